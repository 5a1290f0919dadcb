#include "ui/widgets/table.h"

#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

constexpr float narrowest = 2, widest = 100;  // em
constexpr float handle_em = 0.7F;
constexpr float pad_em = 0.5F;
constexpr float order_em = 0.8F, order_pad_em = 0.2F;  // the arrow of the order, next to the title

using CellOf = FunctionRef<TableCell(std::size_t, std::size_t)>;

struct RowLook {
    bool ringed;
};
void draw_row(Painter& painter, const Node& node, const RowLook& look) {
    draw_item_ground(painter, node, look.ringed);
}

struct CellLook {
    std::string_view text;
    Icon icon;
    Color ink;
    TextStyle style;
    Align align;
};

void draw_cell(Painter& painter, const Node& node, const CellLook& look) {
    Rect rect = node.rect().inset(painter.em(pad_em), 0);
    if (look.icon != Icon::none) {
        painter.icon(rect.cut_left(painter.em(1)), look.icon, look.ink);
        rect.cut_left(painter.em(0.4F));
    }
    painter.text(rect, look.text, look.style, look.ink, look.align);
}

struct HeaderLook {
    Align align;
    Icon order;
};

void draw_header(Painter& painter, const Node& node, const HeaderLook& look) {
    const Theme& t = painter.theme();
    const bool live = !has(node.is, Is::disabled);
    const Rect rect = node.rect();
    const bool lit = live && has(node.is, Is::hovered) && has(node.sense, Sense::activate);
    painter.fill(rect, lit ? t.control_hover : t.header);
    const float line = painter.hairline();
    painter.fill({rect.x, rect.bottom() - line, rect.w, line}, t.border);
    Rect inside = rect.inset(painter.em(pad_em), 0);
    const TextStyle style = painter.text_style();
    if (look.order !=
        Icon::none) {  // in the padding if possible; where there is not room for both, the title has priority
        Rect rest = rect.inset(painter.em(order_pad_em), 0);
        const Rect mark = rest.cut_right(painter.em(order_em));
        rest.cut_right(painter.em(order_pad_em));
        const float right = std::min(inside.right(), rest.right()), room = right - inside.x;
        if (painter.fonts().run(node.shown, style).width <= room + 0.5F) {
            painter.icon(mark, look.order, t.text);
            inside.w = room;
        }
    }
    const Color ink = !live ? t.text_disabled : look.order != Icon::none ? t.text : t.text_dim;
    painter.text(inside, node.shown, style, ink, look.align);
}

void draw_header_ground(Painter& painter, const Node& node, const Color& color) {
    const Rect rect = node.rect();
    const float line = painter.hairline();
    painter.fill(rect, color);
    painter.fill({rect.x, rect.bottom() - line, rect.w, line}, painter.theme().border);
}

void draw_handle(Painter& painter, const Node& node, const Color& rest) {
    const bool active = has(node.is, Is::hovered) || has(node.is, Is::held);
    const float width = (active ? 2 : 1) * painter.hairline();
    const Rect rect = node.rect();
    painter.fill({std::round(rect.center().x - width / 2), rect.y, width, rect.h - painter.hairline()},
                 active ? painter.theme().focus : rest);
}

/// One table while it is built.
struct Making {
    Ui& ui;
    TableState& state;
    std::span<const TableColumn> columns;
    const CellOf& cell;
    TableEvents& events;

    float width(std::size_t column) const { return ui.em(state.widths[column]); }
    void resize(std::size_t column, float ems) {
        const float next = std::clamp(ems, narrowest, widest);
        if (next == state.widths[column]) return;
        state.widths[column] = next;
        events.resized = true;
        ui.build_again();  // rows were built before the header
    }
    void sort(std::size_t column) {
        const bool same = state.sort_column == static_cast<int>(column);
        state.descending = same && !state.descending;
        state.sort_column = static_cast<int>(column);
        events.sorted = true;
        ui.build_again();
    }
    float cell_width(const TableCell& c) const {
        const TextStyle style = c.number ? ui.number_style() : ui.text_style();
        const float icon = c.icon == Icon::none ? 0.0F : ui.em(1) + ui.em(0.4F);
        return ui.fonts().run(c.text, style).width + icon + 2 * ui.em(pad_em) + 1;
    }
    void fit(std::size_t column, std::size_t first, std::size_t last) {
        float most = ui.text_width(columns[column].title) + ui.em(1.1F) + 2 * ui.em(pad_em);
        for (std::size_t row = first; row < last; ++row) most = std::max(most, cell_width(cell(row, column)));
        resize(column, std::ceil(most) / ui.em(1));
    }
    void row(RowList& list, std::size_t index, std::uint64_t key);
    void header(RowList& list, float height);
    Id header_cell(std::size_t column, float at, float height, int& step);
    void handle(RowList& list, std::size_t column, float at, float height);
};

void Making::row(RowList& list, std::size_t index, std::uint64_t key) {
    ui.push_seed(key);
    const TableCell title = columns.empty() ? TableCell{} : cell(index, 0);
    Node& row = ui.open(Role::row, "##row", Axis::x, RowList::item_sense);
    if (!title.text.empty()) row.label = ui.copy(title.text);  // unchanged: a file may be called a##b
    row.size[1] = px(ui.row_height());
    list.respond(index, row);
    ui.draw_with<draw_row>(row, RowLook{list.ringed(index)});
    for (std::size_t c = 0; c < columns.size(); ++c) {
        const TableCell content = c == 0 ? title : cell(index, c);
        Node& node = ui.leaf(Role::cell, columns[c].title);
        node.text = ui.copy(content.text);
        node.size[0] = px(width(c));
        const Theme& t = ui.theme();
        const Color ink = ui.disabled() ? t.text_disabled : color_of(t, content.tone);
        const TextStyle style = content.number ? ui.number_style() : ui.text_style();
        ui.draw_with<draw_cell>(node, CellLook{node.text, content.icon, ink, style, columns[c].align});
    }
    ui.close();
    ui.pop_seed();
}

Id Making::header_cell(std::size_t column, float at, float height, int& step) {
    const TableColumn& c = columns[column];
    const Sense keys = Sense::focus | Sense::arrows_x | Sense::erase;
    const Sense clicks = c.sortable ? Sense::press | Sense::activate : Sense::none;
    Node& node = ui.leaf(Role::column_header, c.title, Sense::hover | keys | clicks);
    const Id id = node.id;
    node.size[0] = px(width(column));
    node.size[1] = px(height);
    node.placed = true;
    node.placement = ui.arena().make(Placement{.offset = {at, 0}});
    node.tip = ui.copy(c.tip);
    const bool sorts = state.sort_column == static_cast<int>(column);
    node.text = !sorts ? "" : state.descending ? "descending" : "ascending";
    const Icon order = !sorts ? Icon::none : state.descending ? Icon::sort_down : Icon::sort_up;
    const Response r = ui.respond(node);
    node.is |= when(sorts, Is::selected);
    ui.draw_with<draw_header>(node, HeaderLook{c.align, order});
    if (ui.disabled()) return id;
    if (r.clicked && c.sortable) sort(column);
    ui.events_of(id, [&](const Event& event) {
        if (event.kind != EventKind::key) return;
        const int way = event.key == Key::left ? -1 : event.key == Key::right ? 1 : 0;
        if (event.key == Key::backspace) resize(column, c.width);
        has(event.mods, Mods::shift) ? resize(column, state.widths[column] + static_cast<float>(way))
                                     : (void)(step = way);
    });
    return id;
}

struct HandleDrag {
    float from = 0;  // em
};

void Making::handle(RowList& list, std::size_t column, float at, float height) {
    const float wide = ui.em(handle_em);
    Node& node = ui.leaf(Role::handle, ui.join({"width of ", columns[column].title}), Sense::hover | Sense::press);
    const Id id = node.id;
    node.size[0] = px(wide);
    node.size[1] = px(height);
    node.placed = true;
    node.placement = ui.arena().make(Placement{.offset = {at - std::round(wide / 2), 0}});
    node.number = ui.number(state.widths[column], narrowest, widest, 1);
    const Response r = ui.respond(node);
    ui.draw_with<draw_handle>(node, ui.theme().border);
    if (r.hovered || r.held) ui.set_cursor(Cursor::resize_x);
    HandleDrag& drag = ui.memory<HandleDrag>(id);
    if (r.pressed) drag.from = state.widths[column];
    if (r.pressed && r.clicks == 2) {
        fit(column, list.first(), list.last());
        drag.from = state.widths[column];
    } else if ((r.held || r.released) && !r.pressed && r.pointer.x != r.pressed_at.x) {
        resize(column, drag.from + (r.pointer.x - r.pressed_at.x) / ui.em(1));
    }
    if (r.cancelled) resize(column, drag.from);
}

/// Builds the header above the rows; it scrolls sideways with them.
void Making::header(RowList& list, float height) {
    const float shift = std::round(list.area().state().offset.x);
    Node& ground = ui.leaf(Role::none, {});
    ground.size[0] = grow();
    ground.size[1] = px(height);
    ground.placed = true;
    ground.placement = ui.arena().make(Placement{});
    ui.draw_with<draw_header_ground>(ground, ui.theme().header);
    float at = -shift;
    Id before = 0;
    bool to_next = false;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        int step = 0;
        const Id id = header_cell(c, at, height, step);
        if (to_next || (step < 0 && before != 0)) {
            ui.set_focus(to_next ? id : before, true);
            ui.reveal(to_next ? id : before);
        }
        to_next = step > 0;
        before = id;
        at += width(c);
    }
    ui.leaf(Role::none, {}).size[0] = px(at + shift);  // so that the header can be scrolled without rows, too
    at = -shift;
    for (std::size_t c = 0; c < columns.size(); ++c) handle(list, c, at += width(c), height);
}

}  // namespace

TableEvents table(Ui& ui, std::string_view label, TableState& state, std::span<const TableColumn> columns,
                  std::size_t count, const CellOf& cell, const TableOptions& options) {
    if (state.widths.size() != columns.size()) {
        state.widths.clear();
        for (const TableColumn& column : columns) state.widths.push_back(column.width);
    }
    for (float& width : state.widths) width = std::isfinite(width) ? std::clamp(width, narrowest, widest) : 8.0F;

    const auto number = [](std::size_t row) { return static_cast<std::uint64_t>(row); };
    const RowList::KeyOf by_number = number;
    const RowList::KeyOf& key_of = options.key_of != nullptr ? *options.key_of : by_number;
    const auto first_text = [&cell](std::size_t row) { return cell(row, 0).text; };
    const NameOf name_of = first_text;
    TableEvents events;
    const float height = ui.row_height();
    {
        RowList list(ui, label, state.selection, key_of,
                     {.count = count,
                      .line_height = height,
                      .multiple = options.multiple,
                      .name_of = options.letters && !columns.empty() ? &name_of : nullptr,
                      .area = {.sideways = true,
                               .width = options.width,
                               .height = options.height,
                               .top = height,
                               .role = Role::table}});
        if (options.show < count) {
            // Before the first layout nobody knows how many rows are in sight.
            if (list.area().state().view.y > 0) {
                const float before = list.area().state().offset.y;
                LineWindow::show(list.area(), options.show, height);
                // The rows of this build are those of before.
                if (list.area().state().offset.y != before) ui.build_again();
            } else {
                events.unseen = true, ui.build_again();
            }
        }
        Making making{ui, state, columns, cell, events};
        for (std::size_t row = list.first(); row < list.last(); ++row) making.row(list, row, key_of(row));
        making.header(list, height);
        static_cast<RowEvents&>(events) = list.events();
    }
    return events;
}

}  // namespace lapfx::ui
