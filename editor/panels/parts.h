// Parts of the window that are no panels, and small things that several panels are made of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/base/editor_options.h"
#include "ui/core/ui.h"
#include "ui/shell/commands.h"
#include "ui/widgets/color_field.h"

namespace lapfx::document {
class Document;
}

namespace lapfx::ui {
struct ViewportResult;
}

namespace lapfx::app {
class ClipShelf;
class Exports;
class FileChooser;
class Files;
class Fitting;
class HotReload;
class Jobs;
class Layouts;
class Measuring;
class Meter;
class PreviewHost;
class PreviewMeasuring;
class Reference;
class Settings;
class Tuning;
}  // namespace lapfx::app

namespace lapfx::panels {

struct Edited;

/// What was dropped, as the UI has it: one a line.
std::vector<std::string> dropped_files(std::string_view paths);
/// Part of a row for a widget that takes all the room it gets, such as segmented(). `ems` 0: all that is left.
struct Room : ui::Row {
    Room(ui::Ui& ui, float ems)
        : ui::Row(ui, {.width = ems > 0 ? ui::px(ui.em(ems)) : ui::grow(), .cross = ui::ChildAlign::center}) {}
};

/// The keys of a command as they are bound now: "Ctrl+Z"; empty: it has none.
inline std::string_view chord_of(const ui::CommandTable& commands, std::string_view command) {
    return commands.chord_text(commands.index_of(command));
}

/// While a field wants a colour from a picture: says what to do, over the picture. Built in the node of the panel.
void pick_hint(ui::Ui& ui, ui::Eyedropper& eyedropper);
/// Where that lies, if the panel that is open now shows it: loupes keep off it.
ui::Rect pick_hint_rect(ui::Ui& ui, const ui::Eyedropper& eyedropper);
/// Takes it from the preview in the view, with a magnifier at the pointer. Built over the view.
void pick_in_view(ui::Ui& ui, const ui::ViewportResult& view, const Edited& edited, app::PreviewHost& preview);
/// Esc ends that. Where no such picture is in sight the view is shown. Once a frame.
void follow_eyedropper(ui::Ui& ui, ui::Eyedropper& eyedropper, app::Layouts& layouts);

/// Whether the reference stays at its frame: every panel that may hold one shows it.
void hold_toggle(ui::Ui& ui, app::Reference& reference);
/// Asks for the reference's file; it becomes the scene's.
void ask_for_video(app::Reference& reference, app::FileChooser& chooser);

void menu_bar(ui::Ui& ui, ui::CommandTable& commands, app::Settings& settings, app::Files& files);
/// In the File menu: the files opened last.
void recent_files_menu(ui::Ui& ui, app::Settings& settings, app::Files& files);
struct StatusParts {
    const document::Document& document;
    const app::PreviewHost& preview;
    const app::ClipShelf& clips;
    const app::Reference& reference;
    const app::Measuring& measuring;
    const app::PreviewMeasuring& measured;
    app::Fitting& fitting;
    const ui::ImageStore& images;
    const app::Jobs& jobs;
    app::Exports& exports;
    const app::HotReload& hot_reload;
    const app::Layouts& layouts;
    app::Meter& meter;
    const app::EditorOptions& options;
};
void status_bar(ui::Ui& ui, const StatusParts& parts);
/// Three lines for a person who starts the editor for the first time, until they are closed.
void first_hint(ui::Ui& ui, app::Settings& settings, bool playing);
/// Commands and parameters by name: a command runs, a parameter's row comes into sight and has the keyboard.
void command_palette(ui::Ui& ui, ui::CommandTable& commands, app::Layouts& layouts, app::Tuning& tuning);
/// All keys, and what the pointer does.
void keys_sheet(ui::Ui& ui, const ui::CommandTable& commands);
/// Version, renderer, paper, licences.
void about_dialog(ui::Ui& ui, const app::EditorOptions& options);
/// Name for the layout that is kept.
void layout_dialog(ui::Ui& ui, app::Layouts& layouts);

}  // namespace lapfx::panels
