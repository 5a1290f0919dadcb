// Writes frames as H.264 in MP4 with the `ffmpeg` program, which only these generators need, and lapfx itself does not.
//
// It converts to planar 4:2:0 itself (BT.601, limited range, as decoders assume for this size), so that black is
// exactly Y = 16 and nothing depends on the rounding of a scaler.
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "volume_renderer.h"

namespace clips {

/// RGB, 0 to 255, interleaved, rows from the top.
struct RgbFrame {
    int width = 0;
    int height = 0;
    std::vector<float> rgb;

    RgbFrame() = default;
    RgbFrame(int w, int h) : width(w), height(h), rgb(std::size_t(w) * h * 3) {}
};

class Encoder {
  public:
    /// `quality`: ffmpeg's options for the encoder, such as "-crf 20 -preset slow". Throws std::runtime_error.
    Encoder(const std::filesystem::path& file, int width, int height, int fps, const std::string& quality);
    ~Encoder();
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;

    void write(const RgbFrame& frame);
    void close();

  private:
    std::filesystem::path file_;
    int width_, height_;
    std::uint32_t frame_ = 0;
    std::FILE* pipe_ = nullptr;
    std::vector<std::uint8_t> planes_;
};

}  // namespace clips
