// Results of lapfx batch: as a file and back, as a table, as a page.
#include "commands/batch_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "unit/preset/support.h"

namespace lapfx::commands {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

BatchResult fitted() {
    BatchResult result{.kind = ItemKind::scene,
                       .fitted = true,
                       .input = "0123",
                       .seconds = 12.34,
                       .to = 3.0,
                       .blood = {.peak = 0.1, .mean = 0.05, .before = 0.04, .after = 0.01},
                       .veil = {.peak = 0.5, .mean = 0.25},
                       .parameters = {{.key = "bleeding.speed",
                                       .unit = "mm/s",
                                       .before = 4,
                                       .after = 6.5,
                                       .low = 6,
                                       .high = 7,
                                       .determined = true},
                                      {.key = "smoke.haze.ventilation", .unit = "1/s", .before = 0.03, .after = 0.03}},
                       .pictures = {{"Reference at 1.00 s", std::string("\xFF\xD8\xFF\0 picture", 12)}},
                       .notes = {"a note"}};
    for (int i = 0; i < 15; ++i) {
        const double time = 0.2 * i;
        result.target.push_back({time, match::Amount{0.01 * i, 0.0, 0.02 * i}, {}});
        match::FrameAmounts& frame = result.after.emplace_back();
        frame.time = time, frame.blood.value = 0.01 * i, frame.veil.value = 0.03 * i;
        if (i == 3) frame.flags = match::told::dense;
    }
    result.before = result.after;
    return result;
}

BatchResult failed() {
    return {.input = "0", .faults = {"a, \"b\".mp4: <script> is broken", "second"}};
}

const std::string item = "week 2/o'p: #1 & <b>.mp4";

TEST(BatchResultTest, ComesBackFromItsText) {
    const BatchResult given = fitted(), back = parse_result(text_of(given), "result.json");
    EXPECT_EQ(back.kind, given.kind);
    EXPECT_TRUE(back.fitted);
    EXPECT_EQ(back.input, "0123");
    EXPECT_EQ(back.seconds, 12.3);
    EXPECT_EQ(back.to, 3.0);
    EXPECT_EQ(back.blood.after, 0.01);
    EXPECT_EQ(back.veil.peak, 0.5);
    EXPECT_FALSE(back.veil.after);
    EXPECT_EQ(back.parameters, given.parameters);
    ASSERT_EQ(back.target.size(), 15U);
    EXPECT_EQ(back.target[5].blood->high, 0.1);
    EXPECT_FALSE(back.target[5].veil);
    EXPECT_DOUBLE_EQ(back.after[5].veil.value, 0.15);
    EXPECT_FALSE(match::measurable(back.after[3], match::Curve::blood));
    EXPECT_TRUE(match::measurable(back.after[3], match::Curve::veil));
    EXPECT_EQ(back.pictures.at(0).jpeg, given.pictures[0].jpeg);
    EXPECT_EQ(back.notes, given.notes);
    EXPECT_EQ(parse_result(text_of(failed()), "r").faults, failed().faults);
}

TEST(BatchResultTest, ForeignTextIsNoResult) {
    const std::string good = text_of(fitted());
    std::string later = good;
    later.replace(later.find("\"version\":1"), 11, "\"version\":2");
    for (const std::string& text : {std::string(), std::string("{}"), std::string("[1]"), std::string("null"),
                                    good.substr(0, good.size() / 2), later})
        EXPECT_THAT(test::faults_of([&] { parse_result(text, "r.json"); }),
                    ElementsAre(StartsWith("r.json: is no result of lapfx batch: ")));
}

TEST(BatchResultTest, WhatIsNoPictureIsLeftOut) {
    std::string text = text_of(fitted());
    const std::size_t at = text.find("\"jpeg\":\"") + 8;
    text.replace(at, 4, "<b>\\\"");
    EXPECT_EQ(parse_result(text, "r").pictures.at(0).jpeg, "");
}

TEST(BatchTableTest, HasAColumnForEachParameterOfAny) {
    const std::string csv = table_csv({{"a.scene.json", fitted(), true}, {item, failed()}, {"z.mp4", {}}});
    std::istringstream lines(csv);
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(
        line,
        "item,kind,state,fault,blood_peak,blood_mean,blood_rms_before,blood_rms_after,veil_peak,veil_mean,"
        "veil_rms_before,veil_rms_after,seconds,report,ended_early,notes,bleeding.speed_before,bleeding.speed_after,"
        "bleeding.speed_low,bleeding.speed_high,bleeding.speed_determined,smoke.haze.ventilation_before,"
        "smoke.haze.ventilation_after,smoke.haze.ventilation_low,smoke.haze.ventilation_high,"
        "smoke.haze.ventilation_determined");
    std::getline(lines, line);
    EXPECT_EQ(
        line,
        "a.scene.json,scene,done,,0.1,0.05,0.04,0.01,0.5,0.25,,,12.34,a.scene.json/report.html,no,a note,4,6.5,6,7,yes,"
        "0.03,0.03,,,no");
    std::getline(lines, line);
    EXPECT_EQ(line, item + ",video,failed,\"a, \"\"b\"\".mp4: <script> is broken; second\",,,,,,,,,,,,,,,,,,,,,,");
    std::getline(lines, line);
    EXPECT_EQ(line, "z.mp4,video,unfinished,,,,,,,,,,,,,,,,,,,,,,,");
}

TEST(BatchIndexTest, NamesBreakNothingAndLinksStayBelow) {
    const std::string html = index_html({{item, fitted(), true}, {"<i>.mp4", failed()}, {"z.mp4", {}}});
    EXPECT_THAT(html, HasSubstr("href=\"./week%202/o%27p%3A%20%231%20%26%20%3Cb%3E.mp4/report.html\""));
    EXPECT_THAT(html, HasSubstr("&lt;script&gt; is broken<br/>second"));
    EXPECT_THAT(html, Not(HasSubstr("<script")));
    EXPECT_THAT(html, Not(HasSubstr("<i>")));
    EXPECT_THAT(html, HasSubstr("3 items, 1 done, 1 failed, 1 unfinished"));
    EXPECT_THAT(html, HasSubstr("Blood RMS 4.00 before, <strong>1.00</strong> % after. Veil not measurable."));
    EXPECT_THAT(html, HasSubstr("id=\"item-1-plot-blood\""));
    EXPECT_THAT(html, HasSubstr("--by-blood:0;--by-veil:0;--by-state:2"));
    EXPECT_THAT(html, HasSubstr("class=\"item failed\" style=\"--by-blood:1;--by-veil:1;--by-state:0\""));
    EXPECT_EQ(relative_url("a:b/\xC3\xA9.mp4"), "./a%3Ab/%C3%A9.mp4");
}

TEST(BatchEntriesTest, AreTheFoldersOfItems) {
    const test::Folder folder;
    const auto write = [&](const std::string& name, const std::string& text) {
        fs::create_directories((folder / name).parent_path());
        folder.write(name, text);
    };
    EXPECT_THAT(test::faults_of([&] { batch_entries(folder / ""); }), ElementsAre(HasSubstr("holds no results")));
    write("week/b.mp4/result.json", text_of(failed())), write("a.scene.json/result.json", text_of(fitted()));
    write("a.scene.json/report.html", "x"), write("c.mp4/running.lock", ""), write("d.mp4/result.json", "{}");
    write("e.mp4/result.json", "{\"format\":\"lapfx.batch\"");
    fs::create_directory_symlink(folder / "week", folder / "link");
    const std::vector<BatchEntry> entries = batch_entries(folder / "");
    std::vector<std::string> found;
    for (const BatchEntry& entry : entries)
        found.push_back(entry.item + ' ' + state_of(entry) + (entry.report ? " with report" : ""));
    EXPECT_THAT(found, ElementsAre("a.scene.json done with report", "c.mp4 unfinished", "e.mp4 unfinished",
                                   "week/b.mp4 failed"));
}

TEST(BatchTableTest, NoTextIsAFormula) {
    BatchResult result = failed();
    result.notes = {"+1", "-2"}, result.faults = {"@SUM(A1)"};
    const std::string csv = table_csv({{"=HYPERLINK(x).mp4", result, true}, {"b\xff\x1b.mp4", {}}});
    EXPECT_THAT(csv, HasSubstr("\n'=HYPERLINK(x).mp4,video,failed,'@SUM(A1),"));
    EXPECT_THAT(csv, HasSubstr(",'=HYPERLINK(x).mp4/report.html,"));
    EXPECT_THAT(csv, HasSubstr(",'+1; -2\n"));
    EXPECT_THAT(csv, HasSubstr("\nb\\xff\\x1b.mp4,video,"));
}

}  // namespace
}  // namespace lapfx::commands
