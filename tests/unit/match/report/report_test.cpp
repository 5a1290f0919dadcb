// The report of a fit: every figure is in it, no name breaks it, and it is well-formed.
#include "match/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "match/report/markup.h"

namespace lapfx::match {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr int times = 16;  // 0.2 s apart
const std::string jpeg("\xFF\xD8\xFF\xE0 a picture", 14);

Amount amount(double value) {
    return {value, std::max(value - 0.02, 0.0), value + 0.02};
}

/// Blood 0.01 a second, veil 0.05; half of both before, all of them after.
FitReport usual() {
    FitReport report{.of = {.scene = "stomach.scene.json",
                            .reference = "operation.mp4",
                            .preset = "usual.json",
                            .fitted = "fitted.json",
                            .fitted_scene = "fitted.scene.json",
                            .seconds = 12.34,
                            .notes = {"12 frames: the camera moves"}},
                     .found = {.fit = {.offset = 0.5, .to = 3.0, .seed = 7}, .result = FitResult{}}};
    for (int i = 0; i < times; ++i) {
        const double time = 0.2 * i;
        report.found.target.push_back({time, amount(0.01 * time), amount(0.05 * time)});
        FrameAmounts& after = report.found.result->after.emplace_back();
        after.time = time, after.blood = amount(0.01 * time), after.veil = amount(0.05 * time);
        FrameAmounts& before = report.found.result->before.emplace_back();
        before.time = time, before.blood = amount(0.005 * time), before.veil = amount(0.025 * time);
    }
    FitResult& result = *report.found.result;
    result.blood_before = 0.0123, result.blood_after = 0.0045, result.veil_before = 0.0678, result.veil_after = 0.0091;
    result.curves = 6, result.evaluations = 345;
    const std::vector<std::string> keys = {"bleeding.speed", "smoke.haze.accumulation", "smoke.haze.ventilation"};
    const std::vector<FreeParameter> free = free_parameters({}, keys);
    result.parameters = {
        {.parameter = free[0], .before = 6.0, .after = 8.75, .low = 5.71, .high = 13.3, .determined = true},
        {.parameter = free[1],
         .before = 0.026,
         .after = 0.2,
         .low = 0.15,
         .high = 0.2,
         .determined = true,
         .at_bound = true},
        {.parameter = free[2], .before = 0.03, .after = 0.03, .why = "the video ends; 4 s of clearing would tell it"},
    };
    return report;
}

std::string with_pictures(FitReport report) {
    report.moments = report_moments(report.found.target);
    for (ReportMoment& moment : report.moments) moment.reference = moment.before = moment.after = jpeg;
    return report_html(report);
}

/// The text of a page as a reader sees it: one blank for whatever lies between words.
std::string words_of(const std::string& html) {
    const std::string body = html.substr(html.find("<body>"));
    return std::regex_replace(std::regex_replace(body, std::regex("<[^>]*>"), " "), std::regex("\\s+"), " ");
}

int count(const std::string& html, const std::string& part) {
    int found = 0;
    for (std::size_t at = html.find(part); at != std::string::npos; at = html.find(part, at + 1)) ++found;
    return found;
}

/// What a strict parser of XML would refuse: elements that are not closed in their order, attributes that are not
/// quoted or come twice, ids that come twice, and '&' that begins no reference. Empty: well-formed.
std::string fault_of(const std::string& html) {
    static const std::regex mark(R"re(<(/?)([a-zA-Z][a-zA-Z0-9]*)((?:\s+[a-zA-Z][a-zA-Z0-9-]*="[^"<]*")*)\s*(/?)>)re");
    static const std::regex attribute(R"re(([a-zA-Z-]+)="([^"]*)")re");
    static const std::regex reference("^&(amp|lt|gt|quot|#[0-9]+);");
    std::vector<std::string> open, ids;
    for (std::size_t at = html.find("<html"); at < html.size(); ++at) {
        std::smatch found;
        const std::string rest = html.substr(at, 400'000);
        if (html[at] == '&' && !std::regex_search(rest, found, reference)) return "bare & at " + rest.substr(0, 40);
        if (html[at] != '<') continue;
        const std::string tag = html.substr(at, html.find('>', at) + 1 - at);
        if (!std::regex_match(tag, found, mark)) return "no element: " + tag.substr(0, 80);
        std::vector<std::string> names;
        const std::string attributes = found[3];
        for (std::sregex_iterator a(attributes.begin(), attributes.end(), attribute), end; a != end; ++a) {
            names.push_back((*a)[1]);
            if (names.back() == "id") ids.push_back((*a)[2]);
        }
        std::sort(names.begin(), names.end());
        if (std::adjacent_find(names.begin(), names.end()) != names.end()) return "twice in " + tag;
        if (found[1].length() > 0) {
            if (open.empty() || open.back() != found[2]) return "closes what is not open: " + tag;
            open.pop_back();
        } else if (found[4].length() == 0) {
            open.push_back(found[2]);
        }
        at += tag.size() - 1;
    }
    std::sort(ids.begin(), ids.end());
    if (std::adjacent_find(ids.begin(), ids.end()) != ids.end()) return "an id that comes twice";
    return open.empty() ? "" : "left open: " + open.back();
}

TEST(Report, TellsEachParameter) {
    const std::string words = words_of(report_html(usual()));
    EXPECT_THAT(words, HasSubstr("Speed bleeding.speed 6 mm/s 8.75 mm/s 5.71 to 13.3 mm/s "));
    EXPECT_THAT(words, HasSubstr("0.026 1/s 0.2 1/s 0.15 to 0.2 1/s ; at its bound, the curves would take it farther"));
    EXPECT_THAT(words, HasSubstr("smoke.haze.ventilation 0.03 1/s kept not determined: the video ends; 4 s of clearing "
                                 "would tell it"));
    EXPECT_THAT(words, Not(HasSubstr("none of the parameters")));
}

TEST(Report, TellsHowCloseItIs) {
    const std::string words = words_of(report_html(usual()));
    EXPECT_THAT(words, HasSubstr("After: blood and veil match within the error of measuring"));
    EXPECT_THAT(words, HasSubstr("Before: veil is 50 % too thin"));
    EXPECT_THAT(words, HasSubstr("Blood 1.23 0.45 Veil 6.78 0.91"));
}

TEST(Report, TellsWhatWasDone) {
    const std::string words = words_of(report_html(usual()));
    for (const char* said :
         {"Fit of stomach.scene.json to operation.mp4", "Preset before usual.json", "Preset after fitted.json",
          "Scene after fitted.scene.json", "Window 0.00 to 3.00 s", "Compared 16 moments", "Offset 0.5 s", "Seed 7",
          "Curves drawn 6", "Evaluations 345", "Took 12.3 s", "12 frames: the camera moves"})
        EXPECT_THAT(words, HasSubstr(said));
    EXPECT_THAT(words, Not(HasSubstr("ended early")));
    FitReport without = usual();
    without.of.preset.clear();
    EXPECT_THAT(words_of(report_html(without)), HasSubstr("Preset before built-in values"));
}

TEST(Report, IsWellFormed) {
    EXPECT_EQ(fault_of(with_pictures(usual())), "");
    EXPECT_EQ(fault_of(report_html({.found = {.result = FitResult{}}})), "");
    EXPECT_NE(fault_of("<html><p></html>"), "");
    EXPECT_NE(fault_of("<html><p class=a></p></html>"), "");
    EXPECT_NE(fault_of("<html>a & b</html>"), "");
}

TEST(Report, LoadsAndRunsNothing) {
    const std::string html = with_pictures(usual());
    EXPECT_THAT(html, HasSubstr("content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:\""));
    for (const char* loads : {"<script", "<link", "<iframe", "url(", "@import", "href=", "onload", "src=\"http"})
        EXPECT_THAT(html, Not(HasSubstr(loads)));
    EXPECT_LT(html.find("Content-Security-Policy"), html.find("<style>"));
}

TEST(Report, ShowsNamesAsTheyAre) {
    FitReport report = usual();
    report.of.scene = "<script>alert(1)</script>.scene.json";
    report.of.reference = "a\" onerror='x' & <b>.mp4";
    report.of.preset = "\xFF\x01 no letters.json";
    report.of.fitted = "cod.\xE2\x80\xAEgpj.json";  // U+202E: turns the letters after it around
    report.of.notes = {"</li><img src=x>"};
    report.found.result->parameters[2].why = "a < b & c";
    const std::string html = with_pictures(report);
    EXPECT_EQ(fault_of(html), "");
    EXPECT_EQ(count(html, "<script"), 0);
    EXPECT_THAT(html, HasSubstr("&lt;script&gt;alert(1)&lt;/script&gt;.scene.json"));
    EXPECT_THAT(html, HasSubstr("a&quot; onerror=&#39;x&#39; &amp; &lt;b&gt;.mp4"));
    EXPECT_THAT(html, HasSubstr("\xEF\xBF\xBD\xEF\xBF\xBD no letters.json"));
    EXPECT_THAT(html, HasSubstr("cod.\xEF\xBF\xBDgpj.json"));
    EXPECT_THAT(html, HasSubstr("&lt;/li&gt;&lt;img src=x&gt;"));
    EXPECT_THAT(html, HasSubstr("a &lt; b &amp; c"));
}

TEST(Report, SaysThatAnAmountIsMissing) {
    FitReport report = usual();
    for (TargetPoint& point : report.found.target) point.blood.reset();
    report.found.result->blood_before.reset(), report.found.result->blood_after.reset();
    const std::string html = with_pictures(report), words = words_of(html);
    EXPECT_EQ(fault_of(html), "");
    EXPECT_THAT(words, HasSubstr("Blood not measurable Veil 6.78 0.91"));
    EXPECT_THAT(words, HasSubstr("Reference: not measurable. Before: at most 1.5 %, at 3 s."));
    EXPECT_THAT(words, HasSubstr("Reference blood unknown, veil 15.0 %"));
    EXPECT_THAT(words, Not(HasSubstr("most blood")));
    EXPECT_EQ(count(html, "class=\"band\" points"), 1);  // the veil has one
    EXPECT_EQ(count(html, "class=\"gap\""), 2);          // over all of the blood's time, and in its legend
}

TEST(Report, ComparesOnlyWhatTheReferenceHas) {
    FitReport report = usual();
    for (TargetPoint& point : report.found.target) point.blood.reset();
    EXPECT_THAT(words_of(report_html(report)),
                HasSubstr("After: blood is at no time measurable in both; veil matches"));
    for (TargetPoint& point : report.found.target) point.veil.reset();
    EXPECT_THAT(words_of(report_html(report)),
                HasSubstr("After: blood is at no time measurable in both; veil is at no time measurable in both"));
}

TEST(Report, SaysThatNothingIsDetermined) {
    FitReport report = usual();
    for (FittedParameter& p : report.found.result->parameters)
        p.determined = p.at_bound = false, p.why = "it is dark", p.after = p.before;
    const std::string words = words_of(report_html(report));
    EXPECT_THAT(words, HasSubstr("The reference determines none of the parameters: all keep their values."));
    EXPECT_THAT(words, HasSubstr("bleeding.speed 6 mm/s kept not determined: it is dark"));
}

TEST(Report, ShowsTheValueThatIsThereWhereAFitEndedBeforeItWasKnown) {
    FitReport report = usual();
    for (FittedParameter& p : report.found.result->parameters)
        p.determined = p.at_bound = false, p.why = "it ended", p.after = 2.0 * p.before;
    EXPECT_THAT(words_of(report_html(report)), HasSubstr("bleeding.speed 6 mm/s 12 mm/s not determined: it ended"));
}

TEST(Report, SaysThatItEndedEarly) {
    FitReport report = usual();
    report.found.result->ended_early = true;
    EXPECT_THAT(words_of(report_html(report)), HasSubstr("The fit ended early"));
    report.found.result->before.clear(), report.found.result->after.clear(), report.found.result->parameters.clear();
    const std::string html = with_pictures(report), words = words_of(html);
    EXPECT_EQ(fault_of(html), "");
    EXPECT_THAT(words, HasSubstr("The fit ended before the scene was measured: nothing is compared."));
    EXPECT_THAT(words, HasSubstr("Parameters None was fitted: all keep their values."));
    EXPECT_THAT(words, Not(HasSubstr("in common")));
    EXPECT_THAT(words, Not(HasSubstr("Root mean square")));
    EXPECT_THAT(words, HasSubstr("3.00 s: most blood and most veil Reference blood 3.0 %"));
}

TEST(Report, DrawsNoLineAcrossWhatIsNotMeasurable) {
    FitReport report = usual();
    for (int i = 5; i < 9; ++i) report.found.target[static_cast<std::size_t>(i)].veil.reset();
    const std::string html = report_html(report);
    EXPECT_EQ(count(html, "<polyline class=\"reference\""), 3);  // one of blood, two of veil
    EXPECT_EQ(count(html, "class=\"band\" points"), 3);
    EXPECT_EQ(count(html, "class=\"gap\""), 2);
    // Nor where the reference has no frame; what remains alone is a dot.
    report = usual();
    report.found.target.erase(report.found.target.begin() + 1, report.found.target.begin() + 4);
    report.found.result->before.clear(), report.found.result->after.clear();
    EXPECT_EQ(count(report_html(report), "<circle class=\"dot reference\""), 2);
}

TEST(Report, DrawsWhatItWasGiven) {
    FitReport report = usual();
    const std::string html = report_html(report);
    EXPECT_EQ(count(html, "<svg"), 2);
    // Veil: 17 % at most in the interval, so the axis ends at 20 %; 0 s at the left, 3 s at the right.
    const std::string veil = html.substr(html.find("id=\"plot-veil\""));
    EXPECT_THAT(veil, HasSubstr("<polyline class=\"after\" points=\"46.0,244.0 "));
    EXPECT_THAT(veil, HasSubstr("468.0,107.5 \"/>"));  // 15 %: 244 - 0.75 * 182
    EXPECT_THAT(veil, HasSubstr(">20</text>"));
    EXPECT_THAT(veil, HasSubstr(">0.5</text>"));
    EXPECT_THAT(html, Not(HasSubstr(">-0")));
}

TEST(Report, ShowsThreeMoments) {
    FitReport report = usual();
    report.found.target[4].blood = amount(0.2);
    const auto moments = report_moments(report.found.target);
    ASSERT_EQ(moments.size(), 3U);
    EXPECT_EQ(moments[0].name, "most blood");
    EXPECT_NEAR(moments[0].time, 0.8, 1e-12);
    EXPECT_EQ(moments[1].name, "most veil");
    EXPECT_NEAR(moments[1].time, 3.0, 1e-12);
    EXPECT_EQ(moments[2].name, "in the middle");
    EXPECT_NEAR(moments[2].time, 1.5, 0.11);
    const std::string html = with_pictures(report);
    EXPECT_EQ(count(html, "<img src=\"data:image/jpeg;base64," + base64(jpeg) + "\""), 9);
    EXPECT_THAT(words_of(html), HasSubstr("0.80 s: most blood Reference blood 20.0 %, veil 4.0 % Before blood 0.4 %, "
                                          "veil 2.0 % After blood 0.8 %, veil 4.0 %"));
}

TEST(Report, ShowsAMomentOnce) {
    const auto moments = report_moments(usual().found.target);
    ASSERT_EQ(moments.size(), 2U);
    EXPECT_EQ(moments[0].name, "most blood and most veil");
    EXPECT_TRUE(report_moments({}).empty());
    std::vector<TargetPoint> none = usual().found.target;
    for (TargetPoint& point : none) point.blood = point.veil = Amount{};
    ASSERT_EQ(report_moments(none).size(), 1U);
    EXPECT_EQ(report_moments(none)[0].name, "in the middle");
}

TEST(Report, LeavesOutAPictureThatTheReferenceDoesNotHave) {
    FitReport report = usual();
    report.moments = report_moments(report.found.target);
    for (ReportMoment& moment : report.moments) moment.before = moment.after = jpeg;
    EXPECT_EQ(count(report_html(report), "<img"), 4);
}

TEST(Report, ColoursAreTold) {
    FitReport report = usual();
    EXPECT_THAT(words_of(report_html(report)), Not(HasSubstr("Colours")));
    report.found.colors = {"blood: Delta E 7.4 before, 0.9 after", "<b>"};
    const std::string html = report_html(report);
    EXPECT_THAT(words_of(html), HasSubstr("Colours blood: Delta E 7.4 before, 0.9 after"));
    EXPECT_EQ(fault_of(html), "");
}

}  // namespace
}  // namespace lapfx::match
