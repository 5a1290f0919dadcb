#include "ui/paint/theme.h"

namespace lapfx::ui {

namespace {

constexpr Theme dark{
    .window = rgb(0x141518),
    .panel = rgb(0x1d1f23),
    .raised = rgb(0x292c32),
    .field = rgb(0x2a2d33),
    .field_hover = rgb(0x32363d),
    .control = rgb(0x33373f),
    .control_hover = rgb(0x3b4048),
    .control_active = rgb(0x2b2e35),
    .accent = rgb(0xc2483f),
    .accent_hover = rgb(0xb8403a),
    .accent_ground = rgb(0x4a2a2a),
    .header = rgb(0x24272c),
    .canvas = rgb(0x0e0f11),
    .well = rgb(0x0e0f11),
    .well_ink = rgb(0xffffff),
    .border = rgb(0x3c4048),
    .grid = rgb(0x2b2e34),
    .focus = rgb(0x6fb3ff),
    .text = rgb(0xe6e7ea),
    .text_dim = rgb(0xa7acb5),
    .text_disabled = rgb(0x6c7079),
    .text_on_accent = rgb(0xffffff),
    .text_link = rgb(0x7db8ff),
    .good = rgb(0x6cc080),
    .warning = rgb(0xe8b04a),
    .error = rgb(0xff8a83),
    .shadow = with_alpha(rgb(0x000000), 0.5F),
    // Okabe and Ito's.
    .series = {rgb(0x56b4e9), rgb(0xe69f00), rgb(0x009e73), rgb(0xcc79a7), rgb(0xf0e442), rgb(0xd55e00), rgb(0x0072b2),
               rgb(0x999999)},
};

constexpr Theme light{
    .window = rgb(0xd9dbdf),
    .panel = rgb(0xf1f2f4),
    .raised = rgb(0xffffff),
    .field = rgb(0xffffff),
    .field_hover = rgb(0xf6f8fb),
    .control = rgb(0xe0e2e7),
    .control_hover = rgb(0xd3d6dd),
    .control_active = rgb(0xc9cdd5),
    .accent = rgb(0xb23a32),
    .accent_hover = rgb(0x9e322b),
    .accent_ground = rgb(0xf4d8d5),
    .header = rgb(0xe6e8ec),
    .canvas = rgb(0x2a2c30),
    .well = rgb(0xfafbfc),
    .well_ink = rgb(0x1d1f24),
    .border = rgb(0xbcc0c8),
    .grid = rgb(0xd8dbe0),
    .focus = rgb(0x1a66c9),
    .text = rgb(0x1d1f24),
    .text_dim = rgb(0x515661),
    .text_disabled = rgb(0x9a9fa8),
    .text_on_accent = rgb(0xffffff),
    .text_link = rgb(0x0d52ab),
    .good = rgb(0x176330),
    .warning = rgb(0x744b00),
    .error = rgb(0xa8211a),
    .shadow = with_alpha(rgb(0x000000), 0.25F),
    // The same hues, dark enough for lines on a light well.
    .series = {rgb(0x2a86c0), rgb(0xb87700), rgb(0x00815e), rgb(0xb65c8d), rgb(0x978800), rgb(0xc65500), rgb(0x0068a8),
               rgb(0x777777)},
};

double linear(std::uint8_t v) {
    const double c = v / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

double luminance(Color c) {
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
}

}  // namespace

const Theme& dark_theme() {
    return dark;
}

const Theme& light_theme() {
    return light;
}

double contrast(Color a, Color b) {
    const double p = luminance(a), q = luminance(b);
    return (std::max(p, q) + 0.05) / (std::min(p, q) + 0.05);
}

}  // namespace lapfx::ui
