// In every layout, scale and size of the window no texts overlap, and none is cut so that it cannot be read. A value
// may end in an ellipsis, the label of a button may not.
#include "ui/support/texts.h"
#include <gmock/gmock.h>

#include "app/base/layouts.h"
#include "app/base/settings.h"
#include "editor/support/shaped_test.h"

namespace lapfx::test {
namespace {

using testing::IsEmpty;

constexpr std::array<Shape, 4> shapes = {{{1, {1440, 900}}, {1.5F, {1440, 900}}, {2, {1440, 900}}, {1, {500, 400}}}};

class TextsTest : public ShapedTest {
  protected:
    void expect_readable(const std::string& what) {
        const float em = ui().ui().em(1);
        const auto texts = ui::texts_seen(*ui().output().list, ui::Harness::fonts(), em);
        EXPECT_GE(texts.size(), 10U) << what;
        EXPECT_THAT(ui::texts_over_texts(ui().ui().tree(), texts, em), IsEmpty()) << what;
        EXPECT_THAT(ui::cut_texts(ui().ui().tree(), texts, em), IsEmpty()) << what;
    }
    /// Checks the panels whose tabs are in front, then brings each of the others to the front and checks it.
    void expect_readable_everywhere(const std::string& name) {
        for (const Shape& to : shapes) {
            char text[64];
            std::snprintf(text, sizeof text, " at %.1f, %d x %d", static_cast<double>(to.scale), to.size.x, to.size.y);
            shape(to);
            expect_readable(name + text);
            for (const std::string_view panel : editor().layouts().panels()) {
                if (editor().layouts().seen(panel) || editor().layouts().shown.find(panel) < 0) continue;
                editor().layouts().shown.show(panel);
                ui().frame().frame();
                expect_readable(name + text + ", " + std::string(panel) + " in front");
            }
        }
    }
};

TEST_F(TextsTest, NoneLiesOverAnotherOrIsCut) {
    for (const std::string_view name : {"Tune", "Key", "Compare", "Stage"}) {
        shape(shapes[0]);
        layout(name);
        expect_readable_everywhere(std::string(name));
    }
}

}  // namespace
}  // namespace lapfx::test
