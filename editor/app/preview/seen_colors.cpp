#include "app/preview/seen_colors.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "ui/canvas/pixels.h"
#include "ui/widgets/color_field.h"

namespace lapfx::app {

namespace {

/// px: what is seen at one place hardly depends on how many there are, and without a GPU each picture takes time.
constexpr double longest_side = 640;

std::string hex(const glm::dvec3& color) {
    char text[9];
    return std::string(
        ui::format_hex(text, ui::color_of(glm::vec4(255.0 * glm::clamp(color, 0.0, 1.0), 255.0)), false));
}

std::string number(double value, int decimals) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string note_of(std::string_view name, const SolvedColor& solved, double time) {
    const glm::dvec3& picked = solved.picked;
    const std::string at = number(time, 2) + " s";
    if (!solved.acts)
        return std::string(name) + " is " + hex(picked) + " as picked: nothing shows it at " + at +
               ", so lamp, exposure and tone curve are left out. Pick again where it is seen.";
    const std::string place = number(100 * solved.place.x, 0) + " % from the left and " +
                              number(100 * solved.place.y, 0) + " % from the top, at " + at;
    const std::string delta = " (Delta E " + number(solved.off, 1) + ")";
    if (solved.off <= reached_color)
        return std::string(name) + " is " + hex(solved.color) + ", so that " + hex(picked) + " is seen" + delta +
               " through lamp, exposure and tone curve, " + place;
    return hex(picked) + " cannot be seen " + place + ", whatever the colour is there: " + std::string(name) + " is " +
           hex(solved.color) + ", which comes nearest: " + hex(solved.seen) + delta;
}

}  // namespace

glm::dvec3 SeenColors::solve(std::string_view name, const glm::dvec3& picked, const glm::dvec3& now,
                             const std::function<void(document::Content&, const glm::dvec3&)>& put) {
    const std::optional<Picture> clicked = std::exchange(picture_, std::nullopt);
    if (!clicked) return picked;  // from no picture of this window
    Picture picture = *clicked;
    if (!preview_.can_try()) {
        notices_.add({.kind = ui::ToastKind::warning,
                      .text = note_of(name, {.color = picked, .picked = picked, .seen = picked}, picture.shot.time)});
        return picked;
    }
    picture.shot.overlay = Overlay::none;
    picture.shot.scale = 1;
    const double scale = std::min(1.0, longest_side / std::max({1, picture.size.x, picture.size.y}));
    const glm::ivec2 size = glm::max(glm::ivec2(glm::round(glm::dvec2(picture.size) * scale)), glm::ivec2(1));
    const SolvedColor solved = solve_color(picked, now, picture.place, [&](const glm::dvec3& color) {
        return preview_.picture_with([&](document::Content& content) { put(content, color); }, picture.shot, size);
    });
    last_ = solved;
    const bool reached = solved.acts && solved.off <= reached_color;
    notices_.add({.kind = reached ? ui::ToastKind::info : ui::ToastKind::warning,
                  .text = note_of(name, solved, picture.shot.time)});
    return solved.color;
}

}  // namespace lapfx::app
