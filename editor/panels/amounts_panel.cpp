// The amounts over the scene's time: what the preset gives, beside what it is compared with. A click goes to that time.
#include "app/measure/amounts.h"
#include "panels/panels.h"
#include "ui/canvas/plot.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/scroll.h"

namespace lapfx::panels {

namespace {

using app::amount_infos;

/// One plot, with the data that it draws made ready.
struct AmountPlot {
    ui::PlotState state;
    std::vector<ui::PlotData> data;  ///< of the scene, then of the others
};
struct AmountPlots {
    std::uint64_t version = 0;
    std::array<AmountPlot, amount_infos.size()> all;
};

void take_series(AmountPlots& plots, const app::AmountsOverTime& amounts) {
    if (plots.version == amounts.version()) return;
    plots.version = amounts.version();
    for (std::size_t kind = 0; kind < plots.all.size(); ++kind) {
        auto& data = plots.all[kind].data;
        data.resize(1 + amounts.others().size());
        if (const app::AmountSeries* scene = amounts.scene()) data[0].set(scene->values[kind], scene->times);
        for (std::size_t i = 0; i < amounts.others().size(); ++i)
            data[i + 1].set(amounts.others()[i].values[kind], amounts.others()[i].times);
    }
}

/// "812", with the series' name where there are several.
std::string_view legend_text(ui::Ui& ui, std::string_view name, const ui::PlotData& data, const app::AmountInfo& info,
                             double time, bool named) {
    const double last = data.size() > 0 ? data.x(data.size() - 1) : 0;
    const double value = data.value_at(std::min(time, last));
    ui::ShortText text;
    if (named) text.add(name).add(" ");
    if (std::isfinite(value))
        text.add(value, info.decimals);
    else
        text.add("-");
    return ui.join({text.view(), "###", name});
}

void one_plot(ui::Ui& ui, const app::AmountsOverTime& amounts, app::Timeline& timeline, AmountPlots& plots,
              std::size_t kind) {
    const app::AmountInfo& info = amount_infos[kind];
    AmountPlot& plot = plots.all[kind];
    std::array<ui::PlotSeries, 9> series;
    const std::size_t count = std::min(plot.data.size(), series.size());
    for (std::size_t i = 0; i < count; ++i) {
        const std::string_view name = i == 0 ? "Scene" : std::string_view(amounts.others()[i - 1].name);
        series[i] = {.name = legend_text(ui, name, plot.data[i], info, timeline.time, count > 1),
                     .data = &plot.data[i],
                     .color = static_cast<int>((kind + 2 * i) % 8),
                     .reference = i > 0};
    }
    const ui::PlotResult result =
        ui::plot(ui, info.name, std::span(series).first(count),
                 {.x_name = {},
                  .x_unit = "s",
                  .y_name = info.name,
                  .y_unit = info.unit,
                  .width = ui::grow(),
                  .height = ui::grow(),
                  .tip = ui.join({info.help, " Click: go to that time. Ctrl+C copies the visible values as CSV."}),
                  .state = &plot.state,
                  .mark = timeline.time});
    if (result.clicked) timeline.seek(result.x);
    if (!result.moved) return;
    for (AmountPlot& other : plots.all) {  // all plots show the same part of time
        if (&other == &plot) continue;
        other.state.fitted = plot.state.fitted;
        other.state.x = plot.state.x;
    }
}

constexpr float least_width = 12, least_height = 6.2F;  // em of a plot; in a smaller panel they scroll

/// The number of columns that makes the plots largest; they are best twice as wide as high.
std::size_t columns_for(const ui::Ui& ui, const ui::Rect& room) {
    std::size_t best = 1;
    float largest = -1;
    for (const std::size_t columns : {1U, 2U, 4U}) {
        const auto across = static_cast<float>(columns),
                   down = std::ceil(static_cast<float>(amount_infos.size()) / across);
        if (columns > 1 && room.w / across < ui.em(least_width)) break;
        const float size = std::min(room.w / across / 2, room.h / down);
        if (size > largest) largest = size, best = columns;
    }
    return best;
}

void nothing_known(ui::Ui& ui, app::AmountsOverTime& amounts) {
    const ui::ScrollArea area(ui, "Nothing known");
    if (!amounts.faults().empty())
        return ui::label(ui, amounts.faults().front().text(),
                         {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    if (!amounts.has_organ())
        return ui::label(ui, "No organ yet: open a mesh or a scene, and its blood and smoke are plotted here.",
                         {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
    if (!amounts.stopped())
        return ui::label(ui, "The amounts of this scene are being computed.", {.tone = ui::Tone::dim});
    ui::label(ui, "Computing the amounts of this scene was stopped.", {.tone = ui::Tone::dim});
    const ui::Row row(ui);
    if (ui::button(ui, "Compute again", {.tip = "Starts again; any change of the scene also does"})) amounts.again();
}

/// This line is always there, so that the plots do not move.
void how_new(ui::Ui& ui, const app::AmountsOverTime& amounts, float line) {
    const ui::Row row(ui, {.width = ui::grow(), .height = ui::px(line), .cross = ui::ChildAlign::center});
    const bool old = amounts.stale() && amounts.busy();
    ui::label(ui,
              old ? "From before the last change; the new amounts are being computed." : "Of the scene as it is now",
              {.tone = old ? ui::Tone::warning : ui::Tone::dim, .width = ui::grow()});
}

void all_plots(ui::Ui& ui, const app::AmountsOverTime& amounts, app::Timeline& timeline, ui::Id id) {
    constexpr float gap = 0.4F;
    const float line = std::ceil(ui.em(1.5F)), part = std::ceil(ui.em(gap));
    how_new(ui, amounts, line);
    auto& plots = ui.memory<AmountPlots>(id);
    take_series(plots, amounts);
    ui::Rect before = ui.rect_before(id);
    before.cut_top(line + part);
    const std::size_t columns = columns_for(ui, before), lines = (plots.all.size() + columns - 1) / columns;
    const auto parted = static_cast<float>(lines);
    const float height = std::floor((before.h - (parted - 1) * part) / parted);
    const ui::ScrollArea area(ui, "All plots", {.gap = gap});
    for (std::size_t first = 0; first < plots.all.size(); first += columns) {
        const ui::Row row(ui,
                          {.width = ui::grow(), .height = ui::px(std::max(height, ui.em(least_height))), .gap = gap});
        for (std::size_t i = first; i < std::min(first + columns, plots.all.size()); ++i)
            one_plot(ui, amounts, timeline, plots, i);
    }
}

}  // namespace

void amounts_panel(ui::Ui& ui, app::AmountsOverTime& amounts, app::Timeline& timeline) {
    amounts.want();
    if (amounts.wants_frame()) ui.wake_at(std::isfinite(amounts.due()) ? amounts.due() : ui.time(), "amounts");
    ui::Node& room = ui.open(ui::Role::group, "Plots", ui::Axis::y);
    const ui::Id id = room.id;
    room.size[0] = room.size[1] = ui::grow();
    room.gap = ui.em(0.4F);
    ui.follow_size(room);
    if (amounts.scene() == nullptr) {
        nothing_known(ui, amounts);
        return ui.close();
    }
    all_plots(ui, amounts, timeline, id);
    ui.close();
}

}  // namespace lapfx::panels
