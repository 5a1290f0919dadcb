// lapfx_bench_ui [--json FILE]: our toolkit beside Dear ImGui, taking turns in one run. `lapfx bench ui` starts it.
#include <glad/gl.h>

#include <chrono>
#include <cstring>
#include <iostream>

#include "bench/ui/cases.h"
#include "commands/bench.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/context.h"
#include "lapfx/error.h"

namespace {

using namespace lapfx;
using bench::Screen;

constexpr int rounds = 15, frames = 20;  // of each toolkit in turn

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
    std::vector<double> frame;
    bench::Drawn drawn;
    double median_us() const { return commands::median(frame) * 1e6; }
};

void take_turns(bench::Toolkit& ours, bench::Toolkit& imgui, Screen screen, Times (&times)[2]) {
    bench::Toolkit* both[] = {&ours, &imgui};
    for (bench::Toolkit* each : both) {
        each->show(screen);
        for (int i = 0; i < 10; ++i) each->frame();
    }
    for (int round = 0; round < rounds; ++round) {
        for (int which = 0; which < 2; ++which) {
            for (int i = 0; i < frames; ++i)
                times[which].frame.push_back(seconds_of([&] { times[which].drawn = both[which]->frame(); }));
        }
    }
}

void add_row(commands::BenchReport& report, const char* screen, const char* toolkit, const Times& times,
             std::size_t memory) {
    report.rows.push_back({.of = {{"screen", screen}, {"toolkit", toolkit}},
                           .measured = {{"cpu_us", times.median_us()},
                                        {"draw_calls", times.drawn.calls},
                                        {"kib_to_gpu", static_cast<double>(times.drawn.bytes) / 1024},
                                        {"elements", static_cast<double>(times.drawn.elements)},
                                        {"memory_kib", static_cast<double>(memory) / 1024}}});
}

/// Against nothing: Dear ImGui has no plot that could hold them.
void measure_million(bench::Toolkit& ours, commands::BenchReport& report) {
    ours.show(Screen::million);
    Times times;
    for (int i = 0; i < 10; ++i) ours.frame();
    for (int i = 0; i < rounds * frames; ++i) times.frame.push_back(seconds_of([&] { times.drawn = ours.frame(); }));
    add_row(report, "plot_million", "lapfx", times, ours.memory());
}

/// Drawing whole frames, on whatever draws here.
void measure_drawing(bench::Toolkit& ours, bench::Toolkit& imgui, Screen screen, const std::string& name,
                     commands::BenchReport& report) {
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
    for (int round = 0; round < rounds + 2; ++round) {
        for (int which = 0; which < 2; ++which) {
            for (int i = 0; i < 4; ++i) {
                times[which].drawn = both[which]->frame();
                glFinish();
                const double took = seconds_of([&] {
                    if (which == 1) glClearColor(0.06F, 0.06F, 0.06F, 1), glClear(GL_COLOR_BUFFER_BIT);
                    both[which]->draw(framebuffer);
                    glFinish();
                });
                if (round >= 2) times[which].frame.push_back(took);
            }
        }
    }
    add_row(report, ("draw_" + name).c_str(), "lapfx", times[0], 0);
    add_row(report, ("draw_" + name).c_str(), "imgui", times[1], 0);
    report.ratios["ui_draw_over_imgui_" + name] = times[0].median_us() / times[1].median_us();
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

commands::BenchReport measure() {
    const Context context = Context::create(Backend::egl);
    commands::BenchReport report;
    report.bench = "ui";
    report.renderer = context.renderer();
    const auto ours = bench::make_ours(), imgui = bench::make_imgui();
    for (const Case& each : cases) {
        Times times[2];
        take_turns(*ours, *imgui, each.screen, times);
        add_row(report, each.name, "lapfx", times[0], ours->memory());
        add_row(report, each.name, "imgui", times[1], 0);
        report.ratios[std::string("ui_over_imgui_") + each.name] = times[0].median_us() / times[1].median_us();
    }
    ours->change_all(true);
    Times anew[2];
    take_turns(*ours, *imgui, Screen::mixed_1000, anew);
    ours->change_all(false);
    add_row(report, "1000_all_changed", "lapfx", anew[0], ours->memory());
    report.ratios["ui_all_changed_over_imgui_1000"] = anew[0].median_us() / anew[1].median_us();
    measure_million(*ours, report);
    measure_drawing(*ours, *imgui, Screen::sliders_368, "1080p", report);
    measure_drawing(*ours, *imgui, Screen::small, "640x400", report);
    return report;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        const commands::BenchReport report = measure();
        commands::print(report);
        if (argc == 3 && std::strcmp(argv[1], "--json") == 0) commands::write_json(report, argv[2]);
        return 0;
    } catch (const lapfx::Error& error) {
        for (const lapfx::Fault& fault : error.faults()) std::cerr << "lapfx: " << fault.text() << '\n';
        return exit_code(error.failure());
    } catch (const std::exception& error) {
        std::cerr << "lapfx: " << error.what() << '\n';
        return 1;
    }
}
