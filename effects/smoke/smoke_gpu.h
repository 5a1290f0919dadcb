// Draws smoke over a frame, role over role (ClipRole). Layers are collected, then drawn at once. Render thread, context
// current, the view block bound at 0.
//
//     gpu.begin(media, softness);
//     gpu.standing(role, layer, corners, bounds);  // any number, drawn in this order
//     gpu.filling(role, layer, unevenness);        // roles lie over each other in their order
//     gpu.draw(scene_depth);
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "gl/objects.h"
#include "gl/program.h"
#include "gl/timer.h"
#include "lapfx/authoring/clip_roles.h"
#include "lapfx/streaming.h"
#include "smoke/layer_gpu.h"
#include "smoke/noise_tiles_gpu.h"

namespace lapfx::smoke {

class SmokeGpu {
  public:
    /// Compiles shaders: throws Error (runtime). `timings`: measure draw() with timer queries.
    SmokeGpu(SmokeResolution resolution, bool timings);

    /// Compiles the programs for up to `count` layers of this kind, so that the first draw need not. Throws Error
    /// (runtime).
    void prepare(const SmokeClip& clip, media::Layout layout, bool alpha, const KeyingParameters& keying, int count);
    /// Pixels of the largest clip of each role: how many an off-screen target has.
    void set_clip_pixels(const PerRole<int>& pixels) noexcept;

    /// Forgets the layers of the last frame. `softness`: mm over which smoke in the scene fades where it meets things.
    void begin(const PerRole<SmokeMedium>& media, double softness) noexcept;
    /// A layer that stands in the scene. `corners`: camera space; `bounds`: of them in the view (view_bounds()).
    void standing(ClipRole which, const Layer& layer, const std::array<glm::vec3, 4>& corners,
                  glm::vec4 bounds) noexcept;
    /// A layer that fills the view.
    void filling(ClipRole which, const Layer& layer, double unevenness) noexcept;
    /// Without a clip: the same thickness, at the focus distance, everywhere.
    void even_haze(double thickness) noexcept { even_ = static_cast<float>(thickness); }

    /// Into the bound framebuffer and viewport, which it leaves bound. `scene_depth`: the depth texture of what has
    /// been drawn.
    void draw(GLuint scene_depth) noexcept;

    /// All of its programs, for gl::rebuild().
    void collect(std::vector<gl::Program*>& programs);
    std::size_t memory() const noexcept;  ///< bytes of targets on the GPU
    const gl::Timer& timer() const { return timer_; }

  private:
    enum Variant : unsigned {
        planar = 1,
        alpha = 2,
        chroma = 4,
        edges = 8,
        noise = 16,
        turned = 32,
        window = 64,
        variants = 128
    };
    static constexpr int most_together = 4;  ///< layers in one draw call: bounded by 16 texture units
    struct Drawn {
        unsigned variant;
        GLuint frames, chroma, opacity;
        std::uint32_t seed;
        NoiseTiles::Grid noise;
    };
    /// Layers that one call draws: they need the same shader and the same grid of noise.
    struct Batch {
        std::size_t first;
        int count;  ///< 1, 2 or 4
        std::size_t tile;
    };
    using Programs = std::array<std::optional<gl::Program>, variants>;  ///< the index is Variant
    /// Everything that belongs to one role.
    struct Role {
        SmokeMedium medium;
        std::array<Programs, 3> programs;  ///< for 1, 2 and 4 layers at once
        std::vector<Drawn> layers;
        std::vector<LayerBlock> blocks;  ///< parallel to layers
        std::vector<Batch> batches;
        gl::Buffer buffer;
        glm::vec4 bounds{0.0f};  ///< what the layers cover, 0..1 of the view
        int clip_pixels = 0;
        gl::Texture sum;  ///< thickness of all layers, at their clips' resolution
        gl::Framebuffer target;
        gl::Texture sum_depth;  ///< depth of the scene for layers that stand in it, as large as their sum
        gl::Framebuffer depth_target;
        gl::Program resolve;
    };
    struct HostTarget;

    static unsigned variant_of(media::Layout layout, bool alpha, bool turned, bool windowed,
                               const KeyingParameters& keying);
    void compile(ClipRole role, int count, unsigned variant);
    const gl::Program* program(ClipRole role, int count, unsigned variant) noexcept;
    void add(ClipRole role, const Layer& layer, const LayerBlock& block) noexcept;
    bool draws_together(ClipRole role) const noexcept;
    void make_batches(ClipRole role) noexcept;
    void upload(Role& role) noexcept;
    void bind(const Drawn& layer, GLuint index) const noexcept;
    void draw_layers(ClipRole role) noexcept;
    void lay_over(ClipRole role) noexcept;
    void sum_up(ClipRole role, const HostTarget& host, GLuint scene_depth) noexcept;
    void resolve(const gl::Program& program, const Role& role, glm::vec4 bounds) const noexcept;
    glm::ivec2 sum_size(ClipRole which, glm::ivec2 view) const noexcept;

    SmokeResolution resolution_;
    PerRole<Role> roles_;
    float even_ = 0.0f;
    float softness_ = 1.0f;
    glm::vec4 viewport_{0.0f};
    NoiseTiles tiles_;
    gl::Program resolve_even_, view_depth_;
    gl::VertexArray no_attributes_;
    gl::Timer timer_;
};

}  // namespace lapfx::smoke
