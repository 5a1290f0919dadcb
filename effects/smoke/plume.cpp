#include "smoke/plume.h"

#include <algorithm>
#include <cmath>

namespace lapfx::smoke {

namespace {

/// 0 before `from`, 1 after `to`, smooth between; a step when they are equal.
double fade(double from, double to, double time) {
    return to > from ? glm::smoothstep(from, to, time) : (time >= from ? 1.0 : 0.0);
}

/// The mean of the burn's smoke from `from` to `to`, or its value at `to` when these are equal.
double mean_emission(const Burn& burn, std::span<const BurnPart> parts, const PlumeParameters& plume,
                     const FactorCurve& factor, double from, double to) {
    const BurnPart* part = &burn.at(parts, to);
    const double now = emission(part->contact, part->fat, plume) * factor.at(to);
    double sum = 0.0, last = to;
    while (last > from) {
        const double first = std::max(std::min(part->contact.time, last), from);
        sum += factor.integral(first, last) * emission(part->contact, part->fat, plume);
        last = first;
        if (part->before == BurnPart::none) break;
        part = &parts[part->before];
    }
    return to > last ? sum / (to - last) : now;
}

}  // namespace

PlumeState plume_state(const Burn& burn, std::span<const BurnPart> parts, const PlumeParameters& plume, glm::dvec3 up,
                       double time, const FactorCurve& factor) noexcept {
    PlumeState state;
    if (!(time >= burn.start && time <= burn.end + plume.fade_out)) return state;
    const double burning = std::min(time, burn.end), after = time - burning;
    const double envelope =
        fade(burn.start, burn.start + plume.fade_in, burning) * (1.0 - fade(burn.end, burn.end + plume.fade_out, time));
    state.density = plume.density *
                    mean_emission(burn, parts, plume, factor, std::max(burn.start, burning - plume.fade_in), burning) *
                    envelope;
    const double age = carried_time * -std::expm1(-(burning - burn.start) / carried_time);
    state.anchor = burn.at(parts, burning).contact.tip(burning) + plume.rise * after * up;
    // A young plume is small: it reaches its size as it fades in.
    const double grown = 1.0 + plume.growth * after;
    const double young = plume.size * (0.6 + 0.4 * fade(burn.start, burn.start + 2.0 * plume.fade_in, burning));
    state.size = young * grown;
    state.height = (young + plume.rise * age) * grown;
    state.widening = (grown + plume.growth * age) / grown;
    return state;
}

PlumePlace plume_place(glm::vec2 drawn, glm::vec2 source, float widening) noexcept {
    const float risen = glm::clamp((source.y - drawn.y) / std::max(source.y, 1e-3f), 0.0f, 1.0f);
    const float width = 1.0f + (widening - 1.0f) * risen;
    return {.uv = {source.x + (drawn.x - source.x) * widening / width, drawn.y}, .thickness = 1.0f / width};
}

ClipTurn clip_turn(const SmokeClip& clip, std::uint32_t chance) noexcept {
    const bool by_chance = (chance & 1u) != 0u;
    const double share = static_cast<double>(chance >> 16) / 65535.0 * 2.0 - 1.0;
    return {.mirrored = clip.mirror == ClipMirror::on || (clip.mirror == ClipMirror::seeded && by_chance),
            .angle = static_cast<float>(glm::radians(clip.rotation) * share)};
}

namespace {

/// Towards the camera, mm: `wanted` far from the lens, less and less near it, for there the smoke would fill the view.
float leant(float wanted, float distance) {
    const float most = 0.6f * distance;
    return most > 0.0f ? wanted / std::sqrt(1.0f + wanted * wanted / (most * most)) : 0.0f;
}

}  // namespace

std::array<glm::vec3, 4> plume_corners(const PlumeQuad& quad) noexcept {
    const glm::vec2 right(quad.up.y, -quad.up.x);
    const float c = std::cos(quad.turn.angle), s = std::sin(quad.turn.angle);
    const float source_x = quad.turn.mirrored ? 1.0f - quad.source.x : quad.source.x;
    std::array<glm::vec3, 4> corners;
    for (int i = 0; i < 4; ++i) {
        const glm::vec2 uv(i & 1, i >> 1);
        const glm::vec2 upright = glm::vec2(uv.x - source_x, quad.source.y - uv.y) * quad.extent;
        const glm::vec2 offset(c * upright.x - s * upright.y, s * upright.x + c * upright.y);
        glm::vec3& corner = corners[static_cast<std::size_t>(i)];
        corner = quad.anchor + glm::vec3(right * offset.x + quad.up * offset.y,
                                         leant(quad.lean * std::max(offset.y, 0.0f), -quad.anchor.z));
    }
    return corners;
}

glm::vec4 view_bounds(const std::array<glm::vec3, 4>& corners, const glm::mat4& projection) noexcept {
    constexpr glm::vec4 all(0.0f, 0.0f, 1.0f, 1.0f);
    glm::vec2 low(1.0f), high(0.0f);
    int behind = 0;
    for (const glm::vec3& corner : corners) {
        const glm::vec4 place = projection * glm::vec4(corner, 1.0f);
        if (!(place.w > 1e-3f)) {
            ++behind;
            continue;
        }
        const glm::vec2 at = glm::vec2(place) / place.w * 0.5f + 0.5f;
        low = glm::min(low, at);
        high = glm::max(high, at);
    }
    if (behind == 4) return {1.0f, 1.0f, 0.0f, 0.0f};
    if (behind > 0) return all;
    return {glm::max(low, 0.0f), glm::min(high, 1.0f)};
}

}  // namespace lapfx::smoke
