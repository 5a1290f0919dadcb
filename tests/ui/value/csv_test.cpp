#include "ui/value/csv.h"

#include <gtest/gtest.h>

namespace lapfx::ui {
namespace {

std::string cell(std::string_view text) {
    std::string csv = "a,";
    append_csv(csv, text);
    return csv;
}

TEST(Csv, QuotesOnlyWhatWouldBreakTheRow) {
    EXPECT_EQ(cell("week 2/op.mp4"), "a,week 2/op.mp4");
    EXPECT_EQ(cell(""), "a,");
    EXPECT_EQ(cell("a,b"), "a,\"a,b\"");
    EXPECT_EQ(cell("5\" lens"), "a,\"5\"\" lens\"");
    EXPECT_EQ(cell("two\nlines"), "a,\"two\nlines\"");
    EXPECT_EQ(cell("two\rlines"), "a,\"two\rlines\"");
}

}  // namespace
}  // namespace lapfx::ui
