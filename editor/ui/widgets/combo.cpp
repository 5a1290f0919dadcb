#include "ui/widgets/combo.h"

#include <cmath>

#include "ui/core/node.h"
#include "ui/value/letters.h"
#include "ui/widgets/field.h"
#include "ui/widgets/text_field.h"
#include "ui/widgets/type_ahead.h"

namespace lapfx::ui {

namespace {

constexpr std::size_t filter_from = 12;  // with at least so many choices there is a field to filter them
constexpr int most_rows = 14;
constexpr float bar_width = 0.45F, least_bar = 2;  // em

/// The state while the list is open, and of what is typed on a closed one.
struct Choosing {
    ScrollState scroll;
    std::string filter;
    TypeAhead typed;
    std::vector<std::uint32_t> shown;  ///< choices that pass the filter
    std::string filtered_by;
    const void* filtered = nullptr;  ///< `shown` was made from this list
    std::size_t filtered_count = 0;
    int at = -1;  ///< index in `shown` of the marked choice, which Enter takes
    float width = 0;
    Id keys = 0;            ///< the node that has the keyboard
    glm::vec2 pointer{-1};  ///< where it was last: only a pointer that moves takes the mark from the keys
};

struct ComboLook {
    std::string_view text, placeholder;
    bool caption;
};

void draw_combo(Painter& painter, const Node& node, const ComboLook& look) {
    const Theme& t = painter.theme();
    const bool disabled = has(node.is, Is::disabled);
    draw_caption(painter, node, look.caption);
    Rect field = field_part(node.rect(), look.caption);
    draw_field(painter, field, node.is);
    field.cut_left(painter.em(0.5F));
    const Rect arrow = field.cut_right(painter.em(1.6F));
    painter.icon({arrow.x, arrow.y, painter.em(1.1F), arrow.h}, Icon::chevron_down,
                 disabled ? t.text_disabled : t.text_dim);
    const bool none = look.text.empty();
    painter.text(field, none ? look.placeholder : look.text, painter.text_style(),
                 disabled ? t.text_disabled
                 : none   ? t.text_dim
                          : t.text);
}

void draw_row(Painter& painter, const Node& node, const std::string_view& text) {
    const Theme& t = painter.theme();
    if (has(node.is, Is::selected)) painter.fill(node.rect(), t.accent_ground, painter.em(t.radius));
    Rect rect = node.rect();
    const Rect mark = rect.cut_left(painter.em(1.7F));
    if (has(node.is, Is::checked)) painter.icon(mark.inset(painter.em(0.4F)), Icon::check, t.text);
    rect.cut_right(painter.em(0.7F));
    painter.text(rect, text, painter.text_style(), t.text);
}

void draw_bar(Painter& painter, const Node& node, ScrollState* const& scroll) {  // as the layout has set it
    const Rect thumb = scroll_thumb(node.rect(), *scroll, painter.em(least_bar));
    painter.fill(thumb, painter.theme().control_hover, thumb.w / 2);
}

/// The next after `from` that begins with what has been typed; `from` when there is none.
int find_typed(const Choosing& c, std::span<const std::string_view> choices, int from) {
    const std::size_t count = choices.size();
    const std::size_t at = c.typed.find(count, from < 0 ? count : static_cast<std::size_t>(from),
                                        [&](std::size_t i) { return choices[i]; });
    return at < count ? static_cast<int>(at) : from;
}

void refilter(Choosing& c, std::span<const std::string_view> choices) {
    if (c.filtered == choices.data() && c.filtered_count == choices.size() && c.filtered_by == c.filter) return;
    c.filtered = choices.data(), c.filtered_count = choices.size(), c.filtered_by = c.filter;
    const std::uint32_t marked = c.at >= 0 && c.at < static_cast<int>(c.shown.size())
                                     ? c.shown[static_cast<std::size_t>(c.at)]
                                     : ~std::uint32_t{0};
    c.shown.clear();
    c.at = -1;
    for (std::uint32_t i = 0; i < choices.size(); ++i) {
        if (!contains_words(choices[i], c.filter)) continue;
        if (i == marked) c.at = static_cast<int>(c.shown.size());
        c.shown.push_back(i);
    }
    if (c.at < 0 && !c.shown.empty()) c.at = 0;
}

float list_height(const Ui& ui, std::size_t rows) {
    const float row = ui.row_height();
    const float most = std::max(row, std::floor(ui.window().y * 0.7F / row) * row);
    return std::min(most, row * static_cast<float>(std::clamp<std::size_t>(rows, 1, most_rows)));
}

void reveal_row(Ui& ui, Choosing& c) {
    const float row = ui.row_height(), view = list_height(ui, c.shown.size());
    const float y = row * static_cast<float>(std::max(c.at, 0));
    c.scroll.offset.y = std::clamp(c.scroll.offset.y, std::max(0.0F, y + row - view), y);
}

void open_list(Ui& ui, Choosing& c, Id id, std::string_view name, int chosen, std::span<const std::string_view> choices,
               bool caption) {
    c.filter.clear();
    c.typed.clear();
    c.filtered = nullptr;
    c.shown.clear();
    refilter(c, choices);
    c.at = std::max(chosen, 0);
    c.pointer = ui.pointer();
    // The chosen one is in the middle of the list if there are enough rows above and below.
    const float row = ui.row_height(), view = list_height(ui, choices.size());
    c.scroll.offset.y = std::clamp(row * (static_cast<float>(c.at) + 0.5F) - view / 2, 0.0F,
                                   std::max(0.0F, row * static_cast<float>(choices.size()) - view));
    std::string_view longest;
    for (const std::string_view each : choices) longest = each.size() > longest.size() ? each : longest;
    const Rect whole = ui.rect_before(id), field = field_part(whole, caption);
    c.width = std::max(field.w, std::min(std::ceil(ui.text_width(longest)) + ui.em(3.5F), ui.em(40)));
    const glm::vec2 offset{field.x - whole.x, ui.em(0.15F)};
    ui.open_overlay(name, OverlayKind::popup, {.side = Placement::Side::below, .offset = offset, .anchor = id});
}

/// Handles an event of the open list. Returns whether the marked choice is taken.
bool take_list_key(Ui& ui, Choosing& c, const Event& event, std::span<const std::string_view> choices, bool filters,
                   bool& leaves) {
    const int last = static_cast<int>(c.shown.size()) - 1;
    const int page = static_cast<int>(list_height(ui, c.shown.size()) / ui.row_height()) - 1;
    if (event.kind == EventKind::text && !filters && event.codepoint > ' ') {
        c.typed.add(event.codepoint, ui.time());
        c.at = find_typed(c, choices, c.at);
        reveal_row(ui, c);
    }
    if (event.kind != EventKind::key) return false;
    int at = c.at;
    switch (event.key) {
        case Key::up:
            at = at <= 0 ? last : at - 1;
            break;
        case Key::down:
            at = at >= last ? 0 : at + 1;
            break;
        case Key::page_up:
            at = std::max(0, at - std::max(1, page));
            break;
        case Key::page_down:
            at = at + std::max(1, page);
            break;
        case Key::home:
            if (!filters) at = 0;
            break;
        case Key::end:
            if (!filters) at = last;
            break;
        case Key::escape:
            leaves = true;
            return false;
        case Key::space:
            return !filters;
        case Key::enter:
            return true;
        default:
            return false;
    }
    c.at = std::clamp(at, std::min(0, last), last);
    reveal_row(ui, c);
    return false;
}

/// A pointer that moves marks the row under it; one that rests leaves the mark to the keys.
void mark_by_pointer(Ui& ui, Choosing& c, const Rect& list) {
    const bool moved = ui.pointer() != c.pointer;
    c.pointer = ui.pointer();
    if (!moved || !list.contains(c.pointer) || ui.held() != 0) return;
    const auto row = static_cast<std::size_t>((c.pointer.y - list.y + std::round(c.scroll.offset.y)) / ui.row_height());
    if (row < c.shown.size()) c.at = static_cast<int>(row);
}

/// Builds only the visible rows, with room above and below for the others. Returns whether one was clicked.
bool put_rows(Ui& ui, Choosing& c, int chosen, std::span<const std::string_view> choices) {
    const float row = ui.row_height(), view = list_height(ui, c.shown.size());
    const float all = row * static_cast<float>(c.shown.size());
    const float offset = std::clamp(c.scroll.offset.y, 0.0F, std::max(0.0F, all - view));
    const auto first = static_cast<std::size_t>(offset / row);
    const std::size_t end = std::min(c.shown.size(), first + static_cast<std::size_t>(view / row) + 2);
    const auto room = [&](std::size_t rows) { ui.leaf(Role::none, {}).size[1] = px(row * static_cast<float>(rows)); };
    bool clicked = false;
    room(first);
    for (std::size_t i = first; i < end; ++i) {
        const std::uint32_t index = c.shown[i];
        const std::string_view text = ui.copy(choices[index]);
        ui.push_seed(index);
        Node& node = ui.leaf(Role::list_item, text.empty() ? "nothing" : text, Sense::hover | Sense::press);
        ui.pop_seed();
        node.size[0] = grow(), node.size[1] = px(row);
        const Response r = ui.respond(node);
        if (r.pressed) ui.set_focus(c.keys);
        if (r.clicked) c.at = static_cast<int>(i), clicked = true;
        node.is |= when(static_cast<int>(index) == chosen, Is::checked);
        node.is |= when(static_cast<int>(i) == c.at, Is::selected);
        node.text = text;
        ui.draw_with<draw_row>(node, text);
    }
    room(c.shown.size() - end);
    return clicked;
}

void put_bar(Ui& ui, Choosing& c) {
    Node& node = ui.leaf(Role::scroll_bar, "Scroll", Sense::hover | Sense::press);
    node.placed = true;
    node.placement = ui.arena().make(Placement{.fraction = {1, 0}, .pivot = {1, 0}});
    node.size[0] = px(ui.em(bar_width)), node.size[1] = fraction(1);
    const Response r = ui.respond(node);
    const Rect track = ui.rect_before(node.id);
    if (r.held && r.drag.y != 0) c.scroll.offset.y = scrolled_by_thumb(track, c.scroll, r.drag.y, ui.em(least_bar));
    if (r.pressed) {
        const Rect thumb = scroll_thumb(track, c.scroll, ui.em(least_bar));
        if (r.pointer.y < thumb.y) c.scroll.offset.y -= c.scroll.view.y;
        if (r.pointer.y >= thumb.bottom()) c.scroll.offset.y += c.scroll.view.y;
    }
    const float most = std::max(0.0F, c.scroll.content.y - c.scroll.view.y);
    node.number = ui.number(c.scroll.offset.y, 0, most);
    ui.draw_with<draw_bar>(node, &c.scroll);
}

/// The open list. Returns whether the marked choice is taken; `leaves`: the list is to be closed in any case.
bool put_list(Ui& ui, Choosing& c, Node& root, int chosen, std::span<const std::string_view> choices, bool filters,
              bool& leaves) {
    root.size[0] = px(c.width);
    for (std::uint8_t& pad : root.padding) pad = static_cast<std::uint8_t>(ui.em(0.25F));
    root.gap = ui.em(0.25F);
    ui.draw_with<draw_popup>(root, false);
    bool taken = false;
    const auto take = [&](const Event& event) { taken |= take_list_key(ui, c, event, choices, filters, leaves); };
    if (filters) {
        if (text_field(ui, "Filter", c.filter, {.placeholder = "Filter", .keys_outside = true}).changed) {
            refilter(c, choices);
            reveal_row(ui, c);
        }
        c.keys = ui.last().id;
        ui.events_of(c.keys, take);
    }
    refilter(c, choices);
    const Sense keys = Sense::focus | Sense::arrows_y | Sense::pages | Sense::extremes | Sense::typing;
    Node& list = ui.open(Role::list, "Choices", Axis::y, filters ? Sense::hover : Sense::hover | keys);
    list.size[0] = grow(), list.size[1] = px(list_height(ui, c.shown.size()));
    list.clips = list.scrolls[1] = true;
    list.scroll = &c.scroll;
    const Id list_id = list.id;
    if (!filters) {
        c.keys = list_id;
        ui.respond(list);
        ui.events_of(list.id, take);
    }
    mark_by_pointer(ui, c, ui.rect_before(list_id));
    taken |= put_rows(ui, c, chosen, choices);
    put_bar(ui, c);
    ui.close();
    return taken && c.at >= 0;
}

/// A part of a notch of the wheel, which is kept and added to the next.
struct WheelRest {
    float notches = 0;
};

/// Keys and wheel on the closed field.
int closed_choice(Ui& ui, Id id, const Response& r, int chosen, std::span<const std::string_view> choices,
                  bool& opens) {
    const int last = static_cast<int>(choices.size()) - 1;
    int next = chosen;
    if (r.wheel != 0) {
        float& rest = ui.memory<WheelRest>(id).notches;
        if (rest * r.wheel < 0) rest = 0;
        rest += r.wheel;  // touch pads send parts of a notch
        const float notches = std::trunc(rest);
        rest -= notches;
        next = std::clamp(next - static_cast<int>(std::clamp(notches, -1e6F, 1e6F)), 0, last);
    }
    ui.events_of(id, [&](const Event& event) {
        if (event.kind == EventKind::text && event.codepoint > ' ') {
            Choosing& c = ui.memory<Choosing>(id);
            c.typed.add(event.codepoint, ui.time());
            next = find_typed(c, choices, next);
        }
        if (event.kind != EventKind::key) return;
        if (event.key == Key::up) next = std::max(0, next - 1);
        if (event.key == Key::down) next = std::min(last, next + 1);
        opens |= event.key == Key::enter || event.key == Key::space;
    });
    return next;
}

}  // namespace

bool contains_words(std::string_view text, std::string_view words) {
    while (!words.empty()) {
        const std::size_t stop = std::min(words.find(' '), words.size());
        const std::string_view word = words.substr(0, stop);
        const auto at = std::search(text.begin(), text.end(), word.begin(), word.end(),
                                    [](char a, char b) { return lower(a) == lower(b); });
        if (at == text.end() && !word.empty()) return false;
        words.remove_prefix(std::min(stop + 1, words.size()));
    }
    return true;
}

Edit combo(Ui& ui, std::string_view label, int& chosen, std::span<const std::string_view> choices,
           const ComboOptions& options) {
    const int last = static_cast<int>(choices.size()) - 1;
    chosen = std::clamp(chosen, -1, last);
    const int was = chosen;
    Node& node =
        ui.leaf(Role::combo, label,
                Sense::hover | Sense::press | Sense::focus | Sense::arrows_y | Sense::typing | Sense::command_wheel);
    node.size[0] = options.width.kind == SizeKind::fit ? px(ui.em(12)) : options.width;
    node.size[1] = px(ui.row_height());
    node.minimum[0] = ui.em(options.caption ? 9 : 5);
    node.tip = ui.copy(options.tip);
    const Id id = node.id;
    const std::string_view name = node.label;
    const Response r = ui.respond(node);
    bool opens = r.pressed;
    if (last >= 0 && (r.focused || r.wheel != 0)) chosen = closed_choice(ui, id, r, chosen, choices, opens);
    const std::string_view text = chosen < 0 ? std::string_view() : ui.copy(choices[static_cast<std::size_t>(chosen)]);
    node.text = text;
    node.number = ui.number(chosen, 0, last, 1);
    ui.draw_with<draw_combo>(node, ComboLook{text, ui.copy(options.placeholder), options.caption});
    if (last < 0 || has(node.is, Is::disabled) || (!opens && ui.overlay_count() == 0))
        return chosen != was ? Edit::once() : Edit{};

    const std::string_view list_name = overlay_name(ui, "combo ", id);
    Choosing& c = ui.memory<Choosing>(id);
    if (opens) open_list(ui, c, id, list_name, chosen, choices, options.caption);
    if (!ui.overlay_open(list_name)) return chosen != was ? Edit::once() : Edit{};
    node.is |= Is::expanded;
    bool leaves = false;
    Node& root = *ui.open_overlay_node(list_name, Role::group, ui.join({name, " choices"}), Axis::y);
    const bool taken = put_list(ui, c, root, chosen, choices, choices.size() >= filter_from, leaves);
    ui.close_overlay_node();
    if (taken) chosen = static_cast<int>(c.shown[static_cast<std::size_t>(c.at)]);
    if (taken || leaves) ui.close_overlay(list_name);
    return chosen != was ? Edit::once() : Edit{};
}

}  // namespace lapfx::ui
