// Shows the colours of a picture: a vectorscope of its CbCr and a waveform of its luma. Counting is done by pure
// functions. Levels are 0..255, full range, as in keying.
#pragma once

#include <optional>

#include "ui/canvas/view.h"

namespace lapfx::ui {

/// Luma 0..255, Cb and Cr -127.5..127.5 of full-range code values by BT.601: (B - Y) / 1.772 and (R - Y) / 1.402.
glm::vec3 luma_chroma(glm::vec3 code);
/// Back; not clamped.
glm::vec3 rgb_of(glm::vec3 luma_chroma);

inline constexpr int scope_side = 256;  ///< cells
/// Cells counted, rows from the top. Kept and reused.
struct DensityGrid {
    std::vector<std::uint32_t> counts;
    std::uint32_t at(int x, int y) const { return counts[static_cast<std::size_t>(y * scope_side + x)]; }
};

/// Pixels of 8 bits; `channels` 3 or 4, red first, rows without gaps. Every `every`-th pixel of every `every`-th row
/// counts. Throws std::invalid_argument when there are fewer bytes than the size asks for.
struct ScopeSource {
    std::span<const std::uint8_t> bytes;
    glm::ivec2 size{0};
    int channels = 3;
    int every = 1;
};
/// Column round(Cb) + 128, row 128 - round(Cr), clamped.
void count_chroma(const ScopeSource& source, DensityGrid& grid);
/// Column by place across the picture, row 255 - round(luma).
void count_luma(const ScopeSource& source, DensityGrid& grid);

/// RGBA of scope_side squared: brighter the more, by the logarithm, so that single pixels show; the vectorscope in the
/// colours meant.
void shade_chroma(const DensityGrid& grid, std::vector<std::uint8_t>& rgba);
void shade_luma(const DensityGrid& grid, Color color, std::vector<std::uint8_t>& rgba);

/// A scope's image, which is made again when the picture changes.
class ScopeImage {
  public:
    explicit ScopeImage(ImageStore& store) : store_(store) {}
    ~ScopeImage();
    ScopeImage(const ScopeImage&) = delete;
    ScopeImage& operator=(const ScopeImage&) = delete;

    void update_chroma(const ScopeSource& source);
    void update_luma(const ScopeSource& source, Color color = {190, 215, 200, 255});
    ImageHandle handle() const { return handle_; }  ///< 0: never updated

  private:
    void send();
    ImageStore& store_;
    DensityGrid grid_;
    std::vector<std::uint8_t> rgba_;
    ImageHandle handle_ = 0;
};

/// A key colour and how far from it keying reaches, in code values of chroma.
struct KeyCircles {
    glm::vec3 color{0, 255, 0};  ///< code values
    double chroma_low = 20, chroma_high = 60;
    double reset_low = 20, reset_high = 60;                     ///< saved: Backspace on a circle goes back to it
    std::optional<double> initial_low = {}, initial_high = {};  ///< default, for Shift+Backspace; none: the saved one
};

struct VectorscopeOptions {
    float zoom = 1;  ///< 1 to 8: around no colour
    std::string_view tip = {};
    Size width = grow(), height = grow();
};
struct VectorscopeResult {
    Edit low, high;
    bool over = false;
    glm::vec2 chroma{0};  ///< Cb and Cr under the pointer
};
/// Square, in the middle of its node. With `key`: the colour's mark and two circles, "Chroma low" and "Chroma high", to
/// drag; low stays 1 below high.
VectorscopeResult vectorscope(Ui& ui, std::string_view label, ImageHandle image, KeyCircles* key,
                              const VectorscopeOptions& options = {});

struct WaveformOptions {
    std::string_view tip = {};
    Size width = grow(), height = grow();
};
/// Reads out the luma under the pointer as its text.
void waveform(Ui& ui, std::string_view label, ImageHandle image, const WaveformOptions& options = {});

}  // namespace lapfx::ui
