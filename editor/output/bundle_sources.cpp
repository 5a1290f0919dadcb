#include "output/bundle_sources.h"

#include <algorithm>

#include "lapfx/authoring/file.h"
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

/// The path of a mesh that a scene names; empty when there is no such file.
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
                                      const std::vector<fs::path>& clip_folders, std::span<const fs::path> organ_files,
                                      std::span<const fs::path> tool_files) {
    Outside outside(folder);
    const auto add_mesh = [&](const char* what, const std::string& name, std::span<const fs::path> files) {
        const fs::path mesh = mesh_of(*scene, name);
        if (mesh.empty()) return;
        outside.add(what, mesh);
        for (const fs::path& file : files) outside.add(what, resolved(file));
    };
    if (scene != nullptr) {
        add_mesh("Organ", scene->organ.file, organ_files);
        if (const fs::path texture = mesh_of(*scene, scene->organ.texture); !texture.empty())
            outside.add("Organ", texture);
        add_mesh("Tool", scene->tool.file, tool_files);
    }
    for (const SmokeClip& clip : preset.smoke.clips) {
        const ClipFiles found = clip_files(clip.file, preset.folder, clip_folders);
        if (found.files.empty()) continue;
        const fs::path& first = found.files.front();
        if (!found.sequence) {
            outside.add("Clip", resolved(first));
            continue;
        }
        const fs::path home = resolved(first.parent_path());
        outside.add("Clip", home / found.name);
        for (const fs::path& image : found.files)  // each may be a link of its own
            if (const fs::path real = resolved(image); real.parent_path() != home) outside.add("Clip", real);
    }
    return outside.take();
}

}  // namespace lapfx::output
