#include "document/document.h"

namespace lapfx::document {

namespace fs = std::filesystem;

namespace {

/// `file` of a document in `from`, as a document in `to` has to name it. Names without a folder are looked up on the search
/// path and stay what they are unless the file lies beside the old document.
std::string moved_path(const std::string& file, const fs::path& from, const fs::path& to) {
    if (file.empty() || from == to) return file;
    const fs::path path = file;
    std::error_code error;
    const fs::path whole = path.is_absolute() ? path : from / path;
    if (!path.is_absolute() && (from.empty() || !fs::exists(whole, error))) return file;
    const fs::path relative = fs::proximate(whole, to, error);
    return error || relative.empty() ? fs::absolute(whole).string() : relative.generic_string();
}

fs::path folder_of(const fs::path& file) {
    return fs::absolute(file).parent_path();
}

}  // namespace

bool same(const Content& a, const Content& b) {
    return write_scene(a.scene) == write_scene(b.scene) && write_preset(a.preset) == write_preset(b.preset);
}

void Document::open(Content content, fs::path scene_file, fs::path preset_file) {
    content_ = std::move(content);
    scene_file_ = std::move(scene_file);
    preset_file_ = std::move(preset_file);
    saved_scene_ = write_scene(content_.scene);
    saved_preset_ = write_preset(content_.preset);
    steps_.clear();
    done_ = 0;
    open_ = false;
    touched();
}

void Document::begin(std::string name) {
    commit();
    open_ = true;
    name_ = std::move(name);
    before_ = content_;
}

void Document::commit() {
    if (!open_) return;
    open_ = false;
    if (same(before_, content_)) return;
    steps_.resize(done_);
    steps_.push_back({.name = std::move(name_), .before = std::move(before_), .after = content_});
    if (steps_.size() > most_steps) steps_.erase(steps_.begin());
    done_ = steps_.size();
}

void Document::cancel() {
    if (!open_) return;
    open_ = false;
    set(before_);
}

void Document::set(const Content& content) {
    // Where the documents lie is no part of what is undone.
    const fs::path scene_folder = content_.scene.folder, preset_folder = content_.preset.folder;
    content_ = content;
    content_.scene.folder = scene_folder;
    content_.preset.folder = preset_folder;
    touched();
}

void Document::undo() {
    if (open_) return cancel();
    if (done_ > 0) set(steps_[--done_].before);
}

void Document::redo() {
    if (can_redo()) set(steps_[done_++].after);
}

void Document::go_to(std::size_t done) {
    commit();
    done = std::min(done, steps_.size());
    while (done_ > done) undo();
    while (done_ < done) redo();
}

void Document::compare() const {
    if (compared_ == version_) return;
    compared_ = version_;
    scene_differs_ = write_scene(content_.scene) != saved_scene_;
    preset_differs_ = write_preset(content_.preset) != saved_preset_;
}

void Document::reload(Preset preset) {
    saved_preset_ = write_preset(preset);
    change("Reload preset", [&](Content& c) { c.preset = std::move(preset); });
}

void Document::reload(Scene scene) {
    saved_scene_ = write_scene(scene);
    change("Reload scene", [&](Content& c) { c.scene = std::move(scene); });
}

bool Document::scene_unsaved() const {
    compare();
    return scene_differs_;
}

bool Document::preset_unsaved() const {
    compare();
    return preset_differs_;
}

void Document::save_preset(const fs::path& file) {
    commit();
    Preset moved = content_.preset;
    const fs::path folder = folder_of(file);
    for (SmokeClip& clip : moved.smoke.clips) clip.file = moved_path(clip.file, moved.folder, folder);
    moved.folder = folder;
    lapfx::save_preset(moved, file);
    content_.preset = std::move(moved);
    preset_file_ = file;
    saved_preset_ = write_preset(content_.preset);
    touched();
}

void Document::save_scene(const fs::path& file) {
    commit();
    Scene moved = content_.scene;
    const fs::path folder = folder_of(file);
    for (std::string* path : {&moved.organ.file, &moved.tool.file, &moved.reference.file, &moved.preset})
        *path = moved_path(*path, moved.folder, folder);
    moved.folder = folder;
    lapfx::save_scene(moved, file);
    content_.scene = std::move(moved);
    scene_file_ = file;
    saved_scene_ = write_scene(content_.scene);
    touched();
}

std::vector<Fault> Document::preset_faults() const {
    return check(preset_table(), &content_.preset);
}

std::vector<Fault> Document::scene_faults() const {
    return check(scene_table(), &content_.scene);
}

}  // namespace lapfx::document
