// The part of Files that opens documents and organs, and asks before they replace others.
#include <algorithm>

#include "app/base/editor_options.h"
#include "app/base/file_chooser.h"
#include "app/base/file_filters.h"
#include "app/base/file_words.h"
#include "app/base/notices.h"
#include "app/base/settings.h"
#include "app/files/autosave.h"
#include "app/files/files.h"
#include "app/files/organ_choice.h"
#include "app/preview/looking.h"
#include "app/preview/orbit.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double unit_told_for = 60;  // s: all that is done with the organ afterwards depends on it

}  // namespace

void Files::make_new() {
    const auto begin = [this] {
        Opened fresh;
        try {
            const Opened sample = open_sample(parts_.options.data_folder);
            fresh.content.scene = sample.content.scene;
        } catch (const Error& error) {
            parts_.notices.tell(error);  // an empty scene then: an organ is loaded into it
        }
        fresh.content.scene.name = new_name(true);
        fresh.content.scene.preset.clear();
        fresh.content.scene.reference = {};
        fresh.content.scene.plate.use = false;
        fresh.content.scene.events.clear();
        fresh.content.preset.name = new_name(false);
        become(std::move(fresh), {}, {.scene = true});
    };
    if (parts_.document.unsaved()) return ask_unsaved("Save changes before starting a new scene?", begin, {});
    begin();
}

void Files::open_dialog() {
    parts_.chooser.ask({.task = ui::FileTask::open_many, .title = "Open", .filters = open_filters()},
                       [this](const std::vector<std::string>& chosen) { bring(chosen); });
}

Files::Kinds Files::kinds_of(const std::vector<std::string>& files) {
    Kinds kinds;
    for (const std::string& file : files) {
        try {
            const FileKind kind = kind_of(file);
            kinds.scene |= kind == FileKind::scene;
            kinds.preset |= kind == FileKind::preset;
        } catch (const Error&) {
            continue;  // opening tells what is wrong with it, and changes nothing
        }
    }
    return kinds;
}

void Files::open(const std::vector<std::string>& files) {
    if (files.size() == 1 && is_organ_name(files.front())) return parts_.organ_choice.open(files.front());
    if (!ready_to_open(files)) return;
    const document::Document& d = parts_.document;
    Opened opened{.content = d.content(), .scene_file = d.scene_file(), .preset_file = d.preset_file(), .warnings = {}};
    std::vector<std::string> videos, others = files;
    try {
        videos = open_files(opened, files);
    } catch (const Error& error) {
        parts_.settings.forget_missing(files);
        return parts_.notices.tell(error);
    }
    std::erase_if(
        others, [&](const std::string& file) { return std::find(videos.begin(), videos.end(), file) != videos.end(); });
    if (!others.empty()) put(std::move(opened), others);
    if (!videos.empty()) bring_videos(videos);
}

void Files::bring(const std::vector<std::string>& files) {
    std::vector<std::string> documents, organs, videos;
    for (const std::string& file : files) {
        const bool written = is_document_name(file);
        std::vector<std::string>& kind = written ? documents : is_organ_name(file) ? organs : videos;
        try {
            if (&kind == &videos) kind_of(file);  // throws where it is neither a video nor a picture
            kind.push_back(file);
        } catch (const Error& error) {
            parts_.notices.tell(error);
        }
    }
    if (!documents.empty()) open(documents);
    if (!organs.empty()) parts_.organ_choice.open(organs.front());
    if (organs.size() > 1)
        parts_.notices.add(
            {.kind = ui::ToastKind::warning, .text = "A scene has one organ: the first of them is opened"});
    if (!videos.empty()) bring_videos(videos);
}

void Files::recover(std::size_t offer) {
    parts_.autosave.recover(offer);
    parts_.forget_document(true);
    note_opened();
}

bool Files::ready_to_open(const std::vector<std::string>& files) {
    if (std::exchange(agreed_, false)) return true;
    const Kinds kinds = kinds_of(files);
    const document::Document& d = parts_.document;
    const bool goes = kinds.scene ? d.unsaved() : kinds.preset && d.preset_unsaved();
    if (!goes) return true;
    ask_unsaved(
        "Save changes before opening " + in_marks(files.front()) + '?', [this, files] { open_anyway(files); }, {},
        kinds.scene);
    return false;
}

void Files::open_anyway(const std::vector<std::string>& files) {
    agreed_ = true;
    open(files);
    agreed_ = false;
}

void Files::put(Opened opened, const std::vector<std::string>& files) {
    const Kinds kinds = kinds_of(files);
    std::vector<Kind> used;
    std::vector<fs::path> names;
    const auto check = [&](Kind kind, const fs::path& opens) {
        if (lock(kind, opens)) return;
        used.push_back(kind);
        names.push_back(opens);
    };
    // A file that is open already is locked by this editor, or the person has agreed to share it.
    if (kinds.scene && opened.scene_file != file(Kind::scene)) check(Kind::scene, opened.scene_file);
    if ((kinds.scene || kinds.preset) && opened.preset_file != file(Kind::preset))
        check(Kind::preset, opened.preset_file);
    const auto shared = std::make_shared<Opened>(std::move(opened));
    const auto go_on = [this, shared, files, kinds] { become(std::move(*shared), files, kinds); };
    if (used.empty()) return go_on();
    ask_in_use(used, names, go_on, [this] { relock(); });
}

void Files::note_opened() {
    std::vector<Kind> used;
    std::vector<fs::path> names;
    for (const Kind kind : {Kind::scene, Kind::preset}) {
        if (lock(kind, file(kind))) continue;
        used.push_back(kind);
        names.push_back(file(kind));
    }
    if (!used.empty()) ask_in_use(used, names, {}, {});
}

void Files::ask_in_use(const std::vector<Kind>& used, const std::vector<fs::path>& files, Then go_on, Then otherwise) {
    std::vector<std::string> lines;
    for (const fs::path& file : files) lines.push_back(in_marks(file) + ": " + holder(file));
    const auto copy = [this, used, go_on] {
        if (go_on) go_on();
        for (const Kind kind : used)
            kind == Kind::scene ? parts_.document.forget_scene_file() : parts_.document.forget_preset_file();
        relock();
    };
    Question question{.title = "Another editor has this file open",
                      .text = "Two editors would overwrite each other's work in one file.",
                      .lines = std::move(lines),
                      .answers = {},
                      .serial = 0};
    question.answers.push_back(
        {.label = "Open anyway",
         .tip = "Both save to the same file; the second is asked before it replaces what the first wrote.",
         .act = go_on});
    question.answers.push_back({.label = "Open a copy",
                                .tip = "The same content without a file: saving asks for a name.",
                                .act = copy,
                                .standard = true,
                                .cancel = !otherwise});
    if (otherwise)
        question.answers.push_back(
            {.label = "Cancel", .tip = "What is open now stays open.", .act = otherwise, .cancel = true});
    ask(std::move(question));
}

void Files::become(Opened opened, const std::vector<std::string>& files, Kinds kinds) {
    document::Document& d = parts_.document;
    const bool another_organ = !kinds.scene && opened.content.scene.organ.file != d.scene().organ.file;
    if (kinds.scene) {
        d.open(std::move(opened.content), opened.scene_file, opened.preset_file);
    } else {
        if (kinds.preset) d.open_preset(opened.content.preset, opened.preset_file);
        // An organ is a change of the document, which can be undone.
        d.change("Open " + fs::path(files.front()).filename().string(),
                 [&](document::Content& c) { c = std::move(opened.content); });
    }
    if (kinds.scene || kinds.preset) parts_.forget_document(kinds.scene);
    if (another_organ) {
        parts_.selected.clear();
        parts_.looking.camera = d.scene().camera;
    }
    relock();
    for (const std::string& name : files) parts_.settings.note_recent(name);
    for (const std::string& warning : opened.warnings)
        parts_.notices.add({.kind = ui::ToastKind::warning, .text = warning});
    if (opened.unit) propose_unit(*opened.unit);
}

void Files::propose_unit(const UnitProposal& unit) {
    const std::string name(length_units[static_cast<std::size_t>(unit_of(unit.scale))].name);
    const auto take = [this, unit] {
        document::Document& d = parts_.document;
        if (d.scene().organ.file != unit.file) return;  // another one since
        d.change("Organ in another unit", [&](document::Content& c) {
            c.scene.organ.scale = unit.scale;
            see_whole(c.scene, unit.organ);
        });
        parts_.looking.camera = d.scene().camera;
    };
    parts_.notices.add({.kind = ui::ToastKind::warning,
                        .text = fs::path(unit.file).filename().string() + ": " + unit.reason,
                        .action = "Use " + name,
                        .act = take,
                        .seconds = unit_told_for});
}

}  // namespace lapfx::app
