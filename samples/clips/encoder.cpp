#include "encoder.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "noise.h"

namespace clips {
namespace {

std::string quoted(const std::string& text) {
    std::string out = "'";
    for (char c : text) {
        if (c == '\'')
            out += "'\\''";
        else
            out += c;
    }
    return out + "'";
}

/// One plane value from weighted RGB, rounded with a little noise so that smooth smoke does not band. Black
/// and other exact values stay exact: the noise never moves a whole number.
std::uint8_t quantized(float value, std::uint32_t position, std::uint32_t frame) {
    const float dither = 0.98f * (uniform(hash(position, frame)) - 0.5f);
    return std::uint8_t(std::clamp(std::lround(value + dither), 0L, 255L));
}

}  // namespace

Encoder::Encoder(const std::filesystem::path& file, int width, int height, int fps, const std::string& quality)
    : file_(file), width_(width), height_(height), planes_(std::size_t(width) * height * 3 / 2) {
    // One thread and no version stamps: the bytes depend only on the frames and on the encoder's version.
    const std::string command =
        "ffmpeg -v error -y -f rawvideo -pix_fmt yuv420p -s " + std::to_string(width) + "x" + std::to_string(height) +
        " -r " + std::to_string(fps) + " -i - -an -c:v libx264 -threads 1 " + quality +
        " -pix_fmt yuv420p -color_range tv -colorspace smpte170m -color_primaries smpte170m -color_trc "
        "smpte170m"
        " -map_metadata -1 -fflags +bitexact -flags:v +bitexact -movflags +faststart " +
        quoted(file.string());
    pipe_ = popen(command.c_str(), "w");
    if (!pipe_) throw std::runtime_error(file.string() + ": cannot start ffmpeg");
}

Encoder::~Encoder() {
    if (pipe_) pclose(pipe_);
}

void Encoder::write(const RgbFrame& frame) {
    const std::size_t w = std::size_t(width_), h = std::size_t(height_);
    const auto rgb = [&](std::size_t x, std::size_t y) { return frame.rgb.data() + 3 * (y * w + x); };
    for (std::size_t y = 0; y < h; ++y)
        for (std::size_t x = 0; x < w; ++x) {
            const float* c = rgb(x, y);
            const float luma = 0.299f * c[0] + 0.587f * c[1] + 0.114f * c[2];
            planes_[y * w + x] = quantized(16.0f + luma * (219.0f / 255.0f), std::uint32_t(y * w + x), frame_);
        }
    std::uint8_t* cb = planes_.data() + w * h;
    std::uint8_t* cr = cb + w * h / 4;
    for (std::size_t y = 0; y < h; y += 2)
        for (std::size_t x = 0; x < w; x += 2) {
            float r = 0.0f, g = 0.0f, b = 0.0f;
            for (std::size_t n = 0; n < 4; ++n) {
                const float* c = rgb(x + (n & 1), y + (n >> 1));
                r += 0.25f * c[0], g += 0.25f * c[1], b += 0.25f * c[2];
            }
            const float luma = 0.299f * r + 0.587f * g + 0.114f * b;
            const std::size_t n = y / 2 * (w / 2) + x / 2;
            cb[n] = std::uint8_t(std::lround(128.0f + (b - luma) * (112.0f / (255.0f * 0.886f))));
            cr[n] = std::uint8_t(std::lround(128.0f + (r - luma) * (112.0f / (255.0f * 0.701f))));
        }
    ++frame_;
    if (std::fwrite(planes_.data(), 1, planes_.size(), pipe_) != planes_.size())
        throw std::runtime_error(file_.string() + ": ffmpeg stopped reading");
}

void Encoder::close() {
    std::FILE* pipe = pipe_;
    pipe_ = nullptr;
    if (pclose(pipe) != 0) throw std::runtime_error(file_.string() + ": ffmpeg failed");
}

}  // namespace clips
