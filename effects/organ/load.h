// load_organ() (lapfx/organ.h) with progress.
#pragma once

#include "lapfx/organ.h"
#include "organ/file.h"
#include "organ/pixels.h"
#include "work/stages.h"

namespace lapfx::organ {

enum class Format { gltf, obj, ply, stl, off, unknown };

/// What the file starts with, and for the formats that start with nothing of their own, the name.
Format format_of(const std::filesystem::path& path, const Bytes& bytes);

/// Of none of them.
[[noreturn]] void refuse_format(const std::string& file);

/// As load_organ(). Throws Stopped when the stages say so. `encoded`: where the files of its images go to, by image.
Organ load(const std::filesystem::path& path, const OrganOptions& options, const work::Stages& stages,
           std::vector<Encoded>* encoded = nullptr);

}  // namespace lapfx::organ
