// Coarse organs: the result of splitting them, and that blood and burns are those of a fine mesh.
#include "lapfx/refine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "cautery/cautery.h"
#include "lapfx/amounts.h"
#include "lapfx/authoring/organ_report.h"
#include "lapfx/error.h"
#include "organ/refine.h"
#include "support/logged.h"
#include "support/meshes.h"
#include "unit/organ/fixtures.h"

namespace lapfx {
namespace {

constexpr double longest = 2.0;

/// A box of 12 triangles around the origin whose faces have separate corners, so that every edge is a seam.
Organ box(double side) {
    Organ organ;
    std::vector<glm::vec3> normals;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {-1.0f, 1.0f}) {
            glm::vec3 n(0.0f), u(0.0f);
            n[axis] = sign;
            u[(axis + 1) % 3] = 1.0f;
            const glm::vec3 v = glm::cross(n, u);
            const auto first = static_cast<std::uint32_t>(organ.positions.size());
            for (const glm::vec2 c : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
                organ.positions.push_back(0.5f * static_cast<float>(side) * (n + c.x * u + c.y * v));
                normals.push_back(n);
            }
            for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) organ.indices.push_back(first + i);
        }
    Organ whole = test::drawable(std::move(organ), normals);
    for (std::size_t v = 0; v < whole.uvs.size(); ++v) whole.uvs[v] = glm::vec2(v % 4 == 1 || v % 4 == 2, v % 4 > 1);
    return whole;
}

double longest_edge(const Organ& organ) {
    double most = 0.0;
    for (std::size_t i = 0; i < organ.indices.size(); ++i) {
        const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
        most = std::max(most, glm::distance(glm::dvec3(organ.positions[organ.indices[i]]),
                                            glm::dvec3(organ.positions[organ.indices[next]])));
    }
    return most;
}

Preset plain() {
    Preset preset;
    preset.bleeding.speed = 4.0;
    preset.bleeding.max_extent = 16.0;
    preset.bleeding.gravity_bias = preset.bleeding.crease_bias = 0.0;
    return preset;
}

Amounts bled(const Organ& organ, const glm::dvec3& at, const Preset& preset, double time = 10.0) {
    const ToolContact cut{.action = ToolAction::cut, .time = 0.0, .duration = 0.1, .position = at, .to = at};
    AmountsModel model(organ);
    model.set(preset, {&cut, 1});
    return model.at(time);
}

TEST(Refine, BloodCoversTheSameOnEveryMesh) {
    const Preset preset = plain();
    const double radius = preset.bleeding.max_extent - preset.bleeding.threshold;
    const double area = std::numbers::pi * radius * radius;
    for (const glm::dvec3 at : {glm::dvec3(0, 0, 0), glm::dvec3(2.3, 0, 4.1), glm::dvec3(-7.7, 0, 9.1)}) {
        const double volume = bled(test::plane(240.0, 240), at, preset).blood_volume;
        for (const std::uint32_t squares : {240u, 80u, 40u, 20u, 12u, 6u, 1u}) {
            const Amounts found = bled(test::plane(240.0, squares), at, preset);
            EXPECT_NEAR(found.blood_area, area, 0.05 * area) << 240.0 / squares << " mm edges at " << at.x;
            EXPECT_NEAR(found.blood_volume, volume, 0.05 * volume) << 240.0 / squares << " mm edges at " << at.x;
        }
        EXPECT_NEAR(bled(box(100.0), {at.x, 50.0, at.z}, preset).blood_area, area, 0.05 * area) << "box at " << at.x;
    }
}

TEST(Refine, SmallPoolsToo) {
    Preset preset = plain();
    preset.bleeding.max_extent = 6.0;
    const double area = bled(test::plane(240.0, 240), {-7.7, 0, 9.1}, preset).blood_area;
    for (const std::uint32_t squares : {80u, 20u, 6u, 1u})
        EXPECT_NEAR(bled(test::plane(240.0, squares), {-7.7, 0, 9.1}, preset).blood_area, area, 0.05 * area) << squares;
}

TEST(Refine, TheRadiusByAreaIsSpeedTimesTimeOnEveryMesh) {
    Preset preset = plain();
    preset.bleeding.threshold = preset.bleeding.noise_strength = preset.bleeding.rivulets = 0.0;
    for (const std::uint32_t squares : {240u, 80u, 60u, 40u, 30u, 20u, 12u, 2u, 1u})
        for (const glm::dvec3 at : {glm::dvec3(0, 0, 0), glm::dvec3(2.3, 0, 4.1), glm::dvec3(1.03, 0, 0.51)}) {
            const Organ organ = test::plane(120.0, squares);
            for (const double time : {0.5, 1.0, 2.0, 5.0}) {
                const double radius = std::sqrt(bled(organ, at, preset, time).blood_area / std::numbers::pi);
                const double wanted = std::min(preset.bleeding.speed * time, preset.bleeding.max_extent);
                EXPECT_NEAR(radius, wanted, std::max(0.015 * wanted, 0.11))
                    << 120.0 / squares << " mm edges at " << at.x << " after " << time;
            }
        }
}

TEST(Refine, BurnsAreThoseOfAFineMesh) {
    const auto charred = [](const Organ& given, HeatModel model) {
        const Organ organ = refine(given).organ;
        const Surface surface(organ);
        test::Logged<cautery::Cautery> cautery(surface, {});
        CauteryParameters parameters;
        parameters.model = model;
        const std::vector<ToolContact> burn{{.duration = 3.0, .position = {2.3, 0, 4.1}, .to = {2.3, 0, 4.1}}};
        cautery.set(burn, parameters);
        cautery.update(3.0);
        double sum = 0.0;
        for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
            const auto& c = surface.triangles[t];
            const auto& p = surface.positions;
            const double area = 0.5 * glm::length(glm::cross(p[c[1]] - p[c[0]], p[c[2]] - p[c[0]]));
            for (int k = 0; k < 3; ++k) sum += area / 3.0 * cautery.marks()[organ.indices[3 * t + std::size_t(k)]].x;
        }
        return sum;
    };
    constexpr double within = 0.05;
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        const double fine = charred(test::plane(120.0, 240), model);
        EXPECT_GT(fine, 5.0);
        for (const std::uint32_t squares : {20u, 3u, 1u})
            EXPECT_NEAR(charred(test::plane(120.0, squares), model), fine, within * fine) << squares;
    }
}

/// mm2 that a burn of 3 s at full power chars.
double burnt_area(const Organ& given, const glm::dvec3& tip, HeatModel model) {
    Preset preset = plain();
    preset.cautery.model = model;
    const ToolContact burn{.time = 0.0, .duration = 3.0, .position = tip, .to = tip};
    AmountsModel amounts(given);
    amounts.set(preset, {&burn, 1});
    return amounts.at(3.0).burnt_area;
}

TEST(Refine, TheBurntAreaIsThatOfAFineMeshWhereverTheTipStandsInItsTriangle) {
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        const double fine = burnt_area(test::plane(120.0, 240), {2.3, 0, 4.1}, model);
        EXPECT_NEAR(fine, std::numbers::pi * 2.08 * 2.08, 0.05 * fine) << "the radius of a burn of 3 s, parameters.cpp";
        for (const std::uint32_t squares : {120u, 40u, 35u, 31u, 27u, 12u, 2u})
            for (const glm::dvec2 share : {glm::dvec2(0.0), {0.5, 0.0}, {0.5, 0.5}, {0.33, 0.33}}) {
                const double edge = 120.0 / squares, corner = edge * (squares / 2) - 60.0;
                const glm::dvec3 tip(corner + share.x * edge, 0.0, corner + share.y * edge);
                EXPECT_NEAR(burnt_area(test::plane(120.0, squares), tip, model), fine, 0.035 * fine)
                    << edge << " mm edges, the tip at " << share.x << ' ' << share.y << " of a square";
            }
    }
}

TEST(Refine, VerticesAreBurntAsOnAFineMesh) {
    const auto burnt = [](const Organ& organ) {
        const Surface surface(organ);
        test::Logged<cautery::Cautery> cautery(surface, {});
        CauteryParameters parameters;
        parameters.model = HeatModel::radial;
        const std::vector<ToolContact> burn{{.duration = 3.0, .position = {2.3, 0, 4.1}, .to = {2.3, 0, 4.1}}};
        cautery.set(burn, parameters);
        cautery.update(3.0);
        std::map<std::pair<float, float>, float> char_at;
        for (std::size_t v = 0; v < organ.positions.size(); ++v)
            char_at[{organ.positions[v].x, organ.positions[v].z}] = cautery.marks()[v].x;
        return char_at;
    };
    const auto fine = burnt(test::plane(120.0, 480));
    int charred = 0;
    for (const std::uint32_t squares : {20u, 3u})  // whose middles lie where the fine mesh has vertices
        for (const auto& [place, value] : burnt(refine(test::plane(120.0, squares)).organ)) {
            const auto found = fine.find(place);
            ASSERT_NE(found, fine.end());
            EXPECT_NEAR(value, found->second, 1e-5) << place.first << ' ' << place.second;
            charred += value > 0.0f;
        }
    EXPECT_GT(charred, 5);
}

TEST(Refine, ABoxStaysClosedAndKeepsItsShape) {
    const Organ given = box(100.0);
    const RefinedOrgan fine = refine(given);
    const OrganReport report = lapfx::report(fine.organ);
    EXPECT_EQ(report.boundary_edges, 0u) << "no crack at the seams";
    EXPECT_EQ(report.non_manifold_edges, 0u);
    EXPECT_EQ(report.components, 1u);
    EXPECT_LE(longest_edge(fine.organ), longest);
    EXPECT_NEAR(test::volume(fine.organ), 1e6, 1.0);
    EXPECT_EQ(fine.organ.triangle_count(), report_refine(given).triangles);
    EXPECT_LT(fine.organ.triangle_count(), 100'000u);
    EXPECT_EQ(report_refine(given).longest_edge, longest);
    EXPECT_EQ(report_refine(fine.organ).longest_edge, 0.0) << "nothing is left to split";
}

TEST(Refine, NewVerticesLieMidwayAndCarryWhatLiesBetween) {
    const Organ given = box(20.0);
    const RefinedOrgan fine = refine(given);
    const std::size_t first = given.positions.size();
    ASSERT_EQ(fine.organ.positions.size(), first + fine.midpoints.size());
    EXPECT_TRUE(std::equal(given.positions.begin(), given.positions.end(), fine.organ.positions.begin()));
    for (std::size_t i = 0; i < fine.midpoints.size(); ++i) {
        const std::size_t v = first + i, a = fine.midpoints[i].x, b = fine.midpoints[i].y;
        ASSERT_LT(std::max(a, b), v);
        const Organ& o = fine.organ;
        EXPECT_EQ(o.positions[v], 0.5f * (o.positions[a] + o.positions[b]));
        EXPECT_EQ(o.uvs[v], 0.5f * (o.uvs[a] + o.uvs[b]));
        EXPECT_EQ(o.normals[v], o.normals[a]) << "flat faces stay flat";
        EXPECT_NEAR(glm::length(glm::vec3(o.tangents[v])), 1.0f, 1e-5f);
    }
}

TEST(Refine, PartsKeepTheirTriangles) {
    Organ given = test::plane(30.0, 2);
    given.parts = {{.name = "a", .first_index = 0, .index_count = 9, .material = 0},
                   {.name = "b", .first_index = 9, .index_count = 15, .material = 0}};
    const Organ fine = refine(given).organ;
    ASSERT_EQ(fine.parts.size(), 2u);
    EXPECT_EQ(fine.parts[0].first_index, 0u);
    EXPECT_EQ(fine.parts[1].first_index, fine.parts[0].index_count);
    EXPECT_EQ(fine.parts[1].first_index + fine.parts[1].index_count, fine.indices.size());
    const auto area = [](const Organ& organ, const Part& part) {
        double sum = 0.0;
        for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; i += 3) {
            const glm::dvec3 p(organ.positions[organ.indices[i]]), q(organ.positions[organ.indices[i + 1]]),
                r(organ.positions[organ.indices[i + 2]]);
            sum += 0.5 * glm::length(glm::cross(q - p, r - p));
        }
        return sum;
    };
    for (std::size_t p = 0; p < 2; ++p) EXPECT_NEAR(area(fine, fine.parts[p]), area(given, given.parts[p]), 1e-3);
}

TEST(Refine, AFineOrganIsLeftAsItIs) {
    const Organ given = test::plane(30.0, 24);  // diagonals of 1.77 mm
    const RefinedOrgan fine = refine(given);
    EXPECT_TRUE(fine.midpoints.empty());
    EXPECT_EQ(fine.organ.indices, given.indices);
    EXPECT_EQ(fine.organ.positions, given.positions);
    EXPECT_EQ(report_refine(given).triangles, given.triangle_count());
}

TEST(Refine, OnlyWhatIsCoarseIsSplit) {
    // Fine squares beside one large triangle.
    Organ given = test::plane(30.0, 24);
    const auto first = static_cast<std::uint32_t>(given.positions.size());
    std::vector<glm::vec3> normals = given.normals;
    for (const glm::vec3 p : {glm::vec3(50, 0, 0), glm::vec3(50, 0, 20), glm::vec3(70, 0, 0)}) {
        given.positions.push_back(p);
        normals.push_back({0, 1, 0});
    }
    given.indices.insert(given.indices.end(), {first, first + 1, first + 2});
    const std::size_t fine_ones = given.triangle_count() - 1;
    given = test::drawable(given, normals);
    const Organ fine = refine(given).organ;
    EXPECT_TRUE(
        std::equal(given.indices.begin(), given.indices.begin() + std::ptrdiff_t(3 * fine_ones), fine.indices.begin()));
    EXPECT_GT(fine.triangle_count(), fine_ones + 20);
}

TEST(Refine, ARoomDoesNotExplode) {
    const Organ room = box(5000.0);
    const RefineReport plan = report_refine(room);
    EXPECT_TRUE(plan.bounded);
    EXPECT_GT(plan.longest_edge, longest);
    const Organ fine = refine(room).organ;
    EXPECT_LE(fine.triangle_count(), 12u + 300'000u);
    EXPECT_GT(fine.triangle_count(), 100'000u) << "as far as it goes";
    EXPECT_LE(longest_edge(fine), plan.longest_edge);
    EXPECT_TRUE(test::has_warning(report(room).warnings, "blood and burns can be no finer than edges of"));
}

TEST(Refine, ASceneAsLargeAsAnAbdomenIsNotToldOf) {
    const Organ abdomen = box(300.0);
    const RefineReport plan = report_refine(abdomen);
    EXPECT_TRUE(plan.bounded);
    EXPECT_GT(plan.longest_edge, longest);
    EXPECT_LT(plan.longest_edge, 4.0);
    EXPECT_TRUE(report(abdomen).warnings.empty());
}

TEST(Refine, WhatIsFineInTheFileStaysFineBesideALargeRoom) {
    // An organ of 60 mm with edges of 4.2 mm on the floor of a room of 3 m.
    Organ organ = test::plane(60.0, 20);
    const std::size_t fine_ones = organ.triangle_count();
    const Organ room = box(3000.0);
    const auto first = static_cast<std::uint32_t>(organ.positions.size());
    std::vector<glm::vec3> normals = organ.normals;
    organ.positions.insert(organ.positions.end(), room.positions.begin(), room.positions.end());
    normals.insert(normals.end(), room.normals.begin(), room.normals.end());
    for (const std::uint32_t i : room.indices) organ.indices.push_back(first + i);
    organ = test::drawable(std::move(organ), normals);
    EXPECT_TRUE(report_refine(organ).bounded);
    Organ fine = refine(organ).organ;
    EXPECT_EQ(2 * report(organ).boundary_edges, report(fine).boundary_edges) << "no crack but the plane's rim";
    const auto far = std::find_if(fine.indices.begin(), fine.indices.end(),
                                  [&](std::uint32_t i) { return std::abs(fine.positions[i].x) > 31.0f; });
    fine.indices.resize(static_cast<std::size_t>(far - fine.indices.begin()) / 3 * 3);
    EXPECT_GE(fine.triangle_count(), 8 * fine_ones) << "the organ, whose triangles come first";
    EXPECT_LE(longest_edge(fine), longest);
}

TEST(Refine, WhatHasNoMiddleIsLeft) {
    Organ organ = test::plane(20.0, 1);
    for (glm::vec3& p : organ.positions) p.x += 9.9e8f;  // whose neighbours are 64 mm away
    EXPECT_LE(refine(organ).organ.triangle_count(), organ::most_added + 2);
}

TEST(Refine, WhatIsNoPlaceIsRefused) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    for (const float far : {1.1e9f, -1e30f, infinite, std::numeric_limits<float>::quiet_NaN()}) {
        Organ organ = test::plane(20.0, 1);
        for (glm::vec3& p : organ.positions) p.x += far;
        EXPECT_THROW(refine(organ), Error) << far;
    }
}

TEST(Refine, ALengthThatWillDoIsFoundAtOnceInAnyUnit) {
    const organ::RefinePlan room = organ::plan_refine(box(5000.0));
    // Twelve halves of squares, halved 13 times, and those halves again; a step finer would be too many.
    EXPECT_EQ(room.triangles, 12U << 14);
    EXPECT_NEAR(room.length, longest * std::pow(1.25, 15.0), 1e-9);
    for (const double side : {5e3, 5e4, 5e6, 5e8}) {
        const organ::RefinePlan plan = organ::plan_refine(box(side));
        EXPECT_LE(plan.counts, 8) << side;
        EXPECT_GT(plan.triangles, 50'000U) << side;
        EXPECT_LE(plan.triangles, 12U + organ::most_added) << side;
    }
    // Long and thin, with almost no area to estimate from.
    Organ needle = test::plane(1.0, 1);
    for (glm::vec3& p : needle.positions) p.x *= 1e8F;
    const organ::RefinePlan thin = organ::plan_refine(needle);
    EXPECT_LE(thin.counts, 14) << "of 141 steps from 2 mm to 1e7";
    EXPECT_GT(thin.triangles, 50'000U);
    EXPECT_EQ(organ::plan_refine(box(100.0)).counts, 1) << "what is within the bound is not estimated";
}

TEST(Refine, CanBeStopped) {
    const Organ room = box(5000.0);
    const Progress never = [](double) { return false; };
    EXPECT_THROW(organ::plan_refine(room, work::Stages(never)), work::Stopped);
    const organ::RefinePlan plan = organ::plan_refine(room);
    std::vector<double> shares;
    const Progress note = [&](double share) {
        shares.push_back(share);
        return true;
    };
    organ::refine(room, plan, work::Stages(note));
    EXPECT_GT(shares.size(), 4U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_LE(shares.back(), 1.0);
    for (std::size_t stop = 1; stop <= shares.size(); ++stop) {
        std::size_t asked = 0;
        const Progress until = [&](double) { return ++asked < stop; };
        EXPECT_THROW(organ::refine(room, plan, work::Stages(until)), work::Stopped);
    }
}

}  // namespace
}  // namespace lapfx
