#include "match/compare/likeness_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lapfx::match {

namespace {

struct AmountRow {
    std::string_view name, unit, help;
    Farness farness;
    std::optional<double> AmountLikeness::*value;
};
constexpr AmountRow amount_rows[] = {
    {"rms", "", "root mean square of the difference over time", Farness::size, &AmountLikeness::rms},
    {"bias", "", "mean difference, above 0 where the preview has more", Farness::size, &AmountLikeness::bias},
    {"rms_over_error", "", "root mean square of difference / error of measuring, up to 1 none is known", Farness::size,
     &AmountLikeness::rms_over_error},
    {"error", "", "error of measuring over time: what differs by less is not known to", Farness::size,
     &AmountLikeness::error},
    {"late", "s", "how late the preview is; below 0 it is early", Farness::size, &AmountLikeness::late},
    {"peak_ratio", "", "peak of the preview / peak of the reference", Farness::ratio, &AmountLikeness::peak_ratio},
    {"peak_over_error", "", "difference of the peaks / error of measuring, up to 1 none is known", Farness::size,
     &AmountLikeness::peak_over_error},
    {"area_ratio", "", "area under the preview's curve / area under the reference's", Farness::ratio,
     &AmountLikeness::area_ratio},
    {"rise_difference", "s", "how much longer the preview takes from 10 % to 90 %", Farness::size,
     &AmountLikeness::rise_difference},
    {"decay_difference", "s", "how much longer half of it takes to go in the preview", Farness::size,
     &AmountLikeness::decay_difference},
};

struct AmountOf {
    std::string_view name;
    AmountLikeness Likeness::*amount;
};
constexpr AmountOf amounts[] = {{"blood", &Likeness::blood}, {"veil", &Likeness::veil}};

struct ColorRow {
    std::string_view name, help;
    std::optional<double> ColorLikeness::*value;
};
constexpr ColorRow color_rows[] = {
    {"blood_delta_e", "colour of blood, of all frames that show it", &ColorLikeness::blood},
    {"smoke_delta_e", "colour of smoke, where the veil is densest", &ColorLikeness::smoke},
    {"tissue_delta_e", "colour of the tissue, of the baselines", &ColorLikeness::tissue},
};

std::vector<Figure> all_figures() {
    std::vector<Figure> all;
    for (const AmountOf& of : amounts)
        for (const AmountRow& row : amount_rows)
            all.push_back({.name = std::string(of.name) + '_' + std::string(row.name),
                           .unit = row.unit,
                           .help = row.help,
                           .farness = row.farness,
                           .amount = of.amount,
                           .of_amount = row.value});
    for (const ColorRow& row : color_rows)
        all.push_back({.name = std::string(row.name),
                       .unit = "Delta E 2000",
                       .help = row.help,
                       .farness = Farness::size,
                       .of_colors = row.value});
    return all;
}

}  // namespace

std::optional<double> Figure::of(const Compared& compared) const {
    return of_colors != nullptr ? compared.colors.*of_colors : compared.amounts.*amount.*of_amount;
}

double Figure::far(double value) const {
    if (farness == Farness::size) return std::abs(value);
    return value > 0.0 ? std::max(value, 1.0 / value) : std::numeric_limits<double>::infinity();
}

std::span<const Figure> figures() {
    static const std::vector<Figure> all = all_figures();
    return all;
}

const Figure* figure_named(std::string_view name) {
    const auto found = std::ranges::find(figures(), name, &Figure::name);
    return found == figures().end() ? nullptr : &*found;
}

}  // namespace lapfx::match
