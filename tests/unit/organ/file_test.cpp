// The contents of URIs: base64 and escapes.
#include "organ/file.h"

#include <gtest/gtest.h>

#include <string>

namespace lapfx::organ {
namespace {

/// The text behind it; "none" when it is no base64.
std::string decoded(std::string_view base64) {
    Bytes bytes{1, 2, 3};
    if (!decode_base64(base64, bytes)) return "none";
    return {bytes.begin(), bytes.end()};
}

TEST(Base64, TextsOfEveryLength) {
    EXPECT_EQ(decoded(""), "");
    EXPECT_EQ(decoded("Zg=="), "f");
    EXPECT_EQ(decoded("Zm8="), "fo");
    EXPECT_EQ(decoded("Zm9v"), "foo");
    EXPECT_EQ(decoded("Zm9vYg=="), "foob");
    EXPECT_EQ(decoded("Zm9vYmE="), "fooba");
    EXPECT_EQ(decoded("Zm9vYmFy"), "foobar");
    EXPECT_EQ(decoded("Zm8"), "fo") << "without padding";
}

TEST(Base64, TheLettersOfUrlsToo) {
    EXPECT_EQ(decoded("++//"), "\xfb\xef\xff");
    EXPECT_EQ(decoded("--__"), "\xfb\xef\xff");
}

TEST(Base64, WhatIsNone) {
    for (const std::string text : {"Zm9v!", "Zm 9v", "Zm9v\n", "Zm8=Zm9v", "Zg=a", "\xc3\xa4", "====a"})
        EXPECT_EQ(decoded(text), "none") << text;
    EXPECT_EQ(decoded(std::string_view("Zm9v\0Zm9v", 9)), "none") << "a zero is no end";
    EXPECT_EQ(decoded(std::string_view("Zm9v\0", 5)), "none");
}

TEST(PercentDecoded, EscapesOfTwoDigitsAndNothingElse) {
    EXPECT_EQ(percent_decoded("a%20b%2fc%2F.bin"), "a b/c/.bin");
    EXPECT_EQ(percent_decoded("100%"), "100%");
    EXPECT_EQ(percent_decoded("%2"), "%2");
    EXPECT_EQ(percent_decoded("%g0%0g"), "%g0%0g");
}

}  // namespace
}  // namespace lapfx::organ
