#include "bleeding/tissue_density.h"

#include <gtest/gtest.h>

#include <limits>
#include <new>

#include "lapfx/authoring/tissue_report.h"
#include "support/tissue.h"

namespace lapfx::bleeding {
namespace {

using namespace test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A surface and its densities.
struct Known {
    explicit Known(Organ made, const VesselParameters& parameters = {})
        : organ(std::move(made)), surface(organ), tissue(organ, surface, parameters) {}
    Organ organ;
    Surface surface;
    TissueDensity tissue;
};

VesselParameters sharp() {
    VesselParameters parameters;
    parameters.smoothing = 0.0;
    return parameters;
}

/// Arteries 1.2 mm wide along z, 10 mm apart.
glm::dvec3 striped(double x, double) {
    return std::abs(x - 10.0 * std::round(x / 10.0)) < 0.6 ? artery : serosa;
}

TEST(TissueDensity, TheRegionsMeanOverAHalfPlane) {
    for (const double region : {0.5, 2.0, 5.0}) {
        VesselParameters parameters = sharp();
        parameters.region = region;
        const Known half(textured_plane(40.0, painted(1000, 1000, 40.0, half_fat)), parameters);
        for (const double height : {0.0, 3.0, -1.0})  // the tip need not touch
            EXPECT_NEAR(half.tissue.fat({0.0, height, 1.0}), 0.5, 0.03) << region;
        EXPECT_NEAR(half.tissue.fat({1.1 * region, 0.0, 0.0}), 1.0, 0.01);
        EXPECT_NEAR(half.tissue.fat({-1.1 * region, 0.0, 0.0}), 0.0, 0.01);
        // A chord at half the radius leaves a segment of 1/3 - sqrt(3) / (4 pi) of the disc.
        EXPECT_NEAR(half.tissue.fat({-0.5 * region, 0.0, 2.0}), 0.1955, 0.03);
    }
}

TEST(TissueDensity, BeyondAnOpenEdgeThereIsNoTissue) {
    VesselParameters parameters = sharp();
    parameters.region = 4.0;
    // Fat in a strip along the edge, half as wide as the region.
    const Known edge(
        textured_plane(40.0, painted(800, 800, 40.0, [](double x, double) { return x > 18.0 ? fat_tissue : serosa; })),
        parameters);
    // Half of the disc is on the plane, and of that everything except the segment beyond half the radius: (0.5 -
    // 0.1955) / 0.5.
    EXPECT_NEAR(edge.tissue.fat({20.0, 0.0, 0.0}), 0.609, 0.05);
    EXPECT_GT(edge.tissue.fat({30.0, 0.0, 0.0}), 0.5) << "the nearest place is at the edge";
}

TEST(TissueDensity, TheRegionFollowsARoundSurface) {
    VesselParameters p;
    p.smoothing = 1.0;
    p.region = 4.0;
    Organ ball = sphere(8.0, 5);
    for (std::size_t i = 0; i < ball.positions.size(); ++i) {
        const glm::dvec3 color = ball.positions[i].x > 0.0f ? fat_tissue : serosa;
        ball.colors[i] = {linear(color.x), linear(color.y), linear(color.z), 1.0f};
    }
    ball.materials[0].base_color = glm::vec4(1.0f);
    const Known k(ball, p);
    EXPECT_NEAR(k.tissue.fat({0.0, 8.0, 0.0}), 0.5, 0.05);
    EXPECT_NEAR(k.tissue.fat({8.0, 0.0, 0.0}), 1.0, 0.01);
    EXPECT_NEAR(k.tissue.fat({-9.0, 0.0, 0.0}), 0.0, 0.01);
}

TEST(TissueDensity, ThresholdAndStrengthDecideHowACutBleeds) {
    Known k(textured_plane(40.0, painted(800, 800, 40.0, striped)));
    VesselParameters p;
    const glm::dvec3 on{0.0, 0.0, 3.0}, off{5.0, 0.0, 3.0};
    p.vessel_threshold = p.vessel_strength = 0.0;
    k.tissue.set(p);
    EXPECT_EQ(k.tissue.wound_strength(on), 1.0) << "without either every cut bleeds alike";
    EXPECT_EQ(k.tissue.wound_strength(off), 1.0);

    const double density = k.tissue.vessels(on);
    // Stripe of 1.2 mm through a disc of radius 2: (2 asin(0.3) + 0.6 sqrt(1 - 0.09)) / pi of it.
    EXPECT_NEAR(density, 0.376, 0.06);
    EXPECT_LT(k.tissue.vessels(off), 0.001);
    p.vessel_threshold = density - 0.001;
    k.tissue.set(p);
    EXPECT_EQ(k.tissue.wound_strength(on), 1.0);
    EXPECT_EQ(k.tissue.wound_strength(off), 0.0);
    p.vessel_threshold = density + 0.001;
    k.tissue.set(p);
    EXPECT_EQ(k.tissue.wound_strength(on), 0.0);

    p.vessel_threshold = 0.0;
    p.vessel_strength = 0.5;
    p.vessel_reference = 0.25;
    k.tissue.set(p);
    EXPECT_NEAR(k.tissue.wound_strength(on), 1.0 + 0.5 * (density / 0.25 - 1.0), 1e-9);
    EXPECT_NEAR(k.tissue.wound_strength(off), 0.5, 0.002);
    p.vessel_strength = 1.0;
    p.vessel_reference = 0.01;
    k.tissue.set(p);
    EXPECT_EQ(k.tissue.wound_strength(on), 4.0) << "the most";
}

/// The paper's figure 9, with nothing set.
TEST(TissueDensity, ByDefaultACutOnAVesselBleedsMoreThanOneBesideIt) {
    const auto faint = [](double x, double z) {  // a capillary of 0.3 mm at x = 5
        return std::abs(x - 5.0) < 0.15 ? artery : striped(x, z);
    };
    for (const Organ& organ : {textured_plane(40.0, painted(800, 800, 40.0, faint)), painted_plane(40.0, 320, faint)}) {
        const Known k(organ);
        const double on = k.tissue.wound_strength({0.0, 0.0, 3.0}), small = k.tissue.wound_strength({5.0, 0.0, 3.0}),
                     off = k.tissue.wound_strength({-15.0, 0.0, 3.0});
        EXPECT_GT(on, 2.0);
        EXPECT_GT(small, 0.3);
        EXPECT_LT(small, 0.6 * on);
        EXPECT_EQ(off, 0.0) << "no vessel, no blood";
    }
}

TEST(TissueDensity, WhatShowsNoVesselsBleedsAlikeEverywhere) {
    VesselParameters p;
    p.vessel_threshold = 0.5;
    p.vessel_strength = 1.0;
    const Paint bare = [](double x, double) { return x > 0.0 ? fat_tissue : serosa; };
    for (const Organ& organ : {textured_plane(40.0, painted(400, 400, 40.0, bare)), painted_plane(40.0, 80, bare)}) {
        const Known k(organ, p);
        for (const double x : {-10.0, 0.0, 10.0}) {
            EXPECT_EQ(k.tissue.wound_strength({x, 0.0, 3.0}), 1.0) << x;
            EXPECT_EQ(k.tissue.sample({x, 0.0, 3.0}).bleeds, 1.0) << x;
        }
        EXPECT_EQ(k.tissue.report().known, 1.0);
        EXPECT_EQ(k.tissue.report().alike, 1.0);
    }
    const Known striped_one(textured_plane(40.0, painted(400, 400, 40.0, striped)), p);
    EXPECT_EQ(striped_one.tissue.report().alike, 0.0);
}

/// Each part of an organ according to its own texture: a liver next to a stomach.
TEST(TissueDensity, APartWithoutVesselsBleedsBesideOneThatHasThem) {
    Organ organ = textured_plane(40.0, painted(800, 800, 40.0, striped), 40);
    organ.images.push_back(painted(100, 100, 40.0, [](double x, double) { return x > 0.0 ? fat_tissue : serosa; }));
    organ.materials.push_back(organ.materials[0]);
    organ.materials[1].base_color_image = 1;
    const auto half = static_cast<std::uint32_t>(organ.indices.size() / 6 * 3);
    organ.parts = {Part{.name = "stomach", .first_index = 0, .index_count = half, .material = 0},
                   Part{.name = "liver",
                        .first_index = half,
                        .index_count = static_cast<std::uint32_t>(organ.indices.size()) - half,
                        .material = 1}};
    const Known k(organ);
    EXPECT_GT(k.tissue.wound_strength({0.0, 0.0, -10.0}), 2.0);
    EXPECT_EQ(k.tissue.wound_strength({5.0, 0.0, -10.0}), 0.0);
    EXPECT_EQ(k.tissue.wound_strength({0.0, 0.0, 10.0}), 1.0);
    EXPECT_EQ(k.tissue.wound_strength({5.0, 0.0, 10.0}), 1.0);
    EXPECT_NEAR(k.tissue.report().alike, 0.5, 0.01);
}

TEST(TissueDensity, AColourFindsBlueAndPaleVessels) {
    struct Vein {
        const char* name;
        glm::dvec3 vein, tissue;
        double by_contrast;  // at most: next to pale tissue, any tissue is redder than its surroundings
    };
    for (const Vein& v :
         {Vein{"blue", {92, 107, 153}, serosa, 0.02}, Vein{"pale", {214, 180, 168}, {120, 48, 44}, 0.25},
          Vein{"dark blue on fat", {84, 84, 120}, fat_tissue, 0.02}}) {
        const Paint veined = [&](double x, double) {
            return std::abs(x - 10.0 * std::round(x / 10.0)) < 0.6 ? v.vein : v.tissue;
        };
        for (const Organ& organ :
             {textured_plane(40.0, painted(800, 800, 40.0, veined)), painted_plane(40.0, 160, veined)}) {
            Known k(organ);
            const glm::dvec3 on{0.0, 0.0, 3.0}, off{5.0, 0.0, 3.0};
            EXPECT_LT(k.tissue.vessels(on), v.by_contrast) << v.name;
            VesselParameters p;
            p.vessel_low = 2.5;  // contrast finds nothing
            p.vessel_high = 3.0;
            p.vessel_color = v.vein / 255.0;
            p.vessel_tolerance = 20.0;
            const int version = k.tissue.version();
            k.tissue.set(p);
            EXPECT_EQ(k.tissue.version(), version + 1) << "the overlay shows it";
            EXPECT_NEAR(k.tissue.vessels(on), 0.376, 0.06) << v.name;
            EXPECT_LT(k.tissue.vessels(off), 0.002) << v.name;
            EXPECT_GT(k.tissue.wound_strength(on), 2.0) << v.name;
            EXPECT_EQ(k.tissue.wound_strength(off), 0.0) << v.name;
            p.vessel_color = glm::dvec3(0.2, 0.9, 0.2);
            k.tissue.set(p);
            EXPECT_LT(k.tissue.vessels(on), 0.001) << "another colour";
        }
    }
}

TEST(TissueDensity, APatchOfTheColourIsNoVessel) {
    const Paint patched = [](double x, double z) {
        return glm::length(glm::dvec2(x + 10.0, z)) < 9.0 || std::abs(x - 10.0) < 0.6 ? glm::dvec3(92, 107, 153)
                                                                                      : serosa;
    };
    VesselParameters p;
    p.vessel_tolerance = 20.0;
    for (const Organ& organ :
         {textured_plane(40.0, painted(800, 800, 40.0, patched)), painted_plane(40.0, 160, patched)}) {
        const Known k(organ, p);
        EXPECT_GT(k.tissue.vessels({10.0, 0.0, 3.0}), 0.3);
        EXPECT_LT(k.tissue.vessels({-10.0, 0.0, 0.0}), 0.01);
    }
}

TEST(TissueDensity, AColourAddsToContrastAndShadeTakesLittleFromIt) {
    Known k(textured_plane(40.0, painted(800, 800, 40.0, [](double x, double z) {
                               const double shade = 0.75 + 0.25 * std::cos(z / 3.0);
                               return (std::abs(x - 10.0) < 0.6 ? glm::dvec3(92, 107, 153) : striped(x - 3.0, z)) *
                                      std::pow(shade, 1 / 2.2);
                           })));
    const double red = k.tissue.vessels({3.0, 0.0, 9.4});
    EXPECT_GT(red, 0.2);
    VesselParameters p;
    p.vessel_tolerance = 24.0;
    k.tissue.set(p);
    EXPECT_EQ(k.tissue.vessels({3.0, 0.0, 9.4}), red);
    for (const double z : {0.0, 5.0, 9.4}) EXPECT_GT(k.tissue.vessels({10.0, 0.0, z}), 0.25) << z;
}

TEST(TissueDensity, MapsAreMadeAgainOnlyWhenTheyChange) {
    Known k(textured_plane(20.0, painted(100, 100, 20.0, half_fat)));
    const int first = k.tissue.version();
    VesselParameters p;
    p.region = 5.0;
    p.vessel_threshold = 0.5;
    p.vessel_strength = 1.0;
    k.tissue.set(p);
    EXPECT_EQ(k.tissue.version(), first);
    const double before = k.tissue.fat({3.0, 0.0, 0.0});
    p.fat_low = 80.0;
    p.fat_high = 95.0;
    k.tissue.set(p);
    EXPECT_EQ(k.tissue.version(), first + 1);
    EXPECT_GT(before, 0.7);
    EXPECT_LT(k.tissue.fat({3.0, 0.0, 0.0}), 0.05);
}

TEST(TissueDensity, WithoutColourVesselsAreEven) {
    VesselParameters p;
    p.vessel_threshold = 0.9;
    p.vessel_strength = 1.0;
    Organ one_texel = textured_plane(20.0, painted(1, 1, 20.0, striped));
    for (const Organ& organ :
         {plane(20.0, 4), one_texel, painted_plane(20.0, 4, [](double, double) { return artery; })}) {
        const Known k(organ, p);
        EXPECT_EQ(k.tissue.vessels({1.0, 0.0, 2.0}), 1.0);
        EXPECT_EQ(k.tissue.fat({1.0, 0.0, 2.0}), 0.0);
        EXPECT_FALSE(k.tissue.sample({1.0, 0.0, 2.0}).known);
        EXPECT_EQ(k.tissue.wound_strength({1.0, 0.0, 2.0}), 1.0);
        EXPECT_EQ(k.tissue.report().known, 0.0);
        EXPECT_EQ(k.tissue.report().alike, 1.0);
    }
    const Known nothing(Organ{}, p);
    EXPECT_EQ(nothing.tissue.vessels({1.0, 0.0, 2.0}), 1.0);
    EXPECT_EQ(nothing.tissue.wound_strength({1.0, 0.0, 2.0}), 1.0);
    EXPECT_EQ(nothing.tissue.report().known, 0.0);
}

TEST(TissueDensity, BadPlacesAreNowhere) {
    const Known k(textured_plane(20.0, painted(100, 100, 20.0, half_fat)));
    for (const double bad : {nan, infinity, -infinity}) {
        const TissueSample sample = k.tissue.sample({bad, 0.0, 0.0});
        EXPECT_EQ(sample.vessels, 0.0);
        EXPECT_EQ(sample.fat, 0.0);
        EXPECT_EQ(k.tissue.wound_strength({0.0, 0.0, bad}), 0.0);
    }
    EXPECT_TRUE(k.tissue.sample({1e5, 0.0, 0.0}).known);
    EXPECT_GE(k.tissue.fat({1e5, 0.0, 0.0}), 0.97) << "far away: the nearest place";
}

TEST(TissueDensity, VertexColoursAtAnyMeshWidth) {
    VesselParameters p;
    p.smoothing = 2.0;
    p.region = 0.1;
    for (const std::uint32_t n : {40u, 100u, 200u}) {
        const Known k(painted_plane(40.0, n, half_fat, Cut::irregular), p);
        EXPECT_NEAR(k.tissue.fat({0.0, 0.0, 0.0}), 0.5, 0.07) << n;
        EXPECT_NEAR(k.tissue.fat({2.0, 0.0, 3.0}), below(1.0, 1.0), 0.07) << n;
        EXPECT_NEAR(k.tissue.fat({-2.0, 0.0, 3.0}), below(-1.0, 1.0), 0.07) << n;
    }
    VesselParameters wide;
    wide.vessel_width = 2.0;
    const Known stripes(painted_plane(40.0, 160, [](double x, double) { return std::abs(x) < 1.0 ? artery : serosa; }),
                        wide);
    EXPECT_GT(stripes.tissue.vessels({0.0, 0.0, 4.0}), 0.4) << "2 of 4 mm are vessel";
    EXPECT_LT(stripes.tissue.vessels({5.0, 0.0, 4.0}), 0.01);
    EXPECT_EQ(stripes.tissue.report().texels_per_mm, 0.0);
    EXPECT_EQ(stripes.tissue.report().known, 1.0);
}

/// Arteries and the organ under them are often separate meshes, each of one colour.
TEST(TissueDensity, AMaterialOfItsOwnStandsOutOfItsSurroundings) {
    Organ organ = joined(plane(60.0, 60), plane(2.0, 4), {5.0f, 0.5f, 0.0f});
    organ.materials = {Material{.name = "heart", .base_color = {0.59f, 0.18f, 0.16f, 1.0f}},
                       Material{.name = "artery", .base_color = {1.0f, 0.0f, 0.0f, 1.0f}}};
    const auto first = static_cast<std::uint32_t>(3 * plane(60.0, 60).triangle_count());
    organ.parts = {{"heart", 0, first, 0},
                   {"artery", first, static_cast<std::uint32_t>(organ.indices.size()) - first, 1}};
    const Known k(organ, sharp());
    VesselParameters p = sharp();
    p.region = 0.5;
    Known near(organ, p);
    EXPECT_GT(near.tissue.vessels({5.0, 0.6, 0.0}), 0.9);
    EXPECT_LT(near.tissue.vessels({-5.0, 0.0, 0.0}), 0.01);
    EXPECT_EQ(k.tissue.report().known, 1.0);
}

/// The two halves of the plane are swapped in the texture, so that its middle is a seam.
TEST(TissueDensity, ASeamOfTheTextureIsNoEdgeOfTheTissue) {
    const auto vessel_across = [](double, double z) { return std::abs(z) < 0.6 ? artery : serosa; };
    const auto swapped = [&](double x, double z) { return vessel_across(x > 0 ? x - 20.0 : x + 20.0, z); };
    const Organ whole = textured_plane(40.0, painted(800, 800, 40.0, vessel_across), 8);
    const Organ before = textured_plane(40.0, painted(800, 800, 40.0, swapped), 8);
    Organ split;
    std::vector<glm::vec2> uvs;
    for (std::size_t i = 0; i < before.indices.size(); ++i) {
        float middle = 0.0f;  // of the triangle
        for (std::size_t c = 0; c < 3; ++c) middle += before.positions[before.indices[i - i % 3 + c]].x;
        split.positions.push_back(before.positions[before.indices[i]]);
        split.indices.push_back(static_cast<std::uint32_t>(i));
        uvs.push_back(before.uvs[before.indices[i]] + glm::vec2(middle > 0.0f ? -0.5f : 0.5f, 0.0f));
    }
    split = drawable(split, std::vector<glm::vec3>(split.positions.size(), {0.0f, 1.0f, 0.0f}));
    split.uvs = uvs;
    split.images = before.images;
    split.materials = before.materials;
    const Known a(whole), b(split);
    EXPECT_GT(a.tissue.vessels({0.0, 0.0, 0.0}), 0.3);
    for (const double x : {-1.5, -0.3, 0.0, 0.3, 1.5})
        for (const double z : {0.0, 1.0})
            EXPECT_NEAR(b.tissue.vessels({x, 0.0, z}), a.tissue.vessels({x, 0.0, z}), 0.03) << x << ' ' << z;
}

TEST(TissueDensity, SharesOfTheSurface) {
    const auto paint = [](double x, double z) { return x > 10.0 ? fat_tissue : striped(x, z); };
    for (const std::uint32_t n : {1u, 30u}) {
        const TissueReport report = report_tissue(textured_plane(40.0, painted(800, 800, 40.0, paint), n));
        EXPECT_EQ(report.known, 1.0);
        EXPECT_NEAR(report.fat, 0.25, 0.01);
        EXPECT_NEAR(report.vessels, (1.2 + 1.2 + 0.6 + 0.6) / 40.0, 0.015) << "at -20 (half), -10, 0 and 10 (half)";
        EXPECT_NEAR(report.texels_per_mm, 20.0, 1e-4);
    }
}

TEST(TissueDensity, TheSameEveryTime) {
    const Organ organ = textured_plane(40.0, painted(300, 300, 40.0, striped));
    const Known a(organ), b(organ);
    for (double x = -10.0; x < 10.0; x += 0.7)
        EXPECT_EQ(a.tissue.vessels({x, 0.1, 0.3 * x}), b.tissue.vessels({x, 0.1, 0.3 * x}));
}

TEST(TissueDensity, StaysAsItWasWhereThereIsNoMemoryForAnother) {
    Organ organ = textured_plane(40.0, painted(200, 200, 40.0, striped));
    const auto nothing =
        std::make_shared<const std::vector<std::uint8_t>>(10, std::uint8_t{0});  // which cannot be decoded
    const organ::PixelList pixels = organ::take_pixels(organ, {nothing});
    const Surface surface(organ);
    TissueDensity tissue(organ, surface, {}, {}, pixels);
    const glm::dvec3 place(0.2, 0.0, 3.0);
    const double before = tissue.vessels(place);
    EXPECT_GT(before, 0.0);
    VesselParameters other;
    other.vessel_width = 3.0;
    pixels[0]->let_go();
    for (int i = 0; i < 2; ++i) {
        EXPECT_THROW(tissue.set(other), std::bad_alloc) << "again, for it is not set";
        EXPECT_EQ(tissue.vessels(place), before);
        EXPECT_EQ(tissue.version(), 1);
    }
    EXPECT_NO_THROW(tissue.set({}));
    EXPECT_EQ(tissue.vessels(place), before);
}

}  // namespace
}  // namespace lapfx::bleeding
