#include "app/files/likely_texture.h"

#include <algorithm>
#include <string_view>

#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/letters.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_looked_at = 2000;  // files and folders, together
constexpr std::size_t same_word = 4;          // letters of a beginning that are no accident

std::string plain(const fs::path& file) {
    return lower(file.stem().string());
}

bool is_other_map(const std::string& name) {
    constexpr std::string_view others[] = {"normal", "bump", "rough", "spec", "height", "metal", "occlusion"};
    return std::ranges::any_of(others, [&](std::string_view word) { return name.find(word) != std::string::npos; });
}

std::size_t shared(const std::string& a, const std::string& b) {
    const auto end = std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first;
    return static_cast<std::size_t>(end - a.begin());
}

void gather(const fs::path& folder, bool deeper, std::size_t& looked_at, std::vector<fs::path>& found) {
    std::error_code error;
    for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
        if (++looked_at > most_looked_at) return;
        std::error_code ignored;
        if (it->is_directory(ignored)) {
            if (deeper) gather(it->path(), false, looked_at, found);
        } else if (is_named_as(Content::picture, it->path()) && it->is_regular_file(ignored) &&
                   !is_other_map(plain(it->path()))) {
            found.push_back(it->path());
        }
    }
}

}  // namespace

std::vector<fs::path> missing_textures(const std::vector<fs::path>& unread) {
    std::vector<fs::path> missing;
    std::ranges::copy_if(unread, std::back_inserter(missing), [](const fs::path& file) {
        return is_named_as(Content::picture, file) && !is_other_map(plain(file));
    });
    return missing;
}

std::optional<fs::path> likely_texture(const fs::path& missing, const fs::path& mesh) {
    std::vector<fs::path> found;
    std::size_t looked_at = 0;
    gather(missing.parent_path(), true, looked_at, found);
    std::erase(found, missing);
    std::ranges::sort(found);
    const std::string wanted = plain(missing), organ = plain(mesh);
    const auto likeness = [&](const fs::path& file) -> std::size_t {
        const std::string name = plain(file);
        if (name == wanted) return 1000;
        const std::size_t most = std::max(shared(name, wanted), shared(name, organ));
        return most >= same_word ? most : 0;
    };
    if (found.empty()) return std::nullopt;
    std::ranges::stable_sort(found, std::greater(), likeness);
    if (found.size() > 1 && likeness(found[0]) == likeness(found[1])) return std::nullopt;
    return found.front();
}

std::string words_of(const MissingTexture& texture) {
    return "Its texture " + texture.missing.filename().string() + (texture.there ? " cannot be read" : " is missing");
}

std::string offer_of(const MissingTexture& texture) {
    const fs::path& likely = *texture.likely;
    const bool same = likely.filename() == texture.missing.filename();
    return "Use " + (same ? likely.lexically_relative(texture.missing.parent_path()) : likely.filename()).string();
}

std::optional<MissingTexture> missing_texture(const Organ& organ, const fs::path& mesh) {
    if (std::ranges::any_of(organ.materials, [](const Material& m) { return m.base_color_image >= 0; }))
        return std::nullopt;
    std::optional<MissingTexture> first;
    for (const fs::path& file : missing_textures(organ.unread_files)) {
        std::error_code ignored;
        MissingTexture one{.missing = file, .likely = likely_texture(file, mesh), .there = fs::exists(file, ignored)};
        if (one.likely) return one;
        if (!first) first = std::move(one);
    }
    return first;
}

}  // namespace lapfx::app
