#include "panels/measure_results.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>

#include "app/measure/measure_bench.h"
#include "app/measure/measured_curve.h"
#include "app/measure/measuring.h"
#include "app/reference/reference.h"
#include "panels/parts.h"
#include "ui/canvas/plot.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

namespace {

using match::FrameAmounts;
namespace told = match::told;

constexpr float name_width = 6.5F, figure_width = 5.5F;  // em

template <typename... Values>
std::string_view formatted(ui::Ui& ui, const char* form, Values... values) {
    char text[96];
    std::snprintf(text, sizeof text, form, values...);
    return ui.copy(text);
}

/// A line of three columns.
void line(ui::Ui& ui, std::string_view name, std::string_view first, std::string_view second, std::string_view tip,
          bool dim = false) {
    const ui::Tone tone = dim ? ui::Tone::dim : ui::Tone::normal;
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::label(ui, name, {.tone = ui::Tone::dim, .width = ui::px(ui.em(name_width))});
    if (!tip.empty()) ui.last().tip = tip;
    ui::label(ui, first, {.tone = tone, .number = true, .width = ui::px(ui.em(figure_width))});
    ui::label(ui, second, {.tone = tone, .number = true, .width = ui::grow()});
}

void wrapped(ui::Ui& ui, std::string_view text, ui::Tone tone) {
    ui::label(ui, text, {.tone = tone, .wrap = true, .width = ui::grow()});
}

void amount_line(ui::Ui& ui, std::string_view name, const match::Amount& amount, std::string_view tip) {
    line(ui, name, formatted(ui, "%.1f %%", 100 * amount.value),
         formatted(ui, "%.1f to %.1f %%", 100 * amount.low, 100 * amount.high), tip);
}

// --- the whole reference ---------------------------------------------------------------------------------------------

std::string_view seconds(ui::Ui& ui, const std::optional<double>& time) {
    return time ? formatted(ui, "%.2f s", *time) : "-";
}

std::string_view percent(ui::Ui& ui, const std::optional<double>& share) {
    return share ? formatted(ui, "%.1f %%", 100 * *share) : "-";
}

void episodes(ui::Ui& ui, const match::Episode& blood, const match::Episode& veil) {
    line(ui, "", "Blood", "Veil", "", true);
    line(ui, "Peak", percent(ui, blood.peak), percent(ui, veil.peak), "The largest amount, smoothed over 0.2 s");
    line(ui, "Peak at", seconds(ui, blood.peak_at), seconds(ui, veil.peak_at),
         "Nothing where the amount stays within its own uncertainty");
    line(ui, "Onset", seconds(ui, blood.onset), seconds(ui, veil.onset),
         "When a tenth of the way from the least to the largest amount is passed for the last time before the peak");
    line(ui, "Rise", seconds(ui, blood.rise), seconds(ui, veil.rise), "From a tenth to nine tenths of that way");
    line(ui, "Decay", seconds(ui, blood.decay), seconds(ui, veil.decay),
         "From the peak until half of that way is left");
    line(ui, "Mean", percent(ui, blood.mean), percent(ui, veil.mean),
         "Over the time that can be measured; nothing where most of it cannot");
    line(ui, "Area", seconds(ui, blood.area), seconds(ui, veil.area), "Area under the curve: shares times seconds");
}

// --- curves ----------------------------------------------------------------------------------------------------------

/// The curves of the plot, in the order of its legend, where a click shows and hides them.
struct ShownCurve {
    const char* name;
    app::FrameCurve curve;
    int color;  ///< of the theme's series
    bool at_first;
};
constexpr std::array shown_curves = {ShownCurve{"Blood", app::blood_curve, app::blood_series, true},
                                     ShownCurve{"Veil", app::veil_curve, app::smoke_series, true},
                                     ShownCurve{"Light", app::light_curve, 2, false},
                                     ShownCurve{"Gain", app::gain_curve, 3, false}};

ui::PlotState seen_at_first() {
    ui::PlotState state;
    for (std::size_t i = 0; i < shown_curves.size(); ++i)
        if (!shown_curves[i].at_first) state.hidden |= std::uint64_t{1} << i;
    return state;
}

struct Curves {
    std::uint64_t version = 0, serial = 0;
    std::array<app::MeasuredCurve, shown_curves.size()> all;
    ui::PlotState state = seen_at_first();
};

void take_curves(Curves& curves, const app::Measuring& measuring) {
    if (curves.version == measuring.version()) return;
    curves.version = measuring.version();
    for (std::size_t i = 0; i < shown_curves.size(); ++i) curves.all[i].set(measuring.frames(), shown_curves[i].curve);
    if (std::exchange(curves.serial, measuring.serial()) == measuring.serial()) return;
    curves.state = {.hidden = curves.state.hidden};  // what is looked at stays, where it lies is another
}

/// Shows that time of the reference: with the scene where it is part of it, else held.
void go_to(const MeasureParts& on, double time) {
    const double at = time - on.edited.document.scene().reference.offset;
    if (at < 0 || at > on.timeline.duration()) return on.reference.hold(on.reference.video()->frame_at(time));
    on.reference.let_go();
    on.timeline.seek(at);
}

}  // namespace

std::string_view not_measurable_text(const FrameAmounts& amounts) {
    for (const match::ToldRow& row : match::told_rows)
        if ((amounts.flags & row.bit & told::unmeasured) != 0) return row.help;
    return {};
}

void frame_figures(ui::Ui& ui, const app::MeasureBench& bench) {
    if (!bench.ready()) return ui::label(ui, "-", {.tone = ui::Tone::dim});
    const FrameAmounts& found = bench.amounts();
    if (found.measurable()) {
        const std::string_view tip =
            "Share of the valid view that is blood, and where the true one is in nine of ten frames of our own "
            "renders; of real video it is not known";
        if (found.blood_measurable())
            amount_line(ui, "Blood", found.blood, tip);
        else
            line(ui, "Blood", "-", "", tip);
        amount_line(ui, "Veil", found.veil,
                    "Mean density of the smoke in the valid view, and where the true one is in nine of ten frames of "
                    "our own renders; of real video it is not known");
    } else {
        wrapped(ui, ui.join({"Here: ", not_measurable_text(found), "."}), ui::Tone::warning);
    }
    line(ui, "Valid view", formatted(ui, "%.0f %%", 100 * found.valid), "",
         "Share of the picture that is measured: without the black surround, instruments and what is left out");
    line(ui, "Likeness", formatted(ui, "%.2f", found.likeness), "",
         "How well the baseline explains this frame: 0 not at all, 1 fully");
    for (const match::ToldRow& row : match::told_rows)
        if ((found.flags & row.bit & ~told::unmeasured) != 0)
            wrapped(ui, ui.join({"Here: ", row.help, "."}), ui::Tone::warning);
}

void whole_figures(ui::Ui& ui, const MeasureParts& on) {
    const app::Measuring& measuring = on.measuring;
    for (const Fault& fault : measuring.faults()) wrapped(ui, ui.copy(fault.text()), ui::Tone::error);
    const match::Measurement* const found = measuring.found();
    if (found == nullptr) {
        if (measuring.faults().empty())
            wrapped(ui,
                    measuring.running() ? "Being measured."
                    : measuring.begun() ? "Measured in part: press Continue."
                                        : "Not measured yet: press Measure.",
                    ui::Tone::dim);
        return;
    }
    if (measuring.stale()) {
        const bool other = measuring.file() != on.reference.file();
        wrapped(ui,
                other                 ? ui.join({"Of ", measuring.file().filename().string(), ": measure again."})
                : measuring.running() ? "From before the last change; it is being measured again."
                                      : "From before the last change: measure again.",
                ui::Tone::warning);
    }
    episodes(ui, found->blood, found->veil);
    for (const std::string& note : found->notes) wrapped(ui, note, ui::Tone::warning);
    ui::command_button(ui, on.commands, "measure.take_marks");
    const ui::Row buttons(ui, {.width = ui::grow()});
    for (const char* id : {"measure.export_csv", "measure.export_json", "measure.export_png"})
        ui::command_button(ui, on.commands, id);
}

void amounts_plot(ui::Ui& ui, const MeasureParts& on, ui::Size height) {
    Curves& curves = ui.memory<Curves>(ui.id_of("measured curves"));
    take_curves(curves, on.measuring);
    std::array<ui::PlotSeries, shown_curves.size()> series;
    for (std::size_t i = 0; i < series.size(); ++i)
        series[i] = curves.all[i].series(shown_curves[i].name, shown_curves[i].color);
    const ui::PlotResult result = ui::plot(
        ui, "Amounts", series,
        {.x_name = "Reference",
         .x_unit = "s",
         .y_name = on.measuring.begun()   ? "Measured so far"
                   : on.measuring.stale() ? "From before the last change"
                                          : "Amount",
         .y_unit = "%",
         .width = ui::grow(),
         .height = height,
         .tip = "Amounts with their intervals; nothing where it cannot be measured. A click on a name shows or "
                "hides its curve: Light is what smoke adds, of white, and Gain the camera's, 100 % as in the "
                "baseline. Click: go to that time. Ctrl+C copies the visible values as CSV",
         .state = &curves.state,
         .mark = on.reference.time()});
    if (result.clicked) go_to(on, result.x);
}

}  // namespace lapfx::panels
