// The noise on each layer's opacity, drawn into a tile of one small texture before the layers read it: evaluating it at
// every pixel of every layer would cost more than all the rest of the smoke. A tile covers its clip once and is
// filtered linearly, so there is neither seam nor repeat. Render thread, context current.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "gl/program.h"
#include "lapfx/preset.h"

namespace lapfx::smoke {

class NoiseTiles {
  public:
    /// Compiles its shader: throws Error (runtime).
    NoiseTiles();

    gl::Program& program() noexcept { return program_; }  ///< for gl::rebuild()
    void clear() noexcept { tiles_.clear(); }
    /// How finely a layer's noise is drawn and how it moves; layers that agree in this can share a tile.
    struct Grid {
        glm::ivec2 texels{0};
        glm::vec2 lobes{0.0f};  ///< across the clip and down
        double drift = 0.0;     ///< lobes that the noise has moved by
        bool operator==(const Grid&) const = default;
    };
    /// `aspect`: of the clip; `time`: s.
    static Grid grid(const KeyingParameters& keying, float aspect, double time);
    /// Asks for a tile with the noise of `count` (1..4) layers, a channel each; its number. Those who ask for the
    /// same (both halves of a cross-fade) get the same.
    std::size_t add(const Grid& grid, glm::ivec4 seeds, int count);
    /// Draws all tiles. Leaves its framebuffer and viewport bound; blending must be off.
    void draw() noexcept;

    /// After draw(): where tile `index` starts (xy) and how far it reaches (zw), coordinates of texture().
    glm::vec4 place(std::size_t index) const noexcept;
    GLuint texture() const { return atlas_.name(); }

  private:
    struct Tile {
        Grid grid;
        glm::ivec4 seeds;
        int count;
        bool operator==(const Tile&) const = default;
    };
    void lay_out() noexcept;

    gl::Program program_;
    gl::Texture atlas_;
    gl::Framebuffer target_;
    std::vector<Tile> tiles_;
    glm::ivec2 cell_{0};  ///< texels; tiles lie in a grid of these
    int columns_ = 1;
};

}  // namespace lapfx::smoke
