// Tests of the whole editor, without a window: they drive its panels by the names of the widgets on the screen, and its
// preview is drawn with OpenGL.
//
//     TEST_F(PresetPanel, SpeedIsDragged) {
//         open_sample();
//         const Image before = picture(6);
//         ui().drag("**/Bleeding/Speed", {60, 0});
//         EXPECT_GT(editor().document.preset().bleeding.speed, 4.0);
//         EXPECT_GT(differing(before, picture(6)), 100);
//     }
//
// Files of the user are in a folder of the test's own, which is removed at its end.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "app/editor.h"
#include "support/gpu_test.h"
#include "ui/support/harness.h"

namespace lapfx::test {

class EditorTest : public GpuTest {
  protected:
    void SetUp() override;
    void TearDown() override;

    /// What SetUp() gives start(); the constructor of a fixture may say otherwise.
    struct Begins {
        glm::ivec2 window{1440, 900};
        bool exact = true;
        // Of SampleTest:
        bool view = true;                 ///< false: the scene is drawn only where a test asks for pixels
        std::string layout = {};          ///< empty: the usual one
        std::optional<double> time = {};  ///< s; none: the start
    } begins;
    /// Makes a new editor with the same folders of the user, as if the program had been started again.
    void start(glm::ivec2 size = {1440, 900}, bool exact = true);
    void open_sample();  ///< samples/lagb.scene.json, stopped at 0 s
    void open(const std::vector<std::string>& files);
    void layout(std::string_view name);

    std::function<double()> clock;  ///< EditorOptions::clock of the editor that start() makes
    /// EditorOptions::exact_scale of the editor that start() makes: pixels of the scene take most of a test's time
    /// without a GPU, and few tests look at single ones. Those ask for 1 in the constructor of their fixture.
    double scene_scale = 0.2;
    /// EditorOptions::measures_preview of an exact editor that start() makes: few tests of the layout Compare look at
    /// it.
    bool measures_preview = false;
    /// EditorOptions::measured_side of the editor that start() makes: a seventh of the pixels tells the same course.
    int measured_side = 96;
    /// Whether videos that were measured are known to all tests, as they are to all documents of an editor. Those that
    /// look at how one is measured ask for false in the constructor of their fixture.
    bool shares_measured = true;
    /// Whether the editor that start() makes shares the sample's organ with all tests. Those that look at what it holds
    /// ask for false in the constructor of their fixture.
    bool shares_organ = true;

    /// Whether textures and videos of the sample are those that are shipped, or those of a quarter of their width and
    /// height, and of the organ the part that the scene's camera sees (support/light_samples.cpp), which take a
    /// fraction of the time. Tests whose pictures are compared with what `lapfx` makes of the sample ask for true in
    /// the constructor of their fixture.
    bool whole_sample = false;
    std::filesystem::path own_shipped = {};  ///< of the test's own, in place of both; from the next start() on
    std::filesystem::path shipped() const;   ///< the folder of shipped files that these say

    app::Editor& editor() { return *editor_; }
    ui::Harness& ui() { return *ui_; }
    const std::filesystem::path& folder() const { return folder_; }  ///< the test's folder, empty at first
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

/// With the sample scene open in the editor, stopped.
class SampleTest : public EditorTest {
  protected:
    void SetUp() override;
};

}  // namespace lapfx::test
