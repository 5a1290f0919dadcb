// The reference moved, scaled and turned under the preview: as a picture, by handles, by numbers, by the endoscope's
// circle.
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "app/files/autosave.h"
#include "app/files/files.h"
#include "app/reference/placed_picture.h"
#include "app/reference/reference.h"
#include "editor/support/editor_test.h"
#include "match/compare/region.h"
#include "support/endoscope.h"

namespace lapfx::test {
namespace {

using app::on_the_vignette;

Image picture_of(const cv::Mat& rgba) {
    Image image{.width = rgba.cols, .height = rgba.rows, .pixels = {}, .name = ""};
    image.pixels.assign(rgba.data, rgba.data + rgba.total() * 4);
    return image;
}
int red(const Image& image, int x, int y) {
    return image.pixels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x))];
}

TEST(PlacedPicture, IsMovedScaledAndTurnedAboutItsMiddle) {
    cv::Mat dots(100, 200, CV_8UC4, cv::Scalar(40, 40, 40, 255));
    cv::rectangle(dots, {145, 45}, {155, 55}, cv::Scalar(240, 240, 240, 255), cv::FILLED);  // 0.5 right of the middle
    const Image image = picture_of(dots);
    const Image moved = placed(image, {.right = 0.2, .up = 0.1}, 2);
    EXPECT_EQ(red(moved, 170, 40), 240);
    EXPECT_EQ(red(moved, 150, 60), 40);
    EXPECT_EQ(red(moved, 5, 40), 0) << "black where the reference has nothing";
    EXPECT_EQ(moved.pixels[4 * (40 * 200 + 5) + 3], 0) << "and clear: the view is seen beneath";
    EXPECT_EQ(moved.pixels[4 * (40 * 200 + 170) + 3], 255);
    const Image small = placed(image, {.scale = 0.5}, 2);
    EXPECT_EQ(red(small, 125, 50), 240);
    EXPECT_EQ(red(small, 140, 50), 40);
    EXPECT_EQ(red(small, 170, 50), 0);
    const Image turned = placed(image, {.scale = 0.5, .rotation = 90}, 2);
    EXPECT_EQ(red(turned, 100, 25), 240) << "counter-clockwise";
    // Lengths of a picture that is stored squeezed are those that are seen.
    const Image squeezed = placed(image, {.scale = 0.5, .rotation = 90}, 1);
    EXPECT_EQ(red(squeezed, 100, 37), 240);
    EXPECT_EQ(red(placed(image, {}, 2), 150, 50), 240);
}

TEST(PlacedPicture, TheRoundViewComesToLieOnTheVignette) {
    cv::Mat view(240, 320, CV_8UC4, cv::Scalar(0, 0, 0, 255));
    cv::circle(view, {140, 125}, 90, cv::Scalar(170, 90, 80, 255), cv::FILLED);
    for (const double rotation : {0.0, 30.0}) {
        const auto found = on_the_vignette(picture_of(view), {.rotation = rotation});
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->scale, 0.562 * 240 / 90.5, 0.01);
        EXPECT_EQ(found->rotation, rotation);
        const glm::dvec2 middle = placed(*found, 320.0 / 240, glm::dvec2(140.5, 125.5) / 240.0);
        EXPECT_NEAR(middle.x, 320.0 / 480, 0.01);
        EXPECT_NEAR(middle.y, 0.5, 0.01);
    }
    EXPECT_FALSE(on_the_vignette(picture_of(cv::Mat(240, 320, CV_8UC4, cv::Scalar(170, 90, 80, 255))), {}));
}

class Placement : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        if (IsSkipped()) return;
        open_sample();
        editor().reference().choose_sample();
        layout("Compare");
        ui().frame().frame();
    }
    const ReferencePlacement& placement() { return editor().document.scene().reference.placement; }
    glm::vec4 middle_of_reference() {
        const ui::Picture picture = editor().reference().comparison().reference();
        return picture.pixels->pixel(picture.size / 2);
    }
};

TEST_F(Placement, IsTypedSeenUndoneAndReset) {
    EXPECT_FALSE(ui().exists("**/Reference/Right"));
    ui().click("**/Reference/Move reference").frame();
    const glm::vec4 before = middle_of_reference();
    const ui::ImageHandle stored = editor().reference().comparison().reference().image;
    ui().click("**/Reference/Right", {.clicks = 2}).type("1.9").key(ui::Key::enter).frame().frame();
    EXPECT_DOUBLE_EQ(placement().right, 1.9);
    EXPECT_NE(editor().reference().comparison().reference().image, stored);
    EXPECT_EQ(middle_of_reference(), glm::vec4(0)) << "it has moved out of the middle";
    EXPECT_NE(editor().reference().shown().placed().image, editor().reference().shown().whole().image)
        << "as an underlay";
    editor().document.undo();
    ui().frame().frame();
    EXPECT_EQ(middle_of_reference(), before);
    ui().click("**/Reference/Scale", {.clicks = 2}).type("2").key(ui::Key::enter).frame();
    EXPECT_DOUBLE_EQ(placement().scale, 2);
    ui().click("**/Reference/Reset").frame();
    EXPECT_FALSE(placement().moved());
}

TEST_F(Placement, IsDraggedInThePicture) {
    editor().reference().comparison().placing = true;
    ui().frame().frame();
    const std::size_t steps = editor().document.done();
    ui().drag("**/First/Reference's middle", {40, -20});
    EXPECT_GT(placement().right, 0.02);
    EXPECT_GT(placement().up, 0.01);
    EXPECT_EQ(editor().document.done(), steps + 1) << "one gesture is one step";
    ui().frame().drag("**/First/Reference's side", {0, -60});
    EXPECT_GT(placement().rotation, 3);
    EXPECT_GT(placement().scale, 1);
    EXPECT_EQ(editor().document.done(), steps + 2);
}

/// What the comparison shows of the reference where the region lies, linear mean as the regions have it.
glm::dvec3 seen_in(const ui::Picture& picture, const ComparedRegion& region) {
    Image copy{.width = picture.size.x, .height = picture.size.y, .pixels = {}, .name = ""};
    for (int y = 0; y < copy.height; ++y)
        for (int x = 0; x < copy.width; ++x) {
            const glm::vec4 pixel = picture.pixels->pixel({x, y});
            for (int c = 0; c < 4; ++c) copy.pixels.push_back(static_cast<std::uint8_t>(pixel[c]));
        }
    return match::figures_of(copy, region, {}).color;
}

TEST_F(Placement, RegionsAndScopesReadWhatIsSeen) {
    const ComparedRegion region{.x = 0.1, .y = 0.1, .width = 0.15, .height = 0.2};
    editor().document.change("Region", [&](document::Content& c) { c.scene.reference.regions = {region}; });
    app::Reference& reference = editor().reference();
    reference.comparison().scopes_look.on = true;
    reference.comparison().scopes_look.kind = app::ScopesLook::regions;
    ui().frame().frame().frame();
    const auto counted = [&] { return reference.comparison().regions().now(1, 0).color; };
    const auto apart = [](const glm::dvec3& a, const glm::dvec3& b) {
        return match::distance({.color = a}, {.color = b});
    };
    const auto samples = [&] {
        std::vector<double> frames, values;
        reference.comparison().regions().curve(1, 0, app::RegionFigure::brightness, frames, values);
        return frames.size();
    };
    const glm::dvec3 stored = counted();
    EXPECT_LT(apart(stored, seen_in(reference.comparison().reference(), region)), 0.5);
    editor().timeline.seek(2);
    ui().frame().frame();
    EXPECT_EQ(samples(), 2U);
    editor().timeline.seek(0);
    ui().frame().frame();
    const auto place = [&](const ReferencePlacement& placement) {
        editor().document.change("Place", [&](document::Content& c) { c.scene.reference.placement = placement; });
        ui().frame().frame().frame();
    };
    place({.right = 0.1, .up = -0.2, .scale = 2, .rotation = 170});
    EXPECT_GT(apart(counted(), stored), 1) << "other tissue lies there";
    EXPECT_LT(apart(counted(), seen_in(reference.comparison().reference(), region)), 0.5);
    EXPECT_EQ(samples(), 1U) << "the curve was of what lay there before";
    place({.right = 1.9});
    EXPECT_EQ(counted(), glm::dvec3(0)) << "nothing of it is there";
    // The reference alone is the video as it is stored.
    reference.comparison().way = app::CompareWay::reference;
    ui().frame().frame().frame();
    EXPECT_LT(apart(counted(), stored), 0.5);
    reference.comparison().way = app::CompareWay::beside;
    ui().frame().frame();
    place({});
    EXPECT_LT(apart(counted(), stored), 1e-9);
}

TEST_F(Placement, IsNudgedByArrows) {
    editor().reference().comparison().placing = true;
    ui().frame().frame();
    const double height = editor().reference().comparison().size().y;
    ui().focus("**/First/Reference's middle").key(ui::Key::right).frame();
    EXPECT_NEAR(placement().right, 1 / height, 1e-3) << "a pixel";
    ui().key(ui::Key::up).frame();
    EXPECT_NEAR(placement().up, 1 / height, 1e-3);
    ui().key(ui::Key::del).frame();
    EXPECT_FALSE(placement().moved());
    editor().document.undo();
    EXPECT_TRUE(placement().moved());
}

TEST_F(Placement, OutlivesACrash) {
    editor().document.change("Place", [](document::Content& c) {
        c.scene.reference.placement = {0.25, -0.1, 1.5, 30};
    });
    editor().autosave().update(1000);
    editor().autosave().update(1000 + app::Autosave::pause);
    start();
    editor().autosave().find();
    ASSERT_EQ(editor().autosave().offers().size(), 1U);
    editor().files().recover(0);
    ui().frame();
    EXPECT_EQ(placement().right, 0.25);
    EXPECT_EQ(placement().up, -0.1);
    EXPECT_EQ(placement().scale, 1.5);
    EXPECT_EQ(placement().rotation, 30);
}

/// Brightness on a ray from the middle of what is compared, from 0.4 to 0.7 heights: where it falls to half, px.
double rim_on(const ui::Picture& picture, glm::dvec2 way) {
    const double height = picture.size.y;
    const auto bright = [&](double r) {
        const glm::vec4 p =
            picture.pixels->pixel(glm::ivec2(glm::floor(glm::dvec2(picture.size) / 2.0 + r * height * way)));
        return std::max({p.r, p.g, p.b});
    };
    for (double r = 0.7; r > 0.4; r -= 0.25 / height)
        if (bright(r) > 60) return r * height;
    return 0;
}

TEST_F(Placement, TheCircleComesToLieOnThePreviews) {
    cv::Mat view(480, 854, CV_8UC4, cv::Scalar(0, 0, 0, 255));
    cv::circle(view, {400, 250}, 230, cv::Scalar(120, 120, 120, 255), cv::FILLED, cv::LINE_AA);
    write_picture(folder() / "round.png", picture_of(view));
    editor().reference().choose(folder() / "round.png");
    ui().frame().frame();
    editor().commands.run("reference.take_circle");
    ui().frame().frame();
    ASSERT_TRUE(placement().moved());
    EXPECT_EQ(editor().document.scene().camera.vignette, 1);
    EXPECT_EQ(editor().document.steps().back().name, "Take the circle");
    const ui::Picture seen = editor().reference().comparison().reference();
    for (const glm::dvec2 way : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0.8, 0.6), glm::dvec2(-0.8, -0.6)})
        EXPECT_NEAR(rim_on(seen, way), 0.562 * seen.size.y, 1.5) << way.x << ' ' << way.y;
    // Again where it lies already: nothing moves.
    const ReferencePlacement before = placement();
    editor().commands.run("reference.take_circle");
    EXPECT_EQ(placement().scale, before.scale);
    EXPECT_EQ(placement().right, before.right);
    // A video that is stored squeezed gets its aspect with it, and lies right.
    cv::resize(view, view, {480, 480}, 0, 0, cv::INTER_AREA);
    write_picture(folder() / "squeezed.png", picture_of(view));
    editor().reference().choose(folder() / "squeezed.png");
    ui().frame().frame();
    const std::size_t steps = editor().document.done();
    editor().commands.run("reference.take_circle");
    EXPECT_EQ(editor().document.done(), steps + 1);
    EXPECT_NEAR(editor().document.scene().reference.aspect, 16.0 / 9, 1e-4);
    EXPECT_NEAR(placement().scale, before.scale, 0.01);
    EXPECT_NEAR(placement().right, before.right, 0.005);
    EXPECT_NEAR(placement().up, before.up, 0.005);
    ASSERT_EQ(editor().reference().look().notes().size(), 2U);
    editor().document.change("Else", [](document::Content& c) { c.scene.duration += 1; });
    ui().frame();
    EXPECT_EQ(editor().reference().look().notes().size(), 2U);
    editor().document.undo();
    editor().document.undo();
    ui().frame();
    EXPECT_TRUE(editor().reference().look().notes().empty()) << "it does not lie there any more";
}

class ProposedAspect : public Placement {
  protected:
    /// A round view, stored in 256 x 256.
    std::filesystem::path squeezed(const std::string& name, double aspect) {
        const glm::ivec2 shown(static_cast<int>(std::lround(480 * aspect)), 480);
        const Image seen = behind_round_view(tissue_picture(shown), glm::dvec2(shown) / 2.0, 216);
        cv::Mat4b pixels(seen.height, seen.width,
                         reinterpret_cast<cv::Vec4b*>(const_cast<std::uint8_t*>(seen.pixels.data())));
        cv::resize(pixels, pixels, {256, 256}, 0, 0, cv::INTER_AREA);
        write_picture(folder() / name, picture_of(pixels));
        return folder() / name;
    }
    void choose(const std::filesystem::path& file) {
        editor().reference().choose(file);
        ui().frame().frame().frame();
    }
    app::Reference& reference() { return editor().reference(); }
    double aspect() { return editor().document.scene().reference.aspect; }
};

TEST_F(ProposedAspect, IsThatOfASqueezedVideoAndStaysWithTheScene) {
    choose(squeezed("wide.png", 16.0 / 9));
    ASSERT_TRUE(reference().look().proposed_aspect());
    EXPECT_NEAR(*reference().look().proposed_aspect(), 16.0 / 9, 1e-4);
    EXPECT_EQ(aspect(), 0) << "it is proposed";
    EXPECT_NE(ui().dump().find("shown at 16:9 it is round"), std::string::npos) << ui().dump();
    ui().click("**/Reference/Use 16:9").frame().frame();
    EXPECT_NEAR(aspect(), 16.0 / 9, 1e-4);
    EXPECT_FALSE(reference().look().proposed_aspect());
    EXPECT_FALSE(ui().exists("**/Reference/Use 16:9"));
    const glm::ivec2 size = reference().comparison().size();
    EXPECT_NEAR(static_cast<double>(size.x) / size.y, 16.0 / 9, 0.01);
    choose(folder() / "wide.png");
    EXPECT_NEAR(aspect(), 16.0 / 9, 1e-4) << "the same file is stored as it was";
    choose(squeezed("other.png", 4.0 / 3));
    EXPECT_EQ(aspect(), 0);
    ASSERT_TRUE(reference().look().proposed_aspect());
    EXPECT_NEAR(*reference().look().proposed_aspect(), 4.0 / 3, 1e-3);
    editor().document.change("By hand", [](document::Content& c) { c.scene.reference.aspect = 1.5; });
    ui().frame();
    EXPECT_FALSE(reference().look().proposed_aspect());
}

TEST_F(ProposedAspect, IsLeftAndIsNoneWhereNothingIsSqueezed) {
    choose(squeezed("wide.png", 16.0 / 9));
    const std::size_t steps = editor().document.done();
    ui().click("**/Reference/Leave as stored").frame();
    EXPECT_FALSE(reference().look().proposed_aspect());
    editor().timeline.seek(1);
    ui().frame().frame();
    EXPECT_FALSE(reference().look().proposed_aspect()) << "nor with another frame";
    EXPECT_EQ(editor().document.done(), steps);
    choose(squeezed("round.png", 1));
    EXPECT_FALSE(reference().look().proposed_aspect());
    write_picture(folder() / "all.png", tissue_picture({256, 256}));
    choose(folder() / "all.png");
    EXPECT_FALSE(reference().look().proposed_aspect());
}

TEST_F(Placement, TheCircleOfTheSampleIsTaken) {
    editor().commands.run("reference.take_circle");
    ui().frame();
    ASSERT_FALSE(editor().reference().look().notes().empty());
    if (placement().moved()) {
        EXPECT_EQ(editor().document.scene().camera.vignette, 1);
        EXPECT_EQ(editor().document.steps().back().name, "Take the circle");
    } else {
        EXPECT_NE(editor().reference().look().notes().front().find("no round view"), std::string::npos);
    }
}

}  // namespace
}  // namespace lapfx::test
