#include "lapfx/clip_cache.h"

#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "media/clip_file.h"
#include "media/known_clips.h"
#include "support/folders.h"
#include "unit/preset/support.h"

namespace lapfx {
namespace {

namespace fs = std::filesystem;

class ClipCacheTest : public testing::Test {
  protected:
    void SetUp() override {
        fs::copy_file(test::source_folder() / "samples/clips/wisps_thin.mp4", folder_ / "a.mp4");
        preset_.folder = folder_.path();
        preset_.smoke.clips = {{.file = "a.mp4"}};
    }
    /// The cached data of the clip.
    std::optional<media::KnownClip> known() const {
        const fs::path path = media::clip_path("a.mp4", folder_.path(), {});
        return ClipCacheAccess::state(cache_).find(path, media::stamp_of(path));
    }

    test::Folder folder_;
    Preset preset_;
    ClipCache cache_;
};

TEST_F(ClipCacheTest, KnowsWhatWasLookedThroughUntilTheFileIsAnother) {
    EXPECT_FALSE(cache_.knows(preset_, {}));
    EXPECT_FALSE(cache_.look_through(preset_, {}, [](double) { return false; })) << "stopped";
    EXPECT_FALSE(cache_.knows(preset_, {}));
    EXPECT_TRUE(cache_.look_through(preset_, {}));
    EXPECT_TRUE(cache_.knows(preset_, {}));
    std::ofstream(folder_ / "a.mp4", std::ios::app) << "x";
    EXPECT_FALSE(cache_.knows(preset_, {}));
    EXPECT_TRUE(cache_.look_through(preset_, {}));
    cache_.forget(folder_ / "a.mp4");
    EXPECT_FALSE(cache_.knows(preset_, {}));
}

TEST_F(ClipCacheTest, WhatTheFirstOfTwoThreadsFoundStays) {
    ASSERT_TRUE(cache_.look_through(preset_, {}));
    const std::optional<media::KnownClip> first = known();
    ASSERT_TRUE(first && first->faults.empty());
    // The second one had begun before the first was done.
    media::KnownClip again = *first;
    again.info = media::Decoder(first->path, media::Layout::planar).info();
    ASSERT_NE(again.info.index, first->info.index);
    ClipCacheAccess::state(cache_).put(again);
    EXPECT_EQ(known()->info.index, first->info.index) << "a clip that plays is not opened anew for it";
}

TEST_F(ClipCacheTest, RemembersWhatIsWrongWithAFile) {
    std::ofstream(folder_ / "a.mp4", std::ios::trunc) << "no video";
    EXPECT_TRUE(cache_.look_through(preset_, {}));
    EXPECT_TRUE(cache_.knows(preset_, {}));
    ASSERT_TRUE(known());
    EXPECT_EQ(known()->faults.size(), 1U);
}

TEST_F(ClipCacheTest, ManyThreadsAtOnce) {
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            for (int k = 0; k < 3; ++k) {
                cache_.look_through(preset_, {});
                if (i == 0) cache_.forget();
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_TRUE(cache_.look_through(preset_, {}));
    EXPECT_TRUE(cache_.knows(preset_, {}));
}

}  // namespace
}  // namespace lapfx
