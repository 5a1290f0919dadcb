// lapfx_bench_ui [--short] [--json FILE]: our toolkit and Dear ImGui, taking turns in one run. `lapfx bench ui` starts
// it.
//
// Building a frame: CPU time of the thread for twenty frames in a row, of each toolkit in turn; the best of many
// rounds. Both are built with the same flags and link-time optimisation, if get_imgui has fetched Dear ImGui's source;
// else this says that they are not. Rest: nothing differs from the frame before. All changed: ours can reuse nothing
// that it drew, as when the theme changes; Dear ImGui builds everything in every frame anyway. Drawing: by the clock,
// until everything is drawn. Neither blends a window's background over the frame: ours clears the window and the panel
// in it, the other side clears the window.
#include <glad/gl.h>

#include <chrono>
#include <cstring>
#include <iostream>
#include <limits>

#include "bench/report.h"
#include "bench/ui/cases.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/context.h"
#include "lapfx/error.h"

namespace {

using namespace lapfx;
using bench::Screen;

// In the names of ratios: Debian's build of Dear ImGui has other flags than ours and no link-time optimisation, so a
// ratio over it is another figure.
#ifdef LAPFX_IMGUI_FROM_SOURCE
const std::string against = "imgui_";
#else
const std::string against = "imgui_debian_build_";
#endif

struct Extent {
    int rounds, frames;  ///< each toolkit has them, in turns
};
constexpr Extent whole{60, 20}, least{1, 2};

struct Case {
    Screen screen;
    const char* name;
};
constexpr Case cases[] = {{Screen::mixed_100, "100"},
                          {Screen::mixed_1000, "1000"},
                          {Screen::rows_10000, "rows_10000"},
                          {Screen::plots, "plots"}};

double seconds_of(const auto& work) {
    const auto from = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - from).count();
}

struct Times {
    double best = std::numeric_limits<double>::infinity();  ///< s a frame
    bench::Drawn drawn;
    double us() const { return 1e6 * best; }
    void add(double seconds) { best = std::min(best, seconds); }
};

/// CPU time per frame, s.
double built_in(bench::Toolkit& toolkit, const Extent& extent, bench::Drawn& drawn) {
    toolkit.frame();  // clears the caches of what the other toolkit left
    const double from = bench::thread_seconds();
    for (int i = 0; i < extent.frames; ++i) drawn = toolkit.frame();
    return (bench::thread_seconds() - from) / extent.frames;
}

void take_turns(bench::Toolkit& ours, bench::Toolkit& imgui, Screen screen, const Extent& extent, Times (&times)[2]) {
    bench::Toolkit* both[] = {&ours, &imgui};
    for (bench::Toolkit* each : both) {
        each->show(screen);
        for (int i = 0; i < 10; ++i) each->frame();
    }
    for (int round = 0; round < extent.rounds; ++round)
        for (int which = 0; which < 2; ++which) times[which].add(built_in(*both[which], extent, times[which].drawn));
}

void add_row(bench::BenchReport& report, const char* screen, const char* toolkit, const Times& times,
             std::size_t memory) {
    report.rows.push_back({.of = {{"screen", screen}, {"toolkit", toolkit}},
                           .measured = {{"cpu_us", times.us()},
                                        {"draw_calls", times.drawn.calls},
                                        {"kib_to_gpu", static_cast<double>(times.drawn.bytes) / 1024},
                                        {"elements", static_cast<double>(times.drawn.elements)},
                                        {"memory_kib", static_cast<double>(memory) / 1024}}});
}

/// There is no comparison: Dear ImGui has no plot for a million points.
void measure_million(bench::Toolkit& ours, const Extent& extent, bench::BenchReport& report) {
    ours.show(Screen::million);
    Times times;
    for (int i = 0; i < 10; ++i) ours.frame();
    for (int round = 0; round < extent.rounds; ++round) times.add(built_in(ours, extent, times.drawn));
    add_row(report, "plot_million", "lapfx", times, ours.memory());
}

/// Draws whole frames with the renderer of this machine.
void measure_drawing(bench::Toolkit& ours, bench::Toolkit& imgui, Screen screen, const std::string& name,
                     const Extent& extent, bench::BenchReport& report) {
    const bench::ScreenSize size = bench::size_of(screen);
    unsigned texture = 0, framebuffer = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &texture);
    glTextureStorage2D(texture, 1, GL_RGBA8, size.width, size.height);
    glCreateFramebuffers(1, &framebuffer);
    glNamedFramebufferTexture(framebuffer, GL_COLOR_ATTACHMENT0, texture, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.width, size.height);
    bench::Toolkit* both[] = {&ours, &imgui};
    Times times[2];
    for (bench::Toolkit* each : both) each->show(screen);
    for (int round = 0; round < extent.rounds + 2; ++round) {
        for (int which = 0; which < 2; ++which) {
            for (int i = 0; i < 4; ++i) {
                times[which].drawn = both[which]->frame();
                glFinish();
                const double took = seconds_of([&] {
                    if (which == 1) glClearColor(0.06F, 0.06F, 0.06F, 1), glClear(GL_COLOR_BUFFER_BIT);
                    both[which]->draw(framebuffer);
                    glFinish();
                });
                if (round >= 2) times[which].add(took);
            }
        }
    }
    add_row(report, ("draw_" + name).c_str(), "lapfx", times[0], 0);
    add_row(report, ("draw_" + name).c_str(), "imgui", times[1], 0);
    report.ratios["ui_draw_over_" + against + name] = times[0].us() / times[1].us();
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

bench::BenchReport measure(const Extent& extent) {
    const Context context = Context::create(Backend::egl);
    bench::BenchReport report;
    report.bench = "ui";
    report.renderer = context.renderer();
    const auto ours = bench::make_ours(), imgui = bench::make_imgui();
    for (const Case& each : cases) {
        Times times[2];
        take_turns(*ours, *imgui, each.screen, extent, times);
        add_row(report, each.name, "lapfx", times[0], ours->memory());
        add_row(report, each.name, "imgui", times[1], 0);
        report.ratios["ui_over_" + against + each.name] = times[0].us() / times[1].us();
    }
    ours->change_all(true);
    Times anew[2];
    take_turns(*ours, *imgui, Screen::mixed_1000, extent, anew);
    ours->change_all(false);
    add_row(report, "1000_all_changed", "lapfx", anew[0], ours->memory());
    report.ratios["ui_all_changed_over_" + against + "1000"] = anew[0].us() / anew[1].us();
    add_row(report, "1000_all_changed", "imgui", anew[1], 0);
    measure_million(*ours, extent, report);
    measure_drawing(*ours, *imgui, Screen::sliders_368, "1080p", extent, report);
    measure_drawing(*ours, *imgui, Screen::small, "640x400", extent, report);
    return report;
}

}  // namespace

int main(int argc, char** argv) {
    const char* json = nullptr;
    bool short_form = false;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--short") == 0) {
            short_form = true;
        } else if (std::strcmp(argv[i], "--json") == 0 && i + 1 < argc) {
            json = argv[++i];
        } else {
            std::cerr << "usage: lapfx_bench_ui [--short] [--json FILE]\n";
            return 2;
        }
    }
    try {
        bench::BenchReport report = measure(short_form ? least : whole);
        report.short_form = short_form;
#ifndef LAPFX_IMGUI_FROM_SOURCE
        std::cout << "Dear ImGui is Debian's library: it has other flags than ours and no link-time optimisation, so "
                     "the ratios "
                     "do not compare\nlike with like. tests/bench/ui/get_imgui says what to do.\n";
#endif
        bench::print(report);
        if (json != nullptr) bench::write_json(report, json);
        return 0;
    } catch (const lapfx::Error& error) {
        for (const lapfx::Fault& fault : error.faults()) std::cerr << "lapfx: " << fault.text() << '\n';
        return exit_code(error.failure());
    } catch (const std::exception& error) {
        std::cerr << "lapfx: " << error.what() << '\n';
        return 1;
    }
}
