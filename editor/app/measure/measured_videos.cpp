#include "app/measure/measured_videos.h"

#include <algorithm>
#include <utility>

#include "app/measure/measuring.h"
#include "lapfx/authoring/compare.h"

namespace lapfx::app {

std::vector<MeasuredVideos::Entry>::iterator MeasuredVideos::place_of(const Key& key) {
    return std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
        return entry.key.file == key.file && entry.key.written == key.written &&
               equal(measure_table(), &entry.key.measure, &key.measure);
    });
}

void MeasuredVideos::keep(Key key, std::shared_ptr<const MeasuredVideo> video) {
    if (const auto known = place_of(key); known != entries_.end()) entries_.erase(known);
    if (entries_.size() >= kept) entries_.erase(entries_.begin());
    entries_.push_back({std::move(key), std::move(video)});
}

std::shared_ptr<const MeasuredVideo> MeasuredVideos::find(const Key& key) {
    const auto known = place_of(key);
    if (known == entries_.end()) return nullptr;
    std::rotate(known, known + 1, entries_.end());
    return entries_.back().video;
}

bool MeasuredVideos::holds(const MeasuredVideo& video) const {
    return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.video.get() == &video; });
}

std::size_t MeasuredVideos::memory() const {
    std::size_t bytes = 0;
    for (const Entry& entry : entries_) bytes += entry.video->counted.memory();
    return bytes;
}

}  // namespace lapfx::app
