// How questions about files call them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lapfx::app {

/// "tuned.json", with the marks.
inline std::string in_marks(const std::filesystem::path& file) {
    return '"' + file.filename().string() + '"';
}

/// The name of a scene or a preset that nobody has named yet.
constexpr std::string_view new_name(bool scene) {
    return scene ? "New scene" : "New preset";
}

}  // namespace lapfx::app
