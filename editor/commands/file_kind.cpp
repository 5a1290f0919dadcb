#include "commands/file_kind.h"

#include <fstream>
#include <string>

#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/picture.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{file.string(), "", reason});
}

/// Checked before anything opens the file: opening a pipe would wait, and decoders accept URLs and devices.
void require_plain_file(const fs::path& file) {
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status)) refuse(file, "no such file");
    if (fs::is_directory(status)) refuse(file, "is a folder, expected a file");
    if (!fs::is_regular_file(status)) refuse(file, "is a pipe or device, expected a plain file");
    if (fs::file_size(file, code) == 0 && !code) refuse(file, "is empty");
}

/// A picture that the core does not decode as a texture is inspected as a clip.
FileKind kind_of(const FileFormat& format) {
    switch (format.content) {
        case Content::mesh:
            return FileKind::organ;
        case Content::document:
            return FileKind::document;
        default:
            return format.texture ? FileKind::image : FileKind::video;
    }
}

/// The first bytes of the file tell it when its name says nothing.
FileKind kind_by_content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string head(16, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    const std::size_t mark = head.starts_with("\xef\xbb\xbf") ? 3 : 0;
    if (const FileFormat* const format = format_beginning(std::string_view(head).substr(mark))) return kind_of(*format);
    if (const std::string why = why_not_read(file); !why.empty()) refuse(file, why);
    const std::size_t first = head.find_first_not_of(" \t\r\n", mark);
    if (first != std::string::npos && head[first] == '{') return FileKind::document;
    if (is_text(file)) refuse(file, "is a text, but not a preset, a scene or a mesh");
    return FileKind::video;
}

/// A name such as "plume_%04d.png": numbered images, which report_clip() finds. A file of just that name comes first.
bool is_sequence(const fs::path& file) {
    std::error_code code;
    return !fs::exists(file, code) && file.filename().string().find('%') != std::string::npos;
}

/// The file need not exist yet; empty where its place cannot be told.
fs::path real_path(const fs::path& path) {
    std::error_code error;
    return fs::weakly_canonical(fs::absolute(path, error), error);
}

}  // namespace

FileKind kind_of_file(const fs::path& file) {
    if (is_sequence(file)) return FileKind::video;
    require_plain_file(file);
    const FileFormat* const format = format_named(file);
    const FileKind kind = format != nullptr ? kind_of(*format) : kind_by_content(file);
    return kind == FileKind::image && is_animated_picture(file) ? FileKind::video : kind;
}

bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code none;
    return fs::equivalent(a, b, none);
}

bool will_be_same_file(const fs::path& a, const fs::path& b) {
    return is_same_file(a, b) || (!real_path(a).empty() && real_path(a) == real_path(b));
}

}  // namespace lapfx::commands
