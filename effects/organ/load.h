// load_organ() (lapfx/organ.h) with progress.
#pragma once

#include "lapfx/organ.h"
#include "organ/file.h"
#include "organ/pixels.h"
#include "work/stages.h"

namespace lapfx::organ {

/// As load_organ(). Throws Stopped when the stages say so. `encoded`: where the files of its images go to, by image.
Organ load(const std::filesystem::path& path, const OrganOptions& options, const work::Stages& stages,
           std::vector<Encoded>* encoded = nullptr);

}  // namespace lapfx::organ
