// Syntax: text that is not JSON is a fault at its line and column.
#include "preset/json.h"

#include <gmock/gmock.h>

#include "unit/preset/support.h"

namespace lapfx {

namespace {

using preset::Json;
using test::faults_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> syntax_faults(const std::string& text) {
    return faults_of([&] { preset::parse_json(text, "f"); });
}

TEST(Json, KeepsOrderAndDuplicates) {
    const Json json = preset::parse_json(R"({"b": 1, "a": [true, null, "x", -2.5e3], "b": {}})", "f");
    EXPECT_THAT(json.keys, ElementsAre("b", "a", "b"));
    EXPECT_EQ(json.items[0].number, 1.0);
    EXPECT_EQ(json.items[1].items.size(), 4u);
    EXPECT_TRUE(json.items[1].items[0].boolean);
    EXPECT_EQ(json.items[1].items[1].type, Json::Type::null);
    EXPECT_EQ(json.items[1].items[2].text, "x");
    EXPECT_EQ(json.items[1].items[3].number, -2500.0);
    EXPECT_EQ(json.items[2].type, Json::Type::object);
    EXPECT_EQ(json.find("b"), &json.items[0]);
    EXPECT_EQ(json.find("c"), nullptr);
}

TEST(Json, SyntaxFaultsGiveLineAndColumn) {
    struct Case {
        const char* text;
        const char* start;
    };
    const Case cases[] = {
        {"", "f: 1:1: "},
        {"{", "f: 1:2: "},
        {"{\n  \"a\": 1,\n}", "f: 3:1: "},
        {"{\"a\": nan}", "f: 1:8: "},
        {"{\"a\": NaN}", "f: 1:7: "},
        {"{\"a\": -Infinity}", "f: 1:8: "},
        {"{\"a\": .5}", "f: 1:7: "},
        {"{\"a\": 01}", "f: 1:8: "},
        {"{\"a\": +1}", "f: 1:7: "},
        {"{'a': 1}", "f: 1:2: "},
        {"{\"a\": 1} x", "f: 1:10: "},
        {"{\"a\": 1 /* c */}", "f: 1:9: "},
        {"[\"äö\", x]", "f: 1:8: "},
        {"{\"a\" 1}", "f: 1:6: "},
    };
    for (const Case& c : cases) EXPECT_THAT(syntax_faults(c.text), ElementsAre(StartsWith(c.start))) << c.text;
}

TEST(Json, MessagesAreShortPrintableAndOursAlone) {
    EXPECT_THAT(syntax_faults("{\"a\": \"" + std::string(5000, 'x')),
                ElementsAre(testing::ResultOf([](const std::string& line) { return line.size(); }, testing::Lt(300u))));
    EXPECT_THAT(syntax_faults("[1,]"), ElementsAre(testing::Not(HasSubstr("json.exception"))));
}

TEST(Json, NumbersBeyondDoubleAreFaults) {
    EXPECT_THAT(syntax_faults("[1e999]"), ElementsAre(HasSubstr("number overflow")));
    EXPECT_THAT(syntax_faults("[-" + std::string(400, '9') + "]"), ElementsAre(HasSubstr("number overflow")));
    EXPECT_EQ(preset::parse_json("[18446744073709551616]", "f").items[0].number, 18446744073709551616.0);
}

TEST(Json, InvalidUtf8IsAFault) {
    EXPECT_THAT(syntax_faults("[\"\xff\"]"), ElementsAre(HasSubstr("ill-formed UTF-8")));
    EXPECT_THAT(syntax_faults("[\"\xc0\xaf\"]"), ElementsAre(HasSubstr("ill-formed UTF-8")));
    EXPECT_THAT(syntax_faults("[\"\\ud800\"]"), ElementsAre(StartsWith("f: 1:")));
    EXPECT_EQ(syntax_faults("[\"\xff\"]")[0].find('\xff'), std::string::npos);
}

TEST(Json, ZeroByteDoesNotEndTheText) {
    EXPECT_THAT(syntax_faults(std::string("{}\0garbage", 10)), ElementsAre("f: 1:3: a zero byte"));
    for (const std::string& utf16 : {std::string("\xff\xfe{\0}\0", 6), std::string("\xfe\xff\0{\0}", 6),
                                     std::string("{\0}\0", 4), std::string("\0{\0}", 4)})
        EXPECT_THAT(syntax_faults(utf16), ElementsAre("f: is UTF-16 text; JSON is read as UTF-8"));
}

TEST(Json, LimitsOnDepthValuesAndSize) {
    EXPECT_THAT(syntax_faults(std::string(100'000, '[')), ElementsAre("f: nested deeper than 32 levels"));
    std::string objects;
    for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
    EXPECT_THAT(syntax_faults(objects), ElementsAre("f: nested deeper than 32 levels"));
    EXPECT_TRUE(syntax_faults(std::string(32, '[') + std::string(32, ']')).empty());

    std::string many = "[0";
    for (int i = 0; i < 100'000; ++i) many += ",0";
    EXPECT_THAT(syntax_faults(many + "]"), ElementsAre("f: more than 100000 values"));

    EXPECT_THAT(syntax_faults(std::string(5'000'000, ' ')), ElementsAre("f: 5000000 bytes; at most 4194304 are read"));
}

}  // namespace

}  // namespace lapfx
