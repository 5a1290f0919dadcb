#include "organ/pack.h"

#include <algorithm>
#include <array>

#include "lapfx/error.h"
#include "lapfx/file.h"
#include "organ/image.h"
#include "organ/load.h"

namespace lapfx {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_stem = 80;

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(), [](char c) { return lower(c); });
    return text;
}

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '-';
}

/// Of a picture, by what it starts with: its own name may say anything.
std::string_view picture_extension(const organ::Bytes& bytes) {
    switch (bytes.empty() ? 0 : bytes[0]) {
        case 0x89:
            return ".png";
        case 0xff:
            return ".jpg";
        case 'R':
            return ".webp";
        default:
            return ".bmp";
    }
}

std::string_view mesh_extension(organ::Format format, const organ::Bytes& bytes) {
    constexpr std::array<std::string_view, 5> extensions{".gltf", ".obj", ".ply", ".stl", ".off"};
    const bool binary = format == organ::Format::gltf && !bytes.empty() && bytes[0] == 'g';
    return binary ? ".glb" : extensions.at(static_cast<std::size_t>(format));
}

}  // namespace

std::string OwnNames::give(const fs::path& wanted, std::string_view extension) {
    std::string stem = wanted.stem().string().substr(0, longest_stem);
    for (char& c : stem)
        if (!is_plain(c)) c = '_';
    stem.erase(0, stem.find_first_not_of('.'));
    if (stem.empty()) stem = "file";
    std::string name = stem + std::string(extension);
    for (int i = 2; !taken_.insert(lower(name)).second; ++i)
        name = stem + '-' + std::to_string(i) + std::string(extension);
    return name;
}

std::string organ::Packing::add(const fs::path& file, std::string_view extension, Bytes bytes) {
    if (const auto known = known_.find(file); known != known_.end()) return known->second;
    const std::string name = names_.give(file.filename(), extension);
    known_.emplace(file, name);
    files.push_back({.name = name, .bytes = std::move(bytes)});
    return name;
}

std::string organ::Packing::add_picture(const fs::path& file) {
    try {
        Bytes bytes = read_file(file, file.string());
        Image decoded;
        if (!decode_image(bytes, decoded).empty()) return {};
        const std::string_view extension = picture_extension(bytes);
        return add(file, extension, std::move(bytes));
    } catch (const Error&) {
        return {};  // loading tells why
    }
}

std::vector<PackedFile> pack_organ(const fs::path& path) {
    const std::string file = path.string();
    organ::Bytes bytes = organ::read_file(path, file);
    const organ::Format format = organ::format_of(path, bytes);
    if (format == organ::Format::unknown) organ::refuse_format(file);
    organ::Packing packing(path.parent_path());
    // First, so that it has the best name; what it names follows from it.
    const std::string name = packing.add(path, mesh_extension(format, bytes), {});
    if (format == organ::Format::obj) bytes = organ::pack_obj(bytes, packing);
    if (format == organ::Format::gltf) bytes = organ::pack_gltf(bytes, file, packing);
    packing.files.front().bytes = std::move(bytes);
    return std::move(packing.files);
}

}  // namespace lapfx
