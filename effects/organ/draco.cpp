#include "organ/draco.h"

#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>

#include "organ/raw.h"

namespace lapfx::organ {

namespace {

/// Draco packs a triangle into half a bit at best. Without this limit, memory would be allocated for a file that claims
/// more.
constexpr std::size_t most_per_byte = 2000;

constexpr std::size_t method_byte = 8;  // of the header

/// Reads the header before anything is allocated for the data.
struct Claim {
    std::uint32_t triangles = 0, points = 0;
};

Claim claim_of(std::span<const std::uint8_t> bytes, const GltfDocument& document, const std::string& place) {
    constexpr std::size_t header = 11;
    constexpr std::uint16_t metadata = 0x8000;
    const auto damaged = [&] { refuse(document.file, place, "its compressed data is damaged"); };
    if (bytes.size() < header || std::memcmp(bytes.data(), "DRACO", 5) != 0) damaged();
    const int major = bytes[5], minor = bytes[6], geometry = bytes[7], method = bytes[method_byte];
    if (major != 2 || minor != 2)
        refuse(document.file, place,
               "is of Draco's format " + std::to_string(major) + '.' + std::to_string(minor) + ", only 2.2 is read");
    if (geometry != draco::TRIANGULAR_MESH) refuse(document.file, place, "contains points only");
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()) + header, bytes.size() - header, 0x0202);
    if (((bytes[9] | bytes[10] << 8) & metadata) != 0) {
        draco::GeometryMetadata skipped;
        if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &skipped)) damaged();
    }
    Claim claim;
    std::uint8_t traversal = 0;
    const bool edges = method == draco::MESH_EDGEBREAKER_ENCODING;
    const bool read =
        edges ? buffer.Decode(&traversal) && draco::DecodeVarint(&claim.points, &buffer) &&
                    draco::DecodeVarint(&claim.triangles, &buffer)
              : draco::DecodeVarint(&claim.triangles, &buffer) && draco::DecodeVarint(&claim.points, &buffer);
    if (!read) damaged();
    const std::size_t most = std::min(maximum_triangles, most_per_byte * bytes.size());
    if (claim.triangles > most || claim.points > 3 * most)
        refuse(document.file, place,
               "claims " + std::to_string(claim.triangles) + " triangles and " + std::to_string(claim.points) +
                   " points in " + std::to_string(bytes.size()) + " bytes");
    return claim;
}

int whole_number(const tinygltf::Value& object, const char* key, const std::string& file, const std::string& place) {
    const tinygltf::Value& value = object.IsObject() ? object.Get(key) : object;
    if (!object.IsObject() || !object.Has(key) || !value.IsInt() || value.GetNumberAsInt() < 0)
        refuse(file, place, std::string(key) + " is missing or not a whole number from 0");
    return value.GetNumberAsInt();
}

/// A decoder of Draco that stops before it unpacks more than `room` bytes of attributes: it unpacks all that the data
/// has, also those that no primitive names.
template <class Decoder>
class Bounded : public Decoder {
  public:
    explicit Bounded(std::size_t room) : room_(room) {}
    std::size_t wanted() const { return wanted_; }  ///< bytes

  protected:
    bool DecodeAllAttributes() override {
        const draco::PointCloud& cloud = *this->point_cloud();
        for (int i = 0; i < cloud.num_attributes(); ++i)
            wanted_ += std::size_t{cloud.num_points()} * static_cast<std::size_t>(cloud.attribute(i)->byte_stride());
        return wanted_ <= room_ && Decoder::DecodeAllAttributes();
    }

  private:
    std::size_t room_, wanted_ = 0;
};

struct Decoded {
    std::unique_ptr<draco::Mesh> mesh;  ///< null: damaged, or too large
    std::size_t bytes = 0;              ///< of all attributes, once they are known
};

template <class Decoder>
Decoded decode_with(std::span<const std::uint8_t> bytes, std::size_t room) {
    draco::DecoderBuffer buffer;
    buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    Bounded<Decoder> decoder(room);
    auto mesh = std::make_unique<draco::Mesh>();
    bool ok = false;
    try {
        ok = decoder.Decode(draco::DecoderOptions(), &buffer, mesh.get()).ok();
    } catch (const std::bad_alloc&) {  // what a damaged file may ask for
    } catch (const std::length_error&) {
    }
    return {ok ? std::move(mesh) : nullptr, decoder.wanted()};
}

/// `room`: bytes that the attributes may have.
Decoded decode(std::span<const std::uint8_t> bytes, std::size_t room) {
    return bytes[method_byte] == draco::MESH_EDGEBREAKER_ENCODING
               ? decode_with<draco::MeshEdgebreakerDecoder>(bytes, room)
               : decode_with<draco::MeshSequentialDecoder>(bytes, room);
}

/// The bytes that an accessor would have without compression; `T` is its componentType. Empty: a value does not fit
/// that type.
template <class T>
std::optional<Bytes> values_of(const draco::PointAttribute& attribute, std::uint32_t points) {
    const auto components = static_cast<std::size_t>(attribute.num_components());
    Bytes bytes(points * components * sizeof(T));
    std::vector<T> value(components);
    for (std::uint32_t p = 0; p < points; ++p) {
        const draco::AttributeValueIndex at = attribute.mapped_index(draco::PointIndex(p));
        if (at.value() >= attribute.size() || !attribute.ConvertValue<T>(at, value.data())) return std::nullopt;
        std::memcpy(bytes.data() + p * components * sizeof(T), value.data(), components * sizeof(T));
    }
    return bytes;
}

std::optional<Bytes> values_of(const draco::PointAttribute& attribute, std::uint32_t points, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return values_of<std::int8_t>(attribute, points);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return values_of<std::uint8_t>(attribute, points);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return values_of<std::int16_t>(attribute, points);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return values_of<std::uint16_t>(attribute, points);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return values_of<std::uint32_t>(attribute, points);
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return values_of<float>(attribute, points);
        default:
            return std::nullopt;
    }
}

const tinygltf::Accessor& accessor_at(const GltfDocument& document, int index, const std::string& place) {
    if (index < 0 || static_cast<std::size_t>(index) >= document.model.accessors.size())
        refuse(document.file, place, "accessor " + std::to_string(index) + " is not in the file");
    return document.model.accessors[static_cast<std::size_t>(index)];
}

void require_count(const GltfDocument& document, std::size_t declared, std::size_t decoded, const std::string& what,
                   const std::string& place) {
    if (declared != decoded)
        refuse(document.file, place,
               what + " has " + std::to_string(declared) + " elements, the compressed data " + std::to_string(decoded));
}

/// What is read of a primitive, and the number that the compressed data has for it.
struct Named {
    std::string name;
    int* accessor = nullptr;
    int unique_id = 0;
};

void require_room(const GltfDocument& document, std::size_t bytes, const std::string& place) {
    if (bytes > maximum_file_size)
        refuse(document.file, place,
               "unpacks to " + std::to_string(bytes) + " bytes with what was unpacked before, more than the limit of " +
                   std::to_string(maximum_file_size));
}

/// Refuses what would take more memory than the largest file: a few bytes may stand for as many equal points as the
/// format can count, and any number of primitives for the same bytes.
void require_room(const GltfDocument& document, std::size_t points, std::size_t triangles,
                  const std::vector<Named>& attributes, const std::string& place) {
    std::size_t bytes = document.unpacked + triangles * sizeof(draco::Mesh::Face);
    for (const Named& attribute : attributes) {
        const tinygltf::Accessor& accessor =
            accessor_at(document, *attribute.accessor, place + "/attributes/" + attribute.name);
        const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType)) *
                         tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
        bytes += points * static_cast<std::size_t>(std::max(size, 0));
    }
    require_room(document, bytes, place);
}

/// A new accessor like `accessor`, with its own bytes.
int add_accessor(GltfDocument& document, tinygltf::Accessor accessor, Bytes bytes) {
    accessor.bufferView = static_cast<int>(document.model.bufferViews.size());
    accessor.byteOffset = 0;
    document.unpacked += bytes.size();
    document.model.bufferViews.emplace_back();
    document.decoded[accessor.bufferView] = std::move(bytes);
    document.model.accessors.push_back(std::move(accessor));
    return static_cast<int>(document.model.accessors.size()) - 1;
}

int indices_of(GltfDocument& document, const draco::Mesh& mesh) {
    Bytes bytes(mesh.num_faces() * sizeof(draco::Mesh::Face));
    for (std::uint32_t f = 0; f < mesh.num_faces(); ++f) {
        const draco::Mesh::Face& face = mesh.face(draco::FaceIndex(f));
        for (std::size_t c = 0; c < 3; ++c) {
            const std::uint32_t corner = face[c].value();
            std::memcpy(bytes.data() + (3 * f + c) * sizeof corner, &corner, sizeof corner);
        }
    }
    tinygltf::Accessor accessor;
    accessor.componentType = TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    accessor.type = TINYGLTF_TYPE_SCALAR;
    accessor.count = 3 * std::size_t{mesh.num_faces()};
    return add_accessor(document, std::move(accessor), std::move(bytes));
}

int attribute_of(GltfDocument& document, const draco::Mesh& mesh, int accessor_index, int unique_id,
                 const std::string& name, const std::string& place) {
    const tinygltf::Accessor accessor = accessor_at(document, accessor_index, place);
    const draco::PointAttribute* const attribute = mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(unique_id));
    const std::string at = place + "/attributes/" + name;
    if (attribute == nullptr)
        refuse(document.file, at, "the compressed data has no attribute " + std::to_string(unique_id));
    require_count(document, accessor.count, mesh.num_points(), name, place);
    if (tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)) != attribute->num_components())
        refuse(document.file, at,
               "the compressed data has " + std::to_string(attribute->num_components()) +
                   " components, which the accessor has not");
    std::optional<Bytes> bytes = values_of(*attribute, mesh.num_points(), accessor.componentType);
    if (!bytes) refuse(document.file, at, "the compressed values are not of the accessor's componentType");
    return add_accessor(document, accessor, std::move(*bytes));
}

bool has_bytes(const GltfDocument& document, int accessor, const std::string& place) {
    return accessor_at(document, accessor, place).bufferView >= 0;
}

}  // namespace

void decode_draco(GltfDocument& document, tinygltf::Primitive& primitive, const tinygltf::Value& object,
                  const std::string& place) {
    const std::string at = place + "/extensions/KHR_draco_mesh_compression";
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) refuse(document.file, place + "/attributes", "has no POSITION");
    if (has_bytes(document, position->second, place + "/attributes/POSITION")) return;  // the same, not packed
    const int view = whole_number(object, "bufferView", document.file, at);
    if (!object.Has("attributes") || !object.Get("attributes").IsObject())
        refuse(document.file, at, "attributes is missing or not an object");

    const std::span<const std::uint8_t> bytes = document.view(view, at);
    const Claim claim = claim_of(bytes, document, at);
    if (primitive.indices >= 0)
        require_count(document, accessor_at(document, primitive.indices, place + "/indices").count,
                      3 * std::size_t{claim.triangles}, "indices", at);
    const tinygltf::Value& ids = object.Get("attributes");
    std::vector<Named> attributes;
    for (auto& [name, accessor] : primitive.attributes)
        if (ids.Has(name)) attributes.push_back({name, &accessor, whole_number(ids, name.c_str(), document.file, at)});
    if (!ids.Has("POSITION")) refuse(document.file, at, "attributes has no POSITION");
    require_room(document, claim.points, claim.triangles, attributes, at);

    const Decoded decoded = decode(bytes, maximum_file_size - document.unpacked);
    require_room(document, document.unpacked + decoded.bytes, at);
    const draco::Mesh* const mesh = decoded.mesh.get();
    if (mesh == nullptr) refuse(document.file, at, "its compressed data is damaged");
    require_room(document, mesh->num_points(), mesh->num_faces(), attributes, at);  // seams add points
    for (const Named& attribute : attributes)
        *attribute.accessor =
            attribute_of(document, *mesh, *attribute.accessor, attribute.unique_id, attribute.name, at);
    primitive.indices = indices_of(document, *mesh);
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
}

}  // namespace lapfx::organ
