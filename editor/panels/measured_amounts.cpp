#include "panels/measured_amounts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/base/jobs.h"
#include "app/measure/fitting.h"
#include "app/measure/measure_bench.h"
#include "app/measure/measured_curve.h"
#include "app/measure/measuring.h"
#include "app/measure/preview_measuring.h"
#include "app/preview/timeline.h"
#include "app/reference/reference.h"
#include "panels/measured_words.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using app::PreviewMeasuring;

constexpr int reference_series = 1, fit_series = 3;   // colours of the theme's series
constexpr float high_enough_for_colors = 16;          // em of the panel
constexpr float least_width = 14, least_height = 10;  // em of a plot; in a smaller panel they scroll
constexpr float narrow_plot = 26;                     // em: below, the names of its curves are short

/// One amount: of the reference, of the preview as measured, as it is in truth, and as a fit has found it.
struct MeasuredPlot {
    ui::PlotState state;
    app::MeasuredCurve reference, preview, fit;
    std::vector<double> times, truth;
    ui::PlotData true_data;
};
struct MeasuredPlots {
    std::uint64_t of_reference = 0, of_preview = 0, of_fit = 0;
    double offset = 0, duration = -1;
    bool truth = false;
    MeasuredPlot blood, veil;
};

void take(MeasuredPlots& plots, const AmountsParts& on) {
    const double offset = on.document.scene().reference.offset, duration = on.timeline.duration();
    const bool moved = std::exchange(plots.offset, offset) != offset;
    const bool other = std::exchange(plots.duration, duration) != duration;
    const ui::Span scene{0, duration};
    if (std::exchange(plots.of_reference, on.measuring.version() + 1) != on.measuring.version() + 1 || moved || other) {
        plots.blood.reference.set(on.measuring.frames(), app::blood_curve, -offset, scene);
        plots.veil.reference.set(on.measuring.frames(), app::veil_curve, -offset, scene);
    }
    if (std::exchange(plots.of_fit, on.fitting.version()) != on.fitting.version() || other) {
        plots.blood.fit.set(on.fitting.frames(), app::blood_curve, 0, scene);
        plots.veil.fit.set(on.fitting.frames(), app::veil_curve, 0, scene);
    }
    const bool truth = std::exchange(plots.truth, on.preview.truth) != on.preview.truth;
    if (std::exchange(plots.of_preview, on.preview.version()) == on.preview.version() && !other && !truth) return;
    plots.blood.preview.set(on.preview.frames(), app::blood_curve, 0, scene);
    plots.veil.preview.set(on.preview.frames(), app::veil_curve, 0, scene);
    for (MeasuredPlot* const plot : {&plots.blood, &plots.veil}) {
        plot->times.clear(), plot->truth.clear();
        for (const app::TrueAmounts& amounts : on.preview.truths()) {
            if (!on.preview.truth) break;  // known, and not wanted now
            plot->times.push_back(amounts.time);
            plot->truth.push_back(100 * (plot == &plots.blood ? amounts.blood : amounts.veil));
        }
        plot->true_data.set(plot->truth, plot->times);
    }
}

/// "Preview 3.2", at the scene's time; the name alone without a value.
std::string_view legend(ui::Ui& ui, std::string_view name, const ui::PlotData& data, double time, bool with_value) {
    ui::ShortText text;
    text.add(name);
    if (!with_value) return ui.join({text.view(), "###", name});
    text.add(" ");
    const double value = data.size() > 0 ? data.value_at(time) : std::nan("");
    if (std::isfinite(value))
        text.add(std::abs(value) < 0.05 ? 0.0 : value, 1);  // never "1.2e-27"
    else
        text.add("-");
    return ui.join({text.view(), "###", name});
}

void one_plot(ui::Ui& ui, const AmountsParts& on, MeasuredPlots& plots, std::string_view name, MeasuredPlot& plot,
              int color, bool narrow) {
    std::array<ui::PlotSeries, 4> series;
    std::size_t count = 0;
    const std::array<std::size_t, 4> sizes = {plot.reference.values().size(), plot.preview.values().size(),
                                              plot.fit.values().size(), plot.true_data.size()};
    // Three names with values would leave no room for the plot's own.
    const bool with_values = !narrow || std::ranges::count(sizes, std::size_t{0}) >= 2;
    const auto add = [&](const char* title, const app::MeasuredCurve& curve, int of) {
        if (curve.values().size() == 0) return;
        series[count++] = curve.series(legend(ui, title, curve.values(), on.timeline.time, with_values), of);
    };
    add(narrow ? "Ref" : "Reference", plot.reference, reference_series);
    add(narrow ? "Pre" : "Preview", plot.preview, color);
    add("Fit", plot.fit, fit_series);
    if (plot.true_data.size() > 0)
        series[count++] = {.name = legend(ui, narrow ? "True" : "Truth", plot.true_data, on.timeline.time, with_values),
                           .data = &plot.true_data,
                           .color = color,
                           .reference = true};
    const ui::PlotResult result = ui::plot(
        ui, name, std::span(series).first(count),
        {.x_name = {},
         .x_unit = "s",
         .y_name = name,
         .y_unit = "%",
         .width = ui::grow(),
         .height = ui::grow(),
         .tip = "Share of the view, with the interval that holds nine of ten. Click: go to that time. Ctrl+C copies "
                "the visible values as CSV.",
         .state = &plot.state,
         .mark = on.timeline.time});
    if (result.clicked) on.timeline.seek(result.x);
    if (!result.moved) return;
    for (MeasuredPlot* const other : {&plots.blood, &plots.veil}) {  // both show the same part of time
        if (other == &plot) continue;
        other->state.fitted = plot.state.fitted;
        other->state.x = plot.state.x;
    }
}

/// "reference 43 %, preview 12 %".
std::string_view running_text(ui::Ui& ui, const AmountsParts& on) {
    const auto part = [](char(&text)[40], const char* name, double share) {
        std::snprintf(text, sizeof text, "%s %.0f %%", name, 100 * std::clamp(share, 0.0, 1.0));
    };
    char of_reference[40] = "", of_preview[40] = "";
    if (const auto& job = on.measuring.running()) part(of_reference, "reference", job->progress());
    if (on.preview.busy()) part(of_preview, "preview", on.preview.progress());
    const bool both = of_reference[0] != 0 && of_preview[0] != 0;
    return ui.join({"Measuring: ", ui.copy(of_reference), both ? ", " : "", ui.copy(of_preview)});
}

struct State {
    std::string_view text;
    ui::Tone tone = ui::Tone::dim;
};

State state_of(ui::Ui& ui, const AmountsParts& on) {
    if (!on.preview.faults().empty()) return {ui.copy(on.preview.faults().front().text()), ui::Tone::error};
    if (!on.measuring.faults().empty()) return {ui.copy(on.measuring.faults().front().text()), ui::Tone::error};
    const bool old_preview = on.preview.stale() && on.preview.complete();
    if (on.measuring.running() || on.preview.busy())
        return {running_text(ui, on), old_preview ? ui::Tone::warning : ui::Tone::dim};
    if (on.preview.stopped()) return {"Measuring the preview was stopped", ui::Tone::warning};
    if (on.measuring.begun()) return {"The reference is measured in part", ui::Tone::warning};
    if (on.measuring.stale()) return {"The reference's curve is from before the last change", ui::Tone::warning};
    if (old_preview) return {"The preview's curve is from before the last change", ui::Tone::warning};
    if (on.reference.video() == nullptr) return {"The preview alone: there is no reference"};
    if (on.measuring.found() == nullptr) return {"The reference is not measured yet"};
    return {"Both measured alike"};
}

void nothing_to_plot(ui::Ui& ui, const AmountsParts& on) {
    const bool organ = !on.document.scene().organ.file.empty();
    ui::label(
        ui,
        !organ && on.reference.video() == nullptr
            ? "Neither an organ nor a reference yet: open a scene or a surgery video, and how much blood and smoke "
              "it shows is plotted here."
        : on.preview.faults().empty() ? "The curves come as they are measured."
                                      : "There is nothing to plot.",
        {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
}

}  // namespace

float measured_tool_width(ui::Ui& ui, const AmountsParts& on, std::size_t tool) {
    const bool runs = on.measuring.running() || on.preview.busy();
    const bool old = on.measuring.begun() || on.measuring.found() == nullptr || on.measuring.stale();
    switch (tool) {
        case 0:
            return runs ? ui.row_height() : 0;
        case 1:
            return !runs && on.preview.stopped() ? ui::tool_width(ui, "Again") : 0;
        case 2:
            return !on.measuring.running() && on.reference.video() != nullptr && old ? ui::tool_width(ui, "Continue")
                                                                                     : 0;
        default:
            return ui::tool_width(ui, "Truth");
    }
}

void measured_tool(ui::Ui& ui, const AmountsParts& on, std::size_t tool) {
    if (tool == 0 && ui::icon_button(ui, ui::Icon::cross, "Stop measuring", {.quiet = true})) {
        on.measuring.cancel();
        if (on.preview.busy()) on.preview.stop();
    }
    if (tool == 1 && ui::button(ui, "Again", {.tip = "Measures the preview again; any change of the scene also does"}))
        on.preview.again();
    if (tool == 2 && ui::button(ui, on.measuring.begun() ? "Continue" : "Measure",
                                {.tip = "Measures blood and smoke in every frame of the reference"}))
        on.measuring.start();
    if (tool == 3)
        ui::toggle(ui, "Truth", on.preview.truth,
                   {.tip = "Adds what the preview's pictures hold exactly, as the core draws it: how far the measured "
                           "curve is off. Takes longer"});
}

void measured_state(ui::Ui& ui, const AmountsParts& on, float height) {
    if (measured_words(ui, on, height >= ui.em(high_enough_for_colors))) return;
    const State state = state_of(ui, on);
    ui::label(ui, state.text, {.tone = state.tone, .wrap = true, .number = true, .width = ui::grow()});
}

void measured_plots(ui::Ui& ui, const AmountsParts& on, glm::vec2 room) {
    MeasuredPlots& plots = ui.memory<MeasuredPlots>(ui.id_of("measured plots"));
    take(plots, on);
    if (plots.blood.reference.values().size() == 0 && plots.blood.preview.values().size() == 0)
        return nothing_to_plot(ui, on);
    const bool beside = room.x >= 2 * ui.em(least_width) && room.x > 1.2F * room.y;
    const float gap = std::ceil(ui.em(0.4F));
    const bool narrow = (beside ? room.x / 2 : room.x) < ui.em(narrow_plot);
    const float height = std::max(beside ? room.y : std::floor((room.y - gap) / 2), ui.em(least_height));
    const ui::ScrollArea area(ui, "Measured plots", {.gap = 0.4F});
    if (beside) {
        const ui::Row row(ui, {.width = ui::grow(), .height = ui::px(height), .gap = 0.4F});
        one_plot(ui, on, plots, "Blood", plots.blood, app::blood_series, narrow);
        one_plot(ui, on, plots, "Veil", plots.veil, app::smoke_series, narrow);
        return;
    }
    for (const bool blood : {true, false}) {
        const ui::Row row(ui, {.width = ui::grow(), .height = ui::px(height)});
        one_plot(ui, on, plots, blood ? "Blood" : "Veil", blood ? plots.blood : plots.veil,
                 blood ? app::blood_series : app::smoke_series, narrow);
    }
}

}  // namespace lapfx::panels
