// The smoke of a preset over a frame: glue of the CPU part (haze and plume over time, decoding) and the GPU
// part. Render thread, context current. Draw calls are noexcept and allocate nothing once a preset's clips
// are loaded.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lapfx/preset.h"
#include "lapfx/tool.h"
#include "smoke/clip_textures.h"
#include "smoke/haze_cpu.h"
#include "smoke/particles_cpu.h"
#include "smoke/particles_gpu.h"
#include "smoke/plume_cpu.h"
#include "smoke/smoke_gpu.h"

namespace lapfx::smoke {

class Smoke {
  public:
    explicit Smoke(std::uint32_t seed);

    /// Opens clips that are new and closes those that are gone; the rest takes effect at once.
    /// Throws Error (bad_input) for a clip that cannot be used, and keeps what it had.
    void set_preset(const Preset& preset, std::span<const std::filesystem::path> search_path);
    /// `fat`: 0..1 for each contact, of the tissue there; it smokes more (PlumeParameters::fat_gain).
    void set_contacts(std::span<const ToolContact> contacts, std::span<const double> fat);

    /// `view`: organ space to camera space; `up`: unit, where smoke rises to.
    void draw(const glm::mat4& view, glm::dvec3 up, double time, GLuint scene_depth, Policy policy) noexcept;

    /// E(t) of the haze.
    double haze(double time) const noexcept { return haze_.density(time); }

  private:
    struct Clip {
        std::filesystem::path path;
        std::shared_ptr<ClipTextures> textures;
    };
    void set_haze();
    const gl::Texture& frame_at(std::size_t clip, double time, Policy policy) noexcept;
    void draw_plume(std::size_t clip, const glm::mat4& view, glm::dvec3 up, double time, Policy policy) noexcept;
    void draw_particles(glm::dvec3 up, double time, GLuint scene_depth) noexcept;
    void draw_even_haze(double time) noexcept;
    void draw_haze(std::size_t clip, double time, double share, Policy policy) noexcept;

    std::uint32_t seed_;
    SmokeParameters parameters_;
    std::vector<Clip> clips_;  // parallel to parameters_.clips
    std::vector<ToolContact> contacts_;
    std::vector<double> fat_;  // parallel to contacts_
    HazeCurve haze_;
    std::vector<Emission> emissions_;
    std::vector<Suction> suctions_;
    std::array<Particle, most_particles> particles_;
    SmokeGpu gpu_;
    ParticlesGpu particles_gpu_;
    gl::Texture no_frame_;  // black, for haze without a clip
};

}  // namespace lapfx::smoke
