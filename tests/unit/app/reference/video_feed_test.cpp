// Frames of a video decoded apart from the UI, and files that vanish or change while they are open.
#include "app/reference/video_feed.h"

#include "app/reference/reference.h"
#include "support/clips.h"
#include "support/wait_until.h"
#include "unit/preset/support.h"

namespace lapfx::app {
namespace {

namespace fs = std::filesystem;

/// Waits for the thread.
template <class Condition>
bool comes(VideoFeed& feed, Condition condition) {
    return test::wait_until([&] {
        feed.take();
        return condition();
    });
}

class VideoFeedTest : public testing::Test {
  protected:
    test::Folder folder;
    fs::path video(const std::string& name = "v.avi", int frames = 20) {
        return test::write_clip(folder / name, frames, {64, 32}, 10);
    }
    static std::vector<std::uint8_t> frame_of(const fs::path& file, int frame) {
        VideoReader reader(file);
        Image image;
        EXPECT_TRUE(reader.read(frame, image));
        return image.pixels;
    }
};

TEST_F(VideoFeedTest, TheNewestWishIsShown) {
    const fs::path file = video();
    std::atomic<int> woken = 0;
    VideoFeed feed;
    feed.set_wake([&] { ++woken; });
    EXPECT_FALSE(feed.opening());
    feed.open(file);
    EXPECT_TRUE(feed.opening());
    ASSERT_TRUE(comes(feed, [&] { return feed.video() != nullptr; }));
    EXPECT_FALSE(feed.opening());
    EXPECT_EQ(feed.frame(), -1);
    for (int frame = 0; frame < 20; ++frame) feed.want(frame);
    feed.want(7);
    ASSERT_TRUE(comes(feed, [&] { return feed.frame() == 7; }));
    EXPECT_EQ(feed.image().pixels, frame_of(file, 7));
    EXPECT_TRUE(feed.good());
    EXPECT_GE(woken, 2);
}

TEST_F(VideoFeedTest, AnotherFileTakesThePlaceOfTheOldOneAtOnce) {
    const fs::path first = video("a.avi"), second = video("b.avi", 5);
    VideoFeed feed;
    feed.open(first);
    ASSERT_TRUE(comes(feed, [&] { return feed.video() != nullptr; }));
    feed.want(3);
    feed.open(second);
    EXPECT_EQ(feed.video(), nullptr);
    EXPECT_EQ(feed.frame(), -1);
    ASSERT_TRUE(comes(feed, [&] { return feed.video() != nullptr; }));
    EXPECT_EQ(feed.video()->info().frames, 5);
    feed.take();
    EXPECT_EQ(feed.frame(), -1) << "no frame of the file before";
    feed.open({});
    EXPECT_EQ(feed.video(), nullptr);
    EXPECT_FALSE(feed.opening());
}

TEST_F(VideoFeedTest, AReaderThatIsOpenAlreadyIsUsedOnce) {
    const fs::path file = video(), other = video("b.avi", 5);
    auto reader = std::make_shared<VideoReader>(file);
    const std::weak_ptr<VideoReader> watched = reader;
    VideoFeed feed;
    feed.open(file, std::move(reader));
    ASSERT_TRUE(comes(feed, [&] { return feed.video() != nullptr; }));
    EXPECT_EQ(feed.video(), watched.lock()) << "nothing was opened again";
    feed.want(7);
    ASSERT_TRUE(comes(feed, [&] { return feed.frame() == 7; }));
    EXPECT_EQ(feed.image().pixels, frame_of(file, 7));
    feed.open(other);
    ASSERT_TRUE(comes(feed, [&] { return feed.video() != nullptr; }));
    EXPECT_EQ(feed.video()->info().frames, 5);
    feed.take();
    EXPECT_TRUE(watched.expired()) << "nobody keeps it";
}

TEST_F(VideoFeedTest, AFrameIsDecodedOnceForAllWhoKeepIt) {
    const fs::path file = video();
    VideoFeed feed(true);
    feed.open(file);
    EXPECT_TRUE(feed.image().pixels.empty());
    feed.want(3);
    const std::shared_ptr<const Image> kept = feed.shared_image();
    EXPECT_EQ(kept.get(), &feed.image()) << "nothing is copied";
    feed.want(3);
    EXPECT_EQ(feed.shared_image(), kept);
    EXPECT_EQ(feed.decoded(), 1U);
    feed.want(4);
    EXPECT_EQ(feed.decoded(), 2U);
    EXPECT_EQ(feed.image().pixels, frame_of(file, 4));
    EXPECT_EQ(kept->pixels, frame_of(file, 3)) << "who keeps it has it while the next one is shown";
}

TEST_F(VideoFeedTest, AFileThatVanishesKeepsItsLastFrame) {
    const fs::path file = video();
    VideoFeed feed;
    feed.open(file);
    ASSERT_TRUE(comes(feed, [&] { return feed.video() != nullptr; }));
    feed.want(4);
    ASSERT_TRUE(comes(feed, [&] { return feed.frame() == 4; }));
    fs::rename(file, folder / "away.avi");
    ASSERT_TRUE(comes(feed, [&] { return !feed.faults().empty(); }));
    EXPECT_EQ(feed.faults().front().text(), file.string() + ": no longer exists; its last frame stays");
    EXPECT_NE(feed.video(), nullptr);
    EXPECT_EQ(feed.frame(), 4);
    fs::rename(folder / "away.avi", file);
    EXPECT_TRUE(comes(feed, [&] { return feed.faults().empty(); })) << "it is back";
}

TEST_F(VideoFeedTest, AFileThatChangesIsOpenedAgain) {
    const fs::path file = video();
    VideoFeed feed(true);
    feed.open(file);
    ASSERT_NE(feed.video(), nullptr);
    feed.want(15);
    EXPECT_EQ(feed.frame(), 15);
    video("v.avi", 6);
    feed.want(15);
    EXPECT_EQ(feed.video()->info().frames, 6);
    EXPECT_EQ(feed.frame(), 5) << "its last one";
    folder.write("v.avi", "words, not a video");
    feed.want(5);
    ASSERT_EQ(feed.faults().size(), 1U);
    EXPECT_EQ(feed.faults().front().reason, "is not a video that can be decoded");
    EXPECT_EQ(feed.frame(), 5) << "what was open stays";
}

TEST_F(VideoFeedTest, AFileThatComesLaterIsOpened) {
    VideoFeed feed(true);
    feed.open(folder / "v.avi");
    ASSERT_EQ(feed.faults().size(), 1U);
    EXPECT_EQ(feed.faults().front().reason, "no such file");
    video();
    feed.want(-1);
    EXPECT_NE(feed.video(), nullptr);
    EXPECT_TRUE(feed.faults().empty());
}

TEST_F(VideoFeedTest, OneNumberedImageStandsForAll) {
    for (const char* name : {"f_08.png", "f_09.png", "f_10.png", "single_3.png", "v_01.mp4", "v_02.mp4"})
        folder.write(name, "x");
    EXPECT_EQ(whole_sequence(folder / "f_09.png"), folder / "f_%02d.png");
    EXPECT_EQ(whole_sequence(folder / "f_10.png"), folder / "f_%02d.png");
    EXPECT_EQ(whole_sequence(folder / "single_3.png"), folder / "single_3.png");
    EXPECT_EQ(whole_sequence(folder / "v_01.mp4"), folder / "v_01.mp4") << "videos are not images";
    EXPECT_EQ(whole_sequence(folder / "none.png"), folder / "none.png");
}

}  // namespace
}  // namespace lapfx::app
