// What pack_organ() (lapfx/pack.h) asks of the formats.
#pragma once

#include <map>

#include "lapfx/pack.h"
#include "organ/file.h"

namespace lapfx::organ {

/// The files of an organ that is being packed.
class Packing {
  public:
    explicit Packing(std::filesystem::path folder) : folder_(std::move(folder)) {}

    const std::filesystem::path& folder() const { return folder_; }
    /// A file of the organ, or the one that it is already.
    std::string add(const std::filesystem::path& file, std::string_view extension, Bytes bytes);
    /// The name of a picture in the pack; empty: it is none that can be decoded.
    std::string add_picture(const std::filesystem::path& file);
    /// A name that no file has.
    std::string unused(const std::filesystem::path& wanted) { return names_.give(wanted, ".missing"); }

    std::vector<PackedFile> files;

  private:
    std::filesystem::path folder_;
    OwnNames names_;
    std::map<std::filesystem::path, std::string> known_;  ///< by where they lie
};

/// The text of an OBJ that names what is packed with it.
Bytes pack_obj(const Bytes& bytes, Packing& packing);
/// The text of a material library; empty: it is none.
std::string pack_mtl(const std::string& text, Packing& packing);
/// A .gltf or .glb; the same bytes where it names nothing outside itself.
Bytes pack_gltf(const Bytes& bytes, const std::string& file, Packing& packing);

}  // namespace lapfx::organ
