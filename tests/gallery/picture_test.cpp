// Every page is drawn with OpenGL in both themes. If LAPFX_UI_LOOK names a folder, pictures at three scales are written
// there.
#include <gmock/gmock.h>

#include <cstdlib>
#include <opencv2/core.hpp>

#include "gallery/gallery.h"
#include "ui/gl/renderer.h"
#include "ui/support/gl_context.h"
#include "ui/support/harness.h"
#include "ui/support/picture.h"

namespace lapfx::gallery {
namespace {

class GalleryPicture : public ui::test::GlTest, public testing::WithParamInterface<int> {};
INSTANTIATE_TEST_SUITE_P(Gallery, GalleryPicture, testing::Range(0, static_cast<int>(pages().size())),
                         [](const auto& each) {
                             return std::string(pages()[static_cast<std::size_t>(each.param)].name);
                         });

ui::test::Picture draw(int page, bool light, float scale, ui::RenderStatistics& statistics) {
    ui::ImageStore images;
    State state(images);
    state.page = page;
    state.light = light;
    state.reduced_motion = true;
    state.scale = scale;
    ui::Ui ui(ui::Harness::fonts(), {.images = &images, .shortcuts = &state.commands});
    const glm::ivec2 size(glm::vec2(1280, 800) * std::min(scale, 1.25F));
    const ui::FrameOutput* output = nullptr;
    for (int i = 0; i < 4; ++i)
        output = &ui.frame({.size = size, .scale = scale, .time = i / 60.0}, [&](ui::Ui& u) { build(u, state); });
    ui::test::Canvas canvas(size);
    ui::Renderer renderer;
    renderer.draw(*output->list, ui::Harness::fonts(), &images, canvas.framebuffer());
    statistics = renderer.last();
    return canvas.read();
}

TEST_P(GalleryPicture, HasTheGroundOfItsThemeAndIsDrawnWithFewCalls) {
    const char* folder = std::getenv("LAPFX_UI_LOOK");
    for (const bool light : {false, true}) {
        for (const float scale : {1.0F, 0.75F, 2.0F}) {
            if (folder == nullptr && scale != 1) continue;
            ui::RenderStatistics statistics;
            const ui::test::Picture picture = draw(GetParam(), light, scale, statistics);
            const ui::Color ground = (light ? ui::light_theme() : ui::dark_theme()).panel;
            const cv::Vec4b corner = picture(picture.rows - 3, 12);
            EXPECT_EQ(corner, (cv::Vec4b{ground.r, ground.g, ground.b, 255}));
            EXPECT_LE(statistics.draw_calls, 80);  // one for each picture and one for all between two pictures
            if (folder == nullptr) continue;
            const std::string name(pages()[static_cast<std::size_t>(GetParam())].name);
            ui::test::write_png(picture, std::string(folder) + "/" + name + (light ? "_light_" : "_dark_") +
                                             std::to_string(scale).substr(0, 4) + ".png");
        }
    }
}

/// An overlay that is visible only after a click: its page, the widget to click, the name of the overlay.
struct Opening {
    const char *name, *page, *clicked;
};
class GalleryOpening : public ui::test::GlTest, public testing::WithParamInterface<Opening> {};
INSTANTIATE_TEST_SUITE_P(Gallery, GalleryOpening,
                         testing::Values(Opening{"Menu", "Shell", "**/from a button/More"},
                                         Opening{"Dialog", "Shell", "**/dialogs/New preset"},
                                         Opening{"Question", "Shell", "**/dialogs/Delete"},
                                         Opening{"Files", "Shell", "**/dialogs/Open a file"},
                                         Opening{"Palette", "Shell", "**/dialogs/Palette"},
                                         Opening{"Keys", "Shell", "**/dialogs/Keys"},
                                         Opening{"Toast", "Shell", "**/toasts/Error"},
                                         Opening{"Combo", "Fields", "**/ten thousand/Frame"},
                                         Opening{"Colour", "Fields", "**/enabled/Glass"}),
                         [](const auto& each) { return std::string(each.param.name); });

TEST_P(GalleryOpening, LiesOverThePageAndIsClosedByEsc) {
    const Opening& opening = GetParam();
    for (const bool light : {false, true}) {
        State* shown = nullptr;
        ui::Harness harness(
            [&](ui::Ui& u) {
                if (shown != nullptr) build(u, *shown);
            },
            {1000, 760});
        State state(harness.images());
        shown = &state;
        state.page = page_named(opening.page);
        state.light = light;
        harness.frame().click(opening.clicked).frame(1);
        EXPECT_GT(harness.ui().overlay_count(), 0U) << harness.dump();
        if (const char* folder = std::getenv("LAPFX_UI_LOOK"); folder != nullptr) {
            ui::test::Canvas canvas(harness.size);
            ui::Renderer().draw(*harness.output().list, ui::Harness::fonts(), &harness.images(), canvas.framebuffer());
            ui::test::write_png(canvas.read(),
                                std::string(folder) + "/open_" + opening.name + (light ? "_light" : "_dark") + ".png");
        }
        if (std::string_view(opening.name) == "Toast") continue;  // it stays, and takes no keys
        harness.key(ui::Key::escape).frame();
        EXPECT_EQ(harness.ui().overlay_count(), 0U) << harness.dump();
    }
}

}  // namespace
}  // namespace lapfx::gallery
