// The mesh formats: one row each, with the function that reads it.
#pragma once

#include "lapfx/authoring/formats.h"
#include "organ/file.h"
#include "organ/raw.h"

namespace lapfx::organ {

class Packing;

struct MeshFormat {
    FileFormat file;
    double unit;                 ///< mm, where the scene says nothing
    bool signed_always = false;  ///< a file of this name that does not begin with the signature is none
    RawOrgan (*read)(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);
    /// For a bundle: its bytes, naming what is packed with it. Null: it names no other files.
    Bytes (*pack)(const Bytes& bytes, const std::string& file, Packing& packing) = nullptr;
};

/// By what the file begins with, and for the formats that begin with nothing of their own by the name. Throws Error
/// (bad_input) for none of them, or for one that does not begin as its name says.
const MeshFormat& mesh_format(const std::filesystem::path& path, const std::string& file, const Bytes& bytes);

}  // namespace lapfx::organ
