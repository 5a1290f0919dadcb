// The pictures of the report of a fit, as JPEG: frames of the reference beside what the scene shows.
//
//     if (!add_pictures(report, video, scene.reference.aspect, draw)) return;  // stopped
//     write_file("report.html", report_html(report));
//
// Any thread.
#pragma once

#include <atomic>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>

#include "lapfx/authoring/video.h"
#include "lapfx/progress.h"
#include "match/report/report.h"

namespace lapfx::match {

/// Of a picture in the shape in which a reference is shown, its longer side at most report_picture_side px, and no
/// larger than the frame. `frame`: px, as VideoInfo::size. `aspect`: width over height when it is shown
/// (SceneReference::aspect); 0: as stored.
glm::ivec2 report_picture_size(glm::dvec2 frame, double aspect = 0.0);

/// One picture of a scene at `time` s; nothing: it was stopped.
using DrawPicture = std::function<std::optional<Image>(const document::Content& tuned, double time, glm::ivec2 size)>;

/// Fills the report's moments; the result is held against what the fit began with. `aspect`: as of
/// report_picture_size(). `progress` is asked before each picture; `stop` ends the reading of one. False: one of them,
/// or `draw`, stopped it. Throws what these throw.
bool add_pictures(FitReport& report, VideoReader& reference, double aspect, const DrawPicture& draw,
                  const Progress& progress = {}, const std::atomic<bool>* stop = nullptr);

/// A picture for an index of many, as JPEG.
std::string small_jpeg(const Image& image);
/// Of a JPEG; empty where it is none.
std::string small_jpeg(const std::string& jpeg);

}  // namespace lapfx::match
