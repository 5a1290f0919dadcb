#include "ui/core/theme.h"

namespace lapfx::ui {

namespace {

constexpr Color okabe_ito[8] = {rgb(0x56b4e9), rgb(0xe69f00), rgb(0x009e73), rgb(0xcc79a7),
                                rgb(0xf0e442), rgb(0xd55e00), rgb(0x0072b2), rgb(0x999999)};

/// The same hues, dark enough for lines on a light well.
constexpr Color on_light[8] = {rgb(0x2a86c0), rgb(0xb87700), rgb(0x00815e), rgb(0xb65c8d),
                               rgb(0x978800), rgb(0xc65500), rgb(0x0068a8), rgb(0x777777)};

Theme make_dark() {
    Theme t;
    t.window = rgb(0x141518), t.panel = rgb(0x1d1f23), t.raised = rgb(0x292c32);
    t.field = rgb(0x2a2d33), t.field_hover = rgb(0x32363d);
    t.control = rgb(0x33373f), t.control_hover = rgb(0x3b4048), t.control_active = rgb(0x2b2e35);
    t.accent = rgb(0xc2483f), t.accent_hover = rgb(0xb8403a), t.accent_ground = rgb(0x4a2a2a);
    t.header = rgb(0x24272c), t.canvas = rgb(0x0e0f11);
    t.well = t.canvas, t.well_ink = rgb(0xffffff);
    t.border = rgb(0x3c4048), t.grid = rgb(0x2b2e34), t.focus = rgb(0x6fb3ff);
    t.text = rgb(0xe6e7ea), t.text_dim = rgb(0xa7acb5), t.text_disabled = rgb(0x6c7079);
    t.text_on_accent = rgb(0xffffff), t.text_link = rgb(0x7db8ff);
    t.good = rgb(0x6cc080), t.warning = rgb(0xe8b04a), t.error = rgb(0xff8a83);
    t.shadow = with_alpha(rgb(0x000000), 0.5F);
    for (int i = 0; i < 8; ++i) t.series[i] = okabe_ito[i];
    return t;
}

Theme make_light() {
    Theme t;
    t.window = rgb(0xd9dbdf), t.panel = rgb(0xf1f2f4), t.raised = rgb(0xffffff);
    t.field = rgb(0xffffff), t.field_hover = rgb(0xf6f8fb);
    t.control = rgb(0xe0e2e7), t.control_hover = rgb(0xd3d6dd), t.control_active = rgb(0xc9cdd5);
    t.accent = rgb(0xb23a32), t.accent_hover = rgb(0x9e322b), t.accent_ground = rgb(0xf4d8d5);
    t.header = rgb(0xe6e8ec), t.canvas = rgb(0x2a2c30);
    t.well = rgb(0xfafbfc), t.well_ink = t.text;
    t.border = rgb(0xbcc0c8), t.grid = rgb(0xd8dbe0), t.focus = rgb(0x1a66c9);
    t.text = rgb(0x1d1f24), t.text_dim = rgb(0x515661), t.text_disabled = rgb(0x9a9fa8);
    t.text_on_accent = rgb(0xffffff), t.text_link = rgb(0x0d52ab);
    t.good = rgb(0x176330), t.warning = rgb(0x744b00), t.error = rgb(0xa8211a);
    t.shadow = with_alpha(rgb(0x000000), 0.25F);
    for (int i = 0; i < 8; ++i) t.series[i] = on_light[i];
    return t;
}

double linear(std::uint8_t v) {
    const double c = v / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(Color c) {
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

}  // namespace

const Theme& dark_theme() {
    static const Theme theme = make_dark();
    return theme;
}

const Theme& light_theme() {
    static const Theme theme = make_light();
    return theme;
}

double contrast(Color a, Color b) {
    const double p = luminance(a), q = luminance(b);
    return (std::max(p, q) + 0.05) / (std::min(p, q) + 0.05);
}

}  // namespace lapfx::ui
