// Where a texture shows vessels and fat: a band pass on the converted image, then a Gaussian (paper: figure 9).
// Formulas and the choice of channel: vessel_parameters.cpp.
//
//     DensityMap map(organ, organ.materials[0].base_color_image);
//     map.set(preset.vessels);
//     const glm::vec2 here = map.sample(uv);   // vessels, fat
//
// One thread at a time for set(); sample() from any thread in between. Copies share what no parameter changes, and the
// map as long as they are set to the same; each may be on a thread of its own.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "bleeding/texture_layout.h"
#include "lapfx/authoring/tissue_report.h"
#include "lapfx/preset.h"
#include "lapfx/tissue.h"
#include "organ/pixels.h"
#include "work/stages.h"

namespace cv {
class Mat;
}

namespace lapfx::bleeding {

/// Share of the surface of a texture, or of what has vertex colours, below which it shows no vessels: a liver's
/// capsule, a photograph without any. Every cut bleeds alike there. Of the sample organ's textures with vessels, 2 to 4
/// % are vessel; of its liver and cavity wall, less than 0.01 %.
inline constexpr double least_vessels = 0.001;

/// Vessel and fat density, 0..255 for 0..1.
using Density = glm::u8vec2;

/// Whether both make the same maps.
bool same_maps(const VesselParameters& a, const VesselParameters& b);

class DensityMap {
  public:
    /// All that does not depend on parameters. What the image multiplies (base_color of the first material that shows
    /// it) is part of the colour.
    DensityMap(const Organ& organ, int image, std::shared_ptr<const organ::Pixels> pixels);
    /// Keeps a copy of the image.
    DensityMap(const Organ& organ, int image);

    /// Whether the image shows vessels at all, as it was last made: at least `least_vessels` of the surface.
    bool shows_vessels() const { return made_ && made_->shows_vessels; }
    /// False when the image is of one colour, so that nothing stands out; the map is then 0 without further work.
    bool tells() const { return source_->tells; }
    /// Makes the map. Lengths that the texture cannot resolve are taken as one texel, and those beyond it as all of it.
    void set(const VesselParameters& parameters, const work::Stages& stages = {});
    /// Leaves the map to its copies: until it is set it has no values.
    void rest() { made_.reset(); }

    /// Adds what the bands are laid over: texels that are on the surface.
    void count(const VesselParameters& parameters, TissueHistogram& histogram) const;

    glm::ivec2 size() const { return source_->size; }
    /// Rows from the top; the size of the image, or none before it is set.
    std::span<const Density> values() const {
        return made_ ? std::span<const Density>(made_->values) : std::span<const Density>();
    }
    const TextureLayout& layout() const { return source_->layout; }
    /// Bytes that copies share, the map that was made last among them; and those of a map that is another one. Pixels
    /// are neither's.
    std::size_t shared_memory() const;
    std::size_t own_memory() const;
    /// Vessels and fat, 0..1, bilinear; beyond the edges the other side where the texture repeats, else the edge. NaN:
    /// 0.
    glm::vec2 sample(glm::vec2 uv) const noexcept;

  private:
    /// A map as it was made.
    struct Made {
        VesselParameters of;
        std::vector<Density> values;
        bool shows_vessels = false;
    };
    /// The image in the terms of the band pass; five bytes a texel, so it is there while a map is made and no longer.
    struct Converted {
        std::vector<std::int16_t> redness;  // in steps of redness_step
        std::vector<glm::u8vec3> lab;       // 255 / 100 L*, a* and b* + 128
    };
    struct Source {
        glm::ivec2 size{0};
        TextureLayout layout;    // without `used`
        std::vector<bool> used;  // TextureLayout::used
        glm::vec3 factor{1.0f};
        bool tells = false;
        std::shared_ptr<const organ::Pixels> pixels;
        mutable std::mutex mutex;
        mutable std::shared_ptr<const Made> newest;  // under the mutex

        bool of_one_color() const;
        Converted convert() const;
        /// Where there is surface, 1 or 0, and the redness there, 0 elsewhere.
        void weigh(const Converted& image, cv::Mat& weights, cv::Mat& red) const;
        /// How far each texel has the colour that is looked for, times its weight.
        cv::Mat colored(const Converted& image, const cv::Mat& weights, const VesselParameters& parameters) const;
    };

    std::shared_ptr<const Made> make(const VesselParameters& parameters, const work::Stages& stages) const;

    std::shared_ptr<const Source> source_;
    std::shared_ptr<const Made> made_;
};

}  // namespace lapfx::bleeding
