#include "document/curve_text.h"

#include <charconv>
#include <cmath>

#include "lapfx/scene.h"

namespace lapfx::document {

namespace {

constexpr std::string_view between = " \t,;\r";
constexpr std::size_t most_faults = 20;

std::string shortest(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value);
    return {buffer, end.ptr};
}

/// Reads the numbers of a line. False: the line contains something else as well.
bool read_figures(std::string_view line, std::vector<double>& figures) {
    figures.clear();
    while (true) {
        const std::size_t start = line.find_first_not_of(between);
        if (start == line.npos) return true;
        line.remove_prefix(start);
        double value = 0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), value);
        const auto used = static_cast<std::size_t>(end - line.data());
        if (error != std::errc{} || (used < line.size() && between.find(line[used]) == between.npos)) return false;
        figures.push_back(value);
        line.remove_prefix(used);
    }
}

}  // namespace

const Table* curve_table(std::string_view key) {
    const Table* curves = scene_table().find("curves");
    return curves != nullptr ? curves->find(key) : nullptr;
}

std::string curve_text(std::span<const CurvePoint> points) {
    std::string text;
    for (const CurvePoint& point : points) text += shortest(point.time) + "\t" + shortest(point.value) + "\n";
    return text;
}

std::vector<CurvePoint> parse_curve_text(std::string_view text, const Table& table) {
    std::vector<CurvePoint> points;
    std::vector<Fault> faults;
    std::vector<double> figures;
    int number = 0;
    const auto fault = [&](std::string reason) {
        if (faults.size() < most_faults) faults.push_back({"", "line " + std::to_string(number), std::move(reason)});
    };
    const auto allowed = [&](std::string_view key, const CurvePoint& point) {
        const Parameter& row = *table.find_row(key);
        const std::string reason = row.check(row.get(&point));
        if (!reason.empty()) fault(std::string(row.name) + ": " + reason);
        return reason.empty();
    };
    while (!text.empty()) {
        ++number;
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (line.find_first_of("0123456789") == line.npos) continue;  // empty, or a heading
        if (!read_figures(line, figures) || figures.size() != 2) {
            fault("\"" + std::string(line.substr(0, 40)) + "\" is not a time and a value");
            continue;
        }
        const CurvePoint point{figures[0], figures[1]};
        if (!allowed("time", point) || !allowed("value", point)) continue;
        if (!points.empty() && table.order != nullptr)
            if (std::string reason = table.order->check(&points.back(), &point); !reason.empty()) {
                fault(std::move(reason));
                continue;
            }
        points.push_back(point);
    }
    if (faults.empty() && points.empty())
        faults.push_back({"", number > 0 ? "line " + std::to_string(number) : "",
                          "no points: expected a time and a value in each line"});
    if (points.size() > table.list->maximum)
        fault(std::to_string(points.size()) + " points are more than " + std::to_string(table.list->maximum));
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    return points;
}

}  // namespace lapfx::document
