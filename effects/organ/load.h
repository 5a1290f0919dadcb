// load_organ() (lapfx/organ.h) with progress.
#pragma once

#include "lapfx/organ.h"
#include "organ/stages.h"

namespace lapfx::organ {

/// As load_organ(). Throws Stopped when the stages say so.
Organ load(const std::filesystem::path& path, const OrganOptions& options, const Stages& stages);

}  // namespace lapfx::organ
