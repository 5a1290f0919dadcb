// Smoke that rises from the tool tip: the thick plume and the thin wisps, which differ only in numbers.
#include <cmath>

#include "noise.h"
#include "parallel.h"
#include "scene.h"

namespace clips {
namespace {

/// Lengths are in heights of the picture (H), times in seconds.
struct PlumeNumbers {
    int sources = 1;
    int detail = 2;            ///< density samples per cell and axis
    float radius = 0.022f;     ///< H
    float wander = 0.01f;      ///< H, how far a source moves from the tip
    float wander_rate = 2.0f;  ///< 1/s
    float density = 1.0f;
    float heat = 1.0f;
    float expansion = 14.0f;   ///< 1/s in the source
    float jet = 0.4f;          ///< H/s
    float sway = 0.3f;         ///< H/s, sideways
    float puff_rate = 2.4f;    ///< 1/s
    float puff_depth = 0.5f;   ///< 0: steady, 1: stops between puffs
    float grain = 60.0f;       ///< 1/H, lumps in the source
    float lift = 2.2f;         ///< H/s^2
    float cooling = 0.5f;      ///< 1/s
    float viscosity = 4e-5f;   ///< H^2/s
    float confinement = 0.4f;  ///< 1/s
    float stir = 5.0f;         ///< H/s^2
    float stir_size = 0.26f;   ///< H, edge of a turbulence tile
    int stir_lobes = 6;
    float stir_gain = 1.0f;   ///< 1 over the density from which it is stirred fully
    float eddies = 0.12f;     ///< share of the local speed
    float eddy_size = 0.12f;  ///< H, edge of a tile
    float fade = 0.1f;        ///< 1/s near the source
    float fade_high = 1.3f;   ///< 1/s near the top
    float erosion = 0.03f;    ///< density/s taken from everywhere: thins edges into wisps
    LightSettings light;
    float extinction = 130.0f;  ///< 1/H
};

class PlumeScene : public Scene {
  public:
    PlumeScene(const SceneOptions& options, const PlumeNumbers& numbers)
        : options_(options),
          n_(numbers),
          h_(float(options.cells_high)),
          cells_(options.cells_high * 2 / 3, options.cells_high, options.cells_high / 2),
          tile_(numbers.stir_lobes, 3, 0.6f, hash(options.seed, 7)) {
        cells_ = (cells_ + 15) / 16 * 16;
    }

    FluidSettings fluid() const override {
        FluidSettings f;
        f.cells = cells_;
        f.detail = n_.detail;
        f.lift = n_.lift * h_;
        f.confinement = n_.confinement;
        f.viscosity = n_.viscosity * h_ * h_;
        f.cooling = n_.cooling;
        return f;
    }
    LightSettings light() const override {
        LightSettings l = n_.light;
        l.extinction = n_.extinction / h_;
        return l;
    }
    ViewSettings view() const override {
        const glm::vec2 box(cells_);
        ViewSettings v;
        v.centre = 0.5f * box;
        v.height = h_;
        v.fades = true;
        v.fade_box = {0.02f * box.x, 0.98f * box.x, 0.985f * h_, 0.02f * h_};
        v.fade = {0.16f * h_, 0.16f * h_, 0.30f * h_, 0.03f * h_};
        return v;
    }

    void emit(Fluid& fluid, float time, float dt) override;
    SmallEddies eddies(float time) const override;
    void stir(const Fluid& fluid, Forces& forces, float time) override;

  private:
    struct Source {
        glm::vec3 centre;  ///< cells
        float radius;
        float strength;   ///< 0 to 1
        glm::vec3 speed;  ///< cells/s
    };
    Source source(int index, float time) const;
    float wave(float time, float rate, std::uint32_t salt) const;
    float lumps(const Source& s, glm::vec3 x, float time) const;
    void emit_smoke(Fluid& fluid, const Source& s, float time, float dt) const;
    void emit_heat(Fluid& fluid, const Source& s, float time, float dt) const;
    void emit_speed(Field& component, int axis, const Source& s, float dt) const;
    void fade(Field& density, float dt) const;

    SceneOptions options_;
    PlumeNumbers n_;
    float h_;
    glm::ivec3 cells_;
    TurbulenceTile tile_;
};

/// Noise over time, about -1 to 1, which repeats with the clip.
float PlumeScene::wave(float time, float rate, std::uint32_t salt) const {
    const int period = std::max(1, int(std::lround(rate * options_.length)));
    return noise1(time * float(period) / options_.length, period, hash(options_.seed, salt));
}

PlumeScene::Source PlumeScene::source(int index, float time) const {
    const auto salt = std::uint32_t(100 * (index + 1));
    const int beats = std::max(1, int(std::lround(n_.puff_rate * options_.length)));
    const float phase = time * float(beats) / options_.length + 0.25f * wave(time, 1.2f, salt) + 0.37f * float(index);
    // Cautery comes in pulses: fast onset, slower end, each of its own strength.
    const float saw = phase - std::floor(phase);
    const float pulse = std::min(1.0f, saw / 0.15f) * std::exp(-2.2f * saw);
    const float level = std::clamp(0.75f + 0.5f * wave(time, 1.7f, salt + 1), 0.2f, 1.0f);
    Source s;
    s.strength = level * glm::mix(1.0f, 1.5f * pulse, n_.puff_depth);
    s.radius = n_.radius * h_ * (0.75f + 0.35f * s.strength);
    const glm::vec3 stray(wave(time, n_.wander_rate, salt + 2), 0.4f * wave(time, n_.wander_rate, salt + 3),
                          wave(time, n_.wander_rate, salt + 4));
    const glm::vec3 lean(wave(time, 1.1f, salt + 5) + 0.6f * wave(time, 5.0f, salt + 6), 0.0f,
                         wave(time, 1.3f, salt + 7) + 0.6f * wave(time, 5.0f, salt + 8));
    s.centre =
        glm::vec3(0.5f, 0.0f, 0.5f) * glm::vec3(cells_) + glm::vec3(0.0f, 0.085f * h_, 0.0f) + n_.wander * h_ * stray;
    s.speed = h_ * (glm::vec3(0.0f, n_.jet * (0.4f + 0.9f * s.strength), 0.0f) + n_.sway * lean);
    return s;
}

/// Uneven smoke leaves the tissue: a ball with soft edge, roughened by noise that streams through it.
float PlumeScene::lumps(const Source& s, glm::vec3 x, float time) const {
    const float r = glm::length(x - s.centre) / s.radius;
    if (r >= 1.6f) return 0.0f;
    const glm::vec3 stream = n_.grain * (x / h_ - glm::vec3(0.0f, 0.6f, 0.0f) * time);
    const float rough = fractal3(stream, 1024, 2, 0.6f, hash(options_.seed, 50));
    const float edge = 1.0f + 0.7f * rough - r;
    return std::clamp(edge * 2.5f, 0.0f, 1.0f);
}

/// Calls body(i, j, k) for the samples of `field` in the box around a source.
template <class Body>
void around(const Field& field, glm::vec3 centre, float reach, const Body& body) {
    const auto sample = [&](glm::vec3 p) {
        return glm::clamp(glm::ivec3((p - field.origin) / field.spacing), glm::ivec3(0), field.size - 1);
    };
    const glm::ivec3 low = sample(centre - reach), high = sample(centre + reach);
    for (int k = low.z; k <= high.z; ++k)
        for (int j = low.y; j <= high.y; ++j)
            for (int i = low.x; i <= high.x; ++i) body(i, j, k);
}

void PlumeScene::emit_smoke(Fluid& fluid, const Source& s, float time, float dt) const {
    Field& density = fluid.density;
    const float share = 1.0f - std::exp(-25.0f * dt);
    around(density, s.centre, 1.7f * s.radius, [&](int i, int j, int k) {
        const float target = n_.density * s.strength * lumps(s, density.position(i, j, k), time);
        float& d = density.at(i, j, k);
        d += share * std::max(0.0f, target - d);
    });
}

void PlumeScene::emit_heat(Fluid& fluid, const Source& s, float time, float dt) const {
    Field& heat = fluid.temperature;
    const float share = 1.0f - std::exp(-25.0f * dt);
    around(heat, s.centre, 1.7f * s.radius, [&](int i, int j, int k) {
        const float target = n_.heat * s.strength * lumps(s, heat.position(i, j, k), time);
        float& t = heat.at(i, j, k);
        t += share * std::max(0.0f, target - t);
        fluid.expansion.at(i, j, k) += n_.expansion * target;
    });
}

void PlumeScene::emit_speed(Field& component, int axis, const Source& s, float dt) const {
    const float share = 1.0f - std::exp(-30.0f * dt);
    around(component, s.centre, 1.5f * s.radius, [&](int i, int j, int k) {
        const float r = glm::length(component.position(i, j, k) - s.centre) / s.radius;
        const float inside = std::clamp(1.5f - r, 0.0f, 1.0f);
        float& v = component.at(i, j, k);
        v += share * inside * (s.speed[axis] - v);
    });
}

/// Smoke thins with age, and faster higher up, so that it ends before the border of the picture.
void PlumeScene::fade(Field& density, float dt) const {
    for_slabs(density.size.z, [&](int begin, int end) {
        for (int j = 0; j < density.size.y; ++j) {
            const float y = density.position(0, j, 0).y / h_;
            const float high = glm::smoothstep(0.45f, 0.95f, y);
            const float keep = std::exp(-dt * glm::mix(n_.fade, n_.fade_high, high));
            const float take = dt * n_.erosion * (1.0f + 2.0f * high);
            for (int k = begin; k < end; ++k)
                for (int i = 0; i < density.size.x; ++i) {
                    float& d = density.at(i, j, k);
                    d = std::max(0.0f, d * keep - take);
                }
        }
    });
}

void PlumeScene::emit(Fluid& fluid, float time, float dt) {
    fade(fluid.density, dt);
    std::fill(fluid.expansion.values.begin(), fluid.expansion.values.end(), 0.0f);
    for (int index = 0; index < n_.sources; ++index) {
        const Source s = source(index, time);
        emit_smoke(fluid, s, time, dt);
        emit_heat(fluid, s, time, dt);
        emit_speed(fluid.velocity.u, 0, s, dt);
        emit_speed(fluid.velocity.v, 1, s, dt);
        emit_speed(fluid.velocity.w, 2, s, dt);
    }
}

SmallEddies PlumeScene::eddies(float time) const {
    const float rise = std::max(1.0f, std::round(0.3f * options_.length / n_.eddy_size));
    const float turn = time / options_.length;
    return {&tile_, 1.0f / (n_.eddy_size * h_), {2.0f * turn, -rise * turn, -turn}, n_.eddies};
}

void PlumeScene::stir(const Fluid& fluid, Forces& forces, float time) {
    // The tiles move upwards with the smoke, a whole number of times per clip.
    const float rise = std::max(1.0f, std::round(0.3f * options_.length / n_.stir_size));
    const float turn = time / options_.length;
    forces.add_turbulence(tile_, 1.0f / (n_.stir_size * h_), {turn, -rise * turn, -turn}, n_.stir * h_, &fluid.density,
                          n_.stir_gain);
}

}  // namespace

std::unique_ptr<Scene> make_thick_plume(const SceneOptions& options) {
    PlumeNumbers n;
    n.light.shadow = 0.65f;
    n.light.direct = 0.95f;
    n.light.ambient = 0.14f;
    return std::make_unique<PlumeScene>(options, n);
}

std::unique_ptr<Scene> make_thin_wisps(const SceneOptions& options) {
    PlumeNumbers n;
    n.sources = 3;
    n.detail = 3;
    n.radius = 0.011f;
    n.wander = 0.03f;
    n.wander_rate = 1.2f;
    n.density = 0.7f;
    n.expansion = 2.0f;
    n.jet = 0.3f;
    n.sway = 0.2f;
    n.puff_rate = 0.8f;
    n.puff_depth = 0.6f;
    n.lift = 3.6f;
    n.cooling = 0.5f;
    n.confinement = 0.5f;
    n.viscosity = 5e-5f;
    n.stir = 1.2f;
    n.stir_gain = 5.0f;
    n.stir_size = 0.4f;
    n.eddies = 0.07f;
    n.eddy_size = 0.2f;
    n.stir_lobes = 4;
    n.fade = 0.03f;
    n.fade_high = 1.0f;
    n.erosion = 0.006f;
    n.extinction = 80.0f;
    n.light.shadow = 0.5f;
    n.light.direct = 0.85f;
    n.light.ambient = 0.15f;
    return std::make_unique<PlumeScene>(options, n);
}

}  // namespace clips
