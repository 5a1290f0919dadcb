// Finding where smoke starts, for made-up plumes with a known source.
#include "smoke/find_source.h"

#include <gtest/gtest.h>

#include <cmath>

#include "lapfx/authoring/suggest.h"
#include "support/folders.h"
#include "unit/organ/fixtures.h"

namespace lapfx::smoke {
namespace {

constexpr glm::ivec2 cells{80, 48};

/// Puffs that leave `source` (fractions) every 0.2 s from `start` on, move by `way` frame heights a second and grow.
OpacityGrid plume(glm::dvec2 source, glm::dvec2 way, double start, double time) {
    OpacityGrid grid{cells, std::vector<float>(static_cast<std::size_t>(cells.x * cells.y))};
    const glm::dvec2 from = source * glm::dvec2(cells);
    for (double born = std::max(start, time - 3.0); born <= time; born += 0.2) {
        const double age = time - born, wide = 1.5 + 3.0 * age;
        const glm::dvec2 swing(2.0 * std::sin(3.0 * born) * age, 2.0 * std::cos(5.0 * born) * age);
        const glm::dvec2 middle = from + way * static_cast<double>(cells.y) * age + swing;
        for (int y = 0; y < cells.y; ++y)
            for (int x = 0; x < cells.x; ++x) {
                const double r = glm::distance(glm::dvec2(x, y) + 0.5, middle) / wide;
                float& cell = grid.cells[static_cast<std::size_t>(y * cells.x + x)];
                const double thick = 0.8 / (1.0 + age) * std::exp(-r * r);
                cell = static_cast<float>(1.0 - (1.0 - static_cast<double>(cell)) * (1.0 - thick));
            }
    }
    return grid;
}

FoundSource found_of(glm::dvec2 source, glm::dvec2 way, double start) {
    std::vector<OpacityGrid> pictures, later, first;
    for (int i = 0; i < 16; ++i) {
        pictures.push_back(plume(source, way, start, 0.3 + 0.5 * i));
        later.push_back(plume(source, way, start, 0.42 + 0.5 * i));
    }
    for (int i = 0; i < 24; ++i) first.push_back(plume(source, way, start, 0.1 * i));
    return find_source(pictures, later, first);
}

TEST(Source, APlumeThatIsThereFromTheFirstStartsAtItsRoot) {
    const std::pair<glm::dvec2, glm::dvec2> takes[] = {{{0.5, 0.9}, {0.0, -0.3}},    // rises
                                                       {{0.2, 0.7}, {0.1, -0.25}},   // beside the middle, slanting
                                                       {{0.1, 0.5}, {0.4, 0.0}},     // to the right
                                                       {{0.6, 0.15}, {0.0, 0.35}}};  // sinks
    for (const auto& [source, way] : takes) {
        const FoundSource found = found_of(source, way, -5.0);
        EXPECT_TRUE(found.found);
        EXPECT_FALSE(found.begins);
        EXPECT_NEAR(found.place.x, source.x, 0.06) << source.x << ", " << source.y;
        EXPECT_NEAR(found.place.y, source.y, 0.08) << source.x << ", " << source.y;
        EXPECT_GT(glm::dot(found.way, glm::normalize(way)), 0.7);
    }
}

TEST(Source, AClipThatBeginsWithoutSmokeShowsWhereItComesFrom) {
    for (const glm::dvec2 source : {glm::dvec2(0.3, 0.8), {0.75, 0.4}}) {
        const FoundSource found = found_of(source, {0.0, -0.3}, 0.5);
        EXPECT_TRUE(found.begins);
        EXPECT_NEAR(found.place.x, source.x, 0.04);
        EXPECT_NEAR(found.place.y, source.y, 0.06);
    }
}

TEST(Source, WithoutSmokeThereIsNone) {
    const std::vector<OpacityGrid> empty(8, {cells, std::vector<float>(static_cast<std::size_t>(cells.x * cells.y))});
    EXPECT_FALSE(find_source(empty, empty, empty).found);
    EXPECT_FALSE(find_source({}, {}, {}).found);
    const std::vector<OpacityGrid> tiny(3, {{2, 1}, {1.0f, 1.0f}});
    EXPECT_TRUE(find_source(tiny, tiny, {}).found) << "too small to see a way in";
}

TEST(Source, OfTheSampleClipsIsWhereTheyWereSolvedToStart) {
    const std::filesystem::path clips = test::source_folder() / "samples" / "clips";
    const SourceSuggestion thick = suggest_source(clips / "plume_thick.mp4");
    std::printf("    plume_thick: %.3f %.3f\n", thick.place.x, thick.place.y);
    EXPECT_TRUE(thick.found);
    EXPECT_NEAR(thick.place.x, 0.5, 0.06);
    EXPECT_NEAR(thick.place.y, 0.92, 0.09);
    const std::filesystem::path real = test::data_folder() / "smoke" / "three-parallax2/public/assets/smoke.mp4";
    if (!std::filesystem::exists(real)) GTEST_SKIP() << "no folder of real clips";
    const SourceSuggestion wisp = suggest_source(real);
    std::printf("    three-parallax2: %.3f %.3f %s\n", wisp.place.x, wisp.place.y, wisp.begins ? "begins" : "root");
    EXPECT_TRUE(wisp.found);
}

}  // namespace
}  // namespace lapfx::smoke
