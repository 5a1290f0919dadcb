// The solver behind the sample clips: what must hold for any smoke it makes.
#include <gtest/gtest.h>

#include <cmath>

#include "clips/advection.h"
#include "clips/composite.h"
#include "clips/noise.h"
#include "clips/projection.h"
#include "clips/scene.h"

namespace {

using namespace clips;

Velocity stirred(glm::ivec3 cells) {
    Velocity velocity(cells);
    std::uint32_t n = 0;
    for (Field* f : {&velocity.u, &velocity.v, &velocity.w})
        for (float& x : f->values) x = 2.0f * uniform(hash(n++)) - 1.0f;
    return velocity;
}

TEST(ClipProjection, TakesAwayTheDivergence) {
    const glm::ivec3 cells(32, 48, 16);
    Velocity velocity = stirred(cells);
    const double before = Projection::divergence(velocity);
    const Field no_expansion(cells, glm::vec3(0.5f), 1.0f);
    Projection(cells, {}).project(velocity, no_expansion, 6);
    EXPECT_LT(Projection::divergence(velocity), 1e-3 * before);
    for (int k = 0; k < cells.z; ++k)
        for (int i = 0; i < cells.x; ++i) ASSERT_EQ(velocity.v.at(i, 0, k), 0.0f) << "flow through the bottom";
}

TEST(ClipProjection, LeavesTheExpansionThatWasAsked) {
    const glm::ivec3 cells(16);
    Velocity velocity(cells);
    Field expansion(cells, glm::vec3(0.5f), 1.0f);
    expansion.at(8, 6, 8) = 3.0f;
    Projection(cells, {}).project(velocity, expansion, 12);
    const float out = velocity.u.at(9, 6, 8) - velocity.u.at(8, 6, 8) + velocity.v.at(8, 7, 8) -
                      velocity.v.at(8, 6, 8) + velocity.w.at(8, 6, 9) - velocity.w.at(8, 6, 8);
    EXPECT_NEAR(out, 3.0f, 1e-3f);
}

TEST(ClipAdvection, LeavesAConstantAsItIs) {
    const glm::ivec3 cells(16, 32, 16);
    Flow flow(cells);
    flow.gather(stirred(cells), 0, cells.z);
    Field field(cells, glm::vec3(0.5f), 1.0f);
    std::fill(field.values.begin(), field.values.end(), 0.75f);
    Advector advector(field);
    advector.trace(flow, 2.0f);
    advector.advect(field);
    for (float x : field.values) ASSERT_NEAR(x, 0.75f, 1e-6f);
}

TEST(ClipAdvection, CarriesALumpWithoutMakingNewExtremes) {
    const glm::ivec3 cells(32, 32, 16);
    Velocity wind(cells);
    std::fill(wind.u.values.begin(), wind.u.values.end(), 3.0f);
    Flow flow(cells);
    flow.gather(wind, 0, cells.z);
    Field field(cells, glm::vec3(0.5f), 1.0f);
    double before = 0.0;
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i) {
                const glm::vec3 d = field.position(i, j, k) - glm::vec3(8.0f, 16.0f, 8.0f);
                const float lump = std::exp(-glm::dot(d, d) / 12.0f);
                field.at(i, j, k) = lump > 0.01f ? lump : 0.0f;
                before += double(field.at(i, j, k));
            }
    Advector advector(field);
    for (int step = 0; step < 10; ++step) {
        advector.active().find(field, 1e-4f, 4.0f);
        advector.trace(flow, 0.5f);
        advector.advect(field);
    }
    double mass = 0.0, centre = 0.0;
    for (int k = 0; k < cells.z; ++k)
        for (int j = 0; j < cells.y; ++j)
            for (int i = 0; i < cells.x; ++i) {
                const float x = field.at(i, j, k);
                ASSERT_GE(x, 0.0f);
                ASSERT_LE(x, 1.0f);
                mass += double(x);
                centre += double(x) * (i + 0.5);
            }
    EXPECT_NEAR(mass, before, 0.05 * before);
    EXPECT_NEAR(centre / mass, 8.0 + 15.0, 0.3);
}

TEST(ClipNoise, RepeatsAfterItsPeriod) {
    for (float x = 0.05f; x < 4.0f; x += 0.31f) {
        EXPECT_NEAR(noise1(x, 4, 7), noise1(x + 4.0f, 4, 7), 1e-4f);
        EXPECT_NEAR(noise3({x, 0.3f, -x}, 4, 7), noise3({x - 4.0f, 4.3f, 4.0f - x}, 4, 7), 1e-4f);
    }
}

TEST(ClipLoop, LastFrameLeadsIntoTheFirst) {
    // Pictures whose value is their time: the blend must end just before the first frame.
    std::vector<float> out;
    LoopBlend loop(10, 4, [&](int, const Picture& p) { out.push_back(p.value[0]); });
    for (int n = -4; n < 10; ++n) {
        Picture p(1, 1);
        p.value[0] = float(n);
        loop.add(n, p);
    }
    ASSERT_EQ(out.size(), 10u);
    EXPECT_EQ(out[5], 5.0f);
    EXPECT_NEAR(out[9], -1.0f, 1.1f);
    EXPECT_EQ(out[0], 0.0f);
}

TEST(ClipScenes, EveryBoxSuitsTheMultigrid) {
    for (const auto& scene : {make_thick_plume({}), make_thin_wisps({}), make_rolling_haze({})})
        EXPECT_EQ(scene->fluid().cells % 16, glm::ivec3(0));
}

}  // namespace
