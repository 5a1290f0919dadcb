#include "ui/core/paragraph.h"

#include "ui/support/count_allocations.h"
#include "ui/support/harness.h"

namespace lapfx::ui {
namespace {

const TextStyle style{.size = 14};

TEST(Paragraph, ItsHeightIsThatOfItsLines) {
    Fonts& fonts = Harness::fonts();
    const float line = fonts.metrics(style).height, width = fonts.run("hello world", style).width + 2;
    EXPECT_EQ(paragraph_height(fonts, "", style, width), line);
    EXPECT_EQ(paragraph_height(fonts, "hello world", style, width), line);
    EXPECT_EQ(paragraph_height(fonts, "hello world again", style, width), 2 * line);
    EXPECT_EQ(paragraph_height(fonts, "hello\n\nworld\n", style, width), 4 * line);
}

TEST(Paragraph, InItsOwnWidthNothingIsBroken) {
    Fonts& fonts = Harness::fonts();
    for (const std::string_view text : {"AVAVAVAVAV To. We. Te", "office affinity", "To\nfrom somewhere else"}) {
        const float width = paragraph_width(fonts, text, style);
        const auto lines = static_cast<float>(1 + std::count(text.begin(), text.end(), '\n'));
        EXPECT_EQ(paragraph_height(fonts, text, style, width), lines * fonts.metrics(style).height) << text;
    }
}

TEST(Paragraph, NothingLongerThanALineIsShaped) {
    Fonts fonts;
    std::string text;
    for (int i = 0; i < 4000; ++i) text += "word " + std::to_string(i) + ' ';
    fonts.next_frame();
    const std::size_t before = test::allocations_so_far();
    const float height = paragraph_height(fonts, text, style, 200);
    EXPECT_GT(height, 1000 * fonts.metrics(style).height);
    EXPECT_LT(test::allocations_so_far() - before, 2000U) << "only single characters";
}

TEST(Paragraph, AllOfItIsDrawn) {
    Fonts& fonts = Harness::fonts();
    DrawList list;
    Painter painter(list, fonts, dark_theme(), 1);
    painter.start({400, 400});
    draw_paragraph(painter, {0, 0, 60, 200}, "alpha beta gamma\ndelta", style, {255, 255, 255, 255});
    painter.finish(nullptr);
    std::size_t glyphs = 0;
    for (std::size_t i = 0; i < list.instances.size(); ++i) glyphs += list.instances[i].kind == InstanceKind::glyph;
    EXPECT_EQ(glyphs, std::string_view("alphabetagammadelta").size()) << "nothing is cut with an ellipsis";
}

}  // namespace
}  // namespace lapfx::ui
