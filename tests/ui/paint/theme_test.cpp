#include "ui/paint/theme.h"

#include <gtest/gtest.h>

namespace lapfx::ui {
namespace {

TEST(Theme, BlackOnWhiteHasTheGreatestContrast) {
    EXPECT_NEAR(contrast(rgb(0x000000), rgb(0xffffff)), 21.0, 1e-9);
    EXPECT_NEAR(contrast(rgb(0x777777), rgb(0xffffff)), 4.48, 0.01);  // the grey that just fails, as WCAG's tables say
}

class EveryTheme : public testing::TestWithParam<const Theme*> {};
INSTANTIATE_TEST_SUITE_P(Theme, EveryTheme, testing::Values(&dark_theme(), &light_theme()),
                         [](const auto& each) { return each.index == 0 ? "dark" : "light"; });

TEST_P(EveryTheme, TextCanBeReadOnEveryGroundItStandsOn) {
    const Theme& t = *GetParam();
    const Color grounds[] = {t.window,  t.panel,         t.raised,         t.field,         t.field_hover,
                             t.control, t.control_hover, t.control_active, t.accent_ground, t.header};
    for (const Color ground : grounds) {
        EXPECT_GE(contrast(t.text, ground), 4.5) << "text";
        EXPECT_GE(contrast(t.text_dim, ground), 4.5) << "dim";
        EXPECT_GE(contrast(t.text_link, ground), 4.5) << "link";
        EXPECT_GE(contrast(t.good, ground), 4.5) << "good";
        EXPECT_GE(contrast(t.warning, ground), 4.5) << "warning";
        EXPECT_GE(contrast(t.error, ground), 4.5) << "error";
    }
    EXPECT_GE(contrast(t.text_on_accent, t.accent), 4.5);
    EXPECT_GE(contrast(t.text_on_accent, t.accent_hover), 4.5);
    for (const Color ground : {t.panel, t.raised, t.field}) EXPECT_GE(contrast(t.focus, ground), 3.0);
}

TEST_P(EveryTheme, WellsAreAsDarkOrLightAsThePanelsAndLinesAreSeenInThem) {
    const Theme& t = *GetParam();
    EXPECT_LT(contrast(t.well, t.panel), 1.5);
    EXPECT_GE(contrast(t.well_ink, t.well), 7.0);
    for (const Color line : t.series) EXPECT_GE(contrast(line, t.well), 3.0) << int(line.r) << ", " << int(line.g);
}

}  // namespace
}  // namespace lapfx::ui
