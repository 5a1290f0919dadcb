#include "organ/gltf_accessor.h"

#include <cstring>

namespace lapfx::organ {

namespace {

/// `count` elements of `components` values, `stride` bytes apart.
struct Elements {
    std::span<const std::uint8_t> bytes;
    std::size_t count = 0;
    std::size_t components = 1;
    std::size_t stride = 0;
    int type = 0;
    bool normalized = false;
};

std::size_t bytes_per_value(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

std::size_t components_of(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        case TINYGLTF_TYPE_MAT4:
            return 16;
        default:
            return 0;
    }
}

template <class T>
T load(const std::uint8_t* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
}

float value_at(const std::uint8_t* at, int type, bool normalized) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: {
            const float value = load<std::int8_t>(at);
            return normalized ? std::max(value / 127.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return normalized ? *at / 255.0f : *at;
        case TINYGLTF_COMPONENT_TYPE_SHORT: {
            const float value = load<std::int16_t>(at);
            return normalized ? std::max(value / 32767.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
            const float value = load<std::uint16_t>(at);
            return normalized ? value / 65535.0f : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return static_cast<float>(load<std::uint32_t>(at));
        default:
            return load<float>(at);
    }
}

std::uint32_t index_at(const std::uint8_t* at, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return *at;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return load<std::uint16_t>(at);
        default:
            return load<std::uint32_t>(at);
    }
}

bool is_index_type(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// Elements in a view; throws if the last byte of the last element is outside it.
Elements elements_in(GltfDocument& document, int view, std::size_t offset, std::size_t count, int type,
                     std::size_t components, bool may_stride, const std::string& place) {
    Elements out{document.view(view, place), count, components, bytes_per_value(type) * components, type, false};
    const std::size_t element = out.stride;
    const std::size_t stride = document.model.bufferViews[static_cast<std::size_t>(view)].byteStride;
    if (may_stride && stride != 0) {
        if (stride < element)
            refuse(document.file, place,
                   "byteStride " + std::to_string(stride) + " is less than an element's " + std::to_string(element) +
                       " bytes");
        out.stride = stride;
    }
    const std::size_t need = count == 0 ? 0 : (count - 1) * out.stride + element;
    if (offset > out.bytes.size() || need > out.bytes.size() - offset)
        refuse(document.file, place,
               "needs " + std::to_string(need) + " bytes at " + std::to_string(offset) + ", buffer view " +
                   std::to_string(view) + " has " + std::to_string(out.bytes.size()));
    out.bytes = out.bytes.subspan(offset, need);
    return out;
}

const tinygltf::Accessor& checked(const GltfDocument& document, int index, const std::string& place) {
    if (index < 0 || static_cast<std::size_t>(index) >= document.model.accessors.size())
        refuse(document.file, place, "accessor " + std::to_string(index) + " is not in the file");
    const tinygltf::Accessor& accessor = document.model.accessors[static_cast<std::size_t>(index)];
    const std::string at = "/accessors/" + std::to_string(index);
    const std::size_t most = accessor.bufferView < 0 ? most_elements_without_view : most_elements;
    if (accessor.count > most)
        refuse(document.file, at,
               "has " + std::to_string(accessor.count) + " elements" +
                   (accessor.bufferView < 0 ? " without a buffer view" : "") + ", at most " + std::to_string(most) +
                   " are allowed");
    if (bytes_per_value(accessor.componentType) == 0)
        refuse(document.file, at, "has componentType " + std::to_string(accessor.componentType));
    if (components_of(accessor.type) == 0) refuse(document.file, at, "is a matrix where a vector is needed");
    return accessor;
}

/// "3", "3 or 4", "3 to 5".
std::string range_words(std::size_t low, std::size_t high) {
    const std::string first = std::to_string(low), last = std::to_string(high);
    return low == high ? first : first + (high == low + 1 ? " or " : " to ") + last;
}

void require(const Expected& expected, std::size_t elements, std::size_t components, const std::string& file,
             const std::string& place) {
    const auto low = static_cast<std::size_t>(expected.components_low),
               high = static_cast<std::size_t>(expected.components_high);
    if (components < low || components > high)
        refuse(file, place,
               "has elements of " + counted(components, "component", "components") + ", expected " +
                   range_words(low, high));
    if (elements < expected.least || elements > expected.most)
        refuse(file, place,
               "has " + counted(elements, "element", "elements") + ", expected " +
                   range_words(expected.least, expected.most));
}

/// Calls `put` with the number of each element that replaces one of the view, and its bytes.
template <class Put>
void substitute(GltfDocument& document, const tinygltf::Accessor& accessor, const std::string& at, const Put& put) {
    const auto& sparse = accessor.sparse;
    const std::string place = at + "/sparse";
    if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count || sparse.indices.byteOffset < 0 ||
        sparse.values.byteOffset < 0 || !is_index_type(sparse.indices.componentType))
        refuse(document.file, place, "has a count, offset or componentType that cannot be");
    const auto count = static_cast<std::size_t>(sparse.count), components = components_of(accessor.type);
    const Elements indices =
        elements_in(document, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
                    sparse.indices.componentType, 1, false, place + "/indices");
    const Elements values =
        elements_in(document, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
                    accessor.componentType, components, false, place + "/values");
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t target = index_at(indices.bytes.data() + i * indices.stride, indices.type);
        if (target >= accessor.count)
            refuse(document.file, place,
                   "index " + std::to_string(target) + " is not below the count " + std::to_string(accessor.count));
        put(target, values.bytes.data() + i * values.stride);
    }
}

}  // namespace

FloatArray read_floats(GltfDocument& document, int index, const Expected& expected, const std::string& place) {
    const tinygltf::Accessor& accessor = checked(document, index, place);
    const std::string at = "/accessors/" + std::to_string(index);
    const std::size_t components = components_of(accessor.type), size = bytes_per_value(accessor.componentType);
    require(expected, accessor.count, components, document.file, place);
    FloatArray array{static_cast<int>(components), {}};
    array.values.assign(accessor.count * components, 0.0f);  // an accessor without a view has zeros
    const auto put = [&](std::size_t element, const std::uint8_t* bytes) {
        for (std::size_t c = 0; c < components; ++c)
            array.values[element * components + c] =
                value_at(bytes + c * size, accessor.componentType, accessor.normalized);
    };
    if (accessor.bufferView >= 0) {
        const Elements elements = elements_in(document, accessor.bufferView, accessor.byteOffset, accessor.count,
                                              accessor.componentType, components, true, at);
        for (std::size_t i = 0; i < accessor.count; ++i) put(i, elements.bytes.data() + i * elements.stride);
    }
    if (accessor.sparse.isSparse) substitute(document, accessor, at, put);
    return array;
}

std::vector<std::uint32_t> read_indices(GltfDocument& document, int index, const std::string& place) {
    const tinygltf::Accessor& accessor = checked(document, index, place);
    const std::string at = "/accessors/" + std::to_string(index);
    if (!is_index_type(accessor.componentType) || accessor.type != TINYGLTF_TYPE_SCALAR)
        refuse(document.file, at, "cannot be indices: they are unsigned scalars of 8, 16 or 32 bits");
    if (accessor.bufferView < 0 && !accessor.sparse.isSparse)
        refuse(document.file, at, "indices need a buffer view or sparse values");
    std::vector<std::uint32_t> indices(accessor.count);  // an accessor without a view has zeros
    const auto put = [&](std::size_t element, const std::uint8_t* bytes) {
        indices[element] = index_at(bytes, accessor.componentType);
    };
    if (accessor.bufferView >= 0) {
        const Elements elements = elements_in(document, accessor.bufferView, accessor.byteOffset, accessor.count,
                                              accessor.componentType, 1, true, at);
        for (std::size_t i = 0; i < accessor.count; ++i) put(i, elements.bytes.data() + i * elements.stride);
    }
    if (accessor.sparse.isSparse) substitute(document, accessor, at, put);
    return indices;
}

}  // namespace lapfx::organ
