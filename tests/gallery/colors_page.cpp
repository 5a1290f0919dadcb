#include <array>
#include <cstdio>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/core/node.h"

namespace lapfx::gallery {

namespace {

struct Named {
    std::string_view name;
    ui::Color ui::Theme::*color;
};

constexpr std::array grounds = {
    Named{"window", &ui::Theme::window},
    Named{"panel", &ui::Theme::panel},
    Named{"raised", &ui::Theme::raised},
    Named{"field", &ui::Theme::field},
    Named{"field hover", &ui::Theme::field_hover},
    Named{"control", &ui::Theme::control},
    Named{"control hover", &ui::Theme::control_hover},
    Named{"control active", &ui::Theme::control_active},
    Named{"header", &ui::Theme::header},
    Named{"accent ground", &ui::Theme::accent_ground},
};
constexpr std::array inks = {
    Named{"text", &ui::Theme::text},
    Named{"dim", &ui::Theme::text_dim},
    Named{"link", &ui::Theme::text_link},
    Named{"good", &ui::Theme::good},
    Named{"warning", &ui::Theme::warning},
    Named{"error", &ui::Theme::error},
    Named{"disabled", &ui::Theme::text_disabled},
};
constexpr std::array others = {
    Named{"accent", &ui::Theme::accent}, Named{"accent hover", &ui::Theme::accent_hover},
    Named{"canvas", &ui::Theme::canvas}, Named{"border", &ui::Theme::border},
    Named{"grid", &ui::Theme::grid},     Named{"focus", &ui::Theme::focus},
};

struct SwatchLook {
    ui::Color ground, ink;
    std::string_view text;
};

void draw_swatch(ui::Painter& painter, const ui::Node& node, const SwatchLook& look) {
    painter.fill(node.rect(), look.ground);
    painter.frame(node.rect(), painter.theme().border, painter.hairline());
    painter.text(node.rect().inset(painter.em(0.4F), 0), look.text, painter.number_style(), look.ink,
                 ui::Align::center);
}

/// `name` in the tree; what is seen is `text`.
void swatch(ui::Ui& ui, std::string_view name, ui::Color ground, ui::Color ink, std::string_view text, ui::Size width) {
    ui::Node& node = ui.leaf(ui::Role::color, name, ui::Sense::hover);
    node.size[0] = width;
    node.size[1] = ui::px(ui.row_height());
    node.text = text;
    std::array<char, 8> hex;
    std::snprintf(hex.data(), hex.size(), "#%02x%02x%02x", ground.r, ground.g, ground.b);
    node.tip = ui.join({name, "  ", std::string_view(hex.data())});
    ui.respond(node);
    ui.draw_with<draw_swatch>(node, SwatchLook{ground, ink, text});
}

/// A table of grounds and inks: each cell shows its ink and says the contrast.
void contrasts(ui::Ui& ui) {
    const ui::Theme& t = ui.theme();
    const Part part(ui, "Text on grounds: contrast, 4.5 is enough");
    for (const Named& ground : grounds) {
        const Line line(ui, ground.name);
        for (const Named& ink : inks) {
            const double figure = ui::contrast(t.*ink.color, t.*ground.color);
            swatch(ui, ink.name, t.*ground.color, t.*ink.color, ui.join({ink.name, " ", text_of(ui, figure, 1)}),
                   ui::px(ui.em(7.2F)));
        }
    }
}

}  // namespace

void colors_page(ui::Ui& ui, State&) {
    const ui::Theme& t = ui.theme();
    contrasts(ui);
    const Part part(ui, "Others");
    {
        const Line line(ui, "accents, lines");
        for (const Named& each : others) {
            const bool accent = each.color == &ui::Theme::accent || each.color == &ui::Theme::accent_hover;
            const double light = ui::contrast(t.*each.color, ui::rgb(0xffffff));
            const ui::Color ink = accent || light >= 4.5 ? ui::rgb(0xffffff) : ui::rgb(0x000000);
            swatch(ui, each.name, t.*each.color, ink, each.name, ui::px(ui.em(7.2F)));
        }
    }
    const Line line(ui, "series");
    for (std::size_t i = 0; i < std::size(t.series); ++i) {
        const std::string_view name = text_of(ui, static_cast<double>(i + 1));
        const bool dark = ui::contrast(t.series[i], ui::rgb(0x000000)) < 4.5;
        swatch(ui, name, t.series[i], dark ? ui::rgb(0xffffff) : ui::rgb(0x000000), name, ui::px(ui.em(5)));
    }
}

}  // namespace lapfx::gallery
