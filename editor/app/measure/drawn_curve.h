// How the scene is drawn beside the UI, to be measured or shown in a report: with the organ and the clips that the
// preview has loaded, one picture at a time.
//
//     steps_ = std::make_unique<RenderSteps>([this] { jobs_.wake(); });
//     curve_ = drawn_curve(organ, host_, clip_folders_, exact_ ? nullptr : &steps_);
//     each frame:  steps_->serve(frame_budget);
//
// UI thread, context current.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "app/base/render_steps.h"
#include "match/scene/preview_curve.h"

namespace lapfx::app {

class PreviewHost;

inline constexpr double look_again = 0.05;    ///< s until it is looked again whether something is loaded
inline constexpr double frame_budget = 8e-3;  ///< s of a frame for drawing; one picture is drawn anyway

/// `steps`: those of whoever draws at that moment, must outlive it; null: the thread that measures draws, too.
std::unique_ptr<match::PreviewCurve> drawn_curve(std::shared_ptr<const PreparedOrgan> organ, const PreviewHost& host,
                                                 const std::vector<std::filesystem::path>& clip_folders,
                                                 const std::unique_ptr<RenderSteps>* steps,
                                                 match::PreviewCurve::Options options = {});

}  // namespace lapfx::app
