// A progress bar, with the time that is left.
#pragma once

#include "ui/core/ui.h"

namespace lapfx::ui {

struct ProgressOptions {
    double seconds_left = -1;    ///< s; negative or not finite: not known
    bool cancellable = false;    ///< a button at the right that gives it up
    std::string_view text = {};  ///< shown beside it, such as "120 of 240 frames"
    Size width = {SizeKind::grow, 1};
};

/// `fraction`: 0 to 1, clamped; negative or not finite: nobody knows, a part of the bar runs to and fro (with reduced
/// motion it stands). `label` is shown in front of it. Returns whether it is to be given up.
bool progress(Ui& ui, std::string_view label, double fraction, const ProgressOptions& options = {});

/// "4 s", "1 min 20 s", "2 h 05 min", in the arena of the frame; rounded up, so that it never says 0 s. Not known: "".
std::string_view duration_text(Ui& ui, double seconds);

}  // namespace lapfx::ui
