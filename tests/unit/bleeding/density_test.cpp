#include "bleeding/density.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/tissue.h"

namespace lapfx::bleeding {
namespace {

using namespace test;

DensityMap map_of(const Organ& organ, const VesselParameters& parameters = {}) {
    DensityMap map(organ, 0);
    map.set(parameters);
    return map;
}

/// Density at a place of a textured_plane, mm.
glm::vec2 at(const DensityMap& map, double side, double x, double z = 0.0) {
    return map.sample({x / side + 0.5, z / side + 0.5});
}

/// Tissue as a camera sees it: the colour times uneven light, with independent noise in every channel.
class Uneven {
  public:
    glm::dvec3 operator()(glm::dvec3 color, double x, double z) {
        const double light = 0.6 + 0.3 * std::sin(0.35 * x) * std::cos(0.2 * z + 1.0) + 0.1 * std::sin(1.9 * x + z);
        const auto noise = [&] { return 6.0 * (static_cast<double>(random_()) / 4294967295.0 - 0.5); };
        for (int c = 0; c < 3; ++c) color[c] = 255.0 * std::pow(std::pow(color[c] / 255.0, 2.2) * light, 1 / 2.2);
        return color + glm::dvec3(noise(), noise(), noise());
    }

  private:
    std::mt19937 random_{3};
};

/// Distance from the nearest vessel: one every 10 mm along x, and a slanting one.
double to_vessel(double x, double z) {
    return std::min(std::abs(z - 10.0 * std::round(z / 10.0)), std::abs(0.6 * x - 0.8 * z - 3.0));
}

struct Found {
    double precision, recall;
};
Found find(double width, const VesselParameters& parameters) {
    constexpr int size = 800;
    constexpr double side = 40.0;
    Uneven uneven;
    const Organ organ = textured_plane(side, painted(size, size, side, [&](double x, double z) {
                                           return uneven(to_vessel(x, z) < width / 2 ? artery : serosa, x, z);
                                       }));
    const DensityMap map = map_of(organ, parameters);
    int hit = 0, found = 0, there = 0;
    for (int i = 0; i < size * size; ++i) {
        const double x = ((i % size + 0.5) / size - 0.5) * side, z = ((i / size + 0.5) / size - 0.5) * side;
        const bool vessel = to_vessel(x, z) < width / 2, seen = map.values()[static_cast<std::size_t>(i)].x >= 128;
        hit += vessel && seen;
        found += seen;
        there += vessel;
    }
    return {double(hit) / found, double(hit) / there};
}

TEST(Density, FindsVesselsOnNoisyUnevenlyLitTissue) {
    const Found wide = find(1.2, {});
    EXPECT_GT(wide.precision, 0.92);  // smoothing widens them a little
    EXPECT_GT(wide.recall, 0.95);
    VesselParameters fine;
    fine.vessel_width = 0.5;
    fine.smoothing = 0.1;
    const Found thin = find(0.4, fine);
    EXPECT_GT(thin.precision, 0.9);
    EXPECT_GT(thin.recall, 0.9);
}

TEST(Density, NeitherShadeNorHighlightsNorYellowsAreVessels) {
    const auto worst = [](const Paint& paint) {
        const DensityMap map = map_of(textured_plane(40.0, painted(400, 400, 40.0, paint)));
        std::uint8_t most = 0;
        for (const Density& d : map.values()) most = std::max(most, d.x);
        return most / 255.0;
    };
    const auto stripe = [](double x) { return std::abs(x - 8.0 * std::round(x / 8.0)) < 0.5; };
    const auto lit = [](double light) {
        glm::dvec3 color = serosa;
        for (int c = 0; c < 3; ++c) color[c] = 255.0 * std::pow(std::pow(color[c] / 255.0, 2.2) * light, 1 / 2.2);
        return color;
    };
    EXPECT_LT(worst([&](double x, double) { return stripe(x) ? lit(0.5) : serosa; }), 0.01) << "half the light";
    EXPECT_LT(worst([&](double x, double z) { return stripe(x) && stripe(z) ? glm::dvec3(255) : serosa; }), 0.01);
    EXPECT_LT(worst([&](double x, double) { return stripe(x) ? glm::dvec3(60, 110, 200) : serosa; }), 0.03) << "blue";
    EXPECT_LT(worst([&](double x, double) { return stripe(x) ? glm::dvec3(60, 60, 60) : serosa; }), 0.01) << "grey";
    EXPECT_LT(worst([&](double x, double) { return stripe(x) ? fat_tissue : serosa; }), 0.01);
    EXPECT_GT(worst([&](double x, double) { return stripe(x) ? artery : serosa; }), 0.75)
        << "the same stripe as artery";
}

TEST(Density, IsTheSizeOfTheTexture) {
    const Organ organ = textured_plane(30.0, painted(57, 131, 30.0, half_fat));
    const DensityMap map = map_of(organ);
    EXPECT_EQ(map.size(), glm::ivec2(57, 131));
    EXPECT_EQ(map.values().size(), 57u * 131u);
}

TEST(Density, SmoothingIsInMillimetresAtAnyResolution) {
    for (const int size : {150, 400, 1600})
        for (const double smoothing : {0.6, 2.0}) {
            VesselParameters parameters;
            parameters.smoothing = smoothing;
            const DensityMap map = map_of(textured_plane(40.0, painted(size, size, 40.0, half_fat)), parameters);
            for (const double x : {-1.5, -0.5, 0.0, 0.5, 1.0, 2.5})
                EXPECT_NEAR(at(map, 40.0, x * smoothing).y, below(x, 1.0), 0.02)
                    << size << " texels, " << smoothing << " mm, at " << x;
        }
}

TEST(Density, TexelsThatAreNotSquareAreSmoothedByMillimetresToo) {
    VesselParameters parameters;
    parameters.smoothing = 1.5;
    const auto slanting = [](double x, double z) { return x + z > 0.0 ? fat_tissue : serosa; };
    const DensityMap map = map_of(textured_plane(40.0, painted(200, 1000, 40.0, slanting)), parameters);
    EXPECT_NEAR(map.layout().texels_per_mm.x, 5.0, 1e-6);
    EXPECT_NEAR(map.layout().texels_per_mm.y, 25.0, 1e-6);
    for (const double d : {-1.5, 0.0, 1.0})
        for (const double along : {-5.0, 6.0})
            EXPECT_NEAR(at(map, 40.0, d * std::sqrt(0.5) + along, d * std::sqrt(0.5) - along).y, below(d, 1.5), 0.02);
}

TEST(Density, VesselsOfTheSameWidthAreFoundAtAnyResolution) {
    const auto paint = [](double x, double) { return std::abs(x) < 0.6 ? artery : serosa; };
    std::vector<double> middle;
    for (const int size : {200, 500, 1500})
        middle.push_back(at(map_of(textured_plane(40.0, painted(size, size, 40.0, paint))), 40.0, 0.0).x);
    EXPECT_GT(middle[1], 0.8);
    EXPECT_NEAR(middle[0], middle[1], 0.05);  // six texels wide
    EXPECT_NEAR(middle[2], middle[1], 0.03);
}

TEST(Density, WhatIsNotOnTheSurfaceDoesNotCount) {
    // The organ uses the left half of the texture; the rest is a gutter with any content.
    const auto with_gutter = [](glm::dvec3 gutter) {
        Organ organ =
            textured_plane(40.0, painted(800, 400, 40.0, [&](double x, double z) {
                               return x > 0.3 ? gutter : std::abs(z) < 0.5 ? artery : z > 10.0 ? fat_tissue : serosa;
                           }));
        for (glm::vec2& uv : organ.uvs) uv.x *= 0.5f;
        return map_of(organ);
    };
    const DensityMap one = with_gutter({0, 0, 0}), other = with_gutter(fat_tissue), third = with_gutter(artery);
    for (const float u : {0.01f, 0.25f, 0.45f, 0.49f})
        for (const float v : {0.2f, 0.45f, 0.5f, 0.7f, 0.9f}) {
            EXPECT_NEAR(one.sample({u, v}).x, other.sample({u, v}).x, 0.02) << u << ' ' << v;
            EXPECT_NEAR(one.sample({u, v}).y, other.sample({u, v}).y, 0.02) << u << ' ' << v;
            EXPECT_NEAR(third.sample({u, v}).x, other.sample({u, v}).x, 0.02) << u << ' ' << v;
        }
    EXPECT_GT(one.sample({0.49f, 0.5f}).x, 0.7f) << "up to the edge";
}

TEST(Density, ARepeatingTextureGoesOnAtItsOtherSide) {
    const auto paint = [](double x, double) { return x < -18.0 ? fat_tissue : serosa; };
    Organ organ = textured_plane(40.0, painted(400, 400, 40.0, paint));
    VesselParameters parameters;
    parameters.smoothing = 1.0;
    const DensityMap single = map_of(organ, parameters);
    for (std::size_t i = 0; i < organ.uvs.size(); ++i) organ.uvs[i] = organ.uvs[i] * 2.0f + 3.0f;
    for (glm::vec3& p : organ.positions) p *= 2.0f;  // there are as many texels per mm as before
    const DensityMap tiled = map_of(organ, parameters);
    EXPECT_FALSE(single.layout().beyond.any);
    EXPECT_TRUE(tiled.layout().beyond.any);
    EXPECT_NEAR(tiled.layout().texels_per_mm.x, single.layout().texels_per_mm.x, 1e-4);
    // Nothing beyond the edge: the share of the surface within 2 mm of it.
    EXPECT_NEAR(at(single, 40.0, -19.95).y, (below(1.95, 1.0) - below(-0.05, 1.0)) / below(0.05, 1.0), 0.02);
    EXPECT_NEAR(at(single, 40.0, 19.5).y, 0.0, 0.01);
    for (const double x : {0.5, 1.0})  // from the edge
        EXPECT_NEAR(at(tiled, 40.0, 20.0 - x).y, below(-x, 1.0) - below(-x - 2.0, 1.0), 0.03);
    EXPECT_NEAR(at(tiled, 40.0, -19.5).y, below(0.5, 1.0) - below(-1.5, 1.0), 0.03);
}

/// The texture that shows the same within 0..1 as `image` does within -0.5..1.5.
Image baked(const Image& image) {
    const auto at = [](int i, int count, Wrap wrap) {
        if (wrap == Wrap::clamp) return std::clamp(i, 0, count - 1);
        const int period = wrap == Wrap::mirror ? 2 * count : count, inside = (i + 2 * period) % period;
        return inside < count ? inside : period - 1 - inside;
    };
    Image out{.width = 2 * image.width, .height = 2 * image.height, .pixels = {}, .name = "baked"};
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            const int from = at(y - image.height / 2, image.height, image.wrap_v) * image.width +
                             at(x - image.width / 2, image.width, image.wrap_u);
            const auto first = image.pixels.begin() + 4 * from;
            out.pixels.insert(out.pixels.end(), first, first + 4);
        }
    return out;
}

TEST(Density, BeyondTheEdgesATextureGoesOnAsItIsDrawn) {
    constexpr double texture = 20.0;  // mm
    const auto paint = [](double x, double z) {
        return x + 0.7 * z < -6.0 ? fat_tissue : std::abs(z - 4.0 + 0.2 * x) < 0.8 ? artery : serosa;
    };
    VesselParameters parameters;
    parameters.smoothing = 0.5;
    parameters.vessel_width = 1.5;
    for (const Wrap u : {Wrap::repeat, Wrap::clamp, Wrap::mirror})
        for (const Wrap v : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
            Image image = painted(200, 200, texture, paint);
            image.wrap_u = u;
            image.wrap_v = v;
            const Organ whole = textured_plane(2 * texture, baked(image));
            Organ organ = textured_plane(2 * texture, image);
            for (glm::vec2& uv : organ.uvs) uv = uv * 2.0f - 0.5f;
            const DensityMap wanted = map_of(whole, parameters), map = map_of(organ, parameters);
            double largest = 0.0, fat = 0.0;
            // Farther out the larger texture ends too soon; beyond a clamped edge, the map has the values of the edge.
            const auto reach = [](Wrap wrap) { return wrap == Wrap::clamp ? 9.9 : 11.0; };
            for (double z = -reach(v); z <= reach(v); z += 0.37)
                for (double x = -reach(u); x <= reach(u); x += 0.37) {
                    const glm::vec2 here = map.sample(glm::vec2(x / texture + 0.5, z / texture + 0.5));
                    const glm::vec2 there = at(wanted, 2 * texture, x, z);
                    largest =
                        std::max({largest, std::abs(double(here.x - there.x)), std::abs(double(here.y - there.y))});
                    fat += double(here.y);
                }
            EXPECT_LT(largest, 0.04) << static_cast<int>(u) << static_cast<int>(v);
            EXPECT_GT(fat, 100.0);
        }
}

TEST(Density, SamplesBetweenTexelsAndAround) {
    const Organ organ = textured_plane(2.0, painted(4, 2, 2.0, half_fat));
    VesselParameters sharp;
    sharp.smoothing = 0.0;
    const DensityMap map = map_of(organ, sharp);
    const auto value = [&](int i) { return map.values()[static_cast<std::size_t>(i)].y / 255.0f; };
    EXPECT_FLOAT_EQ(map.sample({0.375f, 0.25f}).y, value(1));
    EXPECT_FLOAT_EQ(map.sample({0.5f, 0.25f}).y, 0.5f * (value(1) + value(2)));
    EXPECT_FLOAT_EQ(map.sample({0.0f, 0.25f}).y, value(0)) << "the edge goes on";
    EXPECT_FLOAT_EQ(map.sample({1.0f, 9.0f}).y, value(7));
    Organ tiled = organ;
    for (glm::vec2& uv : tiled.uvs) uv *= 3.0f;
    const DensityMap around = map_of(tiled, sharp);
    const auto other = [&](int i) { return around.values()[static_cast<std::size_t>(i)].y / 255.0f; };
    EXPECT_FLOAT_EQ(around.sample({0.0f, 0.25f}).y, 0.5f * (other(0) + other(3))) << "repeats";
    EXPECT_FLOAT_EQ(around.sample({-2.625f, 7.25f}).y, other(1));
    EXPECT_GT(value(2) - value(1), 0.8f);
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        EXPECT_EQ(map.sample({bad, 0.0f}), glm::vec2(0.0f));
        EXPECT_EQ(map.sample({0.0f, -bad}), glm::vec2(0.0f));
    }
    EXPECT_GE(map.sample({1e30f, 3e7f}).y, 0.0f) << "huge coordinates find some texel";
}

TEST(Density, AnImageThatIsNobodysColourHasASizeAndNoSurface) {
    Organ organ = textured_plane(10.0, painted(8, 8, 10.0, half_fat));
    organ.images.push_back(painted(6, 4, 10.0, half_fat));
    DensityMap map(organ, 1);
    map.set({});
    EXPECT_EQ(map.size(), glm::ivec2(6, 4));
    EXPECT_FALSE(map.shows_vessels());
    for (const Density& density : map.values()) EXPECT_EQ(density, Density(0));
}

TEST(Density, AnImageWhosePixelsAreNotThoseOfItsSizeTellsNothing) {
    Organ organ = textured_plane(10.0, painted(8, 8, 10.0, half_fat));
    organ.images[0].pixels.resize(4);
    EXPECT_FALSE(map_of(organ).tells());
    organ.images[0].pixels.clear();
    EXPECT_FALSE(map_of(organ).tells());
}

TEST(Density, OneColourTellsNothing) {
    for (const int size : {1, 64}) {
        const Organ organ = textured_plane(10.0, painted(size, size, 10.0, [](double, double) { return artery; }));
        const DensityMap map = map_of(organ);
        EXPECT_FALSE(map.tells());
        EXPECT_EQ(map.values().size(), static_cast<std::size_t>(size * size));
    }
    EXPECT_TRUE(map_of(textured_plane(10.0, painted(2, 1, 10.0, half_fat))).tells());
}

TEST(Density, TheMaterialsColourIsPartOfTheTextures) {
    Organ organ = textured_plane(
        20.0, painted(40, 40, 20.0, [](double x, double) { return x > 0 ? glm::dvec3(255) : glm::dvec3(120); }));
    EXPECT_LT(at(map_of(organ), 20.0, 5.0).y, 0.01) << "white and grey";
    organ.materials[0].base_color = {linear(240), linear(176), linear(96), 1.0f};
    EXPECT_GT(at(map_of(organ), 20.0, 5.0).y, 0.95);
    EXPECT_GT(at(map_of(organ), 20.0, -5.0).y, 0.95);
}

TEST(Density, BadTextureCoordinatesAreLeftOut) {
    Organ organ = textured_plane(40.0, painted(400, 400, 40.0, half_fat), 8);
    organ.uvs[0].x = std::numeric_limits<float>::quiet_NaN();
    organ.uvs[1].y = std::numeric_limits<float>::infinity();
    organ.uvs[5].x = 1e20f;
    const DensityMap map = map_of(organ);
    EXPECT_NEAR(map.layout().texels_per_mm.x, 10.0, 1e-4);
    EXPECT_FALSE(map.layout().beyond.any);
    EXPECT_NEAR(at(map, 40.0, 0.0).y, 0.5, 0.02);
    for (glm::vec2& uv : organ.uvs) uv = glm::vec2(std::numeric_limits<float>::quiet_NaN());
    const DensityMap none = map_of(organ);
    EXPECT_EQ(none.layout().texels_per_mm, glm::dvec2(0.0));
    EXPECT_EQ(none.sample({0.5f, 0.5f}), glm::vec2(0.0f));
}

}  // namespace
}  // namespace lapfx::bleeding
