// Commands of measuring the reference.
#include "app/base/file_chooser.h"
#include "app/base/layouts.h"
#include "app/editor.h"
#include "app/measure/measure_bench.h"
#include "app/measure/measuring.h"
#include "app/measure/proposed_marks.h"
#include "app/reference/reference.h"
#include "panels/panels.h"

namespace lapfx::panels {

namespace {

using ui::key_of;
using ui::Mods;

struct ExportRow {
    app::MeasureFile kind;
    const char *id, *title, *extension, *filter, *tip;
};
constexpr ExportRow export_rows[] = {
    {app::MeasureFile::csv, "measure.export_csv", "CSV...", ".csv", "Tables",
     "Writes the amounts of every frame as a table"},
    {app::MeasureFile::json, "measure.export_json", "JSON...", ".json", "JSON",
     "Writes amounts, baseline, episodes and notes"},
    {app::MeasureFile::png, "measure.export_png", "PNG...", ".png", "Pictures", "Writes the curves as a picture"},
};

void ask_where(app::Editor& editor, const ExportRow& row) {
    editor.chooser().ask({.task = ui::FileTask::save,
                          .title = std::string("Export amounts as ") + row.filter,
                          .name = editor.measuring().file().stem().string() + "_amounts" + row.extension,
                          .filters = {{row.filter, {row.extension}}}},
                         [&editor, kind = row.kind](const std::vector<std::string>& files) {
                             editor.measuring().write(kind, files.front());
                         });
}

void add_exports(app::Editor& editor) {
    for (const ExportRow& row : export_rows)
        editor.commands.add({.id = row.id,
                             .title = row.title,
                             .group = "Reference",
                             .run = [&editor, &row] { ask_where(editor, row); },
                             .enabled = [&editor] { return editor.measuring().found() != nullptr; },
                             .tip = row.tip,
                             .missing = "the reference has not been measured yet"});
}

}  // namespace

void add_measure_commands(app::Editor& editor) {
    const auto shown = [&editor] { return editor.reference().video() != nullptr; };
    const char* const missing = "there is no reference that can be shown";
    editor.commands.add({.id = "measure.run",
                         .title = "Measure reference",
                         .group = "Reference",
                         .chord = {key_of('M'), Mods::command},
                         .run =
                             [&editor] {
                                 editor.layouts().bring_to_front("Measure");
                                 editor.measuring().start();
                             },
                         .enabled = shown,
                         .tip = "Measures blood and smoke in every frame of the reference",
                         .missing = missing});
    editor.commands.add({.id = "measure.use_frame",
                         .title = "Use this frame",
                         .group = "Reference",
                         .chord = {key_of('B'), Mods::command},
                         .run = [&editor] { editor.measuring().use_frame(); },
                         .enabled = shown,
                         .tip = "The frame of the reference that is shown has no smoke and no blood: it is the "
                                "baseline, which all others are compared with",
                         .missing = missing});
    editor.commands.add({.id = "measure.suggest",
                         .title = "Suggest",
                         .group = "Reference",
                         .run = [&editor] { editor.measuring().suggest(); },
                         .enabled =
                             [&editor] {
                                 return editor.reference().video() != nullptr &&
                                        editor.document.scene().reference.measure.baseline > 0;
                             },
                         .tip = "Looks for the earliest clear frame of the reference and takes it as the baseline",
                         .missing = "the baseline is suggested already"});
    editor.commands.add({.id = "measure.pick_blood",
                         .title = "Pick blood",
                         .group = "Reference",
                         .chord = {key_of('K'), Mods::command | Mods::shift},
                         .icon = ui::Icon::eyedropper,
                         .run =
                             [&editor] {
                                 editor.layouts().bring_to_front("Measure");
                                 app::MeasureBench& bench = editor.measure_bench();
                                 bench.stop_drawing();
                                 bench.look.picks_blood = !bench.look.picks_blood;
                                 bench.show();  // it may have come to the front only now
                             },
                         .enabled = shown,
                         .checked = [&editor] { return editor.measure_bench().look.picks_blood; },
                         .tip = "Takes the colour of blood from the picture: sets redness and brightness",
                         .missing = missing});
    editor.commands.add({.id = "measure.draw_part",
                         .title = "Draw part",
                         .group = "Reference",
                         .run =
                             [&editor] {
                                 editor.layouts().bring_to_front("Measure");
                                 app::MeasureBench& bench = editor.measure_bench();
                                 const bool draws = !bench.look.draws_part;
                                 bench.stop_drawing();
                                 bench.look.picks_blood = false;
                                 bench.look.draws_part = draws;
                                 bench.look.left_out = true;
                                 bench.show();
                             },
                         .enabled =
                             [&editor] {
                                 return editor.reference().video() != nullptr &&
                                        editor.document.scene().reference.measure.parts.size() < most_left_out_parts;
                             },
                         .checked = [&editor] { return editor.measure_bench().look.draws_part; },
                         .tip = "Click the corners of a part of the picture that is not measured, such as a logo",
                         .missing = "there is no reference, or it has as many parts as it can have"});
    editor.commands.add(
        {.id = "measure.take_marks",
         .title = "Take proposed marks",
         .group = "Reference",
         .run =
             [&editor] { app::take_marks(editor.document, app::marks_to_take(editor.measuring(), editor.document)); },
         .enabled = [&editor] { return app::any_marks(app::marks_to_take(editor.measuring(), editor.document)); },
         .tip = "Marks when smoke starts, peaks and has half gone, and when blood starts, as measured; "
                "what is marked already stays. One alone: a click on its ring on the timeline",
         .missing = "the reference is not measured, or all that its curves show is marked"});
    add_exports(editor);
}

}  // namespace lapfx::panels
