// What the editor costs beside the scene that it stands around: a frame of both on the sample scene, playing, with a
// value that changes in every frame. All that is not drawing the scene counts as the editor: the change of the
// document, the update, what the preview does to follow the document, the panels and drawing them.
//
// And what a drag costs: CPU time of this thread in a frame in which the pointer moves one slider of the preset (noise
// scale), beside drawing the scene. It is compared with two frames of the same parts; all in turns, the best of five
// runs each:
//   drag_over_idle   nothing is edited, but the scene is drawn as in a drag, so that both find the processor's caches
//                    and the driver in the same state;
//   drag_over_still  nothing is edited and nothing has to be drawn: the scene is left out, and all that the frame needs
//                    is still in the caches.
#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>

#include "app/base/layouts.h"
#include "app/files/open.h"
#include "bench/benches.h"
#include "commands/headless_editor.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "panels/panels.h"
#include "ui/core/tree.h"

namespace lapfx::bench {

namespace {

using Clock = std::chrono::steady_clock;

struct Extent {
    int frames, warm_up;
    int runs;  // runs of each side of the drag
    glm::ivec2 window;
};
constexpr Extent whole{60, 5, 5, {1440, 900}}, least{2, 1, 1, {900, 700}};

double ms_since(Clock::time_point start) {
    return 1e3 * std::chrono::duration<double>(Clock::now() - start).count();
}

struct Costs {
    std::vector<double> scene, ui;
};

/// In the order of the window: update, panels, preview, list. Each part waits for GL, so that its own drawing counts
/// for it.
Costs measure(commands::HeadlessEditor& headless, const Extent& extent, commands::Progress& progress) {
    app::Editor& editor = headless.editor();
    Costs costs;
    for (int i = 0; i < extent.warm_up + extent.frames; ++i) {
        glFinish();
        const auto start = Clock::now();
        editor.timeline.seek(3.0 + 0.05 * i);
        editor.document.change("Opacity", [&](document::Content& c) { c.preset.bleeding.opacity = 0.8 + 0.001 * i; });
        double built = 0, drawn = 0;
        headless.frame(1.0 / 60, {.after = [&](app::FrameStep step) {
                           if (step == app::FrameStep::followed) glFinish(), built = ms_since(start);
                           if (step == app::FrameStep::drawn) glFinish(), drawn = ms_since(start);
                       }});
        headless.draw_ui();
        glFinish();
        const double all = ms_since(start);
        progress.step();
        if (i < extent.warm_up) continue;
        costs.ui.push_back(built + all - drawn);
        costs.scene.push_back(drawn - built);
    }
    return costs;
}

constexpr std::string_view dragged = "**/Favourites/Noise scale";

enum class FrameKind { still, idle, drag };

/// Makes frames of a kind with the pointer at `at`.
class Frames {
  public:
    Frames(commands::HeadlessEditor& headless, glm::vec2 at) : headless_(headless), at_(at) {
        again_.target.resize(headless.editor().preview.size());
    }

    /// s of CPU that they cost beside drawing the scene, on the average.
    double cost(FrameKind kind, int frames) {
        double seconds = 0;
        for (int i = 0; i < frames; ++i) seconds += cost_of_one(kind, i % 2 == 0 ? 4.0F : -4.0F);
        return seconds / frames;
    }

  private:
    double cost_of_one(FrameKind kind, float moved) {
        glFinish();
        const double begin = thread_seconds();
        if (kind == FrameKind::drag)
            headless_.ui().push({.kind = ui::EventKind::pointer, .at = at_ + glm::vec2(moved, 0)});
        double built = 0, drawn = 0;
        headless_.frame(1.0 / 60, {.after = [&](app::FrameStep step) {
                            if (step == app::FrameStep::followed) built = thread_seconds();
                            if (step != app::FrameStep::drawn) return;
                            if (kind == FrameKind::idle) draw_again();
                            glFinish();
                            drawn = thread_seconds();
                        }});
        headless_.draw_ui();
        return thread_seconds() - drawn + built - begin;
    }

    /// The scene, which has not changed, as the drag draws it.
    void draw_again() {
        again_.revision = 0;
        headless_.editor().preview.draw_into(again_, headless_.editor().shot());
    }

    commands::HeadlessEditor& headless_;
    glm::vec2 at_;
    app::PreviewCopy again_;
};

/// Adds its rows and ratios. The default layout is shown.
void measure_drag(commands::HeadlessEditor& headless, const Extent& extent, BenchReport& report) {
    ui::Ui& ui = headless.ui();
    const glm::vec2 at = ui.tree()[ui::find(ui.tree(), dragged)].rect().center();
    Frames frames(headless, at);
    double still = std::numeric_limits<double>::infinity(), idle = still, drag = still;
    for (int run = 0; run < extent.runs; ++run) {
        ui.push({.kind = ui::EventKind::pointer, .at = at});
        headless.settle();
        still = std::min(still, frames.cost(FrameKind::still, extent.frames));
        idle = std::min(idle, frames.cost(FrameKind::idle, extent.frames));
        ui.push({.kind = ui::EventKind::press, .at = at});
        headless.frame();
        const std::uint64_t before = headless.editor().document.version();
        drag = std::min(drag, frames.cost(FrameKind::drag, extent.frames));
        if (headless.editor().document.version() < before + static_cast<std::uint64_t>(extent.frames))
            throw std::logic_error("the slider does not move");
        ui.push({.kind = ui::EventKind::release, .at = at});
        headless.settle();
    }
    report.rows.push_back({.of = {{"frame", "still"}}, .measured = {{"cpu_ms", 1e3 * still}}});
    report.rows.push_back({.of = {{"frame", "idle"}}, .measured = {{"cpu_ms", 1e3 * idle}}});
    report.rows.push_back({.of = {{"frame", "drag"}}, .measured = {{"cpu_ms", 1e3 * drag}}});
    report.ratios["drag_over_idle"] = drag / idle;
    report.ratios["drag_over_still"] = drag / still;
}

}  // namespace

BenchReport bench_editor(const BenchOptions& options) {
    const Extent& extent = options.short_form ? least : whole;
    commands::HeadlessEditor headless(extent.window, 1.0F, "auto",
                                      false);  // decoding and jobs run at the same time, as in the window
    BenchReport report{
        .bench = "editor", .renderer = headless.context().renderer(), .rows = {}, .ratios = {}, .table = {}};
    app::Opened opened = app::open_sample(commands::data_folder());
    headless.editor().document.open(std::move(opened.content), opened.scene_file, opened.preset_file);
    headless.settle();
    headless.editor().jobs.finish();
    headless.settle();
    measure_drag(headless, extent, report);
    double worst = 0;
    const std::vector<std::string> layouts = headless.editor().layouts().names();
    commands::Progress progress("measuring", static_cast<int>(layouts.size()) * (extent.warm_up + extent.frames));
    for (const std::string& layout : layouts) {
        headless.editor().layouts().choose(layout);
        headless.settle();
        headless.editor().jobs.finish();  // the organ is there
        headless.settle();
        Costs costs = measure(headless, extent, progress);
        const double scene = median(costs.scene), ui = median(costs.ui);
        report.rows.push_back({.of = {{"layout", layout}}, .measured = {{"scene_ms", scene}, {"ui_ms", ui}}});
        worst = std::max(worst, ui / scene);
    }
    report.ratios["editor_ui_over_scene"] = worst;
    return report;
}

}  // namespace lapfx::bench
