// All of the core that belongs to one mesh: its surface, its blood and burns, and their places on the GPU. Cutting the organ
// makes another body. Render thread, context current.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "bleeding/bleed_cpu.h"
#include "bleeding/bleed_gpu.h"
#include "cautery/cautery.h"
#include "foundation.h"
#include "lapfx/memory.h"
#include "lapfx/preset.h"
#include "lapfx/view.h"
#include "organ/moved_surface.h"
#include "render/organ_gpu.h"

namespace lapfx {

class Body {
  public:
    /// Throws Error (runtime) when a shader does not compile. `down`: unit.
    Body(const Organ& organ, std::shared_ptr<const Foundation> foundation, glm::dvec3 down, std::uint32_t seed);

    void set(std::span<const ToolContact> contacts, const Preset& preset);
    /// Both count for all that has happened; set() has to follow.
    void set_down(glm::dvec3 down);
    void set_seed(std::uint32_t seed) { bleed_gpu_.set_seed(seed); }
    void set_contacts(std::span<const ToolContact> contacts, const Preset& preset);
    /// The scene's factor on bleeding over time.
    void set_strength(const FactorCurve& strength) { bleed_->set_strength(strength_ = strength); }
    /// As Effects::set_shape.
    void set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals);
    void set_overlay(Overlay overlay);
    void set_color(glm::vec3 linear) { organ_gpu_.set_color(linear); }
    /// Takes over the blood of `former` at the vertices that are still there (Effects::set_topology).
    void inherit(const Body& former, std::span<const std::uint32_t> origin, double time);

    /// Bytes sent to the GPU.
    std::size_t seek(double time) noexcept;
    void draw() const noexcept;

    void collect(std::vector<gl::Program*>& programs) { organ_gpu_.collect(programs); }  ///< for gl::rebuild()
    MemoryUse memory_use() const;  ///< what it shares with other bodies of the organ among it
    std::size_t left_out_wounds() const { return cautery_.left_out(); }
    /// Whether a tip at a place of the rest shape touches tissue.
    bool touches(const glm::dvec3& place) const { return cautery::touches(surface(), place); }
    const MovedSurface& moved() const { return moved_; }
    const bleeding::BleedField& bleed() const { return *bleed_; }
    const bleeding::BleedGpu& bleed_gpu() const { return bleed_gpu_; }
    const bleeding::TissueDensity& tissue() const { return tissue_; }
    const organ::PixelList& pixels() const { return foundation_->pixels; }

  private:
    static constexpr std::uint32_t gone = 0xffffffff;

    void take_wounds();
    void send_density();
    std::span<const glm::vec3> follow(std::span<const glm::vec3> given, std::vector<glm::vec3>& all) const;
    void set_normals_midway();
    template <class Touched>
    void touch(std::span<const VertexRun> changed, const Touched& is_touched) noexcept;
    std::vector<std::uint32_t> sources_of(const Body& former, std::span<const std::uint32_t> origin) const;

    const Surface& surface() const { return foundation_->surface; }
    /// As RefinedOrgan::midpoints: the last ones of the vertices.
    const std::vector<glm::uvec2>& midpoints() const { return foundation_->unsplit.midpoints; }
    std::size_t given_vertices() const { return vertices_ - midpoints().size(); }

    std::shared_ptr<const Foundation> foundation_;
    MovedSurface moved_;
    std::size_t vertices_;
    std::vector<glm::vec3> positions_, normals_;  // of the moved shape, where the host does not give all
    bleeding::TissueDensity tissue_;
    BleedingParameters bleeding_;
    FactorCurve strength_;
    std::optional<bleeding::BleedField> bleed_;
    cautery::Cautery cautery_;
    std::uint64_t wounds_version_ = 0;
    VesselParameters vessels_;
    bleeding::BleedGpu bleed_gpu_;
    render::OrganGpu organ_gpu_;
    render::TouchedTriangles touched_;
    std::vector<char> is_touched_;  // per vertex
    Overlay overlay_ = Overlay::none;
    int sent_density_ = -1;  // the version that was sent
};

}  // namespace lapfx
