// Measure: how much blood and smoke the reference shows, in the frame that is seen and over all of it; what that is
// compared with, what counts as blood, and what is left out.
#include "app/measure/measuring.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "app/base/layouts.h"
#include "app/editor.h"
#include "app/measure/measure_bench.h"
#include "app/preview/pick_color.h"
#include "app/reference/reference.h"
#include "panels/measure_results.h"
#include "panels/measure_shapes.h"
#include "panels/painted_strokes.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/table_rows.h"
#include "ui/core/node.h"
#include "ui/shell/progress.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/section.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using document::Content;
using ui::Icon;

constexpr float wide_panel = 50, low_panel = 26;  // em: below, all of it scrolls
constexpr float settings_width = 25, plot_share = 0.38F;
constexpr float least_picture = 12, least_plot = 9;    // em of height
constexpr float frame_width = 8, progress_width = 17;  // em

// --- above the picture -----------------------------------------------------------------------------------------------

void measure_or_cancel(ui::Ui& ui, const MeasureParts& on) {
    const std::shared_ptr<app::Job>& running = on.measuring.running();
    if (!running) {
        const bool begun = on.measuring.begun();
        if (ui::button(ui, begun ? "Continue" : "Measure",
                       {.tip = begun ? "Goes on measuring the reference from where it was stopped"
                                     : "Measures blood and smoke in every frame of the reference",
                        .primary = true}))
            on.measuring.start();
        return;
    }
    if (ui::progress(ui, "Measuring", running->progress(),
                     {.cancellable = true, .width = ui::px(ui.em(progress_width))}))
        on.measuring.cancel();
}

void frame_field(ui::Ui& ui, app::Reference& reference) {
    const double last = std::max(reference.video()->info().frames - 1, 0);
    double frame = reference.frame();
    if (ui::number_field(ui, "Frame", frame,
                         {.maximum = std::max(last, 1.0),
                          .hard_minimum = 0,
                          .hard_maximum = last,
                          .step = 1,
                          .tip = "Frame of the reference. A frame set here is held, whatever the timeline does",
                          .integer = true,
                          .width = ui::px(ui.em(frame_width))}))
        reference.hold(static_cast<int>(frame));
}

/// `room`: px.
void tools(ui::Ui& ui, const MeasureParts& on, float room) {
    app::MeasureLook& look = on.bench.look;
    enum : std::size_t { measure, before, frame, after, hold, blood, smoke, left_out, fit, count };
    std::array<ui::ToolItem, count> items;
    items[measure] = {.width = on.measuring.running() ? ui.em(progress_width) : ui::tool_width(ui, "Continue")};
    items[before] = items[after] = {.width = ui.row_height(), .rank = 1};
    items[frame] = {.width = ui.em(frame_width), .rank = 1};
    // While a frame is held, also by a brush, it is seen here as long as anything is, and let go.
    items[hold] = {.width = ui::tool_width(ui, "Hold", true), .rank = on.reference.held() ? 1 : 2};
    items[blood] = {.width = ui::tool_width(ui, "Blood"), .rank = 2};
    items[smoke] = {.width = ui::tool_width(ui, "Smoke"), .rank = 2};
    items[left_out] = {.width = ui::tool_width(ui, "Left out"), .rank = 2};
    items[fit] = {.width = look.state.fitted ? 0 : ui::tool_width(ui, "Fit"), .rank = 3, .end = true};
    ui::toolbar(ui, "Measure tools", room, items, [&](std::size_t item) {
        if (item == measure) measure_or_cancel(ui, on);
        if (item == before &&
            ui::icon_button(ui, Icon::step_back, "Frame before",
                            {.tip = "Goes back by a frame of the reference and holds it there", .quiet = true}))
            on.reference.step(-1);
        if (item == frame) frame_field(ui, on.reference);
        if (item == after &&
            ui::icon_button(ui, Icon::step_forward, "Frame after",
                            {.tip = "Moves the reference on by a frame and holds it there", .quiet = true}))
            on.reference.step(1);
        if (item == hold) hold_toggle(ui, on.reference);
        if (item == blood) ui::toggle(ui, "Blood", look.blood, {.tip = "Shows in yellow what counts as blood"});
        if (item == smoke) ui::toggle(ui, "Smoke", look.smoke, {.tip = "Shows in blue how dense the smoke is"});
        if (item == left_out)
            ui::toggle(ui, "Left out", look.left_out,
                       {.tip = "Hatches what is not measured, and shows the handles of its parts and of the region"});
        if (item == fit &&
            ui::button(ui, "Fit",
                       {.tip = "Shows the whole picture; 0 does the same, 1 shows it pixel by pixel", .quiet = true}))
            look.state = {};
    });
}

// --- the picture -----------------------------------------------------------------------------------------------------

void given_up(ui::Ui& ui, app::MeasureBench& bench) {
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::label(ui, "Measuring this frame was cancelled.", {.tone = ui::Tone::dim});
    if (!ui::button(ui, "Measure this frame", {.tip = "Measures blood and smoke in the frame that is shown"})) return;
    bench.measure_again();
    ui.build_again();
}

std::string_view tool_hint(app::MeasureTool tool) {
    switch (tool) {
        case app::MeasureTool::none:
            return {};
        case app::MeasureTool::pick_blood:
            return "Click blood in the picture. Esc leaves.";
        case app::MeasureTool::draw_part:
            return "Click the corners of the part; a double click or Enter closes it, Esc leaves.";
        case app::MeasureTool::paint_blood:
            return "Paint over blood; with Shift over what is no blood. Ctrl+Z takes a stroke back, Esc leaves.";
        case app::MeasureTool::paint_other:
            return "Paint over what is no blood; with Shift over blood. Ctrl+Z takes a stroke back, Esc leaves.";
    }
    return {};
}

/// One line above it: what to do, or what was found.
void caption(ui::Ui& ui, const MeasureParts& on) {
    app::MeasureBench& bench = on.bench;
    if (const std::string_view hint = tool_hint(bench.look.tool); !hint.empty())
        return ui::label(ui, hint, {.tone = ui::Tone::warning, .width = ui::grow()});
    if (bench.given_up()) return given_up(ui, bench);
    if (!bench.ready())
        return ui::label(ui, bench.faults().empty() ? "Measuring the frame..." : "This frame cannot be measured",
                         {.tone = ui::Tone::dim});
    const match::FrameAmounts& found = bench.amounts();
    if (!found.measurable())
        return ui::label(ui, ui.join({"This frame: ", not_measurable_text(found)}),
                         {.tone = ui::Tone::warning, .width = ui::grow()});
    char text[96];
    if (found.blood_measurable())
        std::snprintf(text, sizeof text, "%.2f s: blood %.1f %%, veil %.1f %%", found.time, 100 * found.blood.value,
                      100 * found.veil.value);
    else
        std::snprintf(text, sizeof text, "%.2f s: veil %.1f %%, too dense to see blood", found.time,
                      100 * found.veil.value);
    ui::label(ui, ui.copy(text), {.number = true});
}

void measured_picture(ui::Ui& ui, const MeasureParts& on) {
    app::MeasureBench& bench = on.bench;
    app::MeasureLook& look = bench.look;
    const bool picks = look.tool == app::MeasureTool::pick_blood;
    caption(ui, on);
    if (!bench.faults().empty()) {
        for (const Fault& fault : bench.faults())
            ui::label(ui, ui.copy(fault.text()), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
        ui::spacer(ui);
        return;
    }
    // Until the first frame is measured, it is shown as it is.
    const ui::Picture picture = bench.ready() ? bench.picture() : on.reference.shown().whole();
    MeasureShapes shapes{bench, on.edited};
    MeasureParts painted = on;
    const bool paints = look.paints();
    const ui::ImageViewResult result =
        ui::image_view(ui, "Measured", picture, look.state,
                       {.magnifier = picks,
                        .eyedropper = picks,
                        .sample_box = picks ? app::picked_side : 1,
                        .over = picks    ? nullptr
                                : paints ? paint_strokes
                                         : MeasureShapes::build,
                        .over_with = paints ? static_cast<void*>(&painted) : &shapes,
                        .tip = "Yellow: blood. Blue: smoke. Hatched: not measured. Wheel: zoom"});
    if (result.picked) {
        bench.pick_blood(result.pick);
        ui.build_again();
    }
}

// --- what it is compared with, and what counts -----------------------------------------------------------------------

/// Rows of `reference.measure`, with what is wrong below each.
class Settings {
  public:
    Settings(ui::Ui& ui, const MeasureParts& on)
        : ui_(ui), on_(on), faults_(ui.memory<Faults>(ui.id_of("measure faults"))) {
        const document::Document& document = on.edited.document;
        if (document.scene_changes_since(faults_.version) != 0) faults_.all = document.scene_faults();
        faults_.version = document.version();
    }

    void build() {
        if (const ui::Section section(ui_, "Baseline", {.unfold = wants({"baseline"})}); section) baseline();
        const bool wants_blood = wants_any("blood") || wants({"without_blood"});
        if (const ui::Section section(ui_, "Blood", {.unfold = wants_blood}); section) blood();
        if (const ui::Section section(ui_, "Left out", {.tip = app::measure_table().find("parts")->help}); section)
            parts();
        const bool wanted = wants({"from", "to"}) || wants_any("region");
        if (const ui::Section section(ui_, "Time and region", {.open = false, .unfold = wanted}); section)
            time_and_region();
    }

  private:
    struct Faults {
        std::uint64_t version = 0;
        std::vector<Fault> all;
    };
    const ReferenceMeasure& measure() const { return on_.edited.document.scene().reference.measure; }
    static const ReferenceMeasure& standard() {
        static const ReferenceMeasure standard;
        return standard;
    }
    /// Whether one of these rows is to come into sight.
    bool wants(std::initializer_list<std::string_view> keys) {
        return std::any_of(keys.begin(), keys.end(),
                           [&](std::string_view key) { return wanted_row(ui_) == app::measure_table().find_row(key); });
    }
    bool wants_any(std::string_view table) { return has_row(*app::measure_table().find(table), wanted_row(ui_)); }
    void row(const Table& table, std::string_view key, const OwnerOf& owner, TableRowOptions options) {
        table_row(ui_, on_.edited, *table.find_row(key), owner, options);
        const bool nested = &table != &app::measure_table();
        const std::string_view place =
            nested ? ui_.join({"/reference/measure/", table.key, "/", key}) : ui_.join({"/reference/measure/", key});
        for (const Fault& fault : faults_.all)
            if (fault.place == place)
                ui::label(ui_, fault.reason, {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    }
    void row(std::string_view key) {
        static const OwnerOf owner = [](Content& c) -> void* { return &c.scene.reference.measure; };
        const VideoReader* const video = on_.reference.video();
        row(app::measure_table(), key, owner,
            {.prefix = "Measure", .standard = &standard(), .maximum = video != nullptr ? video->info().duration : 0});
    }

    void baseline() {
        char text[96];
        if (on_.bench.ready()) {
            std::snprintf(text, sizeof text, "Compared with the frame at %.2f s%s.", on_.bench.baseline(),
                          measure().baseline > 0 ? "" : ", the earliest clear one");
            ui::label(ui_, ui_.copy(text), {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
        }
        row("baseline");
        const ui::Row buttons(ui_, {.width = ui::grow()});
        ui::command_button(ui_, on_.commands, "measure.use_frame");
        ui::command_button(ui_, on_.commands, "measure.suggest");
    }

    void blood() {
        static const OwnerOf owner = [](Content& c) -> void* { return &c.scene.reference.measure.blood; };
        {
            const ui::Row buttons(ui_, {.width = ui::grow()});
            for (const char* const command : {"measure.pick_blood", "measure.paint_blood", "measure.paint_other"})
                ui::command_button(ui_, on_.commands, command);
        }
        painted_strokes(ui_, on_);
        without_blood();
        if (!measure().strokes.empty()) ui::command_button(ui_, on_.commands, "measure.export_strokes");
        if (on_.bench.by_strokes())
            ui::label(ui_, "Blood is what looks as the strokes say: redness, rise and brightness do not count.",
                      {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
        const Table& table = *app::measure_table().find("blood");
        for (const Parameter& each : table.rows)
            row(table, each.key, owner, {.prefix = "Blood", .standard = &standard().blood});
    }

    /// Its time, or that there is none: the value that says so is no time.
    void without_blood() {
        const Parameter& parameter = *app::measure_table().find_row("without_blood");
        const bool named = measure().without_blood >= 0;
        if (named) row(parameter.key);
        const std::ptrdiff_t before = &ui_.last() - &ui_.parent();
        name_without_blood(named, parameter);
        if (wanted_row(ui_) != &parameter) return;
        wanted_row(ui_) = nullptr;
        go_to_row(ui_, before);
    }
    void name_without_blood(bool named, const Parameter& parameter) {
        const ui::Row line(ui_, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        if (!named) {
            ui::label(ui_, "Without blood: none", {.tone = ui::Tone::dim});
            ui_.last().tip = tip_of(parameter);
        }
        ui::command_button(ui_, on_.commands, "measure.without_blood");
        if (named && ui::icon_button(ui_, Icon::cross, "No frame without blood",
                                     {.tip = "No frame is named as one without blood", .quiet = true}))
            on_.edited.document.change("No frame without blood",
                                       [](Content& c) { c.scene.reference.measure.without_blood = -1.0; });
    }

    void parts() {
        {
            const ui::Row buttons(ui_, {.width = ui::grow()});
            ui::command_button(ui_, on_.commands, "measure.draw_part");
        }
        if (measure().parts.empty())
            ui::label(
                ui_,
                "The black surround, instruments and burnt-in text are found without help. Any other thing that is not "
                "tissue can be left out as a part.",
                {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
        for (std::size_t i = 0; i < measure().parts.size(); ++i) {
            ui_.push_seed(i);
            char text[64];
            std::snprintf(text, sizeof text, "Part %zu: %zu corners", i + 1, measure().parts[i].corners.size());
            const ui::Row line(ui_, {.width = ui::grow(), .cross = ui::ChildAlign::center});
            ui::label(ui_, ui_.copy(text), {.width = ui::grow()});
            if (ui::icon_button(ui_, Icon::cross, "Remove part", {.quiet = true}))
                on_.edited.document.change("Remove part", [&](Content& c) {
                    auto& all = c.scene.reference.measure.parts;
                    all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
                });
            ui_.pop_seed();
        }
    }

    void time_and_region() {
        static const OwnerOf owner = [](Content& c) -> void* { return &c.scene.reference.measure.region; };
        row("from");
        row("to");
        const Table& table = *app::measure_table().find("region");
        for (const Parameter& each : table.rows)
            row(table, each.key, owner, {.prefix = "Region", .standard = &standard().region});
    }

    ui::Ui& ui_;
    const MeasureParts& on_;
    Faults& faults_;
};

void settings(ui::Ui& ui, const MeasureParts& on) {
    if (const ui::Section section(ui, "This frame"); section) frame_figures(ui, on.bench);
    if (const ui::Section section(ui, "Whole reference"); section) whole_figures(ui, on);
    Settings(ui, on).build();
}

// --- the panel -------------------------------------------------------------------------------------------------------

void no_video(ui::Ui& ui, const MeasureParts& on) {
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow(), .padding = 1});
    if (has_row(app::measure_table(), wanted_row(ui))) wanted_row(ui) = nullptr;
    if (on.reference.opening()) return ui::label(ui, "Opening the reference...", {.tone = ui::Tone::dim});
    ui::label(ui, "There is no reference to measure. Open a surgery video first.", {.wrap = true, .width = ui::grow()});
    for (const Fault& fault : on.reference.faults())
        ui::label(ui, ui.copy(fault.text()), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    const ui::Row row(ui);
    ui::command_button(ui, on.commands, "reference.open");
    if (ui::button(ui, "Sample reference", {.tip = "A video that comes with lapfx"})) on.reference.choose_sample();
}

/// The picture must not move below a brush, so that the curves wait, as the measuring of all frames does.
bool shows_plot(const MeasureParts& on) {
    return !on.measuring.frames().empty() && !on.bench.look.paints();
}

/// One scrolls from the picture to all else in a small panel.
void small(ui::Ui& ui, const MeasureParts& on, const ui::Rect& room) {
    const ui::ScrollArea area(ui, "Measured all", {.gap = 0.3F});
    {
        const float height = std::max(room.h - 2.5F * ui.row_height() - ui.em(3), ui.em(least_picture / 2));
        const ui::Column held(ui, {.width = ui::grow(), .height = ui::px(height), .gap = 0.2F});
        measured_picture(ui, on);
    }
    if (shows_plot(on)) amounts_plot(ui, on, ui::px(ui.em(least_plot)));
    settings(ui, on);
}

/// Esc, and a part that nobody can see, end what was begun on the picture.
void follow_escape(ui::Ui& ui, app::MeasureBench& bench) {
    if (!bench.look.left_out && bench.look.tool == app::MeasureTool::draw_part) bench.lay_down();
    if (ui.key_down(ui::Key::escape)) bench.lay_down();
}

}  // namespace

void measure_panel(ui::Ui& ui, const MeasureParts& on) {
    on.reference.follow();
    if (on.reference.video() == nullptr) return no_video(ui, on);
    on.bench.show();
    if (!on.bench.look.paints()) on.measuring.want();
    if (on.measuring.due() < ui::never) ui.wake_at(on.measuring.due(), "the reference is being measured");
    if (on.bench.stale()) ui.wake_at(ui.time(), "the measured frame follows");
    follow_escape(ui, on.bench);
    const ui::Rect room = ui.rect_before(ui.parent().id);
    const float width = room.w > 0 ? std::max(1.0F, room.w - 2 * ui.em(0.6F)) : 0.0F;
    tools(ui, on, width);
    if (room.w > 0 && (room.w < ui.em(wide_panel) || room.h < ui.em(low_panel))) return small(ui, on, room);
    const ui::Row row(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.6F, .cross = ui::ChildAlign::stretch});
    {
        const ui::Column seen(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.2F});
        measured_picture(ui, on);
        if (shows_plot(on)) amounts_plot(ui, on, ui::px(std::max(std::floor(plot_share * room.h), ui.em(least_plot))));
    }
    const ui::ScrollArea area(ui, "Measure settings", {.width = ui::px(ui.em(settings_width)), .gap = 0.3F});
    settings(ui, on);
}

}  // namespace lapfx::panels
