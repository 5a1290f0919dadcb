// What is in each frame of a render, exactly, as files in one folder: amounts.csv, with the columns that `lapfx
// measure` writes and no interval, and view_0000.png, blood_0000.png, veil_0000.png ..., grey: the view and blood in it
// white, the veil from black (none) to white (1).
//
//     LayerFiles files("layers", 25.0, {360, 288}, 10);
//     files.add(time, preview.layers(time, {360, 288}));   // for each of the ten frames
//     while (files.check()) {}
//     files.publish();
//
// Destroyed before publish() it leaves nothing. One thread.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "lapfx/authoring/preview.h"
#include "output/frame_files.h"

namespace lapfx::output {

class LayerFiles {
  public:
    /// Makes the folder unless it is there. Throws Error (runtime) when that, or a file in it, cannot be written.
    LayerFiles(std::filesystem::path folder, double fps, glm::ivec2 size, int count);
    ~LayerFiles();
    LayerFiles(const LayerFiles&) = delete;
    LayerFiles& operator=(const LayerFiles&) = delete;

    /// The files in that folder, numbered ones by their patterns; none if `folder` is empty.
    static std::vector<std::filesystem::path> names(const std::filesystem::path& folder);

    void add(double time, const Layers& layers);
    bool check();    ///< as FrameFiles::check
    void publish();  ///< as FrameFiles::publish

  private:
    std::filesystem::path folder_;
    glm::ivec2 size_;
    bool made_ = false;                                    // the folder, by this object, and not published yet
    std::array<std::unique_ptr<FrameFiles>, 3> pictures_;  // view, blood, veil
    std::string amounts_;
};

}  // namespace lapfx::output
