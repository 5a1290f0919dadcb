// Smoke of known opacity: solved like the sample clips, put over a background, encoded.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "clips/volume_renderer.h"

namespace lapfx::test {

struct SmokeTake {
    bool thin = false;  ///< wisps, otherwise a thick plume
    int cells = 48;     ///< over the height: how finely it is solved
    int frames = 12;    ///< a quarter of a second apart
    glm::ivec2 size{240, 320};
};

/// With its own light and shadows.
std::vector<clips::Picture> solve_smoke(const SmokeTake& take);

/// The same smoke with one `brightness` (0..1) everywhere, `thickness` times as thick.
std::vector<clips::Picture> evenly_lit(std::vector<clips::Picture> smoke, float brightness, float thickness = 1.0f);

struct Recording {
    glm::vec3 background{0.0f};                      ///< code values
    float sensor_noise = 1.5f;                       ///< code values, standard deviation
    std::string quality = "-crf 24 -preset medium";  ///< x264's
};

/// Throws std::runtime_error without the `ffmpeg` program.
void record_smoke(const std::filesystem::path& file, const std::vector<clips::Picture>& smoke, const Recording& how);

/// All frames, RGB. Empty when it cannot be read.
std::vector<cv::Mat> read_frames(const std::filesystem::path& file);

struct AlphaError {
    double frame = 0.0;  ///< mean absolute error over all pixels of all frames
    double smoke = 0.0;  ///< over those with an opacity above 0.02
};

/// Error of found opacities, CV_32F 0..1, against the true ones.
AlphaError alpha_error(const std::vector<cv::Mat>& found, const std::vector<clips::Picture>& smoke);

}  // namespace lapfx::test
