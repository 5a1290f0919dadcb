// How fat the tissue under a hot contact is: what its smoke and its specks depend on. One thread at a time.
//
// The mean over places along the path, both ends included, `spacing` apart: closer than the tip's region of influence
// is wide, so nothing lies between them unseen, and at most `most_places`. Asking the tissue costs about 0.1 ms, and a
// contact that is going on changes in every frame: places are rounded to a grid finer than the region, and what was
// asked there is kept. The result is still a function of the contact alone, whenever and in how many steps it came.
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
    static constexpr int most_places = 16;  ///< of one contact
    using Sample = std::function<double(const glm::dvec3&)>;

    /// 0..1; 0 where no organ can be. `sample`: fat density at a place, 0..1; always the same until clear().
    double along(const ToolContact& contact, const Sample& sample);

    /// The tissue is another.
    void clear() { known_.clear(); }

  private:
    struct Hash {
        std::size_t operator()(const glm::ivec3& cell) const;
    };
    double at(const glm::dvec3& place, const Sample& sample);

    std::unordered_map<glm::ivec3, double, Hash> known_;
};

}  // namespace lapfx::smoke
