// Tests of the whole editor: its panels driven by the names of what is on the screen, its preview drawn with OpenGL, no
// window.
//
//     TEST_F(PresetPanel, SpeedIsDragged) {
//         open_sample();
//         const Image before = picture(6);
//         ui().drag("**/Bleeding/Speed", {60, 0});
//         EXPECT_GT(editor().document.preset().bleeding.speed, 4.0);
//         EXPECT_GT(differing(before, picture(6)), 100);
//     }
//
// Files of the user lie in a folder of the test's own, which goes with it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>

#include "app/editor.h"
#include "support/gpu_test.h"
#include "ui/support/harness.h"

namespace lapfx::test {

class EditorTest : public GpuTest {
  protected:
    void SetUp() override;
    void TearDown() override;

    /// A new one, as if the program had been started again: with the same folders of the user.
    void start(glm::ivec2 size = {1440, 900}, bool exact = true);
    void open_sample();  ///< samples/lagb.scene.json, standing at 0 s
    void open(const std::vector<std::string>& files);
    void layout(std::string_view name);

    std::function<double()> clock;  ///< of the editor that start() makes: EditorOptions::clock

    app::Editor& editor() { return *editor_; }
    ui::Harness& ui() { return *ui_; }
    const std::filesystem::path& folder() const { return folder_; }  ///< of the test, empty at first
    /// The preview at `time` s, as the view panel shows it.
    Image picture(double time);
    /// Pixels that differ by more than `tolerance` code values in any channel; all if the sizes differ.
    static std::size_t differing(const Image& a, const Image& b, int tolerance = 8);

  private:
    std::filesystem::path folder_;
    ui::ImageStore images_;
    std::unique_ptr<app::Editor> editor_;
    std::unique_ptr<ui::Harness> ui_;
};

}  // namespace lapfx::test
