#include "app/base/paths.h"

#include "lapfx/authoring/file.h"
#include "lapfx/error.h"

namespace lapfx::app {

std::string path_for(const std::filesystem::path& file, const std::filesystem::path& folder) {
    const std::filesystem::path whole = std::filesystem::absolute(file).lexically_normal();
    if (folder.empty()) return whole.generic_string();
    const std::filesystem::path from = std::filesystem::absolute(folder).lexically_normal();
    const std::filesystem::path relative = whole.lexically_relative(from);
    const bool inside = !relative.empty() && *relative.begin() != "..";
    return inside ? relative.generic_string() : whole.generic_string();
}

std::filesystem::path path_from(const std::filesystem::path& folder, const std::string& file) {
    try {
        return file.empty() ? std::filesystem::path() : named_path(folder, file, Reach::anywhere);
    } catch (const Error&) {
        return {};  // who reads it tells why
    }
}

}  // namespace lapfx::app
