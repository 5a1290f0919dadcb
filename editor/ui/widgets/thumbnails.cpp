#include "ui/widgets/thumbnails.h"

#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

constexpr float pad_em = 0.3F;
constexpr Color star_ink = rgb(0xf2c14e), star_ground = with_alpha(rgb(0x000000), 0.65F);

struct CellLook {
    ImageHandle image;
    float aspect;
    bool changed, ringed;
};

void draw_cell(Painter& painter, const Node& node, const CellLook& look) {
    const Theme& t = painter.theme();
    const float pad = painter.em(pad_em);
    draw_item_ground(painter, node, look.ringed);
    if (has(node.is, Is::selected)) painter.frame(node.rect(), t.accent, 2 * painter.hairline(), painter.em(t.radius));
    Rect rect = node.rect().inset(pad);
    const Rect picture = rect.cut_top(std::round(rect.w / look.aspect));
    if (look.image != 0) {
        painter.image(picture, look.image);
    } else {
        painter.fill(picture, t.canvas);
        painter.icon(picture.inset(picture.w * 0.4F, picture.h * 0.35F), Icon::image, t.text_disabled);
    }
    if (look.changed) {
        const float size = painter.em(0.5F);
        const Rect dot = rect.cut_right(size);
        painter.fill({dot.x, std::round(dot.center().y - size / 2), size, size}, t.accent, size / 2);
    }
    const Color ink = has(node.is, Is::disabled) ? t.text_disabled : t.text;
    painter.text(rect, node.text, painter.text_style(0.9F), ink, Align::center);
}

struct StarLook {
    bool on;
};
void draw_star(Painter& painter, const Node& node, const StarLook& look) {
    const Theme& t = painter.theme();
    const Rect mark = node.rect().inset(painter.em(0.4F));
    const bool hovered = has(node.is, Is::hovered);
    if (!look.on && !hovered) return;
    // The star has to be visible over a picture of any colour, in any theme.
    painter.fill(mark.inset(-painter.em(0.15F)), star_ground, painter.em(t.radius));
    painter.icon(mark, look.on ? Icon::star_filled : Icon::star, look.on ? star_ink : rgb(0xffffff));
}

struct Metrics {
    std::size_t columns = 1;
    float width = 0, height = 0;  // px of a cell
};

Metrics metrics_of(Ui& ui, float view, const ThumbnailOptions& options) {
    Metrics m;
    const float wish = std::max(1.0F, ui.em(options.cell) + 2 * ui.em(pad_em));
    m.columns = std::max<std::size_t>(1, static_cast<std::size_t>(view / wish));
    m.width = std::floor(view / static_cast<float>(m.columns));
    m.height = std::round((m.width - 2 * ui.em(pad_em)) / options.aspect) + 2 * ui.em(pad_em) + ui.em(1.5F);
    m.height = std::max(m.height, ui.row_height());
    return m;
}

Response put_star(Ui& ui, bool on) {
    Node& star = ui.leaf(Role::toggle, "star", Sense::hover | Sense::press);
    star.size[0] = star.size[1] = px(ui.row_height());
    star.placed = true;
    const glm::vec2 corner(1, 0);
    const float pad = ui.em(pad_em);
    star.placement = ui.arena().make(Placement{.fraction = corner, .offset = {-pad, pad}, .pivot = corner});
    star.tip = on ? "Take the star away" : "Give it a star";
    star.is |= when(on, Is::checked);
    const Response r = ui.respond(star);
    ui.draw_with<draw_star>(star, StarLook{on});
    return r;
}

/// Builds a cell. Returns what happened to its star.
Response put_cell(Ui& ui, RowList& list, std::size_t index, const Thumbnail& item, const Metrics& m,
                  const ThumbnailOptions& options) {
    ui.push_seed(item.key == no_key ? index : item.key);
    Node& node = ui.open(Role::image, "##item", Axis::y, RowList::item_sense);
    if (!item.label.empty()) node.label = ui.copy(item.label);
    node.text = node.label;
    node.tip = ui.copy(item.tip);
    if (item.tip.empty() && ui.text_width(node.text) * 0.9F > m.width - 2 * ui.em(pad_em)) node.tip = node.text;
    node.size[0] = px(m.width);
    node.size[1] = px(m.height);
    list.respond(index, node);
    node.is |= when(item.image == 0, Is::busy) | when(item.changed, Is::changed) | when(item.star, Is::checked);
    ui.draw_with<draw_cell>(node, CellLook{item.image, options.aspect, item.changed, list.ringed(index)});
    const Response star = put_star(ui, item.star);
    ui.close();
    ui.pop_seed();
    return star;
}

}  // namespace

ThumbnailEvents thumbnails(Ui& ui, std::string_view label, Selection& selection, std::size_t count,
                           const FunctionRef<Thumbnail(std::size_t)>& item, const ThumbnailOptions& options) {
    const auto key = [&](std::size_t index) {
        const std::uint64_t own = item(index).key;
        return own == no_key ? index : own;
    };
    const RowList::KeyOf key_of = key;
    // Before the first layout there are as many as fit into the window. Once the width is known the frame is built
    // again.
    const ScrollState& known = ui.memory<ScrollState>(ui.id_of(label));
    const Metrics m = metrics_of(ui, known.view.x > 0 ? known.view.x : ui.window().x, options);
    RowList list(ui, label, selection, key_of,
                 {.count = count,
                  .line_height = m.height,
                  .columns = m.columns,
                  .area = {.width = options.width, .height = options.height, .role = Role::grid}});
    std::size_t starred = no_row, hovered = no_row;
    for (std::size_t index = list.first(); index < list.last();) {
        ui.open(Role::none, {}, Axis::x).size[1] = px(m.height);
        for (std::size_t c = 0; c < m.columns && index < list.last(); ++c, ++index) {
            const Response star = put_cell(ui, list, index, item(index), m, options);
            if (star.clicked) starred = index;
            if (star.hovered) hovered = index;  // the pointer is still over the picture
            if (star.pressed) ui.set_focus(list.area().id());
        }
        ui.close();
    }
    ThumbnailEvents events = list.events();
    if (starred != no_row) events.marked = starred;
    if (hovered != no_row) events.hovered = hovered;
    return events;
}

}  // namespace lapfx::ui
