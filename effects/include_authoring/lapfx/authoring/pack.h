// Files on their way to others: an organ with all that it needs, under names of their own.
//
//     for (const lapfx::PackedFile& file : lapfx::pack_organ("cases/liver.obj")) write_file(folder / file.name, ...);
//     // liver.obj (names liver.mtl)  liver.mtl (names skin.png)  skin.png
//
// Names in a file from outside are never used as they are: they may lead anywhere, or be what another program starts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lapfx {

/// Plain names of a folder, each given once, whatever the case of its letters.
class OwnNames {
  public:
    /// After `wanted`, a name or path from outside of which the last name without its extension counts; `extension`
    /// with its dot. Letters, digits, '.', '_' and '-' stay, others become '_'; never hidden, never empty.
    std::string give(const std::filesystem::path& wanted, std::string_view extension);

  private:
    std::set<std::string> taken_;
    std::map<std::string, int> numbers_;  ///< tried last, of names that more than one asked for
};

struct PackedFile {
    std::string name;  ///< plain; as the others name it
    std::vector<std::uint8_t> bytes;
};

/// The mesh first, then what it names: material libraries, pictures, buffers, in texts that name each other by the new
/// names. Only what was read successfully as what it should be is packed, as the very bytes that were read; the rest is
/// named no more, or by a name that no file has. What is embedded in an organ stays there. Throws Error (bad_input)
/// where load_organ() does for want of a file, or for one that may not be followed.
std::vector<PackedFile> pack_organ(const std::filesystem::path& path);

}  // namespace lapfx
