#include "ui/widgets/text_area.h"

#include "ui/core/paragraph.h"
#include "ui/value/utf8.h"
#include "ui/widgets/editing.h"
#include "ui/widgets/field.h"

namespace lapfx::ui {

namespace {

constexpr float side = 0.5F, above = 0.3F;         // em between the edge and the text
constexpr float bar_width = 0.55F, least_bar = 2;  // em
constexpr std::size_t spoken_bytes = 64 << 10;

/// Kept for good: where the lines break is made anew only when the text, the width or the font changes.
struct Area {
    Editing editing;
    ScrollState scroll;
    std::string text;  ///< that is broken so
    float width = -1;
    TextStyle style;
    std::vector<std::uint32_t> begins{0};
    float goal = -1;      ///< px that up and down keep to; negative: not known
    double scrolled = 0;  ///< s, when a drag scrolled last
    bool bar_held = false, show_caret = false;

    std::size_t line_of(std::size_t byte) const {
        const auto after = std::upper_bound(begins.begin(), begins.end(), byte);
        return static_cast<std::size_t>(after - begins.begin()) - 1;
    }
    /// What is seen of it: without its line break.
    std::string_view line(std::size_t i) const {
        const std::size_t begin = begins[i], end = i + 1 < begins.size() ? begins[i + 1] : text.size();
        std::string_view line(text.data() + begin, end - begin);
        if (line.ends_with('\n')) line.remove_suffix(1);
        return line;
    }
    /// Where the End key goes: before the space, or the letter, that the line is broken after.
    std::size_t line_end(std::size_t i) const {
        const std::string_view seen = line(i);
        const std::size_t end = begins[i] + seen.size();
        const bool soft = i + 1 < begins.size() && end == begins[i + 1];
        return soft ? end - previous_character(text, end) : end;
    }
};

struct AreaLook {
    Area* area;
    std::string_view placeholder;
    float line_height;
    bool editing, caret;
};

Rect text_part(const Rect& rect, float em) {
    Rect part = rect.inset(std::round(side * em), std::round(above * em));
    part.cut_right(std::round(bar_width * em));
    return part;
}
Rect track_of(const Rect& rect, float em) {
    Rect inside = rect.inset(std::round(0.15F * em));
    return inside.cut_right(std::round(bar_width * em));
}

/// Called by the layout once the width is known: the height of all lines.
float lay_out_area(Ui& ui, const Node& node, float width) {
    const AreaLook& look = *static_cast<const AreaLook*>(node.arg);
    Area& area = *look.area;
    const float within = text_part({0, 0, width, 100}, ui.em(1)).w;
    if (area.width != within) {
        area.width = within;
        break_lines(ui.fonts(), area.text, area.style, within, area.begins);
    }
    return std::round(2 * above * ui.em(1)) + look.line_height * static_cast<float>(area.begins.size());
}

/// The lines of what is in the field now, in the width that it had last.
void refresh(Ui& ui, Area& area, std::string_view text, const TextStyle& style, float width) {
    if (area.text == text && area.style == style) return;
    area.text = text;
    area.style = style;
    area.width = width;
    break_lines(ui.fonts(), area.text, style, width, area.begins);
}

void draw_line(Painter& painter, const AreaLook& look, std::size_t index, glm::vec2 at) {
    const Theme& t = painter.theme();
    const Area& area = *look.area;
    const std::string_view line = area.line(index);
    const Run& run = painter.fonts().run(line, area.style);
    const LineMetrics metrics = painter.fonts().metrics(area.style);
    const std::size_t begin = area.begins[index], end = begin + line.size();
    const TextEdit& edit = area.editing.edit;
    if (look.editing && edit.selection_begin() != edit.selection_end()) {
        const std::size_t from = std::max(edit.selection_begin(), begin), to = std::min(edit.selection_end(), end);
        const bool beyond = edit.selection_begin() <= end && edit.selection_end() > end;  // the line break, too
        if (from < to || (from <= to && beyond)) {
            const float x0 = std::round(run.x_of(from - begin));
            const float x1 = std::round(run.x_of(to - begin)) + (beyond ? painter.em(0.3F) : 0.0F);
            painter.fill({at.x + x0, at.y, x1 - x0, look.line_height}, selection_color(t));
        }
    }
    painter.run(run, {at.x, at.y + metrics.ascent}, t.text);
    if (look.editing && look.caret && area.line_of(edit.caret()) == index)
        painter.fill({at.x + std::round(run.x_of(edit.caret() - begin)), at.y, painter.hairline(), look.line_height},
                     t.text);
}

void draw_text_area(Painter& painter, const Node& node, const AreaLook& look) {
    const Theme& t = painter.theme();
    const Area& area = *look.area;
    draw_field(painter, node.rect(), node.is);
    Rect part = text_part(node.rect(), painter.em(1));
    ScrollState scroll = area.scroll;
    scroll.view.y = node.extent[1];
    const float most = std::max(0.0F, scroll.content.y - scroll.view.y);
    scroll.offset.y = std::round(std::clamp(scroll.offset.y, 0.0F, most));
    if (area.text.empty()) {
        Rect first = part;
        painter.text(first.cut_top(look.line_height), look.placeholder, area.style, t.text_dim);
    }
    painter.push_clip({part.x - painter.hairline(), node.at[1], part.w + painter.em(side), node.extent[1]});
    const float top = part.y - scroll.offset.y;
    const auto first = static_cast<std::size_t>(std::max(0.0F, std::floor((node.at[1] - top) / look.line_height)));
    for (std::size_t i = first; i < area.begins.size(); ++i) {
        const float y = top + static_cast<float>(i) * look.line_height;
        if (y >= node.rect().bottom()) break;
        draw_line(painter, look, i, {part.x, y});
    }
    painter.pop_clip();
    const Rect thumb = scroll_thumb(track_of(node.rect(), painter.em(1)), scroll, painter.em(least_bar));
    painter.fill(thumb, area.bar_held ? t.control_hover : t.control, painter.em(bar_width) / 2);
}

/// The character nearest to a place in the window.
std::size_t byte_at(Ui& ui, const Area& area, const Rect& part, float line_height, glm::vec2 at) {
    const float row = std::floor((at.y - part.y + std::round(area.scroll.offset.y)) / line_height);
    const auto last = static_cast<float>(area.begins.size() - 1);
    const auto line = static_cast<std::size_t>(std::clamp(row, 0.0F, last));
    if (row < 0) return 0;
    const std::size_t byte = area.begins[line] + ui.fonts().run(area.line(line), area.style).byte_at(at.x - part.x);
    return std::min(byte, std::max<std::size_t>(area.line_end(line), area.begins[line]));
}

/// Up, down, pages, Home and End go by the lines that are seen.
bool take_by_lines(Ui& ui, Area& area, const Event& event, float line_height) {
    if (event.kind != EventKind::key) return false;
    TextEdit& edit = area.editing.edit;
    const bool select = has(event.mods, Mods::shift), command = has(event.mods, Mods::command);
    const std::size_t line = area.line_of(std::min(edit.caret(), area.text.size()));
    if (!command && (event.key == Key::home || event.key == Key::end)) {
        edit.place(event.key == Key::home ? area.begins[line] : area.line_end(line), select);
        return true;
    }
    const float page = std::max(1.0F, std::floor(area.scroll.view.y / line_height) - 1);
    float by = 0;
    if (event.key == Key::up) by = -1;
    if (event.key == Key::down) by = 1;
    if (event.key == Key::page_up) by = -page;
    if (event.key == Key::page_down) by = page;
    if (by == 0) return false;
    if (area.goal < 0) area.goal = ui.fonts().run(area.line(line), area.style).x_of(edit.caret() - area.begins[line]);
    const float to = static_cast<float>(line) + by, last = static_cast<float>(area.begins.size() - 1);
    if (to < 0 && line == 0) {
        edit.place(0, select);
    } else if (to > last && static_cast<float>(line) == last) {
        edit.place(area.text.size(), select);
    } else {
        const auto target = static_cast<std::size_t>(std::clamp(to, 0.0F, last));
        const std::size_t byte = area.begins[target] + ui.fonts().run(area.line(target), area.style).byte_at(area.goal);
        edit.place(std::min(byte, std::max<std::size_t>(area.line_end(target), area.begins[target])), select);
    }
    return true;
}

/// A drag of the text selects, and scrolls beyond the edges; one of the bar scrolls.
void drag(Ui& ui, Area& area, const Response& r, const Rect& rect, float line_height) {
    if (area.bar_held) {
        area.scroll.offset.y = scrolled_by_thumb(track_of(rect, ui.em(1)), area.scroll, r.drag.y, ui.em(least_bar));
        area.bar_held = r.held;
        return;
    }
    const bool moved = glm::distance(r.pointer, r.pressed_at) > 3 * ui.scale();
    if (!r.held || r.button != Button::left || r.pressed || !moved || !r.focused) {
        area.scrolled = ui.time();
        return;
    }
    const Rect part = text_part(rect, ui.em(1));
    const float beyond = r.pointer.y < rect.y          ? r.pointer.y - rect.y
                         : r.pointer.y > rect.bottom() ? r.pointer.y - rect.bottom()
                                                       : 0.0F;
    if (beyond != 0) {
        const auto passed = static_cast<float>(std::clamp(ui.time() - area.scrolled, 0.0, 0.1));
        const float most = std::max(0.0F, area.scroll.content.y - area.scroll.view.y);
        area.scroll.offset.y = std::clamp(area.scroll.offset.y + drag_scroll_speed(ui, beyond) * passed, 0.0F, most);
        const bool goes_on = beyond < 0 ? area.scroll.offset.y > 0 : area.scroll.offset.y < most;
        if (goes_on) ui.wake_at(ui.time() + 1.0 / 60, "selecting");
    }
    area.scrolled = ui.time();
    const glm::vec2 at{r.pointer.x, std::clamp(r.pointer.y, part.y, std::max(part.y, part.bottom() - 1))};
    area.editing.edit.place(byte_at(ui, area, part, line_height, at), true);
    area.editing.touch(ui);
}

void take_events(Ui& ui, Id id, Area& area, const Rect& rect, float line_height, std::string& text, Edit& result) {
    const Rect part = text_part(rect, ui.em(1));
    ui.events_of(id, [&](const Event& event) {
        refresh(ui, area, area.editing.edit.text(), area.style, part.w);
        if (event.kind == EventKind::press && event.button == Button::left) {
            const Rect track = track_of(rect, ui.em(1));
            const Rect thumb = scroll_thumb(track, area.scroll, ui.em(least_bar));
            if (!thumb.empty() && event.at.x >= track.x) {
                area.bar_held = true;
                if (thumb.contains({thumb.x, event.at.y})) return;
                const float page = event.at.y < thumb.y ? -area.scroll.view.y : area.scroll.view.y;
                area.scroll.offset.y += page * 0.9F;
                return;
            }
            area.editing.press(ui, event, byte_at(ui, area, part, line_height, event.at));
            area.goal = -1;
        } else if (take_by_lines(ui, area, event, line_height)) {
            const bool up_or_down = event.key != Key::home && event.key != Key::end;
            if (!up_or_down) area.goal = -1;
            area.editing.touch(ui);
            area.show_caret = true;
        } else if (area.editing.take(ui, event, text, result)) {
            area.goal = -1;
            const bool stays = has(event.mods, Mods::command) && (event.key == key_of('A') || event.key == key_of('C'));
            area.show_caret |= !stays;  // what is read is not scrolled away
        }
    });
}

/// Scrolls by the least that shows the caret.
void show_caret(Area& area, float line_height, float pad) {
    const float y = pad + static_cast<float>(area.line_of(area.editing.edit.caret())) * line_height;
    const float view = area.scroll.view.y, least = y + line_height + pad - view;
    if (view > 0)
        area.scroll.offset.y = std::max(0.0F, std::clamp(area.scroll.offset.y, least, std::max(least, y - pad)));
    area.show_caret = false;
}

}  // namespace

Edit text_area(Ui& ui, std::string_view label, std::string& text, const TextAreaOptions& options) {
    Node& node = ui.open(Role::text_area, label, Axis::y,
                         Sense::hover | Sense::press | Sense::focus | Sense::typing | Sense::context);
    TextStyle style = ui.text_style();
    style.monospace = options.monospace;
    const float line_height = ui.fonts().metrics(style).height, pad = std::round(above * ui.em(1));
    const float height = std::round(line_height * std::max(1.0F, options.lines) + 2 * pad);
    node.size[0] = options.width.kind == SizeKind::fit ? px(ui.em(20)) : options.width;
    node.size[1] = px(height);
    node.minimum[0] = ui.em(6), node.minimum[1] = height;
    node.tip = ui.copy(options.tip);
    node.is |= when(options.read_only, Is::read_only);
    const Response r = ui.respond(node);
    if (r.focused) node.sense = node.sense | Sense::editing;
    if (r.hovered || r.held) ui.set_cursor(Cursor::text);
    Area& area = ui.memory<Area>(node.id);
    const Node* before = ui.before(node.id);
    const bool was_focused = before != nullptr && (has(before->is, Is::focused) || has(before->is, Is::expanded));
    const bool by_menu = was_focused && !r.focused && Editing::menu_open(ui, node.id);
    const bool focused = r.focused || by_menu;
    node.is |= when(by_menu, Is::expanded);
    const Rect rect = ui.rect_before(node.id);
    area.scroll.view.y = rect.h;
    Edit result;
    bool caret = false;
    if (focused) {
        if (!was_focused) {
            const TextLimits limits{.bytes = options.bytes, .lines = true};
            area.editing.open(ui, text, {.limits = limits, .read_only = options.read_only});
            area.editing.edit.place(text.size(), false);
            area.show_caret = !r.pressed;
        }
        area.editing.follow(ui, text);
        take_events(ui, node.id, area, rect, line_height, text, result);
        drag(ui, area, r, rect, line_height);
        caret = area.editing.caret_shown(ui);
    } else if (was_focused) {
        result = area.editing.close();
        area.bar_held = false;
    }
    refresh(ui, area, focused ? std::string_view(area.editing.edit.text()) : std::string_view(text), style,
            text_part(rect, ui.em(1)).w);
    if (focused && area.show_caret) show_caret(area, line_height, pad);
    node.scroll = &area.scroll;
    node.scrolls[1] = true;
    node.text = ui.copy(std::string_view(area.text).substr(0, spoken_bytes));
    ui.draw_with<draw_text_area>(node, AreaLook{&area, ui.copy(options.placeholder), line_height, focused, caret});
    const void* look = node.arg;
    const Id id = node.id;
    const std::string_view name = node.label;
    Node& lines = ui.leaf(Role::none, {});  // as high as all of them, so that there is something to scroll
    lines.arg = look;
    lines.height_for_width = lay_out_area;
    lines.size[0] = grow();
    ui.close();
    if (focused) area.editing.menu(ui, id, name, r, text, result);
    return result;
}

}  // namespace lapfx::ui
