// A part of a number line and the pixels it is shown on: what plots, curves and timelines zoom and pan.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string_view>

#include "ui/paint/theme.h"
#include "ui/value/number.h"

namespace lapfx::ui {

/// Part of an axis that is in sight.
struct Span {
    double low = 0, high = 1;

    double length() const { return high - low; }
    void pan(double by) { low += by, high += by; }
    /// `factor` below 1 zooms in; what is at `at` stays where it is.
    void zoom(double factor, double at) { low = at + (low - at) * factor, high = at + (high - at) * factor; }
    friend bool operator==(const Span&, const Span&) = default;
};

/// `span` from pixel `from` to pixel `to`; upright axes have `to` above `from`.
struct Axis1 {
    Span span;
    float from = 0, to = 1;

    double scale() const { return static_cast<double>(to - from) / span.length(); }  ///< px per unit
    /// px, kept within what lines and rectangles can be drawn with.
    float px_of(double value) const {
        return static_cast<float>(std::clamp(from + (value - span.low) * scale(), -1e6, 1e6));
    }
    double value_at(float px) const { return span.low + (px - from) / scale(); }
};

/// Factor of so many wheel notches, forward is in.
inline double zoom_of(float notches) {
    return std::pow(0.85, static_cast<double>(notches));
}

/// What is drawn in a well: 0 is not seen, 1 is as strong as can be.
inline Color on_well(const Theme& theme, float strength) {
    return mix(theme.well, theme.well_ink, strength);
}
inline constexpr float grid_ink = 0.14F, quiet_ink = 0.4F, label_ink = 0.65F, point_ink = 0.9F;

/// Decimals that show a difference of `resolution`: 0.02 -> 2.
inline int decimals_for(double resolution) {
    const double power = std::floor(std::log10(std::abs(resolution)));
    return std::isfinite(power) ? static_cast<int>(std::clamp(-power, 0.0, 9.0)) : 3;
}

/// A line of text put together without the heap; what is beyond its room is left out.
class ShortText {
  public:
    ShortText& add(std::string_view more) {
        const std::size_t kept = std::min(more.size(), sizeof text_ - size_);
        if (kept > 0) std::memcpy(text_ + size_, more.data(), kept);
        size_ += kept;
        return *this;
    }
    ShortText& add(double value, int decimals) {
        char buffer[32];
        return add(format_number(buffer, value, decimals));
    }
    /// Adds a space and the unit; nothing if the unit is empty.
    ShortText& add_unit(std::string_view unit) { return unit.empty() ? *this : add(" ").add(unit); }
    std::string_view view() const { return {text_, size_}; }

  private:
    char text_[240];
    std::size_t size_ = 0;
};

}  // namespace lapfx::ui
