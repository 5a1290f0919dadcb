#include "lapfx/parameter.h"

#include <gmock/gmock.h>

#include <limits>

#include "preset/tables.h"
#include "unit/preset/support.h"

namespace lapfx {

namespace {

using testing::HasSubstr;
using testing::StartsWith;

enum class Fruit { apple, pear };
struct Basket {
    double weight = 2.0;
    int count = 3;
    bool ripe = true;
    Fruit fruit = Fruit::pear;
    glm::dvec3 color{0.5};
    glm::dvec3 place{1.0, 2.0, 3.0};
    std::string label = "best";
    std::string file = "a.txt";
};

constexpr std::string_view fruits[] = {"apple", "pear"};
const Parameter weight = preset::number<&Basket::weight>("weight", "Weight", {0, 60, 0.1, "mm/s"}, "");
const Parameter count = preset::integer<&Basket::count>("count", "Count", {1, 6, 1}, "");
const Parameter ripe = preset::boolean<&Basket::ripe>("ripe", "Ripe", "");
const Parameter fruit = preset::choice<&Basket::fruit>("fruit", "Fruit", fruits, "");
const Parameter color = preset::color<&Basket::color>("color", "Colour", "");
const Parameter place = preset::vector<&Basket::place>("place", "Place", {-9, 9, 1, "mm"}, "");
const Parameter label = preset::text<&Basket::label>("label", "Label", 5, "");
const Parameter file = preset::path<&Basket::file>("file", "File", "");

const double nan = std::numeric_limits<double>::quiet_NaN();
const double infinity = std::numeric_limits<double>::infinity();

TEST(Parameter, GetReadsTheMemberOfItsRow) {
    const Basket basket;
    EXPECT_EQ(weight.get(&basket), Value(2.0));
    EXPECT_EQ(count.get(&basket), Value(3));
    EXPECT_EQ(ripe.get(&basket), Value(true));
    EXPECT_EQ(fruit.get(&basket), Value(1));
    EXPECT_EQ(color.get(&basket), Value(glm::dvec3(0.5)));
    EXPECT_EQ(place.get(&basket), Value(glm::dvec3(1, 2, 3)));
    EXPECT_EQ(label.get(&basket), Value(std::string("best")));
    EXPECT_EQ(file.get(&basket), Value(std::string("a.txt")));
}

TEST(Parameter, SetWritesTheMemberOfItsRow) {
    Basket basket;
    weight.set(&basket, 5.5);
    count.set(&basket, 6);
    ripe.set(&basket, false);
    fruit.set(&basket, 0);
    color.set(&basket, glm::dvec3(0, 0.5, 1));
    place.set(&basket, glm::dvec3(-9, 0, 9));
    label.set(&basket, std::string("grün"));
    file.set(&basket, std::string("b.txt"));
    EXPECT_EQ(basket.weight, 5.5);
    EXPECT_EQ(basket.count, 6);
    EXPECT_FALSE(basket.ripe);
    EXPECT_EQ(basket.fruit, Fruit::apple);
    EXPECT_EQ(basket.color, glm::dvec3(0, 0.5, 1));
    EXPECT_EQ(basket.place, glm::dvec3(-9, 0, 9));
    EXPECT_EQ(basket.label, "grün");
    EXPECT_EQ(basket.file, "b.txt");
}

TEST(Parameter, RangesAreInclusiveAndNameTheBoundWithItsUnit) {
    EXPECT_EQ(weight.check(0.0), "");
    EXPECT_EQ(weight.check(60.0), "");
    EXPECT_EQ(weight.check(-3.0), "-3 is below the minimum 0 mm/s (allowed: 0 to 60 mm/s)");
    EXPECT_EQ(weight.check(60.5), "60.5 is above the maximum 60 mm/s (allowed: 0 to 60 mm/s)");
    EXPECT_EQ(count.check(7), "7 is above the maximum 6 (allowed: 1 to 6)");
    EXPECT_EQ(place.check(glm::dvec3(0, 10, 0)), "y = 10 is above the maximum 9 mm (allowed: -9 to 9 mm)");
    EXPECT_EQ(color.check(glm::dvec3(0, 0, -1)), "blue = -1 is below the minimum 0 (allowed: 0 to 1)");
    EXPECT_NE(fruit.check(2), "");
    EXPECT_NE(fruit.check(-1), "");
}

TEST(Parameter, NotANumberAndInfinityAreNeverAllowed) {
    EXPECT_EQ(weight.check(nan), "nan is not a finite number (allowed: 0 to 60 mm/s)");
    EXPECT_THAT(weight.check(infinity), StartsWith("inf is not a finite number"));
    EXPECT_THAT(place.check(glm::dvec3(0, 0, -infinity)), StartsWith("z = -inf is not a finite number"));
}

TEST(Parameter, AValueOfAnotherTypeIsRefused) {
    EXPECT_EQ(weight.check(1), "a value of the wrong type; expected a number from 0 to 60 mm/s");
    EXPECT_NE(count.check(1.0), "");
    EXPECT_NE(ripe.check(1), "");
    EXPECT_NE(label.check(true), "");
}

TEST(Parameter, TextIsOneLineOfUtf8OfLimitedLength) {
    EXPECT_EQ(label.check(std::string("äöüßé")), "");
    EXPECT_EQ(label.check(std::string("sixsix")), "6 characters; at most 5 are allowed");
    EXPECT_EQ(label.check(std::string("a\xff")), "\"a\\xff\" is not valid UTF-8");
    EXPECT_THAT(label.check(std::string("a\nb")), HasSubstr("control character or a line break"));
    EXPECT_THAT(label.check(std::string("a\0b", 3)), HasSubstr("control character"));
}

TEST(Parameter, PathIsALocalFile) {
    for (const char* good : {"a.mp4", "clips/a.mp4", "../a.mp4", "/data/a.mp4", "a b.mp4", "..a", ""})
        EXPECT_EQ(file.check(std::string(good)), "") << good;
    for (const char* bad : {"http://x/a.mp4", "concat:a|b", "C:\\a.mp4", "file:a.mp4", "a\\b", "clips/",
                            "subfile,,start,0,end,9,,/a:b", "a\nb"})
        EXPECT_NE(file.check(std::string(bad)), "") << bad;
}

TEST(Parameter, ContainedPathStaysInItsFolder) {
    const Parameter inside = preset::required(preset::contained(file));
    for (const char* good : {"a.mp4", "clips/a.mp4", "..a.mp4", "a..", "clips/..a/b"})
        EXPECT_EQ(inside.check(std::string(good)), "") << good;
    for (const char* bad : {"", "/a.mp4", "../a.mp4", "clips/../../a.mp4", "clips/..", "..", "x/a:b", "clips/"})
        EXPECT_NE(inside.check(std::string(bad)), "") << bad;
}

TEST(Parameter, ExpectedSaysWhatIsAllowed) {
    EXPECT_EQ(weight.expected(), "a number from 0 to 60 mm/s");
    EXPECT_EQ(count.expected(), "a whole number from 1 to 6");
    EXPECT_EQ(ripe.expected(), "true or false");
    EXPECT_EQ(fruit.expected(), "one of \"apple\", \"pear\"");
    EXPECT_EQ(color.expected(), "\"#rrggbb\" or [red, green, blue], each 0 to 1");
    EXPECT_EQ(place.expected(), "[x, y, z], each -9 to 9 mm");
}

}  // namespace

}  // namespace lapfx
