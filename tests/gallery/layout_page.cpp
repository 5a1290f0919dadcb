#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/core/node.h"

namespace lapfx::gallery {

namespace {

struct TileLook {
    ui::Color color;
};

void draw_tile(ui::Painter& painter, const ui::Node& node, const TileLook& look) {
    painter.fill(node.rect(), look.color, painter.em(painter.theme().radius));
    painter.frame(node.rect(), painter.theme().border, painter.hairline(), painter.em(painter.theme().radius));
    painter.text(node.rect().inset(painter.em(0.3F), 0), node.shown, painter.text_style(0.85F),
                 painter.theme().text_dim, ui::Align::center);
}

void tile(ui::Ui& ui, std::string_view name, ui::Size width, ui::Size height) {
    ui::Node& node = ui.leaf(ui::Role::image, name);
    node.size[0] = width;
    node.size[1] = height;
    node.minimum[0] = ui.em(2);
    node.rigid = width.kind == ui::SizeKind::px;
    ui.draw_with<draw_tile>(node, TileLook{ui.theme().control});
}

void sizes(ui::Ui& ui) {
    const Part part(ui, "Sizes");
    const ui::Size high = ui::px(ui.row_height());
    {
        const Line line(ui, "grow");
        tile(ui, "1", ui::grow(), high);
        tile(ui, "2", ui::grow(2), high);
        tile(ui, "1 more", ui::grow(), high);
    }
    {
        const Line line(ui, "fixed and grow");
        tile(ui, "8 em", ui::px(ui.em(8)), high);
        tile(ui, "the rest", ui::grow(), high);
        tile(ui, "4 em", ui::px(ui.em(4)), high);
    }
    {
        const Line line(ui, "fractions");
        tile(ui, "1/2", ui::fraction(0.5F), high);
        tile(ui, "1/4", ui::fraction(0.25F), high);
    }
    {
        const Line line(ui, "spacers");
        tile(ui, "left", ui::px(ui.em(5)), high);
        ui::spacer(ui);
        tile(ui, "middle", ui::px(ui.em(5)), high);
        ui::spacer(ui);
        tile(ui, "right", ui::px(ui.em(5)), high);
    }
}

/// A row high enough to see where things stand across it.
void places(ui::Ui& ui) {
    struct Example {
        std::string_view name;
        ui::ChildAlign cross;
    };
    constexpr Example examples[] = {{"start", ui::ChildAlign::start},
                                    {"centre", ui::ChildAlign::center},
                                    {"end", ui::ChildAlign::end},
                                    {"stretch", ui::ChildAlign::stretch}};
    const Part part(ui, "Across the row");
    const ui::Row row(ui, {.width = ui::grow(), .gap = 1});
    for (const Example& example : examples) {
        const ui::Column column(ui, {.width = ui::grow()});
        ui::label(ui, example.name, {.tone = ui::Tone::dim});
        const ui::Row inner(ui, {.width = ui::grow(), .height = ui::px(ui.em(4)), .cross = example.cross});
        for (const float height : {1.5F, 2.5F}) tile(ui, height < 2 ? "a" : "b", ui::grow(), ui::px(ui.em(height)));
        tile(ui, "c", ui::grow(), ui::fit());
    }
}

void rows_and_columns(ui::Ui& ui) {
    const Part part(ui, "Rows in columns in rows");
    const ui::Row row(ui, {.width = ui::grow(), .height = ui::px(ui.em(9)), .cross = ui::ChildAlign::stretch});
    tile(ui, "10 em", ui::px(ui.em(10)), ui::grow());
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow()});
    tile(ui, "upper third", ui::grow(), ui::grow());
    const ui::Row lower(ui, {.width = ui::grow(), .height = ui::grow(2), .cross = ui::ChildAlign::stretch});
    tile(ui, "lower left", ui::grow(), ui::grow());
    tile(ui, "lower right", ui::grow(), ui::grow());
}

}  // namespace

void layout_page(ui::Ui& ui, State&) {
    sizes(ui);
    places(ui);
    rows_and_columns(ui);
}

}  // namespace lapfx::gallery
