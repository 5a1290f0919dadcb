#include "ui/widgets/literal.h"

#include <cmath>

#include "ui/core/node.h"
#include "ui/core/paragraph.h"

namespace lapfx::ui {

namespace {

struct LiteralLook {
    std::string_view text;
    TextStyle style;
    Color color;
    friend bool operator==(const LiteralLook&, const LiteralLook&) = default;
};

void draw_lines(Painter& painter, const Node& node, const LiteralLook& look) {
    draw_paragraph(painter, node.rect(), look.text, look.style, look.color);
}

float height_of_lines(Ui& ui, const Node& node, float width) {
    return paragraph_height(ui.fonts(), node.text, static_cast<const LiteralLook*>(node.arg)->style, width);
}

void draw_line(Painter& painter, const Node& node, const LiteralLook& look) {
    painter.text(node.rect(), look.text, look.style, look.color);
}

Color ink(Ui& ui, Tone tone) {
    return ui.disabled() ? ui.theme().text_disabled : color_of(ui.theme(), tone);
}

/// A button without text of its own, with a text drawn over it.
struct NamedLook {
    const Drawer* ground;
    const void* look;
    std::string_view text;
    const Run* run;
    bool icon, accent;
    friend bool operator==(const NamedLook& a, const NamedLook& b) {
        return a.ground == b.ground && a.ground->same(a.look, b.look) && a.text == b.text && a.run == b.run &&
               a.icon == b.icon && a.accent == b.accent;
    }
};

void draw_named(Painter& painter, const Node& node, const NamedLook& look) {
    look.ground->draw(painter, node, look.look);
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled);
    Rect inside = node.rect().inset(painter.em(0.7F), 0);
    if (look.icon) inside.cut_left(painter.em(1.4F));
    painter.text(inside, look.text, *look.run, painter.text_style(),
                 disabled      ? t.text_disabled
                 : look.accent ? t.text_on_accent
                               : t.text,
                 look.icon ? Align::start : Align::center);
}

}  // namespace

void literal(Ui& ui, std::string_view text, Tone tone) {
    Node& node = ui.leaf(Role::label, {});
    node.label = node.text = ui.copy(text);
    node.size[0] = grow();
    ui.draw_with<draw_lines>(node, LiteralLook{node.text, ui.text_style(), ink(ui, tone)});
    node.height_for_width = height_of_lines;
}

void literal_line(Ui& ui, std::string_view text) {
    Node& node = ui.leaf(Role::label, "##line", Sense::hover);
    node.label = node.text = node.tip = ui.copy(text);
    node.size[0] = grow();
    node.size[1] = px(ui.row_height());
    ui.respond(node);
    ui.draw_with<draw_line>(node, LiteralLook{node.text, ui.text_style(), ink(ui, Tone::normal)});
}

bool literal_button(Ui& ui, std::string_view text, const ButtonOptions& options) {
    const bool clicked = button(ui, ui.join({"##", text}), options);  // this has the look and the id, but no text
    Node& node = ui.last();
    node.label = ui.copy(text);  // also where it begins with #
    const Run& run = ui.fonts().run(node.label, ui.text_style());
    const float icon = options.icon == Icon::none ? 0.0F : ui.em(1) + ui.em(0.4F);
    const float wish = std::ceil(run.width) + icon + 2 * ui.em(0.7F);
    if (node.tip.empty() && node.id == ui.hot() && ui.rect_before(node.id).w + 1 < wish) node.tip = node.label;
    if (options.width.kind == SizeKind::fit) node.size[0] = px(wish);
    const bool accent = options.primary || options.on;
    ui.draw_with<draw_named>(node,
                             NamedLook{node.drawer, node.arg, node.label, &run, options.icon != Icon::none, accent});
    return clicked;
}

}  // namespace lapfx::ui
