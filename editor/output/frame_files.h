// Where the frames of a render go: one PNG, a numbered sequence of them, or a video. All of it appears when all of it
// is there and has been read back; dropped before, nothing is left and what was there is as it was.
//
//     auto files = output::make_frame_files("out_%04d.png", 25, {1280, 1024}, 240);
//     for (...) files->add(image);
//     while (files->check()) {}
//     files->publish();
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>

#include "lapfx/organ.h"

namespace lapfx::output {

/// out.png: one picture, whose extension an export may have.
bool is_picture_name(const std::filesystem::path& name);
/// out_%04d.png
bool is_sequence_name(const std::filesystem::path& name);
/// Number `index` of a sequence named like out_%04d.png.
std::filesystem::path sequence_name(const std::filesystem::path& pattern, int index);

class FrameFiles {
  public:
    virtual ~FrameFiles() = default;
    virtual void add(const Image& image) = 0;
    /// After the last frame: reads the next one back. False: all have been. Throws Error (runtime).
    virtual bool check() = 0;
    /// Under their names, once they have been checked. Throws Error (runtime).
    virtual void publish() = 0;
};

/// Of either; `count`: frames that will come. All throw Error (runtime) when they cannot be written there.
std::unique_ptr<FrameFiles> make_png_files(const std::filesystem::path& name, double fps, glm::ivec2 size, int count);
std::unique_ptr<FrameFiles> make_video_frames(const std::filesystem::path& name, double fps, glm::ivec2 size,
                                              int count);
/// As the name says (output/kinds.h).
std::unique_ptr<FrameFiles> make_frame_files(const std::filesystem::path& name, double fps, glm::ivec2 size, int count);

}  // namespace lapfx::output
