// The area and volume of blood whose edge is moved by noise, against what a picture shows.
#include <gtest/gtest.h>

#include "bleeding/bleed_cpu.h"
#include "support/edge_noise.h"
#include "support/meshes.h"

namespace lapfx::bleeding {
namespace {

constexpr std::uint32_t squares = 160;
constexpr double width = 80.0, cell = (width / squares) * (width / squares);
const glm::dvec3 level{0.0, -1.0, 0.0}, upright{0.0, 0.0, 1.0};

/// Area (mm2) and volume (mm3) that are drawn, on average over noise.
BloodAmount drawn(const BleedField& field, const Organ& organ, const BleedingParameters& b, const glm::dvec3& down,
                  std::uint32_t seeds) {
    BloodAmount sum;
    for (std::uint32_t seed = 0; seed < seeds; ++seed)
        for (std::size_t v = 0; v < organ.positions.size(); ++v) {
            const float value = field.values()[v].x;
            if (value < b.threshold - b.noise_strength) continue;
            const double depth =
                value - b.threshold -
                b.noise_strength * test::edge_noise(b, down, 100u * seed, organ.positions[v], organ.normals[v]);
            if (depth <= 0.0) continue;
            sum.area += cell / seeds;
            sum.volume += cell / seeds * b.thickness * std::min(1.0, depth / b.deep_at);
        }
    return sum;
}

TEST(BloodAmount, IsWhatThePictureShowsOnAverageAtAnyStrengthOfTheNoise) {
    const Organ organ = test::plane(width, squares);
    const Surface surface(organ);
    struct Case {
        double strength;
        int octaves;
        double rivulets;
        glm::dvec3 down;
        double time = 3.0;
        std::uint32_t seeds = 60;
    };
    for (const Case& c :
         {Case{0.0, 3, 0.0, level}, Case{3.0, 3, 0.35, level}, Case{10.0, 3, 0.35, level}, Case{10.0, 1, 0.0, level},
          Case{20.0, 6, 0.0, level}, Case{10.0, 3, 1.0, upright}, Case{10.0, 3, 0.0, upright, 1.0, 1000}}) {
        BleedingParameters b;
        b.speed = 4.0;
        b.noise_scale = 3.0;
        b.noise_strength = c.strength;
        b.noise_octaves = c.octaves;
        b.rivulets = c.rivulets;
        BleedField field(surface, c.down);
        field.set(std::vector<Wound>{{.position = {0.13, 0.0, 0.21}}}, b);
        field.update(c.time);
        const BloodAmount wanted = drawn(field, organ, b, c.down, c.seeds), found = field.amount();
        EXPECT_GT(wanted.area, 20.0);
        EXPECT_NEAR(found.area / wanted.area, 1.0, 0.02)
            << "noise " << c.strength << ", octaves " << c.octaves << ", rivulets " << c.rivulets << ", " << c.time;
        EXPECT_NEAR(found.volume / wanted.volume, 1.0, 0.05)
            << "noise " << c.strength << ", octaves " << c.octaves << ", rivulets " << c.rivulets << ", " << c.time;
    }
}

}  // namespace
}  // namespace lapfx::bleeding
