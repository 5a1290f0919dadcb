#include "commands/man_pages.h"

#include <gmock/gmock.h>

#include "commands/help_topics.h"

namespace lapfx::commands {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string page_named(const Verb& program, const std::string& name, std::string_view about = {}) {
    for (const ManPage& page : man_pages(program, about))
        if (page.name == name) return page.text;
    return "no such page";
}

class ManPages : public testing::Test {
  protected:
    Verb program{.name = "lapfx",
                 .help = "What it is for.",
                 .parts = {{.name = "draw", .help = "Draw a thing"}},
                 .is_program = true};
    Verb& verb = program.parts.front();
};

TEST(Roff, PrintsWhatItIsGiven) {
    EXPECT_EQ(roff("off-screen --at 3"), "off\\-screen \\-\\-at 3");
    EXPECT_EQ(roff("C:\\clips"), "C:\\(rsclips");
    EXPECT_EQ(roff("the scene's \"x\" ~ ^"), "the scene\\(aqs \\(dqx\\(dq \\(ti \\(ha");
}

TEST(Roff, CodeIsBold) {
    EXPECT_EQ(roff("`lapfx check` prints"), "\\fBlapfx check\\fR prints");
    EXPECT_EQ(roff("a single ` ends with the text"), "a single \\fB ends with the text\\fR");
}

TEST(Roff, ALineMayEndWithinAListOfKeys) {
    EXPECT_EQ(roff("a,b|c, d,"), "a,\\:b|\\:c, d,");
}

TEST_F(ManPages, OneForEachCommandAndTopic) {
    std::vector<std::string> names;
    for (const ManPage& page : man_pages(program, "")) names.push_back(page.name);
    EXPECT_THAT(names, testing::IsSupersetOf({"lapfx.1", "lapfx-draw.1", "lapfx-preset.5", "lapfx-scene.5",
                                              "lapfx-files.7", "lapfx-tool.7"}));
    EXPECT_EQ(names.size(), 2 + help_topics().size());
}

TEST_F(ManPages, OptionsSayWhatTheyTakeAndTheirDefault) {
    int size = 3;
    bool fast = false;
    std::string scene;
    verb.argument("SCENE", "The scene", &scene, {.required = true});
    verb.option("-s,--size", "N", "How large", &size, {.shows_default = true});
    verb.flag("--fast", "Soon", &fast);
    const std::string page = page_named(program, "lapfx-draw.1");
    EXPECT_THAT(page, HasSubstr(".SH NAME\nlapfx\\-draw \\- Draw a thing\n"));
    EXPECT_THAT(page, HasSubstr(".SH \"SYNOPSIS\"\n\\fBlapfx draw\\fR SCENE [OPTIONS]\n"));
    EXPECT_THAT(page, HasSubstr(".SH \"ARGUMENTS\"\n.TP\n\\fBSCENE\\fR\nThe scene\n"));
    EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-s\\fR, \\fB\\-\\-size\\fR \\fIN\\fR\nHow large; default: 3\n"));
    EXPECT_THAT(page, HasSubstr(".TP\n\\fB\\-\\-fast\\fR\nSoon\n"));
}

TEST_F(ManPages, TheWordsBelowTheOptionsKeepTheirLists) {
    verb.footer =
        "One line\nand one more:\n  .dots  are no requests\n    as it  is\n\nExample:\n  lapfx draw -s 3\n  .x";
    const std::string page = page_named(program, "lapfx-draw.1");
    EXPECT_THAT(page, HasSubstr(".PP\nOne line\nand one more:\n.TP\n\\fB.dots\\fR\nare no requests\n"
                                ".RS 4\n.nf\nas it  is\n.fi\n.RE\n"));
    EXPECT_THAT(page, HasSubstr(".SH \"EXAMPLES\"\n.PP\n.RS 4\n.nf\nlapfx draw \\-s 3\n\\&.x\n.fi\n.RE\n"));
}

TEST_F(ManPages, PartsAreOnThePageOfTheirCommand) {
    verb.parts.push_back({.name = "twice", .help = "Draw it again"});
    EXPECT_THAT(page_named(program, "lapfx-draw.1"),
                HasSubstr(".SH \"lapfx draw twice\"\n.SS \"SYNOPSIS\"\n\\fBlapfx draw twice\\fR [OPTIONS]\n"
                          ".SS \"DESCRIPTION\"\nDraw it again.\n"));
}

TEST_F(ManPages, TheProgramsListsThemAndTheExitCodes) {
    const std::string page = page_named(program, "lapfx.1", "It works.\n\nExit codes: 0 done.");
    EXPECT_THAT(page, HasSubstr(".SH NAME\nlapfx \\- What it is for\n"));
    EXPECT_THAT(page, HasSubstr(".PP\nIt works.\n"));
    EXPECT_THAT(page, HasSubstr(".TP\n\\fBlapfx\\-draw\\fR(1)\nDraw a thing\n"));
    EXPECT_THAT(page, HasSubstr(".TP\n\\fBlapfx\\-preset\\fR(5)\n"));
    EXPECT_THAT(page, HasSubstr(".SH \"EXIT STATUS\"\n.PP\n0 done.\n"));
}

TEST_F(ManPages, ATopicHasItsKeys) {
    const std::string page = page_named(program, "lapfx-preset.5");
    EXPECT_THAT(page, HasSubstr(".TH LAPFX\\-PRESET 5 "));
    EXPECT_THAT(page, HasSubstr(".SH \"bleeding\"\n"));
    EXPECT_THAT(page, HasSubstr(".TP\n\\fBspeed\\fR\na number from 0 to 60 mm/s; default "));
    EXPECT_THAT(page, Not(HasSubstr("\n\n"))) << "roff takes an empty line for a request";
}

}  // namespace
}  // namespace lapfx::commands
