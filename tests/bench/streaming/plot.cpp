// The four panels of the paper's figure 10, drawn with OpenCV.
#include <algorithm>
#include <cstdio>
#include <map>
#include <opencv2/imgproc.hpp>

#include "bench/streaming/streaming.h"
#include "output/files.h"

namespace lapfx::bench {

namespace {

constexpr int width = 720, height = 500, left = 76, right = 24, top = 50, bottom = 60;
const cv::Scalar ink(40, 40, 40), pale(225, 225, 225);

struct Panel {
    const char* title;
    double StreamingRow::*value;
};
constexpr Panel panels[] = {{"(a) CPU-GPU transfer, ms", &StreamingRow::upload},
                            {"(b) total video processing, ms", &StreamingRow::total},
                            {"(c) frames per second", &StreamingRow::fps},
                            {"(d) buffer copy, ms", &StreamingRow::copy}};

cv::Scalar color_of(std::size_t index) {
    static const cv::Scalar colors[] = {{40, 40, 200},  {200, 110, 20},  {40, 150, 40},
                                        {150, 30, 150}, {130, 130, 240}, {240, 180, 120}};
    return colors[index % std::size(colors)];
}

void write(cv::Mat& on, const std::string& text, cv::Point where, double scale, const cv::Scalar& color) {
    cv::putText(on, text, where, cv::FONT_HERSHEY_SIMPLEX, scale, color, 1, cv::LINE_AA);
}

/// A round number of the order of `value` above it, for five steps of an axis.
double round_up(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(std::max(value, 1e-3))));
    for (const double step : {1.0, 2.0, 2.5, 5.0, 10.0})
        if (value <= step * power) return step * power;
    return 10.0 * power;
}

using Lines = std::map<std::string, std::vector<const StreamingRow*>>;

void draw_axes(cv::Mat& on, const Panel& panel, double most_streams, double most) {
    write(on, panel.title, {left, 30}, 0.6, ink);
    for (int i = 0; i <= 5; ++i) {
        const int y = height - bottom - i * (height - top - bottom) / 5;
        cv::line(on, {left, y}, {width - right, y}, i == 0 ? ink : pale, 1);
        char text[32];
        std::snprintf(text, sizeof text, "%.3g", most * i / 5.0);
        write(on, text, {12, y + 5}, 0.42, ink);
        const int x = left + i * (width - left - right) / 5;
        std::snprintf(text, sizeof text, "%.3g", most_streams * i / 5.0);
        write(on, text, {x - 8, height - bottom + 20}, 0.42, ink);
    }
    write(on, "streams", {width / 2 - 20, height - 16}, 0.48, ink);
}

cv::Mat draw(const Panel& panel, const Lines& lines) {
    cv::Mat on(height, width, CV_8UC3, cv::Scalar::all(255));
    double most = 0.0, most_streams = 0.0;
    for (const auto& [name, rows] : lines)
        for (const StreamingRow* row : rows) {
            // Nobody sees a difference beyond 120 frames per second, and one line would flatten all others.
            most = std::max(most, panel.value == &StreamingRow::fps ? std::min(row->fps, 120.0) : row->*panel.value);
            most_streams = std::max(most_streams, static_cast<double>(row->streams));
        }
    most = round_up(most);
    draw_axes(on, panel, most_streams, most);
    std::size_t index = 0;
    for (const auto& [name, rows] : lines) {
        const cv::Scalar color = color_of(index);
        std::vector<cv::Point> points;
        for (const StreamingRow* row : rows) {
            const double x = row->streams / most_streams, y = std::min(row->*panel.value / most, 1.0);
            points.emplace_back(left + static_cast<int>(x * (width - left - right)),
                                height - bottom - static_cast<int>(y * (height - top - bottom)));
        }
        cv::polylines(on, points, false, color, 2, cv::LINE_AA);
        for (const cv::Point point : points) cv::circle(on, point, 3, color, cv::FILLED, cv::LINE_AA);
        write(on, name,
              {panel.value == &StreamingRow::fps ? width - 200 : left + 14, top + 18 + 18 * static_cast<int>(index)},
              0.45, color);
        ++index;
    }
    return on;
}

}  // namespace

void plot_streaming(std::span<const StreamingRow> rows, const std::filesystem::path& path) {
    Lines lines;
    for (const StreamingRow& row : rows) lines[row.scheme].push_back(&row);
    std::erase_if(lines, [](const auto& line) { return line.second.size() < 2; });  // a point is not a line
    for (const StreamingRow& row : paper_table_2()) lines[row.scheme].push_back(&row);
    cv::Mat whole(2 * height, 2 * width, CV_8UC3);
    for (int i = 0; i < 4; ++i)
        draw(panels[i], lines).copyTo(whole(cv::Rect(i % 2 * width, i / 2 * height, width, height)));
    Image image{.width = whole.cols, .height = whole.rows, .pixels = {}, .name = ""};
    cv::cvtColor(whole, whole, cv::COLOR_BGR2RGBA);
    image.pixels.assign(whole.data, whole.data + whole.total() * 4);
    output::write_png(path, image);
}

}  // namespace lapfx::bench
