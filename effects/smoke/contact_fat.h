// How fat the tissue under a hot contact is. Its smoke and its specks depend on that. One thread at a time.
//
// The mean over places along the path, both ends included, `spacing` apart: closer than the width of the tip's region
// of influence, so no tissue between them is missed, and at most `most_places`. Asking the tissue costs about 0.1 ms,
// and a running contact changes in every frame, so places are rounded to a grid finer than the region and answers are
// kept. The result still depends only on the contact, not on when and in how many steps it grew.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <unordered_map>

#include "lapfx/tool.h"

namespace lapfx::smoke {

class ContactFat {
  public:
    static constexpr double grid = 0.5;     ///< mm
    static constexpr double spacing = 2.0;  ///< mm
    static constexpr int most_places = 16;  ///< one contact has no more
    using Sample = std::function<double(const glm::dvec3&)>;

    /// 0..1; 0 at places where no organ can be. `sample` gives the fat density at a place, 0..1; it must stay the same
    /// until clear().
    double along(const ToolContact& contact, const Sample& sample);

    /// Call this when the tissue has changed.
    void clear() { known_.clear(); }

  private:
    struct Hash {
        std::size_t operator()(const glm::ivec3& cell) const;
    };
    double at(const glm::dvec3& place, const Sample& sample);

    std::unordered_map<glm::ivec3, double, Hash> known_;
};

}  // namespace lapfx::smoke
