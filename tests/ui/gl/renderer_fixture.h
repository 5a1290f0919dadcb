// A canvas of 120x90 and a renderer on it, for the tests of the renderer.
#pragma once

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>

#include "support/image_compare.h"
#include "ui/gl/renderer.h"
#include "ui/paint/painter.h"
#include "ui/support/gl_context.h"
#include "ui/support/picture.h"
#include "ui/support/shape_reference.h"

namespace lapfx::ui::test {

inline constexpr Color black{0, 0, 0, 255}, white{255, 255, 255, 255}, red{255, 0, 0, 255}, green{0, 255, 0, 255},
    blue{0, 0, 255, 255};
inline constexpr glm::ivec2 size{120, 90};

class RendererTest : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        if (IsSkipped()) return;
        canvas.emplace(size);
        renderer.emplace();
    }
    /// The picture after drawing onto opaque black.
    Picture drawn(const std::function<void(Painter&)>& draw) {
        painter.start(size);
        draw(painter);
        painter.finish(&images);
        canvas->fill(black);
        renderer->draw(list, fonts, &images, canvas->framebuffer());
        return canvas->read();
    }
    void expect_as_reference(const std::function<void(Painter&)>& draw, int levels) {
        const Picture picture = drawn(draw);
        const lapfx::tests::Comparison result =
            lapfx::tests::compare(reference_picture(list), picture, {.max_difference = levels});
        EXPECT_TRUE(result.passed) << result.reason;
    }

    DrawList list;
    Fonts fonts{{.hinting = Hinting::none}};
    ImageStore images;
    Painter painter{list, fonts, dark_theme(), 1};
    std::optional<Canvas> canvas;
    std::optional<Renderer> renderer;
};

inline const std::vector<std::uint8_t> red_green_blue_white{255, 0, 0,   255, 0,   255, 0,   255,
                                                            0,   0, 255, 255, 255, 255, 255, 255};

/// The rectangle around all pixels that are not black.
inline Rect bounds_of(const Picture& picture) {
    glm::vec2 low(1e6F), high(0);
    for (int y = 0; y < picture.rows; ++y) {
        for (int x = 0; x < picture.cols; ++x) {
            if (at(picture, x, y) == black) continue;
            low = glm::min(low, glm::vec2(x, y));
            high = glm::max(high, glm::vec2(x + 1, y + 1));
        }
    }
    return {low.x, low.y, high.x - low.x, high.y - low.y};
}

}  // namespace lapfx::ui::test
