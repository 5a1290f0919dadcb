#include "commands/verb.h"

#include <gmock/gmock.h>

#include "lapfx/error.h"

namespace lapfx::commands {
namespace {

using testing::ElementsAre;

const std::vector<std::string> verbs{"edit", "render", "sheet", "inspect", "check", "help"};

std::string refused(const std::vector<std::string>& arguments) {
    try {
        (void)with_verb(arguments, verbs);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        return error.faults().front().text();
    }
    return "taken";
}

TEST(Verb, FilesAndOptionsAloneAreForTheEditor) {
    EXPECT_THAT(with_verb({}, verbs), ElementsAre("edit"));
    EXPECT_THAT(with_verb({"liver.glb", "smoke.mp4"}, verbs), ElementsAre("edit", "liver.glb", "smoke.mp4"));
    EXPECT_THAT(with_verb({"--size", "800x600"}, verbs), ElementsAre("edit", "--size", "800x600"));
    EXPECT_THAT(with_verb({"/tmp", "x"}, verbs), ElementsAre("edit", "/tmp", "x"))
        << "the editor tells what is no file";
}

TEST(Verb, AVerbStaysWhatItIs) {
    EXPECT_THAT(with_verb({"render", "edit", "-o", "x.png"}, verbs), ElementsAre("render", "edit", "-o", "x.png"));
    EXPECT_THAT(with_verb({"--help"}, verbs), ElementsAre("--help"));
    EXPECT_THAT(with_verb({"--version"}, verbs), ElementsAre("--version"));
    EXPECT_THAT(with_verb({"help", "sheet"}, verbs), ElementsAre("help", "sheet"));
}

TEST(Verb, AWrongOneIsToldWithTheNearest) {
    EXPECT_EQ(refused({"rendr", "x.json"}),
              "\"rendr\" is neither a command nor a file; nearest is render (see lapfx help)");
    EXPECT_EQ(refused({"chekc"}), "\"chekc\" is neither a command nor a file; nearest is check (see lapfx help)");
    EXPECT_EQ(unknown_word("shet", "command or topic of help", verbs).faults().front().text(),
              "\"shet\" is not a command or topic of help; nearest is sheet (see lapfx help)");
    EXPECT_EQ(refused({"fit", "x.json"}), "\"fit\" is neither a command nor a file (see lapfx help)");
    EXPECT_EQ(unknown_word("nothing", "command or topic of help", verbs).faults().front().text(),
              "\"nothing\" is not a command or topic of help (see lapfx help)")
        << "it resembles none";
    EXPECT_NE(refused({std::string(1 << 20, 'x')}), "taken") << "a hostile one costs no minutes";
}

TEST(Verb, AnEmptyValueIsNoneThatWasLeftOut) {
    const auto empty = [](const std::vector<std::string>& arguments) {
        try {
            require_values(arguments);
        } catch (const Error& error) {
            EXPECT_EQ(error.failure(), Failure::bad_input);
            return error.faults().front().text();
        }
        return std::string("taken");
    };
    EXPECT_EQ(empty({"measure", "v.mp4", "-o", ""}), "-o: \"\" is empty; a value is needed here");
    EXPECT_EQ(empty({"measure", "v.mp4", "--json", "", "-o", "a.csv"}),
              "--json: \"\" is empty; a value is needed here");
    EXPECT_EQ(empty({"measure", "--baseline=", "-o", "a.csv"}), "--baseline: \"\" is empty; a value is needed here");
    EXPECT_EQ(empty({"inspect", ""}), "\"\" is empty; a value is needed here");
    EXPECT_EQ(empty({"render", "s", "--set", "name=", "--set=name=", "--", "a="}), "taken") << "the value is \"name=\"";
}

}  // namespace
}  // namespace lapfx::commands
