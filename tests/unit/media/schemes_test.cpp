#include "media/schemes.h"

#include <gtest/gtest.h>

#include <set>

namespace lapfx::media {
namespace {

TEST(Schemes, RowsFollowTheEnumeratorsAndSayWhatGoesTogether) {
    std::set<std::string_view> keys;
    for (std::size_t i = 0; i < std::size(scheme_rows); ++i) {
        const SchemeRow& row = scheme_rows[i];
        EXPECT_EQ(row.scheme, static_cast<Scheme>(i)) << row.key;
        EXPECT_EQ(&row_of(row.scheme), &row);
        EXPECT_TRUE(keys.insert(row.key).second) << row.key;
        EXPECT_EQ(row.stays, row.textures == 0) << row.key << ": a frame is sent to stay, or to a texture";
        EXPECT_TRUE(row.ahead || !row.buffers) << row.key << ": buffers are for frames that are decoded ahead";
        const SchemeRow& otherwise = row_of(row.otherwise);
        EXPECT_EQ(otherwise.layout, row.layout) << row.key << ": a file is decoded once";
        EXPECT_EQ(row.stays, row.otherwise != row.scheme) << row.key << ": what stays may not fit";
        EXPECT_FALSE(otherwise.stays) << row.key << ": it would not fit either";
    }
}

}  // namespace
}  // namespace lapfx::media
