// Where a texture shows vessels and fat: a band pass on the converted image, then a Gaussian (paper: figure 9).
// Formulas and the choice of channel: vessel_parameters.cpp.
//
//     DensityMap map(organ, organ.materials[0].base_color_image);
//     map.set(preset.vessels);
//     const glm::vec2 here = map.sample(uv);   // vessels, fat
//
// One thread at a time for set(); sample() from any thread in between. Copies share the data that no parameter changes,
// and the map while they have the same parameters; each copy may be on its own thread.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "bleeding/texture_layout.h"
#include "lapfx/authoring/tissue_report.h"
#include "lapfx/bleeding_parameters.h"
#include "lapfx/tissue.h"
#include "organ/pixels.h"
#include "work/stages.h"

namespace cv {
class Mat;
}

namespace lapfx::bleeding {

/// Share of the surface of a texture, or of what has vertex colours, below which it shows no vessels, such as a liver's
/// capsule or a photograph without any. There every cut bleeds equally. Of the sample organ's textures with vessels, 2
/// to 4 % are vessel; of its liver and cavity wall, less than 0.01 %.
inline constexpr double least_vessels = 0.001;

/// Vessel and fat density, 0..255 for 0..1.
using Density = glm::u8vec2;

/// Whether both make the same maps.
bool same_maps(const VesselParameters& a, const VesselParameters& b);

class DensityMap {
  public:
    /// Everything that does not depend on parameters. The colour that multiplies the image (base_color of the first
    /// material that shows it) is included.
    DensityMap(const Organ& organ, int image, std::shared_ptr<const organ::Pixels> pixels);
    /// Keeps a copy of the image.
    DensityMap(const Organ& organ, int image);

    /// Whether the current map shows vessels on at least `least_vessels` of the surface.
    bool shows_vessels() const { return made_ && made_->shows_vessels; }
    /// False when the image is of one colour, so that nothing stands out; the map is then 0 without further work.
    bool tells() const { return source_->tells; }
    /// Makes the map. A length that the texture cannot resolve counts as one texel, and one that is larger than the
    /// texture as its whole size.
    void set(const VesselParameters& parameters, const work::Stages& stages = {});
    /// Gives the map away to its copies; it has no values until it is set again.
    void rest() { made_.reset(); }

    /// Adds the texels on the surface to the histograms that the bands are set on.
    void count(const VesselParameters& parameters, TissueHistogram& histogram) const;

    glm::ivec2 size() const { return source_->size; }
    /// Rows from the top, with the size of the image; empty before set().
    std::span<const Density> values() const {
        return made_ ? std::span<const Density>(made_->values) : std::span<const Density>();
    }
    const TextureLayout& layout() const { return source_->layout; }
    /// Bytes that copies share, including the map that was made last, and bytes of another map that only this copy has.
    /// Pixels are not included.
    std::size_t shared_memory() const;
    std::size_t own_memory() const;
    /// Vessels and fat, 0..1, bilinear. Beyond an edge it reads what the texture shows there, or the edge if texture
    /// coordinates stay within 0..1. NaN gives 0.
    glm::vec2 sample(glm::vec2 uv) const noexcept;

  private:
    /// A map as it was made.
    struct Made {
        VesselParameters of;
        std::vector<Density> values;
        bool shows_vessels = false;
    };
    /// The image as the band pass reads it. It takes five bytes per texel, so it exists only while a map is made.
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
        /// 1 on the surface and 0 elsewhere, and the redness on the surface, 0 elsewhere.
        void weigh(const Converted& image, cv::Mat& weights, cv::Mat& red) const;
        /// How close each texel is to the wanted colour, times its weight.
        cv::Mat colored(const Converted& image, const cv::Mat& weights, const VesselParameters& parameters) const;
    };

    std::shared_ptr<const Made> make(const VesselParameters& parameters, const work::Stages& stages) const;

    std::shared_ptr<const Source> source_;
    std::shared_ptr<const Made> made_;
};

}  // namespace lapfx::bleeding
