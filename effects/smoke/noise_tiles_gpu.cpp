#include "smoke/noise_tiles_gpu.h"

#include <algorithm>
#include <cmath>

namespace lapfx::smoke {

namespace {

constexpr double texels_per_lobe =
    8.0;  // texels per lobe of the larger octave: linear filtering is within a few hundredths of the noise
constexpr double least_texels = 16.0, most_texels = 512.0;
constexpr int most_side = 4096;            // the atlas has no longer one; every OpenGL 4.5 has 16384
constexpr double drift_into_depth = 0.35;  // of the drift: smoke changes as it moves

/// Whole lobes, wrapped around at 2^32 as the lattice is.
int whole(double lobes) {
    return static_cast<int>(
        static_cast<std::uint32_t>(static_cast<std::int64_t>(std::fmod(std::floor(lobes), 4294967296.0))));
}

float rest(double lobes) {
    return static_cast<float>(lobes - std::floor(lobes));
}

}  // namespace

NoiseTiles::NoiseTiles() : program_("fullscreen.vert", "noise_tile.frag") {}

NoiseTiles::Grid NoiseTiles::grid(const KeyingParameters& keying, float aspect, double time) {
    const double rows = std::clamp(texels_per_lobe / keying.noise_scale, least_texels, most_texels);
    const double columns = std::clamp(rows * static_cast<double>(aspect), least_texels, 2.0 * most_texels);
    const float down = static_cast<float>(1.0 / keying.noise_scale);
    return {.texels = glm::ivec2(std::lround(columns), std::lround(rows)),
            .lobes = glm::vec2(aspect * down, down),
            // Beyond this a double has no fractions left.
            .drift = std::clamp(keying.noise_drift * time / keying.noise_scale, -1e15, 1e15)};
}

std::size_t NoiseTiles::add(const Grid& grid, glm::ivec4 seeds, int count) {
    const Tile wanted{grid, seeds, count};
    const auto found = std::find(tiles_.begin(), tiles_.end(), wanted);
    if (found != tiles_.end()) return static_cast<std::size_t>(found - tiles_.begin());
    tiles_.push_back(wanted);
    return tiles_.size() - 1;
}

/// A grid of cells of the size of the largest tile; with too many tiles, all of them get coarser.
void NoiseTiles::lay_out() noexcept {
    const int count = static_cast<int>(tiles_.size());
    glm::ivec2 rows_and_columns(1);
    while (true) {
        cell_ = glm::ivec2(0);
        for (const Tile& tile : tiles_) cell_ = glm::max(cell_, tile.grid.texels);
        columns_ = std::clamp(most_side / cell_.x, 1, count);
        rows_and_columns = {columns_, (count + columns_ - 1) / columns_};
        if (rows_and_columns.y * cell_.y <= most_side || cell_.y <= 2) break;
        for (Tile& tile : tiles_) tile.grid.texels = glm::max(tile.grid.texels / 2, glm::ivec2(2));
    }
    const glm::ivec2 needed = glm::min(rows_and_columns * cell_, glm::ivec2(most_side));
    if (needed.x <= atlas_.size().x && needed.y <= atlas_.size().y) return;
    atlas_ = gl::Texture({.size = glm::max(needed, atlas_.size()), .format = GL_RGBA8});
    target_ = gl::Framebuffer(atlas_, nullptr);
}

void NoiseTiles::draw() noexcept {
    if (tiles_.empty()) return;
    lay_out();
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target_.name());
    program_.use();
    for (std::size_t i = 0; i < tiles_.size(); ++i) {
        const Tile& tile = tiles_[i];
        const double y = tile.grid.drift, z = drift_into_depth * tile.grid.drift;
        const int index = static_cast<int>(i);
        const glm::vec2 corner(glm::ivec2(index % columns_, index / columns_) * cell_);
        program_.set("u_texels", glm::vec2(tile.grid.texels));
        program_.set("u_lobes", tile.grid.lobes);
        program_.set("u_drift", glm::vec4(rest(y), rest(z), rest(2.0 * y), rest(2.0 * z)));
        program_.set("u_from", glm::ivec4(whole(y), whole(z), whole(2.0 * y), whole(2.0 * z)));
        program_.set("u_seeds", tile.seeds);
        program_.set("u_count", tile.count);
        glViewportIndexedf(0, corner.x, corner.y, static_cast<float>(tile.grid.texels.x),
                           static_cast<float>(tile.grid.texels.y));
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

glm::vec4 NoiseTiles::place(std::size_t index) const noexcept {
    const int i = static_cast<int>(index);
    const glm::vec2 corner(glm::ivec2(i % columns_, i / columns_) * cell_);
    const glm::vec2 size(atlas_.size());
    return {(corner + 0.5f) / size, (glm::vec2(tiles_[index].grid.texels) - 1.0f) / size};
}

}  // namespace lapfx::smoke
