#include "support/known_smoke.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "clips/composite.h"
#include "clips/noise.h"
#include "clips/scene.h"

namespace lapfx::test {

std::vector<clips::Picture> solve_smoke(const SmokeTake& take) {
    const clips::SceneOptions options{.seed = 77, .cells_high = take.cells, .length = 5.0f};
    const auto scene = take.thin ? clips::make_thin_wisps(options) : clips::make_thick_plume(options);
    clips::Fluid fluid(scene->fluid());
    clips::Forces forces(scene->fluid().cells);
    clips::VolumeRenderer renderer(fluid.density, scene->light(), scene->view(), take.size.x, take.size.y);
    constexpr int fps = 30, apart = 8, warm_up = 45;
    constexpr float dt = 1.0f / fps;
    std::vector<clips::Picture> pictures;
    for (int frame = -warm_up; static_cast<int>(pictures.size()) < take.frames; ++frame) {
        const float time = static_cast<float>(frame) * dt;
        fluid.advect(dt, scene->eddies(time));
        scene->emit(fluid, time, dt);
        forces.clear();
        scene->stir(fluid, forces, time);
        fluid.push(forces, dt);
        if (frame >= 0 && frame % apart == 0) pictures.push_back(renderer.draw(fluid.density));
    }
    return pictures;
}

std::vector<clips::Picture> evenly_lit(std::vector<clips::Picture> smoke, float brightness, float thickness) {
    for (clips::Picture& picture : smoke)
        for (std::size_t n = 0; n < picture.alpha.size(); ++n) {
            picture.alpha[n] = 1.0f - std::pow(1.0f - picture.alpha[n], thickness);
            picture.value[n] = brightness * picture.alpha[n];
        }
    return smoke;
}

void record_smoke(const std::filesystem::path& file, const std::vector<clips::Picture>& smoke, const Recording& how) {
    clips::Encoder encoder(file, smoke.at(0).width, smoke[0].height, 4, how.quality);
    for (std::size_t i = 0; i < smoke.size(); ++i) {
        clips::RgbFrame frame = clips::over(smoke[i], how.background);
        if (how.sensor_noise > 0.0f)
            clips::add_sensor_noise(frame, how.sensor_noise, clips::hash(static_cast<std::uint32_t>(i), 5u));
        encoder.write(frame);
    }
    encoder.close();
}

std::vector<cv::Mat> read_frames(const std::filesystem::path& file) {
    cv::VideoCapture capture(file.string(), cv::CAP_FFMPEG);
    std::vector<cv::Mat> frames;
    cv::Mat bgr;
    while (capture.read(bgr)) {
        cv::cvtColor(bgr, frames.emplace_back(), cv::COLOR_BGR2RGB);
    }
    return frames;
}

AlphaError alpha_error(const std::vector<cv::Mat>& found, const std::vector<clips::Picture>& smoke) {
    double all = 0.0, inside = 0.0;
    std::size_t pixels = 0, smoky = 0;
    for (std::size_t i = 0; i < std::min(found.size(), smoke.size()); ++i)
        for (std::size_t n = 0; n < smoke[i].alpha.size(); ++n) {
            const float truth = smoke[i].alpha[n];
            const double error = static_cast<double>(std::abs(found[i].ptr<float>()[n] - truth));
            all += error, ++pixels;
            if (truth > 0.02f) inside += error, ++smoky;
        }
    const auto mean = [](double sum, std::size_t n) { return n > 0 ? sum / static_cast<double>(n) : 1.0; };
    return {mean(all, pixels), mean(inside, smoky)};
}

}  // namespace lapfx::test
