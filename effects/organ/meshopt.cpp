#include "organ/meshopt.h"

#include <meshoptimizer.h>

#include "organ/raw.h"

namespace lapfx::organ {

namespace {

/// The members of the extension, as the specification names them.
struct Compressed {
    int buffer = -1;
    std::size_t offset = 0, length = 0, stride = 0, count = 0;
    std::string mode, filter = "NONE";
};

/// A whole number of the extension; -1 when it is missing or none.
std::int64_t number(const tinygltf::Value& object, const char* key, std::int64_t fallback) {
    if (!object.Has(key)) return fallback;
    const tinygltf::Value& value = object.Get(key);
    return value.IsInt() && value.GetNumberAsInt() >= 0 ? value.GetNumberAsInt() : -1;
}

Compressed parse(const tinygltf::Value& object, const std::string& file, const std::string& place) {
    if (!object.IsObject()) refuse(file, place, "is not an object");
    const std::int64_t values[] = {number(object, "buffer", -1), number(object, "byteOffset", 0),
                                   number(object, "byteLength", -1), number(object, "byteStride", -1),
                                   number(object, "count", -1)};
    constexpr const char* keys[] = {"buffer", "byteOffset", "byteLength", "byteStride", "count"};
    for (std::size_t i = 0; i < std::size(values); ++i)
        if (values[i] < 0) refuse(file, place, std::string(keys[i]) + " is missing or not a whole number from 0");
    Compressed out{static_cast<int>(values[0]),
                   static_cast<std::size_t>(values[1]),
                   static_cast<std::size_t>(values[2]),
                   static_cast<std::size_t>(values[3]),
                   static_cast<std::size_t>(values[4]),
                   "",
                   "NONE"};
    if (object.Has("mode") && object.Get("mode").IsString()) out.mode = object.Get("mode").Get<std::string>();
    if (object.Has("filter") && object.Get("filter").IsString()) out.filter = object.Get("filter").Get<std::string>();
    return out;
}

/// meshoptimizer asserts its preconditions; here they depend on a file, so they are checked.
void check(const Compressed& c, const std::string& file, const std::string& place) {
    const bool attributes = c.mode == "ATTRIBUTES";
    if (!attributes && c.mode != "TRIANGLES" && c.mode != "INDICES")
        refuse(file, place, "mode is \"" + c.mode + "\", allowed are ATTRIBUTES, TRIANGLES, INDICES");
    const bool stride_fits =
        attributes ? c.stride > 0 && c.stride <= 256 && c.stride % 4 == 0 : c.stride == 2 || c.stride == 4;
    if (!stride_fits) refuse(file, place, "byteStride " + std::to_string(c.stride) + " does not fit mode " + c.mode);
    if (c.mode == "TRIANGLES" && c.count % 3 != 0)
        refuse(file, place, "count " + std::to_string(c.count) + " is not a multiple of 3");
    if (c.count > 3 * maximum_triangles) refuse(file, place, "count " + std::to_string(c.count) + " is too large");
    const bool filter_fits = c.filter == "NONE" || (c.filter == "OCTAHEDRAL" && (c.stride == 4 || c.stride == 8)) ||
                             (c.filter == "QUATERNION" && c.stride == 8) || c.filter == "EXPONENTIAL";
    if (!filter_fits || (!attributes && c.filter != "NONE"))
        refuse(file, place, "filter \"" + c.filter + "\" does not fit byteStride " + std::to_string(c.stride));
}

}  // namespace

std::span<const std::uint8_t> bytes_of(const GltfDocument& document, int buffer, std::size_t offset, std::size_t length,
                                       const std::string& place) {
    if (buffer < 0 || static_cast<std::size_t>(buffer) >= document.model.buffers.size())
        refuse(document.file, place, "buffer " + std::to_string(buffer) + " is not in the file");
    const std::vector<unsigned char>& data = document.model.buffers[static_cast<std::size_t>(buffer)].data;
    if (offset > data.size() || length > data.size() - offset)
        refuse(document.file, place,
               "bytes " + std::to_string(offset) + " to " + std::to_string(offset + length) + " are not in buffer " +
                   std::to_string(buffer) + " of " + std::to_string(data.size()) + " bytes");
    return std::span(data).subspan(offset, length);
}

Bytes decode_meshopt(const GltfDocument& document, const tinygltf::Value& extension, const std::string& place) {
    const std::string at = place + "/extensions/EXT_meshopt_compression";
    const Compressed c = parse(extension, document.file, at);
    check(c, document.file, at);
    const std::span<const std::uint8_t> source = bytes_of(document, c.buffer, c.offset, c.length, at);

    Bytes out(c.count * c.stride);
    int fault = 0;
    if (c.mode == "ATTRIBUTES")
        fault = meshopt_decodeVertexBuffer(out.data(), c.count, c.stride, source.data(), source.size());
    else if (c.mode == "TRIANGLES")
        fault = meshopt_decodeIndexBuffer(out.data(), c.count, c.stride, source.data(), source.size());
    else
        fault = meshopt_decodeIndexSequence(out.data(), c.count, c.stride, source.data(), source.size());
    if (fault != 0) refuse(document.file, at, "its compressed data is damaged");

    if (c.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(out.data(), c.count, c.stride);
    if (c.filter == "QUATERNION") meshopt_decodeFilterQuat(out.data(), c.count, c.stride);
    if (c.filter == "EXPONENTIAL") meshopt_decodeFilterExp(out.data(), c.count, c.stride);
    return out;
}

}  // namespace lapfx::organ
