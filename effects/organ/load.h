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

/// Throws Error for a scale or a rotation that cannot be applied.
void require_usable(const OrganOptions& options, const std::string& file);
/// Applies organ.scale, and the rotation and the texture of the options. Throws Error.
void place(Organ& organ, const OrganOptions& options, std::vector<Encoded>* encoded);

}  // namespace lapfx::organ
