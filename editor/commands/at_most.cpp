#include "commands/at_most.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "commands/options.h"
#include "commands/verb.h"

namespace lapfx::commands {

namespace {

constexpr int usual_digits = 3;

std::string number_text(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const match::Figure& figure : match::figures()) all.push_back(figure.name);
    return all;
}

const match::Figure& figure_of(const std::string& name) {
    if (const match::Figure* figure = match::figure_named(name)) return *figure;
    throw wrong_option("--at-most", unknown_word(name, "figure", names()).faults().front().reason);
}

double value_of(const std::string& name, const std::string& text) {
    double value = 0.0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        throw wrong_option("--at-most", name + ": \"" + text + "\" is not a number");
    if (value < 0.0) throw wrong_option("--at-most", name + ": " + text + " is below the minimum 0");
    return value;
}

Limit limit_of(const std::string& text) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos)
        throw wrong_option("--at-most", "\"" + text + "\" is not NAME=VALUE, such as veil_rms=0.05");
    const match::Figure& figure = figure_of(text.substr(0, equals));
    const std::string number = text.substr(equals + 1);
    const double value = value_of(figure.name, number);
    if (figure.farness == match::Farness::ratio && value < 1.0)
        throw wrong_option("--at-most", figure.name + "=" + number + " never holds: of a ratio the larger of it and " +
                                            "1 / it is limited, which is 1 at least");
    return {&figure, value};
}

/// Of a limit that does not hold.
std::string reason_of(const Limit& limit, const match::Compared& compared) {
    const match::Figure& figure = *limit.figure;
    const std::optional<double> value = figure.of(compared);
    if (!value)
        return figure.name + " is not known, so that it cannot be shown to be at most " +
               number_text(limit.value, usual_digits);
    const double far = figure.far(*value);
    // Two numbers that differ are not to look alike.
    int digits = usual_digits;
    while (digits < std::numeric_limits<double>::max_digits10 &&
           number_text(far, digits) == number_text(limit.value, digits))
        ++digits;
    std::string text = figure.name + " is " + number_text(*value, digits);
    if (far != *value) text += ", which counts as " + number_text(far, digits);
    return text + ", above the " + number_text(limit.value, digits) + " that is allowed";
}

}  // namespace

bool Limit::holds(const match::Compared& compared) const {
    const std::optional<double> found = figure->of(compared);
    return found && figure->far(*found) <= value;
}

std::vector<Limit> limits_of(std::span<const std::string> texts) {
    std::vector<Limit> limits;
    std::vector<Fault> faults;
    for (const std::string& text : texts) {
        try {
            const Limit limit = limit_of(text);
            if (std::ranges::find(limits, limit.figure, &Limit::figure) != limits.end())
                throw wrong_option("--at-most", limit.figure->name + " is given twice");
            limits.push_back(limit);
        } catch (const Error& error) {
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
    }
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    return limits;
}

std::vector<Fault> faults_of(std::span<const Limit> limits, const match::Compared& compared) {
    std::vector<Fault> faults;
    for (const Limit& limit : limits)
        if (!limit.holds(compared)) faults.push_back({.file = "", .place = "", .reason = reason_of(limit, compared)});
    return faults;
}

}  // namespace lapfx::commands
