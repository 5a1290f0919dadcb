// The editor's window, put together from panels. Each panel and each dialog is a function in a file of its own, and
// takes what it works on. workspace.cpp has the one table of panels, and hands out the parts of the app::Editor.
//
//     panels::set_up(editor);  // once
//     ui.frame(input, [&](ui::Ui& u) { panels::workspace(u, editor); });
//
// A new panel is a function that is declared here, and a row of that table.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "app/preview/looking.h"
#include "app/preview/timeline.h"
#include "app/preview/tool_hold.h"
#include "panels/edited.h"
#include "ui/core/ui.h"
#include "ui/shell/commands.h"
#include "ui/shell/toast.h"

namespace lapfx::app {
class AmountsOverTime;
class Autosave;
class Browser;
class ClipShelf;
class Editor;
class Exports;
class Files;
class FitReporting;
class Fitting;
class Jobs;
class KeyingBench;
class Layouts;
class MeasureBench;
class Measuring;
class Notices;
class OrganChoice;
class PreviewHost;
class PreviewMeasuring;
class Reference;
class ReferenceComparison;
class Settings;
class SnapshotPreviews;
class Snapshots;
class Tuning;
}  // namespace lapfx::app

namespace lapfx::panels {

/// Which panels and layouts there are, and every command of the program with its standard keys.
void set_up(app::Editor& editor);
/// All panels, in the order of their table.
std::vector<std::string_view> panel_names();

/// The whole window: menus, panels as the user arranged them, status bar, dialogs, notices.
void workspace(ui::Ui& ui, app::Editor& editor);

// --- panels ----------------------------------------------------------------------------------------------------------
struct ViewParts {
    Edited edited;
    app::PreviewHost& preview;
    app::Looking& looking;
    app::ToolInHand& tool;
    app::ToolHold& hold;
    app::OrganChoice& organ_choice;
    app::ClipShelf& clips;
    app::Reference& reference;
    app::Jobs& jobs;
    ui::CommandTable& commands;
    ui::Toasts& toasts;
    bool half_resolution;
};
void view_panel(ui::Ui& ui, const ViewParts& parts);
void preset_panel(ui::Ui& ui, app::Tuning& tuning, const Edited& edited, const ui::CommandTable& commands,
                  app::Layouts& layouts, ui::Toasts& toasts, const app::ClipShelf& shelf, app::Looking& looking);
void clips_panel(ui::Ui& ui, app::ClipShelf& shelf, const Edited& edited, app::Files& files,
                 ui::CommandTable& commands);
void keying_panel(ui::Ui& ui, app::KeyingBench& bench, app::ClipShelf& shelf, const Edited& edited,
                  ui::CommandTable& commands);
void reference_panel(ui::Ui& ui, app::Reference& reference, app::Measuring& measuring, const Edited& edited,
                     app::Files& files, ui::CommandTable& commands);
struct MeasureParts {
    Edited edited;
    app::Reference& reference;
    app::Measuring& measuring;
    app::MeasureBench& bench;
    app::Timeline& timeline;
    ui::CommandTable& commands;
};
void measure_panel(ui::Ui& ui, const MeasureParts& parts);
struct TimelineParts {
    Edited edited;
    app::Timeline& timeline;
    std::vector<std::size_t>& selected;  ///< of the scene's events
    const app::ToolInHand& tool;         ///< events that are added get its values
    const app::ToolHold& hold;
    const app::PreviewHost& preview;  ///< for their place
    const app::Measuring& measuring;  ///< for marks that it proposes
    const app::Looking& looking;
    ui::CommandTable& commands;
    ui::Toasts& toasts;
};
void timeline_panel(ui::Ui& ui, const TimelineParts& parts);
void curves_panel(ui::Ui& ui, document::Document& document, const app::Timeline& timeline, ui::Toasts& toasts);
struct AmountsParts {
    const document::Document& document;
    app::AmountsOverTime& amounts;   ///< the core's own
    app::PreviewMeasuring& preview;  ///< what the preview's pictures show
    app::Measuring& measuring;       ///< and those of the reference
    const app::Reference& reference;
    app::Timeline& timeline;
    const app::Fitting& fitting;  ///< for the curve that it has found
    app::Tuning& tuning;          ///< whose row mends what differs
    app::Layouts& layouts;
    std::vector<std::size_t>& selected;  ///< of the scene's events
};
void amounts_panel(ui::Ui& ui, const AmountsParts& parts);
struct FitParts {
    app::Fitting& fitting;
    app::FitReporting& reporting;
    const app::Reference& reference;
    app::ClipShelf& clips;
    ui::CommandTable& commands;
};
void fit_panel(ui::Ui& ui, const FitParts& parts);
void presets_panel(ui::Ui& ui, app::Browser& browser, const document::Document& document, app::Files& files,
                   app::FileChooser& chooser, ui::Toasts& notices);
void snapshots_panel(ui::Ui& ui, app::Snapshots& snapshots, app::SnapshotPreviews& previews,
                     app::ReferenceComparison& comparison, app::Layouts& layouts, document::Document& document);
void history_panel(ui::Ui& ui, document::Document& document, ui::CommandTable& commands);
void scene_panel(ui::Ui& ui, const Edited& edited, const app::PreviewHost& preview, ui::CommandTable& commands,
                 ui::Toasts& toasts);

// --- dialogs: nothing while they are closed --------------------------------------------------------------------------
void organ_dialog(ui::Ui& ui, app::OrganChoice& choice, ui::CommandTable& commands);
void export_dialog(ui::Ui& ui, app::Exports& exports, app::FileChooser& chooser, app::Notices& notices);
void export_status(ui::Ui& ui, app::Exports& exports);  ///< the status bar shows it while an export runs
void closing_dialog(ui::Ui& ui, app::Files& files);
void recovery_dialog(ui::Ui& ui, app::Autosave& autosave, app::Files& files);
void settings_dialog(ui::Ui& ui, app::Settings& settings, ui::CommandTable& commands);

// --- commands --------------------------------------------------------------------------------------------------------
// They take the whole editor: a command may act on anything, and what it does is decided when it runs.
void add_file_commands(app::Editor& editor);
void add_edit_commands(app::Editor& editor);
void add_view_commands(app::Editor& editor);
void add_play_commands(app::Editor& editor);
void add_tool_commands(app::Editor& editor);
void add_preset_commands(app::Editor& editor);
void add_clip_commands(app::Editor& editor);
void add_reference_commands(app::Editor& editor);
void add_measure_commands(app::Editor& editor);
void add_fit_commands(app::Editor& editor);
void add_snapshot_commands(app::Editor& editor);
void add_export_commands(app::Editor& editor);
void add_window_commands(app::Editor& editor);
void add_panel_commands(app::Editor& editor);  ///< in workspace.cpp: one for each panel
void add_commands(app::Editor& editor);        ///< all of these

// --- the parts that panels take, out of an editor --------------------------------------------------------------------
Edited edited_in(app::Editor& editor);
ViewParts view_parts(app::Editor& editor);
MeasureParts measure_parts(app::Editor& editor);
TimelineParts timeline_parts(app::Editor& editor);

}  // namespace lapfx::panels
