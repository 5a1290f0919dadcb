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

#include "lapfx/progress.h"

namespace lapfx {

class ClipCache;
struct Preset;

struct ClipReport {
    glm::ivec2 size{0};                ///< pixels; a rotation that the file asks for is not applied
    int frames = 0;                    ///< frames in the file; one that cannot be decoded repeats the one before
    double duration = 0.0;             ///< s, including the time of the last frame
    double frames_per_second = 0.0;    ///< mean
    bool variable_frame_rate = false;  ///< some frames are shown for longer than others
    bool alpha = false;                ///< it has its own opacity
    std::string codec;                 ///< FFmpeg's name: "h264", "vp8", "png"
    std::string pixel_format;          ///< FFmpeg's name: "yuv420p"
    std::string transfer;              ///< of light to code values, and what is done with it; empty: not said
    std::string primaries;             ///< the same of its red, green and blue
    std::string scan;                  ///< "interlaced, top field first; deinterlaced"; empty: frames are whole
    std::string warning;               ///< what is unusual about a clip that plays; one line, or empty
};

/// Looks through the whole file, without decoding more than a few frames. Throws Error (bad_input): not a plain local
/// file, a playlist, not a video that can be decoded, a side over 8192 pixels.
ClipReport report_clip(const std::filesystem::path& path);

struct DecodableFrames {
    int count = 0;  ///< of ClipReport::frames
    double end =
        0.0;  ///< time at which the last of them ends, s: as SmokeClip::out it leaves out what cannot be decoded
};

/// Which frames of a clip can be decoded. This decodes all of them, and takes that long. Throws Error: bad_input as
/// report_clip(), runtime when `progress` stopped it.
DecodableFrames count_decodable_frames(const std::filesystem::path& path, const Progress& progress = {});

/// The path of the clip `file` of a preset: in the preset's folder, or, for a bare name, in one of `folders`. For
/// numbered images ("plume_%04d.png") it is the path of the pattern. Throws Error (bad_input) that names `file` and
/// says where it was looked for, or that it is a directory or not a plain file.
std::filesystem::path find_clip(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> folders);

/// Every path where the clips of a preset are looked for, in this order, whether or not a file exists there, so that
/// they can be watched. For a numbered sequence it is the folder.
std::vector<std::filesystem::path> clip_places(const Preset& preset, std::span<const std::filesystem::path> folders);

/// The images of a numbered sequence in the order in which they play: from the lowest number until one is missing.
/// `path` is what find_clip() gave. Empty when that is a single file and not a pattern.
std::vector<std::filesystem::path> clip_images(const std::filesystem::path& path);

/// Checks that every clip of a preset exists and can be decoded. Clips are looked for in its folder, and bare names
/// also in `folders`. `name` names the preset in faults. Throws Error (bad_input) with a fault for each clip that
/// cannot be used; its place is "/smoke/clips/N/file". What is found is kept in `cache`, if given.
void check_clips(const Preset& preset, const std::string& name, std::span<const std::filesystem::path> folders,
                 ClipCache* cache = nullptr);

}  // namespace lapfx
