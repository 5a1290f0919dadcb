#include "document/document.h"

#include <algorithm>
#include <utility>

#include "document/hash.h"
#include "document/words.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"

namespace lapfx::document {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_file = std::size_t{16} << 20U;  // larger than any document that is loaded

/// An absolute path in one spelling. The path that a document is opened with may be relative to the folder in which the
/// program was started.
fs::path normal(const fs::path& path) {
    if (path.empty()) return path;
    const fs::path whole = fs::absolute(path).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

/// The folder of a document. A file name without a folder was read from the folder in which the program was started.
fs::path normal_folder(const fs::path& folder, const fs::path& file) {
    return folder.empty() && !file.empty() ? folder_of(file) : normal(folder);
}

/// Whether a clip of this name exists. It may be a sequence, and then no file has its name with the %. The path may
/// lead through symbolic links and contain any character.
bool is_there(const fs::path& whole) {
    if (!whole.has_filename() || whole.native().find('\0') != std::string::npos) return false;
    try {
        (void)find_clip(fs::absolute(whole).string(), {}, {});
        return true;
    } catch (const Error&) {
        return false;
    }
}

bool lies_in(const fs::path& whole, const fs::path& folder) {
    const fs::path relative = whole.lexically_relative(folder);
    return !folder.empty() && !relative.empty() && *relative.begin() != "..";
}

/// The path with symbolic links followed; for a sequence only those of its folder. If they may not be read, the path
/// stays as it is.
fs::path real(const fs::path& path) {
    std::error_code error;
    fs::path found = fs::weakly_canonical(path, error);
    return error ? path : found;
}

/// The clip's file; only its name if the preset's folder has no such file.
fs::path whole_clip(const std::string& file, const fs::path& folder) {
    const fs::path whole = (folder / file).lexically_normal();
    return is_there(whole) ? whole : fs::path(file);
}

/// Prefixes "./" to a name such as "case:3.glb", which would be read as a URL.
std::string as_path(std::string name) {
    return name.find(':') < name.find('/') ? "./" + name : name;
}

bool is_in_one_of(const std::vector<fs::path>& folders, const fs::path& file) {
    return std::any_of(folders.begin(), folders.end(), [&](const fs::path& folder) {
        std::error_code error;
        return fs::equivalent(folder, file.parent_path(), error);
    });
}

/// The name of a file relative to this folder. It is the path as spelled if that does not leave the folder; otherwise
/// it is the path with symbolic links followed, which is inside.
std::string name_within(const fs::path& whole, const fs::path& folder) {
    const bool spelled = lies_in(whole, folder) && lies_in(real(whole), real(folder));
    const fs::path name = spelled ? whole.lexically_relative(folder) : real(whole).lexically_relative(real(folder));
    return as_path(name.generic_string());
}

constexpr unsigned all_bits = ~0U;
/// Bits that depend on the folder, because files are looked up in it.
constexpr unsigned files_elsewhere = redo::picture | redo::organ | redo::clips | redo::amounts;

template <class Part>
unsigned differing(const Table& table, const Part& a, const Part& b) {
    return difference(table, &a, &b) | (a.folder == b.folder ? 0 : files_elsewhere);
}

[[noreturn]] void fail_reading_back(const fs::path& file) {
    throw Error(Failure::runtime, Fault{file.string(), "", "the written file does not contain the same values"});
}

}  // namespace

OnDisk OnDisk::of(const fs::path& file) {
    if (file.empty()) return {};
    try {
        return {.exists = true, .hash = hash_of(read_file(file, longest_file))};
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
    if (!path.is_absolute() && (from.empty() || !is_there(whole))) return file;
    const fs::path relative = fs::proximate(whole, to, error);
    return error || relative.empty() ? fs::absolute(whole).string() : as_path(relative.generic_string());
}

void move_scene(Scene& scene, const fs::path& folder) {
    for (std::string* path :
         {&scene.organ.file, &scene.organ.texture, &scene.tool.file, &scene.reference.file, &scene.preset})
        *path = moved_path(*path, scene.folder, folder);
    scene.folder = folder;
}

fs::path real_clip(const std::string& file, const fs::path& folder) {
    const fs::path whole = whole_clip(file, folder);
    return whole.is_absolute() ? real(whole) : whole;
}

void gather_clips(Preset& preset, const fs::path& home, const std::vector<fs::path>& shipped) {
    std::vector<fs::path> whole;  // the path of each clip; one that is not absolute stays a bare name
    fs::path above;               // the deepest folder that contains all of them
    for (const SmokeClip& clip : preset.smoke.clips) {
        fs::path path = whole_clip(clip.file, preset.folder);
        if (path.is_absolute() && is_in_one_of(shipped, path)) path = path.filename();
        if (path.is_absolute()) {
            const fs::path folder = real(path).parent_path();
            if (above.empty()) above = folder;
            while (!lies_in(folder, above)) above = above.parent_path();
        }
        whole.push_back(std::move(path));
    }
    fs::path gathered = above.empty() ? home : above;
    for (const fs::path& folder : {home, preset.folder})
        if (!above.empty() && !folder.empty() && lies_in(above, real(folder))) {
            gathered = folder;
            break;
        }
    for (std::size_t i = 0; i < whole.size(); ++i)
        preset.smoke.clips[i].file =
            whole[i].is_absolute() ? name_within(whole[i], gathered) : whole[i].generic_string();
    preset.folder = gathered;
}

std::string Document::moved_clip(const std::string& file, const fs::path& from, const fs::path& to) const {
    const std::string moved = moved_path(file, from, to);
    const fs::path whole = to / moved;
    return is_in_one_of(clip_folders_, whole) ? whole.filename().string() : moved;
}

void Document::move(Preset& preset, const fs::path& folder) const {
    for (SmokeClip& clip : preset.smoke.clips) clip.file = moved_clip(clip.file, preset.folder, folder);
    preset.folder = folder;
}

void Document::gather_clips(Preset& preset) const {
    document::gather_clips(preset, preset_file_.empty() ? preset.folder : folder_of(preset_file_), clip_folders_);
}

bool same(const Preset& a, const Preset& b) {
    if (a.folder == b.folder) return equal(preset_table(), &a, &b);
    const auto resolved = [](Preset preset) {
        for (SmokeClip& clip : preset.smoke.clips) clip.file = real_clip(clip.file, preset.folder).generic_string();
        return preset;
    };
    const Preset left = resolved(a), right = resolved(b);
    return equal(preset_table(), &left, &right);
}

bool same(const Content& a, const Content& b) {
    return a.scene.folder == b.scene.folder && equal(scene_table(), &a.scene, &b.scene) && same(a.preset, b.preset);
}

Document::Document() : saved_scene_(std::make_shared<Scene>()), saved_preset_(std::make_shared<Preset>()) {
    all_touched();
}

void Document::open(Content content, fs::path scene_file, fs::path preset_file) {
    scene_file_ = normal(scene_file);
    preset_file_ = normal(preset_file);
    content_ = std::move(content);
    content_.scene.folder = normal_folder(content_.scene.folder, scene_file_);
    content_.preset.folder = normal_folder(content_.preset.folder, preset_file_);
    saved_scene_ = std::make_shared<const Scene>(content_.scene);
    saved_preset_ = std::make_shared<const Preset>(content_.preset);
    note_disk();
    forget_steps();
}

void Document::open_preset(Preset preset, fs::path preset_file) {
    if (open_) cancel();
    preset_file_ = normal(preset_file);
    content_.preset = std::move(preset);
    content_.preset.folder = normal_folder(content_.preset.folder, preset_file_);
    preset_disk_ = OnDisk::of(preset_file_);
    saved_preset_ = std::make_shared<const Preset>(content_.preset);
    forget_steps();
}

void Document::recover(Recovered r) {
    if (!r.scene_unsaved) r.scene_in_file = r.content.scene;
    if (!r.preset_unsaved) r.preset_in_file = r.content.preset;
    scene_file_ = normal(r.scene_file);
    preset_file_ = normal(r.preset_file);
    for (Scene* scene : {&r.content.scene, r.scene_in_file ? &*r.scene_in_file : nullptr})
        if (scene != nullptr) scene->folder = normal_folder(scene->folder, scene_file_);
    for (Preset* preset : {&r.content.preset, r.preset_in_file ? &*r.preset_in_file : nullptr})
        if (preset != nullptr) preset->folder = normal_folder(preset->folder, preset_file_);
    scene_disk_ = r.scene_disk;
    preset_disk_ = r.preset_disk;
    saved_scene_ = r.scene_in_file ? std::make_shared<const Scene>(*r.scene_in_file) : nullptr;
    saved_preset_ = r.preset_in_file ? std::make_shared<const Preset>(*r.preset_in_file) : nullptr;
    content_ = {.scene = r.scene_in_file.value_or(r.content.scene),
                .preset = r.preset_in_file.value_or(r.content.preset)};
    forget_steps();
    change("Recovered work", [&](Content& c) { c = std::move(r.content); });
}

/// Earlier steps cannot be undone any more, because the content has been replaced.
void Document::forget_steps() {
    steps_.clear();
    done_ = 0;
    open_ = false;
    settle();
    all_touched();
}

void Document::note_disk() {
    scene_disk_ = OnDisk::of(scene_file_);
    preset_disk_ = OnDisk::of(preset_file_);
}

void Document::forget_scene_file() {
    scene_file_.clear();
    scene_disk_ = {};
    saved_scene_ = nullptr;
    touched();
}

void Document::forget_preset_file() {
    preset_file_.clear();
    preset_disk_ = {};
    saved_preset_ = nullptr;
    touched();
}

// --- following -------------------------------------------------------------------------------------------------------

/// Notes an edit. A row that it changed differs from the last step either now (`differing`) or did so before the edit
/// (`open`).
void Document::Changed::note(unsigned differing, std::uint64_t version) {
    const unsigned bits = differing | std::exchange(open, differing);
    for (std::size_t bit = 0; bit < at.size(); ++bit)
        if ((bits >> bit & 1U) != 0) at[bit] = version;
}

unsigned Document::Changed::since(std::uint64_t version) const {
    unsigned bits = 0;
    for (std::size_t bit = 0; bit < at.size(); ++bit)
        if (at[bit] > version) bits |= 1U << bit;
    return bits;
}

void Document::touched() {
    ++version_;
    scene_changed_.note(differing(scene_table(), settled_.scene, content_.scene), version_);
    preset_changed_.note(differing(preset_table(), settled_.preset, content_.preset), version_);
}

void Document::all_touched() {
    ++version_;
    for (Changed* changed : {&scene_changed_, &preset_changed_}) {
        changed->note(all_bits, version_);
        changed->open = 0;
    }
}

/// Takes the present content as the one that the last step left.
void Document::settle() {
    settled_ = content_;
    scene_changed_.open = preset_changed_.open = 0;
}

// --- changing --------------------------------------------------------------------------------------------------------

void Document::begin(std::string name) {
    commit();
    open_ = true;
    name_ = std::move(name);
}

void Document::commit() {
    if (!open_) return;
    open_ = false;
    // A change that would not show in any file, such as another path to the same clip, does not make a step.
    if (same(settled_, content_)) return take_back();
    steps_.resize(done_);
    Step step{.id = ++last_step_,
              .name = std::move(name_),
              .change = {},
              .scene = Delta(scene_table(), settled_.scene, content_.scene),
              .preset = Delta(preset_table(), settled_.preset, content_.preset)};
    step.change = change_of(step.name, settled_, content_);
    step.scene.redo(settled_.scene);
    step.preset.redo(settled_.preset);
    scene_changed_.open = preset_changed_.open = 0;
    steps_.push_back(std::move(step));
    forget_oldest();
    done_ = steps_.size();
}

void Document::cancel() {
    if (!open_) return;
    open_ = false;
    take_back();
}

/// Brings the content back to exactly the state that the last step left.
void Document::take_back() {
    const Delta scene(scene_table(), settled_.scene, content_.scene);
    const Delta preset(preset_table(), settled_.preset, content_.preset);
    if (scene.empty() && preset.empty()) return;
    scene.undo(content_.scene);
    preset.undo(content_.preset);
    touched();
}

// --- history ---------------------------------------------------------------------------------------------------------

std::size_t Document::step_memory() const {
    std::size_t bytes = steps_.capacity() * sizeof(Step);
    for (const Step& step : steps_)
        bytes += step.name.size() + step.change.size() + step.scene.memory() + step.preset.memory();
    return bytes;
}

void Document::forget_oldest() {
    std::size_t bytes = step_memory();
    std::size_t oldest = 0;  // index of the oldest step that stays
    while (steps_.size() - oldest > 1 && (steps_.size() - oldest > most_steps || bytes > most_step_bytes)) {
        const Step& step = steps_[oldest++];
        bytes -= step.name.size() + step.change.size() + step.scene.memory() + step.preset.memory();
    }
    steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(oldest));
}

/// Brings content_ and settled_ to the state on the other side of a step.
template <typename Apply>
void Document::step(Apply apply) {
    // Undoing leaves the name of the preset's file that the scene was saved with as it is.
    const std::string preset = content_.scene.preset;
    const fs::path folder = content_.scene.folder;
    apply(content_);
    content_.scene.preset = moved_path(preset, folder, content_.scene.folder);
    touched();
    apply(settled_);
    settled_.scene.preset = content_.scene.preset;
    scene_changed_.open = preset_changed_.open = 0;
}

void Document::undo() {
    if (open_) return cancel();
    if (done_ == 0) return;
    const Step& undone = steps_[--done_];
    step([&](Content& c) { undone.scene.undo(c.scene), undone.preset.undo(c.preset); });
}

void Document::redo() {
    if (!can_redo()) return;
    const Step& redone = steps_[done_++];
    step([&](Content& c) { redone.scene.redo(c.scene), redone.preset.redo(c.preset); });
}

void Document::rename(Named what, const std::string& name) {
    commit();
    std::string& now = what == Named::scene ? content_.scene.name : content_.preset.name;
    const std::string before = std::exchange(now, name);
    for (Step& step : steps_) (what == Named::scene ? step.scene : step.preset).replace("/name", before, name);
    describe_again("/name");
    touched();
    settle();
}

/// The words of all steps that change what is at this JSON pointer, as undoing and redoing them now would do.
void Document::describe_again(std::string_view place) {
    const auto changes = [&](const Step& step) { return step.scene.changes(place) || step.preset.changes(place); };
    Content after = content_;
    for (std::size_t i = done_; i-- > 0;) {
        Content before = after;
        steps_[i].scene.undo(before.scene);
        steps_[i].preset.undo(before.preset);
        if (changes(steps_[i])) steps_[i].change = change_of(steps_[i].name, before, after);
        after = std::move(before);
    }
    Content before = content_;
    for (std::size_t i = done_; i < steps_.size(); ++i) {
        after = before;
        steps_[i].scene.redo(after.scene);
        steps_[i].preset.redo(after.preset);
        if (changes(steps_[i])) steps_[i].change = change_of(steps_[i].name, before, after);
        before = std::move(after);
    }
}

/// Writing a file renames other files in the present content only (`change`). This function adapts the steps before and
/// after it, so that they lead to and from the content with the new names.
template <typename Part, typename Change>
void Document::sew(Part Content::*part, Delta Step::*delta, const Table& table, Change change) {
    Part before, behind;
    if (done_ > 0) {
        before = content_.*part;
        (steps_[done_ - 1].*delta).undo(before);
    }
    if (done_ < steps_.size()) {
        behind = content_.*part;
        (steps_[done_].*delta).redo(behind);
    }
    change();
    if (done_ > 0) steps_[done_ - 1].*delta = Delta(table, before, content_.*part);
    if (done_ < steps_.size()) steps_[done_].*delta = Delta(table, content_.*part, behind);
    touched();
    settle();
}

void Document::go_to(std::size_t done) {
    commit();
    done = std::min(done, steps_.size());
    while (done_ > done) undo();
    while (done_ < done) redo();
}

/// Finds out whether a file written now would differ from what was opened or saved; that names are relative to another
/// folder now does not count. A document that has not changed since the last call is not compared again.
void Document::compare() const {
    const auto differs = [](const Table& table, const auto& now, const auto& saved, auto move_to) {
        if (!saved) return true;
        if (saved->folder.empty() || now.folder == saved->folder) return !equal(table, &now, saved.get());
        auto moved = now;
        move_to(moved, saved->folder);
        return !equal(table, &moved, saved.get());
    };
    if (compared_scene_ != saved_scene_ || scene_changes_since(compared_) != 0)
        scene_differs_ = differs(scene_table(), content_.scene, saved_scene_, move_scene);
    if (compared_preset_ != saved_preset_ || preset_changes_since(compared_) != 0)
        preset_differs_ = differs(preset_table(), content_.preset, saved_preset_,
                                  [this](Preset& preset, const fs::path& folder) { move(preset, folder); });
    compared_ = version_;
    compared_scene_ = saved_scene_;
    compared_preset_ = saved_preset_;
}

void Document::reload(Preset preset) {
    preset.folder = normal_folder(preset.folder, preset_file_);
    saved_preset_ = std::make_shared<const Preset>(preset);
    preset_disk_ = OnDisk::of(preset_file_);
    change("Reload preset", [&](Content& c) { c.preset = std::move(preset); });
}

void Document::reload(Scene scene) {
    scene.folder = normal_folder(scene.folder, scene_file_);
    saved_scene_ = std::make_shared<const Scene>(scene);
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
    if (const Preset written = load_preset(file); !equal(preset_table(), &written, &moved)) fail_reading_back(file);
    sew(&Content::preset, &Step::preset, preset_table(), [&] { content_.preset = std::move(moved); });
    preset_file_ = normal(file);
    preset_disk_ = OnDisk::of(file);
    saved_preset_ = std::make_shared<const Preset>(content_.preset);
}

void Document::save_scene(const fs::path& file) {
    commit();
    Scene moved = content_.scene;
    const fs::path folder = folder_of(file);
    move_scene(moved, folder);
    if (!preset_file_.empty()) moved.preset = moved_path(fs::absolute(preset_file_).string(), {}, folder);
    lapfx::save_scene(moved, file);
    if (const Scene written = load_scene(file); !equal(scene_table(), &written, &moved)) fail_reading_back(file);
    sew(&Content::scene, &Step::scene, scene_table(), [&] { content_.scene = std::move(moved); });
    scene_file_ = normal(file);
    scene_disk_ = OnDisk::of(file);
    saved_scene_ = std::make_shared<const Scene>(content_.scene);
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

const std::vector<Fault>& Document::preset_faults() const {
    if (preset_changes_since(checked_) != 0) preset_faults_ = check(preset_table(), &content_.preset);
    checked_ = version_;
    return preset_faults_;
}

std::vector<Fault> Document::scene_faults() const {
    return check(scene_table(), &content_.scene);
}

bool Document::undo_mends(const Fault& fault) const {
    if (done_ == 0 || open_) return false;
    const Delta& last = steps_[done_ - 1].preset;
    const auto lists = [&](const std::vector<Fault>& faults) {
        return std::any_of(faults.begin(), faults.end(), [&](const Fault& each) { return each.place == fault.place; });
    };
    if (!lists(preset_faults())) return last.changes(fault.place);
    Preset before = content_.preset;
    last.undo(before);
    return !lists(check(preset_table(), &before));
}

bool Document::undo_changes_organ() const {
    if (done_ == 0 || open_) return false;
    const Delta& last = steps_[done_ - 1].scene;
    return last.changes("/organ/file") || last.changes("/organ/scale") || last.changes("/organ/rotation") ||
           last.changes("/organ/texture");
}

}  // namespace lapfx::document
