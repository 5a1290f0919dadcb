#include <gtest/gtest.h>

#include "window/ui_window.h"

namespace lapfx::window {
namespace {

using ui::Key;
using ui::key_of;
using ui::Mods;

TEST(UiKeys, LettersFollowTheLayout) {
    EXPECT_EQ(key_from(GLFW_KEY_Z, "z", true), key_of('Z'));
    EXPECT_EQ(key_from(GLFW_KEY_Y, "z", true), key_of('Z'));  // German: Ctrl+Z is on the key labelled Z
    EXPECT_EQ(key_from(GLFW_KEY_Q, "a", true), key_of('A'));  // French
    EXPECT_EQ(key_from(GLFW_KEY_SLASH, "-", true), key_of('-'));
}

TEST(UiKeys, AnotherScriptHasTheKeysOfAnAmericanKeyboard) {
    EXPECT_EQ(key_from(GLFW_KEY_C, "с", true), key_of('C'));  // Cyrillic
    EXPECT_EQ(key_from(GLFW_KEY_V, nullptr, true), key_of('V'));
    EXPECT_EQ(key_from(GLFW_KEY_SEMICOLON, "ö", true), key_of(';'));
}

TEST(UiKeys, TheRowOfDigitsIsDigitsWhateverIsWrittenOnIt) {
    EXPECT_EQ(key_from(GLFW_KEY_1, "&", true), key_of('1'));
    EXPECT_EQ(key_from(GLFW_KEY_6, "-", true), key_of('6'));
    EXPECT_EQ(key_from(GLFW_KEY_0, "0", true), key_of('0'));
}

TEST(UiKeys, TheNumberBlockGivesDigitsOnlyWithNumLock) {
    EXPECT_EQ(key_from(GLFW_KEY_KP_7, "7", true), key_of('7'));
    EXPECT_EQ(key_from(GLFW_KEY_KP_7, "7", false), Key::home);
    EXPECT_EQ(key_from(GLFW_KEY_KP_4, nullptr, false), Key::left);
    EXPECT_EQ(key_from(GLFW_KEY_KP_5, nullptr, false), Key::none);
    EXPECT_EQ(key_from(GLFW_KEY_KP_DECIMAL, nullptr, true), key_of('.'));
    EXPECT_EQ(key_from(GLFW_KEY_KP_DECIMAL, nullptr, false), Key::del);
    EXPECT_EQ(key_from(GLFW_KEY_KP_ENTER, nullptr, true), Key::enter);
    EXPECT_EQ(key_from(GLFW_KEY_KP_ADD, "+", true), key_of('='));
    EXPECT_EQ(key_from(GLFW_KEY_KP_SUBTRACT, "-", true), key_of('-'));
}

TEST(UiKeys, KeysWithoutLettersHaveNames) {
    EXPECT_EQ(key_from(GLFW_KEY_F1, nullptr, true), Key::f1);
    EXPECT_EQ(key_from(GLFW_KEY_F12, nullptr, true), Key::f12);
    EXPECT_EQ(key_from(GLFW_KEY_F13, nullptr, true), Key::none);
    EXPECT_EQ(key_from(GLFW_KEY_PAGE_DOWN, nullptr, true), Key::page_down);
    EXPECT_EQ(key_from(GLFW_KEY_DELETE, nullptr, true), Key::del);
    EXPECT_EQ(key_from(GLFW_KEY_SPACE, " ", true), Key::space);
    EXPECT_EQ(key_from(GLFW_KEY_UNKNOWN, nullptr, true), Key::none);
    EXPECT_EQ(key_from(GLFW_KEY_PRINT_SCREEN, nullptr, true), Key::none);
}

TEST(UiKeys, AModifierCountsFromTheMomentItGoesDownUntilItIsUp) {
    EXPECT_EQ(mods_from(GLFW_MOD_CONTROL | GLFW_MOD_SHIFT), Mods::command | Mods::shift);
    EXPECT_EQ(mods_from(0, GLFW_KEY_LEFT_SHIFT, true), Mods::shift);
    EXPECT_EQ(mods_from(GLFW_MOD_SHIFT, GLFW_KEY_RIGHT_SHIFT, false), Mods::none);
    EXPECT_EQ(mods_from(GLFW_MOD_ALT, GLFW_KEY_LEFT_CONTROL, true), Mods::alt | Mods::command);
    EXPECT_EQ(mods_from(GLFW_MOD_SUPER | GLFW_MOD_CAPS_LOCK | GLFW_MOD_NUM_LOCK), Mods::none);
}

TEST(UiScale, GoesUpAndDownInStepsAndStopsAtTheEnds) {
    EXPECT_EQ(next_scale(1, 1), 1.125F);
    EXPECT_EQ(next_scale(1, -1), 0.875F);
    EXPECT_EQ(next_scale(1.3F, 1), 1.5F);
    EXPECT_EQ(next_scale(1.3F, -1), 1.25F);
    EXPECT_EQ(next_scale(most_scale, 1), most_scale);
    EXPECT_EQ(next_scale(least_scale, -1), least_scale);
    for (float scale = least_scale; scale < most_scale;) {  // there and back
        const float next = next_scale(scale, 1);
        ASSERT_GT(next, scale);
        EXPECT_EQ(next_scale(next, -1), scale);
        scale = next;
    }
}

TEST(UiScale, IsTheUsersElseTheEnvironmentsElseTheScreens) {
    EXPECT_EQ(choose_scale(1.5F, "2", 1.25F), 1.5F);
    EXPECT_EQ(choose_scale(0, "2", 1.25F), 2);
    EXPECT_EQ(choose_scale(0, nullptr, 1.25F), 1.25F);
    for (const char* wrong : {"", "two", "2x", "-1", "0", "nan", "inf"})
        EXPECT_EQ(choose_scale(0, wrong, 1.25F), 1.25F);
    EXPECT_EQ(choose_scale(0, nullptr, 0), 1);
    EXPECT_EQ(choose_scale(9, nullptr, 1), most_scale);
    EXPECT_EQ(choose_scale(0.1F, nullptr, 1), least_scale);
}

TEST(UiScale, IsChangedByPlusMinusAndZeroOfAnyKeyboard) {
    const Mods ctrl = Mods::command, shifted = Mods::command | Mods::shift;
    EXPECT_EQ(scale_step(key_of('='), "=", ctrl), 1);
    EXPECT_EQ(scale_step(key_of('='), "=", shifted), 1) << "as + is typed on an American keyboard";
    EXPECT_EQ(scale_step(key_from(GLFW_KEY_RIGHT_BRACKET, "+", true), "+", ctrl), 1) << "German";
    EXPECT_EQ(scale_step(key_from(GLFW_KEY_SLASH, "-", true), "-", ctrl), -1) << "German";
    EXPECT_EQ(scale_step(key_of('0'), "0", ctrl), 0);
    EXPECT_EQ(scale_step(key_of('0'), "0", shifted), std::nullopt);
    EXPECT_EQ(scale_step(key_of(']'), "]", ctrl), std::nullopt);
    EXPECT_EQ(scale_step(key_of('='), "=", Mods::none), std::nullopt);
    EXPECT_EQ(scale_step(key_of('='), "=", ctrl | Mods::alt), std::nullopt);
}

TEST(EndlessPointer, GoesOnWhereAMouseIsPutBackToTheMiddle) {
    const glm::dvec2 size(1000, 800);
    EndlessPointer pointer;
    pointer.start({300, 400});
    glm::dvec2 real(300, 400), at = real;
    for (int i = 1; i <= 400; ++i) {
        real.x += 10;
        at = pointer.move(real);
        ASSERT_EQ(at, glm::dvec2(300 + 10 * i, 400));
        if (pointer.put_back(real, size)) real = size / 2.0;
        ASSERT_LT(real.x, 1000);
    }
}

TEST(EndlessPointer, TakesEventsFromBeforeItWasPutBackAsTheyWereMeant) {
    EndlessPointer pointer;
    pointer.start({880, 400});
    EXPECT_EQ(pointer.move({910, 400}).x, 910);
    EXPECT_TRUE(pointer.put_back({910, 400}, {1000, 800}));
    EXPECT_EQ(pointer.move({920, 400}).x, 920) << "was on its way";
    EXPECT_TRUE(pointer.put_back({920, 400}, {1000, 800}));
    EXPECT_EQ(pointer.move({505, 400}).x, 925);
}

TEST(EndlessPointer, FollowsADeviceThatTellsPlacesAndCannotBePutBack) {
    EndlessPointer pointer;
    pointer.start({500, 400});
    for (const double x : {560.0, 640.0, 720.0, 800.0, 880.0, 960.0, 999.0, 999.0, 999.0, 920.0, 840.0, 700.0}) {
        EXPECT_EQ(pointer.move({x, 400}), glm::dvec2(x, 400));
        (void)pointer.put_back({x, 400}, {1000, 800});
    }
}

}  // namespace
}  // namespace lapfx::window
