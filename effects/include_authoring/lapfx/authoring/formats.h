// The kinds of files that lapfx reads, one row each: meshes, presets and scenes (effects/organ/formats.cpp), videos and
// pictures (effects/media/formats.cpp). Loading, dialogs, drops, previews, exports, `lapfx inspect` and help texts all
// use these rows.
//
//     if (lapfx::is_named_as(lapfx::Content::mesh, "liver.STL")) open_organ("liver.STL");
//     help("A surface: " + lapfx::listed(lapfx::Content::mesh));        // ".glb, .gltf, .obj, .ply, .stl or .off"
//
// Extensions are in lower case and begin with a dot; file names may use either case. Any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lapfx {

enum class Content { mesh, video, picture, document };

/// What files of a format begin with.
struct Signature {
    std::string_view text;
    std::size_t at = 0;  ///< bytes from the beginning
};

struct FileFormat {
    std::string_view name;  ///< "STL"
    Content content;
    std::span<const std::string_view> extensions;  ///< the first one is the usual one
    std::span<const Signature> signatures =
        {};                  ///< a file begins with one of them; empty when the format has no signature
    std::string_view holds;  ///< what lapfx takes from it
    bool texture =
        false;  ///< a picture that the materials of an organ may name, and that `lapfx inspect` decodes whole
    bool written = false;  ///< an export may be one
};

std::span<const FileFormat> formats(Content content);

/// By the extension of the file name; null when no row has it.
const FileFormat* format_named(const std::filesystem::path& file);
bool is_named_as(Content content, const std::filesystem::path& file);
/// By the first bytes of a file, at least 16; null when no row has such a signature.
const FileFormat* format_beginning(std::string_view bytes);

/// Why a file is not read that belongs to another program or holds no surface, and what to export instead: "is a scene
/// of Autodesk's (FBX): ...". By its first bytes, at least 352, else by its name; empty: it is none that is known.
std::string why_not_read(const std::filesystem::path& file, std::string_view begin);
/// The same, by the file itself.
std::string why_not_read(const std::filesystem::path& file);

/// Whether a file begins with printable characters alone, as texts do and no video or picture does. False when it
/// cannot be read, or is no plain file.
bool is_text(const std::filesystem::path& file);

/// All extensions of a content, for the filter of a dialog; with `written` only those of exports.
std::vector<std::string> extensions(Content content, bool written = false);
/// The usual extensions, for a sentence: ".mp4, .mov, .mkv or .avi".
std::string listed(Content content, std::string_view before_last = " or ", bool written = false);

}  // namespace lapfx
