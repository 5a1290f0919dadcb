#include "commands/beside.h"

#include <filesystem>

#include "app/measure/side_by_side.h"
#include "commands/matched_videos.h"
#include "commands/progress.h"
#include "commands/say.h"

namespace lapfx::commands {

std::unique_ptr<output::FramePage> beside_page(const ShownScene& shown, const std::string& scene,
                                               const std::string& file, glm::ivec2 frame,
                                               std::shared_ptr<const PreparedOrgan> organ) {
    namespace fs = std::filesystem;
    MatchOptions options;
    options.reference = file;
    auto video = std::make_shared<VideoReader>(opened_video(file));
    const Preset& preset = shown.presets.front();
    const std::string& name = preset.name;
    app::Compared compared{.frame = frame,
                           .duration = shown.scene.duration,
                           .preview = name.empty() ? fs::path(scene).filename().string() : name,
                           .video = fs::path(file).filename().string(),
                           .reference = reference_of(options, shown.scene)};
    const match::MeasureOptions measured = measure_options(options, compared.reference, video->info().size, scene);
    match::PreviewCurve curve = preview_curve(
        shown, std::move(organ),
        match::PreviewCurve::options_for(video->info().size, compared.reference.aspect, measured.estimator));
    constexpr int progress_steps = 100;
    Progress progress("comparing", progress_steps);
    const app::BothWanted wanted{
        .scene = shown.scene, .preset = preset, .video = *video, .options = measured, .found = nullptr, .curve = curve};
    try {
        measure_both(compared, wanted, [&progress](double share) {
            progress.to(share);
            return true;
        });
    } catch (const Error& error) {
        throw at_file(file, error);
    }
    say(file + ": " + compared.words);
    return std::make_unique<app::SideBySide>(std::move(video), std::move(compared));
}

}  // namespace lapfx::commands
