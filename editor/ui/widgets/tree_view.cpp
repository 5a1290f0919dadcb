#include "ui/widgets/tree_view.h"

namespace lapfx::ui {

namespace {

constexpr float step_em = 1.1F;     // a level further in
constexpr float least_name_em = 3;  // of a name that is cut

bool has_children(std::span<const TreeItem> items, std::size_t i) {
    return i + 1 < items.size() && items[i + 1].depth > items[i].depth;
}

std::uint64_t key_at(std::span<const TreeItem> items, std::size_t i) {
    return items[i].key == no_key ? i : items[i].key;
}

bool is_closed(const TreeState& state, std::uint64_t key) {
    return std::binary_search(state.closed.begin(), state.closed.end(), key);
}

/// Of the items that no closed one above hides.
void find_shown(const TreeState& state, std::span<const TreeItem> items, std::vector<std::size_t>& shown) {
    shown.clear();
    int below = -1;  // depth of a closed item: what is deeper is hidden; -1: none
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (below >= 0 && items[i].depth > below) continue;
        below = is_closed(state, key_at(items, i)) ? items[i].depth : -1;
        shown.push_back(i);
    }
}

struct ItemLook {
    Icon icon;
    float in;    // px
    float mark;  // px at the right end that its mark has
    bool parent, open, dim, ringed;
};

void draw_item(Painter& painter, const Node& node, const ItemLook& look) {
    const Theme& t = painter.theme();
    draw_item_ground(painter, node, look.ringed);
    Rect rect = node.rect().inset(painter.em(0.3F), 0);
    rect.cut_left(look.in);
    if (look.mark > 0) rect.w = std::max(0.0F, node.rect().right() - look.mark - rect.x);
    const bool disabled = has(node.is, Is::disabled);
    const Color ink = disabled || look.dim ? t.text_disabled : t.text;
    const Rect triangle = rect.cut_left(painter.em(1));
    if (look.parent)
        painter.icon(triangle.inset(painter.em(0.1F)), look.open ? Icon::chevron_down : Icon::chevron_right,
                     t.text_dim);
    rect.cut_left(painter.em(0.2F));
    if (look.icon != Icon::none) {
        painter.icon(rect.cut_left(painter.em(1)), look.icon, disabled || look.dim ? t.text_disabled : t.text_dim);
        rect.cut_left(painter.em(0.4F));
    }
    painter.text(rect, node.text, painter.text_style(), ink);
}

struct MarkLook {
    Icon icon;
    bool dim;
};
void draw_mark(Painter& painter, const Node& node, const MarkLook& look) {
    const Theme& t = painter.theme();
    const bool lit = has(node.is, Is::hovered) && !has(node.is, Is::disabled);
    painter.icon(node.rect().inset(painter.em(0.4F)), look.icon,
                 lit        ? t.text
                 : look.dim ? t.text_disabled
                            : t.text_dim);
}

/// One tree while it is built.
struct Making {
    Ui& ui;
    TreeState& state;
    std::span<const TreeItem> items;
    TreeEvents& events;

    void toggle(std::size_t item) {
        const std::uint64_t key = key_at(items, item);
        const auto at = std::lower_bound(state.closed.begin(), state.closed.end(), key);
        is_closed(state, key) ? (void)state.closed.erase(at) : (void)state.closed.insert(at, key);
        events.toggled = item;
        ui.build_again();
    }
    void row(RowList& list, std::size_t line, std::size_t index);
    void sideways(RowList& list, std::span<const std::size_t> shown);
};

void Making::row(RowList& list, std::size_t line, std::size_t index) {
    const TreeItem& item = items[index];
    const bool parent = has_children(items, index), open = parent && !is_closed(state, key_at(items, index));
    ui.push_seed(key_at(items, index));
    Node& node = ui.open(Role::tree_item, "##item", Axis::x, RowList::item_sense);
    const Id id = node.id;
    if (!item.label.empty()) node.label = ui.copy(item.label);
    node.text = node.label;
    node.size[1] = px(ui.row_height());
    const float in = ui.em(step_em) * static_cast<float>(item.depth);
    const float mark = item.mark == Icon::none ? 0.0F : ui.row_height();
    const float icon = item.icon == Icon::none ? 0.0F : ui.em(1) + ui.em(0.4F);
    node.size[0] = grow();
    // Names are cut where the view ends, so that marks stay in sight; deep down a few letters of them are left and it
    // scrolls.
    const float name = std::ceil(ui.text_width(node.text)) + 1,
                before = ui.em(mark > 0 ? 0.3F : 0.6F) + in + ui.em(1.2F) + icon;
    node.minimum[0] = before + std::min(name, ui.em(least_name_em)) + mark;
    const ScrollState& area = list.area().state();
    if (area.view.x > 0 && before + name + mark > area.view.x) node.tip = node.text;
    const Response r = list.respond(line, node);
    node.is |= when(open, Is::expanded);
    node.number = ui.number(item.depth, 0, 255);
    ui.draw_with<draw_item>(node, ItemLook{item.icon, in, mark, parent, open, item.dim, list.ringed(line)});
    if (item.mark != Icon::none) {
        spacer(ui);
        Node& button = ui.leaf(Role::toggle, "mark", Sense::hover | Sense::press);
        button.size[0] = button.size[1] = px(ui.row_height());
        button.tip = ui.copy(item.mark_tip);
        const Response on_mark = ui.respond(button);
        ui.draw_with<draw_mark>(button, MarkLook{item.mark, item.dim});
        if (on_mark.pressed) ui.set_focus(list.area().id());
        if (on_mark.clicked) events.marked_item = index;
    }
    ui.close();
    ui.pop_seed();
    if (!parent || !r.pressed) return;
    const float triangle = ui.rect_before(id).x + ui.em(0.3F) + in;
    const bool on_it = r.pressed_at.x >= triangle - ui.em(0.2F) && r.pressed_at.x < triangle + ui.em(1.2F);
    if (on_it || r.clicks == 2) toggle(index);
}

/// Left and Right of the current item.
void Making::sideways(RowList& list, std::span<const std::size_t> shown) {
    const RowEvents& e = list.events();
    if (e.sideways == no_row) return;
    const std::size_t index = shown[e.sideways];
    const bool parent = has_children(items, index), open = parent && !is_closed(state, key_at(items, index));
    if (parent && (e.direction > 0) != open) return toggle(index);
    std::size_t to = index;
    if (e.direction > 0 && parent) to = index + 1;
    if (e.direction < 0) {
        while (to > 0 && items[to].depth >= items[index].depth) --to;
        if (items[to].depth >= items[index].depth) return;
    }
    if (to == index) return;
    state.selection.only(key_at(items, to));
    events.selected = true;
    const auto line = static_cast<std::size_t>(std::lower_bound(shown.begin(), shown.end(), to) - shown.begin());
    LineWindow::show(list.area(), line, ui.row_height());
    ui.build_again();
}

struct Shown {
    std::vector<std::size_t> items;  // kept from frame to frame, so that its memory is
};

}  // namespace

TreeEvents tree_view(Ui& ui, std::string_view label, TreeState& state, std::span<const TreeItem> items,
                     const TreeOptions& options) {
    std::vector<std::size_t>& shown = ui.memory<Shown>(ui.id_of(label)).items;
    find_shown(state, items, shown);
    const auto key = [&](std::size_t line) { return key_at(items, shown[line]); };
    const RowList::KeyOf key_of = key;
    TreeEvents events;
    RowList list(ui, label, state.selection, key_of,
                 {.count = shown.size(),
                  .line_height = ui.row_height(),
                  .multiple = options.multiple,
                  .left_right = true,
                  .area = {.sideways = true, .width = options.width, .height = options.height, .role = Role::tree}});
    Making making{ui, state, items, events};
    for (std::size_t line = list.first(); line < list.last(); ++line) making.row(list, line, shown[line]);
    making.sideways(list, shown);
    const auto item = [&](std::size_t line) { return line == no_row ? no_row : shown[line]; };
    const RowEvents& e = list.events();
    events.selected |= e.selected;
    events.opened = item(e.opened);
    events.context = item(e.context);
    events.marked = item(e.marked);
    events.hovered = item(e.hovered);
    events.sideways = item(e.sideways);
    events.direction = e.direction;
    if (events.marked != no_row && items[events.marked].mark != Icon::none) events.marked_item = events.marked;
    return events;
}

}  // namespace lapfx::ui
