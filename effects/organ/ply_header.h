// The header of a PLY: which elements follow, and what each consists of.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace lapfx::organ {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyCoding { text, little_endian, big_endian };

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::float32;
    bool is_list = false;
    PlyType count_type = PlyType::uint8;  ///< of a list
};

struct PlyElement {
    std::string name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    /// Index of a property, or -1.
    int find(std::string_view property) const;
};

/// "comment TextureFile my skin.png", as MeshLab writes it.
struct PlyTexture {
    std::string name;
    std::size_t at = 0;  ///< byte at which the name begins
};

struct PlyHeader {
    PlyCoding coding = PlyCoding::text;
    std::vector<PlyElement> elements;
    std::vector<PlyTexture> textures;
    std::size_t size = 0;  ///< bytes up to the data
};

std::size_t size_of(PlyType type);

/// Throws Error with the number of the line that is wrong.
PlyHeader read_ply_header(const std::string& file, std::string_view text);

}  // namespace lapfx::organ
