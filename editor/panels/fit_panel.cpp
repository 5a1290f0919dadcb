// Fit: what may change so that the preview shows as much blood and smoke as the reference, and what was found.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/clips/clip_shelf.h"
#include "app/measure/fit_reporting.h"
#include "app/measure/fitting.h"
#include "app/reference/reference.h"
#include "app/tuning/key_titles.h"
#include "app/tuning/parameters.h"
#include "match/fit/worse.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/preset_rows.h"
#include "ui/core/node.h"
#include "ui/shell/progress.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/section.h"

namespace lapfx::panels {

namespace {

using app::FitFound;
using app::Fitting;
using app::ParameterEntry;

template <typename... Values>
std::string_view formatted(ui::Ui& ui, const char* form, Values... values) {
    char text[160];
    std::snprintf(text, sizeof text, form, values...);
    return ui.copy(text);
}

void wrapped(ui::Ui& ui, std::string_view text, ui::Tone tone) {
    ui::label(ui, text, {.tone = tone, .wrap = true, .width = ui::grow()});
}

const ParameterEntry* entry_of(std::string_view key) {
    const std::size_t entry = app::parameters().find(key);
    return entry == app::no_entry ? nullptr : &app::parameters()[entry];
}

// --- what is to be done ----------------------------------------------------------------------------------------------

void doing(ui::Ui& ui, Fitting& fitting) {
    if (fitting.measures_first()) {
        const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        ui::label(ui, "Measuring the reference first", {.tone = ui::Tone::dim, .width = ui::grow()});
        if (ui::icon_button(ui, ui::Icon::cross, "Cancel", {.quiet = true})) fitting.cancel();
        return;
    }
    const double share = fitting.proposes() ? -1.0 : fitting.progress();
    if (ui::progress(ui, fitting.proposes() ? "Proposing" : "Fitting", share,
                     {.seconds_left = fitting.seconds_left(), .at_most = true, .cancellable = true}))
        fitting.cancel();
}

void tools(ui::Ui& ui, const FitParts& on) {
    if (on.fitting.busy()) return doing(ui, on.fitting);
    const ui::Row row(ui, {.width = ui::grow()});
    if (on.fitting.found() == nullptr || on.fitting.taken()) {
        ui::command_button(ui, on.commands, "fit.start");
        ui::command_button(ui, on.commands, "fit.propose");
        return;
    }
    for (const char* id : {"fit.take", "fit.leave", "fit.start"}) ui::command_button(ui, on.commands, id);
}

/// What is wrong with a clip is mended where it is told.
void choose_clip(ui::Ui& ui, const FitParts& on) {
    if (!on.fitting.lost_clip()) return;
    if (!ui::button(ui, "Choose file...", {.icon = ui::Icon::folder, .tip = "Use another file for this clip"})) return;
    on.clips.selected = *on.fitting.lost_clip();
    on.commands.run("clip.replace");
}

void state(ui::Ui& ui, const FitParts& on) {
    for (const Fault& fault : on.fitting.faults()) wrapped(ui, ui.copy(fault.text()), ui::Tone::error);
    choose_clip(ui, on);
    if (on.fitting.busy()) return;
    const FitFound* const found = on.fitting.found();
    if (found == nullptr) {
        if (on.reference.video() == nullptr && on.fitting.faults().empty())
            wrapped(ui, "There is no reference to fit to. Open a surgery video first.", ui::Tone::dim);
        return;
    }
    if (on.fitting.stale())
        wrapped(ui, "The scene or the preset has changed since; what is taken is what was found before.",
                ui::Tone::warning);
    if (found->result && found->result->ended_early)
        wrapped(ui, "Cancelled: the nearest so far. What the video tells was not looked into.", ui::Tone::warning);
}

// --- what was found --------------------------------------------------------------------------------------------------

void misfit_line(ui::Ui& ui, const char* name, const std::optional<double>& before,
                 const std::optional<double>& after) {
    const ui::Row row(ui, {.width = ui::grow()});
    ui::label(ui, name, {.tone = ui::Tone::dim, .width = ui::px(ui.em(6.5F))});
    if (!before || !after) return ui::label(ui, "not measurable", {.tone = ui::Tone::dim});
    ui::label(ui, formatted(ui, "off by %.1f %% before, %.1f %% after", 100 * *before, 100 * *after),
              {.number = true, .width = ui::grow()});
    ui.last().tip =
        "Root mean square difference between the preview's curve and the reference's, in percent of the view";
}

void report(ui::Ui& ui, const FitParts& on) {
    if (!on.reporting.busy()) return ui::command_button(ui, on.commands, "fit.report"), void();
    if (ui::progress(ui, "Writing the report", on.reporting.progress(), {.cancellable = true})) on.reporting.cancel();
}

const match::FittedParameter* fitted(const FitFound* found, const std::string& key) {
    if (found == nullptr || !found->result) return nullptr;
    const auto& all = found->result->parameters;
    const auto at = std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.parameter.key == key; });
    return at == all.end() ? nullptr : &*at;
}

/// "4 → 6.3 mm/s", which nobody takes for an interval.
void change_text(ui::Ui& ui, double before, double after, const Parameter& row) {
    ui::label(
        ui,
        ui.join({before == after ? formatted(ui, "%.3g", after) : formatted(ui, "%.3g \u2192 %.3g", before, after),
                 row.unit.empty() ? "" : " ", row.unit}),
        {.tone = before == after ? ui::Tone::dim : ui::Tone::normal, .number = true, .width = ui::grow()});
}

void interval(ui::Ui& ui, const match::FittedParameter& p) {
    if (!p.determined) return;
    ui::label(ui, formatted(ui, "%.3g .. %.3g%s", p.low, p.high, p.at_bound ? ", at its bound" : ""),
              {.tone = p.at_bound ? ui::Tone::warning : ui::Tone::dim, .number = true});
    ui.last().tip = "Holds the true value in nine of ten cases";
}

void why_not(ui::Ui& ui, const match::FittedParameter& p) {
    if (!p.determined && !p.why.empty())
        wrapped(ui, ui.join({"Not determined: ", app::with_titles(p.why)}), ui::Tone::warning);
}

/// When a tool works, of "events.1.time": "Event 2, time: 1.4 → 2.1 s".
void tool_line(ui::Ui& ui, const match::FittedParameter& p) {
    int event = 0;
    if (std::sscanf(p.parameter.key.c_str(), "events.%d.", &event) != 1) return;
    {
        const ui::Row row(ui, {.width = ui::grow()});
        ui::label(ui, formatted(ui, "Event %d, %s", event + 1, p.parameter.row->key.data()),
                  {.tone = ui::Tone::dim, .width = ui::px(ui.em(8.5F))});
        change_text(ui, p.before, p.after, *p.parameter.row);
        interval(ui, p);
    }
    why_not(ui, p);
}

/// Before it is taken: what becomes nearer may be at the cost of something else.
void worse_lines(ui::Ui& ui, const match::FitResult& result) {
    const std::vector<std::string> worse = match::what_is_worse(result);
    if (worse.empty()) return;
    wrapped(ui, "Farther from the reference than before:", ui::Tone::warning);
    for (const std::string& line : worse) wrapped(ui, ui.copy(line), ui::Tone::warning);
}

void found_lines(ui::Ui& ui, const FitFound& found) {
    if (found.result) {
        worse_lines(ui, *found.result);
        misfit_line(ui, "Blood", found.result->blood_before, found.result->blood_after);
        misfit_line(ui, "Veil", found.result->veil_before, found.result->veil_after);
        for (const match::FittedParameter& p : found.result->parameters) tool_line(ui, p);
    }
    for (const auto* const lines : {&found.lines, &found.colors})
        for (const std::string& line : *lines) wrapped(ui, ui.copy(app::with_titles(line)), ui::Tone::dim);
}

// --- what may change -------------------------------------------------------------------------------------------------

void found_of(ui::Ui& ui, const FitFound& found, const std::string& key) {
    const auto free = std::find_if(found.parameters.begin(), found.parameters.end(),
                                   [&](const match::FreeParameter& p) { return p.key == key; });
    if (free == found.parameters.end()) return;
    const match::FittedParameter* const p = fitted(&found, key);
    {
        const ui::Row row(ui, {.width = ui::grow()});
        ui::label(ui, "", {.width = ui::px(ui.em(1))});
        change_text(ui, free->get(found.fit.start), free->get(found.tuned), *free->row);
        if (p != nullptr) interval(ui, *p);
    }
    if (p != nullptr) why_not(ui, *p);
}

/// One that may change; gives whether it is to be taken away.
bool free_row(ui::Ui& ui, const Fitting& fitting, const std::string& key) {
    const ParameterEntry* const entry = entry_of(key);
    const std::string_view title = entry != nullptr ? std::string_view(entry->title) : std::string_view(key);
    const bool locked = fitting.locked(key);
    bool away = false;
    {
        const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        ui::label(ui, title, {.tone = locked ? ui::Tone::dim : ui::Tone::normal, .width = ui::grow()});
        if (entry != nullptr) ui.last().tip = entry->tip;
        if (locked) ui::label(ui, "locked", {.tone = ui::Tone::dim});
        away = ui::icon_button(ui, ui::Icon::cross, ui.join({"Keep ", title}),
                               {.tip = "It stays as it is", .quiet = true});
    }
    if (fitting.found() != nullptr) found_of(ui, *fitting.found(), key);
    return away;
}

/// Numbers of the preset that may be free.
struct Choices {
    std::vector<std::string> keys;
    std::vector<std::string_view> titles;

    Choices() {
        for (const ParameterEntry& entry : app::parameters().entries()) {
            if (entry.row->kind != Kind::number) continue;
            keys.push_back(entry.key);
            titles.push_back(entry.title);
        }
    }
};

void add_free(ui::Ui& ui, Fitting& fitting) {
    static const Choices choices;
    int chosen = -1;
    const ui::Edit edit = ui::combo(ui, "Add parameter", chosen, choices.titles,
                                    {.tip = "Another number of the preset that may change", .placeholder = "Add..."});
    if (!edit.changed || chosen < 0) return;
    const std::string& key = choices.keys[static_cast<std::size_t>(chosen)];
    std::vector<std::string>& keys = fitting.look.keys;
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    ui.build_again();
}

void what_may_change(ui::Ui& ui, Fitting& fitting) {
    std::vector<std::string>& keys = fitting.look.keys;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        ui.push_seed(i);
        const bool away = free_row(ui, fitting, keys[i]);
        ui.pop_seed();
        if (!away) continue;
        keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(i));
        ui.build_again();
        break;
    }
    if (keys.empty()) wrapped(ui, "Nothing: all parameters stay as they are.", ui::Tone::warning);
    add_free(ui, fitting);
    ui::checkbox(ui, "Tools may change", fitting.look.tools,
                 "Strokes may begin when smoke and blood of the reference begin, and be added or silenced");
    ui::checkbox(ui, "Colours", fitting.look.colors,
                 "Matches the colours of blood and smoke, too, and exposure and organ colour of the scene. Not for "
                 "Propose, which draws nothing");
}

void weight(ui::Ui& ui, std::string_view name, double& value, std::string_view tip) {
    ui::param(ui, name, value,
              {.maximum = 1, .hard_minimum = 0, .hard_maximum = 1, .step = 0.1, .standard = 1, .tip = tip});
}

}  // namespace

void fit_panel(ui::Ui& ui, const FitParts& on) {
    Fitting& fitting = on.fitting;
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.3F, .padding = 0.4F});
    tools(ui, on);
    state(ui, on);
    const ui::ScrollArea area(ui, "Fit settings", {.gap = 0.2F});
    if (const FitFound* const found = fitting.found())
        if (const ui::Section section(ui, fitting.busy()    ? "Found before"
                                          : fitting.taken() ? "Taken"
                                                            : "Found");
            section) {
            found_lines(ui, *found);
            if (found->result) report(ui, on);
        }
    if (const ui::Section section(ui, "What may change"); section) what_may_change(ui, fitting);
    if (const ui::Section section(ui, "What counts", {.open = false}); section) {
        weight(ui, "Blood", fitting.look.weights.blood, "How much the curve of blood counts; 0 leaves it out");
        weight(ui, "Veil", fitting.look.weights.veil,
               "How much the curve of smoke counts, of haze and plume together; 0 leaves it out");
    }
}

}  // namespace lapfx::panels
