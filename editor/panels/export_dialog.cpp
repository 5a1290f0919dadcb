// What is exported, to which file, and what is wrong with that: one dialog for all kinds. While an export runs it shows
// the progress; so does the status bar, since the dialog can be closed.
#include <array>
#include <cmath>

#include "app/base/file_chooser.h"
#include "app/base/file_filters.h"
#include "app/editor.h"
#include "app/files/exports.h"
#include "panels/panels.h"
#include "ui/shell/dialog.h"
#include "ui/shell/progress.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/literal.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/text_field.h"

namespace lapfx::panels {

namespace {

using app::ExportForm;
using app::Exports;
using output::OutputKind;

constexpr std::string_view dialog_name = "export", replace_name = "export replace";
constexpr double longest_time = 86'400;  // s

void open(app::Editor& editor, OutputKind kind) {
    editor.exports().propose(kind);
    ui::open_dialog(editor.ui(), dialog_name);
}

/// What is wrong in one place, below it.
void fault_line(ui::Ui& ui, Exports& exports, std::string_view place) {
    const std::string_view reason = exports.fault_at(place);
    if (!reason.empty()) ui::label(ui, reason, {.tone = ui::Tone::error, .wrap = true});
}

ui::FileRequest request_for(const ExportForm& form) {
    const std::string_view path = form.file();
    ui::FileRequest request{.task = ui::FileTask::save,
                            .title = Exports::title(form.what()),
                            .folder = std::string(ui::parent_of(path)),
                            .name = std::string(ui::name_of_path(path))};
    const output::OutputRow& row = output::row_of(form.what());
    if (row.content)
        request.filters = {app::written_filter(std::string(row.files), *row.content)};
    else
        request.task = ui::FileTask::folder;
    return request;
}

/// A path has the whole width, so that its end is seen.
void path_row(ui::Ui& ui, const ExportForm& form, app::FileChooser& chooser, std::string_view label, std::string& path,
              std::string_view tip, bool invalid) {
    const ui::Column column(ui, {.width = ui::grow(), .gap = 0.15F});
    const std::string_view lower = label == "Folder" ? "folder" : label == "Table" ? "table" : "file";
    ui::label(ui, ui.join({"To this ", lower}), {.tone = ui::Tone::dim});
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::text_field(ui, label, path, {.tip = tip, .invalid = invalid});
    const bool amounts = &path == &form.amounts_file;
    if (!ui::icon_button(ui, ui::Icon::folder, ui.join({"Browse for ", label}))) return;
    ui::FileRequest request = request_for(form);
    if (amounts)
        request = {.task = ui::FileTask::save,
                   .title = "Amounts",
                   .folder = std::string(ui::parent_of(path)),
                   .name = std::string(ui::name_of_path(path)),
                   .filters = {{"Tables", {".csv"}}}};
    const bool folder = request.task == ui::FileTask::folder;
    chooser.ask(std::move(request), [&path, folder](const std::vector<std::string>& chosen) {
        path = folder ? chosen.front() + "/" + std::string(ui::name_of_path(path)) : chosen.front();
    });
}

void file_rows(ui::Ui& ui, Exports& exports, app::FileChooser& chooser) {
    ExportForm& form = exports.form;
    const std::string_view label = form.what() == OutputKind::bundle ? "Folder" : "File";
    std::string_view tip = output::row_of(form.what()).help;
    if (form.what() == OutputKind::video) tip = ui.join({tip, ": ", listed(Content::video, " or ", true)});
    path_row(ui, form, chooser, label, form.file(), tip, !exports.fault_at("-o").empty());
    fault_line(ui, exports, "-o");
    if (exports.fault_at("-o").empty() && exports.replaces())
        ui::label(ui,
                  form.what() == OutputKind::bundle ? "This folder contains a bundle, which will be replaced"
                                                    : "A file of this name exists and will be replaced",
                  {.tone = ui::Tone::warning});
}

void size_rows(ui::Ui& ui, Exports& exports) {
    static constexpr auto names = [] {
        std::array<std::string_view, app::export_sizes.size()> all{};
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = app::export_sizes[i].name;
        return all;
    }();
    ExportForm& form = exports.form;
    const glm::ivec2 before = form.px();
    if (ui::combo(ui, "Size", form.size, names, {.tip = "Width and height in pixels", .caption = true}).changed &&
        form.size == static_cast<int>(names.size()) - 1) {
        form.width = before.x;
        form.height = before.y;
    }
    if (form.size == static_cast<int>(names.size()) - 1) {
        ui::ParamOptions side{
            .minimum = 16, .maximum = 4096, .hard_minimum = 1, .hard_maximum = 16384, .step = 2, .unit = "px"};
        side.tip = "Of the picture, in pixels; must be even for a video";
        ui::param(ui, "Width", form.width, side);
        ui::param(ui, "Height", form.height, side);
    }
    fault_line(ui, exports, "--size");
}

void time_param(ui::Ui& ui, std::string_view label, double& value, double duration, std::string_view tip) {
    ui::param(
        ui, label, value,
        {.maximum = duration, .hard_minimum = 0, .hard_maximum = longest_time, .step = 0.1, .unit = "s", .tip = tip});
    value = app::shown_time(value);
}

void time_rows(ui::Ui& ui, Exports& exports) {
    ExportForm& form = exports.form;
    if (form.what() == OutputKind::picture) {
        time_param(ui, "Time", form.at, exports.duration(), "Time in the scene; the view's time to start with");
        return fault_line(ui, exports, "--at");
    }
    time_param(ui, "From", form.from, exports.duration(), "Time of the first frame");
    fault_line(ui, exports, "--from");
    time_param(ui, "To", form.to, exports.duration(), "The end; the last frame is before it");
    fault_line(ui, exports, "--to");
    ui::param(ui, "Frame rate", form.fps,
              {.minimum = 1,
               .maximum = 60,
               .hard_minimum = 0.1,
               .hard_maximum = 1000,
               .step = 1,
               .unit = "fps",
               .standard = 25,
               .tip = "Frames per second, of the scene and of the video"});
    fault_line(ui, exports, "--fps");
}

template <std::size_t count>
std::array<std::string_view, count> titles_of(const auto& rows) {
    std::array<std::string_view, count> titles;
    for (std::size_t i = 0; i < count; ++i) titles[i] = rows[i].title;
    return titles;
}

/// What a video is compressed with.
void codec_rows(ui::Ui& ui, Exports& exports) {
    ExportForm& form = exports.form;
    if (form.what() != OutputKind::video) return;
    const auto codecs = titles_of<output::codec_count>(output::codec_rows());
    ui::combo(ui, "Codec", form.codec, codecs, {.tip = output::row_of(form.coded()).help, .caption = true});
    fault_line(ui, exports, "--codec");
    if (output::row_of(form.coded()).lossless) return;
    const auto qualities = titles_of<output::quality_count>(output::quality_rows());
    const std::string_view tip = output::row_of(static_cast<output::Quality>(form.quality)).help;
    ui::combo(ui, "Quality", form.quality, qualities, {.tip = tip, .caption = true});
}

void extra_rows(ui::Ui& ui, Exports& exports, app::FileChooser& chooser) {
    ExportForm& form = exports.form;
    ui::checkbox(ui, "Beside the reference, with curves", form.beside,
                 "The surgery video beside each picture, and below them how much blood and veil both show over time: "
                 "what one sends to a colleague");
    fault_line(ui, exports, "--beside");
    if (exports.overlaid())
        ui::checkbox(ui, "With the overlay", form.overlay, "With the colours that the view shows over the tissue");
    ui::checkbox(
        ui, "Amounts as a table", form.amounts,
        "A CSV file with blood area and volume, wounds and haze of each frame, by which a trainee could be scored");
    if (!form.amounts) return;
    path_row(ui, form, chooser, "Table", form.amounts_file, "The file for the amounts (.csv)",
             !exports.fault_at("--amounts").empty());
    fault_line(ui, exports, "--amounts");
}

/// "40 s", "3 min", "1.5 h": as exactly as a trial tells it.
std::string_view rough_duration(ui::Ui& ui, double seconds) {
    constexpr double minute = 60, hour = 3600;
    char text[32];
    if (seconds < 2 * minute)
        std::snprintf(text, sizeof text, "%.0f s", std::max(std::ceil(seconds), 1.0));
    else if (seconds < 2 * hour)
        std::snprintf(text, sizeof text, "%.0f min", std::round(seconds / minute));
    else
        std::snprintf(text, sizeof text, "%.1f h", seconds / hour);
    return ui.copy(text);
}

/// What the export will take, once a few frames have been tried.
std::string_view time_text(ui::Ui& ui, Exports& exports) {
    if (const double due = exports.want_estimate(); std::isfinite(due))
        ui.wake_at(due, "the time of an export is tried");
    const double seconds = exports.seconds_expected();
    if (seconds < 0) return "";
    return ui.join({" Takes about ", rough_duration(ui, seconds),
                    exports.form.beside && exports.comparable() ? ", once both are measured." : "."});
}

/// What the export will write, in words.
std::string_view summary(ui::Ui& ui, Exports& exports) {
    const ExportForm& form = exports.form;
    char text[128];
    const int frames = exports.frames();
    const glm::ivec2 px = exports.written_px();
    switch (form.what()) {
        case OutputKind::preset:
            return "The preset as it is now, saved or not.";
        case OutputKind::bundle:
            return form.with_scene ? "Opens on any computer: preset, clips, scene, organ and tool. The reference video "
                                     "is not copied."
                                   : "All that a simulator needs: the preset and its clips.";
        case OutputKind::picture:
            std::snprintf(text, sizeof text, "%d x %d pixels through the scene's camera.", px.x, px.y);
            return ui.copy(text);
        default:
            std::snprintf(text, sizeof text, "%d frames of %d x %d pixels, %.2f s.", frames, px.x, px.y,
                          frames / form.fps);
    }
    return ui.join({ui.copy(text), time_text(ui, exports)});
}

/// What a bundle copies from elsewhere, and whether it may.
void outside_rows(ui::Ui& ui, Exports& exports) {
    if (exports.outside().empty()) return;
    const ui::Column column(ui, {.width = ui::grow(), .gap = 0.2F});
    const std::string home = exports.home().string();
    ui::literal(ui,
                home.empty() ? std::string("A bundle needs copies of these files:")
                             : "A bundle needs copies of these files, which are outside the folder " + home + ":",
                ui::Tone::warning);
    for (const output::SourceFile& source : exports.outside())
        ui::literal(ui, source.what + ": " + source.file.string());
    ui::checkbox(ui, "Copy these files", exports.form.outside_agreed,
                 "Whoever gets the bundle gets these files. Not checked, nothing is exported");
    fault_line(ui, exports, "outside");
}

void form_rows(ui::Ui& ui, Exports& exports, app::FileChooser& chooser) {
    ExportForm& form = exports.form;
    const ui::ScrollArea area(ui, "Form", {.gap = ui.theme().gap});
    file_rows(ui, exports, chooser);
    if (form.what() == OutputKind::bundle)
        ui::checkbox(ui, "With scene and organ", form.with_scene,
                     "Includes what is needed to open it in the editor as it is now; a simulator does not need it");
    outside_rows(ui, exports);
    if (form.renders()) {
        size_rows(ui, exports);
        time_rows(ui, exports);
        codec_rows(ui, exports);
        extra_rows(ui, exports, chooser);
    }
    fault_line(ui, exports, "scene");
    fault_line(ui, exports, "preset");
    fault_line(ui, exports, "clips");
    if (form.what() == OutputKind::preset && !exports.fault_at("clips").empty() &&
        ui::button(ui, "Make a bundle instead", {.tip = "A folder with the preset and copies of its clips"}))
        form.kind = static_cast<int>(OutputKind::bundle);
    ui::label(ui, summary(ui, exports), {.tone = ui::Tone::dim, .wrap = true});
}

void copy_command(ui::Ui& ui, const Exports& exports, app::Notices& notices) {
    try {
        const std::string line = exports.command();
        if (ui.clipboard() != nullptr) ui.clipboard()->set(line);
        notices.add({.kind = ui::ToastKind::good, .text = "Copied the command"});
    } catch (const Error& error) {
        notices.tell(error);
    }
}

/// What runs, and what can be done meanwhile.
void running_rows(ui::Ui& ui, Exports& exports) {
    if (!exports.running()) return;
    if (ui::progress(
            ui, ui.join({"Exporting ", exports.name()}), exports.progress(),
            {.seconds_left = exports.seconds_left(), .cancellable = true, .text = ui.copy(exports.progress_text())}))
        exports.cancel();
    ui::label(ui,
              "You can keep working meanwhile. A preset can be exported at once, the rest when this export is done.",
              {.tone = ui::Tone::dim, .wrap = true});
    ui::separator(ui);
}

void ask_replace(ui::Ui& ui, Exports& exports) {
    const std::string_view name = ui::name_of_path(exports.form.file());
    const auto answer =
        ui::ask(ui, replace_name, "Replace it?",
                ui.join({name, output::row_of(exports.form.what()).numbered
                                   ? ": pictures of this name exist. Those with the same numbers will be replaced."
                                   : " exists and will be replaced once the new one is complete."}),
                {{.label = "Cancel", .cancel = true}, {.label = "Replace"}}, ui::Tone::warning);
    if (answer == 1U) exports.start();
    // If the export was refused, the form says why: files may have changed while the question was open.
    if (answer == 0U || (answer == 1U && !exports.faults().empty())) ui::open_dialog(ui, dialog_name);
}

std::string_view why_not(ui::Ui& ui, Exports& exports) {
    if (!exports.faults().empty()) return ui.join({"Not possible yet: ", exports.faults().front().reason});
    if (exports.waits()) return ui.join({"Not possible yet: ", exports.name(), " is being exported"});
    return "Writes the file and reads it back to check it";
}

}  // namespace

void export_dialog(ui::Ui& ui, Exports& exports, app::FileChooser& chooser, app::Notices& notices) {
    ask_replace(ui, exports);
    ui::Dialog dialog(ui, dialog_name, "New export", {.width = 38, .height = 40});
    if (!dialog) return;
    running_rows(ui, exports);
    ui::segmented(ui, "What", exports.form.kind, output::output_titles());
    form_rows(ui, exports, chooser);
    const bool sound = exports.faults().empty() && !exports.waits();
    if (!sound) ui::label(ui, why_not(ui, exports), {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
    if (exports.form.renders() &&
        ui::button(
            ui, "Copy lapfx render command",
            {.icon = ui::Icon::copy, .tip = "A command line that makes the same files, for scripts", .quiet = true}))
        copy_command(ui, exports, notices);
    const std::string_view leave = exports.running() ? "Close" : "Cancel";  // a running export continues
    const auto pressed =
        dialog.buttons({{.label = leave, .cancel = true},
                        {.label = "Export", .standard = true, .enabled = sound, .tip = why_not(ui, exports)}});
    if (pressed != 1U) return;
    if (exports.replaces())
        ui::open_dialog(ui, replace_name);
    else
        exports.start();
}

/// In short; the dialog says more.
void export_status(ui::Ui& ui, Exports& exports) {
    if (exports.running() && ui::progress(ui, exports.name(), exports.progress(),
                                          {.seconds_left = exports.seconds_left(),
                                           .cancellable = true,
                                           .text = exports.loading() ? "loading" : "",
                                           .width = ui::px(ui.em(20))}))
        exports.cancel();
}

void add_export_commands(app::Editor& editor) {
    using ui::key_of;
    using ui::Mods;
    editor.commands.add({.id = "export.open",
                         .title = "Export...",
                         .group = "File",
                         .chord = {key_of('E'), Mods::command},
                         .run = [&editor] { open(editor, editor.exports().form.what()); },
                         .tip = "A preset, a bundle, pictures or a video"});
    for (const output::OutputRow& row : output::output_rows())
        if (!row.command.empty())
            editor.commands.add({.id = std::string(row.command),
                                 .title = std::string(row.command_title),
                                 .group = "File",
                                 .run = [&editor, kind = row.kind] { open(editor, kind); },
                                 .tip = std::string(row.command_tip)});
    editor.commands.add({.id = "export.copy_json",
                         .title = "Copy preset as JSON",
                         .group = "File",
                         .run =
                             [&editor] {
                                 editor.clipboard()->set(write_preset(editor.document.preset()));
                                 editor.toasts.add({.kind = ui::ToastKind::good, .text = "Copied the preset as JSON"});
                             },
                         .enabled = [&editor] { return editor.clipboard() != nullptr; },
                         .tip = "For a mail or a text editor",
                         .missing = "there is no clipboard"});
}

}  // namespace lapfx::panels
