// The eyedropper takes a colour of the preset or the scene from the view or from the reference.
#include <glm/gtc/color_space.hpp>
#include <set>

#include "app/base/layouts.h"
#include "app/preview/pick_color.h"
#include "app/preview/seen_colors.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "match/compare/region.h"
#include "ui/core/node.h"

namespace lapfx::test {
namespace {

class EyedropperTest : public SampleTest {
  protected:
    EyedropperTest() { begins.time = 6; }
    /// Starts the eyedropper from the picker of blood's deep colour.
    void begin() {
        layout("Compare");
        ui().click("**/Deep colour/Colour").frame();
        ui().click("**/Pick from a picture").frame();
    }
    /// A picture of red tissue as the reference, all of one colour, and nothing but blood that changes the preview's
    /// colours.
    void plain_look(double haze) {
        editor().document.change("Look", [&](document::Content& c) {
            c.preset.smoke.haze.accumulation = haze;
            c.preset.bleeding.clot_darkening = 0;
        });
        ui().frame().frame();
    }
    /// Picks `color`, as if it had been clicked at `place` of the reference, for the field with that caption.
    /// In a picture of the size of what is compared, divided by `smaller`, which takes less time.
    void pick(const std::string& field, glm::dvec3 color, glm::dvec2 place = {0.5, 0.5}, int smaller = 1) {
        ui().click("**/" + field + "/Colour").frame();
        ui().click("**/Pick from a picture").frame();
        const glm::vec3 code(glm::round(255.0 * color));
        editor().seen_colors().clicked({.shot = editor().reference().comparison().shot(),
                                        .size = editor().reference().comparison().size() / smaller,
                                        .place = place});
        editor().eyedropper.picked = ui::color_of(glm::vec4(code, 255));
        ui().frame().frame();
    }
    /// What the comparison shows now where the last colour was solved for, sRGB.
    glm::dvec3 seen(bool haze = true) {
        const glm::ivec2 size = editor().reference().comparison().size();
        app::PreviewCopy copy;
        copy.target.resize(size);
        app::Shot shot = editor().reference().comparison().shot();
        shot.haze = haze;
        editor().preview.draw_into(copy, shot);
        const Image image = copy.target.read();
        const glm::ivec2 at(editor().seen_colors().last().place * glm::dvec2(size));
        return glm::dvec3(codes(app::color_around(app::ImagePixels(image), size, at))) / 255.0;
    }
    static double apart(const glm::dvec3& a, const glm::dvec3& b) {
        return match::distance({.color = a}, {.color = b});
    }
    std::string notice() { return editor().toasts.log().empty() ? "" : editor().toasts.log().back().text; }
    glm::ivec3 picked() { return glm::ivec3(glm::round(255.0 * editor().seen_colors().last().picked)); }
    glm::ivec3 deep() { return glm::ivec3(glm::round(255.0 * editor().document.preset().bleeding.color_deep)); }
    static glm::ivec3 codes(ui::Color c) { return {c.r, c.g, c.b}; }
};

class Halves : public ui::PickSource {
  public:
    glm::vec4 pixel(glm::ivec2 at) const override { return at.x < 3 ? glm::vec4(0, 0, 0, 255) : glm::vec4(255); }
};

TEST(PickedColor, IsAMeanOfLightOverFivePixels) {
    const Halves halves;
    EXPECT_EQ(app::color_around(halves, {20, 20}, {0, 5}), (ui::Color{0, 0, 0, 255}));
    EXPECT_EQ(app::color_around(halves, {20, 20}, {10, 5}), (ui::Color{255, 255, 255, 255}));
    // Pixels 0 to 4: three black, two white. 40 % of the light is the code value 170, not 102.
    EXPECT_NEAR(app::color_around(halves, {20, 20}, {2, 5}).r, 170, 1);
    EXPECT_NEAR(app::color_around(halves, {4, 20}, {3, 5}).r, 156, 1) << "of what is inside: one of three";
}

/// A colour of single pixels can be shown where the pictures are those that are shipped.
class EyedropperInFull : public EyedropperTest {
  protected:
    EyedropperInFull() { whole_sample = true; }
};

TEST_F(EyedropperInFull, AColourComesFromTheReference) {
    editor().reference().comparison().way = app::CompareWay::reference;
    begin();
    ASSERT_NE(editor().eyedropper.wanted_by, 0U);
    EXPECT_TRUE(ui().exists("Workspace/Reference/Pick a colour/Leave"));
    const std::size_t steps = editor().document.done();
    const glm::ivec3 before = deep();
    const ui::Picture video = editor().reference().shown().whole();
    ui().click("Workspace/Reference/Video").frame();
    EXPECT_EQ(editor().eyedropper.wanted_by, 0U);
    EXPECT_EQ(editor().document.done(), steps + 1) << "one step";
    EXPECT_EQ(editor().document.steps().back().name, "Bleeding: Deep colour");
    const glm::dvec3 there = glm::dvec3(codes(app::color_around(*video.pixels, video.size, video.size / 2))) / 255.0;
    EXPECT_LT(apart(seen(), there), 3.0) << "the middle of the picture: " << notice();
    EXPECT_FALSE(ui().exists("**/Leave"));
    editor().document.undo();
    EXPECT_EQ(deep(), before);
}

TEST_F(EyedropperTest, ThePictureShowsTheColourThatWasPicked) {
    layout("Compare");
    plain_look(0);
    editor().timeline.seek(9);
    for (const glm::dvec3& code : {glm::dvec3(95, 28, 32), glm::dvec3(140, 30, 24), glm::dvec3(112, 20, 30)}) {
        const glm::dvec3 color = code / 255.0;
        const std::size_t steps = editor().document.done();
        pick("Deep colour", color);
        EXPECT_EQ(editor().document.done(), steps + 1);
        EXPECT_TRUE(editor().seen_colors().last().acts);
        EXPECT_LT(apart(seen(), color), 3.0) << notice();
        EXPECT_GT(apart(editor().document.preset().bleeding.color_deep, color), 3.0) << "the light is on top";
    }
    EXPECT_NE(notice().find("so that #70141e is seen"), std::string::npos) << notice();
}

TEST_F(EyedropperTest, WhatCannotBeSeenIsToldAndTheNearestIsTaken) {
    layout("Compare");
    plain_look(0);
    editor().timeline.seek(9);
    const glm::dvec3 blue = glm::dvec3(10, 20, 250) / 255.0;
    pick("Deep colour", blue);
    EXPECT_GT(apart(seen(), blue), 3.0);
    EXPECT_NE(notice().find("#0a14fa cannot be seen"), std::string::npos) << notice();
    EXPECT_GT(deep().b, 200) << "the nearest";
    EXPECT_LT(deep().r, 60);
    editor().timeline.seek(0);  // nothing bleeds
    ui().frame();
    pick("Deep colour", glm::dvec3(95, 28, 32) / 255.0);
    EXPECT_NE(notice().find("nothing shows it at 0.00 s"), std::string::npos) << notice();
    EXPECT_EQ(deep(), glm::ivec3(95, 28, 32));
}

TEST_F(EyedropperTest, APlumeThatPassesChangesNoColourOfBlood) {
    layout("Compare");
    plain_look(0);
    editor().timeline.seek(5.5);  // the second stroke
    const glm::dvec3 red = glm::dvec3(122, 50, 54) / 255.0;
    pick("Thin colour", red, {0.5, 0.5}, 4);
    const glm::dvec3 under_plume = editor().seen_colors().last().color;
    const std::string veil = editor().seen_colors().veil();
    EXPECT_TRUE(veil.empty() || veil == "a plume") << veil;
    editor().document.undo();
    editor().toasts.clear();
    editor().document.change("No plume", [](document::Content& c) { c.preset.smoke.plume.density = 0; });
    ui().frame().frame();
    pick("Thin colour", red, {0.5, 0.5}, 4);
    EXPECT_EQ(editor().seen_colors().last().color, under_plume);
    EXPECT_EQ(editor().seen_colors().veil(), "");
}

/// A picture whose light is `base` and `gain` of the field's.
std::function<Image(const glm::dvec3&)> film(const glm::dvec3& base, double gain) {
    return [=](const glm::dvec3& color) {
        Image image{.width = 20, .height = 20, .pixels = {}, .name = {}};
        const glm::dvec3 light = base + gain * glm::convertSRGBToLinear(color);
        const glm::dvec3 code = glm::round(255.0 * glm::convertLinearToSRGB(glm::clamp(light, 0.0, 1.0)));
        for (int i = 0; i < 400; ++i)
            for (const double c : {code.r, code.g, code.b, 255.0}) image.pixels.push_back(static_cast<std::uint8_t>(c));
        return image;
    };
}

TEST(SolveColor, WhereAColourIsOutOfReachItStaysNearWhatWasPicked) {
    const glm::dvec3 picked = glm::dvec3(104, 5, 4) / 255.0, now = glm::dvec3(150, 30, 30) / 255.0;
    const auto hardly = app::solve_color(picked, now, {}, film({0.2, 0.03, 0.03}, 0.05));
    EXPECT_GT(hardly.off, app::reached_color);
    EXPECT_EQ(hardly.color, picked) << "black would be no nearer to the eye";
    const auto well = app::solve_color(picked, now, {}, film({0.0, 0.0, 0.0}, 0.5));
    EXPECT_LE(well.off, app::reached_color);
    EXPECT_GT(well.color.r, picked.r);
    const auto too_light = app::solve_color(picked, now, {}, film({0.17, 0.002, 0.002}, 2.0));
    EXPECT_GT(too_light.off, app::reached_color);
    EXPECT_LT(too_light.color.r, 0.6 * picked.r) << "here black is much nearer: " << too_light.off;
}

TEST_F(EyedropperTest, UnderHazeItIsSolvedForWithoutHaze) {
    layout("Compare");
    plain_look(0.2);
    editor().timeline.seek(9);
    const glm::dvec3 dark = glm::dvec3(112, 14, 9) / 255.0;  // some light is reflected where it is deep, too
    pick("Deep colour", dark);
    EXPECT_EQ(editor().seen_colors().veil(), "haze");
    EXPECT_LE(apart(seen(false), dark), 3.0) << "without haze: " << notice();
    EXPECT_GT(apart(seen(true), dark), 10.0) << "no colour of the blood comes through";
    EXPECT_EQ(notice().find("Under haze #700e09 cannot be seen"), 0U) << notice();
    EXPECT_NE(notice().find("is seen there without haze (Delta E "), std::string::npos) << notice();
    EXPECT_EQ(editor().toasts.log().back().kind, ui::ToastKind::warning);
    plain_look(0);
    pick("Deep colour", dark);
    EXPECT_EQ(editor().seen_colors().veil(), "") << "what has been left out is told once";
    EXPECT_LE(apart(seen(), dark), 3.0) << notice();
}

TEST_F(EyedropperTest, KeysThatAreTypedInThePickerChooseNoTool) {
    layout("Tune");
    ui().click("**/Deep colour/Colour").frame();
    const auto before = editor().tool.action;
    for (const char c : {'3', '8', 'v', 'A', '4'}) ui().key(ui::key_of(c)).frame();
    EXPECT_EQ(editor().tool.action, before);
    EXPECT_EQ(editor().looking.overlay, Overlay::none);
    ui().type("#8a4a3c").frame();
    EXPECT_EQ(deep(), glm::ivec3(0x8a, 0x4a, 0x3c));
    EXPECT_EQ(editor().tool.action, before);
    ui().key(ui::Key::escape).key(ui::Key::escape).key(ui::Key::escape).frame();
    ui().key(ui::key_of('3')).frame();
    EXPECT_EQ(editor().tool.action, ToolAction::coagulate) << "the picker is closed";
}

TEST_F(EyedropperTest, ALoupeShowsPixelsAndTheColourUnderThePointer) {
    layout("Tune");
    ui().click("**/Deep colour/Colour").frame();
    ui().click("**/Pick from a picture").frame();
    ui().move(ui().node("Workspace/View/Preview").rect().center()).frame();
    const Image image = editor().preview.read();
    const app::ImagePixels pixels(image);
    ASSERT_TRUE(ui().exists("**/Loupe"));
    const glm::ivec2 size(image.width, image.height);
    const auto text_of = [&](glm::vec2 at) {
        const glm::ivec2 pixel(at * glm::vec2(size));
        const ui::Color there = app::color_around(pixels, size, pixel);
        char text[64];
        std::snprintf(text, sizeof text, "#%02x%02x%02x   %d, %d", there.r, there.g, there.b, pixel.x, pixel.y);
        return std::string(text);
    };
    const ui::Rect view = ui().node("Workspace/View/Preview").rect();
    std::set<std::string> texts;
    for (const glm::vec2 at : {glm::vec2(0.5F), glm::vec2(0.35F, 0.45F), glm::vec2(0.6F, 0.3F)}) {
        ui().move(glm::round(view.at() + at * view.size())).frame();
        const glm::vec2 rounded = (glm::round(view.at() + at * view.size()) - view.at()) / view.size();
        EXPECT_EQ(ui().node("**/Loupe").text, text_of(rounded));
        texts.insert(std::string(ui().node("**/Loupe").text.substr(0, 7)));
    }
    EXPECT_EQ(texts.size(), 3U) << "places of different colours";
    EXPECT_EQ(editor().preview.read_back(), 1U) << "all of one picture";
    ui().frame().frame();
    EXPECT_EQ(editor().preview.read_back(), 1U);
    editor().timeline.seek(7);
    ui().frame().frame();
    EXPECT_EQ(editor().preview.read_back(), 2U) << "another picture";
    EXPECT_EQ(ui().node("**/Loupe").text.substr(0, 1), "#");
    ui().key(ui::Key::escape).frame();
    EXPECT_FALSE(ui().exists("**/Loupe"));
    editor().reference().comparison().way = app::CompareWay::reference;
    begin();
    ui().move(ui().node("Workspace/Reference/Video").rect().center()).frame();
    EXPECT_EQ(editor().eyedropper.wanted_by != 0, true);
}

/// The box with a magnifier, px of the window; empty: none.
ui::Rect loupe_of(const ui::FrameOutput& output, const ui::Ui& ui) {
    const ui::DrawList& list = *output.list;
    const float side = ui.em(0.55F);  // of a magnified pixel; there are 11
    ui::Rect found;
    ui::Instance box{};  // is drawn just before its glass
    for (const ui::Instance& i : list.instances) {
        if (i.kind != ui::InstanceKind::fill) continue;
        if (std::abs(i.w - 11 * side) < 1 && std::abs(i.h - 11 * side) < 1) found = {box.x, box.y, box.w, box.h};
        box = i;
    }
    return found;
}

TEST_F(EyedropperTest, TheLoupeAndTheBoxThatSaysWhatToDoNeverOverlap) {
    for (const glm::ivec2 window : {glm::ivec2(1440, 900), glm::ivec2(800, 600)})
        for (const std::string panel : {"View/Preview", "Reference/Comparison", "Reference/Video"}) {
            const bool alone = panel == "Reference/Video";
            editor().reference().comparison().way = alone ? app::CompareWay::reference : app::CompareWay::beside;
            ui().size = window;
            layout("Compare");
            ui().frame().frame();
            editor().eyedropper = {.wanted_by = 1, .picked = {}};
            editor().layouts().shown.show(panel.substr(0, panel.find('/')));
            ui().frame().frame();
            const std::string path = "Workspace/" + panel;
            const ui::Rect picture = ui().node(path).rect();
            const ui::Rect hint = ui().rect("Workspace/" + panel.substr(0, panel.find('/')) + "/Pick a colour");
            int looked = 0;
            for (const glm::vec2 at : {glm::vec2(0.02F, 0.02F),
                                       {0.98F, 0.02F},
                                       {0.02F, 0.98F},
                                       {0.98F, 0.98F},
                                       {0.5F, 0.5F},
                                       {0.3F, 0.7F},
                                       {0.5F, 0.75F},
                                       {0.5F, 0.05F},
                                       {0.4F, 0.5F},
                                       {0.1F, 0.6F},
                                       {0.9F, 0.4F},
                                       {0.7F, 0.6F},
                                       {0.25F, 0.65F}}) {
                ui().move(picture.at() + at * picture.size()).frame().frame();
                editor().eyedropper = {.wanted_by = 1, .picked = {}};
                ui().frame();
                const std::string where = panel + " at " + std::to_string(at.x) + ", " + std::to_string(at.y) + " of " +
                                          std::to_string(window.x);
                if (hint.contains(picture.at() + at * picture.size())) continue;
                const bool on_picture = panel == "View/Preview" || !ui().node(path).text.empty();
                if (!on_picture) continue;  // beside a picture that is narrower than its panel
                ++looked;
                const ui::Rect loupe = loupe_of(ui().output(), ui().ui());
                EXPECT_GT(loupe.w * loupe.h, 5000.0F) << where;
                EXPECT_FALSE(loupe.overlaps(hint)) << where;
                EXPECT_EQ(intersect(loupe, picture), loupe) << where << ": it is seen whole";
            }
            EXPECT_GE(looked, 4) << panel;
        }
}

TEST_F(EyedropperTest, AlsoOfThinBloodOfHazeAndOfTheOrgan) {
    layout("Compare");
    plain_look(0);
    editor().timeline.seek(9);
    pick("Thin colour", glm::dvec3(150, 60, 65) / 255.0);
    EXPECT_LT(apart(seen(), glm::dvec3(150, 60, 65) / 255.0), 3.0) << notice();
    plain_look(0.1);
    ui().click("Workspace/Preset/Parameters/Haze/header").frame();
    pick("Haze/Colour", glm::dvec3(150, 140, 150) / 255.0);
    EXPECT_LT(apart(seen(), glm::dvec3(150, 140, 150) / 255.0), 3.0) << notice();
    plain_look(0);
    editor().timeline.seek(0);
    editor().layouts().bring_to_front("Scene");
    ui().frame();
    pick("Organ/Colour", glm::dvec3(120, 70, 60) / 255.0);
    EXPECT_LT(apart(seen(), glm::dvec3(120, 70, 60) / 255.0), 3.0) << notice();
}

TEST_F(EyedropperTest, OrFromWhicheverOfBothIsUnderThePointer) {
    editor().reference().comparison().way = app::CompareWay::wipe;
    begin();
    ui().frame().frame();
    const ui::Picture preview = editor().reference().comparison().preview();
    const ui::Picture video = editor().reference().comparison().reference();
    ASSERT_NE(preview.pixels, nullptr);
    const double line = editor().reference().comparison().state.position;
    ui().click("Workspace/Reference/Comparison", {.at = {0.4F, 0.5F}}).frame();
    const glm::ivec3 first = picked();
    EXPECT_EQ(editor().eyedropper.wanted_by, 0U);
    begin();
    ui().click("Workspace/Reference/Comparison", {.at = {0.6F, 0.5F}}).frame();
    const glm::ivec3 second = picked();
    EXPECT_NE(first, second);
    EXPECT_EQ(editor().reference().comparison().state.position, line) << "the line stays";
    const auto nearest = [](const ui::Picture& picture, const glm::ivec3& color) {
        double least = 1e9;
        const int y = picture.size.y / 2;
        for (int x = 0; x < picture.size.x; ++x)
            least = std::min(
                least,
                glm::length(glm::dvec3(codes(app::color_around(*picture.pixels, picture.size, {x, y})) - color)));
        return least;
    };
    EXPECT_LT(nearest(preview, first), 8.0);
    EXPECT_LT(nearest(video, second), 8.0);
}

TEST_F(EyedropperTest, OrFromTheView) {
    layout("Tune");
    const Image image = editor().preview.read();
    ui().click("**/Deep colour/Colour").frame();
    ui().click("**/Pick from a picture").frame();
    editor().tool.action = ToolAction::cauterise;
    const std::size_t events = editor().document.scene().events.size();
    const std::size_t steps = editor().document.done();
    ui().click("Workspace/View/Preview", {.at = {0.5F, 0.4F}}).frame();
    EXPECT_EQ(editor().document.scene().events.size(), events) << "the tool rests meanwhile";
    EXPECT_EQ(editor().document.done(), steps + 1);
    const app::ImagePixels pixels(image);
    const glm::ivec2 size(image.width, image.height);
    const ui::Color there = app::color_around(pixels, size, glm::ivec2(glm::vec2(size) * glm::vec2(0.5F, 0.4F)));
    EXPECT_LE(glm::length(glm::dvec3(picked() - codes(there))), 6.0);
}

TEST_F(EyedropperTest, EscapeLeavesItAndAFieldThatIsGoneTakesNothing) {
    begin();
    const std::size_t steps = editor().document.done();
    ui().key(ui::Key::escape).frame();
    EXPECT_EQ(editor().eyedropper.wanted_by, 0U);
    ui().click("**/Comparison").frame();
    EXPECT_EQ(editor().document.done(), steps);
    begin();
    layout("Key");  // shows no preset panel
    ui().click("Workspace/View/Preview").frame().frame().frame();
    EXPECT_EQ(editor().eyedropper.wanted_by, 0U);
    EXPECT_EQ(editor().document.done(), steps);
}

TEST_F(EyedropperTest, TheKeyColourIsPickedInTheKeyingPanelAlone) {
    layout("Tune");
    ui().click("Workspace/Preset/Parameters/Keying/header").frame();
    ui().click("**/Key colour/Colour").frame();
    EXPECT_TRUE(ui().exists("**/Hue"));
    EXPECT_FALSE(ui().exists("**/Pick from a picture"));
}

}  // namespace
}  // namespace lapfx::test
