// The plot of a measurement: blood above, veil below, each with its interval and the times of its episode. Drawn with
// OpenCV, so that it needs neither a window nor OpenGL.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "match/video/measure.h"

namespace lapfx::match {

namespace {

constexpr int width = 1280, panel_height = 360, left = 70, right = 24, top = 40, bottom = 44;
const cv::Scalar ink(50, 50, 50), pale(228, 228, 228), unmeasured(240, 240, 236), course_ink(120, 120, 120),
    course_band(216, 216, 216);  // BGR

struct Panel {
    const char* title;
    Curve curve;
    Amount FrameAmounts::*amount;
    Episode Measurement::*episode;
    cv::Scalar color, band;
};
const Panel panels[] = {
    {"Blood, share of the view",
     Curve::blood,
     &FrameAmounts::blood,
     &Measurement::blood,
     {40, 40, 190},
     {205, 205, 242}},
    {"Veil, mean over the view", Curve::veil, &FrameAmounts::veil, &Measurement::veil, {150, 105, 60}, {232, 220, 205}},
};

/// A round number of at least `value`.
double round_up(double value) {
    for (const double most : {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.8})
        if (value <= most) return most;
    return 1.0;
}

class Axes {
  public:
    Axes(double from, double to, double most) : from_(from), length_(std::max(to - from, 1e-3)), most_(most) {}
    int x(double time) const {
        return left + static_cast<int>(std::lround((time - from_) / length_ * (width - left - right)));
    }
    int y(double value) const {
        const double share = std::clamp(value / most_, 0.0, 1.0);
        return panel_height - bottom - static_cast<int>(std::lround(share * (panel_height - top - bottom)));
    }
    double from() const { return from_; }
    double length() const { return length_; }
    double most() const { return most_; }

  private:
    double from_, length_, most_;
};

void write(cv::Mat& on, const std::string& text, cv::Point at, double scale, const cv::Scalar& color) {
    cv::putText(on, text, at, cv::FONT_HERSHEY_SIMPLEX, scale, color, 1, cv::LINE_AA);
}

std::string number(const char* format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// `levels`: the amounts have a scale.
void draw_grid(cv::Mat& on, const Axes& axes, bool levels) {
    for (int i = 0; i <= 4; ++i) {
        const double value = axes.most() * i / 4;
        if (!levels && i > 0) break;
        cv::line(on, {left, axes.y(value)}, {width - right, axes.y(value)}, i == 0 ? ink : pale);
        if (levels) write(on, number("%.3g", value), {16, axes.y(value) + 4}, 0.42, ink);
    }
    for (int i = 0; i <= 8; ++i) {
        const double time = axes.from() + axes.length() * i / 8;
        cv::line(on, {axes.x(time), panel_height - bottom}, {axes.x(time), panel_height - bottom + 4}, ink);
        write(on, number("%.2f s", time), {axes.x(time) - 22, panel_height - bottom + 20}, 0.4, ink);
    }
}

/// Runs of frames that have the amount or not: lines and bands are not drawn across what was not measured.
template <typename Take>
void each_run(const std::vector<FrameAmounts>& frames, Curve curve, Take take) {
    for (std::size_t from = 0; from < frames.size();) {
        std::size_t to = from;
        while (to < frames.size() && measurable(frames[to], curve) == measurable(frames[from], curve)) ++to;
        take(std::span(frames).subspan(from, to - from), measurable(frames[from], curve));
        from = to;
    }
}

void draw_curve(cv::Mat& on, const Axes& axes, const Panel& panel, std::span<const FrameAmounts> run) {
    std::vector<cv::Point> line, band;
    for (const FrameAmounts& f : run) {
        line.emplace_back(axes.x(f.time), axes.y((f.*panel.amount).value));
        band.emplace_back(axes.x(f.time), axes.y((f.*panel.amount).high));
    }
    for (auto f = run.rbegin(); f != run.rend(); ++f)
        band.emplace_back(axes.x(f->time), axes.y((*f.*panel.amount).low));
    cv::fillPoly(on, std::vector<std::vector<cv::Point>>{band}, panel.band, cv::LINE_AA);
    cv::polylines(on, line, false, panel.color, 2, cv::LINE_AA);
}

/// A course fills the height, whatever it is worth: thin, and in no colour of an amount.
void draw_course(cv::Mat& on, const Axes& axes, std::span<const FrameAmounts> run) {
    std::vector<cv::Point> line, band;
    for (const FrameAmounts& f : run) {
        line.emplace_back(axes.x(f.time), axes.y(axes.most() * f.course->value));
        band.emplace_back(axes.x(f.time), axes.y(axes.most() * f.course->high));
    }
    for (auto f = run.rbegin(); f != run.rend(); ++f)
        band.emplace_back(axes.x(f->time), axes.y(axes.most() * f->course->low));
    cv::fillPoly(on, std::vector<std::vector<cv::Point>>{band}, course_band, cv::LINE_AA);
    cv::polylines(on, line, false, course_ink, 1, cv::LINE_AA);
    write(on, "course only, no scale", {axes.x(run.front().time) + 6, panel_height - bottom - 8}, 0.42, ink);
}

void draw_episode(cv::Mat& on, const Axes& axes, const Panel& panel, const Measurement& found, bool course_only) {
    const Episode& episode = found.*panel.episode;
    std::string text = course_only ? "course only, no level" : without_episode(found, panel.curve);
    if (episode.peak) text = number("peak %.3f", *episode.peak) + number("   area %.3f s", *episode.area);
    const auto mark = [&](const char* name, const std::optional<double>& at) {
        if (!at) return;
        const int x = axes.x(*at);
        for (int y = top; y < panel_height - bottom; y += 8) cv::line(on, {x, y}, {x, y + 3}, panel.color);
        write(on, name, {std::min(x + 4, width - right - 50), top + 12}, 0.4, panel.color);
    };
    mark("onset", episode.onset);
    mark("peak", episode.peak_at);
    if (episode.onset) text += number("   onset %.2f s", *episode.onset);
    if (episode.rise) text += number("   rise %.2f s", *episode.rise);
    if (episode.decay) text += number("   decay %.2f s", *episode.decay);
    write(on, text, {left + 330, 24}, 0.48, ink);
}

cv::Mat draw(const Panel& panel, const Measurement& found) {
    cv::Mat on(panel_height, width, CV_8UC3, cv::Scalar::all(255));
    double most = 0.02;
    for (const FrameAmounts& f : found.frames)
        if (measurable(f, panel.curve)) most = std::max(most, (f.*panel.amount).high);
    const Axes axes(found.frames.front().time, found.frames.back().time, round_up(most));
    const double half_frame =
        0.5 * axes.length() / std::max<double>(static_cast<double>(found.frames.size()) - 1.0, 1.0);
    each_run(found.frames, panel.curve, [&](std::span<const FrameAmounts> run, bool has_any) {
        if (has_any) return;
        const int from = std::max(axes.x(run.front().time - half_frame), left);
        const int to = std::min(axes.x(run.back().time + half_frame), width - right);
        cv::rectangle(on, {from, top}, {to, panel_height - bottom}, unmeasured, cv::FILLED);
        const bool has_course = panel.curve == Curve::veil && run.front().course.has_value();
        if (to - from > 110 && !has_course)
            write(on, "not measurable", {from + 6, panel_height - bottom - 8}, 0.42, ink);
    });
    const bool course_only = panel.curve == Curve::veil && found.course_only;
    draw_grid(on, axes, !course_only);
    each_run(found.frames, panel.curve, [&](std::span<const FrameAmounts> run, bool has_any) {
        if (has_any) draw_curve(on, axes, panel, run);
    });
    if (panel.curve == Curve::veil)
        each_run(found.frames, Curve::course, [&](std::span<const FrameAmounts> run, bool has_any) {
            if (has_any) draw_course(on, axes, run);
        });
    write(on, panel.title, {left, 24}, 0.6, ink);
    draw_episode(on, axes, panel, found, course_only);
    return on;
}

}  // namespace

Image plot_of(const Measurement& measurement) {
    cv::Mat whole(2 * panel_height, width, CV_8UC3, cv::Scalar::all(255));
    if (!measurement.frames.empty())
        for (int i = 0; i < 2; ++i)
            draw(panels[i], measurement).copyTo(whole(cv::Rect(0, i * panel_height, width, panel_height)));
    Image image{.width = whole.cols, .height = whole.rows, .pixels = {}, .name = ""};
    cv::cvtColor(whole, whole, cv::COLOR_BGR2RGBA);
    image.pixels.assign(whole.data, whole.data + whole.total() * 4);
    return image;
}

}  // namespace lapfx::match
