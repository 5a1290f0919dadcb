#include "commands/content_hash.h"

#include <gtest/gtest.h>

#include "unit/preset/support.h"

namespace lapfx::commands {
namespace {

std::string hash_of(const std::vector<std::filesystem::path>& files) {
    ContentHash hash;
    for (const auto& file : files) hash.add_file(file);
    return hash.text();
}

TEST(ContentHashTest, IsOfTheContentsAndTheirOrder) {
    const test::Folder folder;
    const auto one = folder.write("one.mp4", "picture"), same = folder.write("same.mp4", "picture");
    const auto other = folder.write("other.mp4", "pictures");
    EXPECT_EQ(hash_of({one}), hash_of({same}));
    EXPECT_EQ(hash_of({one}).size(), 32U);
    EXPECT_NE(hash_of({one}), hash_of({other}));
    EXPECT_NE(hash_of({one, other}), hash_of({other, one}));
    EXPECT_NE(hash_of({one}), hash_of({folder / "none.mp4"}));
    ContentHash whole, parts;
    whole.add("ab"), whole.add("c"), parts.add("a"), parts.add("bc");
    EXPECT_NE(whole.text(), parts.text());
}

TEST(ContentHashTest, TakesNumberedImagesOneByOne) {
    const test::Folder folder;
    folder.write("frame_0.png", "first"), folder.write("frame_1.png", "second");
    const std::string before = hash_of({folder / "frame_%d.png"});
    EXPECT_NE(before, hash_of({folder / "none_%d.png"}));
    folder.write("frame_1.png", "other!");
    EXPECT_NE(before, hash_of({folder / "frame_%d.png"}));
}

}  // namespace
}  // namespace lapfx::commands
