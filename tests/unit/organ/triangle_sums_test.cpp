#include "organ/triangle_sums.h"

#include <gtest/gtest.h>

namespace lapfx::organ {
namespace {

using Parts = std::vector<std::array<double, 2>>;

/// The triangles that were asked for their parts. `numbered`: those that were marked, in the order of the first time.
std::vector<std::uint32_t> measure(TriangleSums<2>& sums, const Parts& parts,
                                   const std::vector<std::uint32_t>& numbered) {
    std::vector<std::uint32_t> asked;
    sums.measure([&](std::uint32_t t, std::uint32_t number) {
        EXPECT_EQ(numbered.at(number), t);
        asked.push_back(t);
        return parts[t];
    });
    return asked;
}

TEST(TriangleSums, OnlyWhatHasChangedIsAskedFor) {
    TriangleSums<2> sums(4);
    Parts parts{{1.0, 10.0}, {2.0, 20.0}, {4.0, 40.0}, {8.0, 80.0}};
    EXPECT_EQ(measure(sums, parts, {}), std::vector<std::uint32_t>{}) << "nothing is there";
    EXPECT_TRUE(sums.mark(3));
    EXPECT_TRUE(sums.mark(1));
    EXPECT_FALSE(sums.mark(1)) << "it is marked already";
    EXPECT_EQ(measure(sums, parts, {3, 1}), (std::vector<std::uint32_t>{3, 1}));
    EXPECT_EQ(sums.sum(0), 10.0);
    EXPECT_EQ(sums.sum(1), 100.0);
    parts[3] = {0.5, 5.0};
    EXPECT_FALSE(sums.mark(3)) << "it has had a part before";
    EXPECT_EQ(measure(sums, parts, {3, 1}), std::vector<std::uint32_t>{3});
    EXPECT_EQ(sums.sum(0), 2.5);
    EXPECT_EQ(sums.sum(1), 25.0);
    parts[1] = {3.0, 0.0};
    sums.mark_all();
    EXPECT_EQ(measure(sums, parts, {3, 1}), (std::vector<std::uint32_t>{3, 1}));
    EXPECT_EQ(sums.sum(0), 3.5);
    EXPECT_EQ(sums.sum(1), 5.0);
}

TEST(TriangleSums, AfterClearThereIsNothing) {
    TriangleSums<2> sums(2);
    const Parts parts{{1.0, 10.0}, {2.0, 20.0}};
    sums.mark(0);
    sums.mark(1);
    measure(sums, parts, {0, 1});
    sums.mark(0);
    sums.clear();
    EXPECT_EQ(measure(sums, parts, {}), std::vector<std::uint32_t>{});
    EXPECT_EQ(sums.sum(0), 0.0);
    EXPECT_TRUE(sums.mark(1)) << "as the first time";
    measure(sums, parts, {1});
    EXPECT_EQ(sums.sum(0), 2.0) << "nothing of before counts";
}

}  // namespace
}  // namespace lapfx::organ
