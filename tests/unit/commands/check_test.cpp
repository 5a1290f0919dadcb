// `lapfx check` as a program: its stdout, stderr and exit code.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include "lapfx/authoring/documents.h"
#include "support/clips.h"
#include "support/folders.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

struct Result {
    int code = -1;
    std::string out;
    std::string err;
};

Result run_lapfx(const test::Folder& folder, const std::string& arguments) {
    const std::string command = "cd '" + folder.path().string() + "' && '" + (test::build_folder() / "lapfx").string() +
                                "' " + arguments + " > out.txt 2> err.txt";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, test::read_text(folder / "out.txt"),
            test::read_text(folder / "err.txt")};
}

class CheckCommand : public testing::Test {
  protected:
    void SetUp() override {
        if (!std::filesystem::exists(test::build_folder() / "lapfx")) GTEST_SKIP() << "the program is not built";
        folder.write("good.json", test::preset_text(R"(, "name": "Ooze")"));
        folder.write("scene.json", test::scene_text());
        folder.write(
            "o.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n9 0 0\n0 9 0\n3 0 1 2\n");
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

TEST_F(CheckCommand, OpensWhatASceneNames) {
    test::write_clip(folder / "real.avi", 3);
    folder.write("words.mp4", "no video at all");
    folder.write("empty.json", test::preset_text(R"(, "smoke": {"clips": [{"file": "gone.avi"}]})"));
    const auto scene = [&](const std::string& name, const std::string& members) {
        folder.write(name, test::scene_text(members));
    };
    scene("good.scene.json", R"(, "preset": "good.json", "organ": {"file": "o.ply"}, "tool": {"file": "o.ply"},
        "reference": {"file": "real.avi", "offset": 2.5})");
    scene("gone.scene.json", R"(, "preset": "none.json", "organ": {"file": "none.ply"}, "tool": {"file": "none.stl"},
        "reference": {"file": "../none.mp4"})");
    scene("wrong.scene.json", R"(, "preset": "empty.json", "organ": {"file": "words.mp4"},
        "reference": {"file": "words.mp4"})");
    EXPECT_EQ(run_lapfx(folder, "check good.scene.json").out, "good.scene.json: scene \"\", ok\n");
    const Result gone = run_lapfx(folder, "check gone.scene.json good.scene.json");
    EXPECT_EQ(gone.code, 2);
    EXPECT_EQ(gone.out, "good.scene.json: scene \"\", ok\n");
    EXPECT_EQ(gone.err,
              "lapfx: gone.scene.json: /organ/file: \"none.ply\": no such file\n"
              "lapfx: gone.scene.json: /tool/file: \"none.stl\": no such file\n"
              "lapfx: gone.scene.json: /preset: \"none.json\": cannot be read: No such file or directory\n"
              "lapfx: gone.scene.json: /reference/file: \"../none.mp4\": no such file\n");
    const Result wrong = run_lapfx(folder, "check wrong.scene.json");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_TRUE(
        wrong.err.starts_with("lapfx: wrong.scene.json: /organ/file: \"words.mp4\": is not a mesh that can be read"))
        << wrong.err;
    EXPECT_NE(wrong.err.find("wrong.scene.json: /preset: \"empty.json\": /smoke/clips/0/file: gone.avi: no such clip"),
              std::string::npos)
        << wrong.err;
    EXPECT_NE(wrong.err.find("wrong.scene.json: /reference/file: \"words.mp4\": is not a video that can be decoded\n"),
              std::string::npos)
        << wrong.err;
}

TEST_F(CheckCommand, TellsWhatTouchesNothingAndSmokeThatCannotBeSeen) {
    folder.write("flat.obj", "v 0 0 0\nv 40 0 0\nv 0 40 0\nf 1 2 3\n");
    folder.write("bare.json", test::preset_text(""));
    const auto event = [](const std::string& action, const std::string& from, const std::string& to) {
        return R"({"action": ")" + action + R"(", "time": 0, "duration": 1, "position": )" + from + R"(, "to": )" + to +
               "}";
    };
    const std::string near = "[5, 5, 1]", far = "[5, 5, 45]", beside = "[-900, 5, 0]";
    folder.write("some.scene.json",
                 test::scene_text(R"(, "preset": "bare.json", "organ": {"file": "flat.obj"}, "events": [)" +
                                  event("cut", near, near) + ", " + event("cauterise", far, far) + ", " +
                                  event("clip", beside, beside) + ", " + event("suction", far, far) + ", " +
                                  event("cut", far, near) + "]"));
    const Result some = run_lapfx(folder, "check some.scene.json");
    EXPECT_EQ(some.code, 0);
    EXPECT_EQ(some.out, "some.scene.json: scene \"\", ok\n");
    const std::string say = "lapfx: note: some.scene.json: ";
    EXPECT_EQ(some.err, say + "/events/1: touches nothing: its tip is 45.0 mm from the organ, 5 mm at most\n" + say +
                            "/events/2: touches nothing: its tip is 900.0 mm from the organ, 5 mm at most\n" + say +
                            "/preset: no smoke clips: cautery makes no smoke\n");
}

/// One organ is far too large in its own unit, and the scene makes another too large.
TEST_F(CheckCommand, TakesMeshesAtTheScenesScale) {
    const auto triangle = [&](const std::string& name, const std::string& size) {
        folder.write(name, "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n");
    };
    triangle("far.obj", "2e9");
    triangle("near.obj", "9e5");
    folder.write("good.scene.json", test::scene_text(R"(, "organ": {"file": "far.obj", "scale": 1e-6},
        "tool": {"file": "far.obj", "scale": 1e-6})"));
    folder.write("bad.scene.json", test::scene_text(R"(, "organ": {"file": "near.obj", "scale": 1e6},
        "tool": {"file": "near.obj", "scale": 1e6})"));
    const Result good = run_lapfx(folder, "check good.scene.json");
    EXPECT_EQ(good.err, "");
    EXPECT_EQ(good.out, "good.scene.json: scene \"\", ok\n");
    const Result bad = run_lapfx(folder, "check bad.scene.json");
    EXPECT_EQ(bad.code, 2);
    EXPECT_NE(bad.err.find("/organ/file: \"near.obj\": no triangles that can be drawn"), std::string::npos) << bad.err;
    EXPECT_NE(bad.err.find("/tool/file: \"near.obj\": no triangles that can be drawn"), std::string::npos) << bad.err;
}

TEST_F(CheckCommand, InspectTellsWhatASceneNamesAndWhatIsMissing) {
    test::write_clip(folder / "real.avi", 3);
    folder.write("s.json", test::scene_text(R"(, "organ": {"file": "gone.ply"}, "preset": "/usr/bin/env",
        "reference": {"file": "real.avi", "offset": 2.5, "aspect": 1.25})"));
    const std::string out = run_lapfx(folder, "inspect s.json").out;
    EXPECT_NE(out.find("  organ               gone.ply (missing)\n"), std::string::npos) << out;
    EXPECT_NE(out.find("  preset              /usr/bin/env (outside the scene's folder)\n"), std::string::npos) << out;
    EXPECT_NE(out.find("  tool                none\n"), std::string::npos) << out;
    EXPECT_NE(out.find("  reference           real.avi, from 2.5 s, shown at 1.25:1\n"), std::string::npos) << out;
    EXPECT_NE(run_lapfx(folder, "inspect scene.json").out.find("  reference           none\n"), std::string::npos);
}

TEST_F(CheckCommand, InspectKnowsTheScenesFolderHoweverAFileInItIsNamed) {
    std::filesystem::create_directories(folder / "scenes");
    folder.write("scenes/p.json", "{}");
    folder.write("p.json", "{}");
    const std::string organ = R"(, "organ": {"file": "o.ply"})";
    for (const std::string& named :
         {std::string("p.json"), std::string("../scenes/p.json"), (folder / "scenes/p.json").string()}) {
        folder.write("scenes/s.json", test::scene_text(organ + ", \"preset\": \"" + named + '"'));
        EXPECT_NE(run_lapfx(folder, "inspect scenes/s.json").out.find("  preset              " + named + "\n"),
                  std::string::npos)
            << named;
    }
    folder.write("scenes/s.json", test::scene_text(organ + ", \"preset\": \"../p.json\""));
    EXPECT_NE(run_lapfx(folder, "inspect scenes/s.json").out.find("../p.json (outside the scene's folder)\n"),
              std::string::npos);
}

TEST_F(CheckCommand, PrintsTheSchemas) {
    EXPECT_EQ(run_lapfx(folder, "check --schema preset").out, preset_schema());
    EXPECT_EQ(run_lapfx(folder, "check --schema scene").out, scene_schema());
}

TEST_F(CheckCommand, ASchemaBesideThePresetsIsNoFault) {
    folder.write("preset.schema.json", preset_schema());
    folder.write("scene.schema.json", scene_schema());
    folder.write("old.schema.json", "{}");
    EXPECT_EQ(run_lapfx(folder, "check preset.schema.json scene.schema.json").out,
              "preset.schema.json: schema, ok\nscene.schema.json: schema, ok\n");
    const Result old = run_lapfx(folder, "check old.schema.json");
    EXPECT_EQ(old.code, 2);
    EXPECT_EQ(old.err,
              "lapfx: old.schema.json: is not the schema of this version; `lapfx check --schema preset` (or "
              "scene) prints it\n");
}

TEST_F(CheckCommand, MigratingSaysWhetherItHasRewritten) {
    EXPECT_EQ(run_lapfx(folder, "migrate good.json").out,
              "good.json: preset \"Ooze\" rewritten in the current version\n");
    const auto written = std::filesystem::last_write_time(folder / "good.json");
    EXPECT_EQ(run_lapfx(folder, "migrate good.json").out,
              "good.json: preset \"Ooze\" is already as this version writes it\n");
    EXPECT_EQ(std::filesystem::last_write_time(folder / "good.json"), written);
}

TEST_F(CheckCommand, WrongUsageIsExitCodeTwo) {
    for (const char* arguments : {"check", "check --schema organ", "check --schema", "check --schema preset good.json"})
        EXPECT_EQ(run_lapfx(folder, arguments).code, 2) << arguments;
}

}  // namespace

}  // namespace lapfx
