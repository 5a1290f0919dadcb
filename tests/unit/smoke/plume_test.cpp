#include "smoke/plume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "unit/smoke/support.h"

namespace lapfx::smoke {
namespace {

constexpr glm::dvec3 up{0.0, 1.0, 0.0};

PlumeParameters parameters() {
    PlumeParameters p;
    p.size = 40.0;
    p.density = 2.0;
    p.rise = 6.0;
    p.growth = 0.25;
    p.fade_in = 0.4;
    p.fade_out = 2.0;
    return p;
}

/// From (0, 0, 0) to (10, 0, 0) between 1 s and 3 s, half power.
ToolContact contact(ToolAction action = ToolAction::cauterise) {
    return {.action = action, .time = 1.0, .duration = 2.0, .position = {0, 0, 0}, .to = {10, 0, 0}, .power = 0.5};
}

PlumeState plume_state(std::span<const ToolContact> contacts, const PlumeParameters& plume, glm::dvec3 rising,
                       double time, double fat = 0.0) {
    const BurnList burns = burns_of(contacts, fat);
    const std::span<const Burn> all = burns.after(-1e9);
    return all.empty() ? PlumeState() : plume_state(all.front(), burns.parts(), plume, rising, time);
}
PlumeState plume_state(const ToolContact& one, const PlumeParameters& plume, glm::dvec3 rising, double time,
                       double fat = 0.0) {
    return plume_state(std::span(&one, 1), plume, rising, time, fat);
}

double density(double time, const PlumeParameters& p = parameters()) {
    return plume_state(contact(), p, up, time).density;
}

TEST(Plume, FadesInBurnsAndFadesOut) {
    EXPECT_EQ(density(0.99), 0.0);
    EXPECT_EQ(density(1.0), 0.0);
    EXPECT_NEAR(density(1.1), 2.0 * 0.5 * 0.15625, 1e-12) << "smoothstep of a quarter";
    EXPECT_NEAR(density(1.2), 0.5, 1e-12);
    EXPECT_NEAR(density(2.0), 1.0, 1e-12);
    EXPECT_NEAR(density(3.0), 1.0, 1e-12);
    EXPECT_NEAR(density(4.0), 0.5, 1e-12);
    EXPECT_NEAR(density(5.0), 0.0, 1e-12);
    EXPECT_EQ(density(5.01), 0.0);
}

TEST(Plume, WithoutFadesItIsThereExactlyWhileTheToolBurns) {
    PlumeParameters p = parameters();
    p.fade_in = p.fade_out = 0.0;
    EXPECT_EQ(density(0.999, p), 0.0);
    EXPECT_EQ(density(1.0, p), 1.0);
    EXPECT_EQ(density(2.999, p), 1.0);
    EXPECT_EQ(density(3.001, p), 0.0);
}

TEST(Plume, ColdToolsDoNotSmoke) {
    for (const double time : {1.5, 2.5, 3.5}) {
        EXPECT_EQ(plume_state(contact(ToolAction::cut), parameters(), up, time).density, 0.0);
        EXPECT_EQ(plume_state(contact(ToolAction::tear), parameters(), up, time).density, 0.0);
        EXPECT_GT(plume_state(contact(ToolAction::coagulate), parameters(), up, time).density, 0.0);
    }
}

TEST(Plume, StandsOnTheTipAndRisesWhenItStops) {
    const auto anchor = [](double time) { return plume_state(contact(), parameters(), up, time).anchor; };
    EXPECT_EQ(anchor(2.0), glm::dvec3(5, 0, 0));
    EXPECT_EQ(anchor(3.0), glm::dvec3(10, 0, 0));
    EXPECT_EQ(anchor(3.5), glm::dvec3(10, 3, 0));
    const glm::dvec3 aside(0.0, 0.0, -1.0);
    EXPECT_EQ(plume_state(contact(), parameters(), aside, 4.0).anchor, glm::dvec3(10, 0, -6));
}

TEST(Plume, IsSmallWhenYoungAndGrowsWhenTheToolStops) {
    PlumeParameters p = parameters();
    p.rise = 0.0;
    for (const auto& [time, wanted] :
         {std::pair{1.0, 24.0}, {1.4, 32.0}, {1.8, 40.0}, {3.0, 40.0}, {4.0, 50.0}, {5.0, 60.0}}) {
        EXPECT_NEAR(plume_state(contact(), p, up, time).height, wanted, 1e-9) << time;
        EXPECT_NEAR(plume_state(contact(), p, up, time).size, wanted, 1e-9) << time;
    }
}

// Smoke at the top is as old as the burn, but slows down: 2 * (1 - exp(-1 / 2)) s after 1 s.
TEST(Plume, RisesAndWidensWhileTheToolIsOn) {
    constexpr double one = 0.7869386805747332, two = 1.2642411176571153;  // age after 1 and 2 s of burning
    const auto at = [](double time, double rise, double growth) {
        PlumeParameters p = parameters();
        p.rise = rise, p.growth = growth;
        return plume_state(contact(), p, up, time);
    };
    for (const double rise : {6.0, 20.0, 60.0})
        for (const double growth : {0.25, 1.0, 3.0}) {
            EXPECT_NEAR(at(1.0, rise, growth).height, 24.0, 1e-9) << "nothing has risen yet";
            EXPECT_EQ(at(1.0, rise, growth).widening, 1.0);
            EXPECT_NEAR(at(2.0, rise, growth).height, 40.0 + rise * one, 1e-9);
            EXPECT_NEAR(at(2.0, rise, growth).widening, 1.0 + growth * one, 1e-9);
            EXPECT_NEAR(at(2.0, rise, growth).size, 40.0, 1e-9) << "at the tip it is as wide as ever";
            EXPECT_NEAR(at(3.0, rise, growth).height, 40.0 + rise * two, 1e-9);
            EXPECT_NEAR(at(3.0, rise, growth).widening, 1.0 + growth * two, 1e-9);
        }
    EXPECT_NEAR(at(4.0, 6.0, 0.25).height, 1.25 * (40.0 + 6.0 * two), 1e-9) << "afterwards it grows as a whole";
    EXPECT_NEAR(at(4.0, 6.0, 0.25).widening, (1.25 + 0.25 * two) / 1.25, 1e-9);
    EXPECT_NEAR(at(3.0 + 1e-9, 6.0, 0.25).height, at(3.0, 6.0, 0.25).height, 1e-6) << "without a jump";
}

TEST(Plume, ComesToRestHoweverLongTheToolIsOn) {
    ToolContact longer = contact();
    longer.duration = 600.0;
    EXPECT_NEAR(plume_state(longer, parameters(), up, 600.0).height, 40.0 + 6.0 * 2.0, 1e-6);
    EXPECT_NEAR(plume_state(longer, parameters(), up, 600.0).widening, 1.0 + 0.25 * 2.0, 1e-6);
}

TEST(PlumePlace, IsThatOfTheClipAtTheTipAndWiderAndThinnerAbove) {
    const glm::vec2 source(0.25f, 0.8f);
    const auto expect = [&](glm::vec2 drawn, glm::vec2 uv, float thickness) {
        const PlumePlace place = plume_place(drawn, source, 2.0f);
        EXPECT_NEAR(glm::distance(place.uv, uv), 0.0f, 1e-6f) << drawn.x << ' ' << drawn.y;
        EXPECT_NEAR(place.thickness, thickness, 1e-6f) << drawn.x << ' ' << drawn.y;
    };
    expect(source, source, 1.0f);
    expect({0.0f, 0.0f}, {0.0f, 0.0f}, 0.5f);
    expect({1.0f, 0.0f}, {1.0f, 0.0f}, 0.5f);
    expect({0.5f, 0.8f}, {0.75f, 0.8f}, 1.0f);
    expect({0.55f, 0.4f}, {0.65f, 0.4f}, 1.0f / 1.5f);
    expect({0.5f, 1.0f}, {0.75f, 1.0f}, 1.0f);
    for (float x = 0.0f; x <= 1.0f; x += 0.125f)
        EXPECT_NEAR(plume_place({x, 0.3f}, source, 1.0f).uv.x, x, 1e-6f) << "without widening it is where it is drawn";
    EXPECT_NEAR(plume_place({0.4f, 0.0f}, {0.5f, 0.0f}, 2.0f).uv.x, 0.3f, 1e-6f) << "a source at the very top";
}

// The sum of thickness over a row, per width of the clip at the tip.
TEST(PlumePlace, WideningAddsNoSmoke) {
    for (const float widening : {1.0f, 1.7f, 4.0f})
        for (const float y : {0.0f, 0.3f, 0.85f}) {
            double sum = 0.0;
            for (int i = 0; i < 10000; ++i) {
                const PlumePlace place =
                    plume_place({(static_cast<float>(i) + 0.5f) / 10000.0f, y}, {0.4f, 0.9f}, widening);
                if (place.uv.x >= 0.0f && place.uv.x <= 1.0f) sum += place.thickness * widening / 10000.0;
            }
            EXPECT_NEAR(sum, 1.0, 1e-3) << widening << ' ' << y;
        }
}

TEST(Plume, FatSmokesMore) {
    PlumeParameters p = parameters();
    p.fat_gain = 1.5;
    EXPECT_NEAR(plume_state(contact(), p, up, 2.0, 0.4).density, 1.6 * plume_state(contact(), p, up, 2.0).density,
                1e-12);
    EXPECT_NEAR(emission(contact(), 1.0, p), 0.5 * 2.5, 1e-12);
    p.fat_gain = 0.0;
    EXPECT_EQ(plume_state(contact(), p, up, 2.0, 0.4).density, plume_state(contact(), p, up, 2.0).density);
}

/// The same stay as contacts that meet at these times.
std::vector<ToolContact> split(const ToolContact& whole, std::span<const double> times) {
    std::vector<ToolContact> parts;
    double from = whole.time;
    const auto add = [&](double to) {
        ToolContact part = whole;
        part.time = from;
        part.duration = to - from;
        part.position = whole.tip(from);
        part.to = whole.tip(to);
        parts.push_back(part);
        from = to;
    };
    for (const double time : times) add(time);
    add(whole.end());
    return parts;
}

void expect_same(const PlumeState& a, const PlumeState& b, double time) {
    EXPECT_NEAR(a.density, b.density, 1e-12) << time;
    EXPECT_NEAR(a.height, b.height, 1e-9) << time;
    EXPECT_NEAR(a.size, b.size, 1e-9) << time;
    EXPECT_NEAR(a.widening, b.widening, 1e-12) << time;
    EXPECT_LT(glm::distance(a.anchor, b.anchor), 1e-9) << time;
}

TEST(Plume, IsTheSameHoweverAStayIsSplit) {
    std::vector<double> many;
    for (int i = 1; i < 20; ++i) many.push_back(1.0 + 0.1 * i);
    for (const std::vector<double>& times : {std::vector{1.0001}, {1.3}, {2.9999}, {1.0, 1.1, 1.1, 3.0}, many})
        for (double time = 0.95; time < 5.1; time += 0.05)
            expect_same(plume_state(split(contact(), times), parameters(), up, time, 0.3),
                        plume_state(contact(), parameters(), up, time, 0.3), time);
}

TEST(Plume, OfAShortTouchIsOnlyAsDenseAsItHadBecome) {
    const PlumeParameters p = parameters();  // fade_in 0.4
    const auto peak = [&](double duration) {
        ToolContact touch = contact();
        touch.duration = duration;
        double most = 0.0;
        for (double time = 1.0; time < 4.0; time += 0.001)
            most = std::max(most, plume_state(touch, p, up, time).density);
        return most;
    };
    EXPECT_NEAR(peak(0.01), 3.0 * 0.025 * 0.025 - 2.0 * 0.025 * 0.025 * 0.025, 1e-5) << "of 1";
    EXPECT_NEAR(peak(0.2), 0.5, 1e-5);
    EXPECT_NEAR(peak(0.4), 1.0, 1e-5);
    EXPECT_NEAR(peak(2.0), 1.0, 1e-12);
}

TEST(Plume, FollowsThePowerWithoutAJump) {
    PlumeParameters p = parameters();
    std::vector<ToolContact> both = split(contact(), std::vector{2.0});
    both[1].power = 1.0;
    const auto at = [&](double time) { return plume_state(both, p, up, time).density; };
    EXPECT_NEAR(at(2.0), 1.0, 1e-12);
    EXPECT_NEAR(at(2.2), 1.5, 1e-12) << "half of the last 0.4 s";
    EXPECT_NEAR(at(2.4), 2.0, 1e-12);
    EXPECT_NEAR(at(3.0), 2.0, 1e-12);
    p.fade_in = 0.0;
    EXPECT_EQ(at(1.999), 1.0);
    EXPECT_EQ(at(2.0), 2.0) << "at once";
}

PlumeQuad quad() {
    return {.anchor = {0.0f, 0.0f, -100.0f}, .extent = {60.0f, 40.0f}, .source = {0.25f, 0.9f}};
}

TEST(PlumeQuad, TheSourceLiesOnTheAnchorHoweverItIsTurned) {
    PlumeQuad q = quad();
    for (const bool mirrored : {false, true})
        for (const float angle : {0.0f, 0.7f, -2.0f}) {
            q.turn = {mirrored, angle};
            const auto c = plume_corners(q);
            const glm::vec2 at(mirrored ? 0.75f : 0.25f, 0.9f);
            const glm::vec3 source = glm::mix(glm::mix(c[0], c[1], at.x), glm::mix(c[2], c[3], at.x), at.y);
            EXPECT_NEAR(glm::distance(source, q.anchor), 0.0f, 1e-4f) << mirrored << ' ' << angle;
            EXPECT_NEAR(glm::distance(c[0], c[1]), 60.0f, 1e-3f);
            EXPECT_NEAR(glm::distance(c[0], c[2]), 40.0f, 1e-3f);
        }
}

TEST(PlumeQuad, StandsUprightAndTurnsCounterClockwise) {
    PlumeQuad q = quad();
    auto c = plume_corners(q);
    EXPECT_NEAR(glm::distance(c[0], glm::vec3(-15.0f, 36.0f, -100.0f)), 0.0f, 1e-4f) << "top left";
    EXPECT_NEAR(glm::distance(c[3], glm::vec3(45.0f, -4.0f, -100.0f)), 0.0f, 1e-4f) << "bottom right";
    q.turn.angle = glm::radians(90.0f);
    c = plume_corners(q);
    EXPECT_NEAR(glm::distance(c[0], glm::vec3(-36.0f, -15.0f, -100.0f)), 0.0f, 1e-4f);
    q.turn.angle = 0.0f;
    q.up = {1.0f, 0.0f};
    c = plume_corners(q);
    EXPECT_NEAR(glm::distance(c[0], glm::vec3(36.0f, 15.0f, -100.0f)), 0.0f, 1e-4f) << "up is to the right";
}

TEST(PlumeQuad, LeansTowardsTheCameraAsFarAsItRisesButNotToTheLens) {
    PlumeQuad q = quad();
    q.lean = 0.5f;
    auto c = plume_corners(q);
    const auto leant = [](float wanted) { return -100.0f + wanted / std::sqrt(1.0f + wanted * wanted / 3600.0f); };
    EXPECT_NEAR(c[0].z, leant(18.0f), 1e-4f);
    EXPECT_NEAR(c[2].z, -100.0f, 1e-4f) << "below the source it stays";
    q.turn.angle = glm::radians(180.0f);
    c = plume_corners(q);
    EXPECT_NEAR(c[0].z, -100.0f, 1e-4f) << "the clip's top hangs down";
    EXPECT_NEAR(c[2].z, leant(2.0f), 1e-4f);
    q.turn.angle = 0.0f;
    q.lean = 1.5f;
    q.extent = {600.0f, 400.0f};
    EXPECT_NEAR(plume_corners(q)[0].z, leant(540.0f), 1e-4f);
}

// A plume of 110 mm, 60 to 150 mm before the lens: every step of lean moves its top, and never to the lens.
TEST(PlumeQuad, LeanActsOverItsWholeRange) {
    for (const float distance : {60.0f, 100.0f, 150.0f}) {
        PlumeQuad q{.anchor = {0.0f, 0.0f, -distance}, .extent = {160.0f, 110.0f}, .source = {0.5f, 0.92f}};
        float before = -distance;
        for (float lean = 0.05f; lean < 1.51f; lean += 0.05f) {
            q.lean = lean;
            const float top = plume_corners(q)[0].z;
            EXPECT_GT(top, before + 0.05f) << distance << ' ' << lean;
            EXPECT_LE(top, -0.4f * distance);
            before = top;
        }
    }
}

TEST(PlumeQuad, BoundsAreThoseOfItsPicture) {
    const glm::mat4 projection = glm::perspective(glm::radians(90.0f), 1.0f, 1.0f, 1000.0f);
    const glm::vec4 b = view_bounds(plume_corners(quad()), projection);  // 100 mm away the view is 200 mm wide and high
    EXPECT_NEAR(b.x, 0.5f - 15.0f / 200.0f, 1e-5f);
    EXPECT_NEAR(b.y, 0.5f - 4.0f / 200.0f, 1e-5f);
    EXPECT_NEAR(b.z, 0.5f + 45.0f / 200.0f, 1e-5f);
    EXPECT_NEAR(b.w, 0.5f + 36.0f / 200.0f, 1e-5f);
    PlumeQuad beside = quad();
    beside.anchor.x = 500.0f;
    const glm::vec4 out = view_bounds(plume_corners(beside), projection);
    EXPECT_FALSE(out.z > out.x && out.w > out.y);
    PlumeQuad behind = quad();
    behind.anchor.z = 100.0f;
    const glm::vec4 none = view_bounds(plume_corners(behind), projection);
    EXPECT_FALSE(none.z > none.x && none.w > none.y);
    std::array<glm::vec3, 4> through = plume_corners(quad());
    through[0].z = 50.0f;
    EXPECT_EQ(view_bounds(through, projection), glm::vec4(0.0f, 0.0f, 1.0f, 1.0f));
}

TEST(ClipTurn, IsSeededUnlessThePresetSaysHow) {
    SmokeClip clip;
    EXPECT_TRUE(clip_turn(clip, 1).mirrored);
    EXPECT_FALSE(clip_turn(clip, 2).mirrored);
    EXPECT_EQ(clip_turn(clip, 0xffff0000u).angle, 0.0f);
    clip.mirror = ClipMirror::on;
    EXPECT_TRUE(clip_turn(clip, 2).mirrored);
    clip.mirror = ClipMirror::off;
    EXPECT_FALSE(clip_turn(clip, 1).mirrored);
    clip.rotation = 30.0;
    EXPECT_NEAR(clip_turn(clip, 0xffff0000u).angle, glm::radians(30.0f), 1e-6f);
    EXPECT_NEAR(clip_turn(clip, 0u).angle, -glm::radians(30.0f), 1e-6f);
    EXPECT_NEAR(clip_turn(clip, 0x80000000u).angle, 0.0f, 1e-4f);
}

TEST(Plume, AFactorOverTimeIsTakenAsItsMeanOverTheFadeIn) {
    const BurnList burns = burns_of(std::vector{contact()});
    const Burn burn = burns.after(-1e9).front();
    const auto with = [&](const FactorCurve& factor, double time) {
        return plume_state(burn, burns.parts(), parameters(), up, time, factor).density;
    };
    const FactorCurve half(std::vector<CurvePoint>{{0.0, 0.5}}),
        rising(std::vector<CurvePoint>{{2.0, 0.0}, {3.0, 2.0}});
    for (const double time : {1.2, 2.0, 3.0, 4.0}) EXPECT_DOUBLE_EQ(with(half, time), 0.5 * density(time)) << time;
    EXPECT_EQ(with(rising, 2.0), 0.0);
    EXPECT_NEAR(with(rising, 2.8), 1.2 * density(2.8), 1e-12) << "the mean from 2.4 to 2.8 s";
    EXPECT_NEAR(with(rising, 4.5), 1.6 * density(4.5), 1e-12)
        << "what is left of it fades with the strength of its end";
}

}  // namespace
}  // namespace lapfx::smoke
