#include "output/bundle_sources.h"

#include <algorithm>

#include "lapfx/file.h"
#include "output/bundle.h"

namespace lapfx::output {

namespace fs = std::filesystem;

namespace {

fs::path resolved(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error);
    const fs::path real = fs::weakly_canonical(whole, error);
    return error ? whole.lexically_normal() : real;
}

class Outside {
  public:
    explicit Outside(const fs::path& folder) : folder_(folder.empty() ? folder : resolved(folder)) {}

    void add(const std::string& what, const fs::path& file) {
        if (folder_.empty() || is_outside(file)) {
            const SourceFile source{what, file};
            if (std::find(found_.begin(), found_.end(), source) == found_.end()) found_.push_back(source);
        }
    }
    std::vector<SourceFile> take() { return std::move(found_); }

  private:
    bool is_outside(const fs::path& file) const {
        const fs::path relative = file.lexically_relative(folder_);
        return relative.empty() || *relative.begin() == "..";
    }

    fs::path folder_;
    std::vector<SourceFile> found_;
};

/// A mesh that a scene names; empty when the name leads nowhere.
fs::path mesh_of(const Scene& scene, const std::string& file) {
    if (file.empty()) return {};
    try {
        return resolved(named_path(scene.folder, file, Reach::anywhere));
    } catch (const Error&) {
        return {};
    }
}

}  // namespace

std::vector<SourceFile> outside_files(const Preset& preset, const Scene* scene, const fs::path& folder,
                                      const std::vector<fs::path>& clip_folders,
                                      std::span<const fs::path> organ_files) {
    Outside outside(folder);
    if (scene != nullptr) {
        if (const fs::path organ = mesh_of(*scene, scene->organ.file); !organ.empty()) {
            outside.add("Organ", organ);
            for (const fs::path& file : organ_files) outside.add("Organ", resolved(file));
        }
        if (const fs::path tool = mesh_of(*scene, scene->tool.file); !tool.empty()) outside.add("Tool", tool);
    }
    for (const SmokeClip& clip : preset.smoke.clips) {
        const ClipFiles found = clip_files(clip.file, preset.folder, clip_folders);
        if (found.files.empty()) continue;
        const fs::path& first = found.files.front();
        outside.add("Clip", found.sequence ? resolved(first.parent_path()) / found.name : resolved(first));
    }
    return outside.take();
}

}  // namespace lapfx::output
