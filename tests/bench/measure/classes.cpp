#include "bench/measure/classes.h"

#include <algorithm>
#include <cstdio>
#include <vector>

namespace lapfx::bench {

namespace {

using Picture = MeasuredPicture;

constexpr double clear_veil = 0.1, thin_veil = 0.2;  // classes of blood by the true veil before it

constexpr Bound veil_still[] = {{"mean_absolute_error", 0.03}, {"bias", 0.02}, {"correlation", 0.98, true}};
constexpr Bound veil_moving[] = {{"mean_absolute_error", 0.055}, {"bias", 0.02}, {"correlation", 0.95, true}};
constexpr Bound no_veil_moving[] = {{"false_area", 0.015}};
constexpr Bound veil_alone[] = {{"correlation", 0.90, true}};
constexpr Bound blood_still[] = {
    {"mean_absolute_error", 0.015}, {"correlation", 0.95, true}, {"dice", 0.85, true}, {"error_over_zero", 1.0 / 3.0}};
constexpr Bound blood_moving[] = {
    {"mean_absolute_error", 0.045}, {"correlation", 0.6, true}, {"raw_error_over_zero", 1.0}};
constexpr Bound no_blood_moving[] = {{"false_area", 0.025}, {"false_area_95", 0.08}};
constexpr Bound blood_thin[] = {{"mean_absolute_error", 0.015}};
constexpr Bound blood_veiled[] = {{"mean_absolute_error", 0.025}};
constexpr Bound blood_labelled[] = {{"mean_absolute_error", 0.022}, {"correlation", 0.88, true}, {"dice", 0.55, true}};
constexpr Bound blood_painted[] = {
    {"mean_absolute_error", 0.02}, {"dice", 0.5, true}, {"interval_coverage", 0.85, true}};
constexpr Bound none_painted[] = {{"false_area", 0.005}};
constexpr Bound dense[] = {{"told", 1.0, true}};
constexpr double most_of_moving = 0.75, most_of_hard = 0.8;  // of the pictures, to be measured at least

Reading veil(const Picture& p) {
    return {.truth = p.true_veil, .measured = p.measured.veil};
}
Reading blood(const Picture& p) {
    return {.truth = p.true_blood, .measured = p.measured.blood, .dice = p.dice};
}
Reading alone(const Picture& p) {
    return {.truth = p.true_veil, .measured = {.value = p.hazeness}};
}
bool veil_measurable(const Picture& p) {
    return p.measured.measurable();
}
bool blood_measurable(const Picture& p) {
    return p.measured.blood_measurable();
}
bool always(const Picture&) {
    return true;
}

bool still(const Picture& p) {
    return !p.moves && !p.labelled && p.by_strokes == 0;
}
bool moving(const Picture& p) {
    return p.moves && !p.labelled && p.by_strokes == 0;
}
bool under(const Picture& p, double from, double to) {
    return p.true_veil >= from && p.true_veil < to;
}

const PictureClass classes[] = {
    {"veil_still", "veil, baseline, still or shifted", Asked::amount, still, veil, veil_measurable, veil_still},
    {"veil_shifted", "  of these shifted", Asked::amount, [](const Picture& p) { return still(p) && p.shifted; }, veil,
     veil_measurable},
    {"veil_moving", "veil, baseline 1 to 4 s old, scene moves", Asked::amount, moving, veil, veil_measurable,
     veil_moving},
    {"veil_moving_none", "  of these without smoke", Asked::amount,
     [](const Picture& p) { return moving(p) && p.true_veil <= next_to_nothing; }, veil, veil_measurable,
     no_veil_moving},
    {"veil_alone", "veil, no baseline: its order alone", Asked::order, still, alone, always, veil_alone},
    {"blood_still", "blood, same view, v < .1", Asked::amount,
     [](const Picture& p) { return still(p) && under(p, 0.0, clear_veil); }, blood, blood_measurable, blood_still},
    {"blood_shifted", "  of these shifted", Asked::amount,
     [](const Picture& p) { return still(p) && p.shifted && under(p, 0.0, clear_veil); }, blood, blood_measurable},
    {"blood_moving", "blood, scene moves, v < .4", Asked::amount,
     [](const Picture& p) { return moving(p) && under(p, 0.0, match::dense_veil); }, blood, blood_measurable,
     blood_moving, most_of_moving},
    {"blood_moving_clear", "  of these v < .1", Asked::amount,
     [](const Picture& p) { return moving(p) && under(p, 0.0, clear_veil); }, blood, blood_measurable},
    {"blood_moving_none", "  of these without blood", Asked::amount,
     [](const Picture& p) { return moving(p) && under(p, 0.0, match::dense_veil) && p.true_blood <= next_to_nothing; },
     blood, blood_measurable, no_blood_moving, most_of_hard},
    {"blood_veil_15", "blood under v = .1 to .2, registered", Asked::amount,
     [](const Picture& p) { return still(p) && under(p, clear_veil, thin_veil); }, blood, blood_measurable, blood_thin},
    {"blood_veil_30", "blood under v = .2 to .4, registered", Asked::amount,
     [](const Picture& p) { return still(p) && under(p, thin_veil, match::dense_veil); }, blood, blood_measurable,
     blood_veiled},
    {"blood_dense", "v > .4: blood told not measurable", Asked::told,
     [](const Picture& p) { return !p.labelled && p.true_veil > match::dense_veil; }, blood, blood_measurable, dense},
    {"blood_labelled", "blood labelled by a person, scene moves", Asked::amount,
     [](const Picture& p) { return p.labelled && p.by_strokes == 0; }, blood, blood_measurable, blood_labelled,
     most_of_hard},
    {"blood_by_strokes", "blood by strokes over one frame", Asked::amount,
     [](const Picture& p) { return p.by_strokes == 1 && p.true_blood > next_to_nothing; }, blood, blood_measurable,
     blood_painted, most_of_hard},
    {"blood_by_strokes_none", "  the frame before the bleeding, learned from", Asked::amount,
     [](const Picture& p) { return p.by_strokes == 1 && p.true_blood <= next_to_nothing; }, blood, blood_measurable,
     none_painted, most_of_hard},
    {"blood_by_strokes_two", "blood by strokes over two frames", Asked::amount,
     [](const Picture& p) { return p.by_strokes == 2 && p.true_blood > next_to_nothing; }, blood, blood_measurable,
     blood_painted, most_of_hard}};

void add_line(BenchReport& report, const std::string& name, const Figures& figures, const std::string& bounds,
              const std::string& verdict) {
    char line[200];
    std::snprintf(line, sizeof line, "%-48.70s", name.c_str());
    report.table += line;
    for (const char* key : {"count", "not_measurable"}) {
        std::snprintf(line, sizeof line, "%6.0f", figures.contains(key) ? figures.at(key) : 0.0);
        report.table += line;
    }
    for (const char* key : {"mean_absolute_error", "bias", "correlation", "dice", "interval_coverage",
                            "raw_mean_absolute_error", "raw_zero_error"}) {
        if (figures.contains(key))
            std::snprintf(line, sizeof line, std::string_view(key) == "bias" ? "  %+.3f" : "  %6.3f", figures.at(key));
        report.table += figures.contains(key) ? line : "       -";
    }
    report.table += "  " + bounds + (verdict.empty() ? "" : ": " + verdict) + "\n";
}

std::string listed(std::span<const Bound> bounds) {
    std::string all;
    for (const Bound& bound : bounds) all += (all.empty() ? "" : ", ") + text_of(bound);
    return all;
}

void add_bounds(BenchRow& row, std::span<const Bound> bounds, bool met) {
    for (const Bound& bound : bounds)
        row.measured[(bound.at_least ? "bound_least_" : "bound_most_") + std::string(bound.figure)] = bound.value;
    if (!bounds.empty()) row.measured["met"] = met ? 1.0 : 0.0;
}

/// Figures that the table has no column for, beside the bounds.
std::string also(const Figures& figures, std::span<const Bound> bounds) {
    std::string text;
    for (const Bound& bound : bounds)
        for (const std::string key : {"error_over_zero", "raw_error_over_zero", "false_area", "false_area_95", "told"})
            if (bound.figure == key && figures.contains(key)) text += text_of({key, figures.at(key)}, "=") + "; ";
    return text;
}

void add_class(BenchReport& report, const PictureClass& row, std::span<const Picture> pictures, bool real) {
    const Figures figures = figures_of(row, pictures);
    const bool met = meets(row, figures);
    BenchRow made{.of = {{"class", std::string(row.key)}, {"pictures", real ? "real" : "renders"}},
                  .measured = figures};
    add_bounds(made, row.bounds, met);
    report.rows.push_back(std::move(made));
    add_line(report, (real ? "real: " : "") + std::string(row.name), figures,
             also(figures, row.bounds) + listed(row.bounds),
             row.bounds.empty() ? ""
             : met              ? "yes"
                                : "NO");
}

/// An amount of a picture, where it is told and known.
struct Told {
    const char* amount;
    Reading (*reading)(const Picture&);
    bool (*measurable)(const Picture&);
    bool known_where_labelled;

    bool tells(const Picture& picture) const {
        return measurable(picture) && (known_where_labelled || !picture.labelled) && picture.by_strokes == 0;
    }
    std::vector<Reading> readings_of(std::span<const Picture> pictures) const {
        std::vector<Reading> all;
        for (const Picture& picture : pictures)
            if (tells(picture)) all.push_back(reading(picture));
        return all;
    }
};
constexpr Told all_told[] = {{"veil", veil, veil_measurable, false}, {"blood", blood, blood_measurable, true}};

using Groups = std::map<std::string, std::vector<Reading>>;

/// How often intervals hold the true amount when one value of a label at a time is left out.
void add_left_out(BenchReport& report, const char* amount, const std::string& label, const Groups& groups, bool real) {
    std::vector<Reading> all;
    for (const auto& [name, readings] : groups) all.insert(all.end(), readings.begin(), readings.end());
    const std::vector<LeftOut> left = leave_one_out(groups);
    Figures figures{{"count", static_cast<double>(all.size())}};
    const LeftOut* lowest = nullptr;
    for (const LeftOut& group : left) {
        figures["coverage"] += group.coverage / static_cast<double>(left.size());
        if (!lowest || group.coverage < lowest->coverage) lowest = &group;
    }
    if (lowest) figures["lowest_coverage"] = lowest->coverage;
    const bool met = std::ranges::all_of(interval_bounds, [&](const Bound& bound) { return meets(figures, bound); });
    const std::string key = std::string(amount) + "_intervals_" + label;
    BenchRow row{.of = {{"class", key}, {"pictures", real ? "real" : "renders"}}, .measured = figures};
    add_bounds(row, interval_bounds, met);
    report.rows.push_back(std::move(row));
    char line[240];
    std::snprintf(line, sizeof line, "%s%s intervals, one %s left out: ", real ? "real: " : "", amount, label.c_str());
    report.table += line;
    if (lowest)
        std::snprintf(line, sizeof line, "coverage %.3f, lowest %.3f (%s); .85 to .95: %s\n", figures["coverage"],
                      lowest->coverage, lowest->group.c_str(), met ? "yes" : "NO");
    else
        std::snprintf(line, sizeof line, "only %zu of them, at least 2 are needed; .85 to .95: NO\n", groups.size());
    report.table += line;
    for (const LeftOut& group : left) {
        report.rows.push_back(
            {.of = {{"class", key + "_left_out"}, {"left_out", group.group}},
             .measured = {
                 {"count", static_cast<double>(group.count)}, {"factor", group.factor}, {"coverage", group.coverage}}});
        std::snprintf(line, sizeof line, "    without %-28s %5zu pictures, factor %.2f, coverage %.3f\n",
                      group.group.c_str(), group.count, group.factor, group.coverage);
        report.table += line;
    }
}

/// How often the intervals hold the true amount as shipped, not scaled.
void add_as_shipped(BenchReport& report, const char* amount, std::span<const Reading> readings, bool real) {
    Figures figures{{"count", static_cast<double>(readings.size())}};
    if (!readings.empty()) figures["coverage"] = figures_of(readings).at("interval_coverage");
    const bool met = std::ranges::all_of(interval_bounds, [&](const Bound& bound) { return meets(figures, bound); });
    BenchRow row{
        .of = {{"class", std::string(amount) + "_intervals_as_shipped"}, {"pictures", real ? "real" : "renders"}},
        .measured = figures};
    add_bounds(row, interval_bounds, met);
    report.rows.push_back(std::move(row));
    char line[120];
    std::snprintf(line, sizeof line, "%s%s intervals as shipped: coverage %.3f; .85 to .95: %s\n", real ? "real: " : "",
                  amount, figures.contains("coverage") ? figures["coverage"] : 0.0, met ? "yes" : "NO");
    report.table += line;
}

}  // namespace

std::span<const PictureClass> picture_classes() {
    return classes;
}

Figures figures_of(const PictureClass& of, std::span<const Picture> pictures) {
    std::vector<Reading> all, told;
    for (const Picture& picture : pictures) {
        if (!of.holds(picture)) continue;
        all.push_back(of.reading(picture));
        if (of.measurable(picture)) told.push_back(all.back());
    }
    Figures figures = figures_of(told);
    if (of.asked != Asked::amount)
        std::erase_if(figures,
                      [&](const auto& figure) { return of.asked == Asked::told || figure.first != "correlation"; });
    else
        for (const auto& [key, value] : figures_of(all))
            if (key == "mean_absolute_error" || key == "zero_error" || key == "error_over_zero")
                figures["raw_" + key] = value;
    figures["count"] = static_cast<double>(all.size());
    figures["not_measurable"] = static_cast<double>(all.size() - told.size());
    if (of.asked == Asked::told && !all.empty()) figures["told"] = figures["not_measurable"] / figures["count"];
    return figures;
}

bool meets(const PictureClass& of, const Figures& figures) {
    const double count = figures.at("count");
    const bool enough = of.asked == Asked::told || count - figures.at("not_measurable") >= of.least_measured * count;
    return enough && count > 0.0 &&
           std::ranges::all_of(of.bounds, [&](const Bound& bound) { return meets(figures, bound); });
}

void add_classes(BenchReport& report, std::span<const Picture> pictures, bool real) {
    char head[200];
    std::snprintf(head, sizeof head, "%-48s%6s%6s%8s%8s%8s%8s%8s%8s%8s  %s\n", real ? "of real frames" : "of renders",
                  "count", "none", "MAE", "bias", "r", "Dice", "cover", "raw", "zero", "bounds: met");
    report.table += head;
    const bool labelled = std::ranges::any_of(pictures, &Picture::labelled),
               others = !labelled || !std::ranges::all_of(pictures, &Picture::labelled);
    for (const PictureClass& row : classes)
        if (row.key == "blood_labelled" || row.key.starts_with("blood_by_strokes") ? labelled : others)
            add_class(report, row, pictures, real);
    report.table += "\n";
    for (const Told& told : all_told)
        if (others || told.known_where_labelled) add_as_shipped(report, told.amount, told.readings_of(pictures), real);
    for (const LabelRow& label : left_out_labels) {
        if (label.real != real) continue;
        for (const Told& told : all_told) {
            if (!others && !told.known_where_labelled) continue;
            Groups groups;
            for (const Picture& picture : pictures)
                if (told.tells(picture))
                    groups[picture.labels.at(std::string(label.label))].push_back(told.reading(picture));
            add_left_out(report, told.amount, std::string(label.label), groups, real);
        }
    }
    report.table += "\n";
}

}  // namespace lapfx::bench
