#include "ui/widgets/basic.h"

#include <cmath>

#include "ui/core/node.h"
#include "ui/core/paragraph.h"
#include "ui/value/closed_list.h"

namespace lapfx::ui {

namespace {

struct TextLook {
    std::string_view text;
    const Run* run;  ///< the run of text and style; null: the text wraps
    TextStyle style;
    Color color;
    Align align;
    bool path = false;
    friend bool operator==(const TextLook& a, const TextLook& b) {
        const bool same_text = a.run == b.run && (a.run != nullptr || (a.text == b.text && a.style == b.style));
        return same_text && a.color == b.color && a.align == b.align && a.path == b.path;
    }
};

void draw_label(Painter& painter, const Node& node, const TextLook& look) {
    Rect rect = node.rect();
    // In the middle of a row the text is on the same pixel as that of the fields next to it, because half pixels are
    // rounded only once.
    const bool odd = std::fmod(std::abs(painter.em(painter.theme().row_height) - rect.h), 2.0F) == 1;
    if (odd) rect.y -= 1, rect.h += 1;
    if (look.path)
        painter.path(rect, look.text, look.style, look.color);
    else
        painter.text(rect, look.text, *look.run, look.style, look.color, look.align);
}

/// A node of one line of text. If it is cut, its tooltip has the whole text. Only then it has an id, which depends on
/// its place: several lines may have the same text, and the text may change all the time. Inside a widget that lights
/// up as a whole, it leaves the hover to that widget.
Node& put_line(Ui& ui, Role role, std::string_view text, const TextStyle& style, const Run*& run) {
    run = &ui.fonts().run(split_label(text).shown, style);
    const Node* before = ui.in_place_before();
    const bool cut = before != nullptr && before->role == role && before->extent[0] + 1 < run->width;
    const Node& parent = ui.parent();
    if (!cut || has(parent.sense, Sense::hover)) return ui.leaf(role, text);
    const std::uint64_t first = parent.last == no_node ? 1 : 0;
    ui.push_seed(2 * std::uint64_t{first != 0 ? parent.end : parent.last} + first);
    Node& node = ui.leaf(role, "line", Sense::hover);
    ui.pop_seed();
    const Label label = split_label(ui.copy(text));
    node.label = label.name, node.shown = label.shown;
    node.tip = node.shown;
    return node;
}

void draw_wrapped(Painter& painter, const Node& node, const TextLook& look) {
    draw_paragraph(painter, node.rect(), look.text, look.style, look.color, look.align);
}

float wrapped_height(Ui& ui, const Node& node, float width) {
    return paragraph_height(ui.fonts(), node.text, static_cast<const TextLook*>(node.arg)->style, width);
}

void draw_separator(Painter& painter, const Node& node, const Axis& across) {
    Rect rect = node.rect();
    const float line = painter.hairline();
    across == Axis::x ? rect = {rect.x, whole(rect.center().y), rect.w, line}
                      : rect = {whole(rect.center().x), rect.y, line, rect.h};
    painter.fill(rect, painter.theme().border);
}

struct ButtonLook {
    Icon icon;
    bool primary, quiet, on;
    const Run* run;  ///< null: only the icon is shown
    friend bool operator==(const ButtonLook&, const ButtonLook&) = default;
};

void draw_button(Painter& painter, const Node& node, const ButtonLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled), hovered = has(node.is, Is::hovered) && !disabled;
    const bool accent = (look.primary || look.on) && !disabled;
    Color ground = accent ? t.accent : t.control;
    if (hovered) ground = accent ? t.accent_hover : t.control_hover;
    if (has(node.is, Is::held) && hovered) ground = accent ? t.accent : t.control_active;
    if (!look.quiet || hovered || look.on) painter.fill(node.rect(), ground, painter.em(t.radius));
    const Color ink = disabled ? t.text_disabled : accent ? t.text_on_accent : t.text;
    Rect inside = node.rect();
    if (look.run == nullptr) return painter.icon(inside.inset(painter.em(0.4F)), look.icon, ink);
    inside = inside.inset(painter.em(0.7F), 0);
    if (look.icon != Icon::none) {
        painter.icon(inside.cut_left(painter.em(1)), look.icon, ink);
        inside.cut_left(painter.em(0.4F));
    }
    painter.text(inside, node.shown, *look.run, painter.text_style(), ink,
                 look.icon == Icon::none ? Align::center : Align::start);
}

Response put_button(Ui& ui, Role role, std::string_view text, const ButtonOptions& options, bool with_text) {
    Node& node = ui.leaf(role, text, Sense::hover | Sense::press | Sense::focus | Sense::activate);
    const float height = ui.row_height();
    node.size[1] = px(height);
    node.tip = ui.copy(options.tip.empty() && !with_text ? node.label : options.tip);
    const Run* run = nullptr;
    if (with_text) {
        run = &ui.fonts().run(node.shown, ui.text_style());
        const float icon = options.icon == Icon::none ? 0.0F : ui.em(1) + ui.em(0.4F);
        const float wish = std::ceil(run->width) + icon + 2 * ui.em(0.7F);
        node.size[0] = px(wish);
        if (node.tip.empty() && node.id == ui.hot() && ui.rect_before(node.id).w + 1 < wish) node.tip = node.shown;
        if (options.width.kind != SizeKind::fit) node.size[0] = options.width;
    } else {
        node.size[0] = px(height);
    }
    const Response r = ui.respond(node);
    ui.draw_with<draw_button>(node, ButtonLook{options.icon, options.primary, options.quiet, options.on, run});
    return r;
}

struct CheckLook {
    bool on;
    const Run* run;
    friend bool operator==(const CheckLook&, const CheckLook&) = default;
};

void draw_checkbox(Painter& painter, const Node& node, const CheckLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled), hovered = has(node.is, Is::hovered) && !disabled;
    Rect rect = node.rect();
    Rect box = rect.cut_left(painter.em(1.1F));
    box = {box.x, whole(box.center().y - painter.em(1.1F) / 2), painter.em(1.1F), painter.em(1.1F)};
    const Color ground = look.on ? (hovered ? t.accent_hover : t.accent) : (hovered ? t.field_hover : t.field);
    painter.fill(box, disabled ? t.field : ground, painter.em(0.25F));
    if (!look.on || disabled)
        painter.frame(box, hovered ? t.text_dim : t.border, painter.hairline(), painter.em(0.25F));
    if (look.on) painter.icon(box.inset(painter.em(0.12F)), Icon::check, disabled ? t.text_disabled : t.text_on_accent);
    rect.cut_left(painter.em(0.5F));
    painter.text(rect, node.shown, *look.run, painter.text_style(), disabled ? t.text_disabled : t.text);
}

}  // namespace

Color color_of(const Theme& theme, Tone tone) {
    static constexpr struct {
        Tone value;
        Color Theme::*color;
    } tones[] = {{Tone::normal, &Theme::text},
                 {Tone::dim, &Theme::text_dim},
                 {Tone::good, &Theme::good},
                 {Tone::warning, &Theme::warning},
                 {Tone::error, &Theme::error}};
    static_assert(is_whole(tones));
    return theme.*tones[static_cast<std::size_t>(tone)].color;
}

void label(Ui& ui, std::string_view text, const LabelOptions& options) {
    TextStyle style = options.number ? ui.number_style() : ui.text_style(options.size, options.weight);
    const Run* run = nullptr;
    Node& node = options.wrap ? ui.leaf(Role::label, text) : put_line(ui, Role::label, text, style, run);
    node.text = node.shown;
    const TextLook look{node.shown,    run,
                        style,         ui.disabled() ? ui.theme().text_disabled : color_of(ui.theme(), options.tone),
                        options.align, options.path};
    if (options.wrap) {
        node.size[0] = options.width.kind == SizeKind::fit ? grow() : options.width;
        ui.draw_with<draw_wrapped>(node, look);
        node.height_for_width = wrapped_height;
        return;
    }
    const float width = std::ceil(run->width);
    node.size[0] = options.width.kind == SizeKind::fit ? px(width) : options.width;
    node.size[1] = px(std::max(ui.em(1.4F * options.size), run->metrics.height));
    node.rigid = false;
    ui.draw_with<draw_label>(node, look);
}

void heading(Ui& ui, std::string_view text) {
    const TextStyle style = ui.text_style(1.15F, Weight::bold);
    const Run* run = nullptr;
    Node& node = put_line(ui, Role::heading, text, style, run);
    node.size[0] = px(std::ceil(run->width));
    node.size[1] = px(ui.row_height());
    node.rigid = false;
    ui.draw_with<draw_label>(node, TextLook{node.shown, run, style, ui.theme().text, Align::start});
}

void separator(Ui& ui) {
    const Axis along = ui.parent().axis;
    Node& node = ui.leaf(Role::separator, {});
    node.size[static_cast<int>(along)] = px(ui.em(0.6F));
    node.size[1 - static_cast<int>(along)] = grow();
    ui.draw_with<draw_separator>(node, along == Axis::y ? Axis::x : Axis::y);
}

bool button(Ui& ui, std::string_view text, const ButtonOptions& options) {
    return put_button(ui, Role::button, text, options, true).clicked;
}

bool icon_button(Ui& ui, Icon icon, std::string_view text, const ButtonOptions& options) {
    ButtonOptions with_icon = options;
    with_icon.icon = icon;
    return put_button(ui, Role::button, text, with_icon, false).clicked;
}

Edit toggle(Ui& ui, std::string_view text, bool& on, const ButtonOptions& options) {
    ButtonOptions shown = options;
    shown.on = on;
    const Response r = put_button(ui, Role::toggle, text, shown, !options.quiet || options.icon == Icon::none);
    if (on) ui.last().is |= Is::checked;
    if (!r.clicked) return {};
    on = !on;
    return Edit::once();
}

Edit checkbox(Ui& ui, std::string_view text, bool& on, std::string_view tip) {
    Node& node = ui.leaf(Role::checkbox, text, Sense::hover | Sense::press | Sense::focus | Sense::activate);
    const Run& run = ui.fonts().run(node.shown, ui.text_style());
    node.size[0] = px(std::ceil(ui.em(1.6F) + run.width));
    node.size[1] = px(ui.row_height());
    node.tip = ui.copy(tip);
    const Response r = ui.respond(node);
    if (r.clicked) on = !on;
    node.is |= when(on, Is::checked);
    ui.draw_with<draw_checkbox>(node, CheckLook{on, &run});
    return r.clicked ? Edit::once() : Edit{};
}

}  // namespace lapfx::ui
