// Whether an organ's arrays fit together: a host may have filled them by hand.
#pragma once

#include "lapfx/organ.h"

namespace lapfx::organ {

/// Throws Error (bad_input) naming what does not fit. Pure; any thread.
void require_complete(const Organ& organ);

}  // namespace lapfx::organ
