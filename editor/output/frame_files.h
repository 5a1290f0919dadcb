// The files that the frames of a render are written to: one PNG, a numbered sequence of them, or a video. They appear
// together, when all have been written and read back. If the object is destroyed before, nothing of them is left, and
// older files of the same names stay as they are.
//
//     auto files = output::make_frame_files("out_%04d.png", {.fps = 25, .size = {1280, 1024}, .count = 240});
//     for (...) files->add(image);
//     while (files->check()) {}
//     files->publish();
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>

#include "lapfx/organ.h"
#include "output/codecs.h"

namespace lapfx::output {

/// Whether this is the name of one picture in a format that can be exported: out.png.
bool is_picture_name(const std::filesystem::path& name);
/// Whether this is the name of a sequence: out_%04d.png.
bool is_sequence_name(const std::filesystem::path& name);
/// The name of picture `index` in a sequence named like out_%04d.png.
std::filesystem::path sequence_name(const std::filesystem::path& pattern, int index);

struct FrameFormat {
    double fps = 25;     ///< frames per second
    glm::ivec2 size{0};  ///< px
    int count = 0;       ///< of the frames that will be added
    Codec codec = Codec::h264;
    Quality quality = Quality::good;
};

class FrameFiles {
  public:
    virtual ~FrameFiles() = default;
    virtual void add(const Image& image) = 0;
    /// Reads the next frame back; called after the last one was added. False: all have been read. Throws Error
    /// (runtime).
    virtual bool check() = 0;
    /// Gives the files their names, once they have been checked. Throws Error (runtime).
    virtual void publish() = 0;
};

/// All three functions throw Error (runtime) when files cannot be written there.
std::unique_ptr<FrameFiles> make_png_files(const std::filesystem::path& name, const FrameFormat& format);
std::unique_ptr<FrameFiles> make_video_frames(const std::filesystem::path& name, const FrameFormat& format);
/// Chooses the kind by the name (output/kinds.h).
std::unique_ptr<FrameFiles> make_frame_files(const std::filesystem::path& name, const FrameFormat& format);

}  // namespace lapfx::output
