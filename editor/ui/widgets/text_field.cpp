#include "ui/widgets/text_field.h"

#include "ui/core/node.h"
#include "ui/value/utf8.h"
#include "ui/widgets/editing.h"
#include "ui/widgets/field.h"

namespace lapfx::ui {

namespace {

// Of a very long text only a window of so many bytes around the caret is shaped. The window moves when the caret comes
// near one of its ends.
constexpr std::size_t window_bytes = 6144, window_margin = 1536;
static_assert(window_bytes < max_run_bytes);
constexpr std::size_t spoken_bytes = 64 << 10;
constexpr float side = 0.5F;  // em between the edge and the text

/// The state of a field while it has the keyboard.
struct Field {
    Editing editing;
    std::size_t start = 0;  ///< byte at which the shaped window begins
    float offset = 0;       ///< px by which the window is scrolled to the left
    double scrolled = 0;    ///< s, when a drag last scrolled it
    bool whole = false;     ///< the next press leaves all selected
};

struct FieldLook {
    std::string_view text, placeholder;
    TextStyle style;
    Icon icon = Icon::none;
    bool caption = false, clear = false, editing = false, caret = false, path = false;
    float offset = 0, caret_x = 0, from = 0, to = 0;  ///< px in the run
    friend bool operator==(const FieldLook&, const FieldLook&) = default;
};

/// The part of a field with this rectangle in which its text is drawn.
Rect text_part(const Rect& row, const FieldLook& look, float em) {
    Rect part = field_part(row, look.caption).inset(std::round(side * em), 0);
    if (look.icon != Icon::none) part.cut_left(std::round(1.4F * em));
    if (look.clear) part.cut_right(std::round(1.3F * em));
    return part;
}

/// The offset nearest to the present one with which the caret is visible, and no room at the right is empty while text
/// is hidden at the left.
float offset_that_shows(float offset, float caret_x, float run_width, float width) {
    offset = std::min(offset, std::max(0.0F, run_width + 2 - width));
    return std::max(0.0F, std::clamp(offset, caret_x + 2 - width, caret_x));
}

void draw_text_field(Painter& painter, const Node& node, const FieldLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled);
    draw_caption(painter, node, look.caption);
    Rect field = field_part(node.rect(), look.caption);
    draw_field(painter, field, node.is);
    const Rect part = text_part(node.rect(), look, painter.em(1));
    if (look.icon != Icon::none)
        painter.icon({field.x + painter.em(side), field.y, painter.em(1), field.h}, look.icon,
                     disabled ? t.text_disabled : t.text_dim);
    if (look.text.empty())
        painter.text(part, look.placeholder, painter.text_style(), disabled ? t.text_disabled : t.text_dim);
    if (!look.editing) {
        const Color ink = disabled ? t.text_disabled : t.text;
        look.path ? painter.path(part, look.text, look.style, ink) : painter.text(part, look.text, look.style, ink);
        return;
    }
    const Run& run = painter.fonts().run(look.text, look.style);
    const LineMetrics metrics = painter.fonts().metrics(look.style);
    const float offset = offset_that_shows(look.offset, look.caret_x, run.width, part.w);
    const float left = part.x - std::round(offset), top = std::round(part.center().y - metrics.height / 2);
    painter.push_clip({part.x - painter.hairline(), field.y, part.w + 2 * painter.hairline(), field.h});
    if (look.from != look.to)
        painter.fill({left + std::round(look.from), top, std::round(look.to) - std::round(look.from), metrics.height},
                     selection_color(t));
    const float ascent = top + std::round((metrics.height - metrics.ascent - metrics.descent) / 2) + metrics.ascent;
    painter.run(run, {left, ascent}, t.text);
    if (look.caret) painter.fill({left + std::round(look.caret_x), top, painter.hairline(), metrics.height}, t.text);
    painter.pop_clip();
}

/// The part of the text that is shaped; the caret is in it. When it changes, the visible text stays at its place.
std::string_view window_of(Ui& ui, Field& field, const TextStyle& style) {
    const std::string_view text = field.editing.edit.text();
    const std::size_t caret = field.editing.edit.caret(), old = std::min(field.start, text.size());
    if (text.size() <= window_bytes) {
        field.start = 0;
        return text;
    }
    const auto at = [&](std::size_t start) {
        return text.substr(start, code_point_at(text, std::min(start + window_bytes, text.size())) - start);
    };
    const std::size_t end = old + at(old).size();
    const bool near_start = old > 0 && caret < old + window_margin;
    const bool near_end = end < text.size() && caret + window_margin > end;
    if (!near_start && !near_end) return at(old);
    field.start = code_point_at(text, caret - std::min(caret, window_bytes / 2));
    if (caret >= old && caret <= end) {
        const float before = ui.fonts().run(at(old), style).x_of(caret - old);
        field.offset += ui.fonts().run(at(field.start), style).x_of(caret - field.start) - before;
    }
    return at(field.start);
}

/// A drag selects. Beyond an edge of the field it scrolls, faster if it is farther away.
void drag(Ui& ui, Field& field, const Response& r, const Rect& part, const Run& run) {
    const bool moved = glm::distance(r.pointer, r.pressed_at) > 3 * ui.scale();
    if (!r.held || r.button != Button::left || r.pressed || !moved) {
        field.scrolled = ui.time();
        return;
    }
    const float beyond = r.pointer.x < part.x         ? r.pointer.x - part.x
                         : r.pointer.x > part.right() ? r.pointer.x - part.right()
                                                      : 0.0F;
    if (beyond != 0) {
        const auto passed = static_cast<float>(std::clamp(ui.time() - field.scrolled, 0.0, 0.1));
        const float most = std::max(0.0F, run.width + 2 - part.w);
        field.offset = std::clamp(field.offset + drag_scroll_speed(ui, beyond) * passed, 0.0F, most);
        const bool goes_on = beyond < 0 ? field.offset > 0 : field.offset < most;
        if (goes_on) ui.wake_at(ui.time() + 1.0 / 60, "selecting");
    }
    field.scrolled = ui.time();
    const float x = std::clamp(r.pointer.x, part.x, part.right()) - part.x + field.offset;
    field.editing.edit.place(field.start + run.byte_at(x), true);
    field.editing.touch(ui);
}

Edit edit_field(Ui& ui, Node& node, const Response& r, Field& field, std::string& text, FieldLook& look) {
    Edit result;
    const Rect row = ui.rect_before(node.id), part = text_part(row, look, ui.em(1));
    field.editing.follow(ui, text);
    std::string_view window = window_of(ui, field, look.style);
    ui.events_of(node.id, [&](const Event& event) {
        if (event.kind == EventKind::press && event.button == Button::left) {
            if (std::exchange(field.whole, false)) return field.editing.touch(ui);
            const float x = event.at.x - part.x + field.offset;
            field.editing.press(ui, event, field.start + ui.fonts().run(window, look.style).byte_at(x));
        } else {
            field.whole = field.whole && event.kind != EventKind::key && event.kind != EventKind::text;
            field.editing.take(ui, event, text, result);
        }
    });
    window = window_of(ui, field, look.style);
    drag(ui, field, r, part, ui.fonts().run(window, look.style));
    window = window_of(ui, field, look.style);
    const Run& run = ui.fonts().run(window, look.style);
    const TextEdit& edit = field.editing.edit;
    const auto x_of = [&](std::size_t byte) { return byte <= field.start ? 0.0F : run.x_of(byte - field.start); };
    look.caret_x = x_of(edit.caret());
    look.from = x_of(edit.selection_begin()), look.to = x_of(edit.selection_end());
    if (part.w > 0) field.offset = offset_that_shows(field.offset, look.caret_x, run.width, part.w);
    look.offset = field.offset;
    look.text = ui.copy(window);
    look.editing = true;
    look.caret = field.editing.caret_shown(ui);
    ui.set_caret({part.x + look.caret_x - look.offset, part.y, 1, part.h});
    return result;
}

/// The field has lost the keyboard. What was typed just before belongs to it: a click may come in the same build.
Edit leave_field(Ui& ui, Id id, std::string& text, bool focus_out) {
    Editing& editing = ui.memory<Field>(id).editing;
    Edit result;
    if (focus_out) {
        editing.follow(ui, text);
        ui.events_of(id, [&](const Event& event) {
            if (event.kind == EventKind::text) editing.take(ui, event, text, result);
        });
    }
    result |= editing.close();
    return result;
}

void draw_clear(Painter& painter, const Node& node, const bool& hovered) {
    const Theme& t = painter.theme();
    const Color ink = has(node.is, Is::disabled) ? t.text_disabled : hovered ? t.text : t.text_dim;
    painter.icon(node.rect().inset(painter.em(0.5F)), Icon::cross, ink);
}

/// The cross that clears the field. It is only for the pointer; the key for it is Esc.
bool put_clear(Ui& ui) {
    Node& node = ui.leaf(Role::button, "Clear", Sense::hover | Sense::press);
    node.placed = true;
    node.placement = ui.arena().make(Placement{.fraction = {1, 0}, .pivot = {1, 0}});
    node.size[0] = node.size[1] = px(ui.row_height());
    node.tip = "Clear (Esc)";
    const Response r = ui.respond(node);
    ui.draw_with<draw_clear>(node, r.hovered);
    return r.clicked;
}

/// If `search`, the node is left open.
Edit put_field(Ui& ui, std::string_view label, std::string& text, const TextFieldOptions& options, bool search) {
    const Sense sense = Sense::hover | Sense::press | Sense::focus | Sense::typing | Sense::context;
    Node& node = search ? ui.open(Role::search_field, label, Axis::x, sense) : ui.leaf(Role::text_field, label, sense);
    node.size[0] = options.width.kind == SizeKind::fit ? px(ui.em(12)) : options.width;
    node.minimum[0] = ui.em(options.caption ? 8 : 4);
    node.size[1] = px(ui.row_height());
    node.tip = ui.copy(options.tip);
    node.is |= when(options.read_only, Is::read_only) | when(options.invalid, Is::invalid);
    const Response r = ui.respond(node);
    if (r.focused) node.sense = node.sense | Sense::editing;
    if ((r.hovered && field_part(ui.rect_before(node.id), options.caption).contains(r.pointer)) || r.held)
        ui.set_cursor(Cursor::text);
    FieldLook look;
    look.placeholder = ui.copy(options.placeholder);
    look.style = ui.text_style();
    look.icon = search ? Icon::search : Icon::none;
    look.caption = options.caption, look.clear = search;
    look.style.monospace = options.monospace;
    look.path = options.path;
    const Node* before = ui.before(node.id);
    const bool was_focused = before != nullptr && (has(before->is, Is::focused) || has(before->is, Is::expanded));
    const bool by_menu = was_focused && !r.focused && Editing::menu_open(ui, node.id);
    const bool focused = r.focused || by_menu;
    node.is |= when(by_menu, Is::expanded);
    Edit result;
    if (focused) {
        Field& field = ui.memory<Field>(node.id);
        if (!was_focused) {
            field = {};
            field.whole = options.whole;
            field.editing.open(ui, text,
                               {.bytes = options.bytes,
                                .read_only = options.read_only,
                                .keys_outside = options.keys_outside,
                                .escape_empties = search});
        }
        result = edit_field(ui, node, r, field, text, look);
    } else {
        if (was_focused) result = leave_field(ui, node.id, text, r.focus_out);
        look.text = ui.copy(std::string_view(text).substr(0, code_point_at(text, window_bytes)));
    }
    node.text = text.size() == look.text.size() ? look.text : ui.copy({text.data(), code_point_at(text, spoken_bytes)});
    ui.draw_with<draw_text_field>(node, look);
    if (focused) {
        const Id id = node.id;
        ui.memory<Field>(id).editing.menu(ui, id, node.label, r, text, result);
    }
    return result;
}

}  // namespace

Edit text_field(Ui& ui, std::string_view label, std::string& text, const TextFieldOptions& options) {
    return put_field(ui, label, text, options, false);
}

Edit search_field(Ui& ui, std::string_view label, std::string& text, const TextFieldOptions& options) {
    Edit result = put_field(ui, label, text, options, true);
    const Id id = ui.parent().id;
    if (!text.empty() && !options.read_only && put_clear(ui)) {
        text.clear();
        result |= Edit::once();
        ui.set_focus(id);
    }
    ui.close();
    return result;
}

}  // namespace lapfx::ui
