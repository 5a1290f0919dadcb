// How far a long task has come, and whether to continue it.
//
//     auto prepared = lapfx::prepare_organ(organ, preset.vessels, [&](double share) { bar = share; return !cancelled;
//     });
#pragma once

#include <functional>

namespace lapfx {

/// Called on the working thread with a share from 0 to 1, never less than before. Returning false stops the work as
/// soon as possible. May be empty.
using Progress = std::function<bool(double share)>;

}  // namespace lapfx
