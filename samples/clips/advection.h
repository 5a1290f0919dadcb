// Semi-Lagrangian advection (Stam 1999) with the MacCormack correction of Selle, Fedkiw, Kim, Liu and
// Rossignac (2008).
#pragma once

#include <cstdint>
#include <vector>

#include "field.h"
#include "noise.h"

namespace clips {

/// Which blocks of 8 x 8 x 8 samples have smoke, or may soon have some. The rest is skipped, because most of the box is
/// empty.
class ActiveBlocks {
  public:
    static constexpr int edge = 8;

    explicit ActiveBlocks(glm::ivec3 samples);

    /// Marks the blocks with a value above `threshold`, and their neighbours up to `reach` samples away.
    void find(const Field& field, float threshold, float reach);
    void set_all();
    bool operator()(int i, int j, int k) const { return blocks_[block(i / edge, j / edge, k / edge)] != 0; }

    /// Calls body(i_begin, i_end, j, k) for each active run of at most eight samples of planes [k_begin,
    /// k_end).
    template <class Body>
    void runs(int k_begin, int k_end, const Body& body) const {
        for (int k = k_begin; k < k_end; ++k)
            for (int j = 0; j < samples_.y; ++j)
                for (int b = 0; b < count_.x; ++b)
                    if (blocks_[block(b, j / edge, k / edge)])
                        body(b * edge, std::min((b + 1) * edge, samples_.x), j, k);
    }

  private:
    std::size_t block(int x, int y, int z) const { return (std::size_t(z) * count_.y + y) * count_.x + x; }

    glm::ivec3 samples_;
    glm::ivec3 count_;
    std::vector<std::uint8_t> blocks_;
};

/// Swirls that are too small for the velocity grid and affect density only. Their strength is a share of the local
/// speed: a simple form of wavelet turbulence (Kim, Thuerey, James and Gross 2008).
struct SmallEddies {
    const TurbulenceTile* tile = nullptr;
    float scale = 0.0f;     ///< tiles per cell
    glm::vec3 drift{0.0f};  ///< tiles
    float share = 0.0f;     ///< of the local speed
};

/// Advects fields that share one lattice along one velocity. Keeps its buffers from step to step.
class Advector {
  public:
    explicit Advector(const Field& lattice);

    ActiveBlocks& active() { return active_; }

    /// Follows the flow back over `dt` seconds from every active sample, with second-order Runge-Kutta.
    void trace(const Flow& flow, float dt, const SmallEddies& eddies = {});

    /// Moves one field along the traced paths. Values outside the active blocks become 0.
    void advect(Field& field);

  private:
    Field guess_;
    Field result_;
    std::vector<glm::vec3> from_;
    ActiveBlocks active_;
};

}  // namespace clips
