// The preset's smoke clips: a list with pictures, and below it how the selected one is used. Videos dropped here are
// added.
#include <algorithm>
#include <array>
#include <cmath>

#include "app/base/file_chooser.h"
#include "app/base/layouts.h"
#include "app/clips/keying_bench.h"
#include "app/editor.h"
#include "app/files/files.h"
#include "lapfx/authoring/clip_roles.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/authoring/smoke_notes.h"
#include "panels/clip_parameters.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/table_rows.h"
#include "ui/core/node.h"
#include "ui/shell/progress.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/param.h"
#include "ui/widgets/rows.h"
#include "ui/widgets/section.h"

namespace lapfx::panels {

namespace {

using app::ClipFacts;
using document::Content;
using ui::Icon;
using ui::Mods;

const std::vector<SmokeClip>& clips_of(const document::Document& document) {
    return document.preset().smoke.clips;
}

std::string file_name(const std::string& file) {
    return std::filesystem::path(file).filename().string();
}

std::string playing_text(const ClipStatus& status) {
    const int share = status.frames > 0 ? 100 * status.resident / status.frames : 0;
    std::string text = share >= 100 ? "all in graphics memory" : std::to_string(share) + " % in graphics memory";
    if (status.misses > 0)
        text += ", " + std::to_string(status.misses) + (status.misses == 1 ? " frame came late" : " frames came late");
    if (status.broken > 0) text += ", " + std::to_string(status.broken) + " broken frames";
    return text;
}

// --- changing the list -----------------------------------------------------------------------------------------------

void remove_clip(document::Document& document, app::ClipShelf& shelf) {
    const std::size_t number = shelf.selected;
    document.change("Remove clip", [&](Content& c) {
        c.preset.smoke.clips.erase(c.preset.smoke.clips.begin() + static_cast<std::ptrdiff_t>(number));
    });
    if (shelf.selected > 0 && shelf.selected >= clips_of(document).size()) --shelf.selected;
}

void duplicate_clip(document::Document& document, app::ClipShelf& shelf) {
    const std::size_t number = shelf.selected;
    document.change("Duplicate clip", [&](Content& c) {
        auto& clips = c.preset.smoke.clips;
        const SmokeClip copy = clips[number];
        clips.insert(clips.begin() + static_cast<std::ptrdiff_t>(number) + 1, copy);
    });
    shelf.selected = number + 1;
}

void move_clip(document::Document& document, app::ClipShelf& shelf, int by) {
    const std::size_t from = shelf.selected, to = from + static_cast<std::size_t>(by);
    document.change(by < 0 ? "Move clip up" : "Move clip down",
                    [&](Content& c) { std::swap(c.preset.smoke.clips[from], c.preset.smoke.clips[to]); });
    shelf.selected = to;
}

void ask_for_clips(app::FileChooser& chooser, app::Files& files) {
    chooser.ask(clip_request("Add smoke clips", true),
                [&files](const std::vector<std::string>& chosen) { files.bring_clips(chosen); });
}

void ask_for_another(app::FileChooser& chooser, app::ClipShelf& shelf) {
    chooser.ask(clip_request("Another file for this clip", false),
                [&shelf](const std::vector<std::string>& files) { shelf.add(files, shelf.selected); });
}

// --- the list --------------------------------------------------------------------------------------------------------

constexpr float weight_width = 7.5F, alone_width = 3.6F;  // em

struct ClipLook {
    ui::ImageHandle image = 0;
    std::string_view title, facts, playing;
    bool wrong = false, warned = false, ringed = false;
    bool left_out = false;  ///< another one smokes alone
};

void draw_clip(ui::Painter& painter, const ui::Node& node, const ClipLook& look) {
    const ui::Theme& t = painter.theme();
    ui::draw_item_ground(painter, node, look.ringed);
    ui::Rect rect = node.rect().inset(painter.em(0.4F), painter.em(0.35F));
    rect.cut_right(painter.em(alone_width + weight_width + 0.8F));
    const ui::Rect picture = rect.cut_left(std::round(rect.h * 16 / 9));
    rect.cut_left(painter.em(0.6F));
    if (look.image != 0) {
        painter.image(picture, look.image);
    } else {
        painter.fill(picture, t.canvas);
        painter.icon(picture.inset(picture.w * 0.38F, picture.h * 0.3F), look.wrong ? Icon::error : Icon::image,
                     look.wrong ? t.error : t.text_disabled);
    }
    const float line = std::floor(rect.h / 3);
    ui::Rect title = rect.cut_top(line);
    if (look.wrong || look.warned) {
        painter.icon(title.cut_right(line).inset(painter.em(0.1F)), look.wrong ? Icon::error : Icon::warning,
                     look.wrong ? t.error : t.warning);
    }
    painter.text(title, look.title, painter.text_style(), look.left_out ? t.text_disabled : t.text);
    painter.text(rect.cut_top(line), look.facts, painter.text_style(0.86F), look.wrong ? t.error : t.text_dim);
    painter.text(rect, look.playing, painter.text_style(0.86F), t.text_dim);
}

ClipLook look_of(ui::Ui& ui, const app::ClipShelf& shelf, const SmokeClip& clip, std::size_t number) {
    const ClipFacts& facts = shelf.of(number);
    const std::vector<std::string>& faults = shelf.faults(number);
    ClipLook look{.image = facts.thumbnail, .title = ui.copy(file_name(clip.file)), .facts = {}, .playing = {}};
    look.wrong = !faults.empty();
    look.warned = shelf.outside(number) || !facts.report.warning.empty();
    if (look.wrong)
        look.facts = ui.copy(faults.front());
    else if (facts.known)
        look.facts = facts.summary;
    else
        look.facts = facts.job && !facts.job->cancelled() ? "reading the file" : "not read yet";
    look.left_out = shelf.alone() && *shelf.alone() != number;
    if (look.left_out)
        look.playing = "not shown: another clip is alone";
    else if (const ClipStatus* status = shelf.playing(number))
        look.playing = ui.copy(std::string(row_of(clip.role).key) + ", " + playing_text(*status));
    else
        look.playing = ui.join({row_of(clip.role).key, ", not in the preview"});
    return look;
}

/// Shows the clip without the others, until it is pressed again.
void alone_toggle(ui::Ui& ui, app::ClipShelf& shelf, std::size_t number) {
    bool alone = shelf.alone() == number;
    if (ui::toggle(ui, "Solo", alone,
                   {.tip = "Shows only this clip's smoke, in the preview alone: preset and exports stay as they are. "
                           "Pressed again, all clips are shown",
                    .quiet = !alone,
                    .width = ui::px(ui.em(alone_width))}))
        shelf.play_alone(alone ? std::optional(number) : std::nullopt);
}

void list_item(ui::Ui& ui, app::ClipShelf& shelf, const Edited& edited, ui::RowList& list, std::size_t number,
               float height) {
    ui.push_seed(number);
    const ClipLook look = look_of(ui, shelf, clips_of(edited.document)[number], number);
    ui::Node& node = ui.open(ui::Role::list_item, "##clip", ui::Axis::x, ui::RowList::item_sense);
    node.size[0] = ui::grow(), node.size[1] = ui::px(height);
    node.cross = ui::ChildAlign::center, node.main = ui::ChildAlign::end;
    node.padding[2] = static_cast<std::uint8_t>(ui.em(0.5F));
    node.label = ui.join({ui.copy(std::to_string(number + 1)), " ", look.title});
    node.text = ui.join({look.title, ", ", look.facts, ", ", look.playing});
    node.tip = ui.join({node.text, "\nWhat is not in graphics memory is decoded while it plays"});
    list.respond(number, node);
    ClipLook drawn = look;
    drawn.ringed = list.ringed(number);
    ui.draw_with<draw_clip>(node, drawn);

    alone_toggle(ui, shelf, number);
    const Parameter& row = *clip_table().find_row("weight");
    double weight = clips_of(edited.document)[number].weight;
    ui::ParamOptions options = param_options(row);
    options.standard = edited.saved.clip(number).weight;
    options.initial = SmokeClip{}.weight;
    options.width = ui::px(ui.em(weight_width));
    const ui::Edit edit = ui::number_field(ui, "Weight", weight, options);
    edited.document.take(edit, "Weight", [&](Content& c) { c.preset.smoke.clips[number].weight = weight; });
    ui.close();
    ui.pop_seed();
}

void clip_list(ui::Ui& ui, app::ClipShelf& shelf, const Edited& edited, ui::CommandTable& commands) {
    const std::size_t count = clips_of(edited.document).size();
    const float height = ui.em(4.4F);
    const auto key = [](std::size_t i) { return static_cast<std::uint64_t>(i); };
    const ui::RowList::KeyOf key_of = key;
    auto& selection = ui.memory<ui::Selection>(ui.id_of("List"));
    if (selection.current != shelf.selected || selection.keys.size() != 1) selection.only(shelf.selected);
    const float shown = std::min(static_cast<float>(count), 4.5F);
    const ui::RowList::KeyOf& keys = key_of;
    ui::RowList list(ui, "List", selection, keys,
                     {.count = count,
                      .line_height = height,
                      .area = {.height = ui::px(std::round(shown * height)),
                               .role = ui::Role::list,
                               .sense = ui::Sense::erase,
                               .tip = "The clips of this preset; drop smoke videos here to add them"}});
    bool removes = false;
    ui.events_of(list.area().id(), [&](const ui::Event& event) {
        removes |= event.kind == ui::EventKind::key && event.key == ui::Key::del;
    });
    for (std::size_t i = list.first(); i < std::min(list.last(), count); ++i)
        list_item(ui, shelf, edited, list, i, height);
    const ui::RowEvents& events = list.events();
    if (events.selected && selection.current < count) shelf.selected = selection.current;
    if (events.opened != ui::no_row) commands.run("clip.bench");
    if (removes) commands.run("clip.remove");
}

// --- what is wrong ---------------------------------------------------------------------------------------------------

void fault_line(ui::Ui& ui, std::string_view text, ui::Tone tone) {
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::start});
    ui::label(ui, text, {.tone = tone, .wrap = true, .width = ui::grow()});
}

void refused_files(ui::Ui& ui, app::ClipShelf& shelf) {
    if (shelf.refused().empty()) return;
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::start});
    {
        const ui::Column faults(ui, {.width = ui::grow()});
        for (const Fault& fault : shelf.refused())
            ui::label(ui, ui.copy("Not added: " + fault.text()),
                      {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    }
    if (ui::icon_button(ui, Icon::cross, "Dismiss", {.quiet = true})) shelf.forget_refused();
}

void work_in_hand(ui::Ui& ui, app::ClipShelf& shelf) {
    if (!shelf.work()) return;
    if (ui::progress(ui, shelf.work()->name(), shelf.work()->progress(), {.cancellable = true})) shelf.cancel_work();
}

/// What is wrong with the selected clip, and what can be done about it.
void clip_faults(ui::Ui& ui, app::ClipShelf& shelf, app::FileChooser& chooser, ui::CommandTable& commands) {
    const std::size_t number = shelf.selected;
    for (const std::string& fault : shelf.faults(number)) fault_line(ui, fault, ui::Tone::error);
    const ClipFacts& facts = shelf.of(number);
    if (!facts.report.warning.empty()) fault_line(ui, facts.report.warning, ui::Tone::warning);
    const bool outside = shelf.outside(number), can_copy = chooser.takes_files(shelf.home());
    if (outside) {
        const std::string home = shelf.home().string();
        fault_line(ui,
                   ui.copy(home.empty() ? "This file is not next to the preset, which is not saved yet: save the "
                                          "preset, and its clips are copied with it."
                           : can_copy   ? "This file is outside the preset's folder, " + home +
                                            ": a simulator would not find it."
                                      : "This file is outside the preset's folder, " + home +
                                            ", and nothing can be copied there: save the preset in a folder of your "
                                            "own, and its clips are copied with it."),
                   ui::Tone::warning);
    }
    const bool stopped = facts.job && facts.job->cancelled();
    const bool lost = !facts.known && (!facts.faults.empty() || stopped);
    if (!outside && !lost) return;
    const ui::Row row(ui);
    if (outside) ui::command_button(ui, commands, can_copy ? "clip.copy" : "file.save_as");
    if (lost && ui::button(ui, "Choose file...", {.icon = Icon::folder, .tip = "Use another file instead"}))
        ask_for_another(chooser, shelf);
    if (lost && ui::button(ui, "Look again", {.tip = "Checks whether the file is there now"})) shelf.look_again();
}

// --- the selected clip -----------------------------------------------------------------------------------------------

/// Both ends of what is played, in one row; where `out` is 0, the end of the clip.
void in_and_out(ui::Ui& ui, const Edited& edited, const SmokeClip& clip, double duration, std::size_t number) {
    double low = std::min(clip.in, duration), high = clip.out > 0 ? std::min(clip.out, duration) : duration;
    const SmokeClip& saved = edited.saved.clip(number);
    const std::array<double, 2> initials{0, duration};
    const std::array<double, 2> standards{std::min(saved.in, duration),
                                          saved.out > 0 ? std::min(saved.out, duration) : duration};
    const ui::Edit edit = ui::range_param(ui, "In and out", low, high,
                                          {.minimum = 0,
                                           .maximum = duration,
                                           .hard_minimum = 0,
                                           .hard_maximum = duration,
                                           .step = 0.1,
                                           .unit = "s",
                                           .initials = initials,
                                           .tip = "The part of the clip that is played in a loop"},
                                          standards);
    edited.document.take(edit, "In and out", [&](Content& c) {
        SmokeClip& to = c.preset.smoke.clips[number];
        to.in = low < high ? low : std::max(0.0, high - 0.1);
        to.out = high >= duration ? 0.0 : std::max(high, to.in + 1e-3);
    });
}

void file_row(ui::Ui& ui, app::ClipShelf& shelf, app::FileChooser& chooser, const SmokeClip& clip) {
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui.parent().padding[0] = static_cast<std::uint8_t>(ui.em(0.35F));  // like the captions below
    ui::label(ui, "File", {.width = ui::fraction(0.45F)});
    ui::label(ui, clip.file, {.tone = ui::Tone::dim, .path = true, .width = ui::grow()});
    if (ui::icon_button(ui, Icon::folder, "Replace file...", {.tip = "Use another file instead of this one"}))
        ask_for_another(chooser, shelf);
}

void clip_rows(ui::Ui& ui, app::ClipShelf& shelf, const Edited& edited, ui::CommandTable& commands,
               const SmokeClip& clip, std::size_t number) {
    static const SmokeClip standard;
    const auto in = [number](Content& c) -> void* {
        return number < c.preset.smoke.clips.size() ? &c.preset.smoke.clips[number] : nullptr;
    };
    const double duration = shelf.of(number).report.duration;
    const ui::Section section(ui, "Use");
    if (!section) return;
    file_row(ui, shelf, edited.chooser, clip);
    for (const Parameter& row : clip_table().rows) {
        if (row.key == "out" && duration > 0) continue;  // with "in"
        if (row.key == "in" && duration > 0) {
            in_and_out(ui, edited, clip, duration, number);
            continue;
        }
        if (row.kind == Kind::path || row.kind == Kind::boolean) continue;  // the file above, own keying below
        table_row(ui, edited, row, in, {.standard = &standard, .saved = &edited.saved.clip(number)});
    }
    ui::command_button(ui, commands, "clip.source");
}

void own_keying(ui::Ui& ui, const Edited& edited, ui::CommandTable& commands, const SmokeClip& clip,
                std::size_t number) {
    const ui::Section section(ui, "Keying of this clip", {.open = false});
    if (!section) return;
    bool own = clip.own_keying;
    const ui::Edit edit =
        ui::checkbox(ui, "Own keying", own, "This clip has thresholds of its own; otherwise the preset's are used");
    edited.document.take(edit, "Own keying", [&](Content& c) {
        SmokeClip& to = c.preset.smoke.clips[number];
        if (own) to.keying = c.preset.smoke.keying;  // begins with the keying that is in use now
        to.own_keying = own;
    });
    ui::command_button(ui, commands, "clip.bench");
    if (!own || !clips_of(edited.document)[number].own_keying) {
        ui::label(ui, "This clip uses the preset's keying.", {.tone = ui::Tone::dim});
        return;
    }
    const auto in = [number](Content& c) -> void* {
        return number < c.preset.smoke.clips.size() ? &c.preset.smoke.clips[number].keying : nullptr;
    };
    static const KeyingParameters standard;
    for (const Parameter& row : keying_table().rows)
        table_row(ui, edited, row, in, {.standard = &standard, .saved = &edited.saved.keying(number)});
}

void nothing_yet(ui::Ui& ui) {
    ui::label(ui, "This preset has no smoke clip: cautery makes no smoke.", {.wrap = true, .width = ui::grow()});
    ui::label(ui, "Drop smoke videos here, or add them with the button above.",
              {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
}

/// Kinds of smoke that no clip shows.
void left_out(ui::Ui& ui, const document::Document& document) {
    for (const std::string& note : smoke_notes(document.preset().smoke))
        ui::label(ui, ui.copy(upper_first(note) + "."), {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
}

/// Files dropped anywhere on the panel.
void take_drops(ui::Ui& ui, app::Files& files) {
    ui::Node& panel = ui.parent();
    panel.sense = panel.sense | ui::Sense::drop;
    ui.events_of(panel.id, [&](const ui::Event& event) {
        if (event.kind != ui::EventKind::drop) return;
        if (const auto dropped = dropped_files(event.paths); !dropped.empty()) files.bring_clips(dropped);
    });
}

}  // namespace

void clips_panel(ui::Ui& ui, app::ClipShelf& shelf, const Edited& edited, app::Files& files,
                 ui::CommandTable& commands) {
    take_drops(ui, files);
    {
        const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        ui::command_button(ui, commands, "clip.add");
        ui::spacer(ui);
        for (const char* id : {"clip.up", "clip.down", "clip.duplicate", "clip.remove"})
            ui::command_button(ui, commands, id, true);
    }
    work_in_hand(ui, shelf);
    refused_files(ui, shelf);
    if (clips_of(edited.document).empty()) return nothing_yet(ui);
    clip_list(ui, shelf, edited, commands);
    left_out(ui, edited.document);
    const std::size_t number = shelf.selected;
    if (number >= clips_of(edited.document).size()) return;
    ui.push_seed(number);
    {
        const ui::ScrollArea area(ui, "Selected clip", {.gap = 0.3F});
        clip_faults(ui, shelf, edited.chooser, commands);
        const SmokeClip clip = clips_of(edited.document)[number];
        clip_rows(ui, shelf, edited, commands, clip, number);
        own_keying(ui, edited, commands, clip, number);
    }
    ui.pop_seed();
}

void add_clip_commands(app::Editor& editor) {
    app::ClipShelf& shelf = editor.clips();
    const auto any = [&editor, &shelf] { return shelf.selected < clips_of(editor.document).size(); };
    const auto add = [&](std::string id, std::string title, ui::Chord chord, Icon icon, std::function<void()> run,
                         std::function<bool()> enabled, std::string missing, std::string tip) {
        editor.commands.add({.id = std::move(id),
                             .title = std::move(title),
                             .group = "Smoke",
                             .chord = chord,
                             .icon = icon,
                             .run = std::move(run),
                             .enabled = std::move(enabled),
                             .tip = std::move(tip),
                             .missing = std::move(missing)});
    };
    add(
        "clip.add", "Add clip...", {ui::key_of('A'), Mods::command | Mods::shift}, Icon::plus,
        [&editor] { ask_for_clips(editor.chooser(), editor.files()); }, {}, "", "Smoke videos for this preset");
    add(
        "clip.replace", "Replace file...", {}, Icon::folder,
        [&editor, &shelf] { ask_for_another(editor.chooser(), shelf); }, any, "no clip is selected",
        "Use another file for the selected clip");
    add(
        "clip.duplicate", "Duplicate clip", {}, Icon::copy,
        [&editor, &shelf] { duplicate_clip(editor.document, shelf); }, any, "no clip is selected",
        "Adds the selected clip once more; it starts elsewhere in the loop, so the two look different");
    add(
        "clip.remove", "Remove clip", {}, Icon::cross, [&editor, &shelf] { remove_clip(editor.document, shelf); }, any,
        "no clip is selected", "Removes the selected clip from the preset; its file stays");
    add(
        "clip.up", "Move clip up", {}, Icon::chevron_up, [&editor, &shelf] { move_clip(editor.document, shelf, -1); },
        [&shelf, any] { return any() && shelf.selected > 0; }, "there is no clip above the selected one",
        "The first clips of the list are kept in graphics memory first");
    add(
        "clip.down", "Move clip down", {}, Icon::chevron_down,
        [&editor, &shelf] { move_clip(editor.document, shelf, 1); },
        [&editor, &shelf] { return shelf.selected + 1 < clips_of(editor.document).size(); },
        "there is no clip below the selected one", "The first clips of the list are kept in graphics memory first");
    add(
        "clip.copy", "Copy clips next to the preset", {}, Icon::copy, [&shelf] { shelf.copy_beside(); },
        [&editor, &shelf] { return shelf.any_outside() && editor.chooser().takes_files(shelf.home()); },
        "all clips are in the preset's folder, or nothing can be copied there",
        "Copies clips from elsewhere into the preset's folder, and uses the copies");
    editor.commands.add(
        {.id = "clip.solo",
         .title = "Solo clip",
         .group = "Smoke",
         .chord = {ui::key_of('S'), Mods::shift},
         .icon = Icon::eye,
         .run = [&shelf] { shelf.play_alone(shelf.alone() ? std::nullopt : std::optional(shelf.selected)); },
         .enabled = [&shelf, any] { return shelf.alone().has_value() || any(); },
         .checked = [&shelf] { return shelf.alone().has_value(); },
         .tip = "Shows only the selected clip's smoke; again, all clips are shown",
         .missing = "no clip is selected"});
    add(
        "clip.bench", "Show in keying bench", {}, Icon::eye, [&editor] { editor.layouts().bring_to_front("Keying"); },
        any, "no clip is selected", "Source, matte, keyed and composite picture of the selected clip");
    add(
        "clip.suggest", "Suggest keying", {ui::key_of('K'), Mods::command}, Icon::star,
        [&editor] { editor.keying().suggest(); },
        [&editor, &shelf] { return shelf.of(shelf.selected).known && !editor.keying().suggesting(); },
        "no clip that could be read is selected, or thresholds are being looked for",
        "Finds thresholds, bars and logos for the selected clip");
    add(
        "clip.suggest_all", "Suggest keying for all clips", {}, Icon::star,
        [&editor] { editor.keying().suggest(app::KeyingBench::For::all); },
        [&editor, &shelf] { return shelf.of(shelf.selected).known && !editor.keying().suggesting(); },
        "no clip that could be read is selected, or thresholds are being looked for",
        "Finds thresholds in the selected clip, and uses them for all clips without keying of their own");
    add(
        "clip.source", "Find the smoke's source", {}, Icon::star, [&editor] { editor.keying().find_source(); },
        [&editor, &shelf] { return shelf.of(shelf.selected).known && !editor.keying().finding_source(); },
        "no clip that could be read is selected, or its source is being looked for",
        "Where in the frame the selected clip's smoke starts: this point is placed at the tool tip");
    editor.commands.add({.id = "clip.eyedropper",
                         .title = "Eyedropper",
                         .group = "Smoke",
                         .chord = {ui::key_of('K'), Mods::none},
                         .icon = Icon::eyedropper,
                         .run = [&editor] { editor.keying().set_eyedropper(!editor.keying().look.eyedropper); },
                         .enabled = [&editor] { return editor.keying().shown() && editor.keying().ready(); },
                         .checked = [&editor] { return editor.keying().look.eyedropper; },
                         .tip = "Takes the key colour from the source picture",
                         .missing = "the Keying panel shows no picture"});
}

}  // namespace lapfx::panels
