// Smoke that has spread through the whole cavity and rolls slowly in front of the lens.
#include <cmath>

#include "noise.h"
#include "parallel.h"
#include "scene.h"

namespace clips {
namespace {

constexpr float refresh_rate = 0.3f;  ///< 1/s, how fast density returns to the drifting uneven pattern
constexpr float margin = 0.1f;        ///< of the box's height on every side of the picture, against inflow

class HazeScene : public Scene {
  public:
    explicit HazeScene(const SceneOptions& options)
        : options_(options),
          h_(float(options.cells_high)),
          cells_(options.cells_high * 3 / 2, options.cells_high, options.cells_high / 3),
          tile_(2, 4, 0.6f, hash(options.seed, 11)) {
        cells_ = (cells_ + 15) / 16 * 16;
    }

    FluidSettings fluid() const override {
        FluidSettings f;
        f.cells = cells_;
        f.walls.bottom = false;
        f.confinement = 1.0f;
        f.drag = 0.5f;
        f.fill = true;
        return f;
    }
    LightSettings light() const override {
        LightSettings l;
        l.extinction = 2.9f / h_;
        l.shadow = 0.6f;
        l.direct = 0.7f;
        l.ambient = 0.2f;
        return l;
    }
    ViewSettings view() const override {
        ViewSettings v;
        v.centre = 0.5f * glm::vec2(cells_);
        v.height = h_ * (1.0f - 2.0f * margin);
        return v;
    }

    void start(Fluid& fluid) override { refresh(fluid.density, 0.0f, 1.0f); }
    void emit(Fluid& fluid, float time, float dt) override {
        refresh(fluid.density, time, 1.0f - std::exp(-refresh_rate * dt));
    }
    void stir(const Fluid&, Forces& forces, float time) override {
        const float turn = time / options_.length;
        forces.add_turbulence(tile_, 1.0f / (0.9f * h_), {turn, 0.0f, -turn}, 0.16f * h_, nullptr);
    }

  private:
    void refresh(Field& density, float time, float share) const;

    SceneOptions options_;
    float h_;
    glm::ivec3 cells_;
    TurbulenceTile tile_;
};

/// Draws density towards an uneven pattern, so that the flow has something to roll up and does not mix everything
/// evenly.
void HazeScene::refresh(Field& density, float time, float share) const {
    // The pattern drifts through its own period once per clip; rows of it are evaluated coarsely and
    // interpolated.
    constexpr int period = 8;
    const glm::vec3 drift = glm::vec3(0.0f, 0.0f, float(period)) * (time / options_.length);
    const int step = 4;
    Field coarse(density.size / step + 2, density.origin, density.spacing * float(step));
    for_slabs(coarse.size.z, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j < coarse.size.y; ++j)
                for (int i = 0; i < coarse.size.x; ++i) {
                    const glm::vec3 p = coarse.position(i, j, k) * (3.0f / h_) + drift;
                    const float n = fractal3(p, period, 3, 0.5f, hash(options_.seed, 12));
                    coarse.at(i, j, k) = glm::smoothstep(-0.55f, 0.75f, n);
                }
    });
    for_slabs(density.size.z, [&](int begin, int end) {
        for (int k = begin; k < end; ++k)
            for (int j = 0; j < density.size.y; ++j)
                for (int i = 0; i < density.size.x; ++i) {
                    float& d = density.at(i, j, k);
                    d += share * (coarse.sample(density.position(i, j, k)) - d);
                }
    });
}

}  // namespace

std::unique_ptr<Scene> make_rolling_haze(const SceneOptions& options) {
    return std::make_unique<HazeScene>(options);
}

}  // namespace clips
