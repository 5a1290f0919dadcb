// The bottom line: what is open, what is being done, what it costs.
#include <algorithm>
#include <cstdio>

#include "app/base/jobs.h"
#include "app/base/layouts.h"
#include "app/clips/clip_shelf.h"
#include "app/files/exports.h"
#include "app/files/hot_reload.h"
#include "app/measure/fitting.h"
#include "app/memory.h"
#include "app/meter.h"
#include "app/preview/preview_host.h"
#include "app/reference/reference.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "ui/shell/progress.h"
#include "ui/shell/status_bar.h"

namespace lapfx::panels {

namespace {

constexpr float room_for_costs = 52;  // em of the window: in less, the names of scene and preset need it

std::string_view formatted(ui::Ui& ui, const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return ui.copy(text);
}

/// The oldest job that no panel shows, and how many more there are: "43 %, +2".
void jobs(ui::Ui& ui, const StatusParts& parts) {
    if (parts.fitting.busy() && !parts.fitting.proposes() && !parts.fitting.measures_first() &&
        !parts.layouts.seen("Fit")) {
        if (ui::progress(ui, "Fitting", parts.fitting.progress(), {.cancellable = true, .width = ui::px(ui.em(20))}))
            parts.fitting.cancel();
        return;
    }
    auto running = parts.jobs.running();
    std::erase_if(running, [exports = parts.exports.job()](const auto& job) { return job.get() == exports; });
    const auto loading = parts.preview.loading();
    if (loading && parts.layouts.seen("View"))
        std::erase_if(running, [&](const auto& job) { return job.get() == loading->job; });
    if (running.empty()) return;
    app::Job& job = *running.front();
    const std::string_view more =
        running.size() > 1 ? formatted(ui, "+%.0f", static_cast<double>(running.size() - 1)) : "";
    if (ui::progress(ui, job.name(), job.progress(), {.cancellable = true, .text = more, .width = ui::px(ui.em(20))}))
        job.cancel();
}

std::string_view megabytes(ui::Ui& ui, std::size_t bytes) {
    return formatted(ui, "%.0f MB", static_cast<double>(bytes) / 1e6);
}

/// What holds it, a line each.
std::string_view memory_tip(ui::Ui& ui, const StatusParts& parts) {
    const app::ProcessMemory process = parts.meter.memory();
    const bool software = parts.options.software;  // then textures are in main memory, too
    std::string_view tip = "Main memory that the editor uses:";
    std::size_t known = process.files;
    for (const app::MemoryPart& part : app::memory_parts(parts.preview, parts.reference, parts.measuring,
                                                         parts.measured, parts.images, parts.document)) {
        if (part.bytes < 500'000) continue;
        const bool elsewhere = part.gpu && !software;
        if (!elsewhere) known += part.bytes;
        tip = ui.join({tip, "\n", part.name, "  ", megabytes(ui, part.bytes), elsewhere ? " on the GPU" : ""});
    }
    return ui.join({tip, "\nProgram and libraries  ", megabytes(ui, process.files), "\nDriver, decoders, all else  ",
                    megabytes(ui, process.all - std::min(process.all, known))});
}

void costs(ui::Ui& ui, const StatusParts& parts) {
    if (ui.window().x < ui.em(room_for_costs)) return;
    ui::status_text(ui, "Scene time", formatted(ui, "scene %.1f ms", 1000 * parts.meter.scene.seconds()),
                    {.number = true, .width = 7.5F, .tip = "Time to draw one frame of the scene"});
    ui::status_text(ui, "UI time", formatted(ui, "UI %.1f ms", 1000 * parts.meter.ui),
                    {.number = true, .width = 5.5F, .tip = "Time to build and draw the panels, per frame"});
    ui::status_text(ui, "Memory", megabytes(ui, parts.meter.memory().all),
                    {.number = true, .width = 4.5F, .tip = memory_tip(ui, parts)});
}

}  // namespace

void status_bar(ui::Ui& ui, const StatusParts& parts) {
    const ui::StatusBar bar(ui);
    const std::string& scene = parts.document.scene().name;
    const std::string& preset = parts.document.preset().name;
    ui::status_text(ui, "Scene",
                    ui.join({scene.empty() ? "Unnamed scene" : scene, parts.document.scene_unsaved() ? " *" : ""}),
                    {.tip = "The scene: what the preset is previewed on. * marks changes that are not saved."});
    ui::status_text(
        ui, "Preset",
        ui.join({preset.empty() ? "Unnamed preset" : preset, parts.document.preset_unsaved() ? " *" : ""}),
        {.tone = ui::Tone::normal, .tip = "The preset: what a simulator loads. * marks changes that are not saved."});
    const auto& clips = parts.document.preset().smoke.clips;
    if (const auto& alone = parts.clips.alone(); alone && *alone < clips.size())
        ui::status_text(ui, "Solo",
                        ui.join({"Solo: ", ui.copy(std::filesystem::path(clips[*alone].file).filename().string())}),
                        {.tone = ui::Tone::warning,
                         .icon = ui::Icon::warning,
                         .tip = "The preview shows only the smoke of this clip; preset and exports have that of all. "
                                "Solo in the Clips panel ends it."});
    if (parts.reference.held() && parts.reference.video() != nullptr)
        ui::status_text(ui, "Held", ui.join({"Reference held at ", formatted(ui, "%.2f s", parts.reference.time())}),
                        {.tone = ui::Tone::warning,
                         .icon = ui::Icon::lock,
                         .tip = "The reference stays at this frame while the timeline moves on, as after painting over "
                                "it. Hold in the Reference or Measure panel lets it go."});
    if (const std::vector<Fault>& faults = parts.hot_reload.shader_faults(); !faults.empty())
        ui::status_text(ui, "Shader fault", faults.front().text(),
                        {.tone = ui::Tone::error,
                         .icon = ui::Icon::error,
                         .tip = "The last working shaders are still used. Correct the file; it is then read again."});
    ui::spacer(ui);
    export_status(ui, parts.exports);
    jobs(ui, parts);
    app::Meter& meter = parts.meter;
    if (meter.frames_per_second() > 0)
        ui::status_text(ui, "Frame rate", formatted(ui, "%.0f fps", meter.frames_per_second()),
                        {.number = true, .width = 4, .tip = "Pictures of the scene per second while it plays"});
    if (meter.memory().all > 0) costs(ui, parts);  // pictures of the editor do not depend on the machine
    const app::EditorOptions& o = parts.options;
    ui::status_text(
        ui, "Renderer", o.software ? "Software" : "GPU",
        {.number = true, .tip = ui.join({o.software ? "Drawn without a GPU, by " : "Drawn by ", o.renderer})});
}

}  // namespace lapfx::panels
