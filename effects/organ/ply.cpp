#include "organ/ply.h"

#include <bit>
#include <charconv>
#include <cstring>

#include "organ/pack.h"
#include "organ/ply_header.h"
#include "organ/soup.h"
#include "organ/texture_files.h"

namespace lapfx::organ {

namespace {

/// The numbers after the header, one by one.
class PlyNumbers {
  public:
    PlyNumbers(const std::string& file, std::string_view data, PlyCoding coding)
        : file_(file), data_(data), coding_(coding) {}

    double next(PlyType type) { return coding_ == PlyCoding::text ? text() : binary(type); }

    /// How many more numbers there can be: a bound for counts that the file claims.
    std::size_t left() const { return data_.size(); }

  private:
    double text() {
        std::size_t at = data_.find_first_not_of(" \t\r\n");
        if (at == std::string_view::npos) refuse(file_, "", "truncated: the file ends within its data");
        if (data_[at] == '+') ++at;
        double value = 0.0;
        const auto [end, code] = std::from_chars(data_.data() + at, data_.data() + data_.size(), value);
        if (code == std::errc::invalid_argument) {
            const std::size_t stop = std::min(data_.find_first_of(" \t\r\n", at), data_.size());
            refuse(file_, "",
                   "\"" + std::string(data_.substr(at, std::min<std::size_t>(stop - at, 40))) + "\" is not a number");
        }
        data_.remove_prefix(static_cast<std::size_t>(end - data_.data()));
        return value;
    }

    template <class T>
    double load(const char* bytes) {
        T value;
        std::memcpy(&value, bytes, sizeof value);
        return static_cast<double>(value);
    }

    double binary(PlyType type) {
        const std::size_t size = size_of(type);
        if (data_.size() < size) refuse(file_, "", "truncated: the file ends within its data");
        char bytes[8];
        std::memcpy(bytes, data_.data(), size);
        data_.remove_prefix(size);
        const bool swap = (coding_ == PlyCoding::big_endian) != (std::endian::native == std::endian::big);
        if (swap) std::reverse(bytes, bytes + size);
        switch (type) {
            case PlyType::int8:
                return load<std::int8_t>(bytes);
            case PlyType::uint8:
                return load<std::uint8_t>(bytes);
            case PlyType::int16:
                return load<std::int16_t>(bytes);
            case PlyType::uint16:
                return load<std::uint16_t>(bytes);
            case PlyType::int32:
                return load<std::int32_t>(bytes);
            case PlyType::uint32:
                return load<std::uint32_t>(bytes);
            case PlyType::float32:
                return load<float>(bytes);
            case PlyType::float64:
                return load<double>(bytes);
        }
        return 0.0;
    }

    const std::string& file_;
    std::string_view data_;
    PlyCoding coding_;
};

/// The value of 1.0 in a colour of this type.
double color_range(PlyType type) {
    switch (type) {
        case PlyType::uint8:
        case PlyType::int8:
            return 255.0;
        case PlyType::uint16:
        case PlyType::int16:
            return 65535.0;
        case PlyType::float32:
        case PlyType::float64:
            return 1.0;
        default:
            return 255.0;
    }
}

int find_any(const PlyElement& element, std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
        if (const int index = element.find(name); index >= 0) return index;
    return -1;
}

/// Where an element has its colour.
class ColorColumns {
  public:
    explicit ColorColumns(const PlyElement& element)
        : element_(element),
          columns_{find_any(element, {"red", "diffuse_red", "r"}), find_any(element, {"green", "diffuse_green", "g"}),
                   find_any(element, {"blue", "diffuse_blue", "b"}), find_any(element, {"alpha", "a"})} {}

    bool any() const { return columns_[0] >= 0 && columns_[1] >= 0 && columns_[2] >= 0; }
    /// Linear.
    glm::vec4 of(const std::vector<double>& values) const {
        glm::vec4 srgb(1.0f);
        for (int c = 0; c < 4; ++c) {
            const auto column = static_cast<std::size_t>(columns_[static_cast<std::size_t>(c)]);
            if (columns_[static_cast<std::size_t>(c)] >= 0)
                srgb[c] = static_cast<float>(values[column] / color_range(element_.properties[column].type));
        }
        return linear_color(srgb);
    }

  private:
    const PlyElement& element_;
    std::array<int, 4> columns_;
};

class PlyReader {
  public:
    PlyReader(const std::string& file, const PlyHeader& header, std::string_view data)
        : file_(file), header_(header), numbers_(file, data, header.coding) {}

    Soup read() {
        for (const PlyElement& element : header_.elements) {
            // Every element takes a byte at least.
            if (!element.properties.empty() && element.count > numbers_.left())
                refuse(
                    file_, "",
                    "truncated: the header promises " + std::to_string(element.count) + " of element " + element.name);
            if (element.name == "vertex")
                vertices(element);
            else if (element.name == "face" || element.name == "tristrips")
                faces(element);
            else
                skip(element);
        }
        if (!soup_.face_colors.empty()) soup_.face_colors.resize(soup_.faces(), glm::vec4(1.0f));
        if (!soup_.face_part.empty()) soup_.face_part.resize(soup_.faces(), 0);
        return std::move(soup_);
    }

  private:
    using Values = std::vector<double>;

    std::size_t list_length(const PlyProperty& property) {
        const double count = numbers_.next(property.count_type);
        if (!(count >= 0.0) || count != std::floor(count) || count > static_cast<double>(numbers_.left()))
            refuse(file_, "", "a list of property " + property.name + " has an impossible length");
        return static_cast<std::size_t>(count);
    }

    void skip_property(const PlyProperty& property) {
        const std::size_t count = property.is_list ? list_length(property) : 1;
        for (std::size_t i = 0; i < count; ++i) numbers_.next(property.type);
    }

    void skip(const PlyElement& element) {
        if (element.properties.empty()) return;
        for (std::size_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties) skip_property(property);
    }

    template <class Vector>
    static bool all(const std::array<int, Vector::length()>& columns) {
        return std::all_of(columns.begin(), columns.end(), [](int column) { return column >= 0; });
    }

    void vertices(const PlyElement& element) {
        const std::array<int, 3> position{element.find("x"), element.find("y"), element.find("z")};
        const std::array<int, 3> normal{element.find("nx"), element.find("ny"), element.find("nz")};
        const std::array<int, 2> uv{find_any(element, {"s", "u", "texture_u"}),
                                    find_any(element, {"t", "v", "texture_v"})};
        const ColorColumns color(element);
        if (!all<glm::vec3>(position)) refuse(file_, "", "its vertices have no x, y and z");
        for (std::size_t i = 0; i < element.count; ++i) {
            row(element);
            const auto at = [&](int column) { return static_cast<float>(values_[static_cast<std::size_t>(column)]); };
            soup_.positions.emplace_back(at(position[0]), at(position[1]), at(position[2]));
            if (all<glm::vec3>(normal)) soup_.normals.emplace_back(at(normal[0]), at(normal[1]), at(normal[2]));
            if (all<glm::vec2>(uv)) soup_.uvs.emplace_back(at(uv[0]), at(uv[1]));
            if (color.any()) soup_.colors.push_back(color.of(values_));
        }
    }

    /// The next element's values, one per property; lists count as 0.
    void row(const PlyElement& element) {
        values_.assign(element.properties.size(), 0.0);
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            if (element.properties[p].is_list)
                skip_property(element.properties[p]);
            else
                values_[p] = numbers_.next(element.properties[p].type);
        }
    }

    void faces(const PlyElement& element) {
        const int list = find_any(element, {"vertex_indices", "vertex_index"});
        const int uvs = element.find("texcoord"), texture = element.find("texnumber");
        const ColorColumns color(element);
        if (list < 0 || !element.properties[static_cast<std::size_t>(list)].is_list)
            refuse(file_, "", "its faces have no list of vertices");
        for (std::size_t i = 0; i < element.count; ++i) {
            face_uvs_.clear();
            const std::size_t begin = soup_.corners.size();
            values_.assign(element.properties.size(), 0.0);
            for (std::size_t p = 0; p < element.properties.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (static_cast<int>(p) == list)
                    corners(property, element.name == "tristrips");
                else if (static_cast<int>(p) == uvs && property.is_list)
                    texcoords(property);
                else if (property.is_list)
                    skip_property(property);
                else
                    values_[p] = numbers_.next(property.type);
            }
            attach_uvs(begin);
            if (color.any()) soup_.face_colors.resize(soup_.faces(), color.of(values_));
            if (texture >= 0)
                soup_.face_part.resize(soup_.faces(), part_of(values_[static_cast<std::size_t>(texture)]));
        }
    }

    /// One part for each texture, and one more for faces without one.
    std::uint32_t part_of(double texture) const {
        const std::size_t count = header_.textures.size();
        const bool is_one = texture >= 0.0 && texture < static_cast<double>(count);
        return static_cast<std::uint32_t>(is_one ? static_cast<std::size_t>(texture) : count);
    }

    void corners(const PlyProperty& property, bool strips) {
        const std::size_t count = list_length(property);
        std::vector<std::uint32_t>& ring = ring_;
        ring.clear();
        for (std::size_t c = 0; c < count; ++c) {
            const double index = numbers_.next(property.type);
            const bool in_range = index >= 0.0 && index < 4294967295.0;
            ring.push_back(in_range ? static_cast<std::uint32_t>(index) : 0xffffffffu);
        }
        if (!strips) {
            if (count >= 3)
                face(ring);
            else
                soup_.add_unreadable(count);
            return;
        }
        // A strip ends at -1; every second triangle is reversed.
        std::size_t start = 0;
        for (std::size_t c = 0; c < count; ++c) {
            if (ring[c] == 0xffffffffu)
                start = c + 1;
            else if (c >= start + 2)
                face({ring[c - 2 + (c - start) % 2], ring[c - 1 - (c - start) % 2], ring[c]});
        }
    }

    void face(const std::vector<std::uint32_t>& ring) {
        soup_.corners.insert(soup_.corners.end(), ring.begin(), ring.end());
        soup_.first.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    }

    void texcoords(const PlyProperty& property) {
        const std::size_t count = list_length(property);
        for (std::size_t c = 0; c < count; ++c) face_uvs_.push_back(static_cast<float>(numbers_.next(property.type)));
    }

    /// MeshLab's "texcoord" list: u and v of each corner.
    void attach_uvs(std::size_t begin) {
        const std::size_t end = soup_.corners.size();
        if (face_uvs_.empty() || face_uvs_.size() != 2 * (end - begin)) {
            if (!soup_.corner_uvs.empty()) soup_.corner_uvs.resize(end, glm::vec2(no_uv, 0.0f));
            return;
        }
        soup_.corner_uvs.resize(begin, glm::vec2(no_uv, 0.0f));
        for (std::size_t c = 0; c < end - begin; ++c)
            soup_.corner_uvs.emplace_back(face_uvs_[2 * c], face_uvs_[2 * c + 1]);
    }

    const std::string& file_;
    const PlyHeader& header_;
    PlyNumbers numbers_;
    Soup soup_;
    Values values_;
    std::vector<std::uint32_t> ring_;
    std::vector<float> face_uvs_;
};

}  // namespace

RawOrgan read_ply(const std::filesystem::path& path, const std::string& file, const Bytes& bytes) {
    std::string storage;
    const std::string_view text = text_of(bytes, storage);
    const PlyHeader header = read_ply_header(file, text);
    const Soup soup = PlyReader(file, header, text.substr(header.size)).read();
    RawOrgan organ;
    TextureFiles textures(path.parent_path(), organ);
    std::vector<RawPart> parts;
    for (const PlyTexture& texture : header.textures) {
        parts.emplace_back().material = static_cast<int>(organ.materials.size());
        Material material;
        material.name = texture.name;
        material.base_color_image = textures.read(texture.name);
        organ.materials.push_back(std::move(material));
    }
    if (!soup.face_part.empty()) parts.emplace_back();
    add_parts(soup, std::move(parts), organ);
    return organ;
}

Bytes pack_ply(const Bytes& bytes, const std::string& file, Packing& packing) {
    std::string storage, out;
    const std::string_view text = text_of(bytes, storage);
    std::size_t done = 0;
    for (const PlyTexture& texture : read_ply_header(file, text).textures) {
        out += text.substr(done, texture.at - done);
        done = texture.at + texture.name.size();
        std::string packed;
        try {
            packed = packing.add_picture(file_beside(packing.folder(), texture.name));
        } catch (const Error&) {  // loading tells why
        }
        out += packed.empty() ? packing.unused(texture.name) : packed;  // faces count the textures
    }
    out += text.substr(done);
    return {out.begin(), out.end()};
}

}  // namespace lapfx::organ
