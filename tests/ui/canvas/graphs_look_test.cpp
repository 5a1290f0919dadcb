// For the eye: LAPFX_UI_LOOK=folder lapfx_ui_tests --gtest_filter=*Look*; and how long graphs take.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "ui/canvas/curve_editor.h"
#include "ui/canvas/plot.h"
#include "ui/canvas/timeline.h"
#include "ui/gl/renderer.h"
#include "ui/support/gl_context.h"
#include "ui/support/harness.h"
#include "ui/support/picture.h"

namespace lapfx::ui {
namespace {

std::vector<double> wave(std::size_t count, double period, double height) {
    std::vector<double> y(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double x = static_cast<double>(i);
        y[i] = height * std::sin(x / period) + 0.1 * std::sin(x * 1.7);
    }
    return y;
}

using GraphsLookTest = test::GlTest;

TEST_F(GraphsLookTest, Look) {
    const char* folder = std::getenv("LAPFX_UI_LOOK");
    if (folder == nullptr) GTEST_SKIP() << "LAPFX_UI_LOOK is not set";
    const std::vector<double> a = wave(300, 30, 2), b = wave(300, 28, 1.8), bins = wave(64, 12, 400);
    std::vector<double> counts;
    for (const double v : bins) counts.push_back(std::abs(v) + 1);
    PlotData first, second, rest, histogram;
    first.set(a, 0, 0.02);
    second.set(b, 0, 0.02);
    const std::vector<double> r = residual_of(first, second);
    rest.set(r, 0, 0.02);
    histogram.set(counts);
    PlotState log{.log_y = true}, ranged{.has_range = true, .range = {1, 2.5}};
    Curve curve({{0, 0}, {0.2, 0.7}, {0.5, 0.3, CurveHandle::free, 0, 0}, {0.8, 0.9, CurveHandle::step}, {1, 0.4}});
    const Curve standard = Curve::preset(CurvePreset::s);
    TimelineState time{.time = 3.2, .loop = true, .has_range = true, .range = {1, 9}, .view = {}};
    std::vector<TimelineTrack> tracks{{"Events", {{"Cut", 2, 4}, {"Bleeding", 6, 8, -1, true}}},
                                      {"Marks", {{"Start", 5, 5}, {"", 7, 7}}}};
    for (const Theme* theme : {&dark_theme(), &light_theme()}) {
        for (const float scale : {1.0F, 2.0F}) {
            std::vector<ImageHandle> images;
            Harness ui(
                [&](Ui& u) {
                    u.set_theme(*theme);
                    Panel panel(u, "Panel");
                    {
                        Row row(u, {.width = grow(), .cross = Place::start});
                        const PlotSeries series[] = {{.name = "Speed", .data = &first},
                                                     {.name = "Reference", .data = &second, .reference = true}};
                        plot(u, "Plot", series,
                             {.x_name = "Time",
                              .x_unit = "s",
                              .y_name = "Speed",
                              .y_unit = "mm/s",
                              .residual = &rest,
                              .state = &ranged});
                        const PlotSeries bars[] = {{.name = "Pixels", .data = &histogram, .kind = PlotKind::bars}};
                        plot(u, "Histogram", bars, {.x_name = "Code", .state = &log});
                    }
                    curve_editor(u, "Curve", curve,
                                 {.x_name = "Age", .x_unit = "s", .standard = &standard, .live = 0.35});
                    timeline(u, "Time", time, tracks, {.length = 10, .thumbnails = images});
                },
                glm::ivec2(glm::vec2(900, 640) * scale), scale);
            for (int i = 0; i < 6; ++i) {
                const std::vector<std::uint8_t> pixel = {static_cast<std::uint8_t>(40 * i), 60, 90, 255};
                images.push_back(ui.images().add({1, 1}, pixel));
            }
            ui.click("**/Point 3");
            ui.move(ui.rect("Panel/Plot").center());
            test::Canvas canvas(ui.size);
            Renderer renderer;
            renderer.draw(*ui.output().list, Harness::fonts(), &ui.images(), canvas.framebuffer());
            const std::string name = std::string(theme == &dark_theme() ? "dark" : "light") + (scale > 1 ? "2" : "1");
            test::write_png(canvas.read(), std::string(folder) + "/graphs_" + name + ".png");
        }
    }
}

double median_us(Harness& ui, const std::function<void(int)>& step) {
    std::vector<double> times;
    for (int i = 0; i < 201; ++i) {
        step(i);
        const auto from = std::chrono::steady_clock::now();
        ui.frame();
        times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - from).count());
    }
    std::nth_element(times.begin(), times.begin() + 100, times.end());
    return times[100];
}

/// Limits are wide: the machine of a test is never quiet. What it took is in the report.
TEST(GraphsSpeed, MillionsOfSamplesPanAndZoomInAMillisecond) {
    std::vector<float> y(1000000);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = static_cast<float>((i * 2654435761U) % 1000);
    PlotData data;
    data.set(y);
    PlotState state;
    Harness ui(
        [&](Ui& u) {
            const PlotSeries series[] = {{"", &data}};
            plot(u, "Plot", series, {.state = &state});
        },
        {1280, 720});
    state.fitted = false;
    const double us = median_us(ui, [&](int i) { state.x = {i * 100.0, 1e6 - i * 4000.0}; });
    RecordProperty("us", static_cast<int>(us));
    std::printf("1e6 samples: %.1f us\n", us);
    EXPECT_LT(us, 3000);
}

TEST(GraphsSpeed, EightSeriesAndAHistogramAreCheap) {
    PlotData data[8], histogram;
    std::vector<std::vector<double>> y;
    for (int i = 0; i < 8; ++i) y.push_back(wave(512, 10 + i, 1));
    for (std::size_t i = 0; i < 8; ++i) data[i].set(y[i]);
    const std::vector<double> counts = wave(256, 40, 100);
    histogram.set(counts);
    Harness ui(
        [&](Ui& u) {
            PlotSeries series[8];
            for (std::size_t i = 0; i < 8; ++i) series[i] = {.name = "", .data = &data[i]};
            plot(u, "Plot", series);
            const PlotSeries bars[] = {{"", &histogram, PlotKind::bars}};
            plot(u, "Histogram", bars);
        },
        {1280, 720});
    const double us = median_us(ui, [](int) {});
    std::printf("8 x 512 and 256 bars: %.1f us, %zu instances\n", us, ui.output().list->instances.size());
    EXPECT_LT(us, 400);
}

}  // namespace
}  // namespace lapfx::ui
