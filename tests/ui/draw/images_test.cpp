#include "ui/draw/images.h"

#include <gtest/gtest.h>

namespace lapfx::ui {
namespace {

const std::vector<std::uint8_t> four_pixels(16, 7), one_pixel{1, 2, 3, 4};

TEST(ImageStore, KeepsWhatItIsGiven) {
    ImageStore store;
    const ImageHandle image = store.add({1, 1}, one_pixel);
    EXPECT_GE(image, own_images);
    ASSERT_NE(store.find(image), nullptr);
    EXPECT_EQ(store.find(image)->pixels, one_pixel);
    EXPECT_EQ(store.find(image)->size, glm::ivec2(1, 1));
}

TEST(ImageStore, EveryChangeHasASerialOfItsOwn) {
    ImageStore store;
    const ImageHandle first = store.add({1, 1}, one_pixel), second = store.add({2, 2}, four_pixels);
    const std::uint32_t before = store.find(first)->serial;
    EXPECT_NE(store.find(second)->serial, before);
    store.update(first, {2, 2}, four_pixels);
    EXPECT_GT(store.find(first)->serial, store.find(second)->serial);
    EXPECT_EQ(store.find(first)->size, glm::ivec2(2, 2));
}

TEST(ImageStore, ARemovedImageIsGoneAndItsPlaceIsUsedAgainWithANewSerial) {
    ImageStore store;
    const ImageHandle image = store.add({1, 1}, one_pixel);
    const std::uint32_t serial = store.find(image)->serial;
    store.remove(image);
    EXPECT_EQ(store.find(image), nullptr);
    EXPECT_EQ(store.all()[0].serial, 0U);
    EXPECT_TRUE(store.all()[0].pixels.empty());
    EXPECT_EQ(store.add({1, 1}, one_pixel), image);
    EXPECT_GT(store.find(image)->serial, serial);
}

TEST(ImageStore, KnowsNeitherTexturesOfTheHostNorNone) {
    ImageStore store;
    store.add({1, 1}, one_pixel);
    EXPECT_EQ(store.find(0), nullptr);
    EXPECT_EQ(store.find(5), nullptr);
    EXPECT_EQ(store.find(own_images + 1), nullptr);
}

}  // namespace
}  // namespace lapfx::ui
