#include "organ/pixels.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "media/image.h"
#include "support/wait_until.h"

namespace lapfx::organ {
namespace {

constexpr std::size_t decoded_bytes = 64 * 48 * 4;

Encoded encoded_picture(const char* extension) {
    cv::Mat pixels(48, 64, CV_8UC3);
    for (int y = 0; y < pixels.rows; ++y)
        for (int x = 0; x < pixels.cols; ++x)
            pixels.at<cv::Vec3b>(y, x) = {static_cast<std::uint8_t>(3 * x), static_cast<std::uint8_t>(5 * y), 90};
    std::vector<std::uint8_t> bytes;
    cv::imencode(extension, pixels, bytes);
    return std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
}

Image decoded(const Encoded& encoded) {
    Image image;
    EXPECT_EQ(media::decode_image(*encoded, image), "");
    return image;
}

TEST(Pixels, AreDecodedAgainAsTheyWere) {
    for (const char* extension : {".png", ".jpg", ".webp"}) {
        const Encoded file = encoded_picture(extension);
        const Image expected = decoded(file);
        const Pixels pixels(expected, file);
        EXPECT_EQ(pixels.memory(), decoded_bytes + file->size());
        pixels.let_go();
        EXPECT_EQ(pixels.memory(), file->size()) << extension;
        {
            const auto again = pixels.get();
            EXPECT_TRUE(again->pixels == expected.pixels) << extension;
            EXPECT_EQ(again->width, 64);
            EXPECT_EQ(pixels.memory(), decoded_bytes + file->size());
            EXPECT_EQ(pixels.get(), again) << "while somebody has them they are decoded once";
        }
        EXPECT_EQ(pixels.memory(), file->size()) << "and then they are gone";
    }
}

TEST(Pixels, ThatComeFromNoFileStay) {
    const Image image = decoded(encoded_picture(".png"));
    const Pixels pixels(image, nullptr);
    pixels.let_go();
    EXPECT_EQ(pixels.memory(), decoded_bytes);
    EXPECT_TRUE(pixels.get()->pixels == image.pixels);
}

TEST(Pixels, OfAnOrganAreTakenOutOfItOrCopiedOrLent) {
    const Encoded file = encoded_picture(".png");
    Organ organ;
    organ.images = {decoded(file), decoded(file)};
    organ.images[1].name = "normals";
    organ.materials = {{.name = "m", .base_color_image = 0, .normal_image = 1}};
    const std::vector<std::uint8_t> expected = organ.images[0].pixels;

    const PixelList copies = copied_pixels(organ), lent = borrowed_pixels(organ);
    ASSERT_EQ(copies.size(), 2U);
    EXPECT_EQ(copies[1], nullptr) << "of what is only drawn nobody asks for pixels";
    EXPECT_EQ(lent[0]->get().get(), organ.images.data());
    EXPECT_EQ(lent[0]->memory(), 0U);

    const PixelList taken = take_pixels(organ, {file, file});
    for (const Image& image : organ.images) EXPECT_TRUE(image.pixels.empty());
    EXPECT_EQ(organ.images[1].name, "normals");
    EXPECT_EQ(organ.images[1].width, 64);
    for (const auto& one : {taken[0], taken[1], copies[0]}) EXPECT_TRUE(one->get()->pixels == expected);
}

TEST(Pixels, OfAFormerOrganAreThoseOfTheSameIndexNameAndSize) {
    const Encoded file = encoded_picture(".png");
    Organ organ;
    organ.images = {decoded(file), decoded(file), decoded(file), decoded(file)};
    organ.materials = {{.name = "m", .base_color_image = 0, .normal_image = 1},
                       {.name = "n", .base_color_image = 2, .normal_image = 3}};
    const Image whole = organ.images[2];
    const PixelList former = take_pixels(organ, {file, file, file, file});
    organ.images[1].name = "another";
    organ.images[2] = whole;
    organ.images[3].width += 1;
    const PixelList list = copied_pixels(organ, former);
    ASSERT_EQ(list.size(), 4U);
    EXPECT_EQ(list[0], former[0]);
    EXPECT_EQ(list[1], nullptr) << "of another name";
    EXPECT_NE(list[2], former[2]) << "it has bytes of its own";
    EXPECT_EQ(list[3], nullptr) << "of another size";
    EXPECT_EQ(copied_pixels(organ, {})[1], nullptr);
}

TEST(Pixels, ThatCannotBeDecodedAgainAreNoMemory) {
    const Image image = decoded(encoded_picture(".png"));
    const Pixels pixels(image, std::make_shared<const std::vector<std::uint8_t>>(100, std::uint8_t{1}));
    EXPECT_TRUE(pixels.get()->pixels == image.pixels);
    pixels.let_go();
    EXPECT_THROW(pixels.get(), std::bad_alloc);
    EXPECT_THROW(pixels.get(), std::bad_alloc) << "nobody waits for a decoder that has given up";
    EXPECT_EQ(pixels.memory(), 100U);
}

TEST(Pixels, AnyThreadMayAskForThemAtAnyTime) {
    const Encoded file = encoded_picture(".png");
    const Image expected = decoded(file);
    const Pixels pixels(expected, file);
    std::atomic<int> others = 0;
    const auto work = [&] {
        for (int i = 0; i < 200; ++i) {
            const auto image = pixels.get();
            if (image->pixels != expected.pixels) ++others;
            pixels.let_go();
            if (pixels.memory() != decoded_bytes + file->size()) ++others;  // `image` has them
        }
    };
    std::thread first(work), second(work);
    first.join();
    second.join();
    EXPECT_EQ(others, 0);
    EXPECT_EQ(pixels.memory(), file->size());
}

TEST(Pixels, WhoAsksForTheirMemoryNeverWaitsForADecoder) {
    cv::Mat noise(1500, 1500, CV_8UC3);
    cv::randu(noise, 0, 256);
    std::vector<std::uint8_t> bytes;
    cv::imencode(".png", noise, bytes);
    const auto file = std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes));
    const Pixels pixels(decoded(file), file);
    pixels.let_go();
    std::shared_ptr<const Image> image;
    int asked = 0;
    const auto ask_meanwhile = [&] {  // on a busy machine it may have decoded before it is asked
        image.reset();
        pixels.let_go();
        std::atomic<bool> begun = false;
        std::thread decoder([&] {
            begun = true;
            image = pixels.get();
        });
        while (!begun) std::this_thread::yield();
        for (asked = 0; pixels.memory() == file->size();) ++asked;
        decoder.join();
    };
    EXPECT_TRUE(test::wait_until([&] { return asked > 100; }, ask_meanwhile)) << "while it decodes";
    EXPECT_EQ(pixels.memory(), image->pixels.size() + file->size());
}

}  // namespace
}  // namespace lapfx::organ
