#include "ui/value/expression.h"
#include "support/folders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <vector>

namespace lapfx::ui {
namespace {

/// The value; a fault fails the test and gives -12345.
double value(std::string_view text, const ExpressionContext& context = {}) {
    const auto result = evaluate(text, context);
    if (const auto* error = std::get_if<ExpressionError>(&result)) {
        ADD_FAILURE() << text << ": " << error->at << ' ' << error->reason;
        return -12345;
    }
    return std::get<double>(result);
}

/// "byte: reason"; "no fault" where there is none.
std::string fault(std::string_view text, const ExpressionContext& context = {}) {
    const auto result = evaluate(text, context);
    const auto* error = std::get_if<ExpressionError>(&result);
    return error == nullptr ? "no fault" : std::to_string(error->at) + ": " + error->reason;
}

TEST(Expression, CalculatesAsSchoolTeaches) {
    EXPECT_DOUBLE_EQ(value("12/2.2"), 12 / 2.2);
    EXPECT_EQ(value("2*(3+4)"), 14);
    EXPECT_EQ(value("2+3*4"), 14);
    EXPECT_EQ(value("10-4-3"), 3);
    EXPECT_EQ(value("64/4/2"), 8);
    EXPECT_EQ(value("2^3^2"), 512) << "from the right";
    EXPECT_EQ(value("-2^2"), -4);
    EXPECT_EQ(value("2^-1"), 0.5);
    EXPECT_EQ(value("--3"), 3);
    EXPECT_EQ(value("2 - -3"), 5);
    EXPECT_EQ(value(" \t7 "), 7);
    EXPECT_EQ(value("6 \u00D7 7 \u2212 4 \u00F7 2"), 40) << "as pasted from a text";
    EXPECT_FALSE(std::signbit(value("-0")));
}

TEST(Expression, ReadsNumbersInAllTheirForms) {
    EXPECT_EQ(value("1e3"), 1000);
    EXPECT_EQ(value("2.5E-2"), 0.025);
    EXPECT_EQ(value(".5"), 0.5);
    EXPECT_EQ(value("5."), 5);
    EXPECT_EQ(value("1,5"), 1.5);
    EXPECT_EQ(value(",5"), 0.5);
    EXPECT_EQ(value("sqrt(6,25)"), 2.5);
    EXPECT_EQ(value("1e+22"), 1e22) << "what format_exact writes";
}

TEST(Expression, ACommaPartsValuesOnlyWhereAListIsMeant) {
    EXPECT_EQ(value("max(1,5)"), 5);
    EXPECT_EQ(value("max(1.5,1.25)"), 1.5);
    EXPECT_EQ(value("max((1,5); 1)"), 1.5);
    EXPECT_EQ(value("min(3; 2; 4)"), 2);
    EXPECT_EQ(value("max(2, sqrt(2,25)) + 0,5"), 2.5);
    EXPECT_EQ(fault("1,234,5"), "5: expected an operator: + - * / ^");
}

TEST(Expression, KnowsFunctionsAndConstants) {
    EXPECT_EQ(value("abs(-3) + round(2.5) + sqrt(16)"), 3 + 3 + 4);
    EXPECT_DOUBLE_EQ(value("2*\u03C0"), 2 * std::numbers::pi);
    EXPECT_DOUBLE_EQ(value("2*pi"), 2 * std::numbers::pi);
}

TEST(Expression, RefersToTheCurrentValue) {
    const ExpressionContext context{.unit = "mm", .hundred_percent = 60, .current = 8};
    EXPECT_EQ(value("x", context), 8);
    EXPECT_EQ(value("x*2 + 1", context), 17);
    EXPECT_EQ(value("+= 2", context), 10);
    EXPECT_EQ(value("-=2", context), 6);
    EXPECT_EQ(value("*= 2+1", context), 24);
    EXPECT_EQ(value("/=4", context), 2);
    EXPECT_EQ(value("+=1 cm", context), 18);
    EXPECT_EQ(value("-2", context), -2) << "a sign is no change";
    EXPECT_EQ(fault("/=0", context), "0: division by 0");
    EXPECT_EQ(fault("+=", context), "2: expected a number");
}

TEST(Expression, ConvertsUnitsOfTheSameKind) {
    struct Case {
        const char *text, *unit;
        double expected;
    };
    const Case cases[] = {
        {"250 ms", "s", 0.25},
        {"1.2cm", "mm", 12},
        {"1 in", "mm", 25.4},
        {"500 um", "mm", 0.5},
        {"500 \u00B5m", "mm", 0.5},
        {"500 \u03BCs", "ms", 0.5},
        {"2 min", "s", 120},
        {"1.5 h", "min", 90},
        {"0.5 m", "cm", 50},
        {"5 cm/s", "mm/s", 50},
        {"0.06 m/s", "mm/s", 60},
        {"3.141592653589793 rad", "deg", 180},
        {"72 bpm", "Hz", 1.2},
        {"0.3 kHz", "Hz", 300},
        {"30 1/min", "1/s", 0.5},
        {"6/s", "1/s", 6},
        {"120/min", "1/s", 2},
        {"2 Hz", "bpm", 120},
        {"3 pixels", "px", 3},
        {"40%", "%", 40},
        {"0.3 s + 200 ms", "s", 0.5},
        {"(1+2) cm", "mm", 30},
        {"-(2 cm)", "mm", -20},
        {"5 mm\u00A0+ 1", "mm", 6},
        {"90\u00B0", "rad", 1.5707963267948966},
        {"120 degC", "\u00B0C", 120},
    };
    for (const Case& c : cases)
        EXPECT_NEAR(value(c.text, {.unit = c.unit}), c.expected, 1e-12 * std::abs(c.expected)) << c.text;
}

TEST(Expression, TheFieldsOwnUnitChangesNothing) {
    for (const char* unit :
         {"mm", "s", "mm\u00B2/s", "rad", "1/s", "/min", "%", "levels", "clip heights/s", "x", "pixels", "\u00B0"}) {
        EXPECT_EQ(value("0.1 " + std::string(unit), {.unit = unit}), 0.1) << unit;
        EXPECT_EQ(value("0.1", {.unit = unit}), 0.1) << unit;
    }
    EXPECT_EQ(value("2x", {.unit = "x", .current = 7}), 2);
    EXPECT_EQ(value("x*2x", {.unit = "x", .current = 7}), 14);
}

TEST(Expression, TakesEveryUnitOfTheEffectsParameters) {
    std::set<std::string> found;
    const std::regex row(R"re(\{[-0-9., ]+, "([^"]+)"[,}])re");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(test::source_folder() / "effects")) {
        if (entry.path().filename() != "parameters.cpp") continue;
        std::stringstream text;
        text << std::ifstream(entry.path()).rdbuf();
        const std::string source = text.str();
        for (std::sregex_iterator match(source.begin(), source.end(), row), end; match != end; ++match)
            found.insert((*match)[1]);
    }
    EXPECT_GE(found.size(), 10u);
    for (const std::string& unit : found) {
        EXPECT_EQ(value("2.5 " + unit, {.unit = unit}), 2.5) << unit;
        EXPECT_EQ(value("10%", {.unit = unit, .hundred_percent = 60}), 6) << unit;
    }
}

TEST(Expression, PercentIsAShareOrAFactor) {
    const ExpressionContext context{.unit = "mm", .hundred_percent = 60, .current = 8};
    EXPECT_EQ(value("40%", context), 24);
    EXPECT_EQ(value("50% + 1", context), 31);
    EXPECT_EQ(value("50% * 2", context), 60);
    EXPECT_EQ(value("x * 50%", context), 4) << "half of it, not 8 times 30";
    EXPECT_EQ(value("*= 150%", context), 12);
    EXPECT_EQ(value("10 mm / 50%", context), 20);
    EXPECT_EQ(value("+= 10%", context), 14);
    EXPECT_EQ(value("40%"), 0.4) << "of a plain number";
    EXPECT_EQ(value("50% * 50%", {.unit = "%"}), 25);
}

TEST(Expression, UnitsAreNotMultipliedIntoOtherKinds) {
    EXPECT_EQ(value("2 * 3 mm", {.unit = "mm"}), 6);
    EXPECT_EQ(value("1 cm / 2 mm * 1 mm", {.unit = "mm"}), 5) << "a ratio is a plain number";
    EXPECT_EQ(value("abs(-2) * 3 mm", {.unit = "mm"}), 6);
    EXPECT_EQ(value("sqrt(4 mm) * 3 mm", {.unit = "mm"}), 6) << "a root has no unit any more";
    EXPECT_EQ(value("6/min(2; 3) + 1"), 4) << "not 6 a minute";
    EXPECT_EQ(fault("2 mm * 3 mm", {.unit = "mm"}), "5: only one side of * can have a unit");
    EXPECT_EQ(fault("abs(2 mm) * 3 mm", {.unit = "mm"}), "10: only one side of * can have a unit");
    EXPECT_EQ(fault("(2 mm)^2", {.unit = "mm"}), "6: a value with a unit cannot be used with ^");
    EXPECT_EQ(fault("(2 mm) cm", {.unit = "mm"}), "7: there is a unit already");
}

TEST(Expression, FaultsNameTheirByteAndWhatIsAllowed) {
    EXPECT_EQ(fault("2 mm", {.unit = "s"}), "2: mm is not a time: allowed are us, ms, s, min, h, %");
    EXPECT_EQ(fault("2 Furlong", {.unit = "mm"}), "2: Furlong is not a unit: allowed are um, mm, cm, m, in, %");
    EXPECT_EQ(fault("2 mm"), "2: mm: the value has no unit: allowed is %");
    EXPECT_EQ(fault("2 mm", {.unit = "levels"}), "2: mm does not go with levels: allowed are levels, %");
    EXPECT_EQ(fault("2 mms", {.unit = "mm"}), "2: mms is not a unit: allowed are um, mm, cm, m, in, %");
    EXPECT_EQ(fault("2 MM", {.unit = "mm"}), "2: MM is not a unit: allowed are um, mm, cm, m, in, %");
    EXPECT_EQ(fault("2 s", {.unit = "%"}), "2: s is not a share: allowed is %");
    EXPECT_EQ(fault(""), "0: expected a number");
    EXPECT_EQ(fault("  "), "2: expected a number");
    EXPECT_EQ(fault("1+"), "2: expected a number");
    EXPECT_EQ(fault("1 2"), "2: expected an operator: + - * / ^");
    EXPECT_EQ(fault("(1+2"), "4: expected )");
    EXPECT_EQ(fault("1)"), "1: no bracket is open");
    EXPECT_EQ(fault("sqrt 4"), "5: expected ( after sqrt");
    EXPECT_EQ(fault("sqrt(4; 5)"), "6: sqrt takes one value");
    EXPECT_EQ(fault("max()"), "4: expected a number");
    EXPECT_EQ(fault("foo+1"), "0: foo is not known: allowed are pi, x, sqrt, abs, min, max, round");
    EXPECT_EQ(fault("sin(1)"), "0: sin is not known: allowed are pi, x, sqrt, abs, min, max, round");
    EXPECT_EQ(fault("2 ml", {.unit = "mm"}), "2: ml is not a unit: allowed are um, mm, cm, m, in, %");
    EXPECT_EQ(fault("\xFF"),
              std::string("0: \xFF is not known") + fault("foo").substr(std::string("0: foo is not known").size()));
    EXPECT_EQ(fault(std::string_view("1\0", 2)), "1: expected an operator: + - * / ^");
}

TEST(Expression, NeverGivesWhatIsNoNumber) {
    EXPECT_EQ(fault("1/0"), "1: division by 0");
    EXPECT_EQ(fault("5 + sqrt(-1)"), "4: sqrt has no value there");
    EXPECT_EQ(fault("(-8)^0.5"), "4: this has no value");
    EXPECT_EQ(fault("10^999"), "2: the result is too large");
    EXPECT_EQ(fault("1e999"), "0: too large or too small a number");
    EXPECT_EQ(fault("1e308*10"), "5: the result is too large");
    EXPECT_EQ(fault("1e308+1e308"), "5: the result is too large");
    EXPECT_EQ(fault("1e308 m", {.unit = "um"}), "0: the result is too large");
    EXPECT_EQ(fault("x", {.current = std::numeric_limits<double>::quiet_NaN()}), "0: this has no value");
}

TEST(Expression, IsBoundedInLengthAndDepth) {
    const auto nested = [](int depth) { return std::string(depth, '(') + "1" + std::string(depth, ')'); };
    EXPECT_EQ(value(nested(64)), 1);
    EXPECT_EQ(fault(nested(65)), "64: more than 64 brackets deep");
    std::string roots;
    for (int i = 0; i < 40; ++i) roots += "abs(";
    EXPECT_EQ(value(roots + "1" + std::string(40, ')')), 1);
    std::string side_by_side;
    for (int i = 0; i < 10; ++i) side_by_side += nested(8) + '+';
    EXPECT_EQ(value(side_by_side + "0"), 10) << "80 brackets, but 8 deep";
    std::string calls;
    for (int i = 0; i < 20; ++i) calls += "abs(1)+";
    EXPECT_EQ(value(calls + nested(50)), 21);
    EXPECT_EQ(value(std::string(255, '-') + "1"), -1);
    EXPECT_EQ(fault(std::string(256, '-') + "1"), "256: longer than 256 bytes");
    std::string powers = "1";
    while (powers.size() < 255) powers += "^1";
    EXPECT_EQ(value(powers), 1);
    EXPECT_EQ(value("1" + std::string(255, ' ')), 1);
    EXPECT_EQ(value("0." + std::string(254, '3')), 1.0 / 3);
}

TEST(Expression, AnyTextGivesANumberOrAFaultWithinIt) {
    const std::vector<std::string> pieces = {
        "1",    "2.5",  "9e99",   ".",      ",",  ";",      "+",      "-",    "*",     "/",    "^",
        "(",    ")",    "(",      ")",      " ",  "e",      "pi",     "x",    "sqrt(", "sin(", "min(",
        "max(", "abs(", "round(", "e2",     "mm", "cm",     "s",      "ms",   "mm/s",  "1/s",  "/min",
        "%",    "degC", "deg",    "levels", "+=", "\u00D7", "\u00B0", "\xFF", "\xC2",  "0",    "1e308"};
    const char* fields[] = {"", "mm", "s", "mm/s", "1/s", "%", "\u00B0C", "levels", "x", "deg"};
    std::mt19937 random(1);
    int numbers = 0;
    for (int i = 0; i < 100000; ++i) {
        std::string text;
        for (auto count = random() % (i % 100 == 0 ? 200 : 5); count > 0; --count)
            text += pieces[random() % pieces.size()];
        const ExpressionContext context{
            .unit = fields[random() % std::size(fields)], .hundred_percent = 60, .current = 3};
        const auto result = evaluate(text, context);
        if (const auto* error = std::get_if<ExpressionError>(&result)) {
            ASSERT_LE(error->at, text.size()) << text;
            ASSERT_FALSE(error->reason.empty()) << text;
        } else {
            ++numbers;
            ASSERT_TRUE(std::isfinite(std::get<double>(result))) << text;
        }
    }
    EXPECT_GT(numbers, 4000) << "or the pieces are ill chosen";
}

TEST(Expression, AnyBytesGiveANumberOrAFaultWithinThem) {
    std::mt19937 random(2);
    for (int i = 0; i < 100000; ++i) {
        std::string text(random() % 40, ' ');
        for (char& c : text) c = static_cast<char>(random() % 2 == 0 ? random() % 256 : 0x20 + random() % 0x60);
        const auto result = evaluate(text, {.unit = "mm"});
        const auto* error = std::get_if<ExpressionError>(&result);
        ASSERT_LE(error == nullptr ? 0 : error->at, text.size()) << text;
    }
}

/// Computes a sum of products in plain C++ and writes it out with random spaces. The parser has to find the same value.
TEST(Expression, RandomSumsAgreeWithTheirValue) {
    std::mt19937 random(3);
    for (int i = 0; i < 100000; ++i) {
        std::string text;
        double sum = 0;
        const auto space = [&] { return std::string(random() % 2, ' '); };
        for (auto terms = 1 + random() % 5; terms > 0; --terms) {
            const bool minus = random() % 2 == 0;
            double product = 1;
            std::string factors;
            for (auto count = 1 + random() % 3; count > 0; --count) {
                const int number = static_cast<int>(1 + random() % 99);
                const bool divides = !factors.empty() && random() % 2 == 0;
                product = factors.empty() ? number : divides ? product / number : product * number;
                factors += (factors.empty() ? "" : divides ? "/" : "*") + space() + std::to_string(number) + space();
            }
            if (random() % 4 == 0) factors = "(" + factors + ")";
            text += (minus ? "-" : "+") + space() + factors;
            sum += minus ? -product : product;
        }
        ASSERT_NEAR(value(text), sum, 1e-9) << text;
    }
}

}  // namespace
}  // namespace lapfx::ui
