#include "bench/measure/over.h"

#include <gmock/gmock.h>

#include "bench/scratch_folder.h"
#include "output/files.h"

namespace lapfx::bench {
namespace {

/// A red wall with a pattern on it.
Image tissue() {
    Image image{.width = 64, .height = 48, .pixels = {}, .name = ""};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (const int code : {150 + (7 * x + 5 * y) % 40, 75, 60 + (3 * x + 11 * y) % 30, 255})
                image.pixels.push_back(static_cast<std::uint8_t>(code));
    return image;
}

/// What is drawn at random follows from the seed and the file's number alone.
TEST(Over, TheSameSeedGivesTheSamePictures) {
    const ScratchFolder folder;
    output::write_png(folder.path() / "wall_1.png", tissue());
    const auto views = [&](std::uint32_t seed, int number) {
        OverCounts counts;
        std::vector<KnownView> made = known_over(folder.path() / "wall_1.png", seed, number, 3, counts);
        EXPECT_EQ(counts.without_later, 1) << "a picture has no later one";
        return made;
    };
    const std::vector<KnownView> once = views(5, 0), again = views(5, 0), seed = views(6, 0), file = views(5, 1);
    ASSERT_EQ(once.size(), 1U);
    ASSERT_EQ(once[0].pictures.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        const KnownPicture &a = once[0].pictures[i], &b = again.at(0).pictures.at(i);
        EXPECT_EQ(a.picture.pixels, b.picture.pixels) << i;
        EXPECT_EQ(a.blood, b.blood) << i;
        EXPECT_EQ(a.veil, b.veil) << i;
        EXPECT_NE(a.picture.pixels, seed.at(0).pictures.at(i).picture.pixels) << i;
        EXPECT_NE(a.picture.pixels, file.at(0).pictures.at(i).picture.pixels) << i;
    }
}

}  // namespace
}  // namespace lapfx::bench
