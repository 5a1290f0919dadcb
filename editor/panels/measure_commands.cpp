// Commands of measuring the reference.
#include "app/base/file_chooser.h"
#include "app/base/layouts.h"
#include "app/editor.h"
#include "app/measure/blood_strokes.h"
#include "app/measure/measure_bench.h"
#include "app/measure/measuring.h"
#include "app/measure/proposed_marks.h"
#include "app/reference/reference.h"
#include "match/use/measure_video.h"
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

void take_tool(app::Editor& editor, app::MeasureTool tool) {
    editor.layouts().bring_to_front("Measure");
    app::MeasureBench& bench = editor.measure_bench();
    bench.take_tool(tool);
    if (tool == app::MeasureTool::draw_part) bench.look.left_out = true;  // its parts are seen with what is left out
    bench.show();                                                         // it may have come to the front only now
}

bool holds(app::Editor& editor, app::MeasureTool tool) {
    return editor.measure_bench().look.tool == tool;
}

/// A tool that is taken in hand, and laid down where it is already.
void add_tool(app::Editor& editor, app::MeasureTool tool, ui::Command command) {
    command.group = "Reference";
    command.run = [&editor, tool] { take_tool(editor, tool); };
    command.checked = [&editor, tool] { return holds(editor, tool); };
    editor.commands.add(std::move(command));
}

void ask_where(app::Editor& editor, const ExportRow& row) {
    editor.chooser().ask({.task = ui::FileTask::save,
                          .title = std::string("Export amounts as ") + row.filter,
                          .name = editor.measuring().file().stem().string() + "_amounts" + row.extension,
                          .filters = {{row.filter, {row.extension}}}},
                         [&editor, kind = row.kind](const std::vector<std::string>& files) {
                             editor.measuring().write(kind, files.front());
                         });
}

// --- strokes of blood ------------------------------------------------------------------------------------------------

struct BrushRow {
    const char *id, *title, *tip;
    char key;
    double factor;  ///< of the brush's radius
};
constexpr double brush_step = 1.25;
constexpr BrushRow brush_rows[] = {
    {"measure.smaller_brush", "Smaller brush", "Strokes of blood are painted with a thinner brush", '[',
     1 / brush_step},
    {"measure.larger_brush", "Larger brush", "Strokes of blood are painted with a thicker brush", ']', brush_step},
};
const ui::FileFilter strokes_filter{"Strokes", {".json"}};

const ReferenceMeasure& measure_of(app::Editor& editor) {
    return editor.document.scene().reference.measure;
}

void change_brush(app::Editor& editor, double factor) {
    double& brush = editor.measure_bench().look.brush;
    brush = std::clamp(factor * brush, app::MeasureLook::least_brush, app::MeasureLook::most_brush);
}

void ask_for_strokes(app::Editor& editor) {
    editor.chooser().ask({.task = ui::FileTask::open, .title = "Open strokes of blood", .filters = {strokes_filter}},
                         [&editor](const std::vector<std::string>& files) {
                             app::open_strokes(editor.document, editor.reference(), files.front(), editor.toasts);
                         });
}

void ask_where_strokes(app::Editor& editor) {
    editor.chooser().ask({.task = ui::FileTask::save,
                          .title = "Export strokes of blood",
                          .name = editor.reference().file().stem().string() + "_strokes.json",
                          .filters = {strokes_filter}},
                         [&editor](const std::vector<std::string>& files) {
                             app::export_strokes(measure_of(editor), files.front(), editor.toasts);
                         });
}

void add_strokes(app::Editor& editor) {
    const auto shown = [&editor] { return editor.reference().video() != nullptr; };
    const auto room = [&editor] {
        return editor.reference().video() != nullptr && measure_of(editor).strokes.size() < most_blood_strokes;
    };
    const auto painted = [&editor] { return !measure_of(editor).strokes.empty(); };
    const auto blood = [&editor] { return match::paints_blood(measure_of(editor)); };
    const char* const missing = "there is no reference that can be shown";
    const char* const full = "there is no reference, or it has as many strokes as it can have";
    const char* const none = "nothing is painted over the reference";
    add_tool(editor, app::MeasureTool::paint_blood,
             {.id = "measure.paint_blood",
              .title = "Paint blood",
              .chord = {key_of('B'), Mods::command | Mods::shift},
              .enabled = room,
              .tip = "Paint over what is blood in the picture: all that looks like it is measured then, not only what "
                     "is new since the baseline",
              .missing = full});
    add_tool(editor, app::MeasureTool::paint_other,
             {.id = "measure.paint_other",
              .title = "Paint other",
              .enabled = room,
              .tip = "Paint over what is no blood: tissue that is as red, highlights, an instrument",
              .missing = full});
    for (const BrushRow& row : brush_rows)
        editor.commands.add({.id = row.id,
                             .title = row.title,
                             .group = "Reference",
                             .chord = {key_of(row.key), Mods::none},
                             .run = [&editor, &row] { change_brush(editor, row.factor); },
                             .enabled = [&editor] { return editor.measure_bench().look.paints(); },
                             .tip = row.tip,
                             .missing = "no brush is in hand"});
    editor.commands.add(
        {.id = "measure.without_blood",
         .title = "No blood in this frame",
         .group = "Reference",
         .run = [&editor] { app::name_frame_without_blood(editor.document, editor.reference()); },
         .enabled = [shown, painted] { return shown() && painted(); },
         .tip = "The frame of the reference that is shown has no blood: strokes learn from all of it",
         .missing = "only strokes learn from it: there is no reference that can be shown, or nothing is painted "
                    "over it"});
    editor.commands.add({.id = "measure.open_strokes",
                         .title = "Open strokes...",
                         .group = "Reference",
                         .run = [&editor] { ask_for_strokes(editor); },
                         .enabled = shown,
                         .tip = "Reads strokes of blood from a file, in place of those over the reference",
                         .missing = missing});
    editor.commands.add({.id = "measure.export_strokes",
                         .title = "Export strokes...",
                         .group = "Reference",
                         .run = [&editor] { ask_where_strokes(editor); },
                         .enabled = blood,
                         .tip = "Writes the strokes to a file for lapfx measure --blood",
                         .missing = "no stroke marks blood"});
    editor.commands.add({.id = "measure.remove_strokes",
                         .title = "Remove strokes",
                         .group = "Reference",
                         .run = [&editor] { app::remove_strokes(editor.document); },
                         .enabled = painted,
                         .tip = "Takes all strokes away: blood is what is new since the baseline then",
                         .missing = none});
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
    add_tool(editor, app::MeasureTool::pick_blood,
             {.id = "measure.pick_blood",
              .title = "Pick blood",
              .chord = {key_of('K'), Mods::command | Mods::shift},
              .icon = ui::Icon::eyedropper,
              .enabled = [&editor, shown] { return shown() && !editor.measure_bench().by_strokes(); },
              .tip = "Takes the colour of blood from the picture: sets redness and brightness",
              .missing = "there is no reference that can be shown, or strokes say what blood is"});
    add_tool(editor, app::MeasureTool::draw_part,
             {.id = "measure.draw_part",
              .title = "Draw part",
              .enabled =
                  [&editor] {
                      return editor.reference().video() != nullptr &&
                             editor.document.scene().reference.measure.parts.size() < most_left_out_parts;
                  },
              .tip = "Click the corners of a part of the picture that is not measured, such as a logo",
              .missing = "there is no reference, or it has as many parts as it can have"});
    add_strokes(editor);
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
