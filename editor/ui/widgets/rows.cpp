#include "ui/widgets/rows.h"

#include "ui/core/node.h"
#include "ui/widgets/type_ahead.h"

namespace lapfx::ui {

namespace {

ScrollOptions with_senses(const RowListOptions& options) {
    ScrollOptions area = options.area;
    area.sense = area.sense | Sense::press | Sense::focus | Sense::arrows_y | Sense::pages | Sense::extremes |
                 Sense::activate | Sense::context;
    if (options.name_of != nullptr) area.sense = area.sense | Sense::typing;
    if (options.columns > 1) area.sense = area.sense | Sense::arrows_x;
    return area;
}

}  // namespace

void Selection::only(std::uint64_t key) {
    keys.assign(1, key);
    current = anchor = key;
}

void Selection::add(std::uint64_t key) {
    const auto at = std::lower_bound(keys.begin(), keys.end(), key);
    if (at == keys.end() || *at != key) keys.insert(at, key);
}

void Selection::toggle(std::uint64_t key) {
    const auto at = std::lower_bound(keys.begin(), keys.end(), key);
    at != keys.end() && *at == key ? (void)keys.erase(at) : (void)keys.insert(at, key);
    current = anchor = key;
}

std::size_t item_after(Key key, std::size_t at, std::size_t count, std::size_t columns, std::size_t page) {
    if (count == 0) return no_row;
    const bool known = at < count;
    const auto back = [&](std::size_t by) { return !known ? 0 : at >= by ? at - by : at % columns; };
    const auto on = [&](std::size_t by) {
        if (!known) return std::size_t{0};
        if (at + by < count) return at + by;
        const std::size_t below = at + (count - 1 - at) / columns * columns;  // the last item of its own column
        return below != at || at / columns == (count - 1) / columns ? below : count - 1;
    };
    page = std::max<std::size_t>(page, 1);
    switch (key) {
        case Key::up:
            return back(columns);
        case Key::down:
            return on(columns);
        case Key::left:
            return known && at > 0 ? at - 1 : 0;
        case Key::right:
            return known ? std::min(at + 1, count - 1) : 0;
        case Key::page_up:
            return back(page * columns);
        case Key::page_down:
            return on(page * columns);
        case Key::home:
            return 0;
        case Key::end:
            return count - 1;
        default:
            return no_row;
    }
}

RowList::RowList(Ui& ui, std::string_view label, Selection& selection, const KeyOf& key_of,
                 const RowListOptions& options)
    : ui_(ui),
      selection_(selection),
      key_of_(key_of),
      options_(options),
      area_(ui, label, with_senses(options)),
      window_((take_keys(), ui), area_, (options.count + options.columns - 1) / options.columns, options.line_height) {}

std::size_t RowList::find(std::uint64_t key) const {
    if (key == no_key) return no_row;
    for (std::size_t i = 0; i < options_.count; ++i) {
        if (key_of_(i) == key) return i;
    }
    return no_row;
}

void RowList::select_between(std::uint64_t from, std::size_t to) {
    const std::size_t found = find(from), anchor = found == no_row ? to : found;
    selection_.keys.clear();
    for (std::size_t i = std::min(anchor, to); i <= std::max(anchor, to); ++i) selection_.keys.push_back(key_of_(i));
    std::sort(selection_.keys.begin(), selection_.keys.end());
}

void RowList::go(std::size_t item, Mods mods) {
    const std::uint64_t key = key_of_(item);
    events_.selected = true;
    if (options_.multiple && has(mods, Mods::shift) && selection_.anchor != no_key) {
        select_between(selection_.anchor, item);
        selection_.current = key;
    } else if (options_.multiple && has(mods, Mods::command)) {
        selection_.toggle(key);
    } else {
        events_.selected = selection_.keys.size() != 1 || !selection_.has(key);
        selection_.only(key);
    }
}

/// Opens an item. Letters typed after this begin a new word, as they may be meant for the item that has been opened.
void RowList::open(std::size_t item) {
    events_.opened = item;
    if (options_.name_of != nullptr) ui_.memory<TypeAhead>(area_.id()).clear();
}

void RowList::take_letter(const Event& event) {
    TypeAhead& typed = ui_.memory<TypeAhead>(area_.id());
    if (has(event.mods, Mods::command) || event.codepoint < ' ') return;
    if (event.codepoint == ' ' && !typed.open(ui_.time())) return;
    typed.add(event.codepoint, ui_.time());
    const std::size_t to = typed.find(options_.count, find(selection_.current), *options_.name_of);
    if (to >= options_.count) return;
    go(to, Mods::none);
    LineWindow::show(area_, to / options_.columns, options_.line_height);
}

void RowList::take_keys() {
    if (!ui_.has_events(area_.id()) || has(area_.is(), Is::disabled)) return;
    ui_.events_of(area_.id(), [&](const Event& event) {
        const bool beside_all = event.kind == EventKind::press && event.button == Button::left;
        if (beside_all && options_.multiple && !selection_.keys.empty()) {
            selection_.clear();
            events_.selected = true;
        }
        if (event.kind == EventKind::text && options_.name_of != nullptr) take_letter(event);
        if (event.kind != EventKind::key) return;
        const bool spelling = options_.name_of != nullptr && ui_.memory<TypeAhead>(area_.id()).open(ui_.time());
        const std::size_t at = find(selection_.current);
        const auto page = static_cast<std::size_t>(area_.state().view.y / options_.line_height);
        if (event.key == Key::enter) open(at);
        if (event.key == Key::menu) events_.context = at;
        if (event.key == Key::space && at != no_row && !spelling) {
            if (options_.multiple) selection_.toggle(selection_.current), events_.selected = true;
            if (!options_.multiple) events_.marked = at;
        }
        const std::size_t to = item_after(event.key, at, options_.count, options_.columns, page);
        if (to == no_row) return;
        if (spelling) ui_.memory<TypeAhead>(area_.id()).clear();
        go(to, has(event.mods, Mods::shift) ? Mods::shift : Mods::none);
        LineWindow::show(area_, to / options_.columns, options_.line_height);
    });
}

Response RowList::respond(std::size_t item, Node& node) {
    const Response r = ui_.respond(node);
    const std::uint64_t key = key_of_(item);
    if (r.hovered) events_.hovered = item;
    if (r.pressed || r.context) {
        ui_.set_focus(area_.id());
        if (r.pressed || !selection_.has(key)) go(item, r.pressed ? r.mods : Mods::none);
        if (r.context) events_.context = item;
        if (r.pressed && r.clicks == 2 && r.mods == Mods::none) open(item);
        if (events_.selected) ui_.build_again();  // items before this one still show the earlier selection
    }
    node.is |= when(selection_.has(key), Is::selected);
    return r;
}

bool RowList::ringed(std::size_t item) const {
    return has(area_.is(), Is::ringed) && selection_.current == key_of_(item);
}

void draw_item_ground(Painter& painter, const Node& node, bool ringed) {
    const Theme& t = painter.theme();
    const float radius = painter.em(t.radius);
    const bool enabled = !has(node.is, Is::disabled);
    if (has(node.is, Is::selected)) {
        painter.fill(node.rect(), t.accent_ground, radius);
    } else if (has(node.is, Is::hovered) && enabled) {
        painter.fill(node.rect(), t.field_hover, radius);
    }
    if (ringed) painter.frame(node.rect(), t.focus, painter.hairline(), radius);
}

}  // namespace lapfx::ui
