// Text, buttons and switches.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

enum class Tone : std::uint8_t { normal, dim, good, warning, error };

struct LabelOptions {
    Tone tone = Tone::normal;
    Align align = Align::start;
    bool wrap =
        false;  ///< as many lines as the width asks for; else one, cut with an ellipsis and whole in its tooltip
    bool path = false;    ///< of one line: where it is too long, its end is seen
    bool number = false;  ///< digits of one width
    float size = 1;       ///< em
    Weight weight = Weight::regular;
    Size width = {SizeKind::fit, 0};
};
void label(Ui& ui, std::string_view text, const LabelOptions& options = {});
/// The title of what follows.
void heading(Ui& ui, std::string_view text);
/// A hairline across the parent's axis.
void separator(Ui& ui);

struct ButtonOptions {
    Icon icon = Icon::none;
    std::string_view tip = {};
    bool primary = false;  ///< the main action
    bool quiet = false;    ///< no ground until the pointer is on it
    bool on = false;       ///< pressed in: a toggle
    Size width = {SizeKind::fit, 0};
};
/// Returns whether it was clicked, by pointer, Enter or space.
bool button(Ui& ui, std::string_view label, const ButtonOptions& options = {});
/// Shows only the icon; `label` is its name and, if there is no other, its tooltip.
bool icon_button(Ui& ui, Icon icon, std::string_view label, const ButtonOptions& options = {});
/// A button that stays down.
Edit toggle(Ui& ui, std::string_view label, bool& on, const ButtonOptions& options = {});
Edit checkbox(Ui& ui, std::string_view label, bool& on, std::string_view tip = {});

/// One of a few choices, side by side. `chosen` is clamped. Arrow keys choose.
Edit segmented(Ui& ui, std::string_view label, int& chosen, std::span<const std::string_view> choices);

Color color_of(const Theme& theme, Tone tone);

}  // namespace lapfx::ui
