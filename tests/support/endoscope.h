// Pictures as an endoscope gives them, made by formula: tissue of known colours, its round view, smoke of known
// thickness.
#pragma once

#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "lapfx/organ.h"

namespace lapfx::test {

/// Reddish tissue with patches, streaks and grain of several sizes: no place is like another.
inline Image tissue_picture(glm::ivec2 size, unsigned seed = 1) {
    cv::RNG random(seed);
    cv::Mat1f height(size.y, size.x, 0.0f);
    for (const int cells : {6, 16, 48, 120}) {
        cv::Mat1f coarse(std::max(2, cells * size.y / size.x), cells);
        random.fill(coarse, cv::RNG::UNIFORM, -1.0, 1.0);
        cv::Mat1f wide;
        cv::resize(coarse, wide, height.size(), 0, 0, cv::INTER_CUBIC);
        height += wide * (1.2 / std::sqrt(cells));
    }
    Image image{.width = size.x, .height = size.y, .pixels = {}, .name = "tissue"};
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const float h = height(y, x);
            for (const float value : {170.0f + 60.0f * h, 80.0f + 55.0f * h, 70.0f + 40.0f * h})
                image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(value, 30.0f, 225.0f)));
            image.pixels.push_back(255);
        }
    return image;
}

/// Makes black what is outside of the circle.
inline Image behind_round_view(Image image, glm::dvec2 center, double radius) {
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (glm::distance(glm::dvec2(x, y) + 0.5, center) > radius)
                for (std::size_t c = 0; c < 3; ++c)
                    image.pixels[4 * static_cast<std::size_t>(y * image.width + x) + c] = 0;
    return image;
}

/// An even veil of grey before it, in code values: enough to be told from none.
inline Image veiled(Image image, double transmission) {
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        if (i % 4 != 3)
            image.pixels[i] =
                static_cast<std::uint8_t>(std::lround(image.pixels[i] * transmission + 200.0 * (1.0 - transmission)));
    return image;
}

inline void write_picture(const std::filesystem::path& file, const Image& image) {
    const cv::Mat4b pixels(image.height, image.width,
                           reinterpret_cast<cv::Vec4b*>(const_cast<std::uint8_t*>(image.pixels.data())));
    cv::Mat3b stored;
    cv::cvtColor(pixels, stored, cv::COLOR_RGBA2BGR);
    if (!cv::imwrite(file.string(), stored)) throw std::runtime_error("cannot write " + file.string());
}

/// Numbered images, which read as a video of 25 frames a second: "frame_%03d.png" of the folder.
inline std::filesystem::path write_video(const std::filesystem::path& folder, const std::vector<Image>& frames) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "frame_%03zu.png", i);
        write_picture(folder / name, frames[i]);
    }
    return folder / "frame_%03d.png";
}

inline glm::ivec3 pixel(const Image& image, glm::ivec2 at) {
    const std::size_t i = 4 * static_cast<std::size_t>(at.y * image.width + at.x);
    return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

}  // namespace lapfx::test
