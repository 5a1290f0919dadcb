// What HTML is made of, from bytes of any kind.
#include "match/report/markup.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lapfx::match {
namespace {

TEST(Markup, Base64IsThatOfTheStandard) {  // RFC 4648, section 10
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xFF\xFE\x00\xFB", 4)), "//4A+w==");
}

TEST(Markup, EscapesWhatIsNoLetter) {
    const std::string none = "\xEF\xBF\xBD";
    EXPECT_EQ(escaped("Gr\xC3\xBC\xC3\x9F \xE8\x83\x83 \xF0\x9F\xA9\xB8"),
              "Gr\xC3\xBC\xC3\x9F \xE8\x83\x83 \xF0\x9F\xA9\xB8");
    EXPECT_EQ(escaped("\xC0\xAF"), none + none);                        // '/' in two bytes
    EXPECT_EQ(escaped("\xED\xA0\x80"), none + none + none);             // half of a pair of UTF-16
    EXPECT_EQ(escaped("\xE2\x82"), none + none);                        // ends within a letter
    EXPECT_EQ(escaped("\xEF\xBF\xBF"), none);                           // U+FFFF
    EXPECT_EQ(escaped("\xF4\x90\x80\x80"), none + none + none + none);  // beyond U+10FFFF
    EXPECT_EQ(escaped(std::string("a\0b\r\x1B", 5)), "a" + none + "b" + none + none);
    EXPECT_EQ(escaped("\xC2\x85"), none);  // U+0085, a control
}

TEST(Markup, NumbersAreShort) {
    EXPECT_EQ(digits(0.0123456), "0.0123");
    EXPECT_EQ(digits(8.748), "8.75");
    EXPECT_EQ(digits(12345.6), "12346");
    EXPECT_EQ(digits(999.9), "1000");
    EXPECT_EQ(digits(std::nan("")), "-");
    EXPECT_EQ(digits(-std::numeric_limits<double>::infinity()), "-");
}

}  // namespace
}  // namespace lapfx::match
