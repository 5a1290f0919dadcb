#include "bleeding/bleed_cpu.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/meshes.h"

namespace lapfx::bleeding {
namespace {

using test::Cut;

constexpr glm::dvec3 into_the_plane{0.0, -1.0, 0.0};  // gravity that neither helps nor hinders
constexpr glm::dvec3 along_x{1.0, 0.0, 0.0};

/// 4 mm/s up to 16 mm; no threshold, no pulse, no gravity.
BleedingParameters plain() {
    BleedingParameters b;
    b.speed = 4.0;
    b.max_extent = 16.0;
    b.threshold = 0.0;
    b.gravity_bias = 0.0;
    b.pulse_rate = b.pulse_strength = 0.0;
    return b;
}

/// Whether an update to `time` changes any value.
bool changes(BleedField& field, double time) {
    field.changed().take();
    field.update(time);
    return !field.changed().empty();
}

/// The value at the organ's vertex nearest to a place.
float value_at(const BleedField& field, const Organ& organ, glm::vec3 place) {
    std::size_t best = 0;
    for (std::size_t v = 0; v < organ.positions.size(); ++v)
        if (glm::distance(organ.positions[v], place) < glm::distance(organ.positions[best], place)) best = v;
    return field.values()[best].x;
}

double disc(double radius) {
    return std::numbers::pi * radius * radius;
}

TEST(Bleed, ValueIsSourceMinusDistance) {
    const Organ organ = test::plane(60.0, 60);
    const Surface surface(organ);
    BleedField field(surface, into_the_plane);
    field.set(std::vector<Wound>{{.position = {0.2, 0.0, 0.3}}}, plain());
    field.update(2.0);
    for (std::size_t v = 0; v < organ.positions.size(); ++v) {
        const double distance = glm::distance(glm::dvec3(organ.positions[v]), glm::dvec3(0.2, 0.0, 0.3));
        EXPECT_NEAR(std::max(0.0f, field.values()[v].x), std::max(0.0, 8.0 - distance), 1e-4) << v;
    }
}

TEST(Bleed, TwoWoundsGiveTheLargerValueNotTheSum) {
    const Organ organ = test::plane(60.0, 60);
    const Surface surface(organ);
    BleedField field(surface, into_the_plane);
    field.set(std::vector<Wound>{{.position = {-4.0, 0.0, 0.0}}, {.position = {4.0, 0.0, 0.0}, .strength = 2.0}},
              plain());
    field.update(1.5);  // 6 mm and 12 mm
    EXPECT_NEAR(value_at(field, organ, {0, 0, 0}), 8.0, 1e-4);
    EXPECT_NEAR(value_at(field, organ, {-4, 0, 0}), 6.0, 1e-4);
    EXPECT_NEAR(value_at(field, organ, {-9, 0, 0}), 1.0, 1e-4);
    EXPECT_NEAR(value_at(field, organ, {4, 0, 0}), 12.0, 1e-4);
}

TEST(Bleed, GravityShortensDownhillAndLengthensUphillByTheDrop) {
    const Organ organ = test::plane(80.0, 80);
    const Surface surface(organ);
    BleedField field(surface, along_x);
    BleedingParameters b = plain();
    b.gravity_bias = 0.4;
    field.set(std::vector<Wound>{{.position = {0.0, 0.0, 0.0}}}, b);
    field.update(3.0);  // 12 mm
    EXPECT_NEAR(value_at(field, organ, {5, 0, 0}), 12.0 - 5.0 * 0.6, 1e-4);
    EXPECT_NEAR(value_at(field, organ, {-5, 0, 0}), 12.0 - 5.0 * 1.4, 1e-4);
    EXPECT_NEAR(value_at(field, organ, {0, 0, 5}), 12.0 - 5.0, 1e-4) << "level ground";
    EXPECT_NEAR(value_at(field, organ, {3, 0, 4}), 12.0 - (5.0 - 0.4 * 3.0), 1e-4);
    // It reaches 12 / (1 - 0.4) = 20 mm downhill and 12 / 1.4 = 8.57 mm uphill.
    EXPECT_NEAR(value_at(field, organ, {19, 0, 0}), 0.6, 1e-4);
    EXPECT_LE(value_at(field, organ, {21, 0, 0}), 0.0f);
    EXPECT_LE(value_at(field, organ, {-9, 0, 0}), 0.0f);
    field.update(100.0);  // 16 mm: 26.7 mm downhill
    EXPECT_NEAR(value_at(field, organ, {26, 0, 0}), 0.4, 1e-4) << "the limit of the march leaves room for gravity";
}

TEST(Bleed, AreaFollowsTheDisc) {
    const Surface surface(test::plane(44.0, 220));
    BleedField field(surface, into_the_plane);
    BleedingParameters b = plain();
    b.noise_strength = 0.0;
    field.set(std::vector<Wound>{{.position = {0.07, 0.0, 0.11}}}, b);
    for (const double time : {1.0, 2.0, 3.0, 4.0, 6.0}) {
        field.update(time);
        const double wanted = disc(std::min(4.0 * time, 16.0));
        EXPECT_NEAR(field.amount().area, wanted, 0.02 * wanted) << time;
    }
}

TEST(Bleed, TheThresholdNarrowsTheDisc) {
    const Surface surface(test::plane(44.0, 220));
    BleedField field(surface, into_the_plane);
    BleedingParameters b = plain();
    b.threshold = 3.0;
    field.set(std::vector<Wound>{{.position = {0.07, 0.0, 0.11}}}, b);
    field.update(0.5);  // 2 mm: nothing shows yet
    EXPECT_EQ(field.amount().area, 0.0);
    field.update(3.0);
    EXPECT_NEAR(field.amount().area, disc(9.0), 0.02 * disc(9.0));
}

TEST(Bleed, NothingBleedsBeforeTheWoundNorFarFromIt) {
    const Surface surface(test::plane(44.0, 44));
    BleedField field(surface, into_the_plane);
    EXPECT_EQ(field.amount().area, 0.0);
    field.update(0.0);
    EXPECT_EQ(field.amount().area, 0.0) << "no wound";
    field.set(std::vector<Wound>{{.position = {0.0, 0.0, 0.0}, .start = 2.0}}, plain());
    field.update(1.0);
    EXPECT_EQ(field.amount().area, 0.0);
    for (const glm::vec2 value : field.values()) EXPECT_LE(value.x, 0.0f);
}

TEST(Bleed, FromTwoThousandToTwoHundredThousandTrianglesTheAreaIsTheSame) {
    BleedingParameters b = plain();
    b.threshold = 0.3;
    b.gravity_bias = 0.35;
    for (const Cut cut : {Cut::regular, Cut::irregular}) {
        double finest = 0.0;
        for (const std::uint32_t n : {316u, 100u, 32u}) {
            const Surface surface(test::plane(80.0, n, cut));
            BleedField field(surface, along_x);
            field.set(std::vector<Wound>{{.position = {-5.3, 0.0, 0.9}}}, b);
            field.update(4.0);
            if (finest == 0.0) finest = field.amount().area;
            // The set d - g x < s is an ellipse: half axes s / (1 - g^2) and s / sqrt(1 - g^2).
            const double s = 15.7, shrink = 1.0 - 0.35 * 0.35;
            EXPECT_NEAR(finest, std::numbers::pi * s * s / std::pow(shrink, 1.5), 0.03 * finest);
            EXPECT_NEAR(field.amount().area, finest, 0.05 * finest) << 2 * n * n << " triangles";
        }
    }
}

TEST(Bleed, ASettledFieldReportsNothing) {
    const Surface surface(test::plane(44.0, 44));
    BleedField field(surface, into_the_plane);
    field.set(std::vector<Wound>{{.position = {0.0, 0.0, 0.0}, .start = 1.0}}, plain());
    field.update(0.0);
    EXPECT_FALSE(changes(field, 0.5)) << "not begun";
    EXPECT_TRUE(changes(field, 2.0));
    EXPECT_FALSE(changes(field, 2.0)) << "the same time";
    EXPECT_TRUE(changes(field, 5.0));
    EXPECT_FALSE(changes(field, 6.0)) << "at its largest extent";
    EXPECT_FALSE(changes(field, 600.0));
    EXPECT_EQ(bleeding_wounds(field.wounds()), 0);
    field.update(3.0);
    EXPECT_EQ(bleeding_wounds(field.wounds()), 1);
}

TEST(Bleed, TheRunsHoldEveryValueThatChangedAndLittleElse) {
    const Surface surface(test::plane(88.0, 88));
    BleedField field(surface, into_the_plane);
    field.set(std::vector<Wound>{{.position = {3.0, 0.0, 2.0}}}, plain());
    field.update(0.0);
    const auto all = field.changed().take();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0], (VertexRun{0, static_cast<std::uint32_t>(field.values().size())})) << "all at first";
    std::vector<glm::vec2> before(field.values().begin(), field.values().end());
    for (const double time : {0.5, 1.0, 3.0, 0.7}) {
        field.update(time);
        std::vector<char> sent(before.size(), false);
        std::size_t bytes = 0, changed = 0;
        for (const VertexRun& run : field.changed().take())
            for (std::uint32_t v = run.begin; v < run.end; ++v, ++bytes) sent[v] = true;
        for (std::uint32_t v = 0; v < before.size(); ++v) {
            if (field.values()[v] == before[v]) continue;
            ++changed;
            EXPECT_TRUE(sent[v]) << v;
        }
        EXPECT_GT(changed, 10u);
        EXPECT_LT(bytes, 40 * (2 + static_cast<std::size_t>(std::sqrt(changed))) + changed)
            << "blocks at each row's ends";
        before.assign(field.values().begin(), field.values().end());
    }
}

TEST(Bleed, CopiesOfAVertexAtASeamGetTheSameValue) {
    // Every triangle has its own vertices: flat shading.
    const Organ sheet = test::plane(20.0, 20);
    Organ organ;
    for (const std::uint32_t i : sheet.indices) {
        organ.indices.push_back(static_cast<std::uint32_t>(organ.positions.size()));
        organ.positions.push_back(sheet.positions[i]);
    }
    const Surface surface(organ), joined(sheet);
    BleedField split(surface, into_the_plane), whole(joined, into_the_plane);
    const std::vector<Wound> wounds{{.position = {0.2, 0.0, 0.3}}};
    split.set(wounds, plain());
    whole.set(wounds, plain());
    split.update(1.5);
    whole.update(1.5);
    ASSERT_EQ(split.values().size(), sheet.indices.size());
    for (std::size_t i = 0; i < sheet.indices.size(); ++i)
        EXPECT_EQ(split.values()[i], whole.values()[sheet.indices[i]]);
    EXPECT_DOUBLE_EQ(split.amount().area, whole.amount().area);
    EXPECT_GT(split.amount().area, 0.9 * disc(6.0));
}

TEST(Bleed, RemovingWoundsWipesTheirBlood) {
    const Surface surface(test::plane(44.0, 44));
    BleedField field(surface, into_the_plane);
    const Wound left{.position = {-8.0, 0.0, 0.0}}, right{.position = {8.0, 0.0, 0.0}};
    field.set(std::vector<Wound>{left, right}, plain());
    field.update(1.0);
    const double both = field.amount().area;
    field.set(std::vector<Wound>{right}, plain());
    EXPECT_TRUE(changes(field, 1.0));
    EXPECT_NEAR(field.amount().area, both / 2.0, 0.01 * both);
    field.set(std::vector<Wound>{}, plain());
    EXPECT_TRUE(changes(field, 1.0));
    EXPECT_EQ(field.amount().area, 0.0);
    for (const glm::vec2 value : field.values()) EXPECT_LE(value.x, 0.0f);
    EXPECT_FALSE(changes(field, 2.0));
}

TEST(Bleed, TimeMayRunBackwardsAndJump) {
    const Surface surface(test::plane(44.0, 44));
    const std::vector<Wound> wounds{{.position = {-3.0, 0.0, 0.0}},
                                    {.position = {3.0, 0.0, 1.0}, .start = 1.0, .stop = 2.5}};
    BleedField jumping(surface, along_x);
    BleedingParameters b;
    jumping.set(wounds, b);
    for (const double time : {9.0, 0.2, 3.0, 1.4, 0.0, 2.2}) {
        jumping.update(time);
        BleedField fresh(surface, along_x);
        fresh.set(wounds, b);
        fresh.update(time);
        for (std::size_t v = 0; v < fresh.values().size(); ++v)
            ASSERT_EQ(jumping.values()[v], fresh.values()[v]) << time;
        EXPECT_EQ(jumping.amount().area, fresh.amount().area);
    }
}

TEST(Bleed, ParametersTakeEffectOnWoundsThatAreThere) {
    const Organ organ = test::plane(60.0, 60);
    const Surface surface(organ);
    BleedField field(surface, into_the_plane);
    const std::vector<Wound> wounds{{.position = {0.0, 0.0, 0.0}}};
    BleedingParameters b = plain();
    field.set(wounds, b);
    field.update(10.0);
    EXPECT_NEAR(value_at(field, organ, {15, 0, 0}), 1.0, 1e-4);
    b.max_extent = 24.0;  // farther than the known distances
    field.set(wounds, b);
    field.update(10.0);
    EXPECT_NEAR(value_at(field, organ, {23, 0, 0}), 1.0, 1e-4);
    b.max_extent = 5.0;
    field.set(wounds, b);
    field.update(10.0);
    EXPECT_NEAR(value_at(field, organ, {4, 0, 0}), 1.0, 1e-4);
    EXPECT_LE(value_at(field, organ, {6, 0, 0}), 0.0f);
}

}  // namespace
}  // namespace lapfx::bleeding
