// Whole videos for tests, as numbered pictures that are painted (pictures.h); 25 frames per second. Each has half of
// the width and height of pictures.h: what a video costs goes by its pixels.
#pragma once

#include <cstdio>
#include <filesystem>

#include "output/files.h"
#include "unit/match/pictures.h"
#include "unit/preset/support.h"

namespace lapfx::match::test {

inline cv::Mat smoky(const cv::Mat& picture, double veil) {
    return veiled(picture, cv::Mat(picture.size(), CV_32F, cv::Scalar(veil)), light_of({}));
}

/// White foil that fills the view.
inline cv::Mat bag() {
    cv::Mat white;
    cv::transform(tissue(77777), white, cv::Matx33f(0, 0, 1.2F, 0, 0, 1.15F, 0, 0, 1.25F));
    return white;
}

class Clip {
  public:
    void add(const cv::Mat& linear, int times = 1) {
        cv::Mat half;
        cv::resize(linear, half, linear.size() / 2, 0, 0, cv::INTER_AREA);
        for (int i = 0; i < times; ++i) {
            char name[32];
            std::snprintf(name, sizeof name, "f_%04d.png", count_++);
            output::write_png(folder / name, image_of(half));
        }
    }
    std::filesystem::path video() const { return folder / "f_%04d.png"; }

    lapfx::test::Folder folder;

  private:
    int count_ = 0;
};

}  // namespace lapfx::match::test
