// What a bleeding model (bleeding.h) has on the GPU: the buffers that the organ is drawn with, a uniform block, and the
// shaders that draw its blood. Render thread, context current.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "bleeding/bleeding.h"
#include "gl/objects.h"

namespace lapfx::bleeding {

/// Files of shaders/.
struct ModelShaders {
    const char *vertex, *fragment;  ///< of the program for tissue that anything has happened to
    const char* for_hosts;          ///< the part that a host pastes into its own shader
};
const ModelShaders& shaders_of(Model model);

/// Of the organ's vertex array: floats per vertex, tightly packed.
struct Attribute {
    GLuint index;
    const gl::Buffer* buffer;
    int components;
};

class BleedingGpu {
  public:
    BleedingGpu() = default;
    BleedingGpu(const BleedingGpu&) = delete;
    BleedingGpu& operator=(const BleedingGpu&) = delete;
    virtual ~BleedingGpu() = default;

    virtual Model model() const = 0;
    /// The first one is what a host's own shader gets (Effects::bleed_buffer). Number 5 is the bleed value and clot as
    /// in `spread`, which overlays show, whatever else the model draws. Valid while this object lives.
    virtual std::span<const Attribute> attributes() const = 0;

    /// `down`: unit, organ space: the direction in which rivulets run. `seed`: of the noise.
    virtual void set(const BleedingParameters& parameters, const glm::dvec3& down,
                     std::uint32_t seed) const noexcept = 0;
    /// Sends what has changed of `blood`, which is of this model, at the vertices of these runs; bytes sent.
    virtual std::size_t send(const Bleeding& blood, std::span<const VertexRun> changed) const noexcept = 0;
    /// What the shaders read besides the attributes.
    virtual void bind() const noexcept = 0;
    virtual std::size_t memory() const = 0;  ///< bytes per vertex, of all vertices
};

/// For an organ with so many vertices.
std::unique_ptr<BleedingGpu> make_bleeding_gpu(Model model, std::size_t vertices);

}  // namespace lapfx::bleeding
