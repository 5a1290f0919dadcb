// A scene and its presets as a verb shows them, with every fault of their files found before anything is drawn.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lapfx/clip_cache.h"
#include "lapfx/error.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

/// Opens what a scene names, in place: faults name the scene and the place of the name.
class SceneFiles {
  public:
    /// Keeps a reference to the scene. `name`: the scene's file.
    SceneFiles(const Scene& scene, std::string name) : scene_(scene), name_(std::move(name)) {}

    /// Calls open(path of `file`) and keeps what it throws. A file that is not named is no fault.
    template <typename Open>
    void open(const std::string& place, const std::string& file, const Open& open) {
        if (file.empty()) return;
        try {
            open(path_of(file));
        } catch (const Error& error) {
            add(place, file, error);
        }
    }
    std::vector<Fault> take() { return std::move(faults_); }

  private:
    std::filesystem::path path_of(const std::string& file) const;
    void add(const std::string& place, const std::string& file, const Error& error);

    const Scene& scene_;
    std::string name_;
    std::vector<Fault> faults_;
};

struct ShownScene {
    Scene scene;
    std::vector<Preset> presets;       ///< there is at least one
    std::shared_ptr<ClipCache> clips;  ///< knows the clips of all presets
};

/// The scene of a file, and its presets: those in `presets`, or the one that the scene names; then each KEY=VALUE of
/// `settings`. Throws Error (bad_input): every file that is missing, of scene and presets together, and every clip that
/// cannot be decoded. What the organ's file holds is not looked at.
ShownScene open_shown(const std::string& scene, const std::vector<std::string>& presets,
                      const std::vector<std::string>& settings);

}  // namespace lapfx::commands
