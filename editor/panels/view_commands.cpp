// Commands of the view: what is loaded into it, where it is looked from, and what lies over the tissue.
#include <algorithm>
#include <string>

#include "app/base/file_chooser.h"
#include "app/base/file_filters.h"
#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "app/clips/keying_bench.h"
#include "app/editor.h"
#include "app/files/organ_choice.h"
#include "app/measure/measure_bench.h"
#include "app/preview/orbit.h"
#include "app/reference/plate.h"
#include "app/reference/reference.h"
#include "panels/panels.h"
#include "ui/core/tree.h"

namespace lapfx::panels {

namespace {

using ui::Key;
using ui::Mods;

void show_organ_whole(app::Looking& looking, const app::PreviewHost& host) {
    const Preview* const preview = host.preview();
    if (preview == nullptr || preview->organ().positions.empty()) return;
    const glm::dvec2 size(glm::max(host.size(), glm::ivec2(1)));
    looking.camera = app::fit(preview->organ().positions, size.x / size.y);
    looking.endoscope = false;
}

/// The panel under the pointer; empty: none.
std::string panel_under_pointer(const ui::Ui& ui) {
    const auto tree = ui.tree();
    for (std::uint32_t i = 0; ui.hot() != 0 && i < tree.size(); ++i) {
        if (tree[i].id != ui.hot()) continue;
        const std::string path = ui::path_of(tree, i);
        const std::size_t begin = path.find('/') + 1;
        return path.starts_with("Workspace/") ? path.substr(begin, path.find('/', begin) - begin) : "";
    }
    return {};
}

/// Shows the whole picture under the pointer; without one the whole organ, or where the view is hidden, the picture
/// that is seen.
void show_whole(app::Editor& editor) {
    const std::string panel = panel_under_pointer(editor.ui());
    const app::Layouts& layouts = editor.layouts();
    const bool view = layouts.seen("View"), reference = layouts.seen("Reference");
    if (panel == "Keying" || (!view && !reference && layouts.seen("Keying")))
        editor.keying().look.state = {};
    else if (panel == "Measure" || (!view && !reference && layouts.seen("Measure")))
        editor.measure_bench().look.state = {};
    else if (panel == "Reference" || (!view && reference))
        editor.reference().comparison().state.view = {};
    else
        show_organ_whole(editor.looking, editor.preview);
}

/// Whether any picture is seen; it is asked in every frame, so it does not look for the pointer.
bool can_show_whole(app::Editor& editor) {
    const app::Layouts& layouts = editor.layouts();
    return editor.preview.ready() || (layouts.seen("Keying") && editor.keying().ready()) ||
           ((layouts.seen("Reference") || layouts.seen("Measure")) && editor.reference().video() != nullptr);
}

void add_overlay(app::Editor& editor, const OverlayRow& row) {
    editor.commands.add({.id = "view." + std::string(row.key),
                         .title = std::string(row.command),
                         .group = "View",
                         .chord = {ui::key_of(row.shortcut), Mods::none},
                         .run =
                             [&editor, overlay = row.overlay] {
                                 const bool on = editor.looking.overlay == overlay;
                                 editor.looking.overlay = on ? Overlay::none : overlay;
                             },
                         .checked = [&editor, overlay = row.overlay] { return editor.looking.overlay == overlay; },
                         .tip = std::string(row.help)});
}

void ask_organ(app::Editor& editor) {
    editor.chooser().ask(
        {.task = ui::FileTask::open, .title = "Load an organ", .filters = {app::mesh_filter()}},
        [&editor](const std::vector<std::string>& files) { editor.organ_choice().open(files.front()); });
}

void use_view(app::Editor& editor) {
    editor.document.change("Endoscope's place", [&](document::Content& c) {
        const SceneCamera& seen = editor.looking.camera;
        SceneCamera& camera = c.scene.camera;
        // The lamp is at the camera: it is turned down where that comes nearer, as the free view already shows it.
        c.scene.light.focus_distance =
            std::clamp(c.scene.light.focus_distance * app::nearness(camera, seen), 1.0, 2000.0);
        camera.eye = seen.eye, camera.target = seen.target, camera.up = seen.up;
        camera.field_of_view = seen.field_of_view;
    });
    editor.looking.endoscope = true;
}

/// The plate is seen through the endoscope, whose picture it is.
void turn_plate(app::Editor& editor) {
    const bool on = !editor.document.scene().plate.use;
    app::show_plate(editor.document, on);
    if (on) editor.looking.endoscope = true;
}

/// One that has lost its reference can still be turned off. While one is being made, a second press would take it away
/// again: the progress that is shown has a button for that.
bool can_turn_plate(app::Editor& editor) {
    const Scene& scene = editor.document.scene();
    return !scene.reference.file.empty() ? !editor.reference().look().plate_progress() : scene.plate.use;
}

}  // namespace

void add_view_commands(app::Editor& editor) {
    editor.commands.add({.id = "file.load_organ",
                         .title = "Load organ...",
                         .group = "File",
                         .chord = {ui::key_of('O'), Mods::command | Mods::shift},
                         .icon = ui::Icon::folder,
                         .run = [&editor] { ask_organ(editor); },
                         .tip = "Use another surface, with its unit and orientation"});
    editor.commands.add({.id = "view.frame",
                         .title = "Frame the organ",
                         .group = "View",
                         .chord = {Key::home, Mods::none},
                         .run = [&editor] { show_whole(editor); },
                         .enabled = [&editor] { return can_show_whole(editor); },
                         .tip = "Shows the whole organ, from the front. Over another picture: the whole picture",
                         .missing = "no picture is shown"});
    editor.commands.add({.id = "view.endoscope",
                         .title = "Endoscope view",
                         .group = "View",
                         .chord = {ui::key_of('E'), Mods::none},
                         .run = [&editor] { editor.looking.endoscope = !editor.looking.endoscope; },
                         .checked = [&editor] { return editor.looking.endoscope; },
                         .tip = "The view through the scene's camera, with its round picture; exports use it"});
    editor.commands.add({.id = "view.plate",
                         .title = "Plate",
                         .group = "View",
                         .chord = {ui::key_of('P'), Mods::none},
                         .run = [&editor] { turn_plate(editor); },
                         .enabled = [&editor] { return can_turn_plate(editor); },
                         .checked = [&editor] { return editor.document.scene().plate.use; },
                         .tip = "A clear frame of the reference in place of the organ: smoke and blood over the same "
                                "tissue as in the video",
                         .missing = "the scene has no reference, or its plate is being made"});
    editor.commands.add(
        {.id = "view.underlay",
         .title = "Underlay",
         .group = "View",
         .chord = {ui::key_of('U'), Mods::none},
         .run = [&editor] { editor.looking.underlay = !editor.looking.underlay; },
         .enabled = [&editor] { return editor.reference().video() != nullptr; },
         .checked = [&editor] { return editor.looking.underlay; },
         .tip = "Shows the reference over the view, translucent, so that the camera can be placed by it",
         .missing = "there is no reference that can be shown"});
    editor.commands.add({.id = "view.use_view",
                         .title = "Use view as endoscope",
                         .group = "View",
                         .run = [&editor] { use_view(editor); },
                         .enabled = [&editor] { return !editor.looking.endoscope; },
                         .tip = "Moves the endoscope to where you look from: comparing and exporting use its view",
                         .missing = "you look through the endoscope"});
    editor.commands.add(
        {.id = "view.half_resolution",
         .title = "Half resolution",
         .group = "View",
         .run = [&editor] { editor.settings().half_resolution = !editor.settings().half_resolution; },
         .checked = [&editor] { return editor.settings().half_resolution; },
         .tip = "Draws the view with a quarter of the pixels: faster without a GPU. Exports do not change"});
    for (const OverlayRow& row : overlays)
        if (!row.command.empty()) add_overlay(editor, row);
}

}  // namespace lapfx::panels
