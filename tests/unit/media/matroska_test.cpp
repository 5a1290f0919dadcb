#include "media/matroska.h"

#include <gtest/gtest.h>

#include <vector>

namespace lapfx::media {
namespace {

using Bytes = std::vector<std::uint8_t>;

const Bytes header{0x1a, 0x45, 0xdf, 0xa3, 0x82, 7, 7};  // two bytes of content

Bytes file(const Bytes& more) {
    Bytes bytes = header;
    bytes.insert(bytes.end(), more.begin(), more.end());
    return bytes;
}

TEST(Matroska, StatesTheSizeOfTheWholeFile) {
    EXPECT_EQ(matroska_size(file({0x18, 0x53, 0x80, 0x67, 0x85})), 7 + 5 + 5);
    EXPECT_EQ(matroska_size(file({0x18, 0x53, 0x80, 0x67, 0x41, 0x02})), 7 + 6 + 0x102);
    EXPECT_EQ(matroska_size(file({0x18, 0x53, 0x80, 0x67, 0x01, 0, 0, 0, 0, 1, 0, 0})), 7 + 12 + 0x10000);
    EXPECT_EQ(matroska_size(file({0xec, 0x81, 0, 0x18, 0x53, 0x80, 0x67, 0x85})), 7 + 3 + 5 + 5);  // padding before it
}

TEST(Matroska, ASizeThatIsNotKnownIsNone) {
    EXPECT_EQ(matroska_size(file({0x18, 0x53, 0x80, 0x67, 0xff})), 0);
    EXPECT_EQ(matroska_size(file({0x18, 0x53, 0x80, 0x67, 0x01, 255, 255, 255, 255, 255, 255, 255})), 0);
}

TEST(Matroska, OtherAndBrokenFilesStateNone) {
    EXPECT_EQ(matroska_size({}), 0);
    EXPECT_EQ(matroska_size(Bytes{'R', 'I', 'F', 'F', 1, 2, 3, 4}), 0);
    EXPECT_EQ(matroska_size(Bytes{0x18, 0x53, 0x80, 0x67, 0x85}), 0);  // without the header
    EXPECT_EQ(matroska_size(file({0x41, 0x42, 0x85})), 0);             // another element
    const Bytes whole = file({0x18, 0x53, 0x80, 0x67, 0x41, 0x02});
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_EQ(matroska_size(std::span(whole).first(size)), 0) << size;
}

}  // namespace
}  // namespace lapfx::media
