// Draws the smoke of a preset over a frame: its clips, placed by the burns and the haze of the simulation. Render
// thread, context current. Draw calls are noexcept and allocate nothing once a preset's clips are loaded.
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "lapfx/smoke_parameters.h"
#include "lapfx/view.h"
#include "media/clip_set.h"
#include "smoke/burns.h"
#include "smoke/particles_cpu.h"
#include "smoke/particles_gpu.h"
#include "smoke/plume.h"
#include "smoke/smoke_gpu.h"

namespace lapfx {
struct Preset;
}

namespace lapfx::smoke {

/// What there is to draw. Directions in organ space.
struct SmokeScene {
    const BurnList& burns;
    const FactorCurve& factor;  ///< the scene's, on smoke over time
    double haze = 0.0;          ///< E, optical thickness
    glm::dvec3 up{0.0};         ///< unit, where smoke rises to
    double time = 0.0;          ///< s
};

class Smoke {
  public:
    Smoke(std::uint32_t seed, const StreamingOptions& options, std::shared_ptr<ClipCache> cache = nullptr);

    /// Opens new clips and closes those that have left; everything else takes effect at once. Throws Error: bad_input
    /// for a clip that cannot be used, runtime for a shader; it then keeps the previous state. Shaders are compiled
    /// first, with and without own opacity, because only an open clip shows which of the two it needs.
    void set_preset(const Preset& preset, std::span<const std::filesystem::path> search_path);
    /// Sets everything except the clips. Those that play continue, with the parameters of the same files, except in and
    /// out points and cross-fades. Throws Error (runtime) for a shader, and then keeps the previous state.
    void set_parameters(const SmokeParameters& wanted);
    void set_seed(std::uint32_t seed) { seed_ = seed; }
    /// The next draw() begins a cycle of the clips; until this is called again, each shows the same frames.
    void update() noexcept { updated_ = true; }
    /// Into the bound framebuffer and viewport.
    void draw(const View& view, const SmokeScene& scene, GLuint scene_depth, media::Policy policy) noexcept;

    /// The parameters in use, with the clips that play.
    const SmokeParameters& parameters() const { return parameters_; }

    void collect(std::vector<gl::Program*>& programs) {  ///< for gl::rebuild()
        gpu_.collect(programs);
        programs.push_back(&particles_gpu_.program());
    }
    const media::ClipSet& clips() const { return clips_; }
    std::size_t target_memory() const noexcept { return gpu_.memory(); }  ///< bytes on the GPU
    /// GPU time of all smoke drawn so far, s, and of how many frames; 0 without StreamingOptions::gpu_timings.
    double shading_seconds() const { return gpu_.timer().seconds(); }
    std::uint64_t shaded() const { return gpu_.timer().spans(); }

  private:
    /// What a clip shows in this frame, and one entry for each place where it is drawn.
    struct ClipInFrame {
        media::ClipFrame frame;
        std::optional<media::ClipFrame> fading;
        double fade = 0.0;
    };
    void prepare(const SmokeParameters& wanted, const std::function<std::optional<bool>(std::size_t)>& alpha);
    void take_wanted();
    media::ClipFrame clip_frame(std::size_t clip, int head, int index, media::Policy policy) noexcept;
    ClipInFrame show(std::size_t clip, double time, media::Policy policy) noexcept;
    void add_layers(const View& view, const SmokeScene& scene, media::Policy policy) noexcept;
    Layer layer(std::size_t clip, double time) const noexcept;
    void add_plumes(std::size_t clip, double share, const View& view, const SmokeScene& scene,
                    media::Policy policy) noexcept;
    bool add_haze(std::size_t clip, double time, double density, media::Policy policy) noexcept;
    void draw_particles(const SmokeScene& scene, GLuint scene_depth) noexcept;

    std::uint32_t seed_;
    StreamingOptions options_;
    SmokeParameters parameters_;
    // Kept, so that setting values while they are dragged allocates nothing.
    SmokeParameters wanted_;
    std::vector<bool> used_;  // each clip that is set has one: one that plays has taken its values
    media::ClipSet clips_;    // parallel to parameters_.clips
    bool updated_ = true;     // nothing has been drawn since
    std::array<Particle, most_particles> particles_;
    SmokeGpu gpu_;
    ParticlesGpu particles_gpu_;
};

}  // namespace lapfx::smoke
