#include "ui/widgets/color_field.h"

#include <charconv>
#include <utility>

#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/field.h"
#include "ui/widgets/param.h"
#include "ui/widgets/text_field.h"

namespace lapfx::ui {

namespace {

/// The state of a picker, which is kept from its first opening on.
struct Picking {
    Hsv hsv;
    Color shown;   ///< the colour that hsv belongs to
    Color before;  ///< the colour when it was opened
    Color start;   ///< the colour when the drag began
    Hsv start_hsv;
    bool began = false;
    std::string_view part;  ///< the part of the picker that began the edit; a literal
    std::string hex;
    Id hex_field = 0;
};

/// The picker whose edit has begun and not ended; a picker may be closed in the middle of typing.
struct Unfinished {
    Id owner = 0;
};
constexpr Id unfinished_key = 0x636f6c6f7572ULL;

struct ColorLook {
    Color color;
    std::string_view text;
    bool caption;
};

// Looks are drawn through pointers into the frame's arena, because later parts of the build may still change the
// colour.

void draw_color_field(Painter& painter, const Node& node, ColorLook* const& shown) {
    const ColorLook& look = *shown;
    const Theme& t = painter.theme();
    draw_caption(painter, node, look.caption);
    const Rect field = field_part(node.rect(), look.caption);
    draw_field(painter, field, node.is);
    Rect inside = field.inset(painter.em(0.25F));
    draw_swatch(painter, inside.cut_left(std::min(painter.em(2.4F), inside.w)), look.color);
    inside.cut_left(painter.em(0.5F));
    TextStyle style = painter.number_style();
    if (inside.w > painter.em(4))
        painter.text(inside, look.text, style, has(node.is, Is::disabled) ? t.text_disabled : t.text);
}

// --- the parts of the picker

struct PadLook {
    Hsv hsv;
    Color color;
};

void draw_ring(Painter& painter, glm::vec2 at, float radius) {
    const float line = painter.hairline();
    const Rect ring{std::round(at.x) - radius, std::round(at.y) - radius, 2 * radius, 2 * radius};
    painter.frame(ring.inset(-line), with_alpha(rgb(0x000000), 0.7F), line, radius + line);  // visible on any colour
    painter.frame(ring, rgb(0xffffff), 2 * line, radius);
}

void draw_square(Painter& painter, const Node& node, PadLook* const& shown) {
    const PadLook& look = *shown;
    const Rect rect = node.rect();
    painter.gradient(rect, rgb(0xffffff), to_color({look.hsv.hue, 1, 1}), false);
    painter.gradient(rect, {0, 0, 0, 0}, rgb(0x000000), true);
    painter.push_clip(rect);
    draw_ring(painter, {rect.x + rect.w * look.hsv.saturation, rect.y + rect.h * (1 - look.hsv.value)},
              painter.em(0.4F));
    painter.pop_clip();
}

void draw_mark(Painter& painter, const Rect& rect, float place) {
    const float half = painter.em(0.25F), y = std::round(rect.y + (rect.h - 1) * place);
    const Rect mark{rect.x - painter.hairline(), y - half, rect.w + 2 * painter.hairline(), 2 * half};
    painter.frame(mark.inset(-painter.hairline()), with_alpha(rgb(0x000000), 0.7F), painter.hairline());
    painter.frame(mark, rgb(0xffffff), 2 * painter.hairline());
}

void draw_hue(Painter& painter, const Node& node, PadLook* const& shown) {
    const PadLook& look = *shown;
    const Rect rect = node.rect();
    for (int i = 0; i < 6; ++i) {
        const auto part = static_cast<float>(i);
        const float y0 = std::round(rect.y + rect.h * part / 6), y1 = std::round(rect.y + rect.h * (part + 1) / 6);
        painter.gradient({rect.x, y0, rect.w, y1 - y0}, to_color({part * 60, 1, 1}), to_color({(part + 1) * 60, 1, 1}),
                         true);
    }
    draw_mark(painter, rect, look.hsv.hue / 360);
}

void draw_alpha(Painter& painter, const Node& node, PadLook* const& shown) {
    const PadLook& look = *shown;
    const Rect rect = node.rect();
    painter.checker(rect, rgb(0xbbbbbb), rgb(0x777777), painter.em(0.45F));
    painter.gradient(rect, with_alpha(look.color, 1), with_alpha(look.color, 0), true);
    draw_mark(painter, rect, 1 - static_cast<float>(look.color.a) / 255);
}

void draw_swatch_node(Painter& painter, const Node& node, const Color& color) {
    draw_swatch(painter, node.rect(), color);
    if (has(node.is, Is::hovered)) painter.frame(node.rect(), painter.theme().text_dim, painter.hairline());
}

/// What all parts of the picker change: the picker's own colour and the caller's.
struct Session {
    Ui& ui;
    Picking& p;
    Color& color;
    PadLook* look;
    Edit edit = {};

    void set(const Hsv& hsv, std::uint8_t alpha) {
        const Color next = to_color(hsv, alpha);
        p.hsv = hsv;
        p.shown = next;
        if (next == color) return;
        edit.began |= !p.began;
        p.began = edit.changed = true;
        color = next;
    }
    void begin(std::string_view part) {
        commit(p.part);
        p.part = part;
        p.start = color, p.start_hsv = p.hsv;
    }
    void commit(std::string_view part) {
        if (part != p.part) return;
        edit.committed |= p.began;
        p.began = false;
    }
    void cancel(std::string_view part) {
        if (!p.began || part != p.part) return;
        color = p.shown = p.start;
        p.hsv = p.start_hsv;
        p.began = false;
        edit.changed = edit.cancelled = true;
    }
};

/// A square or a bar. A press or a drag calls `moved(place)` with the pointer's place, 0..1 from the upper left. Arrows
/// move by hundredths, with Shift by thousandths, with Ctrl by tenths.
template <typename Moved>
void drag_pad(Session& s, std::string_view part, Node& node, glm::vec2 place, Moved&& moved) {
    const Response r = s.ui.respond(node);
    const Rect rect = s.ui.rect_before(node.id);
    if (r.pressed) s.begin(part);
    const bool follows = r.pressed || ((r.held || r.released) && r.drag != glm::vec2(0));
    if (follows && r.button == Button::left && !rect.empty())
        moved(glm::clamp((r.pointer - rect.at()) / glm::max(rect.size() - 1.0F, 1.0F), 0.0F, 1.0F));
    if (r.released) s.commit(part);
    if (r.cancelled) s.cancel(part);
    s.ui.events_of(node.id, [&](const Event& event) {
        if (event.kind != EventKind::key || r.held) return;  // one edit at a time
        glm::vec2 by{0};
        if (event.key == Key::left) by.x = -1;
        if (event.key == Key::right) by.x = 1;
        if (event.key == Key::up) by.y = -1;
        if (event.key == Key::down) by.y = 1;
        const float step = has(event.mods, Mods::shift) ? 0.001F : has(event.mods, Mods::command) ? 0.1F : 0.01F;
        s.begin(part);
        moved(glm::clamp(place + by * step, 0.0F, 1.0F));
        s.commit(part);
    });
}

constexpr Sense pad_sense = Sense::hover | Sense::press | Sense::focus | Sense::arrows_y;

std::string_view percent(Ui& ui, float share) {
    char digits[8];
    const char* end = std::to_chars(digits, digits + sizeof digits, std::lround(share * 100)).ptr;
    return ui.join({{digits, static_cast<std::size_t>(end - digits)}, " %"});
}

void put_square(Session& s) {
    Ui& ui = s.ui;
    Node& node = ui.leaf(Role::canvas, "Saturation and value", pad_sense | Sense::arrows_x);
    node.size[0] = node.size[1] = px(ui.em(12));
    const Hsv hsv = s.p.hsv;
    drag_pad(s, "Saturation and value", node, {hsv.saturation, 1 - hsv.value}, [&](glm::vec2 at) {
        s.set({s.p.hsv.hue, at.x, 1 - at.y}, s.color.a);
    });
    node.text = ui.join({percent(ui, s.p.hsv.saturation), ", ", percent(ui, s.p.hsv.value)});
    ui.draw_with<draw_square>(node, s.look);
}

void put_hue(Session& s) {
    Ui& ui = s.ui;
    Node& node = ui.leaf(Role::slider, "Hue", pad_sense);
    node.size[0] = px(ui.em(1.4F)), node.size[1] = px(ui.em(12));
    drag_pad(s, "Hue", node, {0, s.p.hsv.hue / 360}, [&](glm::vec2 at) {
        s.set({std::min(at.y * 360, 359.99F), s.p.hsv.saturation, s.p.hsv.value}, s.color.a);
    });
    node.number = ui.number(s.p.hsv.hue, 0, 360, 1);
    ui.draw_with<draw_hue>(node, s.look);
}

void put_alpha(Session& s) {
    Ui& ui = s.ui;
    Node& node = ui.leaf(Role::slider, "Alpha", pad_sense);
    node.size[0] = px(ui.em(1.4F)), node.size[1] = px(ui.em(12));
    const float alpha = static_cast<float>(s.color.a) / 255;
    drag_pad(s, "Alpha", node, {0, 1 - alpha},
             [&](glm::vec2 at) { s.set(s.p.hsv, static_cast<std::uint8_t>(std::lround((1 - at.y) * 255))); });
    node.number = ui.number(static_cast<double>(s.color.a) / 255, 0, 1, 0.01);
    ui.draw_with<draw_alpha>(node, s.look);
}

void take_over(Session& s, Color color) {
    s.begin("Before");
    s.set(to_hsv(color, s.p.hsv), color.a);
    s.commit("Before");
}

/// Shows the colour that the picker was opened with, where a click restores it, and next to it the present one.
void put_swatches(Session& s, const ColorOptions& options) {
    Ui& ui = s.ui;
    const Row row(ui, {.width = grow(), .gap = 0, .cross = ChildAlign::center});
    Node& before = ui.leaf(Role::button, "Before", Sense::hover | Sense::press | Sense::focus | Sense::activate);
    before.size[0] = grow(), before.size[1] = px(ui.row_height());
    before.tip = "Back to what it was";
    char hex[9];
    before.text = ui.copy(format_hex(hex, s.p.before, options.alpha));
    if (ui.respond(before).clicked) take_over(s, s.p.before);
    ui.draw_with<draw_swatch_node>(before, s.p.before);
    Node& now = ui.leaf(Role::label, "Now");
    now.size[0] = grow(), now.size[1] = px(ui.row_height());
    now.text = ui.copy(format_hex(hex, s.color, options.alpha));
    ui.draw_with<draw_swatch_node>(now, s.color);
}

/// A field that shows the colour unless a person is typing in it. Text that is not a colour is red and changes nothing.
void put_hex(Session& s, const ColorOptions& options) {
    Ui& ui = s.ui;
    char hex[9];
    const bool typing = ui.focus() == s.p.hex_field && s.p.hex_field != 0;
    if (!typing) s.p.hex = format_hex(hex, s.color, options.alpha);
    const Edit typed = text_field(ui, "Hex", s.p.hex, {.width = px(ui.em(7.5F)), .monospace = true, .whole = true});
    s.p.hex_field = ui.last().id;
    const std::optional<Color> color = parse_hex(s.p.hex);
    if (!color) {
        ui.last().is |= Is::invalid;
        const bool left = typed.committed;
        ui.explain(s.p.hex_field,
                   '"' + s.p.hex + (left ? "\" was not taken: " : "\" is no colour: ") +
                       "allowed are 3 or 6 digits of 0 to 9 and a to f, as #8a4a3c",
                   left ? Ui::explained_for : 0);
    }
    if (typed.began) s.begin("Hex");
    if (typed.changed && color) {
        Color next = *color;
        if (!options.alpha) next.a = s.color.a;
        s.set(to_hsv(next, s.p.hsv), next.a);
    }
    if (typed.cancelled) s.cancel("Hex");
    if (!typed.committed) return;
    s.commit("Hex");
    s.p.hex = format_hex(hex, s.color, options.alpha);
}

/// A number that can be dragged or typed; `changed(number)` sets the colour.
template <typename Changed>
void put_number(Session& s, std::string_view label, double number, double maximum, std::string_view unit,
                Changed&& changed) {
    const Edit edit = number_field(
        s.ui, label, number,
        {.maximum = maximum, .hard_minimum = 0, .hard_maximum = maximum, .step = 1, .unit = unit, .decimals = 0});
    if (edit.began) s.begin(label);
    if (edit.changed) changed(static_cast<float>(number));
    if (edit.committed) s.commit(label);
    if (edit.cancelled) s.cancel(label);
}

void put_numbers(Session& s) {
    Ui& ui = s.ui;
    {
        const Row row(ui, {.width = grow(), .cross = ChildAlign::center});
        constexpr std::uint8_t Color::*channels[] = {&Color::r, &Color::g, &Color::b};
        constexpr std::string_view labels[] = {"R", "G", "B"};
        for (std::size_t i = 0; i < 3; ++i) {
            put_number(s, labels[i], s.color.*channels[i], 255, {}, [&](float v) {
                Color next = s.color;
                next.*channels[i] = static_cast<std::uint8_t>(std::lround(v));
                s.set(to_hsv(next, s.p.hsv), next.a);
            });
        }
    }
    const Row row(ui, {.width = grow(), .cross = ChildAlign::center});
    const auto set = [&](const Hsv& hsv) { s.set(hsv, s.color.a); };
    put_number(s, "H", s.p.hsv.hue, 360, "deg", [&](float v) {
        set({std::min(v, 359.99F), s.p.hsv.saturation, s.p.hsv.value});
    });
    put_number(s, "S", s.p.hsv.saturation * 100, 100, "%", [&](float v) {
        set({s.p.hsv.hue, v / 100, s.p.hsv.value});
    });
    put_number(s, "V", s.p.hsv.value * 100, 100, "%", [&](float v) {
        set({s.p.hsv.hue, s.p.hsv.saturation, v / 100});
    });
}

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    const char lower = static_cast<char>(c | 0x20);
    return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

}  // namespace

Hsv to_hsv(Color color, const Hsv& before) {
    const float r = static_cast<float>(color.r) / 255, g = static_cast<float>(color.g) / 255,
                b = static_cast<float>(color.b) / 255;
    const float most = std::max({r, g, b}), least = std::min({r, g, b}), range = most - least;
    if (most <= 0) return {before.hue, before.saturation, 0};
    if (range <= 0) return {before.hue, 0, most};
    float sixth = 0;
    if (most == r) {
        sixth = (g - b) / range;
    } else {
        sixth = most == g ? (b - r) / range + 2 : (r - g) / range + 4;
    }
    return {sixth < 0 ? (sixth + 6) * 60 : sixth * 60, range / most, most};
}

Color to_color(const Hsv& hsv, std::uint8_t alpha) {
    const auto channel = [&](float shift) {
        const float k = std::fmod(shift + hsv.hue / 60, 6.0F);
        const float v = hsv.value * (1 - hsv.saturation * std::clamp(std::min(k, 4 - k), 0.0F, 1.0F));
        return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0F, 1.0F) * 255));
    };
    return {channel(5), channel(3), channel(1), alpha};
}

std::optional<Color> parse_hex(std::string_view text) {
    while (text.starts_with(' ')) text.remove_prefix(1);
    while (text.ends_with(' ')) text.remove_suffix(1);
    if (text.starts_with('#')) text.remove_prefix(1);
    const bool brief = text.size() == 3 || text.size() == 4;
    if (!brief && text.size() != 6 && text.size() != 8) return std::nullopt;
    std::uint8_t parts[4] = {0, 0, 0, 255};
    const std::size_t digits = brief ? 1 : 2;
    for (std::size_t i = 0; i * digits < text.size(); ++i) {
        const int high = hex_digit(text[i * digits]), low = hex_digit(text[i * digits + digits - 1]);
        if (high < 0 || low < 0) return std::nullopt;
        parts[i] = static_cast<std::uint8_t>(high * 16 + low);
    }
    return Color{parts[0], parts[1], parts[2], parts[3]};
}

std::string_view format_hex(std::span<char> buffer, Color color, bool alpha) {
    constexpr std::string_view digits = "0123456789abcdef";
    const std::uint8_t parts[4] = {color.r, color.g, color.b, color.a};
    std::size_t at = 0;
    buffer[at++] = '#';
    for (std::size_t i = 0; i < (alpha ? 4U : 3U); ++i) {
        buffer[at++] = digits[parts[i] >> 4];
        buffer[at++] = digits[parts[i] & 15];
    }
    return {buffer.data(), at};
}

void draw_swatch(Painter& painter, const Rect& rect, Color color) {
    if (color.a < 255) painter.checker(rect, rgb(0xbbbbbb), rgb(0x777777), painter.em(0.35F));
    painter.fill(rect, color);
    painter.frame(rect, painter.theme().border, painter.hairline());  // it may have the same colour as its background
}

void open_color_picker(Ui& ui, Id owner, Color color, glm::vec2 offset) {
    Picking& p = ui.memory<Picking>(owner);
    p.before = p.shown = color;
    p.hsv = to_hsv(color, p.hsv);
    p.began = false;
    ui.open_overlay(overlay_name(ui, "color ", owner), OverlayKind::popup,
                    {.side = Placement::Side::below, .offset = offset + glm::vec2(0, ui.em(0.15F)), .anchor = owner});
}

Edit color_picker(Ui& ui, Id owner, std::string_view label, Color& color, const ColorOptions& options) {
    Eyedropper* const dropper = options.eyedropper;
    if (dropper != nullptr && dropper->wanted_by == owner && dropper->picked) {
        Color picked = *dropper->picked;
        *dropper = {};
        if (options.picked_as != nullptr) picked = (*options.picked_as)(picked);
        picked.a = color.a;
        if (picked == color) return {};
        color = picked;
        return Edit::once();
    }
    Id& unfinished = ui.memory<Unfinished>(unfinished_key).owner;
    if (ui.overlay_count() == 0 && unfinished != owner) return {};
    const std::string_view name = overlay_name(ui, "color ", owner);
    Node* root = ui.open_overlay_node(name, Role::group, ui.join({label, " picker"}), Axis::y);
    if (root == nullptr && unfinished != owner) return {};
    Picking& p = ui.memory<Picking>(owner);
    if (root == nullptr) {
        unfinished = 0;
        return {.committed = std::exchange(p.began, false)};
    }
    if (p.shown != color) p.hsv = to_hsv(color, p.hsv), p.shown = color;  // changed by the program
    for (std::uint8_t& pad : root->padding) pad = static_cast<std::uint8_t>(std::min(255.0F, ui.em(0.7F)));
    root->gap = ui.em(0.6F);
    ui.draw_with<draw_popup>(*root, false);
    Session s{ui, p, color, ui.arena().make(PadLook{})};
    bool pick = false;
    {
        const Row pads(ui, {.gap = 0.6F, .cross = ChildAlign::start});
        put_square(s);
        put_hue(s);
        if (options.alpha) put_alpha(s);
    }
    {
        const Row row(ui, {.width = grow(), .gap = 0.4F, .cross = ChildAlign::center});
        put_hex(s, options);
        put_swatches(s, options);
        if (dropper != nullptr) pick = icon_button(ui, Icon::eyedropper, "Pick from a picture", {.quiet = true});
    }
    put_numbers(s);
    ui.close_overlay_node();
    *s.look = {p.hsv, color};
    if (p.began || unfinished == owner) unfinished = p.began ? owner : 0;
    if (pick) {
        *dropper = {.wanted_by = owner, .picked = std::nullopt};
        ui.close_overlay(name);
    }
    return s.edit;
}

Edit color_field(Ui& ui, std::string_view label, Color& color, const ColorOptions& options) {
    Node& node =
        ui.leaf(Role::color, label, Sense::hover | Sense::press | Sense::focus | Sense::activate | Sense::copying);
    node.size[0] = options.width.kind == SizeKind::fit ? px(ui.em(8)) : options.width;
    node.size[1] = px(ui.row_height());
    node.minimum[0] = ui.em(options.caption ? 6 : 2);
    node.tip = ui.copy(options.tip);
    const Id id = node.id;
    const std::string_view name = node.label;
    const Response r = ui.respond(node);
    Edit edit;
    char hex[9];
    ui.events_of(id, [&](const Event& event) {
        if (event.kind != EventKind::key || !has(event.mods, Mods::command) || ui.clipboard() == nullptr) return;
        if (event.key == Key::enter || event.key == Key::space) return;
        if (event.key != key_of('V')) return ui.clipboard()->set(std::string(format_hex(hex, color, options.alpha)));
        const std::optional<Color> pasted = parse_hex(ui.clipboard()->get());
        if (!pasted || *pasted == color) return;
        const std::uint8_t alpha = color.a;
        color = *pasted;
        if (!options.alpha) color.a = alpha;
        edit = Edit::once();
    });
    const Rect row = ui.rect_before(id);
    if (r.clicked) open_color_picker(ui, id, color, {field_part(row, options.caption).x - row.x, 0});
    char* const text = static_cast<char*>(ui.arena().take(9, 1));
    node.text = format_hex({text, 9}, color, options.alpha);
    ColorLook* const look = ui.arena().make(ColorLook{color, node.text, options.caption});
    ui.draw_with<draw_color_field>(node, look);
    if (has(node.is, Is::disabled)) return edit;
    edit |= color_picker(ui, id, name, color, options);
    look->color = color;
    format_hex({text, 9}, color, options.alpha);
    return edit;
}

}  // namespace lapfx::ui
