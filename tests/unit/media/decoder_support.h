// Shared by the tests of decoded clips: clips made by the ffmpeg program, and pictures as colours.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

#include "media/decoder.h"
#include "unit/preset/support.h"

namespace lapfx::media {

namespace fs = std::filesystem;

using Bytes = std::vector<std::uint8_t>;

inline bool have_ffmpeg() {
    static const bool have = std::system("command -v ffmpeg >/dev/null 2>&1") == 0;
    return have;
}

/// A source of 30 frames that are all different, 10 in a second.
constexpr const char* moving = "-f lavfi -i testsrc2=size=64x48:rate=10:duration=3 ";

class DecoderTest : public testing::Test {
  protected:
    test::Folder folder;

    /// Runs ffmpeg in the folder; its last argument is the clip's name, whose path is returned.
    fs::path make(const std::string& arguments) const {
        const std::string command =
            "cd '" + folder.path().string() + "' && ffmpeg -nostdin -v error -y " + arguments + " >/dev/null 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << arguments;
        return folder / arguments.substr(arguments.rfind(' ') + 1);
    }

    static std::string fault(const fs::path& path) {
        const auto lines = test::faults_of([&] { Decoder(path, Layout::planar); });
        if (lines.size() != 1) return std::to_string(lines.size()) + " faults";
        EXPECT_TRUE(lines[0].starts_with(path.string() + ": ")) << lines[0];
        return lines[0].substr(std::min(lines[0].size(), path.string().size() + 2));
    }

    /// All frames in order.
    static std::vector<Bytes> frames_of(const fs::path& path, Layout layout = Layout::planar) {
        Decoder decoder(path, layout);
        std::vector<Bytes> frames;
        Picture picture;
        for (int i = 0; i < decoder.info().frame_count(); ++i) {
            decoder.read(i, picture);
            frames.push_back(picture.bytes);
        }
        return frames;
    }
};

inline glm::vec3 rgb_at(const Picture& picture, const PictureFormat& format, glm::ivec2 at) {
    const auto pixel = static_cast<std::size_t>(at.y * format.size.x + at.x);
    return {picture.bytes[3 * pixel], picture.bytes[3 * pixel + 1], picture.bytes[3 * pixel + 2]};
}

/// R'G'B' of a planar picture's pixel, chroma between its samples, whose plane covers the same area as luma's.
inline glm::vec3 planar_at(const Picture& picture, const PictureFormat& format, const ColorMatrix& color,
                           glm::ivec2 at) {
    const glm::ivec2 size = format.chroma_size();
    const std::uint8_t* chroma = picture.bytes.data() + format.color_bytes();
    const glm::vec2 place = (glm::vec2(at) + 0.5f) * glm::vec2(size) / glm::vec2(format.size) - 0.5f;
    const glm::vec2 low = glm::floor(place), part = place - low;
    const auto sample = [&](int dx, int dy) {
        const glm::ivec2 p = glm::clamp(glm::ivec2(low) + glm::ivec2(dx, dy), glm::ivec2(0), size - 1);
        const std::uint8_t* pair = chroma + 2 * (p.y * size.x + p.x);
        return glm::vec2(pair[0], pair[1]);
    };
    const glm::vec2 c =
        glm::mix(glm::mix(sample(0, 0), sample(1, 0), part.x), glm::mix(sample(0, 1), sample(1, 1), part.x), part.y);
    const float luma = picture.bytes[static_cast<std::size_t>(at.y * format.size.x + at.x)];
    return glm::clamp(color.matrix * (glm::vec3(luma, c) - color.offset), 0.0f, 255.0f);
}

}  // namespace lapfx::media
