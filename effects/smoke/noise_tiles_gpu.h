// The noise on each layer's opacity, drawn into a tile of one small texture before the layers read it: evaluating it at
// every pixel of every layer would cost more than the rest of the smoke. A tile covers its clip once and is filtered
// linearly, so it has no seam and does not repeat. Render thread, context current.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/objects.h"
#include "gl/program.h"
#include "lapfx/smoke_parameters.h"

namespace lapfx::smoke {

class NoiseTiles {
  public:
    /// Compiles its shader: throws Error (runtime).
    NoiseTiles();

    gl::Program& program() noexcept { return program_; }  ///< for gl::rebuild()
    void clear() noexcept { tiles_.clear(); }
    /// How fine a layer's noise is and how it moves; layers with the same values can share a tile.
    struct Grid {
        glm::ivec2 texels{0};
        glm::vec2 lobes{0.0f};  ///< across the clip and down
        double drift = 0.0;     ///< lobes that the noise has moved by
        bool operator==(const Grid&) const = default;
    };
    /// `aspect`: of the clip; `time`: s.
    static Grid grid(const KeyingParameters& keying, float aspect, double time);
    /// Asks for a tile with the noise of `count` (1..4) layers, one channel each, and gives its number. Equal requests
    /// (both halves of a cross-fade) get the same tile.
    std::size_t add(const Grid& grid, glm::ivec4 seeds, int count);
    /// Draws all tiles. Leaves its framebuffer and viewport bound; blending must be off.
    void draw() noexcept;

    /// After draw(): start (xy) and size (zw) of tile `index`, in coordinates of texture().
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
    glm::ivec2 cell_{0};  ///< texels; tiles are in a grid of such cells
    int columns_ = 1;
};

}  // namespace lapfx::smoke
