// Names that come from outside: textures, buffers, clips. Whoever wrote them may have meant any file of this machine.
#include <utf8proc.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <memory>

#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/error.h"

namespace lapfx {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_shown = 120;

/// "C:\organ.obj"
bool has_drive(std::string_view name) {
    return name.size() > 1 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0]));
}

/// "scheme:rest", as in URLs and FFmpeg's protocols.
bool has_scheme(std::string_view name) {
    const std::size_t colon = name.find(':');
    if (colon == std::string_view::npos || colon == 0) return false;
    if (!std::isalpha(static_cast<unsigned char>(name[0]))) return false;
    return std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
    });
}

bool leaves(const fs::path& relative) {
    return relative.empty() || relative.is_absolute() || *relative.begin() == "..";
}

/// The reason why an allowed name still leads out of the folder, by a symbolic link; empty: it does not.
std::string led_out(const fs::path& folder, const fs::path& path) {
    std::error_code error;
    const fs::path real_folder = fs::weakly_canonical(fs::absolute(folder, error), error);
    if (error) return "its folder cannot be followed: " + error.message();
    const fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
    if (error) return "cannot be followed: " + error.message();
    return leaves(real.lexically_relative(real_folder)) ? "leads out of the folder by a symbolic link" : "";
}

/// Normalization form C (Unicode Standard Annex 15). What is no UTF-8 stays as it is.
std::string composed(const std::string& name) {
    const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> text(
        utf8proc_NFC(reinterpret_cast<const utf8proc_uint8_t*>(name.c_str())), &std::free);
    return text ? reinterpret_cast<const char*>(text.get()) : name;
}

/// An entry of the folder that reads as this name does, or the name itself. A letter with a mark is one character or
/// two, depending on the system that a file comes from, and Linux takes these for two names.
fs::path entry_named(const fs::path& folder, const fs::path& name) {
    const std::string wanted = composed(name.string());
    std::error_code error;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, error), end; !error && entry != end;
         entry.increment(error))
        if (composed(entry->path().filename().string()) == wanted) return entry->path().filename();
    return name;
}

/// `path` as the folders on the disk spell it, where it is not there as it is written.
fs::path as_on_disk(const fs::path& folder, const fs::path& path) {
    const std::string& text = path.native();
    const bool is_plain =
        std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
    std::error_code error;
    if (is_plain || fs::exists(folder / path, error)) return folder / path;
    fs::path there = folder;
    for (const fs::path& name : path) there /= fs::exists(there / name, error) ? name : entry_named(there, name);
    return there;
}

}  // namespace

bool lies_in(const fs::path& folder, const fs::path& path) {
    return led_out(folder.empty() ? fs::path(".") : folder, path).empty();
}

fs::path named_path(const fs::path& folder, std::string_view name, Reach reach, const std::string& file,
                    const std::string& place) {
    const auto refuse = [&](const std::string& reason) {
        throw Error(Failure::bad_input, Fault{.file = file, .place = place, .reason = reason});
    };
    if (name.empty()) refuse("no file name");
    const std::string shown = '"' + std::string(name.substr(0, most_shown)) + '"';
    const auto outside = [&](const std::string& what) {
        refuse(shown + ' ' + what + "; only plain files in the folder of the file that names them, or below, are read");
    };
    if (name.find('\0') != std::string_view::npos) refuse("the file name contains a NUL character");
    const fs::path path = fs::path(name).lexically_normal();
    if (reach == Reach::anywhere) {
        if (has_drive(name)) refuse(shown + " is a path of Windows; the file has to be on this machine");
        if (has_scheme(name)) refuse(shown + " is a URL; only plain files are read");
        const fs::path found = as_on_disk(folder, path);
        note_read(found);
        return found;
    }
    if (!has_drive(name) && has_scheme(name)) outside("is a URL");
    if (has_drive(name) || path.has_root_path()) outside("is an absolute path");
    if (leaves(path)) outside("leads out of the folder");
    const fs::path found = as_on_disk(folder, path);
    if (!lies_in(folder, found)) outside(led_out(folder.empty() ? "." : folder, found));
    note_read(found);
    return found;
}

}  // namespace lapfx
