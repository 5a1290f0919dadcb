// The report of lapfx fit: whether its file may be written, and its pictures.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/video.h"
#include "match/fit/report.h"

namespace lapfx::commands {

/// The files that a scene is made of, as it names them; and those in `more` that have a name.
std::vector<std::filesystem::path> files_of(const Scene& scene, std::vector<std::filesystem::path> more);

/// Checks before the work. Throws Error: bad_input for a name that does not end in .html or is one of `taken`, runtime
/// where the file may not be written.
void check_report(const std::filesystem::path& report, std::span<const std::filesystem::path> taken);

/// Fills the report's moments: frames of the reference beside what the scene shows with `before` and with the result.
/// Render thread, context current. Throws Error (runtime) when the driver cannot make a picture.
void add_pictures(match::FitReport& report, VideoReader& reference, const match::Tuned& before,
                  const std::shared_ptr<const PreparedOrgan>& organ, const PreviewOptions& preview);

}  // namespace lapfx::commands
