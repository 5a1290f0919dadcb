// Thumbnails by a program of the test: what is kept, reported and ended.
#include "app/browser/thumbnail_maker.h"

#include <signal.h>

#include <chrono>

#include "lapfx/preset.h"
#include "support/wait_until.h"
#include "unit/preset/support.h"

namespace lapfx::app {
namespace {

namespace fs = std::filesystem;

class Thumbnails : public testing::Test {
  protected:
    fs::path program(const std::string& script) {
        const fs::path file = folder_.write("render.sh", "#!/bin/bash\n" + script + "\n");
        fs::permissions(file, fs::perms::owner_all);
        return file;
    }
    ThumbnailMaker::Options options(const fs::path& by) {
        return {.cache = folder_.path() / "cache",
                .clip_folders = {},
                .program = by,
                .render = true,
                .longest = std::chrono::hours(1),  // it runs at the lowest priority, perhaps on a busy machine
                .wake = {}};
    }
    ThumbnailMaker::Request request(const std::string& name, double speed = 4) {
        Preset preset;
        preset.bleeding.speed = speed;
        return {.file = folder_.write(name, write_preset(preset)), .scene = scene_, .time = 2};
    }
    /// A script that records its arguments and fails.
    std::string notes() { return "echo \"$@\" >> '" + (folder_.path() / "calls").string() + "'; echo no >&2; exit 1"; }
    std::string calls() const { return test::read_text(folder_.path() / "calls"); }
    static std::vector<ThumbnailMaker::Result> made(ThumbnailMaker& maker, std::vector<ThumbnailMaker::Request> all) {
        maker.want(std::move(all));
        maker.finish();
        return maker.take();
    }
    /// A script that writes a picture of this grey to the given place, and counts its runs.
    std::string writes(int grey) {
        return "echo run >> '" + (folder_.path() / "runs").string() +
               "'\npython3 - \"$@\" <<'EOF'\nimport sys, zlib, struct\n"
               "w, h = (int(v) for v in sys.argv[sys.argv.index('--size') + 1].split('x'))\n"
               "def chunk(t, d): return struct.pack('>I', len(d)) + t + d + struct.pack('>I', zlib.crc32(t + d))\n"
               "rows = b''.join(b'\\0' + bytes([" +
               std::to_string(grey) +
               "]) * w for _ in range(h))\n"
               "open(sys.argv[-1], 'wb').write(b'\\x89PNG\\r\\n\\x1a\\n' + chunk(b'IHDR', struct.pack('>IIBBBBB', w, "
               "h, 8, "
               "0, 0, 0, 0)) + chunk(b'IDAT', zlib.compress(rows)) + chunk(b'IEND', b''))\nEOF";
    }
    /// A script that tells its process, and does not end by itself.
    std::string hangs() {
        const std::string file = hanging_.string();
        return "echo $$ > '" + file + ".new'; mv '" + file + ".new' '" + file + "'; exec sleep 100000";
    }
    /// Waits for it to run. Gives its process.
    pid_t hanging() {
        EXPECT_TRUE(test::wait_until([&] { return fs::exists(hanging_); }));
        const pid_t process = std::atoi(test::read_text(hanging_).c_str());
        fs::remove(hanging_);
        return process;
    }
    static bool ends(pid_t process) {
        return test::wait_until([&] { return ::kill(process, 0) != 0 && errno == ESRCH; });
    }
    std::size_t runs() const {
        const std::string text = test::read_text(folder_.path() / "runs");
        return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
    }

    test::Folder folder_;
    fs::path hanging_ = folder_.path() / "hanging";
    fs::path scene_ = folder_.write("s.json", test::scene_text());
};

TEST_F(Thumbnails, AreMadeOnceAndFoundAgainUntilThePresetChanges) {
    const auto by = options(program(writes(77)));
    ThumbnailMaker maker(by);
    auto results = made(maker, {request("a.json"), request("b.json", 5)});
    ASSERT_EQ(results.size(), 2U);
    for (const auto& result : results) {
        EXPECT_EQ(result.fault, "");
        ASSERT_EQ(result.rgba.size(), 192U * 154U * 4U);
        EXPECT_EQ(result.rgba[0], 77);
        EXPECT_EQ(result.rgba[3], 255);
    }
    EXPECT_EQ(runs(), 2U);
    ThumbnailMaker again(by);
    EXPECT_EQ(made(again, {request("a.json")}).at(0).rgba[0], 77);
    EXPECT_EQ(runs(), 2U) << "from the cache";
    made(again, {request("a.json", 6)});
    EXPECT_EQ(runs(), 3U) << "its text is another";
}

TEST_F(Thumbnails, ShowOnlyWhatIsKeptWhereNothingIsRendered) {
    auto by = options(program(writes(77)));
    by.render = false;
    ThumbnailMaker maker(by);
    const auto results = made(maker, {request("a.json")});
    EXPECT_TRUE(results.at(0).rgba.empty());
    EXPECT_EQ(results.at(0).fault, "");
    EXPECT_FALSE(fs::exists(folder_.path() / "cache"));
}

TEST_F(Thumbnails, TellWhatTheProgramSays) {
    ThumbnailMaker maker(options(program("echo 'lapfx: o.ply: no such file' >&2; echo more >&2; exit 1")));
    EXPECT_EQ(made(maker, {request("a.json")}).at(0).fault, "lapfx: o.ply: no such file");
    ThumbnailMaker silent(options(program("exit 0")));
    EXPECT_NE(made(silent, {request("a.json")}).at(0).fault.find("cannot be written"), std::string::npos);
    ThumbnailMaker none(options(folder_.path() / "nothing"));
    EXPECT_NE(made(none, {request("a.json")}).at(0).fault.find("cannot be started"), std::string::npos);
    for (const auto& entry : fs::directory_iterator(folder_.path() / "cache" / "thumbnails"))
        ADD_FAILURE() << entry.path() << " is left";
}

TEST_F(Thumbnails, ABrokenPresetAndABrokenPictureAreNoTrouble) {
    ThumbnailMaker maker(
        options(program("echo no picture > \"${12}\"; for last; do :; done; echo no picture > \"$last\"")));
    EXPECT_TRUE(made(maker, {request("a.json")}).at(0).rgba.empty());
    const fs::path broken = folder_.write("broken.json", "{");
    EXPECT_NE(made(maker, {{.file = broken, .scene = scene_, .time = 0}}).at(0).fault.find("broken.json"),
              std::string::npos);
}

TEST_F(Thumbnails, WhatIsNotWantedAnyMoreIsEndedAtOnce) {
    pid_t last = 0;
    {
        ThumbnailMaker maker(options(program(hangs())));
        maker.want({request("a.json"), request("b.json", 5)});
        const pid_t process = hanging();
        EXPECT_TRUE(maker.busy());
        maker.want({});
        maker.finish();
        EXPECT_TRUE(ends(process));
        EXPECT_TRUE(maker.take().empty());
        maker.want({request("a.json")});
        last = hanging();
    }
    EXPECT_TRUE(ends(last)) << "and one that runs when the editor ends";
}

TEST_F(Thumbnails, WhatIsWantedAgainWhileItIsEndedIsMadeAnew) {
    const std::string first = "'" + (folder_.path() / "first").string() + "'";
    ThumbnailMaker maker(options(program("if mkdir " + first + "; then " + hangs() + "; fi\n" + writes(7))));
    const ThumbnailMaker::Request a = request("a.json");
    maker.want({a});
    hanging();
    maker.want({});
    maker.want({a});
    maker.finish();
    const auto results = maker.take();
    ASSERT_EQ(results.size(), 1U);
    EXPECT_EQ(results[0].fault, "");
    EXPECT_FALSE(results[0].rgba.empty());
    EXPECT_EQ(runs(), 1U);
}

TEST_F(Thumbnails, WhateverMakesThemHasLimits) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    const std::string memory;
#else
    const std::string memory = std::to_string(ThumbnailMaker::most_memory / 1024) + ' ';
#endif
    const std::string tells = memory.empty() ? "" : "$(ulimit -d) ";
    ThumbnailMaker::Options wanted = options("");
    wanted.niceness = 12;
    // Limits come when it runs already, its niceness last. A wrong one is told after a minute.
    const std::string waits =
        "for ((i = 0; i < 6000; ++i)); do read -r -a stat < /proc/$$/stat && [ \"$(ulimit -t) ${stat[18]}\" = '600 12' "
        "] "
        "&& break; sleep 0.01; done\n";
    wanted.program = program(waits + "((i < 6000)) || echo never nice >&2\necho \"" + tells +
                             "$(ulimit -t) $(ulimit -c)\" >&2\nexit 1");
    ThumbnailMaker maker(wanted);
    EXPECT_EQ(made(maker, {request("a.json")}).at(0).fault, memory + "600 0") << "a preset";
    EXPECT_EQ(made(maker, {{.file = folder_.write("a.mp4", "x")}}).at(0).fault, memory + "600 0") << "any other";
}

TEST_F(Thumbnails, AnyOtherFileIsShownByItself) {
    ThumbnailMaker maker(options(program(notes())));
    made(maker, {{.file = folder_.write("a.mp4", "x")}, {.file = scene_, .scene = folder_.write("other.json", "{}")}});
    // The organ of the scene does not exist, which only the called program notices.
    EXPECT_NE(calls().find("picture " + (folder_.path() / "a.mp4").string() + " --size 192x154 -o "),
              std::string::npos);
    EXPECT_NE(calls().find("picture " + scene_.string()), std::string::npos)
        << "on itself, not on the one that is open";
    made(maker, {request("p.json")});
    EXPECT_NE(calls().find("render " + scene_.string() + " --preset " + (folder_.path() / "p.json").string()),
              std::string::npos);
    made(maker, {{.file = folder_.path() / "p.json"}});
    EXPECT_NE(calls().find("picture " + (folder_.path() / "p.json").string()), std::string::npos);
}

TEST_F(Thumbnails, AFileIsMadeAnewWhenItHasChanged) {
    ThumbnailMaker maker(options(program(writes(9))));
    const fs::path file = folder_.write("a.glb", "x");
    EXPECT_EQ(made(maker, {{.file = file}}).at(0).size, glm::ivec2(192, 154));
    made(maker, {{.file = file}});
    EXPECT_EQ(runs(), 1U);
    folder_.write("a.glb", "xy");
    made(maker, {{.file = file}});
    EXPECT_EQ(runs(), 2U) << "another length";
    auto large = options(program(writes(9)));
    large.size = {360, 288};
    ThumbnailMaker other(large);
    EXPECT_EQ(made(other, {{.file = file}}).at(0).size, glm::ivec2(360, 288));
    EXPECT_EQ(runs(), 3U) << "another size is another picture";
}

TEST_F(Thumbnails, OneThatTakesTooLongOrCrashesIsTold) {
    auto short_time = options(program(hangs()));
    short_time.longest = std::chrono::seconds(1);
    ThumbnailMaker slow(short_time);
    EXPECT_EQ(made(slow, {{.file = folder_.write("a.mp4", "x")}}).at(0).fault, "the picture took more than 1 s");
    ThumbnailMaker crashing(options(program("kill -SEGV $$")));
    EXPECT_NE(made(crashing, {{.file = folder_.path() / "a.mp4"}}).at(0).fault.find("crashed"), std::string::npos);
    for (const auto& entry : fs::directory_iterator(folder_.path() / "cache" / "thumbnails"))
        ADD_FAILURE() << entry.path() << " is left";
}

TEST_F(Thumbnails, OneThatIsLargerThanAskedForIsRefused) {
    auto large = options(program(writes(9)));
    const fs::path script = program("set -- \"$1\" \"$2\" --size 500x10 \"${@: -2}\"\n" + writes(9));
    large.program = script;
    ThumbnailMaker maker(large);
    const auto results = made(maker, {{.file = folder_.write("a.mp4", "x")}});
    EXPECT_TRUE(results.at(0).rgba.empty());
    EXPECT_EQ(results.at(0).fault, "what was made is not a picture");
}

TEST_F(Thumbnails, OpensNoWindow) {
    ThumbnailMaker maker(options(program("test -z \"$DISPLAY$WAYLAND_DISPLAY\" || exit 1; echo none >&2; exit 1")));
    ::setenv("DISPLAY", ":77", 1);
    const auto results = made(maker, {request("a.json")});
    ::unsetenv("DISPLAY");
    EXPECT_EQ(results.at(0).fault, "none");
}

TEST_F(Thumbnails, KeepsThreeHundred) {
    const fs::path kept = folder_.path() / "cache" / "thumbnails";
    fs::create_directories(kept);
    for (int i = 0; i < 330; ++i) {
        const fs::path file = folder_.write("cache/thumbnails/" + std::to_string(i) + ".png", "x");
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(1000 - i));
    }
    ThumbnailMaker maker(options(program(writes(5))));
    made(maker, {request("a.json")});
    EXPECT_EQ(std::distance(fs::directory_iterator(kept), fs::directory_iterator()), 300);
    EXPECT_FALSE(fs::exists(kept / "30.png")) << "the longest unused";
    EXPECT_TRUE(fs::exists(kept / "31.png"));
}

}  // namespace
}  // namespace lapfx::app
