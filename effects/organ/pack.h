// What pack_organ() (lapfx/authoring/pack.h) needs from the formats.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "lapfx/authoring/pack.h"
#include "organ/file.h"

namespace lapfx::organ {

/// How a file of the pack is read. A file that is named in two ways is in the pack twice, with different bytes.
enum class PackedKind { mesh, library, picture, buffer };

/// The files of an organ that is being packed. Each is read once, however often it is named.
class Packing {
  public:
    explicit Packing(std::filesystem::path folder) : folder_(std::move(folder)) {}

    const std::filesystem::path& folder() const { return folder_; }
    /// The name of a file that add() or leave_out() knows; empty: it is left out. None: the file is new.
    std::optional<std::string> known(PackedKind kind, const std::filesystem::path& file) const;
    /// Adds a file that is not known yet.
    std::string add(PackedKind kind, const std::filesystem::path& file, std::string_view extension, Bytes bytes);
    /// Leaves out a file that is not what it is named as.
    void leave_out(PackedKind kind, const std::filesystem::path& file) { known_.try_emplace({kind, file}); }
    /// The name of a picture in the pack; empty: it is not a picture that can be decoded.
    std::string add_picture(const std::filesystem::path& file);
    /// The name of a buffer in the pack, with at least `length` of its bytes. Throws Error (bad_input), which names
    /// `what` at `place` in `mesh`, when it cannot be read or is shorter.
    std::string add_buffer(const std::filesystem::path& file, std::size_t length, const std::string& mesh,
                           const std::string& place, const std::string& what);
    /// A name that no file has.
    std::string unused(const std::filesystem::path& wanted) { return names_.give(wanted, ".missing"); }

    std::vector<PackedFile> files;

  private:
    std::filesystem::path folder_;
    OwnNames names_;
    /// The key is kind and path, the value the index in `files`; none: the file is left out.
    std::map<std::pair<PackedKind, std::filesystem::path>, std::optional<std::size_t>> known_;
};

/// The text of an OBJ that names the files packed with it.
Bytes pack_obj(const Bytes& bytes, Packing& packing);
/// The text of a material library; empty: the file is not one.
std::string pack_mtl(const std::string& text, Packing& packing);
/// A PLY whose comments name the textures packed with it.
Bytes pack_ply(const Bytes& bytes, const std::string& file, Packing& packing);
/// A .gltf or .glb; the same bytes if it names no other file.
Bytes pack_gltf(const Bytes& bytes, const std::string& file, Packing& packing);

}  // namespace lapfx::organ
