// Colours and metrics of the UI. Two themes, dark and light, both name every colour (theme.cpp); pairs of text and
// ground have a contrast of 4.5 or more (tests/ui/paint/theme_test.cpp).
#pragma once

#include "ui/value/geometry.h"

namespace lapfx::ui {

struct Theme {
    // grounds
    Color window;  ///< between and around panels
    Color panel;   ///< of panels
    Color raised;  ///< menus, dialogs, tooltips
    Color field;   ///< of what can be typed or dragged
    Color field_hover;
    Color control;  ///< buttons, thumbs
    Color control_hover;
    Color control_active;
    Color accent;  ///< what is on, selected, filled
    Color accent_hover;
    Color accent_ground;  ///< a selected row: quiet, text stays readable
    Color header;         ///< section and table headers
    Color canvas;         ///< behind pictures and scopes: dark in every theme
    Color well;           ///< behind plots, curves and timelines
    Color well_ink;       ///< lines and text there, whole or mixed with it
    // lines
    Color border;
    Color grid;
    Color focus;  ///< ring of what has the keyboard
    // text
    Color text;
    Color text_dim;  ///< units, hints
    Color text_disabled;
    Color text_on_accent;
    Color text_link;
    // signals
    Color good;
    Color warning;
    Color error;
    Color shadow;
    /// Plots use them; people with colour blindness can tell them apart (Okabe and Ito 2008).
    Color series[8];

    // metrics; em are font heights
    float font_size = 14;      ///< px at scale 1: one em
    float row_height = 1.75F;  ///< em, of a control: 24 px at scale 1
    float gap = 0.4F;          ///< em between controls
    float padding = 0.6F;      ///< em inside panels
    float radius = 0.3F;       ///< em, of corners
};

const Theme& dark_theme();
const Theme& light_theme();

/// The contrast of two opaque colours, 1 to 21 (WCAG 2.1, relative luminance).
double contrast(Color a, Color b);

}  // namespace lapfx::ui
