#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "bench/streaming/streaming.h"
#include "lapfx/error.h"

namespace lapfx::bench {

namespace {

const cv::Size size(720, 480);

[[noreturn]] void cannot(const std::filesystem::path& path) {
    throw Error(Failure::runtime, Fault{path.string(), "", "cannot be written: the bench needs its clips there"});
}

/// Puffs that rise and change: fields of noise, large and small, that slide over each other and are brightest in a
/// column. A camera's grain gives the encoder as much work as a real clip. `left`: remaining frames.
cv::Mat smoke(cv::RNG& random, const cv::Mat& coarse, const cv::Mat& fine, const cv::Mat& column, int left) {
    cv::Mat large, small, grain(size, CV_32F), code;
    coarse(cv::Rect(0, 2 * left, size.width, size.height)).copyTo(large);
    fine(cv::Rect(0, 3 * left, size.width, size.height)).copyTo(small);
    random.fill(grain, cv::RNG::NORMAL, 0.0, 2.0);
    const cv::Mat value = column.mul(0.7 * large + 0.3 * small) * 230.0 + 16.0 + grain;
    value.convertTo(code, CV_8U);
    cv::cvtColor(code, code, cv::COLOR_GRAY2BGR);
    return code;
}

cv::Mat field(cv::RNG& random, int lobes, int frames) {
    cv::Mat values(2 * lobes, 2 * lobes, CV_32F), whole;
    random.fill(values, cv::RNG::UNIFORM, 0.0, 1.0);
    cv::resize(values, whole, {size.width, size.height + 3 * frames}, 0, 0, cv::INTER_CUBIC);
    return whole;
}

void make(const std::filesystem::path& path, int seed, int frames) {
    cv::RNG random(static_cast<std::uint64_t>(seed) + 1);
    const cv::Mat coarse = field(random, 4, frames), fine = field(random, 16, frames);
    cv::Mat column(size, CV_32F);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const double wide = 60.0 + 0.35 * (size.height - y), off = (x - 0.5 * size.width) / wide;
            column.at<float>(y, x) = static_cast<float>(std::exp(-off * off));
        }
    cv::VideoWriter writer(path.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('D', 'I', 'V', 'X'), bench_clip_fps,
                           size);
    if (!writer.isOpened()) cannot(path);
    for (int left = frames; left > 0; --left) writer.write(smoke(random, coarse, fine, column, left));
}

}  // namespace

BenchClips::BenchClips(int count, int frames, int distinct) : frames_(frames) {
    for (int i = 0; i < count; ++i)
        if (i < distinct)
            make(path(i), i, frames);
        else
            std::filesystem::copy_file(path(i % distinct), path(i));
}

}  // namespace lapfx::bench
