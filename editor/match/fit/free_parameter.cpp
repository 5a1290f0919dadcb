#include "match/fit/free_parameter.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace lapfx::match {

namespace {

constexpr double linear_parts = 4.0;  // of the row's range: one coordinate

Fault fault(const std::string& key, const std::string& reason) {
    return {.file = "", .place = "--parameters", .reason = key + ": " + reason};
}

std::string shown(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 6).ptr;
    return {text, end};
}

struct Bounds {
    double low, high;
};

/// "2..8"
std::optional<Bounds> read_bounds(const std::string& text) {
    const std::size_t dots = text.find("..");
    if (dots == std::string::npos) return {};
    Bounds bounds{};
    const auto read = [](const char* from, const char* to, double& value) {
        const auto [end, code] = std::from_chars(from, to, value);
        return code == std::errc() && end == to && std::isfinite(value);
    };
    const char* const begin = text.data();
    if (!read(begin, begin + dots, bounds.low) || !read(begin + dots + 2, begin + text.size(), bounds.high)) return {};
    return bounds;
}

const Table& table_of(const FreeParameter& parameter) {
    return parameter.of_scene ? scene_table() : preset_table();
}

FoundParameter find(const FreeParameter& parameter, document::Content& tuned) {
    void* const document = parameter.of_scene ? static_cast<void*>(&tuned.scene) : static_cast<void*>(&tuned.preset);
    return find_parameter(table_of(parameter), document, parameter.key);
}

/// Of the preset if it knows the key, else of the scene; what the preset says of an unknown key is told.
FreeParameter find_key(document::Content& tuned, const std::string& key) {
    FreeParameter parameter{.key = key};
    try {
        parameter.row = find(parameter, tuned).row;
    } catch (const Error& unknown) {
        parameter.of_scene = true;
        try {
            parameter.row = find(parameter, tuned).row;
        } catch (const Error&) {
            throw unknown;
        }
    }
    return parameter;
}

/// Of a coordinate; 0 where it is a logarithm.
double linear_unit(const Parameter& row) {
    if (row.key == "time") return 1.0;  // s: a moment, no amount
    return row.minimum < 0.0 ? (row.maximum - row.minimum) / linear_parts : 0.0;
}

bool is_number(const Parameter& row) {
    return row.kind == Kind::number;
}

/// Throws Error for anything that is wrong with one of `keys`.
FreeParameter parameter_of(document::Content& tuned, const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::string key = text.substr(0, equals);
    FreeParameter parameter;
    try {
        parameter = find_key(tuned, key);
    } catch (const Error& error) {
        throw Error(Failure::bad_input, fault(key.empty() ? "\"\"" : key, error.faults().front().reason));
    }
    const Parameter& row = *parameter.row;
    const auto refuse = [&](const std::string& reason) { throw Error(Failure::bad_input, fault(key, reason)); };
    if (!is_number(row)) refuse("is no number; only numbers can be fitted");
    parameter.minimum = row.minimum, parameter.maximum = row.maximum;
    if (equals != std::string::npos) {
        const std::string bounds_text = text.substr(equals + 1);
        const std::optional<Bounds> bounds = read_bounds(bounds_text);
        if (!bounds) refuse("\"" + bounds_text + "\" is not LOW..HIGH, such as 2..8");
        if (bounds->low >= bounds->high)
            refuse("the lower bound of \"" + bounds_text + "\" is not below the upper one");
        if (bounds->low < row.minimum || bounds->high > row.maximum)
            refuse("\"" + bounds_text + "\" leaves what is allowed: " + shown(row.minimum) + " to " +
                   shown(row.maximum) + (row.unit.empty() ? "" : " " + std::string(row.unit)));
        parameter.minimum = bounds->low, parameter.maximum = bounds->high;
    }
    const double value = parameter.get(tuned);
    if (value < parameter.minimum || value > parameter.maximum)
        refuse("is " + shown(value) + ", outside of the bounds " + shown(parameter.minimum) + ".." +
               shown(parameter.maximum));
    return parameter;
}

}  // namespace

double FreeParameter::get(const document::Content& tuned) const {
    return std::get<double>(
        row->get(find(*this, const_cast<document::Content&>(tuned)).owner));  // only an address is taken
}

void FreeParameter::set(document::Content& tuned, double value) const {
    row->set(find(*this, tuned).owner, std::clamp(value, minimum, maximum));
}

double FreeParameter::coordinate(double value) const {
    if (const double unit = linear_unit(*row); unit > 0.0) return value / unit;
    return std::log(value + row->step);
}

double FreeParameter::value(double coordinate) const {
    const double unit = linear_unit(*row), value = unit > 0.0 ? coordinate * unit : std::exp(coordinate) - row->step;
    return std::clamp(value, minimum, maximum);
}

std::vector<FreeParameter> free_parameters(const document::Content& tuned, std::span<const std::string> keys) {
    if (keys.empty())
        throw Error(Failure::bad_input,
                    Fault{.file = "", .place = "--parameters", .reason = "names no parameter: nothing is free"});
    document::Content looked_at = tuned;
    std::vector<FreeParameter> parameters;
    std::vector<Fault> faults;
    for (const std::string& key : keys) {
        try {
            FreeParameter parameter = parameter_of(looked_at, key);
            for (const FreeParameter& other : parameters)
                if (find(other, looked_at).owner == find(parameter, looked_at).owner && other.row == parameter.row)
                    throw Error(Failure::bad_input, fault(parameter.key, "is named twice"));
            parameters.push_back(std::move(parameter));
        } catch (const Error& error) {
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
    }
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    return parameters;
}

}  // namespace lapfx::match
