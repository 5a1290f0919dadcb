// Places and colours of the UI. Pixels of the framebuffer, origin top left, y down.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace lapfx::ui {

/// The nearest whole number, halves upwards. Without SSE 4.1 std::round is a call into the library; here it is three
/// instructions.
inline float whole(float v) {
    const float down = static_cast<float>(static_cast<int>(v + 0.5F));
    return down > v + 0.5F ? down - 1 : down;
}

/// Half open: a place on the right or lower edge is outside.
struct Rect {
    float x = 0, y = 0, w = 0, h = 0;

    float right() const { return x + w; }
    float bottom() const { return y + h; }
    glm::vec2 at() const { return {x, y}; }
    glm::vec2 size() const { return {w, h}; }
    glm::vec2 center() const { return {x + w / 2, y + h / 2}; }
    bool empty() const { return w <= 0 || h <= 0; }
    bool contains(glm::vec2 p) const { return p.x >= x && p.y >= y && p.x < right() && p.y < bottom(); }
    bool overlaps(const Rect& o) const {
        return x < o.right() && o.x < right() && y < o.bottom() && o.y < bottom() && !empty() && !o.empty();
    }
    Rect inset(float dx, float dy) const {
        return {x + dx, y + dy, std::max(0.0F, w - 2 * dx), std::max(0.0F, h - 2 * dy)};
    }
    Rect inset(float d) const { return inset(d, d); }
    Rect moved(glm::vec2 d) const { return {x + d.x, y + d.y, w, h}; }

    /// Cuts a strip off and returns it; this rectangle keeps the rest. Widgets divide their room this way.
    Rect cut_left(float a) {
        a = std::clamp(a, 0.0F, w);
        const Rect strip{x, y, a, h};
        x += a, w -= a;
        return strip;
    }
    Rect cut_right(float a) {
        a = std::clamp(a, 0.0F, w);
        w -= a;
        return {x + w, y, a, h};
    }
    Rect cut_top(float a) {
        a = std::clamp(a, 0.0F, h);
        const Rect strip{x, y, w, a};
        y += a, h -= a;
        return strip;
    }
    Rect cut_bottom(float a) {
        a = std::clamp(a, 0.0F, h);
        h -= a;
        return {x, y + h, w, a};
    }
    friend bool operator==(const Rect&, const Rect&) = default;
};

inline Rect intersect(const Rect& a, const Rect& b) {
    const float x = std::max(a.x, b.x), y = std::max(a.y, b.y);
    return {x, y, std::max(0.0F, std::min(a.right(), b.right()) - x),
            std::max(0.0F, std::min(a.bottom(), b.bottom()) - y)};
}

/// sRGB with straight alpha, as it is stored and typed; the shader premultiplies.
struct Color {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    friend bool operator==(const Color&, const Color&) = default;
};

constexpr Color rgb(std::uint32_t hex) {
    return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8), static_cast<std::uint8_t>(hex),
            255};
}
constexpr Color with_alpha(Color c, float alpha) {
    c.a = static_cast<std::uint8_t>(std::clamp(alpha, 0.0F, 1.0F) * 255.0F + 0.5F);
    return c;
}
/// (1 - t) * a + t * b in sRGB, as the UI blends everything.
constexpr Color mix(Color a, Color b, float t) {
    const auto blend = [t](std::uint8_t p, std::uint8_t q) {
        return static_cast<std::uint8_t>(static_cast<float>(p) + (static_cast<float>(q) - static_cast<float>(p)) * t +
                                         0.5F);
    };
    return {blend(a.r, b.r), blend(a.g, b.g), blend(a.b, b.b), blend(a.a, b.a)};
}

}  // namespace lapfx::ui
