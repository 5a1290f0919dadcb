#include "lapfx/authoring/printable.h"

#include <gtest/gtest.h>

#include "lapfx/error.h"

namespace lapfx {
namespace {

TEST(Printable, WhatDrivesATerminalIsEscaped) {
    EXPECT_EQ(printable("\x1b[2Jgone"), "\\x1b[2Jgone");
    EXPECT_EQ(printable("two\nlines\r\tand\x7f"), "two\\x0alines\\x0d\\x09and\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\u009b31m")
        << "the same as ESC [";
    EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(Printable, WhatTurnsTheDirectionOfTextIsEscaped) {
    EXPECT_EQ(printable("gpj.\u202e"
                        "exe"),
              "gpj.\\u202eexe");
    EXPECT_EQ(printable("\u2066x\u2069\u200f\u2028"), "\\u2066x\\u2069\\u200f\\u2028");
}

TEST(Printable, OtherTextStays) {
    EXPECT_EQ(printable("Rauch gr\u00f6\u00dfe, \u65e5\u672c, \U0001f525 \"x\" \\x1b"),
              "Rauch gr\u00f6\u00dfe, \u65e5\u672c, \U0001f525 \"x\" \\x1b");
    EXPECT_EQ(printable(""), "");
}

TEST(Printable, BytesThatAreNotUtf8AreEscaped) {
    EXPECT_EQ(printable("latin \xe4!"), "latin \\xe4!");
    EXPECT_EQ(printable("\xc0\xaf \xed\xa0\x80 \xf5 \xe2\x82"), "\\xc0\\xaf \\xed\\xa0\\x80 \\xf5 \\xe2\\x82")
        << "overlong, half of a pair, beyond Unicode, cut off";
}

TEST(Printable, AFaultIsOneLine) {
    EXPECT_EQ((Fault{.file = "a\nb\u202e", .place = "/x", .reason = "\x1b"}.text()), "a\\x0ab\\u202e: /x: \\x1b");
}

}  // namespace
}  // namespace lapfx
