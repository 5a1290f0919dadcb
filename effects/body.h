// The organ on the GPU: mesh, blood and burns, as the simulation says. Cutting the organ makes another body. Render
// thread, context current.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "bleeding/bleeding_gpu.h"
#include "foundation.h"
#include "lapfx/memory.h"
#include "lapfx/view.h"
#include "organ/moved_surface.h"
#include "render/clips_gpu.h"
#include "render/organ_gpu.h"
#include "simulation.h"

namespace lapfx {

class Body {
  public:
    /// For what happens in `simulation`. `programs`: for tissue. `textures`: those of the organ.
    Body(const Organ& organ, std::shared_ptr<const Foundation> foundation, const Simulation& simulation,
         std::uint32_t seed, std::shared_ptr<render::OrganPrograms> programs, render::OrganTextures textures);

    /// Parameters, gravity and densities of the simulation have changed. Throws Error (runtime) when its bleeding model
    /// is another one and the shader of that does not compile; a caller that has prepared the programs needs no care.
    void take(const Simulation& simulation);
    void set_seed(std::uint32_t seed) { seed_ = seed; }  ///< with the next take()
    /// Effects::set_shape() says what it does.
    void set_shape(std::span<const glm::vec3> positions, std::span<const glm::vec3> normals);
    void set_overlay(Overlay overlay, const Simulation& simulation);
    void set_color(glm::vec3 linear) { organ_gpu_.set_color(linear); }
    void set_projector(const glm::mat4& projector) { organ_gpu_.set_projector(projector); }  ///< as OrganGpu

    /// For a body that is not drawn any more: frees one of its textures, which can take ms; false when none is left.
    bool free_texture() noexcept { return organ_gpu_.free_texture(); }
    /// Sends what has changed in the simulation since the last call, and returns the bytes sent.
    std::size_t send(Simulation& simulation) noexcept;
    void draw() const noexcept;  ///< with the clips on it
    void draw_metal_clips() const noexcept { clips_gpu_.draw(organ_gpu_.programs().clips); }

    /// GPU memory, and what it shares with other bodies of the organ.
    MemoryUse memory_use(const Simulation& simulation) const;
    const MovedSurface& moved() const { return moved_; }
    const bleeding::BleedingGpu& blood() const { return *blood_; }
    const organ::PixelList& pixels() const { return foundation_->pixels; }

  private:
    void send_density(const bleeding::TissueDensity& density);
    std::size_t send_clips();
    std::span<const glm::vec3> follow(std::span<const glm::vec3> given, std::vector<glm::vec3>& all) const;
    void set_normals_midway();
    template <class Touched>
    void touch(std::span<const VertexRun> changed, const Touched& is_touched) noexcept;

    const Surface& surface() const { return foundation_->surface; }
    /// Like RefinedOrgan::midpoints: of the vertices at the end.
    const std::vector<glm::uvec2>& midpoints() const { return foundation_->unsplit.midpoints; }

    std::shared_ptr<const Foundation> foundation_;
    MovedSurface moved_;
    std::size_t vertices_;
    std::vector<glm::vec3> positions_, normals_;  // the moved shape, if the host does not give all of it
    std::uint32_t seed_;
    std::unique_ptr<bleeding::BleedingGpu> blood_;
    render::OrganGpu organ_gpu_;
    render::ClipsGpu clips_gpu_;
    std::vector<cautery::Clip> clips_;  // the clips that exist now
    std::vector<cautery::ClipPose> poses_;
    double clip_length_ = 0.0;  // mm
    std::uint64_t clips_version_ = 0;
    render::TouchedTriangles touched_;
    std::vector<char> is_touched_;  // per vertex
    Overlay overlay_ = Overlay::none;
    int sent_density_ = -1;  // the version that was sent
};

}  // namespace lapfx
