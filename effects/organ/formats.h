// The mesh formats: one row each, with the function that reads it.
#pragma once

#include "lapfx/authoring/formats.h"
#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

class Packing;

struct MeshFormat {
    FileFormat file;
    double unit;                 ///< mm per unit if the scene does not say
    bool signed_always = false;  ///< a file with this extension must begin with the signature
    RawOrgan (*read)(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);
    /// For a bundle: its bytes, which name the files that are packed with it. Null: the format names no other files.
    Bytes (*pack)(const Bytes& bytes, const std::string& file, Packing& packing) = nullptr;
};

/// The format by the first bytes of the file, or by its name for formats without a signature. Throws Error (bad_input)
/// for an unknown format, and for a file that does not begin as its name says.
const MeshFormat& mesh_format(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
