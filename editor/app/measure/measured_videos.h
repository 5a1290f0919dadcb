// What is known of whole videos that were measured, for all documents and windows of a process: a reference that is
// opened again, by whatever document, is not measured again as long as nobody has written to its file.
//
//     videos.keep({.file = file, .written = written, .measure = measure}, video);
//     if (auto known = videos.find({.file = file, .written = written, .measure = measure})) show(*known->found);
//
// Not synchronised.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <vector>

#include "app/measure/counted_frames.h"
#include "lapfx/scene.h"
#include "match/video/measure.h"
#include "match/video/peak_colors.h"

namespace lapfx::app {

/// All that measuring a whole video has found; neither pointer is null.
struct MeasuredVideo {
    std::shared_ptr<const match::Measurement> found;
    std::shared_ptr<const match::ColorsOverTime> colors;
    CountedFrames counted;
};

class MeasuredVideos {
  public:
    static constexpr std::size_t kept = 4;  ///< so many that were kept or found last

    /// What a measurement depends on.
    struct Key {
        std::filesystem::path file;
        std::filesystem::file_time_type written;
        ReferenceMeasure measure;
    };
    /// In place of what is known of the same.
    void keep(Key key, std::shared_ptr<const MeasuredVideo> video);
    /// Null: it is not known.
    std::shared_ptr<const MeasuredVideo> find(const Key& key);
    bool holds(const MeasuredVideo& video) const;
    std::size_t memory() const;  ///< bytes of what was counted

  private:
    struct Entry {
        Key key;
        std::shared_ptr<const MeasuredVideo> video;
    };
    std::vector<Entry>::iterator place_of(const Key& key);
    std::vector<Entry> entries_;  ///< the one that was used last at the end
};

}  // namespace lapfx::app
