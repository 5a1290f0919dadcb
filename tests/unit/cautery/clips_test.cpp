#include "cautery/clips.h"

#include <gtest/gtest.h>

#include <random>

#include "bleeding/wound.h"
#include "lapfx/amounts.h"
#include "unit/cautery/support.h"

namespace lapfx::cautery {
namespace {

ToolContact clip_at(glm::dvec3 place, double time, double duration = 0.3) {
    return at(place, time, duration, ToolAction::clip);
}

class ClipsTest : public testing::Test {
  protected:
    const Wound& wound_at(const Cautery& of, double x) {
        const auto wounds = of.wounds();
        const auto found = std::find_if(wounds.begin(), wounds.end(),
                                        [&](const Wound& w) { return std::abs(w.position.x - x) < 0.01; });
        EXPECT_NE(found, wounds.end()) << x;
        return *found;
    }
    void expect_like_fresh(const std::vector<ToolContact>& contacts) {
        LoggedCautery fresh(flat(), {});
        fresh.set(contacts, parameters);
        ASSERT_EQ(cautery.clips().size(), fresh.clips().size());
        for (std::size_t i = 0; i < fresh.clips().size(); ++i) {
            EXPECT_EQ(cautery.clips()[i].time, fresh.clips()[i].time);
            EXPECT_EQ(cautery.clips()[i].ends[0].position, fresh.clips()[i].ends[0].position);
            EXPECT_EQ(cautery.clips()[i].ends[1].position, fresh.clips()[i].ends[1].position);
        }
        ASSERT_TRUE(
            std::equal(cautery.wounds().begin(), cautery.wounds().end(), fresh.wounds().begin(), fresh.wounds().end()));
    }

    CauteryParameters parameters = simple_parameters();
    LoggedCautery cautery{flat(), {}};
};

TEST_F(ClipsTest, WoundsUnderItStopAtOnceAndOthersBleedOn) {
    // Along x, the clip's own direction: 9 mm long, 3 mm to each side.
    cautery.set(std::vector{at({-20, 0, 0}, 0.0, 0.1, ToolAction::cut), at({7, 0, 0}, 0.2, 0.1, ToolAction::cut),
                            at({0, 0, 2.9}, 0.4, 0.1, ToolAction::cut), at({1, 0, 3.2}, 0.5, 0.1, ToolAction::cut),
                            clip_at({0, 0, 0}, 2.0)},
                parameters);
    ASSERT_EQ(cautery.wounds().size(), 4U);
    EXPECT_EQ(wound_at(cautery, 7).sealed, 2.0);  // 2.5 mm beyond the clip's end
    EXPECT_EQ(wound_at(cautery, 0).sealed, 2.0);
    EXPECT_EQ(wound_at(cautery, 0).stop, 2.0);
    EXPECT_EQ(wound_at(cautery, -20).stop, never);
    EXPECT_EQ(wound_at(cautery, 1).sealed, never) << "3.2 mm beside it";
    const BleedingParameters bleeding;
    const Wound& held = wound_at(cautery, 0);
    EXPECT_GT(bleeding::flow(held, bleeding, 2.0), 0.0);
    EXPECT_EQ(bleeding::flow(held, bleeding, 2.0 + bleeding.coagulation_time), bleeding::flow(held, bleeding, 2.0));
    EXPECT_EQ(bleeding::state_of(held, bleeding, 1.99), WoundState::bleeding);
    EXPECT_EQ(bleeding::state_of(held, bleeding, 2.0), WoundState::closed);
    EXPECT_TRUE(bleeding::bleeds(held, bleeding, 1.99));
    EXPECT_FALSE(bleeding::bleeds(held, bleeding, 2.0));
}

TEST_F(ClipsTest, WhatIsCutUnderAClipDoesNotBleed) {
    cautery.set(std::vector{clip_at({0, 0, 0}, 1.0), at({1, 0, 1}, 3.0, 0.1, ToolAction::cut),
                            at({20, 0, 0}, 4.0, 0.1, ToolAction::cut)},
                parameters);
    const BleedingParameters bleeding;
    EXPECT_EQ(bleeding::flow(wound_at(cautery, 1), bleeding, 9.0), 0.0);
    EXPECT_EQ(bleeding::state_of(wound_at(cautery, 1), bleeding, 9.0), WoundState::closed);
    EXPECT_GT(bleeding::flow(wound_at(cautery, 20), bleeding, 9.0), 0.0);
}

// A wound that a clip holds is closed: it stands for no cut beside the clip.
TEST_F(ClipsTest, WhatIsCutBesideAHeldWoundBleeds) {
    const ToolContact held = at({0, 0, 2.8}, 0.5, 0.1, ToolAction::cut), clip = clip_at({0, 0, 0}, 2.0),
                      beside = at({0, 0, 3.4}, 4.0, 0.1, ToolAction::cut);
    const BleedingParameters bleeding;
    for (const HeatModel model : {HeatModel::radial, HeatModel::bioheat}) {
        parameters.model = model;
        const auto bleeding_at = [&](const std::vector<ToolContact>& contacts, double time) {
            cautery.set(contacts, parameters);
            cautery.update(time);
            return std::ranges::count_if(cautery.wounds(), [&](const Wound& w) {
                return w.start <= time && bleeding::bleeds(w, bleeding, time);
            });
        };
        EXPECT_EQ(bleeding_at({held, clip, beside}, 7.9), 1);
        bleeding_at({held, beside}, 7.9);
        EXPECT_EQ(cautery.wounds().size(), 1U) << "an open wound stands for it";
        ToolContact before = beside;
        before.time = 1.0;
        EXPECT_EQ(bleeding_at({held, before, clip}, 7.9), 0) << "when the second was cut, the first was open";
        // The clip is added after the cut: two tools at the same time are written to the log in any order.
        bleeding_at({held, beside}, 7.9);
        EXPECT_EQ(bleeding_at({held, clip, beside}, 7.9), 1);
        EXPECT_EQ(cautery.wounds().size(), 2U);
    }
    Preset preset;
    preset.smoke.clips.clear();
    AmountsModel both(test::plane(80.0, 80)), one(test::plane(80.0, 80));
    both.set(preset, std::vector{held, clip, beside});
    one.set(preset, std::vector{clip, beside});
    EXPECT_GE(both.at(7.9).blood_area, one.at(7.9).blood_area);
    EXPECT_EQ(both.at(7.9).bleeding_wounds, 1);
}

TEST_F(ClipsTest, ItPointsWhereItsStrokeGoes) {
    const auto direction = [&](const ToolContact& contact) {
        cautery.set(std::vector{contact}, parameters);
        EXPECT_EQ(cautery.clips().size(), 1U);
        return pose_of(cautery.clips().front(), flat().mesh());
    };
    const ClipPose lying = direction(clip_at({5, 0.4, 5}, 1.0));
    EXPECT_NEAR(std::abs(lying.along.x), 1.0f, 1e-5f) << "nothing says where to";
    EXPECT_NEAR(lying.up.y, 1.0f, 1e-5f);
    EXPECT_NEAR(glm::distance(lying.position, {5, 0, 5}), 0.0f, 1e-5f) << "on the surface";
    const ClipPose short_one = direction(along({5, 0, 5}, {5, 0, 7.9}, 1.0, 0.5, ToolAction::clip));
    EXPECT_NEAR(std::abs(short_one.along.x), 1.0f, 1e-5f);
    const ClipPose aimed = direction(along({5, 0, 5}, {5, 0, 12}, 1.0, 0.5, ToolAction::clip));
    EXPECT_NEAR(aimed.along.z, 1.0f, 1e-5f);
    EXPECT_NEAR(glm::distance(aimed.position, {5, 0, 5}), 0.0f, 1e-5f) << "it stays where the stroke began";
    parameters.clip_length = 14.0;
    cautery.set(std::vector{clip_at({0, 0, 0}, 1.0)}, parameters);
    const Clip& long_one = cautery.clips().front();
    EXPECT_NEAR(glm::distance(long_one.ends[0].position, long_one.ends[1].position), 14.0, 1e-9);
    cautery.set(std::vector{clip_at({0, 5.1, 0}, 1.0)}, parameters);
    EXPECT_EQ(cautery.clips().size(), 0U) << "it touches nothing";
}

// Samples come a few at a time, strokes of several tools run at once, and undo removes them again.
TEST_F(ClipsTest, AnyOrderOfCallsGivesTheSame) {
    std::vector<ToolContact> all{along({-20, 0, 0}, {20, 0, 0}, 0.0, 1.0, ToolAction::cut)};
    for (const ToolContact& piece : in_pieces(along({-9, 0, 1}, {-9, 0, 9}, 1.5, 1.0, ToolAction::clip), 7))
        all.push_back(piece);
    all.push_back(clip_at({6, 0, -1}, 1.7));
    all.push_back(clip_at({12, 0, 0}, 4.0));
    all.push_back(at({-9, 0, 0}, 5.0, 2.0, ToolAction::cauterise));
    all.push_back(at({6, 0, 1.9}, 1.2, 0.1, ToolAction::cut));  // held, and then one beside the clip
    all.push_back(at({6, 0, 2.5}, 4.5, 0.1, ToolAction::cut));
    all.push_back(at({6, 0, 2.3}, 1.3, 4.0, ToolAction::cauterise));  // divides while the clip is set
    std::mt19937 random(7);
    for (int round = 0; round < 40; ++round) {
        const std::vector<ToolContact> some(all.begin(), all.begin() + 1 + static_cast<long>(random() % all.size()));
        cautery.set(some, parameters);
        cautery.update(static_cast<double>(random() % 80) / 10);
        expect_like_fresh(some);
        if (HasFailure()) return;
    }
    parameters.clip_reach = 1.0;
    cautery.set(all, parameters);
    expect_like_fresh(all);
    parameters.model = HeatModel::bioheat;
    cautery.set(all, parameters);
    cautery.update(6.0);
    EXPECT_EQ(cautery.clips().size(), 3U);
    const auto wounds = cautery.wounds();
    EXPECT_GE(std::count_if(wounds.begin(), wounds.end(), [](const Wound& w) { return w.sealed == 4.0; }), 1);
}

TEST_F(ClipsTest, AnEmptySurfaceHasNoClips) {
    const Surface empty{Organ{}};
    LoggedCautery none(empty, {});
    none.set(std::vector{clip_at({0, 0, 0}, 1.0)}, parameters);
    EXPECT_EQ(none.clips().size(), 0U);
}

// The same, as a score sees it: the core's own amounts.
TEST_F(ClipsTest, AmountsStandFromTheClipOn) {
    Preset preset;
    preset.smoke.clips.clear();
    const std::vector<ToolContact> cut{at({0, 0, 0}, 0.5, 0.1, ToolAction::cut)};
    std::vector<ToolContact> clipped = cut;
    clipped.push_back(clip_at({0, 0, 0}, 2.0));
    AmountsModel with(test::plane(80.0, 80)), without(test::plane(80.0, 80));
    with.set(preset, clipped);
    without.set(preset, cut);
    EXPECT_EQ(with.at(1.9).blood_area, without.at(1.9).blood_area);
    EXPECT_EQ(with.at(1.9).bleeding_wounds, 1);
    const double then = with.at(2.0).blood_area;
    EXPECT_GT(then, 0.0);
    EXPECT_EQ(with.at(2.0).bleeding_wounds, 0);
    EXPECT_LE(with.at(5.0).blood_area, then) << "clots draw together";
    EXPECT_GT(without.at(5.0).blood_area, 1.5 * then);
    EXPECT_EQ(with.at(1.9).bleeding_wounds, 1) << "and back";
}

}  // namespace
}  // namespace lapfx::cautery
