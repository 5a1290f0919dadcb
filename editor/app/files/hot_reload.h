// What is open is read again when it changes on disk: shaders, clips, the organ with its textures and its tool, preset
// and scene. What cannot be read, or is gone, leaves what is shown, and is told once. Where there are unsaved changes
// it asks, so that no work is lost.
//
//     hot_reload.update(now);      // once before each frame
//     hot_reload.reload_all();     // "Reload from disk"
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "app/base/file_watch.h"
#include "document/document.h"
#include "lapfx/error.h"

namespace lapfx::app {

class Jobs;
class Notices;
class PreviewHost;

class HotReload {
  public:
    /// All must outlive it. `data_folder`: of the shaders.
    HotReload(document::Document& document, PreviewHost& preview, Jobs& jobs, Notices& notices,
              const std::filesystem::path& data_folder);

    /// Once before each frame. `now`: s.
    void update(double now);
    /// These have changed: what the watch tells, and tests.
    void take(const std::vector<std::filesystem::path>& changed);
    /// All that is open, whether or not it has changed.
    void reload_all();

    /// What is wrong with the shaders on disk; empty again once they are mended. The last good ones are used.
    const std::vector<Fault>& shader_faults() const { return shader_faults_; }

    /// The shaders of the user interface, which its window has (ui::Renderer::reload): false, and why, keeps the former
    /// ones.
    using UiShaders = std::function<bool(std::string_view vertex, std::string_view fragment, std::string& fault)>;
    void set_ui_shaders(UiShaders reload) { ui_shaders_ = std::move(reload); }

  private:
    void follow();
    bool is_gone(const std::filesystem::path& file);
    void reload_shaders();
    void reload_ui_shaders();
    void take_or_ask(const std::filesystem::path& file, bool unsaved, const std::function<void()>& take,
                     std::function<void()> give_in);
    void reload_preset();
    void reload_scene();
    void give_in_to_preset(const std::filesystem::path& file);
    void give_in_to_scene(const std::filesystem::path& file);
    std::filesystem::path shader_folder() const;

    document::Document& document_;
    PreviewHost& preview_;
    Notices& notices_;
    std::filesystem::path data_folder_;
    std::uint64_t followed_ = 0;  // version of the document
    std::string preset_file_, scene_file_;
    bool was_loading_ = false;
    std::vector<std::filesystem::path> watched_;
    std::set<std::filesystem::path> gone_;  // told
    std::vector<Fault> shader_faults_;
    UiShaders ui_shaders_;
    FileWatch watch_;
};

}  // namespace lapfx::app
