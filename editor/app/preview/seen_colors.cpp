#include "app/preview/seen_colors.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "app/preview/pick_color.h"
#include "match/compare/region.h"
#include "ui/canvas/pixels.h"
#include "ui/widgets/color_field.h"

namespace lapfx::app {

namespace {

/// px: what is seen at one place hardly depends on how many there are, and without a GPU each picture takes time.
constexpr double longest_side = 640;
constexpr double told_for = 12;   // s
constexpr double least_veil = 1;  // Delta E that smoke makes: less does not lie over a place

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

void without_plumes(document::Content& content) {
    content.preset.smoke.plume.density = 0;
}

/// What else is seen at a place of this colour, and where the picked one may belong.
std::string under(std::string_view name) {
    return name == "Thin colour" ? ". Tissue shows through thin blood: what was picked may be the deep colour" : "";
}

/// `veil`: the smoke that was left out.
std::string note_of(std::string_view name, const SolvedColor& solved, const std::string& veil, double time) {
    const glm::dvec3& picked = solved.picked;
    const std::string at = number(time, 2) + " s";
    if (!solved.acts)
        return std::string(name) + " is " + hex(picked) + " as picked: nothing shows it at " + at +
               ", so lamp, exposure and tone curve are left out. Pick again where it is seen.";
    const std::string place = number(100 * solved.place.x, 0) + " % from the left and " +
                              number(100 * solved.place.y, 0) + " % from the top, at " + at;
    const std::string delta = " (Delta E " + number(solved.off, 1) + ")";
    if (!veil.empty())
        return "Under " + veil + " " + hex(picked) + " cannot be seen " + place + ": " + std::string(name) + " is " +
               hex(solved.color) + ", with which " + hex(solved.seen) + " is seen there without " + veil + delta;
    if (solved.off <= reached_color)
        return std::string(name) + " is " + hex(solved.color) + ", so that " + hex(picked) + " is seen" + delta +
               " through lamp, exposure and tone curve, " + place;
    return hex(picked) + " cannot be seen " + place + ", whatever the colour is there: " + std::string(name) + " is " +
           hex(solved.color) + ", which comes near: " + hex(solved.seen) + delta + under(name);
}

}  // namespace

bool SeenColors::plume_over(const SolvedColor& solved, const Shot& shot, glm::ivec2 size, const Put& put) {
    const glm::ivec2 at(solved.place * glm::dvec2(size));
    const Image image =
        preview_.picture_with([&](document::Content& content) { put(content, solved.color); }, shot, size);
    const ui::Color color = color_around(ImagePixels(image), size, at);
    return match::distance({.color = glm::dvec3(color.r, color.g, color.b) / 255.0}, {.color = solved.seen}) >
           least_veil;
}

glm::dvec3 SeenColors::solve(std::string_view name, const glm::dvec3& picked, const glm::dvec3& now,
                             const std::function<void(document::Content&, const glm::dvec3&)>& put) {
    const std::optional<Picture> clicked = std::exchange(picture_, std::nullopt);
    if (!clicked) return picked;  // the click was on no picture of this window
    Picture picture = *clicked;
    if (!preview_.can_try()) {
        notices_.add(
            {.kind = ui::ToastKind::warning,
             .text = note_of(name, {.color = picked, .picked = picked, .seen = picked}, {}, picture.shot.time)});
        return picked;
    }
    picture.shot.overlay = Overlay::none;
    picture.shot.scale = 1;
    const double scale = std::min(1.0, longest_side / std::max({1, picture.size.x, picture.size.y}));
    const glm::ivec2 size = glm::max(glm::ivec2(glm::round(glm::dvec2(picture.size) * scale)), glm::ivec2(1));
    const auto began = std::chrono::steady_clock::now();
    const auto solve_in = [&](const Shot& shot, bool plumes) {
        const auto draw = [&](const glm::dvec3& color) {
            const auto change = [&](document::Content& content) {
                put(content, color);
                if (!plumes) without_plumes(content);
            };
            return preview_.picture_with(change, shot, size);
        };
        return solve_color(picked, now, picture.place, draw, shot.camera.response());
    };
    // A plume passes, and only its own colours need it.
    SolvedColor solved = solve_in(picture.shot, false);
    const bool of_plume = !solved.acts;
    if (of_plume) solved = solve_in(picture.shot, true);
    veil_.clear();
    Shot shot = picture.shot;
    if (!of_plume && solved.off > reached_color) {
        shot.haze = false;
        const SolvedColor bare = solve_in(shot, false);
        // Half as far off at least: else it is not the haze that keeps the colour away.
        if (bare.acts && bare.off < 0.5 * solved.off) solved = bare, veil_ = "haze";
        if (veil_.empty()) shot.haze = picture.shot.haze;
    }
    if (!of_plume && plume_over(solved, shot, size, put)) veil_ = veil_.empty() ? "a plume" : "haze and a plume";
    last_ = solved;
    const bool reached = solved.acts && solved.off <= reached_color && veil_.empty();
    // The notice's time begins with this frame, which takes as long as the search.
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
    notices_.add({.kind = reached ? ui::ToastKind::info : ui::ToastKind::warning,
                  .text = note_of(name, solved, veil_, picture.shot.time),
                  .seconds = told_for + took.count()});
    return solved.color;
}

}  // namespace lapfx::app
