#include "organ/gltf_document.h"

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "lapfx/authoring/file.h"
#include "organ/gltf_check.h"
#include "organ/gltf_codecs.h"
#include "organ/meshopt.h"
#include "organ/pack.h"
#include "organ/raw.h"

namespace lapfx::organ {

namespace {

using nlohmann::json;

constexpr int maximum_depth = 64;

/// Read in full, or safe to leave out: the surface is the same without them. Besides these the codecs (gltf_codecs.h).
constexpr const char* known_extensions[] = {"EXT_texture_webp",
                                            "KHR_mesh_quantization",
                                            "KHR_node_visibility",
                                            "KHR_texture_transform",
                                            "KHR_materials_pbrSpecularGlossiness",
                                            "KHR_materials_unlit",
                                            "KHR_lights_punctual",
                                            "KHR_materials_ior",
                                            "KHR_materials_specular",
                                            "KHR_materials_sheen",
                                            "KHR_materials_clearcoat",
                                            "KHR_materials_transmission",
                                            "KHR_materials_volume",
                                            "KHR_materials_emissive_strength",
                                            "KHR_materials_variants",
                                            "KHR_xmp_json_ld"};

struct Chunks {
    std::string_view json;
    std::span<const std::uint8_t> binary;
};

std::uint32_t word(const Bytes& bytes, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

/// A .glb: a header, a JSON chunk, and perhaps a binary chunk.
Chunks split_glb(const Bytes& bytes, const std::string& file) {
    constexpr std::uint32_t json_type = 0x4e4f534a, binary_type = 0x004e4942;
    if (bytes.size() < 20) refuse(file, "", "truncated: the file ends within the header of a binary glTF");
    if (word(bytes, 4) != 2)
        refuse(file, "", "binary glTF version " + std::to_string(word(bytes, 4)) + " is not read, expected 2");
    const std::size_t length = word(bytes, 8), json_length = word(bytes, 12);
    if (length > bytes.size())
        refuse(file, "",
               "truncated: its header says " + std::to_string(length) + " bytes, the file has " +
                   std::to_string(bytes.size()));
    if (word(bytes, 16) != json_type) refuse(file, "", "its first chunk is not JSON");
    if (json_length > bytes.size() - 20) refuse(file, "", "truncated: the file ends within its JSON chunk");
    Chunks chunks{{reinterpret_cast<const char*>(bytes.data()) + 20, json_length}, {}};
    std::size_t at = 20 + (json_length + 3) / 4 * 4;
    while (at + 8 <= bytes.size()) {
        const std::size_t size = word(bytes, at), room = bytes.size() - at - 8;
        if (word(bytes, at + 4) == binary_type) {
            if (size > room) refuse(file, "", "truncated: the file ends within its binary chunk");
            chunks.binary = std::span(bytes).subspan(at + 8, size);
            break;
        }
        if (size > room) break;  // further chunks are ignored
        at += 8 + (size + 3) / 4 * 4;
    }
    return chunks;
}

template <typename Json>
void make_whole(Json& value) {
    const double number = value.template get<double>();
    if (number != std::floor(number) || std::abs(number) > 9007199254740992.0) return;
    if (number >= 0.0)
        value = static_cast<std::uint64_t>(number);
    else
        value = static_cast<std::int64_t>(number);
}

/// "[json.exception.parse_error.101] parse error at line 1 ..." without the library's own number.
std::string without_code(const std::string& what) {
    const std::size_t end = what.starts_with('[') ? what.find("] ") : std::string::npos;
    return end == std::string::npos ? what : what.substr(end + 2);
}

template <typename Json>
Json parse(std::string_view text, const std::string& file, bool with_extras) {
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    // Extras may contain anything; without them, and with bounded depth, the rest is safe for recursive readers. A
    // whole number may be written as 840.0: the specification says so.
    const auto keep = [&](int depth, typename Json::parse_event_t event, Json& value) {
        if (depth > maximum_depth) refuse(file, "", "its JSON is nested deeper than 64 levels");
        if (!with_extras && event == Json::parse_event_t::value && value.is_number_float()) make_whole(value);
        return with_extras || event != Json::parse_event_t::key || value != "extras";
    };
    try {
        Json document = Json::parse(text, keep);
        if (!document.is_object()) refuse(file, "", "its JSON is not an object");
        return document;
    } catch (const json::exception& fault) {
        refuse(file, "", "its JSON cannot be read: " + without_code(fault.what()).substr(0, 160));
    }
}

void check_head(const json& document, const std::string& file) {
    const json* asset = document.contains("asset") ? &document["asset"] : nullptr;
    if (!asset || !asset->is_object() || !asset->contains("version") || !(*asset)["version"].is_string())
        refuse(file, "/asset/version", "is missing: not a glTF 2.0 file");
    const std::string version = (*asset)["version"];
    if (!version.starts_with("2."))
        refuse(file, "/asset/version", "is \"" + version.substr(0, 40) + "\", only 2.0 is read");
    if (!document.contains("extensionsRequired")) return;
    const json& required = document["extensionsRequired"];
    if (!required.is_array()) refuse(file, "/extensionsRequired", "is not an array");
    for (const json& name : required) {
        if (!name.is_string()) refuse(file, "/extensionsRequired", "contains something that is not a string");
        const std::string extension = name;
        if (find_codec(extension) == nullptr && std::find(std::begin(known_extensions), std::end(known_extensions),
                                                          extension) == std::end(known_extensions))
            refuse(file, "/extensionsRequired", "needs the extension " + extension + ", which is not read");
    }
}

Bytes data_uri(std::string_view uri, const std::string& file, const std::string& place) {
    const std::size_t comma = uri.find(',');
    if (comma == std::string_view::npos) refuse(file, place, "is a data URI without a comma before its data");
    const std::string data = percent_decoded(uri.substr(comma + 1));
    if (!uri.substr(0, comma).ends_with(";base64")) return {data.begin(), data.end()};
    Bytes bytes;
    if (!decode_base64(data, bytes)) refuse(file, place, "is a data URI that is not valid base64");
    return bytes;
}

bool is_data_uri(std::string_view uri) {
    return uri.starts_with("data:");
}

template <typename Json>
std::string text_member(const Json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->template get<std::string>() : std::string();
}

/// A buffer that is only the target of EXT_meshopt_compression has no bytes.
bool is_fallback(const json& buffer) {
    const json none = json::object();
    const json& extensions = buffer.contains("extensions") ? buffer["extensions"] : none;
    return extensions.is_object() && extensions.contains("EXT_meshopt_compression");
}

void read_buffers(GltfDocument& document, const json& buffers, std::span<const std::uint8_t> binary) {
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const json& source = buffers[i];
        const std::string place = "/buffers/" + std::to_string(i);
        tinygltf::Buffer buffer;
        if (!source.is_object() || !source.contains("byteLength") || !source["byteLength"].is_number_unsigned())
            refuse(document.file, place, "has no byteLength");
        const std::size_t length = source["byteLength"];
        const std::string uri = text_member(source, "uri");
        if (uri.empty() && i == 0 && !binary.empty())
            buffer.data.assign(binary.begin(), binary.end());
        else if (is_data_uri(uri))
            buffer.data = data_uri(uri, document.file, place + "/uri");
        else if (!uri.empty()) {
            const std::filesystem::path path =
                named_path(document.folder, percent_decoded(uri), Reach::inside, document.file, place + "/uri");
            buffer.data = read_file(path, document.file, place + ": " + uri);
            document.files.push_back(path);
        } else if (!is_fallback(source))
            refuse(document.file, place, "has no uri, and the file has no binary chunk for it");
        if (!buffer.data.empty() && buffer.data.size() < length)
            refuse(document.file, place,
                   "truncated: has " + std::to_string(buffer.data.size()) + " of " + std::to_string(length) + " bytes");
        if (buffer.data.size() > length) buffer.data.resize(length);
        document.model.buffers.push_back(std::move(buffer));
    }
}

void read_images(GltfDocument& document, const json& images) {
    for (std::size_t i = 0; i < images.size(); ++i) {
        const json& source = images[i];
        const std::string place = "/images/" + std::to_string(i);
        if (!source.is_object()) refuse(document.file, place, "is not an object");
        tinygltf::Image image;
        image.name = text_member(source, "name");
        image.uri = text_member(source, "uri");
        image.bufferView = -1;
        if (source.contains("bufferView") && source["bufferView"].is_number_integer())
            image.bufferView = source["bufferView"];
        document.model.images.push_back(std::move(image));
    }
}

/// -1 for null, and for a number that no index can be.
int index_of(const json& value) {
    if (!value.is_number_integer()) return -1;
    const auto number = value.get<std::int64_t>();
    return number >= 0 && number < 0x7fffffff ? static_cast<int>(number) : -1;
}

void read_skins(GltfDocument& document, const json& skins) {
    for (const json& source : skins) {
        GltfSkin& skin = document.skins.emplace_back();
        if (source.contains("joints"))
            for (const json& joint : source["joints"]) skin.joints.push_back(index_of(joint));
        if (source.contains("inverseBindMatrices")) skin.inverse_bind = index_of(source["inverseBindMatrices"]);
    }
}

json taken_out(json& document, const char* key, const std::string& file) {
    if (!document.contains(key)) return json::array();
    json value = std::move(document[key]);
    document.erase(key);
    if (!value.is_array()) refuse(file, std::string("/") + key, "is not an array");
    return value;
}

/// The first line of tinygltf's message.
std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

struct IndicesWithoutView {
    std::size_t mesh, primitive;
    int accessor;
};

/// tinygltf wants a buffer view for all indices, so it does not get those that a codec unpacks with their primitive,
/// nor those that are zeros with sparse substitutions.
std::vector<IndicesWithoutView> take_indices_without_view(json& document) {
    std::vector<IndicesWithoutView> taken;
    if (!document.contains("meshes")) return taken;
    const json none = json::array();
    const json& accessors = document.contains("accessors") ? document["accessors"] : none;
    std::size_t mesh_number = 0;
    for (json& mesh : document["meshes"]) {
        const std::size_t m = mesh_number++;
        if (!mesh.contains("primitives")) continue;
        for (std::size_t p = 0; p < mesh["primitives"].size(); ++p) {
            json& primitive = mesh["primitives"][p];
            if (!primitive.contains("indices")) continue;
            const auto accessor = primitive["indices"].get<std::int64_t>();
            if (accessor < 0 || accessor >= static_cast<std::int64_t>(accessors.size()) ||
                accessors[static_cast<std::size_t>(accessor)].contains("bufferView"))
                continue;
            taken.push_back({m, p, static_cast<int>(accessor)});
            primitive.erase("indices");
        }
    }
    return taken;
}

void run_tinygltf(GltfDocument& document, const json& structure) {
    const std::string text = structure.dump();
    if (text.size() > 0x7fffffff) refuse(document.file, "", "its JSON is larger than 2 GiB");
    tinygltf::TinyGLTF loader;
    std::string error, warning;
    bool done = false;
    try {
        done = loader.LoadASCIIFromString(&document.model, &error, &warning, text.data(),
                                          static_cast<unsigned>(text.size()), "");
    } catch (const std::exception& fault) {
        error = without_code(fault.what());
    }
    // When it cannot read a primitive, it drops that with only a message and continues.
    if (!done || !error.empty()) refuse(document.file, "", first_line(error.empty() ? "is malformed" : error));
}

}  // namespace

GltfDocument read_gltf_document(const std::filesystem::path& path, const std::string& file, const Bytes& bytes) {
    GltfDocument document;
    document.file = file;
    document.folder = path.parent_path();
    Chunks chunks{{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, {}};
    if (chunks.json.starts_with("glTF")) chunks = split_glb(bytes, file);

    json structure = parse<json>(chunks.json, file, false);
    check_head(structure, file);
    check_structure(structure, file);
    const json buffers = taken_out(structure, "buffers", file);
    const json images = taken_out(structure, "images", file);
    read_skins(document, taken_out(structure, "skins", file));
    for (const char* unused : {"animations", "cameras", "extensions"}) structure.erase(unused);
    mend_materials(structure, document.warnings);
    const std::vector<IndicesWithoutView> taken = take_indices_without_view(structure);
    run_tinygltf(document, structure);
    for (const IndicesWithoutView& indices : taken)
        document.model.meshes[indices.mesh].primitives[indices.primitive].indices = indices.accessor;
    read_buffers(document, buffers, chunks.binary);
    read_images(document, images);
    return document;
}

std::span<const std::uint8_t> GltfDocument::view(int index, const std::string& place) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.bufferViews.size())
        refuse(file, place, "buffer view " + std::to_string(index) + " is not in the file");
    if (const auto done = decoded.find(index); done != decoded.end()) return done->second;
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(index)];
    const std::string view_place = "/bufferViews/" + std::to_string(index);
    for (const auto& [name, object] : view.extensions)
        if (const GltfCodec* const codec = find_codec(name); codec != nullptr && codec->decode_view != nullptr)
            return decoded[index] = codec->decode_view(*this, object, view_place);
    return bytes_of(*this, view.buffer, view.byteOffset, view.byteLength, view_place);
}

std::filesystem::path GltfDocument::image_file(int index) const {
    const tinygltf::Image& image = model.images[static_cast<std::size_t>(index)];
    if (image.bufferView >= 0 || is_data_uri(image.uri)) return {};
    return named_path(folder, percent_decoded(image.uri), Reach::inside, file,
                      "/images/" + std::to_string(index) + "/uri");
}

std::span<const std::uint8_t> GltfDocument::image_bytes(int index, Bytes& storage, std::string& fault) {
    const tinygltf::Image& image = model.images[static_cast<std::size_t>(index)];
    const std::string place = "/images/" + std::to_string(index);
    if (image.bufferView >= 0) return view(image.bufferView, place + "/bufferView");
    if (is_data_uri(image.uri)) return storage = data_uri(image.uri, file, place + "/uri");
    const std::filesystem::path path = image_file(index);
    try {
        return storage = read_file(path, image.uri);
    } catch (const Error& error) {
        fault = error.faults().front().reason;
        return {};
    }
}

namespace {

using OrderedJson = nlohmann::ordered_json;

/// The members of a list that name a separate file.
std::vector<OrderedJson*> with_files(OrderedJson& document, const char* list) {
    std::vector<OrderedJson*> found;
    if (!document.contains(list) || !document[list].is_array()) return found;
    for (OrderedJson& member : document[list])
        if (member.is_object() && !text_member(member, "uri").empty() && !is_data_uri(text_member(member, "uri")))
            found.push_back(&member);
    return found;
}

std::string pack_buffer(const OrderedJson& buffer, const std::string& file, Packing& packing) {
    const std::string uri = text_member(buffer, "uri"), place = "/buffers";
    const std::filesystem::path path = named_path(packing.folder(), percent_decoded(uri), Reach::inside, file, place);
    OrderedJson length = buffer.value("byteLength", OrderedJson());
    if (length.is_number_float()) make_whole(length);
    if (!length.is_number_unsigned()) refuse(file, place, uri + " has no byteLength");
    return packing.add_buffer(path, length.get<std::size_t>(), file, place, uri);
}

std::string pack_image(const OrderedJson& image, Packing& packing) {
    const std::string name = percent_decoded(text_member(image, "uri"));
    try {
        if (const std::string packed = packing.add_picture(named_path(packing.folder(), name)); !packed.empty())
            return packed;
    } catch (const Error&) {  // an image outside the folder that no material uses
    }
    return packing.unused(name);
}

void put_word(Bytes& out, std::size_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(value >> shift & 0xffU));
}

/// A binary glTF with another JSON; the chunks after it stay.
Bytes with_json(const Bytes& glb, std::string text) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t end = std::min<std::size_t>(word(glb, 8), glb.size());
    const std::size_t rest = std::min<std::size_t>(20 + (std::size_t{word(glb, 12)} + 3) / 4 * 4, end);
    Bytes out(glb.begin(), glb.begin() + 8);
    put_word(out, 20 + text.size() + end - rest);
    put_word(out, text.size());
    out.insert(out.end(), glb.begin() + 16, glb.begin() + 20);
    out.insert(out.end(), text.begin(), text.end());
    out.insert(out.end(), glb.begin() + static_cast<std::ptrdiff_t>(rest),
               glb.begin() + static_cast<std::ptrdiff_t>(end));
    return out;
}

}  // namespace

Bytes pack_gltf(const Bytes& bytes, const std::string& file, Packing& packing) {
    Chunks chunks{{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, {}};
    const bool binary = chunks.json.starts_with("glTF");
    if (binary) chunks = split_glb(bytes, file);
    OrderedJson document = parse<OrderedJson>(chunks.json, file, true);
    const std::vector<OrderedJson*> buffers = with_files(document, "buffers"), images = with_files(document, "images");
    if (buffers.empty() && images.empty()) return bytes;
    for (OrderedJson* buffer : buffers) (*buffer)["uri"] = pack_buffer(*buffer, file, packing);
    for (OrderedJson* image : images) (*image)["uri"] = pack_image(*image, packing);
    std::string text = document.dump();
    return binary ? with_json(bytes, std::move(text)) : Bytes(text.begin(), text.end());
}

}  // namespace lapfx::organ
