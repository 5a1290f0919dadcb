#include "match/compare/color_likeness.h"

#include "match/picture/color_difference.h"

namespace lapfx::match {

namespace {

std::optional<double> difference(const std::optional<glm::dvec3>& a, const std::optional<glm::dvec3>& b) {
    if (!a || !b) return {};
    return delta_e_2000(lab_of_linear(*a), lab_of_linear(*b));
}

/// Without a tint only how bright it is.
std::optional<glm::dvec3> smoke_of(const MeasuredColors& colors, bool tinted) {
    if (!colors.smoke || tinted) return colors.smoke;
    return glm::dvec3(light_of(*colors.smoke));
}

}  // namespace

ColorLikeness likeness_of(const MeasuredColors& preview, const MeasuredColors& reference) {
    const bool tinted = preview.tinted && reference.tinted;
    return {.blood = difference(preview.blood, reference.blood),
            .smoke = difference(smoke_of(preview, tinted), smoke_of(reference, tinted)),
            .tissue = difference(preview.tissue, reference.tissue)};
}

}  // namespace lapfx::match
