#include "bench/measure/speed.h"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <opencv2/imgproc.hpp>

#include "bench/scratch_folder.h"
#include "commands/session.h"
#include "lapfx/authoring/video.h"
#include "lapfx/error.h"
#include "match/use/measure_video.h"
#include "output/files.h"

namespace lapfx::bench {

namespace {

const cv::Size speed_size(720, 480);
constexpr int speed_rounds = 3;
constexpr double least_measurable = 0.9;

/// This thread, those that it starts and OpenCV's work run on one core, until this goes.
class OneCore {
  public:
    OneCore() : threads_(cv::getNumThreads()) {
        cv::setNumThreads(1);
        sched_getaffinity(0, sizeof before_, &before_);
        cpu_set_t one;
        CPU_ZERO(&one);
        CPU_SET(std::max(sched_getcpu(), 0), &one);
        sched_setaffinity(0, sizeof one, &one);
    }
    ~OneCore() {
        sched_setaffinity(0, sizeof before_, &before_);
        cv::setNumThreads(threads_);
    }
    OneCore(const OneCore&) = delete;
    OneCore& operator=(const OneCore&) = delete;

  private:
    int threads_;
    cpu_set_t before_{};
};

/// Its first frames at 720x480.
void write_speed_clip(const std::filesystem::path& file, int frames) {
    VideoReader reader(commands::data_folder() / "samples/reference/operation.mp4");
    output::VideoFile video(file, reader.info().frames_per_second, {speed_size.width, speed_size.height});
    Image image;
    cv::Mat scaled;
    for (int i = 0; i < std::min(frames, reader.info().frames); ++i) {
        reader.read(i, image);
        cv::resize(cv::Mat(image.height, image.width, CV_8UC4, image.pixels.data()), scaled, speed_size, 0, 0,
                   cv::INTER_AREA);
        video.add(
            {.width = scaled.cols, .height = scaled.rows, .pixels = {scaled.datastart, scaled.dataend}, .name = ""});
    }
    video.finish();
}

}  // namespace

double measure_over_playback(int frames) {
    const ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "speed.mp4";
    write_speed_clip(file, frames);
    const OneCore one;
    double best = 1e30, plays = 1.0;
    for (int round = 0; round < speed_rounds; ++round) {
        const auto start = std::chrono::steady_clock::now();
        VideoReader video(file);
        const match::Measurement found = match::measure_video(video, {}).found;
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        plays = video.info().duration;
        const auto measurable = std::count_if(found.frames.begin(), found.frames.end(),
                                              [](const match::FrameAmounts& f) { return f.measurable(); });
        if (static_cast<double>(measurable) < least_measurable * static_cast<double>(found.frames.size()))
            throw Error(Failure::runtime,
                        Fault{.file = "",
                              .place = "measure_over_playback_720x480",
                              .reason = "only " + std::to_string(measurable) + " of " +
                                        std::to_string(found.frames.size()) + " frames of the clip are measurable"});
    }
    return best / plays;
}

}  // namespace lapfx::bench
