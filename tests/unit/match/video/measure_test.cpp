// Whole videos, as numbered pictures that are painted here.
#include "match/video/measure.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "unit/match/clips.h"

namespace lapfx::match {
namespace {

class MeasureTest : public ::testing::Test {
  protected:
    test::Clip clip;
    const lapfx::test::Folder& folder = clip.folder;

    void add(const cv::Mat& linear) { clip.add(linear); }
    std::filesystem::path video() const { return clip.video(); }
    /// Smoke rises from 0 to 0.5 and blood spreads.
    void add_operation(int frames) {
        const cv::Mat clear = test::tissue();
        for (int i = 0; i < frames; ++i) {
            cv::Mat frame = clear.clone();
            const double share = std::clamp((i - 4) / (frames - 8.0), 0.0, 1.0);
            test::bleed(frame, {150, 130}, static_cast<int>(40 * share));
            add(test::veiled(frame, cv::Mat(clear.size(), CV_32F, cv::Scalar(0.5 * share)), test::light_of({})));
        }
    }
    static std::vector<std::string> faults(const std::filesystem::path& path, const MeasureOptions& options) {
        return lapfx::test::faults_of([&] {
            VideoReader reader(path);
            measure(reader, options);
        });
    }
};

TEST_F(MeasureTest, FindsTheClearFrameAndBothEpisodes) {
    add_operation(30);
    VideoReader reader(video());
    const Measurement found = measure(reader, {});
    const double frame = 1.0 / reader.info().frames_per_second;
    EXPECT_TRUE(found.suggested);
    EXPECT_LT(found.baseline, 6 * frame);
    ASSERT_EQ(found.frames.size(), 30U);
    EXPECT_NEAR(found.frames.back().veil.value, 0.5, 0.06);
    EXPECT_NEAR(found.frames.back().blood.value, 3.14159 * 1600 / (test::width * test::height), 0.015);
    EXPECT_NEAR(found.frames.front().veil.value, 0.0, 0.02);
    ASSERT_TRUE(found.veil.onset);
    EXPECT_NEAR(*found.veil.onset, 6 * frame, 3 * frame);
    EXPECT_NEAR(*found.veil.rise, 17.6 * frame, 3 * frame);
    EXPECT_FALSE(found.veil.decay);
    EXPECT_EQ(found.frames.back().flags, told::dense);
    EXPECT_EQ(found.frames.front().flags, 0U);
    EXPECT_TRUE(found.blood.peak);
}

TEST_F(MeasureTest, GivesNoEpisodeOfBloodThatDenseSmokeHidesMostly) {
    const cv::Mat clear = test::tissue();
    for (int i = 0; i < 10; ++i)
        add(test::veiled(clear, cv::Mat(clear.size(), CV_32F, cv::Scalar(i < 3 ? 0.0 : 0.55)), test::light_of({})));
    VideoReader reader(video());
    const Measurement found = measure(reader, {.baseline = 0.0});
    EXPECT_FALSE(found.blood.peak);
    EXPECT_EQ(without_episode(found, Curve::blood), "measurable in 3 of 10 frames, too few for a peak");
    EXPECT_TRUE(found.veil.peak_at);
    EXPECT_EQ(found.notes, std::vector<std::string>{"7 of 10 frames: blood is not measurable, because the veil before "
                                                    "it is denser than 40 %"});
}

TEST_F(MeasureTest, MeasuresPartOfAVideoAtTheStepAsked) {
    add_operation(22);
    VideoReader reader(video());
    const double frame = 1.0 / reader.info().frames_per_second;
    const Measurement found = measure(reader, {.baseline = 0.0, .from = 10 * frame, .to = 20 * frame, .every = 2});
    EXPECT_FALSE(found.suggested);
    ASSERT_EQ(found.frames.size(), 6U);
    EXPECT_NEAR(found.frames[1].time, 12 * frame, 1e-6);
}

TEST_F(MeasureTest, GivesEachFrameAsItIsWithItsLayers) {
    add_operation(12);
    VideoReader reader(video()), beside(video());
    std::vector<double> times, veils;
    const std::uint8_t* memory = nullptr;
    const auto look = [&](const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
        Image own;
        ASSERT_TRUE(beside.read(beside.frame_at(amounts.time), own));
        EXPECT_EQ(frame.pixels, own.pixels) << amounts.time;
        if (memory == nullptr) memory = frame.pixels.data();
        EXPECT_EQ(frame.pixels.data(), memory) << "none is copied";
        times.push_back(amounts.time);
        veils.push_back(cv::mean(estimator->veil(), estimator->valid())[0]);
    };
    const Measurement found = measure(reader, {.baseline = 0.0, .measured = look});
    ASSERT_EQ(times.size(), found.frames.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
        EXPECT_EQ(times[i], found.frames[i].time);
        EXPECT_EQ(veils[i], found.frames[i].veil.value);
    }
}

TEST_F(MeasureTest, AFrameThatTheFileCannotGiveHasNoAmounts) {
    add_operation(30);
    VideoReader whole(video());
    const Measurement all = measure(whole, {.baseline = 0.0});
    for (const char* name : {"f_0014.png", "f_0015.png", "f_0029.png"}) folder.write(name, "broken");
    VideoReader reader(video());
    int drawn = 0;
    const Measurement found =
        measure(reader, {.baseline = 0.0, .measured = [&](const Image&, const Estimator*, const FrameAmounts& amounts) {
                             drawn += amounts.flags == told::missing ? 1 : 0;
                         }});
    EXPECT_EQ(drawn, 3);
    ASSERT_EQ(found.frames.size(), 30U);
    for (std::size_t i = 0; i < 30; ++i) {
        const FrameAmounts& f = found.frames[i];
        EXPECT_EQ(f.time, all.frames[i].time);
        const bool missing = i == 14 || i == 15 || i == 29;
        EXPECT_EQ(f.flags == told::missing, missing) << i;
        EXPECT_NEAR(f.veil.value, missing ? 0.0 : all.frames[i].veil.value, 0.01) << i;
        EXPECT_NEAR(f.veil.high, missing ? 0.0 : all.frames[i].veil.high, 0.015) << "a gap widens no other: " << i;
    }
    EXPECT_EQ(found.notes.front(), "3 of 30 frames: not measurable, because the file cannot give them");
    const std::string csv = csv_of(found);
    EXPECT_NE(csv.find("\n0.5600,,,,,,,missing,,,,,,\n0.6000,,,,,,,missing,,,,,,\n0.6400,0."), std::string::npos)
        << csv;
    EXPECT_FALSE(read_amounts(csv, "a.csv")[14].measurable());
    const nlohmann::json json = nlohmann::json::parse(json_of(found))["frames"][14];
    for (const char* key : {"blood", "veil", "valid", "likeness"}) EXPECT_TRUE(json[key].is_null()) << key;
}

TEST_F(MeasureTest, TellsThatNothingHappens) {
    for (int i = 0; i < 12; ++i) add(test::tissue());
    VideoReader reader(video());
    const Measurement found = measure(reader, {});
    EXPECT_FALSE(found.blood.peak_at);
    EXPECT_FALSE(found.veil.peak_at);
    EXPECT_EQ(found.notes, (std::vector<std::string>{"Blood: as its intervals go, it may not change at all.",
                                                     "Veil: as its intervals go, it may not change at all."}));
}

TEST_F(MeasureTest, TellsThatMostIsNotMeasurable) {
    for (int i = 0; i < 4; ++i) add(test::tissue());
    clip.add(test::bag(), 12);
    VideoReader reader(video());
    const Measurement found = measure(reader, {.baseline = 0.0, .every = 2});
    ASSERT_FALSE(found.notes.empty());
    EXPECT_EQ(
        found.notes.front(),
        "Most of this video is not measurable with the baseline at 0.00 s: no peak, mean, onset or decay is given. "
        "Choose a baseline or a part of one view.");
    for (const Episode* episode : {&found.blood, &found.veil})
        for (const auto& figure : {episode->peak, episode->mean, episode->area, episode->onset, episode->decay})
            EXPECT_FALSE(figure);
    EXPECT_NE(json_of(found).find("\"peak\": null"), std::string::npos);
}

TEST_F(MeasureTest, RefusesAVideoInWhichNothingIsMeasurable) {
    for (int i = 0; i < 2; ++i) add(test::tissue());
    for (int i = 0; i < 6; ++i) add(cv::Mat(test::height, test::width, CV_32FC3, cv::Scalar::all(0.5)));
    EXPECT_EQ(faults(video(), {.baseline = 0.0, .from = 0.08}),
              std::vector<std::string>{"has no frame that is measurable with the baseline at 0.00 s: none shows its "
                                       "tissue; choose a baseline or a part of one view"});
}

TEST_F(MeasureTest, TellsASmokyBaseline) {
    add_operation(30);
    VideoReader reader(video());
    const Measurement found = measure(reader, {.baseline = reader.time_of(29), .every = 5});
    ASSERT_FALSE(found.notes.empty());
    EXPECT_NE(found.notes.front().find("may be hazy itself"), std::string::npos) << found.notes.front();
}

TEST_F(MeasureTest, TakesNoPaleTissueForAHazyBaseline) {
    // As haze, but red to the last: what is as bright as this behind haze is not as red.
    cv::Mat pale;
    cv::transform(test::tissue(), pale, cv::Matx34f(0.8F, 0, 0, 0.03F, 0, 0.8F, 0, 0.03F, 0, 0, 1.2F, 0.16F));
    for (int i = 0; i < 12; ++i) add(pale);
    ASSERT_GT(hazeness_of(test::image_of(pale)), 0.2);
    VideoReader reader(video());
    for (const std::string& note : measure(reader, {}).notes) EXPECT_EQ(note.find("hazy"), std::string::npos) << note;
}

TEST_F(MeasureTest, RefusesWhatIsOutsideTheVideoOrShowsNothing) {
    add_operation(10);
    EXPECT_EQ(faults(video(), {.baseline = 99.0}),
              std::vector<std::string>{"baseline: 99.00 s is outside the video (allowed: 0 to 0.40 s)"});
    EXPECT_EQ(faults(video(), {.from = 0.3, .to = 0.1}), std::vector<std::string>{"to: 0.10 s is before from, 0.30 s"});
    EXPECT_EQ(faults(folder / "f_0001.png", {}),
              std::vector<std::string>{"has one frame; measuring compares frames with a clear one of the same view"});
}

TEST_F(MeasureTest, RefusesABlackVideo) {
    for (int i = 0; i < 3; ++i) add(cv::Mat(test::height, test::width, CV_32FC3, cv::Scalar::all(0)));
    EXPECT_EQ(faults(video(), {}),
              std::vector<std::string>{"has no frame that shows anything: all are black or missing"});
}

TEST_F(MeasureTest, StopsWhenItIsTold) {
    add_operation(10);
    VideoReader reader(video());
    EXPECT_EQ(lapfx::test::faults_of([&] { measure(reader, {}, [](double share) { return share < 0.5; }); },
                                     Failure::runtime),
              std::vector<std::string>{"measuring was stopped"});
}

TEST_F(MeasureTest, ItsPlotHasBothCurves) {
    add_operation(12);
    VideoReader reader(video());
    const Measurement found = measure(reader, {});
    const Image plot = plot_of(found);
    EXPECT_EQ(plot.width, 1280);
    EXPECT_EQ(plot.height, 720);
    int red = 0, blue = 0;
    for (std::size_t i = 0; i < plot.pixels.size(); i += 4) {
        red += plot.pixels[i] == 190 && plot.pixels[i + 1] == 40 ? 1 : 0;
        blue += plot.pixels[i] == 60 && plot.pixels[i + 2] == 150 ? 1 : 0;
    }
    EXPECT_GT(red, 500);
    EXPECT_GT(blue, 500);
}

TEST(AmountsFile, CsvHasEmptyCellsWhereNothingIsMeasurable) {
    Measurement m;
    m.frames.resize(3);
    m.frames[0].blood = {0.1, 0.05, 0.2};
    m.frames[0].veil = {0.3, 0.2, 0.4};
    m.frames[0].light = {0.04, 0.03, 0.05};
    m.frames[0].gain = {0.75, 0.7, 1.0};
    m.frames[0].valid = 0.7;
    m.frames[1].time = 0.04;
    m.frames[1].veil = {0.9, 0.8, 1.0};
    m.frames[1].flags = told::cut | told::not_measurable;
    m.frames[2].time = 0.08;
    m.frames[2].flags = told::motion;
    EXPECT_EQ(
        csv_of(m),
        "time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags,"
        "light,light_low,light_high,gain,gain_low,gain_high\n"
        "0.0000,0.10000,0.05000,0.20000,0.30000,0.20000,0.40000,,0.04000,0.03000,0.05000,0.75000,0.70000,1.00000\n"
        "0.0400,,,,,,,cut not_measurable,,,,,,\n"
        "0.0800,0.00000,0.00000,0.00000,0.00000,0.00000,0.00000,motion,0.00000,0.00000,0.00000,"
        "1.00000,1.00000,1.00000\n");
}

TEST(AmountsFile, BehindADenseVeilOnlyTheBloodIsEmpty) {
    Measurement m;
    m.frames.resize(1);
    m.frames[0].blood = {0.1, 0.05, 0.2};
    m.frames[0].veil = {0.5, 0.4, 0.6};
    m.frames[0].flags = told::dense;
    const std::string csv = csv_of(m);
    EXPECT_EQ(csv.substr(csv.find('\n') + 1),
              "0.0000,,,,0.50000,0.40000,0.60000,dense,0.00000,0.00000,0.00000,1.00000,1.00000,1.00000\n");
    const std::vector<FrameAmounts> read = read_amounts(csv, "a.csv");
    EXPECT_FALSE(read.at(0).blood_measurable());
    EXPECT_DOUBLE_EQ(read[0].veil.high, 0.6);
    const nlohmann::json json = nlohmann::json::parse(json_of(m));
    EXPECT_TRUE(json["frames"][0]["blood"].is_null());
    EXPECT_EQ(json["frames"][0]["veil"]["value"], 0.5);
}

TEST(AmountsFile, CsvIsReadAsItWasWritten) {
    Measurement m;
    m.frames.resize(2);
    m.frames[0].blood = {0.1, 0.05, 0.2};
    m.frames[0].veil = {0.3, 0.2, 0.4};
    m.frames[0].light = {0.04, 0.03, 0.05};
    m.frames[0].gain = {1.25, 1.2, 1.5};
    m.frames[1].time = 0.04;
    m.frames[1].flags = told::cut | told::not_measurable;
    const std::vector<FrameAmounts> read = read_amounts(csv_of(m), "a.csv");
    ASSERT_EQ(read.size(), 2U);
    EXPECT_DOUBLE_EQ(read[0].blood.high, 0.2);
    EXPECT_DOUBLE_EQ(read[0].veil.low, 0.2);
    EXPECT_DOUBLE_EQ(read[1].time, 0.04);
    EXPECT_EQ(read[1].flags, told::cut | told::not_measurable);
    EXPECT_EQ(read[1].veil.high, 0.0);
    EXPECT_DOUBLE_EQ(read[0].light.low, 0.03);
    EXPECT_DOUBLE_EQ(read[0].gain.value, 1.25);
    EXPECT_DOUBLE_EQ(read[0].gain.high, 1.5);
    EXPECT_EQ(read[1].gain.value, 1.0);
}

TEST(AmountsFile, IsReadWithoutLightAndGain) {
    const std::vector<FrameAmounts> read = read_amounts(
        "time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags\n"
        "0.5,0.1,0,0.2,0.3,0.2,0.4,motion\n",
        "a.csv");
    ASSERT_EQ(read.size(), 1U);
    EXPECT_DOUBLE_EQ(read[0].veil.high, 0.4);
    EXPECT_EQ(read[0].flags, told::motion);
    EXPECT_EQ(read[0].light.high, 0.0);
    EXPECT_EQ(read[0].gain.value, 1.0);
}

TEST(AmountsFile, JsonHasTheSameWords) {
    Measurement m;
    m.frames.resize(2);
    m.frames[0].veil = {0.25, 0.125, 0.5};
    m.frames[0].plume = Amount{0.0625, 0.03125, 0.125};
    m.frames[0].light = {0.125, 0.0625, 0.25};
    m.frames[0].gain = {0.75, 0.5, 1.0};
    m.frames[0].likeness = 0.75;
    m.frames[1].flags = told::cut | told::not_measurable;
    const nlohmann::json read = nlohmann::json::parse(json_of(m));
    EXPECT_EQ(read["frames"][0]["veil"], (nlohmann::json{{"value", 0.25}, {"low", 0.125}, {"high", 0.5}}));
    EXPECT_EQ(read["frames"][0]["plume"], (nlohmann::json{{"value", 0.0625}, {"low", 0.03125}, {"high", 0.125}}));
    EXPECT_TRUE(read["frames"][1]["plume"].is_null());
    EXPECT_EQ(read["frames"][0]["light"], (nlohmann::json{{"value", 0.125}, {"low", 0.0625}, {"high", 0.25}}));
    EXPECT_EQ(read["frames"][0]["gain"], (nlohmann::json{{"value", 0.75}, {"low", 0.5}, {"high", 1.0}}));
    EXPECT_EQ(read["frames"][0]["likeness"], 0.75);
    EXPECT_EQ(read["frames"][0]["flags"], "");
    EXPECT_TRUE(read["frames"][1]["blood"].is_null());
    EXPECT_TRUE(read["frames"][1]["veil"].is_null());
    EXPECT_TRUE(read["frames"][1]["light"].is_null());
    EXPECT_TRUE(read["frames"][1]["gain"].is_null());
    EXPECT_EQ(read["frames"][1]["flags"], "cut not_measurable");
    EXPECT_TRUE(read["veil"]["peak"].is_null());
}

TEST(AmountsFile, FaultsNameLineValueAndWhatIsAllowed) {
    const std::string head = "time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags\n";
    const auto fault = [](const std::string& csv) {
        const auto lines = lapfx::test::faults_of([&] { read_amounts(csv, "a.csv"); });
        return lines.size() == 1 ? lines[0] : "";
    };
    EXPECT_EQ(fault("time,blood\n0,1\n"),
              "a.csv: line 1: the columns are \"time,blood\" instead of " + head.substr(0, head.size() - 1));
    EXPECT_EQ(fault(head + "0,0.1,0,0.2\n"),
              "a.csv: line 2: has 4 values instead of 8 (" + head.substr(0, head.size() - 1) + ")");
    EXPECT_EQ(fault(head + "0,x,0,0,0,0,0,\n"), "a.csv: line 2: blood: \"x\" is not a number");
    EXPECT_EQ(fault(head + "0,nan,0,0,0,0,0,\n"), "a.csv: line 2: blood: \"nan\" is not a number");
    EXPECT_EQ(fault(head + "0,1.5,0,0,0,0,0,\n"), "a.csv: line 2: blood: 1.5 is outside the allowed 0 to 1");
    EXPECT_EQ(fault(head + "0,0.5,0.6,0.7,0,0,0,\n"), "a.csv: line 2: blood: its interval does not hold it");
    EXPECT_EQ(fault(head + "0,0,0,0,,,,tinted\n"), "a.csv: line 2: veil: is empty, and no flag says why");
    EXPECT_EQ(fault(head + "0,0,,0,0,0,0,dark\n"), "a.csv: line 2: blood_low: \"\" is not a number");
    EXPECT_NE(fault(head + "0,0,0,0,0,0,0,foggy\n").find("flags: \"foggy\" is not known (allowed: cut, motion, "),
              std::string::npos);
    EXPECT_EQ(fault(head + "1,0,0,0,0,0,0,\n1,0,0,0,0,0,0,\n"),
              "a.csv: line 3: time: 1.00 s is not after that of the line before");
    EXPECT_EQ(fault(head), "a.csv: line 2: has no amounts");
    const std::string whole = head.substr(0, head.size() - 1) + ",light,light_low,light_high,gain,gain_low,gain_high\n";
    EXPECT_EQ(fault(whole + "0,0,0,0,0,0,0,\n"),
              "a.csv: line 2: has 8 values instead of 14 (" + whole.substr(0, whole.size() - 1) + ")");
    EXPECT_EQ(fault(whole + "0,0,0,0,0,0,0,,1.5,0,0,1,1,1\n"),
              "a.csv: line 2: light: 1.5 is outside the allowed 0 to 1");
    EXPECT_EQ(fault(whole + "0,0,0,0,0,0,0,,0,0,0,1,1,4.5\n"),
              "a.csv: line 2: gain_high: 4.5 is outside the allowed 0 to 4");
    EXPECT_EQ(fault(whole + "0,0,0,0,0,0,0,,0,0,0,,,\n"), "a.csv: line 2: gain: is empty, and no flag says why");
}

}  // namespace
}  // namespace lapfx::match
