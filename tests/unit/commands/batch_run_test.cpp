// When lapfx batch does an item, and when it does not. What is done well is tested from outside (e2e/batch_test.py).
#include "commands/batch_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "commands/batch_result.h"
#include "document/lock.h"
#include "unit/preset/support.h"

namespace lapfx::commands {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

const BatchItem video{"week/a.mp4", ItemKind::video}, scene{"s.scene.json", ItemKind::scene};

class BatchRunTest : public ::testing::Test {
  protected:
    BatchRunTest() {
        fs::create_directories(folder / "videos/week");
        fs::create_directories(results(video));
        write("videos/week/a.mp4", "no video");
        options.folder = folder / "videos", options.results = folder / "results";
    }
    void write(const std::string& name, const std::string& text) const { folder.write(name, text); }
    fs::path results(const BatchItem& item) const { return folder / "results" / item.name; }
    /// The faults that it ends with; what it says is in `said`.
    std::vector<std::string> run(const BatchItem& item) {
        std::ostringstream out;
        auto faults = test::faults_of([&] { run_item(options, item, out); });
        said = out.str();
        return faults;
    }
    std::vector<std::string> files(const BatchItem& item) const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(results(item))) names.push_back(entry.path().filename());
        std::sort(names.begin(), names.end());
        return names;
    }

    test::Folder folder;
    BatchRunOptions options;
    std::string said;
};

TEST_F(BatchRunTest, AFaultOfTheInputIsKeptWithoutThePlaceOfTheFolder) {
    EXPECT_THAT(run(video), ElementsAre(folder.path() / "videos/week/a.mp4: is not a video that can be decoded"));
    EXPECT_THAT(files(video), ElementsAre("result.json"));
    const auto kept = read_result(results(video));
    ASSERT_TRUE(kept);
    EXPECT_THAT(kept->faults, ElementsAre("week/a.mp4: is not a video that can be decoded"));
    EXPECT_FALSE(kept->fitted);
    EXPECT_EQ(kept->input.size(), 32U);
}

TEST_F(BatchRunTest, WhatIsKeptIsToldUntilItsInputIsAnother) {
    run(video);
    const std::string first = test::read_text(results(video) / "result.json");
    EXPECT_THAT(run(video), ElementsAre("week/a.mp4: is not a video that can be decoded"));
    EXPECT_EQ(said, "week/a.mp4: failed before\n");
    options.again = true;
    EXPECT_THAT(run(video), ElementsAre(HasSubstr("videos/week/a.mp4: is not")));
    EXPECT_EQ(said, "");
    options.again = false;
    EXPECT_EQ(test::read_text(results(video) / "result.json"), first);  // the same again
    write("videos/week/a.mp4", "no video either");
    run(video);
    EXPECT_EQ(said, "");
    EXPECT_NE(test::read_text(results(video) / "result.json"), first);
    options.fit.match.window = "0,1";
    run(video);
    EXPECT_EQ(said, "");
    options.fit.seed = 7;  // nothing of measuring
    run(video);
    EXPECT_EQ(said, "week/a.mp4: failed before\n");
}

TEST_F(BatchRunTest, WhatIsDoneIsNotDoneAgain) {
    run(video);
    BatchResult done = *read_result(results(video));
    done.faults.clear();
    write("results/week/a.mp4/result.json", text_of(done));
    EXPECT_THAT(run(video), IsEmpty());
    EXPECT_EQ(said, "week/a.mp4: done before\n");
    write("results/week/a.mp4/result.json", "{\"format\":\"lapfx.batch\"");
    EXPECT_EQ(run(video).size(), 1U);
    EXPECT_EQ(said, "") << "half a result is none";
}

TEST_F(BatchRunTest, AFaultOfTheCommandLeavesWhatWasFound) {
    write("s.scene.json", test::scene_text()), write("o.ply", "ply");
    options.fit.files.scene = folder / "s.scene.json";
    run(video);
    const std::string kept = test::read_text(results(video) / "result.json");
    options.fit.parameters = "smoke.haze.acumulation";
    EXPECT_THAT(run(video), ElementsAre(HasSubstr("--parameters: smoke.haze.acumulation")));
    EXPECT_EQ(test::read_text(results(video) / "result.json"), kept);
}

TEST_F(BatchRunTest, WhatAKillLeftIsCleared) {
    for (const char* name :
         {"running.lock", "fitted.json", "report.html", "amounts.csv", ".lapfx-part-12-0f5a7bc9.tmp"})
        write(std::string("results/week/a.mp4/") + name, "half");
    run(video);
    EXPECT_THAT(files(video), ElementsAre("result.json"));
}

TEST_F(BatchRunTest, WhatFailedByNoFaultOfItsInputIsDoneAgain) {
    run(video);
    auto kept = *read_result(results(video));
    kept.unfinished = true;
    write("results/week/a.mp4/result.json", text_of(kept));
    EXPECT_STREQ(state_of(*read_result(results(video))), "unfinished");
    run(video);
    EXPECT_EQ(said, "");  // and not "failed before"
    EXPECT_STREQ(state_of(*read_result(results(video))), "failed");
}

TEST_F(BatchRunTest, ClipsOfAFailedItemAreGone) {
    write("videos/s.scene.json", test::scene_text(R"(, "organ": {"file": "o.ply"}, "preset": "p.json",
        "reference": {"file": "week/a.mp4"})"));
    write("videos/p.json", test::preset_text(R"(, "smoke": {"clips": [{"file": "own/deep/clip.mp4"}]})"));
    fs::create_directories(folder / "videos/own/deep");
    write("videos/own/deep/clip.mp4", "a clip");
    for (int time = 0; time < 2; ++time) {
        EXPECT_THAT(run(scene), testing::Not(IsEmpty()));
        EXPECT_THAT(files(scene), ElementsAre("result.json"));
        fs::create_directories(results(scene) / "own/deep");  // of a run that was killed
        fs::create_hard_link(folder / "videos/own/deep/clip.mp4", results(scene) / "own/deep/clip.mp4");
        options.again = true;
    }
    EXPECT_TRUE(fs::exists(folder / "videos/own/deep/clip.mp4"));
}

TEST_F(BatchRunTest, OnlyOneProcessDoesIt) {
    const auto lock = document::Lock::take(results(video) / "running.lock");
    ASSERT_TRUE(lock);
    EXPECT_THAT(run(video), IsEmpty());
    EXPECT_THAT(said, StartsWith("week/a.mp4: is being done by process "));
    EXPECT_THAT(files(video), ElementsAre("running.lock"));
}

TEST_F(BatchRunTest, ASceneWithoutAReferenceIsAFault) {
    write("videos/s.scene.json", test::scene_text());
    EXPECT_THAT(run(scene), ElementsAre(HasSubstr("s.scene.json: /reference/file: is missing")));
    EXPECT_TRUE(read_result(results(scene))->fitted);
    write("videos/s.scene.json", "{");
    EXPECT_EQ(run(scene).size(), 1U);
    EXPECT_EQ(said, "");
    run(scene);
    EXPECT_EQ(said, "s.scene.json: failed before\n");
}

TEST_F(BatchRunTest, WhatItReadsIsNotReplaced) {
    write("results/week/a.mp4/fitted.json", test::preset_text());
    write("s.scene.json", test::scene_text());
    options.fit.files.scene = folder / "s.scene.json", options.fit.files.preset = results(video) / "fitted.json";
    EXPECT_THAT(run(video), ElementsAre(HasSubstr("fitted.json: is a result of this item")));
    EXPECT_THAT(files(video), ElementsAre("fitted.json"));
}

TEST_F(BatchRunTest, AFitIsOfAllFilesThatTheSceneAndItsOrganName) {
    write("videos/s.scene.json", test::scene_text(R"(, "organ": {"file": "o.obj"}, "preset": "p.json",
        "reference": {"file": "week/a.mp4"})"));
    write("videos/p.json", test::preset_text());
    std::vector<std::string> inputs;
    const auto add = [&] {
        run(scene);
        inputs.push_back(read_result(results(scene))->input);
    };
    add();
    write("videos/o.obj", "mtllib o.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    add();
    write("videos/o.mtl", "newmtl a\nKd 1 0 0\n");
    add();
    write("videos/o.mtl", "newmtl a\nKd 1 1 0\n");
    add();
    write("videos/p.json", test::preset_text(R"(, "bleeding": {"speed": 3})"));
    add();
    write("videos/week/a.mp4", "another");
    add();
    options.fit.seed = 7;
    add();
    options.fit.parameters = "bleeding.speed";
    add();
    std::sort(inputs.begin(), inputs.end());
    EXPECT_EQ(std::unique(inputs.begin(), inputs.end()), inputs.end());
    add();
    EXPECT_EQ(said, "s.scene.json: failed before\n");
}

}  // namespace
}  // namespace lapfx::commands
