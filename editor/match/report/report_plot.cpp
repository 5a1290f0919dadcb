#include "match/report/report_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "match/report/markup.h"
#include "match/video/shots.h"

namespace lapfx::match {

namespace {

// Units of the picture: about pixels on a desktop, three quarters of them on a phone.
constexpr double width = 480.0, height = 290.0, left = 46.0, right = 12.0, top = 62.0, bottom = 46.0;
constexpr double tick = 5.0, line_of_text = 17.0;
constexpr double least_range = 0.02;  // of an amount: what is smaller is noise
constexpr double hundred = 100.0;

/// A round step of which a range has about `count`.
double round_step(double range, double count) {
    const double rough = range / count, power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (rough <= factor * power) return factor * power;
    return 10.0 * power;
}

struct Sample {
    double time, value, low, high;
};
/// Samples between which lines may be drawn.
using Run = std::vector<Sample>;

class Axes {
  public:
    Axes(double from, double to, double most) : from_(from), length_(std::max(to - from, 1e-3)) {
        constexpr double lines = 4.0;
        step_ = round_step(std::max(most, least_range), lines);
        most_ = step_ * std::ceil(std::max(most, least_range) / step_ - 1e-9);
    }
    double x(double time) const {
        return left + std::clamp((time - from_) / length_, 0.0, 1.0) * (width - left - right);
    }
    double y(double value) const {
        return height - bottom - std::clamp(value / most_, 0.0, 1.0) * (height - top - bottom);
    }
    double from() const { return from_; }
    double length() const { return length_; }
    double most() const { return most_; }
    double step() const { return step_; }  ///< between lines of the amount

  private:
    double from_, length_, most_ = 1.0, step_ = 1.0;
};

/// A number of an axis, with as many decimals as its steps have; adding 0 makes 0 of -0.
std::string axis_number(double value, double step) {
    const double places = std::ceil(-std::log10(step) - 1e-9);
    return decimals(value + 0.0, static_cast<int>(std::clamp(places, 0.0, 6.0)));
}

std::string at(double value) {
    return decimals(value, 1);
}

std::string point(const Axes& axes, double time, double value) {
    return at(axes.x(time)) + ',' + at(axes.y(value)) + ' ';
}

std::string line(double x1, double y1, double x2, double y2, const char* look) {
    return "<line class=\"" + std::string(look) + "\" x1=\"" + at(x1) + "\" y1=\"" + at(y1) + "\" x2=\"" + at(x2) +
           "\" y2=\"" + at(y2) + "\"/>\n";
}

/// `look`: classes; "end" ends at x, "middle" is about it, else it begins there.
std::string text(double x, double y, const char* look, const std::string& words) {
    return "<text class=\"" + std::string(look) + "\" x=\"" + at(x) + "\" y=\"" + at(y) + "\">" + escaped(words) +
           "</text>\n";
}

/// How long a gap between two times may be, s: the target leaves out what the reference does not have.
double longest_step(std::span<const TargetPoint> target) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < target.size(); ++i) least = std::min(least, target[i].time - target[i - 1].time);
    constexpr double slack = 1.5;
    return slack * least;
}

/// `sample(i)`: that of the i-th time of the target, or nothing.
template <typename Take>
std::vector<Run> runs_of(std::span<const TargetPoint> target, const Take& sample) {
    std::vector<Run> runs;
    const double longest = longest_step(target);
    bool goes_on = false;
    for (std::size_t i = 0; i < target.size(); ++i) {
        const std::optional<Amount> amount = sample(i);
        if (i > 0 && target[i].time - target[i - 1].time > longest) goes_on = false;
        if (amount) {
            if (!goes_on) runs.emplace_back();
            runs.back().push_back({target[i].time, amount->value, amount->low, amount->high});
        }
        goes_on = amount.has_value();
    }
    return runs;
}

struct Curves {
    std::vector<Run> reference, before, after;
};

Curves curves_of(std::span<const TargetPoint> target, const FitResult& result, const AmountName& amount) {
    const auto shown = [&](const std::vector<FrameAmounts>& frames) {
        return runs_of(target, [&](std::size_t i) -> std::optional<Amount> {
            if (i >= frames.size() || !measurable(frames[i], amount.curve)) return {};
            return frames[i].*amount.shown;
        });
    };
    return {.reference = runs_of(target, [&](std::size_t i) { return target[i].*amount.aim; }),
            .before = shown(result.before),
            .after = shown(result.after)};
}

double most_of(const Curves& curves) {
    double most = 0.0;
    for (const Run& run : curves.reference)
        for (const Sample& s : run) most = std::max(most, s.high);
    for (const auto* runs : {&curves.before, &curves.after})
        for (const Run& run : *runs)
            for (const Sample& s : run) most = std::max(most, s.value);
    return most;
}

std::string band(const Axes& axes, const std::vector<Run>& runs) {
    std::string svg;
    for (const Run& run : runs) {
        svg += "<polygon class=\"band\" points=\"";
        for (const Sample& s : run) svg += point(axes, s.time, s.high);
        for (auto s = run.rbegin(); s != run.rend(); ++s) svg += point(axes, s->time, s->low);
        svg += "\"/>\n";
    }
    return svg;
}

/// A moment alone has a dot: a line of one point is not seen.
std::string curve(const Axes& axes, const std::vector<Run>& runs, const char* look) {
    std::string svg;
    for (const Run& run : runs) {
        if (run.size() == 1) {
            svg += "<circle class=\"dot " + std::string(look) + "\" r=\"2.5\" cx=\"" + at(axes.x(run[0].time)) +
                   "\" cy=\"" + at(axes.y(run[0].value)) + "\"/>\n";
            continue;
        }
        svg += "<polyline class=\"" + std::string(look) + "\" points=\"";
        for (const Sample& s : run) svg += point(axes, s.time, s.value);
        svg += "\"/>\n";
    }
    return svg;
}

/// The time in which the reference does not have the amount.
std::string gaps(const Axes& axes, const std::vector<Run>& runs, double half_step) {
    std::string svg;
    double from = axes.from();
    const auto shade = [&](double to) {
        if (to - from > half_step)
            svg += "<rect class=\"gap\" x=\"" + at(axes.x(from)) + "\" y=\"" + at(top) + "\" width=\"" +
                   at(axes.x(to) - axes.x(from)) + "\" height=\"" + at(height - top - bottom) + "\"/>\n";
    };
    for (const Run& run : runs) {
        shade(run.front().time - half_step);
        from = run.back().time + half_step;
    }
    shade(axes.from() + axes.length());
    return svg;
}

std::string grid(const Axes& axes, const AmountName& amount, const PlotPlace& place) {
    std::string svg;
    for (double value = 0.0; value <= axes.most() + 0.5 * axes.step(); value += axes.step()) {
        svg += line(left, axes.y(value), width - right, axes.y(value), value > 0.0 ? "grid" : "axis");
        svg +=
            text(left - tick - 2.0, axes.y(value) + tick, "end", axis_number(hundred * value, hundred * axes.step()));
    }
    constexpr double times = 6.0, slack = 1e-6;
    const double step = round_step(axes.length(), times), to = axes.from() + axes.length();
    for (double i = std::ceil(axes.from() / step - slack); i * step <= to + slack; i += 1.0) {
        const double time = i * step;
        svg += line(axes.x(time), height - bottom, axes.x(time), height - bottom + tick, "axis");
        svg += text(axes.x(time), height - bottom + line_of_text + 2.0, "middle", axis_number(time, step));
    }
    svg += text(0.5 * (left + width - right), height - 8.0, "middle", "Time of the " + place.of + ", s");
    return svg + text(0.0, line_of_text - 3.0, "name", std::string(amount.name) + ": " + amount.axis);
}

std::string legend(bool has_gaps, bool compared) {
    struct Entry {
        const char* words;
        const char* look;
        double x;
    };
    const Entry entries[] = {{compared ? "Reference, 90 %" : "Measured, 90 %", "reference", 0.0},
                             {"Before", "before", 152.0},
                             {"After", "after", 242.0}};
    constexpr double middle = 32.0, sample = 24.0, space = 6.0, gap_x = 322.0, thick = 12.0;
    const auto box = [&](double x, const char* look) {
        return "<rect class=\"" + std::string(look) + "\" x=\"" + at(x) + "\" y=\"" + at(middle - 0.5 * thick) +
               "\" width=\"" + at(sample) + "\" height=\"" + at(thick) + "\"/>\n";
    };
    std::string svg = box(0.0, "band");
    for (const Entry& entry : std::span(entries).first(compared ? std::size(entries) : 1))
        svg += line(entry.x, middle, entry.x + sample, middle, entry.look) +
               text(entry.x + sample + space, middle + tick, "", entry.words);
    if (has_gaps) svg += box(gap_x, "gap") + text(gap_x + sample + space, middle + tick, "", "not measurable");
    return svg;
}

std::string peak_words(const char* name, const std::vector<Run>& runs) {
    const Sample* peak = nullptr;
    for (const Run& run : runs)
        for (const Sample& s : run)
            if (peak == nullptr || s.value > peak->value) peak = &s;
    if (peak == nullptr) return std::string(name) + ": not measurable. ";
    return std::string(name) + ": at most " + percent_text(peak->value) + ", at " + digits(peak->time) + " s. ";
}

std::string description(const Curves& curves, const Axes& axes, const PlotPlace& place) {
    const std::string said = "From " + digits(axes.from()) + " to " + digits(axes.from() + axes.length()) +
                             " s of the " + place.of + ". " + peak_words("Reference", curves.reference);
    if (!place.compared) return said;
    return said + peak_words("Before", curves.before) + peak_words("After", curves.after);
}

}  // namespace

std::string amount_plot(std::span<const TargetPoint> target, const FitResult& result, const AmountName& amount,
                        double from, double to, const PlotPlace& place) {
    const Curves curves = curves_of(target, result, amount);
    const Axes axes(from, to, most_of(curves));
    const double longest = longest_step(target);
    const std::string unmeasured = gaps(axes, curves.reference, std::isfinite(longest) ? 0.5 * longest : 0.0);
    const std::string key = amount.key, id = place.id + key;
    std::string svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"plot " + key + "\" id=\"" + place.id +
                      "plot-" + key + "\" role=\"img\" viewBox=\"0 0 " + digits(width) + " " + digits(height) +
                      "\" aria-labelledby=\"" + id + "-title " + id + "-description\">\n";
    svg += "<title id=\"" + id + "-title\">" + amount.name + " over time" +
           (place.compared ? ": reference, before and after" : "") + "</title>\n";
    svg += "<desc id=\"" + id + "-description\">" + escaped(description(curves, axes, place)) + "</desc>\n";
    svg += unmeasured + grid(axes, amount, place) + band(axes, curves.reference) + curve(axes, curves.after, "after") +
           curve(axes, curves.before, "before") + curve(axes, curves.reference, "reference");
    return svg + legend(!unmeasured.empty(), place.compared) + "</svg>\n";
}

}  // namespace lapfx::match
