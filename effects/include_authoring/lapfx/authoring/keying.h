// A frame of a clip on its way to smoke, on the CPU: what the editor's keying bench shows. The same formulas as the
// shader's (smoke/keying_pixel.h, tests/parity/smoke/keying_test.cpp); without noise.
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
#include "lapfx/preset.h"

namespace lapfx {

/// BT.601 luma, full range: the brightness of R'G'B' code values that luma thresholds are compared with.
inline float luma(glm::vec3 code) {
    return glm::dot(code, glm::vec3(0.299f, 0.587f, 0.114f));
}

/// A frame as keying sees it, pixel after pixel. Memory is kept for the next frame.
struct KeyingFrame {
    glm::ivec2 size{0};
    std::vector<float> luma, cb, cr;  ///< code values, not rounded; Cb and Cr around 0
    std::vector<float> opacity;       ///< 0..1; empty for a clip that does not bring its own

    /// R'G'B' code values, not rounded; beyond 0..255 where the clip's are.
    glm::vec3 code(glm::ivec2 pixel) const;
};

class KeyingReader {
  public:
    /// Opens and looks through the file. Throws Error (bad_input) as report_clip() does. `stop`, if given, ends that
    /// early: Error (runtime).
    explicit KeyingReader(const std::filesystem::path& clip, const std::atomic<bool>* stop = nullptr);
    KeyingReader(KeyingReader&&) noexcept;
    KeyingReader& operator=(KeyingReader&&) noexcept;
    ~KeyingReader();

    const ClipReport& report() const;
    int frame_at(double time) const;  ///< shown at `time`, s of the clip; clamped
    double time_of(int frame) const;  ///< s
    /// 0 .. report().frames - 1, clamped. False when the file cannot give it: then it is the last good one before it,
    /// or black; without memory for it, a frame of no size. `stop`, if given, ends a long way to a frame early: false,
    /// and it is any frame or black.
    bool read(int frame, KeyingFrame& into, const std::atomic<bool>* stop = nullptr) noexcept;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// What smoke is made of it.
struct KeyingLook {
    KeyingParameters keying{};
    SmokeClip clip{};  ///< its polarity, crop, fade at the edges and masks are used; its own keying is not
    glm::dvec3 color{0.62, 0.62, 0.68};     ///< of plume or haze, sRGB
    glm::dvec3 extinction{0.85, 1.0, 1.1};  ///< of plume or haze
    double density = 1.0;                   ///< 1 is as keyed
};

/// 0..1 for each pixel, choke and feather done: a clip's own opacity, else keyed; nothing where crop and masks of
/// `clip` are.
void keyed_opacity(const KeyingFrame& frame, const KeyingParameters& keying, const SmokeClip& clip,
                   std::vector<float>& opacity);
/// Light of the smoke itself in a pixel, linear, 1 where it is grey: the clip's tint, and its shading where it brings
/// its opacity.
glm::vec3 smoke_light(const KeyingFrame& frame, const KeyingLook& look, glm::ivec2 pixel);

/// The clip as it is, code values rounded; opaque.
Image source_picture(const KeyingFrame& frame);
/// The opacity as grey; opaque.
Image matte_picture(glm::ivec2 size, std::span<const float> opacity);
/// The smoke alone, straight alpha: its colour, and how much green it holds back.
Image keyed_picture(const KeyingFrame& frame, const KeyingLook& look, std::span<const float> opacity);
/// The smoke over `background`, of which the middle is taken that has the clip's shape; sRGB. An empty one counts as
/// black.
Image composite_picture(const KeyingFrame& frame, const KeyingLook& look, std::span<const float> opacity,
                        const Image& background);

inline Image matte_picture(const KeyingFrame& frame, const KeyingLook& look) {
    std::vector<float> opacity;
    keyed_opacity(frame, look.keying, look.clip, opacity);
    return matte_picture(frame.size, opacity);
}

}  // namespace lapfx
