// What pack_organ() (lapfx/pack.h) asks of the formats.
#pragma once

#include <map>
#include <optional>
#include <utility>

#include "lapfx/authoring/pack.h"
#include "organ/file.h"

namespace lapfx::organ {

/// What a file of the pack is read as. A file that is named as two of them is two in the pack: their bytes differ.
enum class PackedKind { mesh, library, picture, buffer };

/// The files of an organ that is being packed. Each is read once, however often it is named.
class Packing {
  public:
    explicit Packing(std::filesystem::path folder) : folder_(std::move(folder)) {}

    const std::filesystem::path& folder() const { return folder_; }
    /// The name of a file that add() or leave_out() was told of; empty: it stays behind. None: it is new.
    std::optional<std::string> known(PackedKind kind, const std::filesystem::path& file) const;
    /// A file that is not known yet.
    std::string add(PackedKind kind, const std::filesystem::path& file, std::string_view extension, Bytes bytes);
    /// A file that is not what it is named as.
    void leave_out(PackedKind kind, const std::filesystem::path& file) { known_.try_emplace({kind, file}); }
    /// The name of a picture in the pack; empty: it is none that can be decoded.
    std::string add_picture(const std::filesystem::path& file);
    /// The name of a buffer in the pack, of which at least `length` bytes come along. Throws Error (bad_input), which
    /// names `what` at `place` in `mesh`: it cannot be read, or is shorter.
    std::string add_buffer(const std::filesystem::path& file, std::size_t length, const std::string& mesh,
                           const std::string& place, const std::string& what);
    /// A name that no file has.
    std::string unused(const std::filesystem::path& wanted) { return names_.give(wanted, ".missing"); }

    std::vector<PackedFile> files;

  private:
    std::filesystem::path folder_;
    OwnNames names_;
    /// By where they lie: the place in `files`; none: it stays behind.
    std::map<std::pair<PackedKind, std::filesystem::path>, std::optional<std::size_t>> known_;
};

/// The text of an OBJ that names what is packed with it.
Bytes pack_obj(const Bytes& bytes, Packing& packing);
/// The text of a material library; empty: it is none.
std::string pack_mtl(const std::string& text, Packing& packing);
/// A .gltf or .glb; the same bytes where it names nothing outside itself.
Bytes pack_gltf(const Bytes& bytes, const std::string& file, Packing& packing);

}  // namespace lapfx::organ
