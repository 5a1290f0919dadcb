// `lapfx check` as a program: what goes to stdout and stderr, and its exit code.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include "support/clips.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

struct Result {
    int code = -1;
    std::string out;
    std::string err;
};

Result run_lapfx(const test::Folder& folder, const std::string& arguments) {
    const std::string command =
        "cd '" + folder.path().string() + "' && '" LAPFX_BINARY_DIR "/lapfx' " + arguments + " > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, test::read_text(folder / "out.txt"),
            test::read_text(folder / "err.txt")};
}

class CheckCommand : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(LAPFX_BINARY_DIR "/lapfx")) GTEST_SKIP() << "the program is not built";
        folder.write("good.json", test::preset_text(R"(, "name": "Ooze")"));
        folder.write("scene.json", test::scene_text());
        folder.write("bad.json", test::preset_text(R"(, "bleeding": {"speed": -3, "sped": 1})"));
    }
    test::Folder folder;
};

TEST_F(CheckCommand, GoodFilesAreNamedOnStdout) {
    const Result result = run_lapfx(folder, "check good.json scene.json");
    EXPECT_EQ(result.code, 0);
    EXPECT_EQ(result.out, "good.json: preset \"Ooze\", ok\nscene.json: scene \"\", ok\n");
    EXPECT_EQ(result.err, "lapfx: note: good.json: no smoke clips: cautery makes no smoke\n");
}

TEST_F(CheckCommand, EveryFaultOfEveryFileIsALineOnStderr) {
    const Result result = run_lapfx(folder, "check bad.json good.json missing.json .");
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "good.json: preset \"Ooze\", ok\n");
    EXPECT_EQ(result.err,
              "lapfx: note: good.json: no smoke clips: cautery makes no smoke\n"
              "lapfx: bad.json: /bleeding/sped: unknown key; nearest is \"speed\"\n"
              "lapfx: bad.json: /bleeding/speed: -3 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)\n"
              "lapfx: missing.json: cannot be read: No such file or directory\n"
              "lapfx: .: not a plain file but a folder\n");
}

TEST_F(CheckCommand, OpensTheClipsOfAPreset) {
    test::write_clip(folder / "real.avi", 3);
    folder.write("empty.mp4", "");
    folder.write("clips.json", test::preset_text(R"(, "name": "Clips", "smoke": {"clips": [{"file": "real.avi"},
        {"file": "gone.mp4"}, {"file": "plume_thick.mp4"}, {"file": "empty.mp4"}]})"));
    folder.write("real.json",
                 test::preset_text(R"(, "smoke": {"haze": {"accumulation": 0}, "clips": [{"file": "real.avi"}]})"));
    const Result result = run_lapfx(folder, "check clips.json real.json");
    EXPECT_EQ(result.code, 2);
    EXPECT_EQ(result.out, "real.json: preset \"\", ok\n");
    EXPECT_TRUE(result.err.starts_with("lapfx: clips.json: /smoke/clips/1/file: gone.mp4: no such clip; looked in ."))
        << result.err;
    EXPECT_TRUE(result.err.ends_with("\nlapfx: clips.json: /smoke/clips/3/file: empty.mp4: is empty\n")) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 2) << result.err;
}

TEST_F(CheckCommand, PrintsTheSchemas) {
    EXPECT_EQ(run_lapfx(folder, "check --schema preset").out, preset_schema());
    EXPECT_EQ(run_lapfx(folder, "check --schema scene").out, scene_schema());
}

TEST_F(CheckCommand, WrongUsageIsExitCodeTwo) {
    for (const char* arguments : {"check", "check --schema organ", "check --schema", "check --schema preset good.json"})
        EXPECT_EQ(run_lapfx(folder, arguments).code, 2) << arguments;
}

}  // namespace

}  // namespace lapfx
