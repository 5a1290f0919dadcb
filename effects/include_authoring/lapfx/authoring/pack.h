// Packs files for other people: an organ with everything that it needs, under new names.
//
//     for (const lapfx::PackedFile& file : lapfx::pack_organ("cases/liver.obj")) write_file(folder / file.name, ...);
//     // liver.obj (names liver.mtl)  liver.mtl (names skin.png)  skin.png
//
// Names in a file from outside are never used as they are: they may lead anywhere, or name something that another
// program would start.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace lapfx {

/// Gives out plain names for one folder, each only once, also in another case.
class OwnNames {
  public:
    /// A name like `wanted`, a name or path from outside, whose last part without extension counts. `extension`
    /// includes the dot. Letters, digits, '.', '_' and '-' stay and others become '_'; the name is never hidden and
    /// never empty.
    std::string give(const std::filesystem::path& wanted, std::string_view extension);

  private:
    std::set<std::string> taken_;
    std::map<std::string, int> numbers_;  ///< number tried last for a name that was asked for more than once
};

struct PackedFile {
    std::string name;  ///< plain name, as the other files refer to it
    std::vector<std::uint8_t> bytes;
};

/// The mesh first, then what it names: material libraries, pictures and buffers. The texts refer to each other by the
/// new names. Only files that were read successfully are packed, with exactly the bytes that were read; references to
/// others are removed, or replaced by a name that no file has. What is embedded in an organ stays there. Throws Error
/// (bad_input) where load_organ() does because a file is missing or may not be followed.
std::vector<PackedFile> pack_organ(const std::filesystem::path& path);

}  // namespace lapfx
