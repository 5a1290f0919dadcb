// What a person does with strokes of blood as a whole: from a file, to a file, and the frame that has no blood.
// Painting them is MeasureBench::add_stroke.
//
//     open_strokes(document, reference, "strokes.json", notices);   // an undo step
//
// UI thread.
#pragma once

#include <filesystem>
#include <string>

#include "app/base/notices.h"
#include "document/document.h"
#include "lapfx/authoring/video.h"
#include "lapfx/error.h"

namespace lapfx::app {

class Reference;

/// A time that means this frame also when it was rounded: s, whole ms, a little after the frame begins.
double time_within(const VideoReader& video, int frame);

/// What is wrong with the scene's strokes, for people: "stroke 2 at 1.88 s: lies outside of the view".
std::string text_of(const Fault& fault, const ReferenceMeasure& measure);

/// In place of those that the scene has: an undo step. What cannot be read is told. Nothing without a reference that
/// can be shown.
void open_strokes(document::Document& document, const Reference& reference, const std::filesystem::path& path,
                  Notices& notices);
/// A notice says that it was written, or why not.
void export_strokes(const ReferenceMeasure& measure, const std::filesystem::path& path, Notices& notices);
/// An undo step: the frame that is shown has no blood. Nothing without a reference that can be shown.
void name_frame_without_blood(document::Document& document, const Reference& reference);
void remove_strokes(document::Document& document);  ///< an undo step

}  // namespace lapfx::app
