// Commands of the fit.
#include "app/base/file_chooser.h"
#include "app/base/layouts.h"
#include "app/editor.h"
#include "app/measure/fit_reporting.h"
#include "app/measure/fitting.h"
#include "app/reference/reference.h"
#include "panels/panels.h"

namespace lapfx::panels {

namespace {

/// What was found when it was asked for: a new fit may have begun meanwhile.
void ask_where(app::Editor& editor) {
    const app::FitFound found = *editor.fitting().found();
    editor.chooser().ask({.task = ui::FileTask::save,
                          .title = "Export report of the fit",
                          .name = found.of.reference.stem().string() + "_fit.html",
                          .filters = {{"Web pages", {".html"}}}},
                         [&editor, found](const std::vector<std::string>& files) {
                             editor.fit_reporting().write(found, files.front());
                         });
}

}  // namespace

void add_fit_commands(app::Editor& editor) {
    const auto can_start = [&editor] { return editor.reference().video() != nullptr && !editor.fitting().busy(); };
    const auto found = [&editor] {
        return editor.fitting().found() != nullptr && !editor.fitting().taken() && !editor.fitting().busy();
    };
    const char* const no_start = "there is no reference that can be shown, or it is being fitted";
    const char* const nothing = "nothing has been found yet, it has been taken, or it is being looked for anew";
    const auto show = [&editor] { editor.layouts().bring_to_front("Fit"); };
    editor.commands.add({.id = "fit.start",
                         .title = "Fit",
                         .group = "Reference",
                         .chord = {ui::key_of('F'), ui::Mods::command | ui::Mods::shift},
                         .run =
                             [&editor, show] {
                                 show();
                                 editor.fitting().start();
                             },
                         .enabled = can_start,
                         .tip = "Finds the values with which the preview shows as much blood and smoke as the "
                                "reference; nothing changes until they are taken",
                         .missing = no_start});
    editor.commands.add({.id = "fit.propose",
                         .title = "Propose",
                         .group = "Reference",
                         .run =
                             [&editor, show] {
                                 show();
                                 editor.fitting().propose();
                             },
                         .enabled = can_start,
                         .tip = "Reads times and amounts out of the reference's curves alone, without drawing: within "
                                "two seconds, less exact than Fit",
                         .missing = no_start});
    editor.commands.add({.id = "fit.take",
                         .title = "Take",
                         .group = "Reference",
                         .run = [&editor] { editor.fitting().take(); },
                         .enabled = found,
                         .tip = "Takes what was found into preset and scene, as one undo step",
                         .missing = nothing});
    editor.commands.add({.id = "fit.leave",
                         .title = "Leave",
                         .group = "Reference",
                         .run = [&editor] { editor.fitting().leave(); },
                         .enabled = found,
                         .tip = "Forgets what was found; preset and scene stay as they are",
                         .missing = nothing});
    editor.commands.add({.id = "fit.report",
                         .title = "Export report...",
                         .group = "Reference",
                         .run = [&editor] { ask_where(editor); },
                         .enabled =
                             [&editor] {
                                 const app::FitFound* const all = editor.fitting().found();
                                 return all != nullptr && all->result && !editor.fit_reporting().busy();
                             },
                         .tip = "Writes curves, parameters and pictures of what Fit has found as a page for a browser",
                         .missing = "No whole fit has been done yet, or a report is being written"});
}

}  // namespace lapfx::panels
