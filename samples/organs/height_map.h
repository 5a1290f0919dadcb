// The visible parts of patches along one direction, as heights over a plane. Tissue on other tissue is modelled with
// such a map, and the light in gaps is found with many of them.
//
//     HeightMap under(view_from({0, 0.3, 0.95}), 260.0, 260);
//     under.add(stomach);
//     under.drape(9.0);      // a cloth over it
//     double z = under.at({x, y});
#pragma once

#include <vector>

#include "patch.h"

namespace organs {

/// An orthographic view: `toward` points at the eye.
struct View {
    dvec3 right{1.0, 0.0, 0.0};
    dvec3 up{0.0, 1.0, 0.0};
    dvec3 toward{0.0, 0.0, 1.0};

    dvec3 place(const dvec2& xy, double height) const { return xy.x * right + xy.y * up + height * toward; }
    dvec3 seen(const dvec3& p) const { return {glm::dot(p, right), glm::dot(p, up), glm::dot(p, toward)}; }
};
View view_from(const dvec3& toward);

class HeightMap {
  public:
    /// `cells` by `cells` over a square of `size` mm about the origin.
    HeightMap(const View& view, double size, int cells);
    /// `facing`: only parts that face the view.
    void add(const Patch& patch, bool facing = false);
    /// Puts a cloth over it that bridges hollows narrower than `radius`.
    void drape(double radius);
    double at(const dvec2& xy) const;
    const View& view() const { return view_; }

  private:
    void triangle(const dvec3& a, const dvec3& b, const dvec3& c, bool facing);
    dvec2 cell(const dvec3& seen) const;

    View view_;
    double size_;
    int cells_;
    std::vector<double> height_;
};

/// Sets `light` of every vertex: how open it is to its surroundings. Tissue farther away than `reach` mm does not
/// darken it.
void find_light(const std::vector<Patch*>& lit, const std::vector<const Patch*>& blockers, int directions,
                double reach);

}  // namespace organs
