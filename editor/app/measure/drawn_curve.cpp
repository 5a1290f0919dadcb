#include "app/measure/drawn_curve.h"

#include <utility>

#include "app/preview/preview_host.h"

namespace lapfx::app {

namespace {

constexpr std::size_t clip_memory = std::size_t{128} << 20;  // bytes: the clips of the preview are there already

}  // namespace

std::unique_ptr<match::PreviewCurve> drawn_curve(std::shared_ptr<const PreparedOrgan> organ, const PreviewHost& host,
                                                 const std::vector<std::filesystem::path>& clip_folders,
                                                 const std::unique_ptr<RenderSteps>* steps,
                                                 match::PreviewCurve::Options options) {
    match::RenderThread render;
    if (steps != nullptr)
        render = [steps](const std::function<void()>& drawing) { return (*steps)->carry_out(drawing); };
    return std::make_unique<match::PreviewCurve>(std::move(organ),
                                                 PreviewOptions{.clip_folders = clip_folders,
                                                                .wait_for_clips = true,
                                                                .streaming = {.memory = clip_memory},
                                                                .clip_cache = host.clip_cache()},
                                                 std::move(options), std::move(render));
}

}  // namespace lapfx::app
