#include "organ/texture_levels.h"

#include <gmock/gmock.h>

namespace lapfx {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

using Texel = std::array<std::uint8_t, 4>;

Image image_of(int width, int height, const std::vector<Texel>& texels) {
    Image image{.width = width, .height = height, .pixels = {}, .name = "given"};
    for (const Texel& t : texels) image.pixels.insert(image.pixels.end(), t.begin(), t.end());
    return image;
}

constexpr Texel black{0, 0, 0, 255}, white{255, 255, 255, 255};

TEST(TextureLevels, AColoursAreMeansOfLight) {
    const auto levels = organ::smaller_levels(image_of(2, 2, {black, white, white, black}), true);
    ASSERT_EQ(levels.size(), 1U);
    EXPECT_THAT(levels[0].pixels, ElementsAre(188, 188, 188, 255));  // half of the light: 255 (1.055 .5^(1/2.4) - .055)
}

TEST(TextureLevels, OpacityIsNotEncoded) {
    const auto levels = organ::smaller_levels(image_of(2, 1, {{10, 10, 10, 0}, {10, 10, 10, 255}}), true);
    ASSERT_EQ(levels.size(), 1U);
    EXPECT_THAT(levels[0].pixels, ElementsAre(10, 10, 10, 128));
}

TEST(TextureLevels, OfANormalMapTheyAreMeansOfTheValues) {
    const auto levels = organ::smaller_levels(
        image_of(2, 2, {{0, 100, 200, 255}, {100, 100, 200, 255}, {0, 100, 200, 255}, {100, 100, 220, 255}}), false);
    ASSERT_EQ(levels.size(), 1U);
    EXPECT_THAT(levels[0].pixels, ElementsAre(50, 100, 205, 255));
}

TEST(TextureLevels, OneColourStaysAtEveryLevel) {
    for (int value = 0; value < 256; ++value) {
        const auto v = static_cast<std::uint8_t>(value);
        for (const bool color : {true, false})
            for (const Image& level :
                 organ::smaller_levels(image_of(5, 3, std::vector<Texel>(15, {v, v, v, v})), color))
                EXPECT_THAT(level.pixels, testing::Each(v)) << value << " at " << level.width << 'x' << level.height;
    }
}

/// Like OpenGL's levels.
TEST(TextureLevels, SizesAreHalvedAndRoundedDown) {
    std::vector<std::pair<int, int>> sizes;
    for (const Image& level : organ::smaller_levels(image_of(13, 3, std::vector<Texel>(39, white)), true)) {
        sizes.emplace_back(level.width, level.height);
        EXPECT_EQ(level.pixels.size(), static_cast<std::size_t>(4 * level.width * level.height));
    }
    EXPECT_THAT(sizes, ElementsAre(std::pair(6, 1), std::pair(3, 1), std::pair(1, 1)));
    EXPECT_TRUE(organ::smaller_levels(image_of(1, 1, {white}), true).empty());
}

/// The middle column of three counts as much as the others.
TEST(TextureLevels, AnOddSideLosesNoTexel) {
    const auto levels =
        organ::smaller_levels(image_of(3, 1, {{0, 0, 0, 0}, {255, 255, 255, 255}, {0, 0, 0, 0}}), false);
    ASSERT_EQ(levels.size(), 1U);
    EXPECT_THAT(levels[0].pixels, testing::Each(85));
}

TEST(TextureLevels, AreOfWhatAMaterialUses) {
    Organ organ;
    organ.images = {image_of(1, 1, {white}), image_of(2, 1, {black, white}), image_of(1, 1, {black})};
    organ.materials.resize(2);
    organ.materials[0].base_color_image = organ.materials[0].normal_image = 1;
    organ.materials[1].normal_image = 2;
    std::vector<std::pair<std::size_t, bool>> uses;
    for (const organ::TextureUse& use : organ::texture_uses(organ)) uses.emplace_back(use.image, use.color);
    EXPECT_THAT(uses, ElementsAre(std::pair(1, true), std::pair(1, false), std::pair(2, false)));

    const organ::TextureLevels levels = organ::texture_levels(organ, {}, {.image = 1, .color = true});
    EXPECT_EQ(levels.count(), 2U);
    EXPECT_EQ(levels.level(0).pixels, organ.images[1].pixels);
    EXPECT_EQ(levels.level(1).pixels, levels.smaller[0].pixels);
}

TEST(TextureLevels, WithoutPixelsThereAreNone) {
    Organ organ;
    organ.images = {{.width = 4, .height = 4, .pixels = {}, .name = "gone"}};
    organ.materials.resize(1);
    organ.materials[0].base_color_image = 0;
    EXPECT_EQ(organ::texture_levels(organ, {}, {.image = 0, .color = true}).whole, nullptr);
}

}  // namespace
}  // namespace lapfx
