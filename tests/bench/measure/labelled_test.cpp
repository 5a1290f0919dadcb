#include "bench/measure/labelled.h"

#include <gmock/gmock.h>

#include <fstream>

#include "bench/scratch_folder.h"
#include "lapfx/error.h"
#include "output/files.h"

namespace lapfx::bench {
namespace {

constexpr int width = 64, height = 48;

/// Tissue, and so many white columns at its left.
Image picture(int white, bool label, int across = width) {
    Image image{.width = across, .height = height, .pixels = {}, .name = ""};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < across; ++x) {
            const bool in = x < white;
            const int value = label ? (in ? 255 : 0) : 150 + (7 * x + 5 * y) % 40;
            for (const int code : {value, label ? value : value / 2, label ? value : value / 2, 255})
                image.pixels.push_back(static_cast<std::uint8_t>(code));
        }
    return image;
}

class Labelled : public testing::Test {
  protected:
    void write(const std::string& name, const Image& image) { output::write_png(folder_.path() / name, image); }
    std::string fault() const {
        try {
            known_labelled(folder_.path());
        } catch (const Error& error) {
            return error.failure() == Failure::bad_input ? error.what() : "another kind of failure";
        }
        return "none";
    }
    ScratchFolder folder_;
};

TEST_F(Labelled, FramesFollowTheBaselineOfTheirSequenceInTheOrderOfTheirNumbers) {
    write("frame_3_0.png", picture(0, false));
    for (const int number : {2, 10}) {
        write("frame_3_" + std::to_string(number) + ".png", picture(0, false));
        write("blood_3_" + std::to_string(number) + ".png", picture(4 * number, true));
    }
    write("frame_1_0.png", picture(0, false));
    write("frame_1_1.png", picture(0, false));
    write("blood_1_1.png", picture(0, true));
    write("other.png", picture(0, true));
    const std::vector<KnownView> views = known_labelled(folder_.path());
    ASSERT_EQ(views.size(), 2U);
    EXPECT_EQ(views[0].labels.at("operation"), folder_.path().filename().string() + "/frame_1");
    EXPECT_EQ(views[0].pictures.at(0).blood, 0.0);
    ASSERT_EQ(views[1].pictures.size(), 2U);
    EXPECT_TRUE(views[1].labelled && views[1].real && views[1].in_order);
    EXPECT_NEAR(views[1].pictures[0].blood, 8.0 / width, 0.02);
    EXPECT_NEAR(views[1].pictures[1].blood, 40.0 / width, 0.02) << "2 is before 10";
    EXPECT_EQ(views[1].pictures[0].picture.pixels, picture(0, false).pixels);
    EXPECT_EQ(views[1].baseline.pixels, picture(0, false).pixels);
}

TEST_F(Labelled, AFaultNamesItsFile) {
    EXPECT_THAT(fault(), testing::HasSubstr("has no frames named frame_S_0.png"));
    write("frame_0_1.png", picture(0, false));
    EXPECT_THAT(fault(), testing::HasSubstr("frame_0_0.png"));
    write("frame_0_0.png", picture(0, false));
    EXPECT_THAT(fault(), testing::HasSubstr("blood_0_1.png"));
    write("blood_0_1.png", picture(0, true, width - 1));
    EXPECT_THAT(fault(), testing::HasSubstr("blood_0_1.png: is 63x48, where its frame is 64x48"));
    std::ofstream(folder_.path() / "blood_0_1.png") << "no picture";
    EXPECT_THAT(fault(), testing::HasSubstr("blood_0_1.png"));
}

}  // namespace
}  // namespace lapfx::bench
