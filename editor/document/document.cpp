#include "document/document.h"

#include <algorithm>

#include "lapfx/file.h"

namespace lapfx::document {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_file = std::size_t{16} << 20U;  // of a document; more than is ever loaded

void move_scene(Scene& scene, const fs::path& folder) {
    for (std::string* path : {&scene.organ.file, &scene.tool.file, &scene.reference.file, &scene.preset})
        *path = moved_path(*path, scene.folder, folder);
    scene.folder = folder;
}

[[noreturn]] void fail_reading_back(const fs::path& file) {
    throw Error(Failure::runtime, Fault{file.string(), "", "what was written does not read back as the same values"});
}

}  // namespace

OnDisk OnDisk::of(const fs::path& file) {
    if (file.empty()) return {};
    try {
        std::uint64_t hash = 0xcbf29ce484222325ULL;  // FNV-1a
        for (const char c : read_file(file, longest_file))
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
        return {.exists = true, .hash = hash};
    } catch (const Error&) {
        return {};
    }
}

fs::path folder_of(const fs::path& file) {
    return fs::absolute(file).lexically_normal().parent_path();
}

std::string moved_path(const std::string& file, const fs::path& from, const fs::path& to) {
    if (file.empty() || from == to) return file;
    const fs::path path = file;
    std::error_code error;
    const fs::path whole = path.is_absolute() ? path : from / path;
    if (!path.is_absolute() && (from.empty() || !fs::exists(whole, error))) return file;
    const fs::path relative = fs::proximate(whole, to, error);
    return error || relative.empty() ? fs::absolute(whole).string() : relative.generic_string();
}

std::string Document::moved_clip(const std::string& file, const fs::path& from, const fs::path& to) const {
    const std::string moved = moved_path(file, from, to);
    const fs::path whole = to / moved, name = whole.filename();
    const auto shipped = [&](const fs::path& folder) {
        std::error_code error;
        return fs::equivalent(folder / name, whole, error);
    };
    return std::any_of(clip_folders_.begin(), clip_folders_.end(), shipped) ? name.string() : moved;
}

void Document::move(Preset& preset, const fs::path& folder) const {
    for (SmokeClip& clip : preset.smoke.clips) clip.file = moved_clip(clip.file, preset.folder, folder);
    preset.folder = folder;
}

bool same(const Content& a, const Content& b) {
    return write_scene(a.scene) == write_scene(b.scene) && write_preset(a.preset) == write_preset(b.preset);
}

Document::Document() : saved_scene_(write_scene(content_.scene)), saved_preset_(write_preset(content_.preset)) {}

void Document::open(Content content, fs::path scene_file, fs::path preset_file) {
    content_ = std::move(content);
    scene_file_ = std::move(scene_file);
    preset_file_ = std::move(preset_file);
    saved_scene_ = write_scene(content_.scene);
    saved_preset_ = write_preset(content_.preset);
    note_disk();
    forget_steps();
}

void Document::open_preset(Preset preset, fs::path preset_file) {
    if (open_) cancel();
    content_.preset = std::move(preset);
    preset_file_ = std::move(preset_file);
    preset_disk_ = OnDisk::of(preset_file_);
    saved_preset_ = write_preset(content_.preset);
    forget_steps();
}

void Document::recover(Recovered r) {
    if (!r.scene_unsaved) r.scene_in_file = r.content.scene;
    if (!r.preset_unsaved) r.preset_in_file = r.content.preset;
    scene_file_ = std::move(r.scene_file);
    preset_file_ = std::move(r.preset_file);
    scene_disk_ = r.scene_disk;
    preset_disk_ = r.preset_disk;
    saved_scene_ = r.scene_in_file ? write_scene(*r.scene_in_file) : std::string();
    saved_preset_ = r.preset_in_file ? write_preset(*r.preset_in_file) : std::string();
    content_ = {.scene = r.scene_in_file.value_or(r.content.scene),
                .preset = r.preset_in_file.value_or(r.content.preset)};
    forget_steps();
    change("Recovered work", [&](Content& c) { c = std::move(r.content); });
}

void Document::forget_steps() {
    steps_.clear();
    done_ = 0;
    open_ = false;
    touched();
}

void Document::note_disk() {
    scene_disk_ = OnDisk::of(scene_file_);
    preset_disk_ = OnDisk::of(preset_file_);
}

void Document::forget_scene_file() {
    scene_file_.clear();
    scene_disk_ = {};
    saved_scene_.clear();
    touched();
}

void Document::forget_preset_file() {
    preset_file_.clear();
    preset_disk_ = {};
    saved_preset_.clear();
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
    steps_.push_back({.id = ++last_step_, .name = std::move(name_), .before = std::move(before_), .after = content_});
    if (steps_.size() > most_steps) steps_.erase(steps_.begin());
    done_ = steps_.size();
}

void Document::cancel() {
    if (!open_) return;
    open_ = false;
    set(before_);
}

void Document::set(const Content& content) {
    content_ = content;
    // Where the documents lie is no part of what is undone: they may have been saved elsewhere since.
    if (!scene_file_.empty()) move_scene(content_.scene, folder_of(scene_file_));
    if (!preset_file_.empty()) move(content_.preset, folder_of(preset_file_));
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
    preset_disk_ = OnDisk::of(preset_file_);
    change("Reload preset", [&](Content& c) { c.preset = std::move(preset); });
}

void Document::reload(Scene scene) {
    saved_scene_ = write_scene(scene);
    scene_disk_ = OnDisk::of(scene_file_);
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
    move(moved, folder_of(file));
    lapfx::save_preset(moved, file);
    const std::string text = write_preset(moved);
    if (write_preset(load_preset(file)) != text) fail_reading_back(file);
    content_.preset = std::move(moved);
    preset_file_ = file;
    preset_disk_ = OnDisk::of(file);
    saved_preset_ = text;
    touched();
}

void Document::save_scene(const fs::path& file) {
    commit();
    Scene moved = content_.scene;
    const fs::path folder = folder_of(file);
    move_scene(moved, folder);
    if (!preset_file_.empty()) moved.preset = moved_path(fs::absolute(preset_file_).string(), {}, folder);
    lapfx::save_scene(moved, file);
    const std::string text = write_scene(moved);
    if (write_scene(load_scene(file)) != text) fail_reading_back(file);
    content_.scene = std::move(moved);
    scene_file_ = file;
    scene_disk_ = OnDisk::of(file);
    saved_scene_ = text;
    touched();
}

std::vector<std::string> Document::clips_outside(const fs::path& folder) const {
    std::vector<std::string> outside;
    for (const SmokeClip& clip : content_.preset.smoke.clips) {
        const fs::path moved = moved_clip(clip.file, content_.preset.folder, fs::absolute(folder).lexically_normal());
        const bool leaves = std::find(moved.begin(), moved.end(), "..") != moved.end();
        if (moved.is_absolute() || leaves) outside.push_back(clip.file);
    }
    return outside;
}

std::vector<Fault> Document::preset_faults() const {
    return check(preset_table(), &content_.preset);
}

std::vector<Fault> Document::scene_faults() const {
    return check(scene_table(), &content_.scene);
}

}  // namespace lapfx::document
