#include "organ/pack.h"

#include <algorithm>

#include "lapfx/authoring/file.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/error.h"
#include "media/image.h"
#include "organ/formats.h"
#include "organ/raw.h"

namespace lapfx {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_stem = 80;

bool is_plain(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' || c == '_' ||
           c == '-';
}

/// The extension of a picture, by its first bytes, because its name may be wrong.
std::string_view picture_extension(const organ::Bytes& bytes) {
    const FileFormat* const format = format_beginning({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    return format != nullptr && format->texture ? format->extensions.front()
                                                : ".bmp";  // a picture that decodes but begins differently
}

}  // namespace

std::string OwnNames::give(const fs::path& wanted, std::string_view extension) {
    std::string stem = wanted.stem().string().substr(0, longest_stem);
    for (char& c : stem)
        if (!is_plain(c)) c = '_';
    stem.erase(0, stem.find_first_not_of('.'));
    if (stem.empty()) stem = "file";
    std::string name = stem + std::string(extension);
    int& number = numbers_.try_emplace(lower(name), 1).first->second;
    while (!taken_.insert(lower(name)).second) name = stem + '-' + std::to_string(++number) + std::string(extension);
    return name;
}

std::optional<std::string> organ::Packing::known(PackedKind kind, const fs::path& file) const {
    const auto found = known_.find({kind, file});
    if (found == known_.end()) return std::nullopt;
    return found->second ? files[*found->second].name : "";
}

std::string organ::Packing::add(PackedKind kind, const fs::path& file, std::string_view extension, Bytes bytes) {
    known_[{kind, file}] = files.size();
    files.push_back({.name = names_.give(file.filename(), extension), .bytes = std::move(bytes)});
    return files.back().name;
}

std::string organ::Packing::add_picture(const fs::path& file) {
    if (const auto name = known(PackedKind::picture, file)) return *name;
    try {
        Bytes bytes = read_file(file, file.string());
        Image decoded;
        if (media::decode_image(bytes, decoded, longest_texture).empty()) {
            const std::string_view extension = picture_extension(bytes);
            return add(PackedKind::picture, file, extension, std::move(bytes));
        }
    } catch (const Error&) {  // loading tells why
    }
    leave_out(PackedKind::picture, file);
    return {};
}

std::string organ::Packing::add_buffer(const fs::path& file, std::size_t length, const std::string& mesh,
                                       const std::string& place, const std::string& what) {
    const auto found = known_.find({PackedKind::buffer, file});
    PackedFile* const packed = found != known_.end() && found->second ? &files[*found->second] : nullptr;
    if (packed && packed->bytes.size() >= length) return packed->name;
    Bytes bytes = read_file(file, mesh, place + ": " + what);
    if (length > bytes.size()) refuse(mesh, place, what + " is not as long as it should be");
    bytes.resize(length);  // the rest of it does not belong to the organ
    if (!packed) return add(PackedKind::buffer, file, ".bin", std::move(bytes));
    packed->bytes = std::move(bytes);  // another buffer that uses less of it named it before
    return packed->name;
}

std::vector<PackedFile> pack_organ(const fs::path& path) {
    const std::string file = path.string();
    organ::Bytes bytes = organ::read_file(path, file);
    const organ::MeshFormat& format = organ::mesh_format(path, file, bytes);
    organ::Packing packing(path.parent_path());
    // First, so that it gets the best name; the files that it names follow.
    const std::string name = packing.add(organ::PackedKind::mesh, path, format.file.extensions.front(), {});
    if (format.pack != nullptr) bytes = format.pack(bytes, file, packing);
    packing.files.front().bytes = std::move(bytes);
    return std::move(packing.files);
}

}  // namespace lapfx
