#include "organ/formats.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "lapfx/authoring/letters.h"
#include "media/formats.h"
#include "organ/gltf.h"
#include "organ/obj.h"
#include "organ/off.h"
#include "organ/pack.h"
#include "organ/ply.h"
#include "organ/stl.h"

namespace lapfx {

namespace organ {

namespace {

namespace fs = std::filesystem;

/// For a format whose files name no others.
template <RawOrgan (*Read)(const std::string&, const Bytes&)>
RawOrgan alone(const fs::path&, const std::string& file, const Bytes& bytes) {
    return Read(file, bytes);
}

Bytes pack_text(const Bytes& bytes, const std::string&, Packing& packing) {
    return pack_obj(bytes, packing);
}

constexpr std::string_view glb[] = {".glb"}, gltf[] = {".gltf"}, obj[] = {".obj"}, ply[] = {".ply"},
                           stl[] = {".stl", ".stla", ".stlb"}, off[] = {".off"};
constexpr Signature glb_begins[] = {{"glTF"}}, ply_begins[] = {{"ply\n"}, {"ply\r"}};
constexpr double metres = 1000, millimetres = 1;

constexpr MeshFormat rows[] = {
    {.file = {.name = "binary glTF",
              .content = Content::mesh,
              .extensions = glb,
              .signatures = glb_begins,
              .holds = "materials, textures, vertex colours; packed by meshoptimizer, by Draco or not"},
     .unit = metres,
     .signed_always = true,
     .read = read_gltf,
     .pack = pack_gltf},
    {.file = {.name = "glTF",
              .content = Content::mesh,
              .extensions = gltf,
              .holds = "the same, with its buffers and textures in files of their own"},
     .unit = metres,
     .read = read_gltf,
     .pack = pack_gltf},
    {.file = {.name = "OBJ",
              .content = Content::mesh,
              .extensions = obj,
              .holds = "materials, textures and vertex colours"},
     .unit = millimetres,
     .read = read_obj,
     .pack = pack_text},
    {.file = {.name = "PLY",
              .content = Content::mesh,
              .extensions = ply,
              .signatures = ply_begins,
              .holds = "colours of vertices or faces, texture coordinates, textures that its comments name"},
     .unit = millimetres,
     .read = read_ply,
     .pack = pack_ply},
    {.file = {.name = "STL", .content = Content::mesh, .extensions = stl, .holds = "triangles alone, text or binary"},
     .unit = millimetres,
     .read = alone<read_stl>},
    {.file = {.name = "OFF", .content = Content::mesh, .extensions = off, .holds = "triangles alone"},
     .unit = millimetres,
     .read = alone<read_off>},
};

constexpr auto files = [] {
    std::array<FileFormat, std::size(rows)> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = rows[i].file;
    return all;
}();

const MeshFormat* row_of(const FileFormat* format) {
    const auto found = std::find_if(std::begin(rows), std::end(rows),
                                    [&](const MeshFormat& row) { return format && row.file.name == format->name; });
    return found != std::end(rows) ? found : nullptr;
}

}  // namespace

const MeshFormat& mesh_format(const fs::path& path, const std::string& file, const Bytes& bytes) {
    const std::string_view begin{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    const std::string_view unmarked = begin.substr(begin.starts_with("\xef\xbb\xbf") ? 3 : 0);
    if (const MeshFormat* const row = row_of(format_beginning(unmarked))) return *row;
    const MeshFormat* const row = row_of(format_named(path));
    if (const std::string why = row == nullptr ? why_not_read(path, begin) : ""; !why.empty()) refuse(file, "", why);
    if (row == nullptr) refuse(file, "", "is not a mesh that can be read: " + listed(Content::mesh));
    if (row->signed_always)
        refuse(file, "",
               "is not a " + std::string(row->file.name) + ": it does not start with " +
                   std::string(row->file.signatures.front().text));
    return *row;
}

}  // namespace organ

namespace {

constexpr std::string_view json[] = {".json"};
constexpr FileFormat documents[] = {
    {.name = "lapfx",
     .content = Content::document,
     .extensions = json,
     .holds = "a preset or a scene",
     .written = true},
};

constexpr Content contents[] = {Content::mesh, Content::video, Content::picture, Content::document};

bool begins_with(std::string_view bytes, const Signature& signature) {
    return bytes.size() > signature.at && bytes.substr(signature.at).starts_with(signature.text);
}

template <class Is>
const FileFormat* find(Is is) {
    for (const Content content : contents)
        for (const FileFormat& format : formats(content))
            if (is(format)) return &format;
    return nullptr;
}

}  // namespace

std::span<const FileFormat> formats(Content content) {
    switch (content) {
        case Content::mesh:
            return organ::files;
        case Content::video:
            return media::video_formats();
        case Content::picture:
            return media::picture_formats();
        case Content::document:
            return documents;
    }
    return {};
}

const FileFormat* format_named(const std::filesystem::path& file) {
    const std::string extension = lower(file.extension().string());
    return find([&](const FileFormat& format) { return std::ranges::count(format.extensions, extension) > 0; });
}

bool is_named_as(Content content, const std::filesystem::path& file) {
    const FileFormat* const format = format_named(file);
    return format != nullptr && format->content == content;
}

bool is_text(const std::filesystem::path& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return false;  // opening a pipe would wait for its writer
    std::ifstream in(file, std::ios::binary);
    std::string begin(4096, '\0');
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    begin.resize(static_cast<std::size_t>(in.gcount()));
    return !begin.empty() && std::all_of(begin.begin(), begin.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= ' ' ? byte != 127 : byte == '\n' || byte == '\r' || byte == '\t' || byte == '\f';
    });
}

const FileFormat* format_beginning(std::string_view bytes) {
    return find([&](const FileFormat& format) {
        return std::ranges::any_of(format.signatures, [&](const Signature& s) { return begins_with(bytes, s); });
    });
}

std::vector<std::string> extensions(Content content, bool written) {
    std::vector<std::string> all;
    for (const FileFormat& format : formats(content))
        if (format.written || !written) all.insert(all.end(), format.extensions.begin(), format.extensions.end());
    return all;
}

std::string listed(Content content, std::string_view before_last, bool written) {
    std::vector<std::string_view> usual;
    for (const FileFormat& format : formats(content))
        if (format.written || !written) usual.push_back(format.extensions.front());
    std::string text;
    for (std::size_t i = 0; i < usual.size(); ++i)
        text += std::string(i == 0 ? "" : i + 1 == usual.size() ? before_last : ", ") + std::string(usual[i]);
    return text;
}

}  // namespace lapfx
