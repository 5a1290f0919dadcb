// Opening a smoke clip: a plain local video file that OpenCV can decode. Anything else is a fault.
#pragma once

#include <filesystem>
#include <opencv2/videoio.hpp>
#include <span>
#include <string>

namespace lapfx::smoke {

struct ClipInfo {
    cv::Size size;  ///< pixels
    double fps = 25.0;
    int frame_count = 0;  ///< frames that really decode, not what the container claims
};

/// The clip `file` of a preset: inside the preset's folder, or a bare name on the search path.
/// Throws Error (bad_input) that names `file` and where it was looked for.
std::filesystem::path find_clip(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> search_path);

/// Throws Error (bad_input): not a plain file, a playlist, not a video, of no or absurd size.
cv::VideoCapture open_clip(const std::filesystem::path& path);

/// Reads the whole file once, without converting frames. Throws like open_clip, and for a clip without
/// frames.
ClipInfo read_clip_info(const std::filesystem::path& path);

}  // namespace lapfx::smoke
