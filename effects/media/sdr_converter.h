// HDR and wide gamut frames as an ordinary display shows them: 8 bit, BT.709. Not thread safe.
//
// ITU-R BT.2100 has the curves of PQ and HLG (for a display of 1000 cd/m2), BT.2408 the white of SDR within them, 203
// cd/m2, and BT.1886 the display. What is brighter, or outside of the gamut, is clipped.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "media/color_tags.h"
#include "media/frame_scaler.h"

namespace lapfx::media {

class SdrConverter {
  public:
    /// A frame whose color_tags() are converted(), as R'G'B' of BT.709 in planes of 8 bit, with its opacity if it has
    /// one; `from` says how its code values are to be read. Valid until the next call. Throws as FrameScaler.
    const AVFrame& convert(const AVFrame& frame, const ClipColor& from);

  private:
    void prepare(const ColorTags& tags);
    void make_frame(const AVFrame& like, bool alpha);
    template <bool hlg>
    void convert_row(const std::uint16_t* const (&from)[3], std::uint8_t* const (&into)[3], int width) const;

    static constexpr int depth = 12;  // bits of a code value before conversion
    static constexpr std::size_t codes = std::size_t{1} << depth;
    static constexpr std::size_t roots = 4096;  // steps of the square root of light: small where the eye sees steps

    std::optional<FrameScaler> colors_, with_opacity_;
    libav::Frame made_;
    const TransferRow* transfer_ = nullptr;  ///< what the tables are for
    const PrimariesRow* primaries_ = nullptr;
    std::array<float, codes> light_{};        ///< the index is the code value
    std::array<float, roots> display_{};      ///< HLG: display's light over the scene's, by the root of luminance
    std::array<std::uint8_t, roots> code_{};  ///< the index is the root of light
    glm::mat3 gamut_{1.0f};
    glm::vec3 luminance_{0.0f};
};

}  // namespace lapfx::media
