// The amounts over the scene's time: what the view shows, measured as the reference is and laid over it, and what the
// organ has by the core's own count. A click goes to that time.
#include "app/measure/amounts.h"

#include "app/measure/measuring.h"
#include "app/measure/preview_measuring.h"
#include "panels/measured_amounts.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "ui/canvas/plot.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using app::plotted_amounts;

/// One plot, with the data that it draws made ready.
struct AmountPlot {
    ui::PlotState state;
    ui::PlotData data;
};
struct AmountPlots {
    std::uint64_t version = 0;
    std::array<AmountPlot, plotted_amounts.size()> all;
};

void take_series(AmountPlots& plots, const app::AmountsOverTime& amounts) {
    if (plots.version == amounts.version()) return;
    plots.version = amounts.version();
    const app::AmountSeries* const scene = amounts.scene();
    for (std::size_t kind = 0; scene != nullptr && kind < plots.all.size(); ++kind)
        plots.all[kind].data.set(scene->values[kind], scene->times);
}

/// "812".
std::string_view legend_text(ui::Ui& ui, const ui::PlotData& data, int decimals, double time) {
    const double last = data.size() > 0 ? data.x(data.size() - 1) : 0;
    const double value = data.value_at(std::min(time, last));
    ui::ShortText text;
    if (std::isfinite(value))
        text.add(value, decimals);
    else
        text.add("-");
    return ui.join({text.view(), "###Scene"});
}

void one_plot(ui::Ui& ui, app::Timeline& timeline, AmountPlots& plots, std::size_t kind) {
    const AmountRow& row = plotted_amounts[kind].row();
    AmountPlot& plot = plots.all[kind];
    const ui::PlotSeries series = {.name = legend_text(ui, plot.data, plotted_amounts[kind].decimals, timeline.time),
                                   .data = &plot.data,
                                   .color = static_cast<int>(kind % 8)};
    const ui::PlotResult result =
        ui::plot(ui, row.title, {&series, 1},
                 {.x_name = {},
                  .x_unit = "s",
                  .y_name = row.title,
                  .y_unit = row.unit,
                  .width = ui::grow(),
                  .height = ui::grow(),
                  .tip = ui.join({row.help, " Click: go to that time. Ctrl+C copies the visible values as CSV."}),
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

constexpr float choice_width = 11;                      // em
constexpr float least_width = 12, least_height = 6.2F;  // em of a plot; in a smaller panel they scroll

/// The number of columns that makes the plots largest; they are best twice as wide as high.
std::size_t columns_for(const ui::Ui& ui, const ui::Rect& room) {
    std::size_t best = 1;
    float largest = -1;
    for (const std::size_t columns : {1U, 2U, 4U}) {
        const auto across = static_cast<float>(columns),
                   down = std::ceil(static_cast<float>(plotted_amounts.size()) / across);
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

constexpr std::string_view new_text = "Of the scene as it is now", old_text = "From before the last change";

void how_new(ui::Ui& ui, const app::AmountsOverTime& amounts) {
    const bool old = amounts.stale() && amounts.busy();
    ui::label(ui, old ? old_text : new_text, {.tone = old ? ui::Tone::warning : ui::Tone::dim});
}

/// `room`: px.
void all_plots(ui::Ui& ui, const app::AmountsOverTime& amounts, app::Timeline& timeline, const ui::Rect& room) {
    constexpr float gap = 0.4F;
    auto& plots = ui.memory<AmountPlots>(ui.id_of("amount plots"));
    take_series(plots, amounts);
    const std::size_t columns = columns_for(ui, room), lines = (plots.all.size() + columns - 1) / columns;
    const auto parted = static_cast<float>(lines);
    const float height = std::floor((room.h - (parted - 1) * std::ceil(ui.em(gap))) / parted);
    const ui::ScrollArea area(ui, "All plots", {.gap = gap});
    for (std::size_t first = 0; first < plots.all.size(); first += columns) {
        const ui::Row row(ui,
                          {.width = ui::grow(), .height = ui::px(std::max(height, ui.em(least_height))), .gap = gap});
        for (std::size_t i = first; i < std::min(first + columns, plots.all.size()); ++i)
            one_plot(ui, timeline, plots, i);
    }
}

/// `room`: of the panel.
void tools(ui::Ui& ui, const AmountsParts& on, const ui::Rect& room) {
    static constexpr std::array<std::string_view, 2> names = {"In view", "On organ"};
    const bool in_view = on.amounts.look.of == app::AmountsLook::in_view;
    std::array<ui::ToolItem, 2 + measured_tools> items;
    items[0] = {.width = ui.em(choice_width)};
    for (std::size_t i = 0; i < measured_tools; ++i)
        items[1 + i] = {.width = in_view ? measured_tool_width(ui, on, i) : 0, .rank = i + 1 == measured_tools ? 2 : 1};
    items.back() = {.width = in_view || on.amounts.scene() == nullptr
                                 ? 0
                                 : std::max(ui.text_width(new_text), ui.text_width(old_text)),
                    .rank = 3};
    ui::toolbar(ui, "Amounts tools", room.w, items, [&](std::size_t item) {
        if (item + 1 == items.size()) return how_new(ui, on.amounts);
        if (item > 0) return measured_tool(ui, on, item - 1);
        const Room held(ui, choice_width);
        ui::segmented(ui, "Amounts", on.amounts.look.of, names);
        ui.last().tip =
            "In view: the share of the picture, of preview and reference measured alike. On organ: what the "
            "core counts of the preview";
    });
    if (in_view) measured_state(ui, on, room.h);
}

/// Whatever works beside the panel wakes it when there is something to show; this is for the rest.
template <typename Amounts>
void wake_for(ui::Ui& ui, const Amounts& amounts, const char* reason) {
    if (amounts.wants_frame()) ui.wake_at(std::isfinite(amounts.due()) ? amounts.due() : ui.time(), reason);
}

}  // namespace

void amounts_panel(ui::Ui& ui, const AmountsParts& on) {
    const bool in_view = on.amounts.look.of == app::AmountsLook::in_view;
    if (in_view) {
        on.preview.want();
        on.measuring.want();
        if (on.measuring.due() < ui::never) ui.wake_at(on.measuring.due(), "the reference is being measured");
        wake_for(ui, on.preview, "the preview's measured amounts");
    } else {
        on.amounts.want();
        wake_for(ui, on.amounts, "amounts");
    }
    ui::Node& node = ui.open(ui::Role::group, "Plots", ui::Axis::y);
    node.size[0] = node.size[1] = ui::grow();
    node.gap = ui.em(0.2F);
    ui.follow_size(node);
    tools(ui, on, ui.rect_before(node.id));
    ui::Node& below = ui.open(ui::Role::group, "Curves", ui::Axis::y);
    below.size[0] = below.size[1] = ui::grow();
    below.gap = ui.em(0.4F);
    ui.follow_size(below);
    const ui::Rect room = ui.rect_before(below.id);
    if (in_view)
        measured_plots(ui, on, {room.w, room.h});
    else if (on.amounts.scene() == nullptr)
        nothing_known(ui, on.amounts);
    else
        all_plots(ui, on.amounts, on.timeline, room);
    ui.close();
    ui.close();
}

}  // namespace lapfx::panels
