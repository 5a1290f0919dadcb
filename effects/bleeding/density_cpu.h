// Where a texture shows vessels and fat: a band pass on the converted image, then a Gaussian (paper: figure 9). Formulas and
// the choice of channel: vessel_parameters.cpp.
//
//     DensityMap map(organ, organ.materials[0].base_color_image);
//     map.set(preset.vessels);
//     const glm::vec2 here = map.sample(uv);   // vessels, fat
//
// One thread at a time for set(); sample() from any thread in between. Copies share what no parameter changes, and the map until
// one of them is set.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "bleeding/texture_layout_cpu.h"
#include "lapfx/preset.h"
#include "lapfx/tissue.h"
#include "organ/stages.h"

namespace cv {
class Mat;
}

namespace lapfx::bleeding {

/// Share of the surface of a texture, or of what has vertex colours, below which it shows no vessels: a liver's capsule, a
/// photograph without any. Every cut bleeds alike there. Of the sample organ's textures with vessels, 2 to 4 % are vessel;
/// of its liver and cavity wall, less than 0.01 %.
inline constexpr double least_vessels = 0.001;

/// Vessel and fat density, 0..255 for 0..1.
using Density = glm::u8vec2;

class DensityMap {
  public:
    /// Converts the image: all that does not depend on parameters. What the image multiplies (base_color of the first
    /// material that shows it) is part of the colour.
    DensityMap(const Organ& organ, int image);

    /// Whether the image shows vessels at all, as it was last made: at least `least_vessels` of the surface.
    bool shows_vessels() const { return shows_vessels_; }
    /// False when the image is of one colour, so that nothing stands out; the map is then 0 without further work.
    bool tells() const { return source_->tells; }
    /// Makes the map. Lengths that the texture cannot resolve are taken as one texel, and those beyond it as all of it.
    void set(const VesselParameters& parameters, const organ::Stages& stages = {});

    /// Adds what the bands are laid over: texels that are on the surface.
    void count(const VesselParameters& parameters, TissueHistogram& histogram) const;

    glm::ivec2 size() const { return source_->size; }
    std::span<const Density> values() const { return *values_; }  ///< rows from the top; the size of the image
    const TextureLayout& layout() const { return source_->layout; }
    std::size_t memory() const;  ///< bytes
    /// Vessels and fat, 0..1, bilinear; beyond the edges the other side where the texture repeats, else the edge. NaN: 0.
    glm::vec2 sample(glm::vec2 uv) const noexcept;

  private:
    /// The converted image.
    struct Source {
        glm::ivec2 size{0};
        TextureLayout layout;
        bool tells = false;
        std::vector<std::int16_t> redness;  // in steps of redness_step
        std::vector<glm::u8vec3> lab;       // 255 / 100 L*, a* and b* + 128

        void convert(const Image& image, const glm::vec3& factor);
        /// Where there is surface, 1 or 0, and the redness there, 0 elsewhere.
        void weigh(cv::Mat& weights, cv::Mat& red) const;
        /// How far each texel has the colour that is looked for, times its weight.
        cv::Mat colored(const cv::Mat& weights, const VesselParameters& parameters) const;
    };

    std::shared_ptr<const Source> source_;
    std::shared_ptr<const std::vector<Density>> values_;
    bool shows_vessels_ = false;
};

}  // namespace lapfx::bleeding
