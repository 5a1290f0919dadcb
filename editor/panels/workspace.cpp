// The window: the one table of panels, and which parts of the editor each panel and each dialog takes.
#include <string>

#include "app/base/file_chooser.h"
#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/editor.h"
#include "app/files/autosave.h"
#include "app/files/files.h"
#include "app/measure/fit_reporting.h"
#include "app/measure/fitting.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/letters.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/standard_layouts.h"
#include "ui/widgets/dock.h"

namespace lapfx::panels {

namespace {

using app::Editor;
using ui::Ui;

/// A panel: its name, which is the title of its tab and its path in the semantic tree, what its command is explained
/// by, and what builds it out of which parts of the editor.
struct PanelRow {
    std::string_view name;
    std::string_view tip;
    void (*build)(Ui& ui, Editor& editor);
};

/// The one list of panels. Layouts (standard_layouts.cpp), commands, menus and settings go by these names.
constexpr PanelRow panel_rows[] = {
    {"View", "The organ with blood and smoke, to look at and to work on with the tool",
     [](Ui& ui, Editor& e) { view_panel(ui, view_parts(e)); }},
    {"Preset", "The preset's parameters",
     [](Ui& ui, Editor& e) {
         preset_panel(ui, e.tuning(), edited_in(e), e.commands, e.layouts(), e.toasts, e.clips(), e.looking);
     }},
    {"Clips", "The preset's smoke videos",
     [](Ui& ui, Editor& e) { clips_panel(ui, e.clips(), edited_in(e), e.files(), e.commands); }},
    {"Keying", "What in the selected clip is smoke",
     [](Ui& ui, Editor& e) { keying_panel(ui, e.keying(), e.clips(), edited_in(e), e.commands); }},
    {"Reference", "The surgery video to match, alone or against the preview",
     [](Ui& ui, Editor& e) { reference_panel(ui, e.reference(), e.measuring(), edited_in(e), e.files(), e.commands); }},
    {"Measure", "How much blood and smoke the reference shows",
     [](Ui& ui, Editor& e) { measure_panel(ui, measure_parts(e)); }},
    {"Timeline", "Time, and what the tools do in it", [](Ui& ui, Editor& e) { timeline_panel(ui, timeline_parts(e)); }},
    {"Curves", "Factors over time on cautery power, bleeding and smoke",
     [](Ui& ui, Editor& e) { curves_panel(ui, e.document, e.timeline, e.toasts); }},
    {"Amounts", "Blood and smoke over time, as plots",
     [](Ui& ui, Editor& e) {
         amounts_panel(ui, {.document = e.document,
                            .amounts = e.amounts(),
                            .preview = e.preview_measuring(),
                            .measuring = e.measuring(),
                            .reference = e.reference(),
                            .timeline = e.timeline,
                            .fitting = e.fitting(),
                            .tuning = e.tuning(),
                            .layouts = e.layouts(),
                            .selected = e.selected});
     }},
    {"Fit", "Finds the values with which the preview shows what the reference shows",
     [](Ui& ui, Editor& e) {
         fit_panel(ui, {.fitting = e.fitting(),
                        .reporting = e.fit_reporting(),
                        .reference = e.reference(),
                        .clips = e.clips(),
                        .commands = e.commands});
     }},
    {"Library", "Presets in folders, with pictures",
     [](Ui& ui, Editor& e) { presets_panel(ui, e.browser(), e.document, e.files(), e.chooser(), e.toasts); }},
    {"Snapshots", "Four states of the preset, and what differs between them",
     [](Ui& ui, Editor& e) {
         snapshots_panel(ui, e.snapshots(), e.snapshot_previews(), e.reference().comparison(), e.layouts(), e.document);
     }},
    {"History", "All that was done, to go back to",
     [](Ui& ui, Editor& e) { history_panel(ui, e.document, e.commands); }},
    {"Scene", "Organ, tool, camera, light and reference",
     [](Ui& ui, Editor& e) { scene_panel(ui, edited_in(e), e.preview, e.commands, e.toasts); }},
};

/// Layouts that were kept by an earlier version of the program name these.
constexpr ui::RenamedPanel renamed_panels[] = {{.before = "Presets", .now = "Library"}};

/// Files that were dropped where no panel takes them.
void bring_dropped(const Ui& ui, app::Files& opens) {
    if (const std::vector<std::string> files = dropped_files(ui.dropped()); !files.empty()) opens.bring(files);
}

}  // namespace

std::vector<std::string> dropped_files(std::string_view paths) {
    std::vector<std::string> files;
    for (std::size_t from = 0; from < paths.size();) {
        const std::size_t end = std::min(paths.find('\n', from), paths.size());
        if (end > from) files.emplace_back(paths.substr(from, end - from));
        from = end + 1;
    }
    return files;
}

Edited edited_in(Editor& e) {
    return {e.document, e.saved(), e.eyedropper, e.chooser(), e.seen_colors()};
}

ViewParts view_parts(Editor& e) {
    return {.edited = edited_in(e),
            .preview = e.preview,
            .looking = e.looking,
            .tool = e.tool,
            .hold = e.hold,
            .organ_choice = e.organ_choice(),
            .clips = e.clips(),
            .reference = e.reference(),
            .jobs = e.jobs,
            .commands = e.commands,
            .toasts = e.toasts,
            .half_resolution = e.settings().half_resolution};
}

MeasureParts measure_parts(Editor& e) {
    return {.edited = edited_in(e),
            .reference = e.reference(),
            .measuring = e.measuring(),
            .bench = e.measure_bench(),
            .timeline = e.timeline,
            .commands = e.commands};
}

TimelineParts timeline_parts(Editor& e) {
    return {.edited = edited_in(e),
            .timeline = e.timeline,
            .selected = e.selected,
            .tool = e.tool,
            .hold = e.hold,
            .preview = e.preview,
            .measuring = e.measuring(),
            .looking = e.looking,
            .commands = e.commands,
            .toasts = e.toasts};
}

std::vector<std::string_view> panel_names() {
    std::vector<std::string_view> names;
    for (const PanelRow& row : panel_rows) names.push_back(row.name);
    return names;
}

void set_up(Editor& editor) {
    editor.layouts().set_panels(panel_names(), standard_layouts(),
                                {std::begin(renamed_panels), std::end(renamed_panels)});
    add_commands(editor);
    // Keys, layouts and folders as the user left them.
    editor.settings().connect(editor.commands, editor.layouts(), editor.chooser().dialog(), editor.toasts);
}

void add_panel_commands(Editor& editor) {
    for (const PanelRow& row : panel_rows)
        editor.commands.add({.id = "window.show_" + lower(row.name),
                             .title = "Show " + std::string(row.name),
                             .group = "Window",
                             .run = [&editor, name = row.name] { editor.layouts().bring_to_front(name); },
                             .checked = [&editor, name = row.name] { return editor.layouts().seen(name); },
                             .tip = std::string(row.tip) + "; shows the panel, also if it was closed"});
}

void workspace(Ui& ui, Editor& e) {
    e.set_ui(ui);
    app::Layouts& layouts = e.layouts();
    app::Settings& settings = e.settings();
    layouts.fit_window(ui.window() / ui.em(1));
    bring_dropped(ui, e.files());
    follow_eyedropper(ui, e.eyedropper, layouts);
    ui.set_theme(settings.light ? ui::light_theme() : ui::dark_theme());
    ui.set_reduced_motion(settings.reduced_motion);
    {
        const ui::Column window(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0});
        menu_bar(ui, e.commands, settings, e.files());
        if (!layouts.stacked()) first_hint(ui, settings, e.timeline.playing());
        ui::dock(ui, "Workspace", layouts.shown, layouts.panels(),
                 [&](std::size_t panel) { panel_rows[panel].build(ui, e); });
        status_bar(ui, {.document = e.document,
                        .preview = e.preview,
                        .clips = e.clips(),
                        .reference = e.reference(),
                        .measuring = e.measuring(),
                        .measured = e.preview_measuring(),
                        .fitting = e.fitting(),
                        .images = e.images,
                        .jobs = e.jobs,
                        .exports = e.exports(),
                        .hot_reload = e.hot_reload(),
                        .layouts = layouts,
                        .meter = e.meter(),
                        .options = e.options()});
    }
    organ_dialog(ui, e.organ_choice(), e.commands);
    export_dialog(ui, e.exports(), e.chooser(), e.toasts);
    closing_dialog(ui, e.files());
    recovery_dialog(ui, e.autosave(), e.files());
    settings_dialog(ui, settings, e.commands);
    layout_dialog(ui, layouts);
    about_dialog(ui, e.options());
    e.chooser().build(ui);
    command_palette(ui, e.commands, layouts, e.tuning());
    keys_sheet(ui, e.commands);
    e.toasts.build(ui);
    if (e.wants_frame()) ui.wake_at(ui.time(), "the preview plays");
    if (const double at = e.whole_at(); at < ui::never) ui.wake_at(at, "the scene as a whole");
    for (const double due : {e.autosave().due(), settings.due(), e.fitting().due(), e.fit_reporting().due()})
        if (due < ui::never) ui.wake_at(due, "what waits for a while");
}

}  // namespace lapfx::panels
