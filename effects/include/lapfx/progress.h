// How far long work has come, and whether to go on with it.
//
//     auto organ = lapfx::prepare_organ(scene, preset.vessels, [&](double share) { bar = share; return !cancelled; });
#pragma once

#include <functional>

namespace lapfx {

/// Called on the thread that works, with 0 to 1, never less than before. False stops the work as soon as it can be. May
/// be empty.
using Progress = std::function<bool(double share)>;

}  // namespace lapfx
