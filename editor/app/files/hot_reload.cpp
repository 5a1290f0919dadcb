#include "app/files/hot_reload.h"

#include <algorithm>
#include <fstream>

#include "app/base/jobs.h"
#include "app/base/notices.h"
#include "app/preview/preview_host.h"
#include "lapfx/authoring/compare.h"
#include "ui/core/ui.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

fs::path normal(const fs::path& path) {
    return path.empty() ? path : fs::absolute(path).lexically_normal();
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// One notice for a compiler's message: what it is about, and its first line with a place.
std::string told(const std::vector<Fault>& faults) {
    std::string text = faults.empty() ? "" : faults.front().text();
    if (faults.size() > 1) text += ": " + faults[1].text();
    return text + "; the last working one is used";
}

bool contains(const std::vector<fs::path>& paths, const fs::path& path) {
    return std::find(paths.begin(), paths.end(), path) != paths.end();
}

}  // namespace

HotReload::HotReload(document::Document& document, PreviewHost& preview, Jobs& jobs, Notices& notices,
                     const fs::path& data_folder)
    : document_(document), preview_(preview), notices_(notices), data_folder_(data_folder), watch_([&jobs] {
          jobs.wake();
      }) {}

fs::path HotReload::shader_folder() const {
    return normal(data_folder_ / "shaders");
}

void HotReload::update(double) {
    follow();
    if (const std::vector<fs::path> changed = watch_.take(); !changed.empty()) take(changed);
}

/// Watches the files that are open now.
void HotReload::follow() {
    const bool loading = preview_.loading().has_value();
    const document::Document& document = document_;
    const bool other_files = (document.changes_since(followed_) & (redo::organ | redo::clips)) != 0 ||
                             document.preset_file().native() != preset_file_ ||
                             document.scene_file().native() != scene_file_;
    followed_ = document.version();
    if (!other_files && loading == was_loading_) return;
    was_loading_ = loading;
    preset_file_ = document.preset_file().native();
    scene_file_ = document.scene_file().native();
    std::vector<fs::path> paths{shader_folder()};
    for (const fs::path& file : {document.preset_file(), document.scene_file()})
        if (!file.empty()) paths.push_back(normal(file));
    const std::vector<fs::path> clips = preview_.clip_files(document.preset());
    const std::vector<fs::path> organ = preview_.organ_files(document.scene());
    paths.insert(paths.end(), clips.begin(), clips.end());
    paths.insert(paths.end(), organ.begin(), organ.end());
    if (paths == watched_) return;
    watched_ = paths;
    watch_.set(watched_);
}

/// Told once, until it comes back.
bool HotReload::is_gone(const fs::path& file) {
    std::error_code error;
    if (fs::exists(file, error)) {
        gone_.erase(file);
        return false;
    }
    if (gone_.insert(file).second)
        notices_.add({.kind = ui::ToastKind::warning,
                      .text = file.filename().string() + " no longer exists on the disk; what is shown stays"});
    return true;
}

void HotReload::take(const std::vector<fs::path>& changed) {
    const document::Document& document = document_;
    const std::vector<fs::path> clips = preview_.clip_files(document.preset());
    const std::vector<fs::path> organ = preview_.organ_files(document.scene());
    const fs::path shaders = shader_folder();
    std::vector<fs::path> changed_clips;
    bool shader = false, organ_changed = false;
    for (const fs::path& path : changed) {
        const bool of_clips = contains(clips, path) || contains(clips, path.parent_path());
        if (path.parent_path() == shaders)
            shader = true;
        else if (path == normal(document.preset_file()))
            is_gone(path) ? void() : reload_preset();
        else if (path == normal(document.scene_file()))
            is_gone(path) ? void() : reload_scene();
        else if (of_clips && (contains(clips, path.parent_path()) || !is_gone(path)))
            changed_clips.push_back(path);
        else if (of_clips)
            preview_.look_for_clips();
        else if (contains(organ, path) && !is_gone(path))
            organ_changed = true;
    }
    if (shader) reload_shaders();
    if (!changed_clips.empty()) preview_.reload_clips(changed_clips);
    if (organ_changed) preview_.reload_organ();
}

void HotReload::reload_all() {
    gone_.clear();
    reload_shaders();
    preview_.reload_clips();
    preview_.reload_organ();
    if (!document_.preset_file().empty() && !is_gone(normal(document_.preset_file()))) reload_preset();
    if (!document_.scene_file().empty() && !is_gone(normal(document_.scene_file()))) reload_scene();
}

void HotReload::reload_shaders() {
    const bool were_broken = !shader_faults_.empty();
    std::error_code error;
    if (!fs::is_directory(shader_folder(), error)) return;  // those that were built in are used
    try {
        shader_faults_.clear();
        preview_.reload_shaders(shader_folder());
        reload_ui_shaders();
    } catch (const Error& fault) {
        shader_faults_ = fault.faults();
    }
    if (!shader_faults_.empty())
        notices_.add({.kind = ui::ToastKind::error, .text = told(shader_faults_)});
    else if (were_broken)
        notices_.add({.kind = ui::ToastKind::good, .text = "Shaders compile again"});
}

void HotReload::reload_ui_shaders() {
    const fs::path vertex = shader_folder() / "ui.vert", fragment = shader_folder() / "ui.frag";
    std::error_code error;
    if (!ui_shaders_ || !fs::exists(vertex, error) || !fs::exists(fragment, error)) return;
    std::string fault;
    if (ui_shaders_(text_of(vertex), text_of(fragment), fault)) return;
    throw Error(Failure::runtime, Fault{.file = "ui.vert + ui.frag", .place = "", .reason = fault});
}

/// A document has changed on disk. It is read at once where nothing would be lost, else by a button of the notice.
void HotReload::take_or_ask(const fs::path& file, bool unsaved, const std::function<void()>& take,
                            std::function<void()> give_in) {
    const std::string name = file.filename().string();
    if (!unsaved) {
        take();
        notices_.add({.text = name + " has changed on disk and was reloaded"});
        return;
    }
    notices_.add({.kind = ui::ToastKind::warning,
                  .text = name + " has changed on disk, and here it has unsaved changes",
                  .action = "Reload",
                  .act = std::move(give_in),
                  .seconds = 0});
}

void HotReload::reload_preset() {
    document::Document& d = document_;
    const fs::path file = d.preset_file();
    // Values that differ from what was saved are the changes made in this editor.
    if (document::OnDisk::of(file) == d.preset_on_disk()) return;
    try {
        const Preset preset = load_preset(file);
        if (equal(preset_table(), &preset, &d.preset())) return;
        take_or_ask(
            file, d.preset_unsaved(), [&] { d.reload(preset); }, [this, file] { give_in_to_preset(file); });
    } catch (const Error& error) {
        notices_.tell(error);
    }
}

void HotReload::reload_scene() {
    document::Document& d = document_;
    const fs::path file = d.scene_file();
    if (document::OnDisk::of(file) == d.scene_on_disk()) return;
    try {
        const Scene scene = load_scene(file);
        if (equal(scene_table(), &scene, &d.scene())) return;
        take_or_ask(
            file, d.scene_unsaved(), [&] { d.reload(scene); }, [this, file] { give_in_to_scene(file); });
    } catch (const Error& error) {
        notices_.tell(error);
    }
}

/// The notice's button was pressed. By then another document may be open, or the file may have changed again.
void HotReload::give_in_to_preset(const fs::path& file) {
    if (document_.preset_file() != file) return;
    try {
        document_.reload(load_preset(file));
    } catch (const Error& error) {
        notices_.tell(error);
    }
}

void HotReload::give_in_to_scene(const fs::path& file) {
    if (document_.scene_file() != file) return;
    try {
        document_.reload(load_scene(file));
    } catch (const Error& error) {
        notices_.tell(error);
    }
}

}  // namespace lapfx::app
