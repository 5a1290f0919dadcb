#include "output/organ_files.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lapfx/file.h"

namespace lapfx::output {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t longest_organ = std::size_t{2} << 30;
constexpr std::size_t longest_library = std::size_t{16} << 20;

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

/// "%20" is a space.
std::string percent_decoded(const std::string& uri) {
    std::string out;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned value = 0;
        if (uri[i] == '%' && i + 2 < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[i + 1])) != 0 &&
            std::isxdigit(static_cast<unsigned char>(uri[i + 2])) != 0) {
            value = static_cast<unsigned>(std::stoul(uri.substr(i + 1, 2), nullptr, 16));
            i += 2;
            out += static_cast<char>(value);
        } else {
            out += uri[i];
        }
    }
    return out;
}

/// The files found so far, each once.
class Found {
  public:
    explicit Found(const fs::path& organ) : folder_(organ.parent_path()) { files_.push_back(organ.filename()); }

    /// Gives whether there is such a file inside of the folder.
    bool add(const std::string& name) {
        if (name.empty() || name.find('\0') != std::string::npos) return false;
        const fs::path relative = fs::path(name).lexically_normal();
        if (relative.is_absolute() || *relative.begin() == "..") return false;
        std::error_code error;
        if (!fs::is_regular_file(folder_ / relative, error)) return false;
        if (std::find(files_.begin(), files_.end(), relative) == files_.end()) files_.push_back(relative);
        return true;
    }
    fs::path folder() const { return folder_; }
    std::vector<fs::path> take() { return std::move(files_); }

  private:
    fs::path folder_;
    std::vector<fs::path> files_;
};

/// The JSON of a .gltf, or of a .glb's first chunk.
std::string_view json_of(std::string_view bytes) {
    if (!bytes.starts_with("glTF")) return bytes;
    if (bytes.size() < 20) return {};
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 12, sizeof length);
    return bytes.substr(20, length);
}

void add_gltf(Found& found, std::string_view bytes) {
    const auto document = nlohmann::json::parse(json_of(bytes), nullptr, false);
    if (!document.is_object()) return;
    for (const char* list : {"buffers", "images"}) {
        if (!document.contains(list) || !document[list].is_array()) continue;
        for (const auto& entry : document[list]) {
            if (!entry.is_object() || !entry.contains("uri") || !entry["uri"].is_string()) continue;
            const auto& uri = entry["uri"].get_ref<const std::string&>();
            if (!uri.starts_with("data:")) found.add(percent_decoded(uri));
        }
    }
}

/// Names may hold spaces, and options stand before them: what is a file is the name.
void add_texture(Found& found, const std::string& words) {
    for (std::size_t at = words.find_first_not_of(" \t"); at != std::string::npos;) {
        if (found.add(trimmed(words.substr(at)))) return;
        at = words.find_first_of(" \t", at);
        if (at != std::string::npos) at = words.find_first_not_of(" \t", at);
    }
}

void add_library(Found& found, const std::string& name) {
    if (!found.add(name)) return;
    std::istringstream lines(read_file(found.folder() / name, longest_library));
    for (std::string line; std::getline(lines, line);) {
        line = trimmed(line.substr(0, line.find('#')));
        const std::size_t space = line.find_first_of(" \t");
        if (space == std::string::npos) continue;
        const std::string key = lower(line.substr(0, space));
        if (key.starts_with("map_") || key == "bump" || key == "norm") add_texture(found, line.substr(space));
    }
}

void add_obj(Found& found, const std::string& bytes) {
    std::istringstream lines(bytes);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("mtllib")) add_library(found, trimmed(line.substr(6)));
}

}  // namespace

std::vector<fs::path> organ_files(const fs::path& organ) {
    Found found(organ);
    const std::string extension = lower(organ.extension().string());
    if (extension == ".gltf" || extension == ".glb") add_gltf(found, read_file(organ, longest_organ));
    if (extension == ".obj") add_obj(found, read_file(organ, longest_organ));
    return found.take();
}

}  // namespace lapfx::output
