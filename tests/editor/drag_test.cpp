// The cost of dragging one slider must not depend on how large the document is.
#include <gtest/gtest.h>

#include "editor/support/editor_test.h"
#include "ui/support/count_allocations.h"

namespace lapfx::test {

class Drag : public EditorTest {
  protected:
    /// Bytes that are allocated while the pointer moves a slider of the preset, without those for drawing the scene.
    std::size_t bytes_of_a_drag() {
        constexpr std::string_view slider = "**/Bleeding/Gloss";
        ui().settle();
        ui().around([this](double now, const std::function<void()>& build) {
            editor().frame(now, build, {.after = [this](app::FrameStep step) {
                               if (step == app::FrameStep::followed) begin_ = allocated_bytes_so_far();
                               if (step == app::FrameStep::drawn) drawing_ += allocated_bytes_so_far() - begin_;
                           }});
        });
        const glm::vec2 at = ui().rect(slider).center();
        ui().press(slider);
        const auto move = [&](int count) {
            for (int i = 0; i < count; ++i) ui().move(at + glm::vec2(i % 2 == 0 ? 5 : -5, 0));
        };
        move(10);  // after this, memory that is kept from frame to frame has been allocated
        const std::uint64_t version = editor().document.version();
        const std::size_t before = allocated_bytes_so_far() - drawing_;
        move(10);
        const std::size_t bytes = allocated_bytes_so_far() - drawing_ - before;
        EXPECT_GE(editor().document.version(), version + 10) << "the slider moves";
        ui().release();
        EXPECT_EQ(editor().document.steps().back().name, "Bleeding: Gloss");
        return bytes;
    }

  private:
    std::size_t begin_ = 0, drawing_ = 0;  ///< bytes when drawing of the scene began; bytes of all drawing so far
};

TEST_F(Drag, AllocatesNoMoreInALargeDocument) {
    open_sample();
    const std::size_t small = bytes_of_a_drag();
    document::Content large = editor().document.content();
    ASSERT_FALSE(large.preset.smoke.clips.empty());
    large.preset.smoke.clips.resize(12, large.preset.smoke.clips.front());
    // These events are many, but have no effect: they are too far away to touch the organ.
    for (int i = 0; i < 4000; ++i)
        large.scene.events.push_back({.action = ToolAction::cauterise,
                                      .time = 0.002 * i,
                                      .duration = 0.001,
                                      .position = {1e3, 1e3, i},
                                      .to = {1e3, 1e3, i}});
    start();
    editor().document.open(std::move(large));
    ui().frame().frame();
    EXPECT_EQ(bytes_of_a_drag(), small);
}

}  // namespace lapfx::test
