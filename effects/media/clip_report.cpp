#include "media/clip_report.h"

#include <algorithm>

#include "lapfx/authoring/clip.h"
#include "media/clip_file.h"

namespace lapfx {

namespace {

constexpr int maximum_frames = 10'000'000;  // more than a day: surgery videos are reported, too

/// Containers usually round times to 1 ms; a larger difference is intended.
constexpr double rounding = 2e-3;  // s

bool varies(const std::vector<double>& times) {
    if (times.size() < 3) return false;
    double shortest = times[1] - times[0], longest = shortest;
    for (std::size_t i = 2; i < times.size(); ++i) {
        shortest = std::min(shortest, times[i] - times[i - 1]);
        longest = std::max(longest, times[i] - times[i - 1]);
    }
    return longest - shortest > rounding;
}

}  // namespace

ClipReport media::report_of(const ClipInfo& info) {
    ClipReport report;
    report.size = info.size;
    report.frames = info.frame_count();
    report.duration = info.duration;
    report.frames_per_second = report.frames / info.duration;
    report.variable_frame_rate = varies(info.times);
    report.alpha = info.alpha;
    report.codec = info.codec;
    report.pixel_format = info.pixel_format;
    report.transfer = info.transfer;
    report.primaries = info.primaries;
    report.scan = info.scan;
    report.warning = info.warning;
    return report;
}

ClipReport report_clip(const std::filesystem::path& path) {
    return media::report_of(media::Decoder(path, media::Layout::planar, maximum_frames).info());
}

DecodableFrames count_decodable_frames(const std::filesystem::path& path, const Progress& progress) {
    try {
        media::Decoder decoder(path, media::Layout::planar, maximum_frames);
        return decoder.count_decodable(work::Stages(progress));
    } catch (const work::Stopped&) {
        throw Error(Failure::runtime, Fault{.file = path.string(), .place = "", .reason = "was not read to its end"});
    }
}

std::filesystem::path find_clip(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> folders) {
    return media::find_clip(file, preset_folder, folders);
}

std::vector<std::filesystem::path> clip_images(const std::filesystem::path& path) {
    return media::sequence_images(path);
}

}  // namespace lapfx
