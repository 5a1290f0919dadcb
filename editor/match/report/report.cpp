#include "match/report/report.h"

#include <algorithm>
#include <cmath>

#include "match/compare/likeness.h"
#include "match/fit/worse.h"
#include "match/report/markup.h"
#include "match/report/page.h"
#include "match/report/report_plot.h"
#include "match/video/shots.h"

namespace lapfx::match {

namespace {

std::string paragraph(const std::string& html, const std::string& look = {}) {
    return "<p" + (look.empty() ? "" : " class=\"" + look + "\"") + ">" + html + "</p>\n";
}

std::string with_unit(const std::string& value, const FittedParameter& p) {
    return "<span class=\"value\">" + value +
           (p.parameter.row->unit.empty() ? "" : " " + escaped(p.parameter.row->unit)) + "</span>";
}

/// What the fit aimed at, as frames: compared at the very times at which the scene was measured.
std::vector<FrameAmounts> frames_of(std::span<const TargetPoint> target) {
    std::vector<FrameAmounts> frames;
    for (const TargetPoint& aim : target) {
        FrameAmounts& frame = frames.emplace_back();
        frame.time = aim.time;
        frame.blood = aim.blood.value_or(Amount{});
        frame.veil = aim.veil.value_or(Amount{});
        frame.flags = !aim.veil ? told::not_measurable : !aim.blood ? told::dense : 0U;
    }
    return frames;
}

std::string worse(const FitResult& result) {
    std::string all;
    for (const std::string& line : what_is_worse(result)) all += (all.empty() ? "" : "; ") + escaped(line);
    return all.empty() ? all : paragraph("<strong>Farther than before:</strong> " + all, "notice");
}

std::string closeness(const FittedScene& found) {
    const std::vector<FrameAmounts> reference = frames_of(found.target);
    const auto words = [&](const std::vector<FrameAmounts>& shown) {
        return escaped(in_words(likeness_of(shown, reference, 0.0)));
    };
    return "<div class=\"closeness\">\n" + paragraph("<strong>After:</strong> " + words(found.result->after), "main") +
           paragraph("Before: " + words(found.result->before), "quiet") + worse(*found.result) + "</div>\n";
}

std::string misfits(const FitResult& result) {
    std::string html =
        "<table class=\"narrow misfits\">\n<caption>Root mean square difference, % of the view"
        "</caption>\n<thead><tr><th scope=\"col\">Amount</th><th scope=\"col\">Before</th><th scope=\"col\">After</th>"
        "</tr></thead>\n<tbody>\n";
    constexpr double hundred = 100.0;
    for (const AmountName& amount : amount_names) {
        const std::optional<double>&before = result.*amount.before, &after = result.*amount.after;
        html += std::string("<tr><th scope=\"row\">") + amount.name + "</th>";
        if (before && after)
            html += "<td>" + decimals(hundred * *before, 2) + "</td><td>" + decimals(hundred * *after, 2) + "</td>";
        else
            html += "<td colspan=\"2\">not measurable</td>";
        html += "</tr>\n";
    }
    return html + "</tbody>\n</table>\n";
}

std::string plots(const FittedScene& found) {
    std::string html = paragraph(
                           "The band is the interval of the reference: it is to hold the true amount in nine of "
                           "ten cases.",
                           "quiet") +
                       "<div class=\"plots\">\n";
    for (const AmountName& amount : amount_names)
        html += amount_plot(found.target, *found.result, amount, found.fit.from, found.fit.to);
    return html + "</div>\n";
}

std::string row_of(const FittedParameter& p) {
    const auto cell = [](const char* label, const std::string& html) {
        return "<td data-label=\"" + std::string(label) + "\">" + html + "</td>";
    };
    std::string html = "<tr><th scope=\"row\">" + escaped(p.parameter.row->name) + " <code>" +
                       escaped(p.parameter.key) + "</code></th>";
    html += cell("Before", with_unit(digits(p.before), p));
    const std::string after = with_unit(digits(p.after), p);
    html += cell("After", p.determined ? "<strong>" + after + "</strong>" : p.after == p.before ? "kept" : after);
    if (!p.determined) return html + "<td>not determined: " + escaped(p.why) + "</td></tr>\n";
    return html +
           cell("90 % interval", with_unit(digits(p.low) + " to " + digits(p.high), p) +
                                     (p.at_bound ? "; at its bound, the curves would take it farther" : "")) +
           "</tr>\n";
}

std::string parameters(const FitResult& result) {
    if (result.parameters.empty()) return paragraph("None was fitted: all keep their values.", "notice");
    const auto determined = [](const FittedParameter& p) { return p.determined; };
    const auto kept = [](const FittedParameter& p) { return p.after == p.before; };
    std::string html;
    if (std::none_of(result.parameters.begin(), result.parameters.end(), determined))
        html += paragraph(
            std::string("The reference determines none of the parameters") +
                (std::all_of(result.parameters.begin(), result.parameters.end(), kept) ? ": all keep their values."
                                                                                       : "."),
            "notice");
    html += "<table class=\"parameters\">\n<thead><tr>";
    for (const char* column : {"Parameter", "Before", "After", "90 % interval"})
        html += "<th scope=\"col\">" + std::string(column) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const FittedParameter& p : result.parameters) html += row_of(p);
    return html + "</tbody>\n</table>\n";
}

std::string amounts_at(const std::optional<Amount>& blood, const std::optional<Amount>& veil) {
    const auto said = [](const std::optional<Amount>& amount) {
        return amount ? percent_text(amount->value) : "unknown";
    };
    return "<br/><span>blood " + said(blood) + ",</span> <span>veil " + said(veil) + "</span>";
}

std::string amounts_at(const std::vector<FrameAmounts>& frames, std::size_t i) {
    std::optional<Amount> blood, veil;
    if (i < frames.size() && measurable(frames[i], Curve::blood)) blood = frames[i].blood;
    if (i < frames.size() && measurable(frames[i], Curve::veil)) veil = frames[i].veil;
    return amounts_at(blood, veil);
}

std::string picture(const std::string& jpeg, const char* name, const std::string& when, const std::string& amounts) {
    if (jpeg.empty()) return {};
    return "<figure><img src=\"data:image/jpeg;base64," + base64(jpeg) + "\" alt=\"" + name + " at " + when +
           " of the scene\"/><figcaption>" + name + amounts + "</figcaption></figure>\n";
}

std::string pictures(const FittedScene& found, const ReportMoment& moment) {
    const auto aim = std::find_if(found.target.begin(), found.target.end(),
                                  [&](const TargetPoint& point) { return point.time == moment.time; });
    const auto i = static_cast<std::size_t>(aim - found.target.begin());
    const std::string when = decimals(moment.time, 2) + " s";
    std::string html =
        "<div class=\"moment\">\n<h3>" + when + ": " + escaped(moment.name) + "</h3>\n<div class=\"pictures\">\n";
    html += picture(moment.reference, "Reference", when,
                    aim == found.target.end() ? "" : amounts_at(aim->blood, aim->veil));
    html += picture(moment.before, "Before", when, amounts_at(found.result->before, i));
    html += picture(moment.after, "After", when, amounts_at(found.result->after, i));
    return html + "</div>\n</div>\n";
}

std::string list(const std::vector<std::string>& lines) {
    std::string html = "<ul>\n";
    for (const std::string& line : lines) html += "<li>" + escaped(line) + "</li>\n";
    return html + "</ul>\n";
}

std::string span_words(double from, double to) {
    return decimals(from, 2) + " to " + decimals(to, 2) + " s";
}

std::string done(const FitReport& report) {
    const FittedScene& found = report.found;
    std::string html = "<dl>\n";
    const auto row = [&](const char* name, const std::string& value) {
        html += "<dt>" + std::string(name) + "</dt><dd>" + value + "</dd>\n";
    };
    row("Scene", name_element(report.of.scene));
    row("Reference", name_element(report.of.reference));
    row("Preset before", report.of.preset.empty() ? "built-in values" : name_element(report.of.preset));
    if (!report.of.fitted.empty()) row("Preset after", name_element(report.of.fitted));
    if (!report.of.fitted_scene.empty()) row("Scene after", name_element(report.of.fitted_scene));
    row("Window", span_words(found.fit.from, found.fit.to) + " of the scene");
    if (!found.target.empty())
        row("Compared", std::to_string(found.target.size()) + " moments, " +
                            span_words(found.target.front().time, found.target.back().time));
    row("Offset", digits(found.fit.offset) + " s: time of the reference - time of the scene");
    row("Seed", std::to_string(found.fit.seed));
    row("Curves drawn", std::to_string(found.result->curves));
    row("Evaluations", std::to_string(found.result->evaluations) + " of the core");
    row("Took", decimals(report.of.seconds, 1) + " s");
    return html + "</dl>\n";
}

struct Named {
    double time;
    const char* name;
};

std::optional<Named> most(std::span<const TargetPoint> target, const AmountName& amount, const char* name) {
    const TargetPoint* found = nullptr;
    for (const TargetPoint& aim : target)
        if (aim.*amount.aim && (found == nullptr || (aim.*amount.aim)->value > (found->*amount.aim)->value))
            found = &aim;
    if (found == nullptr || (found->*amount.aim)->value <= 0.0) return {};
    return Named{found->time, name};
}

}  // namespace

std::vector<ReportMoment> report_moments(std::span<const TargetPoint> target) {
    std::vector<ReportMoment> moments;
    const auto add = [&](const std::optional<Named>& named) {
        if (!named) return;
        const auto same = std::find_if(moments.begin(), moments.end(),
                                       [&](const ReportMoment& moment) { return moment.time == named->time; });
        if (same == moments.end())
            moments.push_back({.time = named->time, .name = named->name});
        else
            same->name += std::string(" and ") + named->name;
    };
    if (target.empty()) return moments;
    add(most(target, amount_names[0], "most blood"));
    add(most(target, amount_names[1], "most veil"));
    const double middle = 0.5 * (target.front().time + target.back().time);
    const auto nearest =
        std::min_element(target.begin(), target.end(), [&](const TargetPoint& a, const TargetPoint& b) {
            return std::abs(a.time - middle) < std::abs(b.time - middle);
        });
    add(Named{nearest->time, "in the middle"});
    return moments;
}

std::string report_html(const FitReport& report) {
    const FittedScene& found = report.found;
    std::string html = page_head("Fit of " + report.of.scene + " to " + report.of.reference) +
                       "<body>\n<main>\n<h1>Fit of " + name_element(report.of.scene) + " to " +
                       name_element(report.of.reference) + "</h1>\n";
    const bool compared = !found.result->after.empty();
    if (!compared)
        html += paragraph("The fit ended before the scene was measured: nothing is compared.", "notice");
    else if (found.result->ended_early)
        html += paragraph("The fit ended early: this is the best that was found until then.", "notice");
    if (compared) html += closeness(found);
    html += "<h2>Amounts over time</h2>\n" + plots(found);
    if (compared) html += misfits(*found.result);
    html += "<h2>Parameters</h2>\n" + parameters(*found.result);
    if (!found.colors.empty()) html += "<h2>Colours</h2>\n" + list(found.colors);
    if (!report.moments.empty()) html += "<h2>Pictures</h2>\n";
    for (const ReportMoment& moment : report.moments) html += pictures(found, moment);
    if (!report.of.notes.empty()) html += "<h2>Notes of measuring the reference</h2>\n" + list(report.of.notes);
    return html + "<h2>What was done</h2>\n" + done(report) + "</main>\n</body>\n</html>\n";
}

}  // namespace lapfx::match
