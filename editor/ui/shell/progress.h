// A progress bar, with the time that is left.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct ProgressOptions {
    double seconds_left = -1;    ///< s; negative or not finite: not known
    bool at_most = false;        ///< it may end sooner: "up to 4 s left"
    bool cancellable = false;    ///< there is a button at the right that cancels
    std::string_view text = {};  ///< shown next to it, such as "120 of 240 frames"
    Size width = {SizeKind::grow, 1};
};

/// `fraction` is 0 to 1, clamped. If it is negative or not finite, the progress is unknown, and a part of the bar moves
/// forwards and backwards (with reduced motion it stands still). `label` is shown in front of the bar. Returns whether
/// the person cancels.
bool progress(Ui& ui, std::string_view label, double fraction, const ProgressOptions& options = {});

/// "4 s", "1 min 20 s", "2 h 05 min", in the arena of the frame. It is rounded up, so that it never says 0 s. If the
/// time is not known the text is empty.
std::string_view duration_text(Ui& ui, double seconds);

}  // namespace lapfx::ui
