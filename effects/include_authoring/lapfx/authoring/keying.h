// How a frame of a clip becomes smoke, computed on the CPU for the editor's keying bench, with the formulas of the
// shader (smoke/keying_pixel.h, tests/parity/smoke/keying_test.cpp) but without noise.
//
//     lapfx::KeyingReader reader(lapfx::find_clip("plume.mp4", preset.folder, {}));  // throws lapfx::Error: not a clip
//     lapfx::KeyingFrame frame;
//     reader.read(12, frame);
//     std::vector<float> opacity;
//     lapfx::keyed_opacity(frame, preset.smoke.keying, clip, opacity);
//     const lapfx::Image matte = lapfx::matte_picture(frame.size, opacity);
//
// Pictures have rows from the top, RGBA. Code values 0..255. Any thread; a reader one at a time. No GL.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "lapfx/authoring/clip.h"
#include "lapfx/organ.h"
#include "lapfx/smoke_parameters.h"

namespace lapfx {

/// BT.601 luma, full range: the brightness of R'G'B' code values that luma thresholds are compared with.
inline float luma(glm::vec3 code) {
    return glm::dot(code, glm::vec3(0.299f, 0.587f, 0.114f));
}

/// A frame as keying sees it, pixel after pixel. Memory is kept for the next frame.
struct KeyingFrame {
    glm::ivec2 size{0};
    std::vector<float> luma, cb, cr;  ///< code values, not rounded; Cb and Cr around 0
    std::vector<float> opacity;       ///< 0..1; empty for a clip without its own opacity

    /// R'G'B' code values, not rounded; outside 0..255 where the clip's are.
    glm::vec3 code(glm::ivec2 pixel) const;
};

class KeyingReader {
  public:
    /// Opens and looks through the file. Throws Error (bad_input) as report_clip() does. If given, `stop` ends that
    /// early with Error (runtime).
    explicit KeyingReader(const std::filesystem::path& clip, const std::atomic<bool>* stop = nullptr);
    KeyingReader(KeyingReader&&) noexcept;
    KeyingReader& operator=(KeyingReader&&) noexcept;
    ~KeyingReader();

    const ClipReport& report() const;
    int frame_at(double time) const;  ///< shown at `time`, s of the clip; clamped
    double time_of(int frame) const;  ///< s
    /// `frame` is clamped to 0 .. report().frames - 1. Gives false when the file does not have it: then `into` is the
    /// last good frame before it, or black, or without memory a frame of size 0. If given, `stop` ends a long search
    /// early: then the answer is false and `into` is any frame or black.
    bool read(int frame, KeyingFrame& into, const std::atomic<bool>* stop = nullptr) noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// How smoke is made from a frame.
struct KeyingLook {
    KeyingParameters keying{};
    SmokeClip clip{};  ///< its polarity, crop, fade at the edges and masks are used; its own keying is not
    glm::dvec3 color{0.62, 0.62, 0.68};     ///< of plume or haze, sRGB
    glm::dvec3 extinction{0.85, 1.0, 1.1};  ///< of plume or haze
    double density = 1.0;                   ///< 1 is as keyed
};

/// Opacity of each pixel, 0..1, after choke and feather: the clip's own opacity, otherwise the keyed one; 0 where crop
/// and masks of `clip` are.
void keyed_opacity(const KeyingFrame& frame, const KeyingParameters& keying, const SmokeClip& clip,
                   std::vector<float>& opacity);
/// Light of the smoke in a pixel, linear, 1 where it is grey: the tint of the clip, and its shading if it has its own
/// opacity.
glm::vec3 smoke_light(const KeyingFrame& frame, const KeyingLook& look, glm::ivec2 pixel);

/// The clip as it is, with rounded code values; opaque.
Image source_picture(const KeyingFrame& frame);
/// The opacity as grey; opaque.
Image matte_picture(glm::ivec2 size, std::span<const float> opacity);
/// The smoke alone, straight alpha: its colour, and how much green it holds back.
Image keyed_picture(const KeyingFrame& frame, const KeyingLook& look, std::span<const float> opacity);
/// The smoke over `background`, cropped around its middle to the shape of the clip; sRGB. An empty background counts as
/// black.
Image composite_picture(const KeyingFrame& frame, const KeyingLook& look, std::span<const float> opacity,
                        const Image& background);

inline Image matte_picture(const KeyingFrame& frame, const KeyingLook& look) {
    std::vector<float> opacity;
    keyed_opacity(frame, look.keying, look.clip, opacity);
    return matte_picture(frame.size, opacity);
}

}  // namespace lapfx
