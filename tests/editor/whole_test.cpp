// A person's whole work with the editor, driven by the names of the widgets on the screen: load an organ and a clip,
// move the four parameters that matter most, see the picture change, undo, export, and have `lapfx render` make the
// same pixels from the export.
#include <gmock/gmock.h>

#include <array>
#include <cstdlib>
#include <opencv2/imgcodecs.hpp>

#include "app/files/exports.h"
#include "app/preview/target.h"
#include "editor/support/editor_test.h"
#include "output/files.h"
#include "support/folders.h"
#include "support/wait_until.h"

namespace lapfx::test {
namespace {

namespace fs = std::filesystem;

/// One of the four parameters, with its place in the preset panel.
struct Moved {
    const char* path;
    const char* key;
    double to;
    double time;  ///< s, when its effect is visible
};
constexpr std::array<Moved, 4> four = {{
    {"**/Bleeding/Speed", "bleeding.speed", 9, 3},
    {"**/Bleeding/Level extent", "bleeding.max_extent", 5, 11},
    {"**/Bleeding/Noise scale", "bleeding.noise_scale", 1.5, 6},
    {"**/Favourites/Keying: Luma/Low", "smoke.keying.luma_low", 90, 2},
}};

constexpr glm::ivec2 size{640, 512};

class WholeTest : public EditorTest {
  protected:
    WholeTest() { scene_scale = 1; }  // its pictures are compared with exported ones, pixel by pixel
    /// Moves it in the panel; a missing slider fails the test.
    void move(const Moved& moved) {
        ASSERT_TRUE(ui().exists(moved.path)) << moved.path << " is not there\n" << ui().dump();
        ui().click(moved.path, {.clicks = 2}).type(std::to_string(moved.to)).key(ui::Key::enter).frame();
    }
    /// The view's picture with as many pixels as an export has.
    Image view(double time) {
        editor().timeline.seek(time);
        ui().frame();
        app::PreviewHost& preview = editor().preview;
        const glm::ivec2 shown = preview.size();
        preview.resize(size);
        preview.draw(editor().shot());
        Image image = preview.read();
        preview.resize(shown);
        return image;
    }
    static std::size_t unlike(const Image& image, const cv::Mat& file) {
        cv::Mat bgr;
        output::to_bgr(image, bgr);
        if (bgr.size() != file.size() || bgr.type() != file.type()) return bgr.total();
        std::size_t count = 0;
        for (int y = 0; y < bgr.rows; ++y)
            for (int x = 0; x < bgr.cols; ++x) count += bgr.at<cv::Vec3b>(y, x) != file.at<cv::Vec3b>(y, x) ? 1U : 0U;
        return count;
    }
    void run_export(output::OutputKind kind, const fs::path& file, double time) {
        app::Exports& exports = editor().exports();
        exports.propose(kind);
        exports.form.file() = file.string();
        exports.form.size = 5;
        exports.form.at = time;
        ASSERT_TRUE(exports.faults().empty()) << exports.faults().front().text();
        exports.start();
        EXPECT_TRUE(wait_until([&] { return !exports.running(); }, [&] { ui().frame(); }));
        ASSERT_TRUE(fs::exists(file)) << ui().dump();
    }
};

TEST_F(WholeTest, LoadTuneUndoExportAndRenderTheSamePixels) {
    const fs::path data = shipped();
    open_sample();
    editor().timeline.speed = 0;

    // An organ and a clip are loaded as if they were dropped on the window.
    const Image sample = picture(0);
    open({(data / "samples/liver_lobe.glb").string()});
    ui().click("**/Load organ/Load").frame();
    ASSERT_TRUE(editor().preview.ready());
    const Image organ = picture(0);
    EXPECT_GT(differing(sample, organ), 10'000U);
    open({(data / "samples/lagb.scene.json").string()});
    ui().click("**/Discard").frame().frame();  // the organ was a change
    EXPECT_GT(differing(organ, picture(0)), 10'000U);
    open({(data / "samples/clips/wisps_thin.mp4").string()});
    EXPECT_EQ(editor().document.preset().smoke.clips.back().file, "wisps_thin.mp4");
    ui().click("Workspace/tabs/Preset").frame();  // the clips came to the front

    // Each of the four changes the picture, is one step, and undo restores every pixel.
    for (const Moved& moved : four) {
        const Image before = view(moved.time);
        const std::size_t steps = editor().document.done();
        ASSERT_NO_FATAL_FAILURE(move(moved));
        EXPECT_EQ(editor().document.done(), steps + 1) << moved.key;
        EXPECT_GT(differing(before, view(moved.time)), 50U) << moved.key;
        ui().key('Z', ui::Mods::command).frame();
        EXPECT_EQ(differing(before, view(moved.time), 0), 0U) << moved.key;
        ui().key('Z', ui::Mods::command | ui::Mods::shift).frame();
    }

    // The exported picture is the one that the view shows.
    const double time = 6;
    const Image shown = view(time);
    run_export(output::OutputKind::picture, folder() / "shown.png", time);
    EXPECT_EQ(unlike(shown, cv::imread((folder() / "shown.png").string())), 0U);
    run_export(output::OutputKind::bundle, folder() / "whole", time);

    // The program renders the exported bundle without a window.
    const fs::path program = build_folder() / "lapfx";
    ASSERT_TRUE(fs::exists(program));
    const fs::path rendered = folder() / "rendered.png";
    const std::string command = "'" + program.string() + "' render '" + (folder() / "whole/whole.scene.json").string() +
                                "' --size 640x512 --at 6 -o '" + rendered.string() + "' 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(unlike(shown, cv::imread(rendered.string())), 0U);
}

}  // namespace
}  // namespace lapfx::test
