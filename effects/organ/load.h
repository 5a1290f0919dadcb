// load_organ() (lapfx/organ.h) with progress.
#pragma once

#include "lapfx/organ.h"
#include "organ/file.h"
#include "organ/pixels.h"
#include "work/stages.h"

namespace lapfx::organ {

/// Like load_organ(). Throws Stopped when the stages say so. `encoded` receives the encoded files of its images, by
/// image.
Organ load(const std::filesystem::path& path, const OrganOptions& options, const work::Stages& stages,
           std::vector<Encoded>* encoded = nullptr);

}  // namespace lapfx::organ
