#include "ui/draw/draw_list.h"

namespace lapfx::ui {

void Instances::grow(std::size_t least) {
    capacity_ = std::max({least, capacity_ * 2, std::size_t{1024}});
    auto items = std::make_unique<Instance[]>(capacity_);
    if (size_ > 0) std::memcpy(static_cast<void*>(items.get()), items_.get(), size_ * sizeof(Instance));
    items_ = std::move(items);
}

void DrawList::reset(glm::ivec2 frame_size) {
    size = frame_size;
    clears.clear(), instances.clear(), clips.clear(), batches.clear(), serials.clear();
}

bool same_frame(const DrawList& a, const DrawList& b) {
    return a.instances.size() == b.instances.size() && a.size == b.size && a.clears == b.clears && a.clips == b.clips &&
           a.batches == b.batches && a.serials == b.serials;
}

bool same_picture(const DrawList& a, const DrawList& b) {
    return same_frame(a, b) && (a.instances.empty() || std::memcmp(a.instances.data(), b.instances.data(),
                                                                   a.instances.size() * sizeof(Instance)) == 0);
}

}  // namespace lapfx::ui
