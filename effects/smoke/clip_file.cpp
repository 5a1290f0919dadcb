#include "smoke/clip_file.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "lapfx/error.h"

namespace lapfx::smoke {

namespace fs = std::filesystem;

namespace {

constexpr int maximum_side = 8192;       // pixels: 8K
constexpr int maximum_frames = 100'000;  // an hour at 25 frames per second
constexpr const char* not_decodable = "is not a video that can be decoded";

Error bad_clip(const fs::path& path, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = path.string(), .place = "", .reason = reason}};
}

void require_plain_file(const fs::path& path) {
    std::error_code error;
    const auto status = fs::status(path, error);
    if (!fs::exists(status)) throw bad_clip(path, "no such file");
    if (fs::is_directory(status)) throw bad_clip(path, "is a directory; a video file is needed");
    if (!fs::is_regular_file(status)) throw bad_clip(path, "is not a plain file");
    if (fs::file_size(path, error) == 0) throw bad_clip(path, "is empty");
}

/// Playlists make FFmpeg open whatever they name; a clip is one file. All playlists are text and no video is, so that text
/// is never handed on: FFmpeg knows some of them behind comments, too.
void refuse_playlist(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, 512> head{};
    if (!file.read(head.data(), head.size()) && file.gcount() == 0) throw bad_clip(path, "cannot be read");
    const std::string_view start(head.data(), static_cast<std::size_t>(file.gcount()));
    for (const std::string_view mark : {"#EXTM3U", "ffconcat", "<?xml", "<MPD", "v=0", "[playlist]"})
        if (start.starts_with(mark)) throw bad_clip(path, "is a playlist; a clip is a single video file");
    const auto printable = [](char c) { return static_cast<unsigned char>(c) >= 0x20 || (c >= '\t' && c <= '\r'); };
    if (std::all_of(start.begin(), start.end(), printable)) throw bad_clip(path, not_decodable);
}

}  // namespace

fs::path find_clip(const std::string& file, const fs::path& preset_folder, std::span<const fs::path> search_path) {
    std::string looked_in;
    const auto try_folder = [&](const fs::path& folder) {
        looked_in += (looked_in.empty() ? "" : ", ") + (folder.empty() ? fs::path(".") : folder).string();
        std::error_code error;
        return fs::exists(folder / file, error);
    };
    if (try_folder(preset_folder)) return preset_folder / file;
    const bool bare = fs::path(file).filename() == fs::path(file);
    if (bare)
        for (const fs::path& folder : search_path)
            if (try_folder(folder)) return folder / file;
    throw bad_clip(file, "no such clip; looked in " + looked_in);
}

cv::VideoCapture open_clip(const fs::path& path) {
    require_plain_file(path);
    refuse_playlist(path);
    // An absolute path cannot be taken for a protocol such as "concat:" or a device number.
    cv::VideoCapture capture;
    bool open = false;
    try {
        open = capture.open(fs::absolute(path).string(), cv::CAP_FFMPEG);
    } catch (const cv::Exception&) {  // told below, like any other file that is no video
    }
    if (!open) throw bad_clip(path, not_decodable);
    const double width = capture.get(cv::CAP_PROP_FRAME_WIDTH), height = capture.get(cv::CAP_PROP_FRAME_HEIGHT);
    if (!(width >= 1 && height >= 1)) throw bad_clip(path, "holds no picture");
    if (width > maximum_side || height > maximum_side)
        throw bad_clip(path, "is " + std::to_string(static_cast<int>(width)) + "x" +
                                 std::to_string(static_cast<int>(height)) + " pixels; at most " +
                                 std::to_string(maximum_side) + " a side are allowed");
    return capture;
}

ClipInfo read_clip_info(const fs::path& path) {
    cv::VideoCapture capture = open_clip(path);
    ClipInfo info;
    const double fps = capture.get(cv::CAP_PROP_FPS);
    if (fps > 0.1 && fps <= 1000.0) info.fps = fps;
    cv::Mat first;
    if (!capture.read(first) || first.empty()) throw bad_clip(path, "holds no frame that can be decoded");
    info.size = first.size();
    info.frame_count = 1;
    while (info.frame_count < maximum_frames && capture.grab()) ++info.frame_count;
    return info;
}

}  // namespace lapfx::smoke
