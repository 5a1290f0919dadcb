// Marks that the measured curves of the reference propose: when smoke starts, peaks and clears, and when blood starts.
//
//     const ReferenceMarks proposed = marks_to_take(measuring, document);
//     take_marks(document, proposed);   // one undo step
#pragma once

#include "document/document.h"
#include "match/video/measure.h"

namespace lapfx::app {

class Measuring;

/// From the episodes: onset, peak and the time at which half of the peak is gone of the veil, onset of the blood. s of
/// the reference; -1 where the curve does not show it.
ReferenceMarks marks_of(const match::Measurement& found);
/// Those of them that the scene has not marked yet; none while the reference is not measured as it is now.
ReferenceMarks marks_to_take(const Measuring& measuring, const document::Document& document);
bool any_marks(const ReferenceMarks& marks);
/// An undo step: the scene has these marks, too.
void take_marks(document::Document& document, const ReferenceMarks& marks);

}  // namespace lapfx::app
