// The pictures of the report of lapfx fit.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/video.h"
#include "match/fit/report.h"

namespace lapfx::commands {

/// Fills the report's moments: frames of the reference beside what the scene shows with `before` and with the result.
/// Render thread, context current. Throws Error (runtime) when the driver cannot make a picture.
void add_pictures(match::FitReport& report, VideoReader& reference, const match::Tuned& before,
                  const std::shared_ptr<const PreparedOrgan>& organ, const PreviewOptions& preview);

/// A picture for an index of many, as JPEG.
std::string small_jpeg(const Image& image);
/// Of a JPEG; empty where it is none.
std::string small_jpeg(const std::string& jpeg);

}  // namespace lapfx::commands
