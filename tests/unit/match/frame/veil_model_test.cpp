#include "match/frame/veil_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "lapfx/error.h"

namespace lapfx::match {
namespace {

/// Statistics that are wrong in ways of their own, of a veil that none of them is, and a map that has too little.
std::vector<VeilExample> examples(int count, int seed) {
    cv::RNG random(static_cast<std::uint64_t>(seed));
    std::vector<VeilExample> all;
    for (int i = 0; i < count; ++i) {
        const double veil = random.uniform(0.0, 0.8);
        VeilExample example{.figures = {}, .veil = veil, .view = i / 4};
        for (std::size_t k = 0; k < veil_statistics; ++k)
            example.figures.statistics[k] = veil * (0.6 + 0.1 * static_cast<double>(k)) + random.gaussian(0.05);
        example.figures.map = 0.9 * veil + random.gaussian(0.02);
        all.push_back(example);
    }
    return all;
}

std::string fault_of(std::string_view json) {
    try {
        VeilModel::read(json, "m.json");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(VeilModel, LearnsWhatTheFiguresTellTogether) {
    const VeilModel model = VeilModel::learn(examples(800, 1), "drawn at random");
    double off = 0.0, alone = 0.0, map = 0.0;
    const auto others = examples(400, 2);
    for (const VeilExample& example : others) {
        off += std::abs(model.veil_of(example.figures) - example.veil) / 400.0;
        alone += std::abs(example.figures.statistics[4] - example.veil) / 400.0;
        map += std::abs(example.figures.map - example.veil) / 400.0;
    }
    EXPECT_LT(off, 0.02);
    EXPECT_GT(alone, 0.035);
    EXPECT_GT(map, 0.035);
    EXPECT_NEAR(model.error().mean_absolute, off, 0.004);  // its own word on views that were left out
    EXPECT_LT(std::abs(model.error().bias), 0.004);
    EXPECT_GT(model.error().correlation, 0.99);
}

TEST(VeilModel, WhereTheTissueIsNotLaidTheStatisticsAreTheMost) {
    const VeilModel model = VeilModel::learn(examples(800, 1), "drawn at random");
    VeilFigures figures{.statistics = {}, .map = 0.5};  // what lies otherwise looks like veil to the map alone
    for (std::size_t k = 0; k < veil_statistics; ++k)
        figures.statistics[k] = 0.3 * (0.6 + 0.1 * static_cast<double>(k));
    const auto told = [&](double map, double likeness) {
        figures.map = map, figures.likeness = likeness;
        return model.veil_of(figures);
    };
    const double with_map = told(0.5, 1.0);
    EXPECT_GT(with_map, 0.4);
    EXPECT_EQ(told(0.5, 0.8), with_map);
    EXPECT_NEAR(told(0.5, 0.5), 0.3, 0.02);
    EXPECT_EQ(told(0.5, 0.0), told(0.5, 0.5));
    EXPECT_NEAR(told(0.5, 0.65), 0.5 * (with_map + told(0.5, 0.5)), 1e-9);
    EXPECT_EQ(told(0.1, 0.0), told(0.1, 1.0)) << "a map that has less is believed";
}

TEST(VeilModel, IsTheSameAfterItsFileWasReadAgain) {
    const VeilModel model = VeilModel::learn(examples(200, 3), "seed 3");
    const VeilModel read = VeilModel::read(model.json(), "m.json");
    for (const VeilExample& example : examples(50, 4))
        EXPECT_DOUBLE_EQ(read.veil_of(example.figures), model.veil_of(example.figures));
    EXPECT_EQ(read.json(), model.json());
    EXPECT_EQ(read.origin(), "seed 3");
}

TEST(VeilModel, GivesAShareWhateverTheFiguresAre) {
    for (const double figure : {-0.6, 0.0, 1.1}) {
        VeilFigures figures{.statistics = {}, .map = std::max(figure, 0.0)};
        figures.statistics.fill(figure);
        EXPECT_GE(VeilModel::shipped().veil_of(figures), 0.0);
        EXPECT_LE(VeilModel::shipped().veil_of(figures), 1.0);
    }
}

/// Without a change there is next to no veil, and where all figures agree on one, it is about that.
TEST(VeilModel, TheShippedOneAgreesWithFiguresThatAgree) {
    VeilFigures none{};
    EXPECT_EQ(VeilModel::shipped().veil_of(none), 0.0);
    double before = 0.0;
    for (const double veil : {0.15, 0.3, 0.45}) {
        VeilFigures figures{.statistics = {}, .map = veil};
        figures.statistics.fill(veil);
        figures.statistics[4] = std::min(1.6 * veil, 0.9);  // saturation falls faster
        const double told = VeilModel::shipped().veil_of(figures);
        EXPECT_NEAR(told, veil, 0.09);
        EXPECT_GT(told, before + 0.05);
        before = told;
    }
}

TEST(VeilModel, SaysFromWhatItWasLearnedAndHowFarItIsOff) {
    const nlohmann::json file = nlohmann::json::parse(VeilModel::shipped().json());
    EXPECT_THAT(file.at("learned_from").get<std::string>(), testing::StartsWith("renders of seed "));
    EXPECT_GE(file.at("pictures").get<int>(), 900);
    EXPECT_LT(VeilModel::shipped().error().mean_absolute, 0.06);
    EXPECT_GT(VeilModel::shipped().error().mean_absolute, 0.0);
}

TEST(VeilModel, RefusesTooFewPictures) {
    EXPECT_THROW(VeilModel::learn(examples(99, 5), ""), Error);
    auto one_view = examples(200, 5);
    for (VeilExample& example : one_view) example.view = 0;
    EXPECT_THROW(VeilModel::learn(one_view, ""), Error);
}

TEST(VeilModel, NamesWhatIsWrongInItsFile) {
    EXPECT_THAT(fault_of("no"), testing::HasSubstr("m.json"));
    nlohmann::json file = nlohmann::json::parse(VeilModel::learn(examples(200, 6), "").json());
    for (const char* key :
         {"with_map", "without_map", "pictures", "views", "learned_from", "error_on_views_left_out"}) {
        nlohmann::json without = file;
        without.erase(key);
        EXPECT_THAT(fault_of(without.dump()), testing::HasSubstr(key));
    }
    for (const char* key : {"pictures", "learned_from", "error_on_views_left_out"}) {
        nlohmann::json other = file;
        other[key] = nlohmann::json::array({1e300});
        EXPECT_THAT(fault_of(other.dump()), testing::HasSubstr(key));
    }
    nlohmann::json far = file;
    far["views"] = 1e300;
    EXPECT_THAT(fault_of(far.dump()), testing::HasSubstr("views"));
    for (const char* ridge : {"with_map", "without_map"}) {
        nlohmann::json other = file;
        other[ridge].erase("weights");
        EXPECT_THAT(fault_of(other.dump()), testing::HasSubstr(std::string(ridge) + "/weights: is no list of"));
        other = file;
        other[ridge]["size"][0] = 0;
        EXPECT_THAT(fault_of(other.dump()), testing::HasSubstr("below the minimum"));
        other[ridge]["size"][0] = "wide";
        EXPECT_THAT(fault_of(other.dump()), testing::HasSubstr(std::string(ridge) + "/size/0: is no number"));
    }
}

}  // namespace
}  // namespace lapfx::match
