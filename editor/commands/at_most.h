// --at-most NAME=VALUE of `lapfx compare`: limits on figures of a likeness, and which of them do not hold.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lapfx/error.h"
#include "match/compare/likeness_figures.h"

namespace lapfx::commands {

struct Limit {
    const match::Figure* figure;  ///< never null
    double value;                 ///< the figure is not to be farther (Figure::far); 0 or more

    /// A figure that is not known cannot be shown to hold.
    bool holds(const match::Compared& compared) const;
};

/// In their order. Throws Error (bad_input) with every fault: not NAME=VALUE, no figure of that name, no number of 0 or
/// more, a name for the second time.
std::vector<Limit> limits_of(std::span<const std::string> texts);

/// One line for each that does not hold: "veil_rms is 0.12, above the 0.05 that is allowed".
std::vector<Fault> faults_of(std::span<const Limit> limits, const match::Compared& compared);

}  // namespace lapfx::commands
