#include "panels/compared_regions.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "panels/parts.h"
#include "ui/canvas/plot.h"
#include "ui/core/node.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/table.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using app::ComparedRegions;
using app::RegionFigure;
using document::Content;

constexpr float figure_width = 9, list_width = 34, narrow = 60, swatch_width = 5;  // em
constexpr float list_height = 11, plot_height = 11;                                // em, in a narrow panel

std::string_view formatted(ui::Ui& ui, const char* format, double a, double b = 0) {
    char text[64];
    std::snprintf(text, sizeof text, format, a, b);
    return ui.copy(text);
}

void add_region(const Edited& edited, app::ScopesLook& look) {
    look.region = edited.document.scene().reference.regions.size();
    edited.document.change("Add region", [](Content& c) {
        auto& all = c.scene.reference.regions;
        // Each new one a little further, so that none hides another.
        const double shift = 0.13 * static_cast<double>(all.size() % 4);
        all.push_back({.x = 0.2 + shift, .y = 0.2 + shift, .width = 0.15, .height = 0.15});
    });
}

void remove_region(const Edited& edited, app::ScopesLook& look) {
    edited.document.change("Remove region", [at = look.region](Content& c) {
        auto& all = c.scene.reference.regions;
        if (at < all.size()) all.erase(all.begin() + static_cast<std::ptrdiff_t>(at));
    });
    if (look.region > 0) --look.region;
}

// --- figures ---------------------------------------------------------------------------------------------------------

struct Figures {
    const ComparedRegions& regions;
    bool alone;  ///< only the second picture is there
};

/// "12.1 / 14.0", or that of the second alone.
std::string_view pair_text(ui::Ui& ui, const Figures& of, std::size_t region, RegionFigure figure) {
    const auto value = [&](std::size_t side) { return app::figure_of(of.regions.now(side, region), figure); };
    if (!of.regions.counted(1)) return "-";
    if (of.alone || !of.regions.counted(0)) return formatted(ui, "%.1f", value(1));
    return formatted(ui, "%.1f / %.1f", value(0), value(1));
}

std::string_view cell_text(ui::Ui& ui, const Figures& of, std::size_t region, std::size_t column) {
    if (column == 0) return ui.join({"Region ", ui.copy(std::to_string(region + 1))});
    const auto figure = static_cast<RegionFigure>(column - 1);
    if (figure != RegionFigure::distance) return pair_text(ui, of, region, figure);
    if (of.alone || !of.regions.counted(0) || !of.regions.counted(1)) return "-";
    return formatted(ui, "%.1f", match::distance(of.regions.now(0, region), of.regions.now(1, region)));
}

void list(ui::Ui& ui, app::ScopesLook& look, const Figures& of, std::size_t count) {
    struct State {
        ui::TableState table;
    };
    State& state = ui.memory<State>(ui.id_of("regions"));
    if (!state.table.selection.has(look.region)) state.table.selection.only(look.region);
    std::array<ui::TableColumn, 1 + app::region_figures.size()> columns;
    columns[0] = {"Region", 6, ui::Align::start, false, "Drag its handles over the pictures."};
    for (std::size_t i = 0; i < app::region_figures.size(); ++i) {
        const app::RegionFigureRow& row = app::region_figures[i];
        columns[i + 1] = {row.title, i + 1 == app::region_figures.size() ? 5.0F : 7.5F, ui::Align::end, false,
                          ui.join({row.help, row.unit.empty() ? "." : ". First / second picture, %."})};
    }
    ui::table(ui, "Regions", state.table, columns, count, [&](std::size_t row, std::size_t column) {
        return ui::TableCell{.text = cell_text(ui, of, row, column), .number = column > 0};
    });
    if (state.table.selection.keys.size() == 1) look.region = static_cast<std::size_t>(state.table.selection.keys[0]);
}

void draw_color(ui::Painter& painter, const ui::Node& node, const ui::Color& color) {
    ui::draw_swatch(painter, node.rect(), color);
}

void mean_colors(ui::Ui& ui, const app::ScopesLook& look, const Figures& of,
                 const std::array<std::string_view, 2>& names) {
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    for (std::size_t side = of.alone ? 1 : 0; side < names.size(); ++side) {
        if (!of.regions.counted(side)) continue;
        const glm::dvec3 mean = glm::round(255.0 * of.regions.now(side, look.region).color);
        const ui::Color color{static_cast<std::uint8_t>(mean.r), static_cast<std::uint8_t>(mean.g),
                              static_cast<std::uint8_t>(mean.b), 255};
        char hex[9];
        ui::label(ui, names[side], {.tone = ui::Tone::dim});
        ui.push_seed(names[side]);
        ui::Node& swatch = ui.leaf(ui::Role::color, "Mean colour", ui::Sense::hover);
        swatch.size[0] = ui::px(ui.em(swatch_width)), swatch.size[1] = ui::px(ui.em(1.2F));
        swatch.text = ui.copy(ui::format_hex(hex, color, false));
        swatch.tip = ui.join({"Mean colour of the region, taken in linear light: ", swatch.text});
        ui.draw_with<draw_color>(swatch, color);
        ui.pop_seed();
    }
}

// --- curves ----------------------------------------------------------------------------------------------------------

struct Curves {
    std::uint64_t version = 0;
    std::size_t region = 0;
    RegionFigure figure = RegionFigure::veil;
    std::array<std::vector<double>, 2> frames, values;
    std::array<ui::PlotData, 2> data;
};

void take_curves(Curves& curves, const app::Reference& reference, const app::ScopesLook& look) {
    const ComparedRegions& regions = reference.comparison().regions();
    if (curves.version == regions.version() + 1 && curves.region == look.region && curves.figure == look.figure) return;
    curves.version = regions.version() + 1, curves.region = look.region, curves.figure = look.figure;
    const VideoReader* const video = reference.video();
    for (std::size_t side = 0; side < 2; ++side) {
        std::vector<double>&frames = curves.frames[side], &values = curves.values[side];
        regions.curve(side, look.region, look.figure, frames, values);
        // Another video may have come since they were counted.
        const int count = video != nullptr ? video->info().frames : 0;
        while (!frames.empty() && frames.back() >= count) frames.pop_back(), values.pop_back();
        for (double& frame : frames) frame = video->time_of(static_cast<int>(frame));
        curves.data[side].set(curves.values[side], curves.frames[side]);
    }
}

void plot(ui::Ui& ui, app::Reference& reference, const app::ScopesLook& look, const Figures& of,
          const std::array<std::string_view, 2>& names, ui::Size height) {
    Curves& curves = ui.memory<Curves>(ui.id_of("region curves"));
    take_curves(curves, reference, look);
    const app::RegionFigureRow& row = app::region_figures[static_cast<std::size_t>(look.figure)];
    const bool distance = look.figure == RegionFigure::distance;
    const std::array<ui::PlotSeries, 2> series = {
        {{.name = distance ? row.title : names[0], .data = &curves.data[0], .color = 0},
         {.name = names[1], .data = &curves.data[1], .color = 4}}};
    const auto shown = distance ? std::span(series).first(1) : of.alone ? std::span(series).last(1) : std::span(series);
    ui::plot(
        ui, "Over time", shown,
        {.x_name = "Reference",
         .x_unit = "s",
         .y_name = ui.join({"Region ", ui.copy(std::to_string(look.region + 1)), ", ", row.title}),
         .y_unit = row.unit,
         .width = ui::grow(),
         .height = height,
         .tip = "Fills while the timeline plays: what the pictures showed at each time, as long as it would be the "
                "same now. Ctrl+C copies it as CSV",
         .mark = reference.time()});
}

}  // namespace

void region_tools(ui::Ui& ui, app::ScopesLook& look, const Edited& edited, float room) {
    const std::size_t count = edited.document.scene().reference.regions.size();
    const std::array<ui::ToolItem, 3> items = {
        {{.width = count < most_compared_regions ? ui::tool_width(ui, "Add region") : 0},
         {.width = count > 0 ? ui::tool_width(ui, "Remove") : 0, .rank = 1},
         {.width = count > 0 ? ui.em(figure_width) : 0, .rank = 1}}};
    ui::toolbar(ui, "Region tools", room, items, [&](std::size_t item) {
        if (item == 0 && ui::button(ui, "Add region", {.tip = "A rectangle that is compared in both pictures"}))
            add_region(edited, look);
        if (item == 1 && ui::button(ui, "Remove", {.tip = "Removes the region that is plotted"}))
            remove_region(edited, look);
        if (item != 2) return;
        std::array<std::string_view, app::region_figures.size()> titles;
        for (std::size_t i = 0; i < titles.size(); ++i) titles[i] = app::region_figures[i].title;
        int figure = static_cast<int>(look.figure);
        if (ui::combo(ui, "Plotted", figure, titles,
                      {.tip = app::region_figures[static_cast<std::size_t>(look.figure)].help,
                       .width = ui::px(ui.em(figure_width))}))
            look.figure = static_cast<RegionFigure>(figure);
    });
}

void region_figures(ui::Ui& ui, app::Reference& reference, const Edited& edited,
                    const std::array<std::string_view, 2>& names, float room) {
    app::ReferenceComparison& comparison = reference.comparison();
    app::ScopesLook& look = comparison.scopes_look;
    const std::size_t count = std::min(edited.document.scene().reference.regions.size(), most_compared_regions);
    if (count == 0)
        return ui::label(ui, "No region yet. Add one, and drag it over what shows the same tissue in both pictures.",
                         {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
    look.region = std::min(look.region, count - 1);
    const Figures of{comparison.regions(), comparison.way == app::CompareWay::reference};
    const bool small = room > 0 && room < ui.em(narrow);
    const auto lists = [&](ui::Size width, ui::Size height) {
        const ui::Column column(ui, {.width = width, .height = height, .gap = 0.3F});
        list(ui, look, of, count);
        mean_colors(ui, look, of, names);
    };
    if (small) {
        const ui::ScrollArea area(ui, "Region figures", {.gap = 0.3F});
        lists(ui::grow(), ui::px(ui.em(list_height)));
        return plot(ui, reference, look, of, names, ui::px(ui.em(plot_height)));
    }
    const ui::Row row(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.6F, .cross = ui::ChildAlign::stretch});
    lists(ui::px(ui.em(list_width + 8)), ui::grow());
    plot(ui, reference, look, of, names, ui::grow());
}

}  // namespace lapfx::panels
