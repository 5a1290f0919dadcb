#include "match/use/compare_scene.h"

#include <utility>

#include "match/video/peak_colors.h"

namespace lapfx::match {

std::optional<ComparedScene> compare_scene(const SceneToCompare& what, PreviewCurve& curve, const Progress& progress) {
    PeakColors colors;
    CurveCalls calls{.progress = progress};
    if (what.colors != nullptr)
        calls.measured = [&colors](const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
            colors.add(frame, estimator, amounts);
        };
    std::optional<std::vector<FrameAmounts>> frames = curve.measure(what.scene, what.preset, what.times, calls);
    if (!frames) return {};
    Compared compared{.amounts = likeness_of(*frames, what.reference, what.offset), .colors = {}};
    if (what.colors != nullptr) compared.colors = likeness_of(colors.found(), *what.colors);
    return ComparedScene{.frames = std::move(*frames), .compared = std::move(compared)};
}

}  // namespace lapfx::match
