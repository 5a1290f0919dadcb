#include "app/files/files.h"

#include <algorithm>

#include "app/base/editor_options.h"
#include "app/base/file_chooser.h"
#include "app/base/file_words.h"
#include "app/base/notices.h"
#include "app/base/settings.h"
#include "app/clips/clip_shelf.h"
#include "app/files/autosave.h"
#include "app/files/exports.h"
#include "app/files/open.h"
#include "app/tuning/snapshots.h"
#include "document/words.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/letters.h"
#include "ui/shell/commands.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

/// A file name made from a preset's name: "Brisk bleed, 2" is brisk_bleed_2.
std::string file_name_of(const std::string& name, const char* otherwise) {
    std::string file;
    for (const char c : name) {
        const char small = lower(c);
        if ((small >= 'a' && small <= 'z') || (c >= '0' && c <= '9') || c == '-')
            file += small;
        else if (!file.empty() && file.back() != '_')
            file += '_';
    }
    while (!file.empty() && file.back() == '_') file.pop_back();
    return file.empty() ? otherwise : file;
}

/// The other way round, for people: my_bleed.scene.json is "My bleed".
std::string name_of_file(const fs::path& file) {
    std::string name = file.stem().string();
    if (name.ends_with(".scene")) name.resize(name.size() - 6);
    std::replace(name.begin(), name.end(), '_', ' ');
    return upper_first(std::move(name));
}

/// What the document on the disk is called; empty: there is none.
std::string name_in(const fs::path& file, bool scene) {
    if (file.empty()) return {};
    try {
        return scene ? load_scene(file).name : load_preset(file).name;
    } catch (const Error&) {
        return {};
    }
}

std::string counted(std::size_t count, const std::string& what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

}  // namespace

const fs::path& Files::file(Kind kind) const {
    return kind == Kind::scene ? parts_.document.scene_file() : parts_.document.preset_file();
}

bool Files::needs_name(Kind kind) const {
    return file(kind).empty() || parts_.chooser.shipped(file(kind));
}

// --- questions -------------------------------------------------------------------------------------------------------

void Files::ask(Question question) {
    question.serial = ++serial_;
    question_ = std::move(question);
}

void Files::answer(std::size_t index) {
    if (!question_ || index >= question_->answers.size()) return;
    const Then act = std::move(question_->answers[index].act);
    question_.reset();  // before `act`, which may ask again
    if (act) act();
    while (!question_ && !after_question_.empty()) {
        const Then next = std::move(after_question_.front());
        after_question_.erase(after_question_.begin());
        next();
    }
}

std::vector<std::string> Files::unsaved_words(bool scene_too) const {
    std::vector<std::string> words;
    const document::Document& d = parts_.document;
    const auto add = [&](Kind kind, const std::string& name, const char* what) {
        const std::string called =
            file(kind).empty() ? (name.empty() ? std::string("new") : '"' + name + '"') : in_marks(file(kind));
        words.push_back(std::string(what) + ' ' + called);
    };
    if (d.preset_unsaved()) add(Kind::preset, d.preset().name, "Preset");
    if (!scene_too) return words;  // steps do not say which of both they belong to
    if (d.scene_unsaved()) add(Kind::scene, d.scene().name, "Scene");
    // The last things that were done, in words.
    constexpr std::size_t most = 4;
    for (std::size_t i = 0; i < std::min(d.done(), most); ++i)
        words.push_back("- " + document::title_of(d.steps()[d.done() - 1 - i]));
    if (d.done() > most) words.push_back("- and " + counted(d.done() - most, "step") + " before these");
    return words;
}

/// What saving will do with files that came with the program; empty: there are none among them.
std::string Files::shipped_words(bool scene_too) const {
    const document::Document& d = parts_.document;
    const bool preset = d.preset_unsaved() && parts_.chooser.shipped(d.preset_file());
    const bool scene = scene_too && d.scene_unsaved() && parts_.chooser.shipped(d.scene_file());
    if (!preset && !scene) return {};
    const std::string names = preset && scene ? in_marks(d.preset_file()) + " and " + in_marks(d.scene_file())
                              : preset        ? in_marks(d.preset_file())
                                              : in_marks(d.scene_file());
    return ' ' + names + " came with lapfx and " + (preset && scene ? "stay unchanged" : "stays unchanged") +
           ": saving asks for a new name.";
}

void Files::ask_unsaved(std::string title, Then then, Then otherwise, bool scene_too) {
    const document::Document& d = parts_.document;
    const bool scene = scene_too && d.scene_unsaved(), both = scene && d.preset_unsaved();
    const bool names = (scene && needs_name(Kind::scene)) || (d.preset_unsaved() && needs_name(Kind::preset));
    const auto save_first = [this, then, scene_too] {
        if (scene_too)
            save_all(then);
        else
            save_preset(then);
    };
    const bool stays = !scene_too && d.scene_unsaved();
    ask({.title = std::move(title),
         .text = "These changes are not saved." + shipped_words(scene_too) +
                 (stays ? " The scene keeps its changes, whichever you choose." : ""),
         .lines = unsaved_words(scene_too),
         .answers = {
             {.label = std::string(both ? "Save all" : "Save") + (names ? " as..." : ""),
              .tip = names ? "Asks for names and saves, then continues. If that fails, everything stays as it is."
                           : "Saves them, then continues. If that fails, everything stays as it is.",
              .act = save_first,
              .standard = true},
             {.label = "Discard", .tip = "Continues without saving. The changes are lost.", .act = then},
             {.label = "Cancel", .tip = "Everything stays as it is.", .act = std::move(otherwise), .cancel = true}}});
}

void Files::ask_failed(Kind kind, const fs::path& file, const std::vector<Fault>& faults, Then then) {
    std::vector<std::string> lines;
    constexpr std::size_t most = 8;
    for (const Fault& fault : faults) {
        if (lines.size() == most) {
            lines.push_back("and " + counted(faults.size() - most, "more fault"));
            break;
        }
        lines.push_back(fault.text());
    }
    parts_.autosave.soon();
    ask({.title = in_marks(file) + " was not saved",
         .text = "Your work is still open here, and an earlier file on the disk is unchanged.",
         .lines = std::move(lines),
         .answers = {{.label = "Save as...",
                      .tip = "Choose another name or folder.",
                      .act = [this, kind, then] { save_as(kind, then); },
                      .standard = true},
                     {.label = "Try again",
                      .tip = "Tries the same file again, once the disk has room or allows writing.",
                      .act = [this, kind, file, then] { save_to(kind, file, then); }},
                     {.label = "Cancel", .tip = "Continues without saving.", .cancel = true}}});
}

void Files::ask_outside(const fs::path& file, const std::vector<std::string>& clips, Then then) {
    Question question{
        .title = "Clips are outside the preset's folder",
        .text = "A preset can only use clips in its own folder or below, so that both can be passed on together. " +
                in_marks(file) + " cannot use these:",
        .lines = clips,
        .answers = {},
        .serial = 0};
    const fs::path folder = document::folder_of(file);
    const bool copies = parts_.chooser.takes_files(folder);
    if (copies)
        question.answers.push_back(
            {.label = "Copy clips and save",
             .tip = "Copies them next to the preset, which then uses the copies.",
             .act = [this, folder, file,
                     then] { parts_.clips.copy_to(folder, [this, file, then] { save_to(Kind::preset, file, then); }); },
             .standard = true});
    else
        question.text +=
            " (Nothing can be copied into this folder: " +
            std::string(parts_.chooser.shipped(folder) ? "it came with lapfx" : "it cannot be written to") + ".)";
    const bool bundles = parts_.commands.contains("export.bundle");
    if (bundles)
        question.answers.push_back({.label = "Export as a bundle...",
                                    .tip = "A folder with the preset and copies of its clips.",
                                    .act = [this] { parts_.commands.run("export.bundle"); }});
    question.answers.push_back({.label = "Save as...",
                                .tip = "Another folder: one of your own, or one that contains the clips.",
                                .act = [this, then] { save_preset_as(then); },
                                .standard = !copies});
    question.answers.push_back({.label = "Cancel", .tip = "Continues without saving.", .cancel = true});
    ask(std::move(question));
}

// --- saving ----------------------------------------------------------------------------------------------------------

void Files::save_preset(Then then) {
    save(Kind::preset, std::move(then));
}
void Files::save_preset_as(Then then) {
    save_as(Kind::preset, std::move(then));
}
void Files::save_scene(Then then) {
    save(Kind::scene, std::move(then));
}
void Files::save_scene_as(Then then) {
    save_as(Kind::scene, std::move(then));
}

/// The preset first: the scene names its file.
void Files::save_all(Then then) {
    const auto scene = [this, then] {
        if (parts_.document.scene_unsaved()) return save_scene(then);
        if (then) then();
    };
    if (parts_.document.preset_unsaved()) return save_preset(scene);
    scene();
}

void Files::save(Kind kind, Then then) {
    const fs::path to = file(kind);
    if (needs_name(kind)) return save_as(kind, std::move(then));
    const document::OnDisk& known =
        kind == Kind::scene ? parts_.document.scene_on_disk() : parts_.document.preset_on_disk();
    const document::OnDisk now = document::OnDisk::of(to);
    // If the file no longer exists, saving does not replace anybody's work.
    if (!now.exists || now == known) return save_to(kind, to, std::move(then));
    ask({.title = in_marks(to) + " has been changed by another program",
         .text = "The file on the disk is not the one that was opened here. Saving would replace it.",
         .lines = {to.string()},
         .answers = {{.label = "Overwrite",
                      .tip = "What the other program wrote is lost.",
                      .act = [this, kind, to, then] { save_to(kind, to, then); }},
                     {.label = "Save as...",
                      .tip = "Both are kept.",
                      .act = [this, kind, then] { save_as(kind, then); },
                      .standard = true},
                     {.label = "Cancel", .tip = "Continues without saving.", .cancel = true}}});
}

void Files::save_as(Kind kind, Then then) {
    const document::Document& d = parts_.document;
    const bool scene = kind == Kind::scene;
    const fs::path now = file(kind);
    const bool ours = !now.empty() && !parts_.chooser.shipped(now);
    std::string name = now.empty() ? file_name_of(scene ? d.scene().name : d.preset().name, "untitled") +
                                         (scene ? ".scene.json" : ".json")
                                   : now.filename().string();
    parts_.chooser.ask(
        {.task = ui::FileTask::save,
         .title = scene ? "Save scene as" : "Save preset as",
         .folder = ours ? document::folder_of(now).string() : "",  // else the user's own
         .name = std::move(name),
         .filters = {{scene ? "Scenes" : "Presets", extensions(Content::document)}}},
        [this, kind, then](const std::vector<std::string>& chosen) { save_to(kind, chosen.front(), then); });
}

void Files::save_to(Kind kind, const fs::path& to, Then then) {
    parts_.document.commit();
    if (kind == Kind::preset)
        if (const auto outside = parts_.document.clips_outside(document::folder_of(to)); !outside.empty())
            return ask_outside(to, outside, std::move(then));
    const bool another = to != file(kind);
    const std::string why =
        another ? why_not_replaced(kind == Kind::scene ? FileKind::scene : FileKind::preset, to) : "";
    if (!why.empty()) return ask_failed(kind, to, {{.file = to.string(), .place = "", .reason = why}}, std::move(then));
    if (!another || lock(kind, to)) return write(kind, to, then);
    ask({.title = in_marks(to) + " is open in another editor",
         .text = "The other editor would not show what is saved here. (" + holder(to) + ')',
         .lines = {},
         .answers = {{.label = "Save anyway", .act = [this, kind, to, then] { write(kind, to, then); }},
                     {.label = "Save as...", .act = [this, kind, then] { save_as(kind, then); }, .standard = true},
                     {.label = "Cancel", .cancel = true}}});
}

/// A document that nobody has named gets the name of its new file.
std::string Files::name_for(Kind kind, const fs::path& to) const {
    const bool scene = kind == Kind::scene;
    const fs::path& before = file(kind);
    const document::Document& d = parts_.document;
    const std::string& now = scene ? d.scene().name : d.preset().name;
    const auto last = d.steps().begin() + static_cast<std::ptrdiff_t>(d.done());
    const bool typed = std::any_of(d.steps().begin(), last, [&](const document::Step& step) {
        return (scene ? step.scene : step.preset).changes("/name");
    });
    const bool as_made = before.empty() && !typed && now == new_name(scene);
    const bool own = !now.empty() && !as_made && now != name_in(before, scene);
    return own || to == before ? now : name_of_file(to);
}

void Files::write(Kind kind, const fs::path& to, const Then& then) {
    const fs::path before = file(kind);
    using Named = document::Document::Named;
    const Named what = kind == Kind::scene ? Named::scene : Named::preset;
    const std::string name = what == Named::scene ? parts_.document.scene().name : parts_.document.preset().name;
    if (const std::string wanted = name_for(kind, to); wanted != name) parts_.document.rename(what, wanted);
    try {
        if (kind == Kind::scene)
            parts_.document.save_scene(to);
        else
            parts_.document.save_preset(to);
    } catch (const Error& error) {
        parts_.document.rename(what, name);
        relock();
        return ask_failed(kind, to, error.faults(), then);
    }
    relock();
    if (kind == Kind::preset) parts_.snapshots.move(before, to);
    parts_.settings.note_recent(to.string());
    parts_.notices.add({.kind = ui::ToastKind::good, .text = "Saved " + to.filename().string()});
    if (then) then();
}

// --- locks -----------------------------------------------------------------------------------------------------------

bool Files::lock(Kind kind, const fs::path& file) {
    std::optional<document::Lock>& held = locks_[kind == Kind::scene ? 0 : 1];
    const fs::path& state = parts_.options.folders.state;
    if (file.empty() || state.empty() || parts_.chooser.shipped(file)) {
        held.reset();
        return true;
    }
    const fs::path name = document::lock_file(state, file);
    if (held && held->file() == name) return true;
    try {
        std::optional<document::Lock> taken = document::Lock::take(name);
        if (!taken) return false;
        held = std::move(taken);
    } catch (const Error& error) {
        held.reset();
        if (!lock_told_) parts_.notices.tell(error);
        lock_told_ = true;
    }
    return true;
}

/// After the document's files have changed. A file that another editor has locked is not locked here.
void Files::relock() {
    for (const Kind kind : {Kind::scene, Kind::preset})
        if (!lock(kind, file(kind))) locks_[kind == Kind::scene ? 0 : 1].reset();
}

std::string Files::holder(const fs::path& file) const {
    const std::string who = document::holder_of(document::lock_file(parts_.options.folders.state, file));
    return who.empty() ? "an unknown process" : who;
}

// --- closing ---------------------------------------------------------------------------------------------------------

void Files::close() {
    if (question_) return;  // that one comes first
    const auto end = [this] {
        parts_.autosave.end();
        parts_.settings.write();
        closed_ = true;
    };
    const auto stop_export = [this, end] { parts_.exports.running() ? ask_running(end) : end(); };
    if (!parts_.document.unsaved()) return stop_export();
    ask_unsaved("Save changes before closing?", stop_export, {});
}

void Files::ask_running(Then then) {
    const auto stop = [this, then = std::move(then)] {
        parts_.exports.cancel();
        then();
    };
    ask({.title = in_marks(parts_.exports.name()) + " is being exported",
         .text = "Closing stops the export. Nothing of it is written, and an earlier file of that name stays.",
         .answers = {{.label = "Stop it and close", .tip = "The export is cancelled.", .act = stop},
                     {.label = "Keep exporting", .tip = "The editor stays open.", .standard = true, .cancel = true}}});
}

const std::string& Files::title() {
    const document::Document& d = parts_.document;
    if (title_version_ == d.version()) return title_;
    title_version_ = d.version();
    const auto part = [](const fs::path& file, const std::string& name, std::string_view otherwise, bool unsaved) {
        const std::string called =
            !file.empty() ? file.filename().string() : std::string(name.empty() ? otherwise : name);
        return called + (unsaved ? "*" : "");
    };
    title_ = part(d.preset_file(), d.preset().name, new_name(false), d.preset_unsaved()) + " - " +
             part(d.scene_file(), d.scene().name, new_name(true), d.scene_unsaved()) + " - lapfx";
    return title_;
}

}  // namespace lapfx::app
