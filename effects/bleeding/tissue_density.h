// Vessel and fat density anywhere on an organ, from its textures or, where it has none, from its vertex colours.
//
//     TissueDensity tissue(organ, surface, preset.vessels);
//     if (tissue.wound_strength(tip) > 0.0) ...                  // a cut here bleeds
//
// A copy refers to the same surface, shares the data that no parameter changes, and has its own parameters. Where
// neither textures nor vertex colours say anything (a single colour), vessels count as even: density 1, fat 0, strength
// 1. set() and the constructor on one thread; the rest is const and may run on any.
#pragma once

#include <memory>
#include <optional>

#include "bleeding/density.h"
#include "lapfx/authoring/tissue_report.h"
#include "lapfx/tissue.h"
#include "organ/surface.h"

namespace lapfx::bleeding {

class TissueDensity {
  public:
    /// Keeps a reference to `surface`, which must be that of `organ`; copies what it needs from the organ. `pixels` are
    /// those of the organ's images if these have none; when empty, the pixels of the images are copied.
    TissueDensity(const Organ& organ, const Surface& surface, const VesselParameters& parameters = {},
                  const work::Stages& stages = {}, organ::PixelList pixels = {});

    /// Live: maps are made again only when a parameter that they depend on has changed. Throws when there is not enough
    /// memory, and then changes nothing.
    void set(const VesselParameters& parameters);
    /// Gives its maps away to copies; this object then has none.
    void rest();

    /// Means over the region of influence: a disc of radius `region` around the nearest place of the surface. NaN: 0.
    TissueSample sample(const glm::dvec3& position) const noexcept;
    double vessels(const glm::dvec3& position) const noexcept { return sample(position).vessels; }
    double fat(const glm::dvec3& position) const noexcept { return sample(position).fat; }
    /// How strongly a cut here bleeds, times the preset's speed: 0 when the density of vessels is below
    /// `vessel_threshold`, else 1 + vessel_strength * (density / vessel_reference - 1), at most 4. 1 where nothing
    /// shows vessels: no colour, or a texture without vessels.
    double wound_strength(const glm::dvec3& position) const noexcept;
    TissueReport report() const;
    TissueHistogram histogram(const VesselParameters& parameters) const;  ///< whatever was set

    /// For the overlay: the map of an image, or null where the image says nothing.
    const DensityMap* map(int image) const;
    std::size_t images() const { return maps_.size(); }
    /// For the overlay, per organ vertex: densities that come from vertex colours; 1 and 0 where nothing is known; 1
    /// and 1 where there is a map, because these values multiply it.
    const std::vector<glm::vec2>& vertex_values() const { return vertex_values_; }
    /// Rises whenever the densities have changed.
    int version() const { return version_; }
    /// Bytes that copies share, and bytes of this object alone. Pixels are not included.
    std::size_t shared_memory() const;
    std::size_t own_memory() const;

  private:
    static constexpr int by_vertex = -1, unknown = -2;
    struct Tissue {
        glm::vec2 density{0.0f};
        bool known = false;
        bool tells = false;  // of vessels
    };
    /// What no parameter changes.
    struct Mesh {
        std::vector<int> source;          // per triangle: a map, by_vertex or unknown
        std::vector<glm::uvec3> corners;  // per triangle: organ vertices
        std::vector<glm::vec2> uvs;
        std::vector<glm::vec3> points;      // per vertex, mm; empty when no triangle is by_vertex
        std::vector<float> areas, redness;  // per vertex; mm2
        std::vector<glm::vec3> lab;         // per vertex
    };
    void find_sources(const Organ& organ, Mesh& mesh) const;
    static void take_colors(const Organ& organ, const organ::PixelList& pixels, Mesh& mesh);
    void make(const VesselParameters& parameters, const work::Stages& stages);
    std::vector<std::optional<DensityMap>> made_maps(const VesselParameters& parameters,
                                                     const work::Stages& stages) const;
    void set_vertices(const VesselParameters& parameters);
    bool tells(int source) const noexcept;
    Tissue at(std::uint32_t triangle, const glm::dvec3& weights) const noexcept;
    Tissue mean(const glm::dvec3& position) const noexcept;
    double strength_of(const Tissue& here) const noexcept;

    const Surface& surface_;
    VesselParameters parameters_;
    std::vector<std::optional<DensityMap>> maps_;  // per image; none where it says nothing
    std::shared_ptr<const Mesh> mesh_;
    std::vector<glm::vec2> vertex_values_;
    bool vertices_show_vessels_ = false, rests_ = false;
    int version_ = 0;
};

}  // namespace lapfx::bleeding
