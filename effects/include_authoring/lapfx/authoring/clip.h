// What a video, an image or a sequence of numbered images contains.
//
//     const lapfx::ClipReport report = lapfx::report_clip("plume.webm");
//     if (!report.warning.empty()) log("plume.webm: " + report.warning);
//
// Any thread.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/progress.h"

namespace lapfx {

struct ClipReport {
    glm::ivec2 size{0};                ///< pixels; a rotation that the file asks for is not applied
    int frames = 0;                    ///< in the file; one that cannot be decoded repeats the one before
    double duration = 0.0;             ///< s, the last frame's time included
    double frames_per_second = 0.0;    ///< mean
    bool variable_frame_rate = false;  ///< some frames are shown for longer than others
    bool alpha = false;                ///< it has its own opacity
    std::string codec;                 ///< FFmpeg's name: "h264", "vp8", "png"
    std::string pixel_format;          ///< FFmpeg's name: "yuv420p"
    std::string warning;               ///< what is unusual about it, although it plays; one line, or empty
};

/// Looks through the whole file, without decoding more than a few frames. Throws Error (bad_input): not a plain local
/// file, a playlist, not a video that can be decoded, a side over 8192 pixels.
ClipReport report_clip(const std::filesystem::path& path);

struct DecodableFrames {
    int count = 0;     ///< of ClipReport::frames
    double end = 0.0;  ///< s, when the last of them is over: as SmokeClip::out it leaves out what cannot be decoded
};

/// Which of a clip's frames can be decoded. Decodes them all: takes as long as that takes. Throws Error: bad_input as
/// report_clip(), runtime when `progress` stopped it.
DecodableFrames count_decodable_frames(const std::filesystem::path& path, const Progress& progress = {});

/// Where the clip `file` of a preset is: in the preset's folder, or, a bare name, in one of `folders`; of numbered
/// images
/// ("plume_%04d.png") the pattern's place. Throws Error (bad_input) that names `file`: where it was looked for, or that
/// it is a directory or not a plain file.
std::filesystem::path find_clip(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> folders);

/// Where the clips of a preset are looked for, in this order, whether or not there is a file: for those who watch them.
/// Of a numbered sequence its folder.
std::vector<std::filesystem::path> clip_places(const Preset& preset, std::span<const std::filesystem::path> folders);

/// The images of numbered ones, as they are played: from the lowest number on, until one is missing. `path`: as
/// find_clip() found it. Empty: it is not such a pattern, but a single file.
std::vector<std::filesystem::path> clip_images(const std::filesystem::path& path);

/// Whether every clip of a preset is there and can be decoded: looked for in its folder, then, bare names, in
/// `folders`. `name` names the preset in faults. Throws Error (bad_input) with a fault for each clip that cannot be
/// used, whose place is its
/// "/smoke/clips/N/file".
void check_clips(const Preset& preset, const std::string& name, std::span<const std::filesystem::path> folders);

/// Frames per second that the threads which decode playing clips reach on this machine: all `clips` side by side, as
/// planes in main memory, `loops` times the longest of them. `threads`: 0 for as many as there are cores. Takes as long
/// as that takes. Throws Error (bad_input).
double decoding_rate(std::span<const std::filesystem::path> clips, int loops, int threads = 0);

}  // namespace lapfx
