#include "ui/widgets/tabs.h"

#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/menu.h"

namespace lapfx::ui {

namespace {

constexpr float widest_em = 16, pad_em = 0.8F, close_pad_em = 0.45F, cross_em = 1.4F;
constexpr float slack_em = 0.5F;  // that the pointer may move before a press becomes a drag

struct Strip {
    ScrollState scroll;
    int active = -1;
    bool overflow = false;
    Id focus_next = 0;
    bool dragging = false;
};

struct TabLook {
    bool active, closable;
    float pad;  ///< em
};

Rect cross_of(const Rect& tab, float width) {
    Rect rect = tab;
    return rect.cut_right(width);
}

void draw_tab(Painter& painter, const Node& node, const TabLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled), hovered = has(node.is, Is::hovered) && !disabled;
    const Rect rect = node.rect();
    // One that is not seen whole is in the menu of all tabs: half a name looks like a mistake. Unless there is no room
    // for more than half of it.
    const bool fits = painter.clip().w >= rect.w;
    if ((fits || !look.active) && intersect(rect, painter.clip()).w < rect.w - 1) return;
    if (look.active || hovered) painter.fill(rect, look.active ? t.panel : t.control);
    const float line = 2 * painter.hairline();
    if (look.active) painter.fill({rect.x, rect.y, rect.w, line}, disabled ? t.text_disabled : t.accent);
    Rect inside = rect.inset(painter.em(look.pad), 0);
    if (look.closable) {
        const Rect cross = cross_of(rect, painter.em(cross_em));
        if (look.active || hovered) painter.icon(cross.inset(painter.em(0.35F)), Icon::cross, t.text_dim);
        inside = rect;
        inside.cut_left(painter.em(look.pad));
        inside.cut_right(painter.em(cross_em));
    }
    const Color ink = disabled ? t.text_disabled : look.active || hovered ? t.text : t.text_dim;
    painter.text(inside, node.shown, painter.text_style(), ink, look.closable ? Align::start : Align::center);
}

void draw_strip(Painter& painter, const Node& node, const Color& color) {
    painter.ground(node.rect(), color);
}

/// One strip while it is built.
struct Making {
    Ui& ui;
    Strip& strip;
    int active, count;
    const TabOptions& options;
    TabEvents& events;
    float pad = pad_em;

    Id tab(int index, std::string_view name);
    void take_key(int index, const Event& event);
    void menu(Id key, std::span<const std::string_view> names);
};

void Making::take_key(int index, const Event& event) {
    int to = index;
    if (event.key == Key::left) to = (index + count - 1) % count;
    if (event.key == Key::right) to = (index + 1) % count;
    if (event.key == Key::home) to = 0;
    if (event.key == Key::end) to = count - 1;
    if (event.key == Key::del && options.closable) events.closed = index;
    if (to != index) events.chosen = to;
}

Id Making::tab(int index, std::string_view name) {
    // Tab stops only at the tab that is shown; arrows lead to the others.
    const Sense keys = index == active
                           ? Sense::focus | Sense::arrows_x | Sense::extremes | Sense::activate | Sense::erase
                           : Sense::none;
    Node& node = ui.leaf(Role::tab, name, Sense::hover | Sense::press | Sense::middle | Sense::context | keys);
    const Id id = node.id;
    const float ends = ui.em(pad) + ui.em(options.closable ? cross_em : pad);
    const float wish = std::ceil(ui.text_width(node.shown)) + ends;
    node.size[0] = px(std::min(wish, ui.em(widest_em)));
    node.size[1] = px(ui.row_height());
    if (wish > ui.em(widest_em)) node.tip = node.shown;
    const Response r = ui.respond(node);
    node.is |= when(index == active, Is::selected);
    ui.draw_with<draw_tab>(node, TabLook{index == active, options.closable, pad});
    if (ui.disabled()) return id;

    const Rect rect = ui.rect_before(id);
    if (!rect.empty() && ui.pointer().x > rect.center().x) events.place = index + 1;
    const Rect cross = cross_of(rect, options.closable ? ui.em(cross_em) : 0.0F);
    const bool from_cross = cross.contains(r.pressed_at), left = r.button == Button::left;
    if (r.context) events.context = index;
    if (r.pressed) strip.dragging = false;
    if (r.pressed && !from_cross) {
        events.chosen = events.pressed = index;
        ui.set_focus(id);
    }
    ui.events_of(id, [&](const Event& event) {
        if (event.kind == EventKind::key) take_key(index, event);
        const bool released = event.kind == EventKind::release && rect.contains(event.at) && options.closable;
        if (released && event.button == Button::middle) events.closed = index;
        if (released && event.button == Button::left && from_cross && cross.contains(event.at) && !strip.dragging)
            events.closed = index;
    });
    if (options.draggable && r.held && left && glm::distance(r.pointer, r.pressed_at) > ui.em(slack_em))
        strip.dragging = true;
    if (strip.dragging && r.held) events.grabbed = index;
    if (strip.dragging && (r.released || r.cancelled)) {
        (r.released ? events.dropped : events.grabbed) = r.released ? index : -1;
        events.cancelled = r.cancelled;
        strip.dragging = false;
    }
    return id;
}

/// The menu of all tabs, for when not all of them are visible.
void Making::menu(Id key, std::span<const std::string_view> names) {
    const std::string_view name = ui.join({"tabs of ", {reinterpret_cast<const char*>(&key), sizeof key}});
    if (strip.overflow) {
        ui.push_seed(key);  // several strips side by side have one each
        const bool clicked = icon_button(ui, Icon::chevron_down, "All tabs", {.quiet = true});
        if (clicked) open_menu(ui, name, {.side = Placement::Side::below, .anchor = ui.last().id});
        ui.pop_seed();
    }
    if (Menu all(ui, name, "All tabs"); all) {
        for (int i = 0; i < count; ++i) {
            ui.push_seed(static_cast<std::uint64_t>(i));
            if (menu_item(ui, names[static_cast<std::size_t>(i)], {.checked = i == active})) events.chosen = i;
            ui.pop_seed();
        }
    }
}

}  // namespace

TabEvents tab_strip(Ui& ui, std::string_view label, int active, std::span<const std::string_view> names,
                    const TabOptions& options) {
    TabEvents events;
    const int count = static_cast<int>(names.size());
    const Id key = ui.id_of(label);
    Strip& strip = ui.memory<Strip>(key);
    Node& outer = ui.open(Role::none, {}, Axis::x);
    outer.size[0] = options.width;
    outer.size[1] = px(ui.row_height());
    ui.draw_with<draw_strip>(outer, ui.theme().window);
    Node& list = ui.open(Role::tab_list, label, Axis::x);
    list.size[0] = grow();
    list.clips = true;
    list.scrolls[0] = true;
    list.scroll = &strip.scroll;
    Making making{ui, strip, std::clamp(active, 0, std::max(count - 1, 0)), count, options, events};
    // Rather closer together than out of sight.
    const float room = strip.scroll.view.x + (strip.overflow ? ui.row_height() : 0);
    float wish = 0;
    for (const std::string_view name : names)
        wish += std::ceil(ui.text_width(split_label(name).shown)) +
                ui.em(options.closable ? pad_em + cross_em : 2 * pad_em);
    if (room > 0 && wish > room) making.pad = close_pad_em;
    Id active_id = 0;
    for (int i = 0; i < count; ++i) {
        const Id id = making.tab(i, names[static_cast<std::size_t>(i)]);
        if (i == making.active) active_id = id;
    }
    ui.close();
    strip.overflow = strip.scroll.content.x > strip.scroll.view.x + (strip.overflow ? ui.row_height() : 0) + 0.5F;
    making.menu(key, names);
    ui.close();
    if (making.active != strip.active && active_id != 0) {
        // If the keyboard was on a tab, it moves to the tab of the new page.
        if (ui.focus() != 0 && ui.focus() == strip.focus_next) ui.set_focus(active_id, ui.focus_ringed());
        ui.reveal(active_id);
        strip.active = making.active;
    }
    strip.focus_next = active_id;
    if (events.chosen == making.active) events.chosen = -1;
    return events;
}

Tabs::Tabs(Ui& ui, std::string_view label, int& active, std::span<const std::string_view> names,
           const TabsOptions& options)
    : ui_(ui) {
    Node& outer = ui.open(Role::group, label, Axis::y, Sense::tab_keys);
    const Id id = outer.id;
    outer.size[0] = options.width;
    outer.size[1] = options.height;
    outer.rigid = false;
    const int count = static_cast<int>(names.size()), most = std::max(count - 1, 0);
    active = std::clamp(active, 0, most);
    const int before = active;
    ui.events_of(id, [&](const Event& event) {
        if (event.kind == EventKind::key && count > 0)
            active = (active + (event.key == Key::page_down ? 1 : count - 1)) % count;
    });
    if (const int chosen = tab_strip(ui, "tabs", active, names).chosen; chosen >= 0) {
        active = chosen;
        ui.build_again();  // the tabs were built with the other one chosen
    }
    changed_ = active != before;
    ui.push_seed(count > 0 ? names[static_cast<std::size_t>(active)] : std::string_view{});
    Node& page = ui.open(Role::none, {}, Axis::y);
    page.size[0] = grow();
    page.size[1] = options.height.kind == SizeKind::fit ? fit() : grow();
    page.gap = ui.em(ui.theme().gap);
    for (std::uint8_t& pad : page.padding)
        pad = static_cast<std::uint8_t>(std::clamp(ui.em(options.padding), 0.0F, 255.0F));
    page.rigid = false;
    page.clips = true;
}

Tabs::~Tabs() {
    ui_.close();
    ui_.pop_seed();
    ui_.close();
}

}  // namespace lapfx::ui
