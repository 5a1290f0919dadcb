#include "commands/command_line.h"

#include <gmock/gmock.h>

#include <utility>

#include "lapfx/error.h"

namespace lapfx::commands {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Values {
    std::string scene;
    std::vector<std::string> settings, folders;
    std::vector<double> times;
    std::optional<double> offset;
    std::optional<std::size_t> number;
    double fps = 25.0, at = 0.0;
    float scale = 0.0F;
    int rounds = 3;
    std::uint32_t seed = 1;
    bool fast = false, has_at = false, has_span = false;
};

class CommandLine : public testing::Test {
  protected:
    CommandLine() {
        Verb draw{.name = "draw", .help = "Draw a thing", .run = [this] { ran = "draw"; }};
        draw.argument("SCENE", "The scene", &v.scene, {.required = true});
        draw.option("--set", "KEY=VALUE", "Change a value", &v.settings, {.one_each = true});
        draw.option("--folders", "A B", "Two folders", &v.folders, {.count = 2});
        draw.option("--times", "TIMES", "Times", &v.times,
                    {.one_each = true, .separator = ',', .range = Range{0.0, 10.0}});
        draw.option("--offset", "S", "Later by", &v.offset, {.number = Number::finite});
        draw.option("--number", "N", "Which", &v.number, {.number = Number::whole});
        draw.option("--fps", "N", "How often", &v.fps, {.shows_default = true, .range = Range{0.1, 1000.0}});
        draw.option("--from", "S", "Begin at", &v.at, {.given = &v.has_span});
        draw.option("--to", "S", "End at", &v.at, {.given = &v.has_span});
        draw.option("--at", "S", "Only at", &v.at, {.excludes = {"--from", "--to"}, .given = &v.has_at});
        draw.option("--scale", "N", "How large", &v.scale, {.range = Range{0.5, 2.0}});
        draw.option("-r,--rounds", "N", "How often", &v.rounds, {.range = Range{1, 20}});
        draw.option("--seed", "N", "Of the chance", &v.seed, {.shows_default = true, .number = Number::whole});
        draw.option("--theme", "dark|light", "Colours", &theme, {.words = {"dark", "light"}});
        draw.flag("--fast", "Soon", &v.fast);
        Verb bench{.name = "bench", .help = "Measure"};
        bench.parts.push_back({.name = "speed", .help = "Of all", .run = [this] { ran = "bench speed"; }});
        program.parts = {std::move(draw), std::move(bench)};
    }

    void take(std::vector<std::string> arguments) { parse(program, std::move(arguments), "1.2.3")(); }
    std::string fault_of(std::vector<std::string> arguments) {
        try {
            take(std::move(arguments));
        } catch (const Error& error) {
            EXPECT_EQ(error.failure(), Failure::bad_input);
            EXPECT_EQ(ran, "");
            return error.faults().front().text();
        }
        return "no fault";
    }
    std::string printed(std::vector<std::string> arguments) {
        testing::internal::CaptureStdout();
        take(std::move(arguments));
        EXPECT_EQ(ran, "");
        return testing::internal::GetCapturedStdout();
    }

    Values v;
    std::string theme, ran;
    Verb program{.name = "lapfx", .help = "What it is for.", .is_program = true};
};

TEST_F(CommandLine, ValuesGoWhereTheOptionsSay) {
    take({"draw",  "--set",    "a=1",    "x.scene.json", "--set=b=2", "--folders", "one",   "two",     "--times",
          "1,2.5", "--offset", "-3",     "--number",     "4",         "--fps",     "30",    "--scale", "1.5",
          "-r",    "7",        "--seed", "4294967295",   "--theme",   "light",     "--fast"});
    EXPECT_EQ(ran, "draw");
    EXPECT_EQ(v.scene, "x.scene.json");
    EXPECT_THAT(v.settings, ElementsAre("a=1", "b=2"));
    EXPECT_THAT(v.folders, ElementsAre("one", "two"));
    EXPECT_THAT(v.times, ElementsAre(1.0, 2.5));
    EXPECT_EQ(v.offset, -3.0);
    EXPECT_EQ(v.number, 4U);
    EXPECT_EQ(v.fps, 30.0);
    EXPECT_EQ(v.scale, 1.5F);
    EXPECT_EQ(v.rounds, 7);
    EXPECT_EQ(v.seed, 4294967295U);
    EXPECT_EQ(theme, "light");
    EXPECT_TRUE(v.fast);
}

TEST_F(CommandLine, WhatIsNotGivenStaysAsItIs) {
    take({"draw", "x"});
    EXPECT_EQ(v.fps, 25.0);
    EXPECT_EQ(v.offset, std::nullopt);
    EXPECT_FALSE(v.fast);
    EXPECT_FALSE(v.has_at);
    EXPECT_FALSE(v.has_span);
}

TEST_F(CommandLine, TellsWhatWasGiven) {
    take({"draw", "x", "--from", "1"});
    EXPECT_TRUE(v.has_span) << "and --to, which shares it, was not";
    EXPECT_FALSE(v.has_at);
}

TEST_F(CommandLine, APartRunsAndItsCommandAloneDoesNot) {
    take({"bench", "speed"});
    EXPECT_EQ(std::exchange(ran, ""), "bench speed");
    EXPECT_EQ(fault_of({"bench"}), "A subcommand is required (see lapfx help)");
}

TEST_F(CommandLine, NumbersHaveTheirLimits) {
    EXPECT_EQ(fault_of({"draw", "x", "--offset", "nan"}), "--offset: \"nan\" is not a number (see lapfx help)");
    EXPECT_EQ(fault_of({"draw", "x", "--fps", "inf"}), "--fps: \"inf\" is not a number (see lapfx help)");
    EXPECT_EQ(fault_of({"draw", "x", "--number", "-1"}),
              "--number: \"-1\" is not a whole number from 0 to 4294967295 (see lapfx help)");
    EXPECT_EQ(fault_of({"draw", "x", "--times", "1,11"}),
              "--times: Value 11 not in range 0.000000 to 10.000000 (see lapfx help)");
    EXPECT_EQ(fault_of({"draw", "x", "--rounds", "1.5"}), "--rounds: Value 1.5 not in range 1 to 20 (see lapfx help)");
}

TEST_F(CommandLine, WhatMustBeThereAndWhatMayNot) {
    EXPECT_EQ(fault_of({"draw"}), "SCENE is required (see lapfx help)");
    EXPECT_EQ(fault_of({"draw", "x", "--at", "1", "--to", "2"}), "--to excludes --at (see lapfx help)");
    EXPECT_THAT(fault_of({"draw", "x", "--theme", "red"}), HasSubstr("red not in {dark,light}"));
    EXPECT_THAT(fault_of({"draw", "x", "--nothing"}), HasSubstr("--nothing"));
    EXPECT_THAT(fault_of({"draw", "x", "--folders", "one"}), HasSubstr("At least 2 required but received 1"));
}

TEST_F(CommandLine, HelpIsThatOfTheCommandOrItsPart) {
    EXPECT_THAT(printed({"draw", "--help"}), HasSubstr("Draw a thing\n\nUsage: lapfx draw SCENE [OPTIONS]\n"));
    EXPECT_THAT(printed({"draw", "--help"}), HasSubstr("\n  --fps N                 How often; default: 25\n"));
    EXPECT_EQ(
        printed({"bench", "speed", "-h"}),
        "Of all\n\nUsage: lapfx bench speed [OPTIONS]\n\nOptions:\n  -h,--help               Print this help\n\n");
    EXPECT_THAT(printed({"--help"}), HasSubstr("Commands:\n  draw                    Draw a thing\n"));
    EXPECT_EQ(printed({"--version"}), "1.2.3\n");
}

}  // namespace
}  // namespace lapfx::commands
