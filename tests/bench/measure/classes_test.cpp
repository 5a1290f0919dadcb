#include "bench/measure/classes.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace lapfx::bench {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::UnorderedElementsAre;

const PictureClass& named(std::string_view key) {
    return *std::ranges::find(picture_classes(), key, &PictureClass::key);
}

MeasuredPicture picture(double veil, double blood, bool moves = false) {
    MeasuredPicture p;
    p.moves = moves;
    p.true_blood = blood;
    p.true_veil = veil;
    p.hazeness = 0.1 + 0.5 * veil;
    p.labels = {{"organ", blood > 0.1 ? "liver" : "stomach"}, {"light", "warm"}, {"camera", "near"}};
    p.measured.veil = {.value = veil, .low = veil - 0.01, .high = veil + 0.01};
    p.measured.blood = {.value = blood, .low = blood - 0.01, .high = blood + 0.01};
    return p;
}

std::vector<std::string_view> classes_of(const MeasuredPicture& p) {
    std::vector<std::string_view> keys;
    for (const PictureClass& row : picture_classes())
        if (row.holds(p)) keys.push_back(row.key);
    return keys;
}

TEST(Classes, ArePickedByMotionAndTheVeilBeforeTheBlood) {
    EXPECT_THAT(classes_of(picture(0.05, 0.1)), ElementsAre("veil_still", "veil_alone", "blood_still"));
    EXPECT_THAT(classes_of(picture(0.1, 0.1)), ElementsAre("veil_still", "veil_alone", "blood_veil_15"));
    EXPECT_THAT(classes_of(picture(0.39, 0.1)), ElementsAre("veil_still", "veil_alone", "blood_veil_30"));
    EXPECT_THAT(classes_of(picture(0.41, 0.1)), ElementsAre("veil_still", "veil_alone", "blood_dense"));
    EXPECT_THAT(classes_of(picture(0.05, 0.1, true)), ElementsAre("veil_moving", "blood_moving", "blood_moving_clear"));
    EXPECT_THAT(classes_of(picture(0.0, 0.0, true)), ElementsAre("veil_moving", "veil_moving_none", "blood_moving",
                                                                 "blood_moving_clear", "blood_moving_none"));
    EXPECT_THAT(classes_of(picture(0.5, 0.0, true)), ElementsAre("veil_moving", "blood_dense"));
    MeasuredPicture labelled = picture(0.0, 0.1, true);
    labelled.labelled = true;
    EXPECT_THAT(classes_of(labelled), ElementsAre("blood_labelled")) << "its veil is not known";
    MeasuredPicture by_strokes = labelled;
    for (const auto& [frames, blood, key] : {std::tuple{1, 0.1, "blood_by_strokes"},
                                             {1, 0.0, "blood_by_strokes_none"},
                                             {2, 0.1, "blood_by_strokes_two"}}) {
        by_strokes.by_strokes = frames;
        by_strokes.true_blood = blood;
        EXPECT_THAT(classes_of(by_strokes), ElementsAre(key));
    }
    MeasuredPicture shifted = picture(0.05, 0.1);
    shifted.shifted = true;
    EXPECT_THAT(classes_of(shifted),
                ElementsAre("veil_still", "veil_shifted", "veil_alone", "blood_still", "blood_shifted"));
}

TEST(Classes, HaveTheBoundsOfTheIssue) {
    std::map<std::string_view, std::string> bounds;
    for (const PictureClass& row : picture_classes())
        for (const Bound& bound : row.bounds) bounds[row.key] += text_of(bound) + ";";
    EXPECT_THAT(bounds,
                UnorderedElementsAre(Pair("veil_still", "MAE <= 0.03;bias <= 0.02;r >= 0.98;"),
                                     Pair("veil_moving", "MAE <= 0.055;bias <= 0.02;r >= 0.95;"),
                                     Pair("veil_moving_none", "false area <= 0.015;"), Pair("veil_alone", "r >= 0.9;"),
                                     Pair("blood_still", "MAE <= 0.015;r >= 0.95;Dice >= 0.85;of zero's <= 0.333;"),
                                     Pair("blood_moving", "MAE <= 0.045;r >= 0.6;raw of zero's <= 1;"),
                                     Pair("blood_moving_none", "false area <= 0.025;its 95 % <= 0.08;"),
                                     Pair("blood_veil_15", "MAE <= 0.015;"), Pair("blood_veil_30", "MAE <= 0.025;"),
                                     Pair("blood_dense", "told >= 1;"),
                                     Pair("blood_labelled", "MAE <= 0.022;r >= 0.88;Dice >= 0.55;"),
                                     Pair("blood_by_strokes", "MAE <= 0.02;Dice >= 0.5;intervals >= 0.85;"),
                                     Pair("blood_by_strokes_none", "false area <= 0.005;"),
                                     Pair("blood_by_strokes_two", "MAE <= 0.02;Dice >= 0.5;intervals >= 0.85;")));
}

TEST(Classes, BoundsAreNotKeptByRefusingPictures) {
    std::vector<MeasuredPicture> pictures;
    for (int i = 0; i < 10; ++i) pictures.push_back(picture(0.05 * i, 0.0));
    const PictureClass& veil = named("veil_still");
    EXPECT_TRUE(meets(veil, figures_of(veil, pictures)));
    pictures[0].measured.flags = match::told::not_measurable;
    EXPECT_EQ(figures_of(veil, pictures).at("not_measurable"), 1.0);
    EXPECT_TRUE(meets(veil, figures_of(veil, pictures)));
    pictures[1].measured.flags = match::told::dark;
    EXPECT_FALSE(meets(veil, figures_of(veil, pictures)));
    EXPECT_FALSE(meets(veil, figures_of(veil, {}))) << "a bound is kept by nothing";
}

TEST(Classes, OfWhatIsRefusedTheErrorIsToldToo) {
    std::vector<MeasuredPicture> pictures;
    for (int i = 0; i < 4; ++i) pictures.push_back(picture(0.05, 0.02 * i, true));
    pictures[3].measured.blood.value = 0.16;
    pictures[3].measured.flags = match::told::unregistered;
    const PictureClass& blood = named("blood_moving");
    const Figures figures = figures_of(blood, pictures);
    EXPECT_NEAR(figures.at("mean_absolute_error"), 0.0, 1e-12);
    EXPECT_NEAR(figures.at("raw_mean_absolute_error"), 0.1 / 4, 1e-12);
    EXPECT_NEAR(figures.at("zero_error"), 0.06 / 3, 1e-12);
    EXPECT_NEAR(figures.at("raw_zero_error"), 0.12 / 4, 1e-12);
    EXPECT_NEAR(figures.at("raw_error_over_zero"), 0.1 / 0.12, 1e-12);
    EXPECT_TRUE(meets(blood, figures)) << "a quarter of the pictures that move may be refused";
    pictures[2].measured.flags = match::told::unregistered;
    EXPECT_FALSE(meets(blood, figures_of(blood, pictures)));
}

TEST(Classes, LabelledPicturesHaveARowWhereThereAreAny) {
    const auto rows = [](std::span<const MeasuredPicture> pictures) {
        BenchReport report;
        add_classes(report, pictures, true);
        return std::ranges::count(report.rows, "blood_labelled",
                                  [](const BenchRow& row) { return row.of.at("class"); });
    };
    MeasuredPicture labelled = picture(0.0, 0.1, true);
    labelled.labels["operation"] = "here/0";
    EXPECT_EQ(rows(std::vector{labelled}), 0);
    labelled.labelled = true;
    EXPECT_EQ(rows(std::vector{labelled}), 1);
}

TEST(Classes, IntervalsOfBloodByStrokesAreOfTheirOwnRowAlone) {
    MeasuredPicture labelled = picture(0.0, 0.1, true);
    labelled.labels["operation"] = "here/0";
    labelled.labelled = true;
    MeasuredPicture by_strokes = labelled;
    by_strokes.by_strokes = 1;
    by_strokes.measured.blood = {.value = 0.3, .low = 0.2, .high = 0.4};
    BenchReport report;
    add_classes(report, std::vector{labelled, by_strokes}, true);
    const auto coverage = [&report](const char* of, const char* figure) {
        return std::ranges::find(report.rows, std::string(of), [](const BenchRow& row) { return row.of.at("class"); })
            ->measured.at(figure);
    };
    EXPECT_EQ(coverage("blood_intervals_as_shipped", "coverage"), 1.0);
    EXPECT_EQ(coverage("blood_by_strokes", "interval_coverage"), 0.0);
    EXPECT_NEAR(coverage("blood_by_strokes", "mean_absolute_error"), 0.2, 1e-12);
}

TEST(Classes, BloodBehindADenseVeilHasToBeToldOfEachPicture) {
    std::vector<MeasuredPicture> pictures{picture(0.5, 0.1), picture(0.6, 0.2), picture(0.2, 0.2)};
    const PictureClass& dense = named("blood_dense");
    pictures[0].measured.flags = match::told::dense;
    EXPECT_THAT(figures_of(dense, pictures),
                UnorderedElementsAre(Pair("count", 2.0), Pair("not_measurable", 1.0), Pair("told", 0.5)));
    EXPECT_FALSE(meets(dense, figures_of(dense, pictures)));
    pictures[1].measured.flags = match::told::not_measurable;
    EXPECT_TRUE(meets(dense, figures_of(dense, pictures)));
}

TEST(Classes, OfAnOrderTheLevelDoesNotCount) {
    const std::vector<MeasuredPicture> pictures{picture(0.1, 0), picture(0.2, 0), picture(0.7, 0)};
    const PictureClass& alone = named("veil_alone");
    EXPECT_THAT(figures_of(alone, pictures), UnorderedElementsAre(Pair("count", 3.0), Pair("not_measurable", 0.0),
                                                                  Pair("correlation", testing::DoubleNear(1.0, 1e-9))));
    EXPECT_TRUE(meets(alone, figures_of(alone, pictures)));
}

TEST(Classes, EachHasARowAlsoWithoutPictures) {
    BenchReport report;
    add_classes(report, {}, true);
    std::size_t with_verdict = 0;
    for (const BenchRow& row : report.rows) {
        EXPECT_EQ(row.of.at("pictures"), "real");
        if (!row.measured.contains("met")) continue;
        ++with_verdict;
        EXPECT_EQ(row.measured.at("met"), 0.0) << row.of.at("class");
    }
    EXPECT_EQ(with_verdict, 10U + 4U);  // and the intervals of both amounts, as shipped and scaled
}

TEST(Classes, IntervalsAreTriedOnTheOrganThatWasLeftOut) {
    std::vector<MeasuredPicture> pictures;
    for (int i = 0; i < 10; ++i) {
        pictures.push_back(picture(0.05, 0.02 * i));
        pictures.back().measured.veil.value += i == 0 ? 0.005 : 0.001;
    }
    BenchReport report;
    add_classes(report, pictures, false);
    const auto row = std::ranges::find(report.rows, std::string("veil_intervals_organ"),
                                       [](const BenchRow& made) { return made.of.at("class"); });
    ASSERT_NE(row, report.rows.end());
    EXPECT_THAT(row->measured, testing::IsSupersetOf({Pair("count", 10.0), Pair("bound_least_coverage", 0.85)}));
    EXPECT_THAT(report.table, HasSubstr("without liver"));
}

TEST(Classes, IntervalsThatAreTooWideAreTold) {
    std::vector<MeasuredPicture> pictures;
    const auto coverage = [&pictures] {
        BenchReport report;
        add_classes(report, pictures, false);
        return std::ranges::find(report.rows, std::string("veil_intervals_as_shipped"),
                                 [](const BenchRow& made) { return made.of.at("class"); })
            ->measured;
    };
    for (int i = 0; i < 10; ++i) pictures.push_back(picture(0.05, 0.02 * i));
    EXPECT_THAT(coverage(), testing::IsSupersetOf({Pair("coverage", 1.0), Pair("met", 0.0)}));
    pictures[0].true_veil = 0.07;
    EXPECT_THAT(coverage(), testing::IsSupersetOf({Pair("coverage", 0.9), Pair("met", 1.0)}));
}

}  // namespace
}  // namespace lapfx::bench
