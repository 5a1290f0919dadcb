// Names that come from outside: textures, buffers, clips. Whoever wrote them may have meant any file of this machine.
#include <algorithm>
#include <cctype>

#include "lapfx/authoring/file.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/error.h"

namespace lapfx {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_shown = 120;

/// "scheme:rest", as in URLs and FFmpeg's protocols; a single letter (a DOS drive) counts as well.
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
        if (has_scheme(name)) refuse(shown + " is a URL; only plain files are read");
        note_read(folder / path);
        return folder / path;
    }
    if (has_scheme(name)) outside("is a URL");
    if (path.has_root_path()) outside("is an absolute path");
    if (leaves(path)) outside("leads out of the folder");
    const fs::path base = folder.empty() ? fs::path(".") : folder;
    if (const std::string reason = led_out(base, base / path); !reason.empty()) outside(reason);
    note_read(folder / path);
    return folder / path;
}

}  // namespace lapfx
