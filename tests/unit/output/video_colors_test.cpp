// The colours of an exported video are those of its frames, whatever its number of rows: a reader that has to guess
// takes another matrix from 720 rows on.
#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "lapfx/authoring/video.h"
#include "output/files.h"
#include "unit/preset/support.h"

namespace lapfx::output {
namespace {

constexpr int patches[4][3] = {{170, 30, 25}, {200, 120, 110}, {255, 255, 255}, {12, 8, 9}};
constexpr int most = 3;  // codes: what 8 bits of a limited range lose

/// Red, tissue, white and dark, one beside the other.
Image patches_of(int width, int height) {
    Image image{.width = width, .height = height, .pixels = {}, .name = ""};
    image.pixels.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            for (const int value : patches[4 * x / width]) image.pixels.push_back(static_cast<std::uint8_t>(value));
            image.pixels.push_back(255);
        }
    return image;
}

/// The largest difference from the patches, away from their edges.
int difference(const Image& read) {
    int largest = 0;
    for (int y = 0; y < read.height; ++y)
        for (int x = 0; x < read.width; ++x) {
            const int width = read.width / 4, from_edge = std::min(x % width, width - 1 - x % width);
            if (from_edge < 16) continue;
            for (int c = 0; c < 3; ++c) {
                const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(read.width) +
                                            static_cast<std::size_t>(x)) +
                                       static_cast<std::size_t>(c);
                largest = std::max(largest, std::abs(read.pixels[at] - patches[4 * x / read.width][c]));
            }
        }
    return largest;
}

class VideoColors : public testing::TestWithParam<std::tuple<const char*, cv::Size>> {};

TEST_P(VideoColors, ComeBack) {
    const auto& [extension, size] = GetParam();
    const test::Folder folder;
    const std::filesystem::path file = folder / ("v" + std::string(extension));
    VideoFile video(file, 25.0, {size.width, size.height});
    const Image image = patches_of(size.width, size.height);
    for (int i = 0; i < 3; ++i) video.add(image);
    video.finish();
    VideoReader reader(file);
    Image read;
    ASSERT_TRUE(reader.read(1, read));
    ASSERT_EQ(cv::Size(read.width, read.height), size);
    EXPECT_LE(difference(read), most);
}

INSTANTIATE_TEST_SUITE_P(All, VideoColors,
                         testing::Combine(testing::Values(".mp4", ".mov", ".mkv", ".avi"),
                                          testing::Values(cv::Size(1280, 1024), cv::Size(640, 512))),
                         [](const auto& of) {
                             return std::string(std::get<0>(of.param) + 1) + "_" +
                                    std::to_string(std::get<1>(of.param).height);
                         });

}  // namespace
}  // namespace lapfx::output
