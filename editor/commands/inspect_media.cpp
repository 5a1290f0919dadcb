// Images and videos, through the core's decoders.
#include <cmath>
#include <cstdio>
#include <iostream>

#include "commands/inspect.h"
#include "commands/progress.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/picture.h"
#include "lapfx/authoring/printable.h"

namespace lapfx::commands {

namespace {

/// Every frame is decoded, because the claims of a file may be wrong.
DecodableFrames decodable_frames(const std::filesystem::path& file) {
    constexpr int steps = 100;
    Progress progress("decoding " + file.filename().string(), steps);
    return count_decodable_frames(file, [&](double share) {
        progress.to(share);
        return true;
    });
}

/// A time, s, rounded down to milliseconds: rounded up, "out" of a clip would play the frame that begins then.
double rounded_down(double time) {
    constexpr double inexact = 5e-4;  // ms, so that 0.5 s does not become 0.499; much less than the earliness of frames
    return std::floor(1000.0 * time + inexact) / 1000.0;
}

}  // namespace

void inspect_image(const std::filesystem::path& file) {
    const ImageFile found = read_image(file);
    constexpr const char* kinds[] = {"", "grey", "grey and alpha", "colour", "colour and alpha"};
    std::cout << printable(file.string()) << ": image\n"
              << "  size                " << found.image.width << "x" << found.image.height << '\n'
              << "  channels            " << kinds[std::min(found.channels, 4)] << ", " << found.bits << " bit\n";
}

void inspect_video(const std::filesystem::path& file) {
    const ClipReport report = report_clip(file);
    const DecodableFrames decodable = decodable_frames(file);
    const auto number = [](const char* format, double value) {
        char text[64];
        std::snprintf(text, sizeof text, format, value);
        return std::string(text);
    };
    std::cout << printable(file.string()) << ": video\n"
              << "  size                " << report.size.x << "x" << report.size.y << '\n'
              << "  frames per second   " << number("%.6g", report.frames_per_second)
              << (report.variable_frame_rate ? ", the average of a variable rate\n" : "\n")  //
              << "  frames              " << report.frames
              << (decodable.count == report.frames
                      ? ""
                      : ", of which " + std::to_string(decodable.count) + " can be decoded; the one before is shown")
              << (decodable.end < report.duration ? ", none after " + number("%.3f s", rounded_down(decodable.end)) +
                                                        " (a clip's \"out\" there leaves them out)\n"
                                                  : "\n")
              << "  duration            " << number("%.3f s", report.duration) << '\n'
              << "  codec               " << report.codec << '\n'
              << "  pixel format        " << report.pixel_format << (report.alpha ? ", with opacity\n" : "\n");
    for (const auto& [name, words] : {std::pair{"transfer ", &report.transfer},
                                      {"primaries", &report.primaries},
                                      {"scan     ", &report.scan},
                                      {"warning  ", &report.warning}})
        if (!words->empty()) std::cout << "  " << name << "           " << printable(*words) << '\n';
}

}  // namespace lapfx::commands
