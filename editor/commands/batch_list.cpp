#include "commands/batch_list.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "commands/batch_result.h"
#include "commands/content_hash.h"
#include "commands/file_kind.h"
#include "commands/options.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/scene.h"

namespace lapfx::commands {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view scene_ending = ".scene.json";

std::optional<ItemKind> kind_of(const std::string& name) {
    if (name.ends_with(scene_ending)) return ItemKind::scene;
    if (is_named_as(Content::video, name)) return ItemKind::video;
    return {};
}

bool is_hidden(const fs::path& path) {
    return path.filename().string().starts_with('.');
}

bool has_line_break(const std::string& name) {
    return name.find_first_of("\r\n") != std::string::npos;
}

std::string shown(const std::string& name) {
    return Fault{.file = name, .place = "", .reason = ""}.text();
}

/// A line of the list is an argument of `lapfx batch run`.
std::string no_option(const std::string& name) {
    return name.starts_with('-') ? "./" + name : name;
}

/// "FOLDER: 2 other files are left out: a, b"; the first three are named.
std::string left_out(const fs::path& folder, const std::string& one, const std::string& many,
                     std::vector<std::string> names) {
    constexpr std::size_t named = 3;
    std::sort(names.begin(), names.end());
    std::string said =
        shown(folder.string()) + ": " + std::to_string(names.size()) + ' ' + (names.size() == 1 ? one : many);
    for (std::size_t i = 0; i < std::min(named, names.size()); ++i) said += (i == 0 ? " " : ", ") + names[i];
    if (names.size() > named) said += ", ...";
    return said;
}

/// All files below a folder; folders that are links come last, so that a file has the name of its own place.
class Walk {
  public:
    Walk(const fs::path& top, const fs::path& results, std::vector<std::string>& notes) : top_(top), notes_(notes) {
        std::error_code none;
        if (!results.empty()) seen_.insert(fs::weakly_canonical(fs::absolute(results, none), none));
        look_through(top, false);
        while (!links_.empty()) {
            const std::vector<fs::path> links = std::exchange(links_, {});
            for (const fs::path& link : links)
                if (lies_in(top, link))
                    look_through(link, true);
                else
                    notes.push_back(shown(link.string()) + ": leads out of the folder and is not looked through");
        }
        if (!of_batch_.empty())
            notes.push_back(left_out(top, "folder of results is not looked through:",
                                     "folders of results are not looked through:", std::move(of_batch_)));
    }
    std::vector<std::string> files;  ///< names

  private:
    std::string name_of(const fs::path& path) const { return path.lexically_relative(top_).generic_string(); }

    void look_through(const fs::path& folder, bool link) {
        std::error_code error;
        const fs::path real = fs::canonical(folder, error);
        if (!error && seen_.contains(real)) {
            if (link) notes_.push_back(shown(folder.string()) + ": leads to a folder that is not looked through again");
            return;
        }
        seen_.insert(real);
        if (is_of_batch(folder)) {
            of_batch_.push_back(shown(folder == top_ ? folder.string() : name_of(folder)));
            return;
        }
        std::vector<fs::directory_entry> entries;
        for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
            entries.push_back(*it);
        if (error) {
            notes_.push_back(shown(folder.string()) + ": cannot be looked through: " + error.message());
            return;
        }
        std::sort(entries.begin(), entries.end());
        for (const fs::directory_entry& entry : entries) take(entry);
    }
    void take(const fs::directory_entry& entry) {
        std::error_code error;
        if (!entry.is_directory(error)) {
            if (entry.is_regular_file(error))
                files.push_back(name_of(entry.path()));
            else
                notes_.push_back(shown(entry.path().string()) + ": is " +
                                 (entry.exists(error) ? "not a plain file" : "a link to nothing") + " and is left out");
        } else if (!is_hidden(entry.path())) {
            if (entry.is_symlink(error))
                links_.push_back(entry.path());
            else
                look_through(entry.path(), false);
        }
    }

    const fs::path& top_;
    std::vector<std::string>& notes_;
    std::vector<fs::path> links_;
    std::vector<std::string> of_batch_;  ///< folders
    std::set<fs::path> seen_;
};

std::vector<BatchItem> items_of(const fs::path& folder, const std::vector<std::string>& files,
                                std::vector<std::string>& notes) {
    std::vector<BatchItem> items;
    std::vector<std::string> others;
    for (const std::string& name : files) {
        const std::optional<ItemKind> kind = is_hidden(name) || has_line_break(name) ? std::nullopt : kind_of(name);
        if (kind)
            items.push_back({no_option(name), *kind});
        else
            others.push_back(shown(name));
    }
    if (!others.empty())
        notes.push_back(left_out(folder, "other file is left out:", "other files are left out:", std::move(others)));
    return items;
}

/// Such files have the same content; for those that no other file shares its size with, nothing is read.
using Contents = std::map<std::string, std::vector<std::string>>;

Contents contents_of(const fs::path& folder, const std::vector<BatchItem>& items) {
    std::map<std::pair<std::string, std::uintmax_t>, std::vector<std::string>> by_size;
    for (const BatchItem& item : items) {
        std::error_code error;
        const std::uintmax_t size = fs::file_size(folder / item.name, error);
        // A scene names its files relative to its own folder.
        const std::string of =
            item.kind == ItemKind::scene ? "scene " + fs::path(item.name).parent_path().string() : "";
        if (!error && size > 0) by_size[{of, size}].push_back(item.name);
    }
    Contents contents;
    for (const auto& [size, names] : by_size) {
        if (names.size() < 2) continue;
        for (const std::string& name : names) {
            ContentHash hash;
            hash.add(size.first);
            hash.add_file(folder / name);
            contents[hash.text()].push_back(name);
        }
    }
    return contents;
}

/// Files that scenes of the list name, and the first scene that does.
using References = std::map<fs::path, std::string>;

/// The scene whose reference a video is.
std::optional<std::string> scene_of(const fs::path& video, const References& references) {
    std::error_code error;
    const auto found = references.find(fs::canonical(video, error));
    return error || found == references.end() ? std::nullopt : std::optional(found->second);
}

/// A reference stays rather than its copies.
void drop_copies(const fs::path& folder, const References& references, std::vector<BatchItem>& items,
                 std::vector<std::string>& notes) {
    std::set<std::string> copies;
    for (auto [hash, names] : contents_of(folder, items)) {
        std::ranges::stable_partition(
            names, [&](const std::string& name) { return scene_of(folder / name, references).has_value(); });
        for (std::size_t i = 1; i < names.size(); ++i) {
            copies.insert(names[i]);
            notes.push_back(shown(names[i]) + ": has the content of " + shown(names[0]) + " and is left out");
        }
    }
    std::erase_if(items, [&](const BatchItem& item) { return copies.contains(item.name); });
}

/// What a scene names; nothing where it cannot be read, which whoever fits it tells.
fs::path reference_of(const fs::path& scene) {
    try {
        const Scene loaded = load_scene(scene);
        if (loaded.reference.file.empty()) return {};
        std::error_code error;
        return fs::canonical(named_path(loaded.folder, loaded.reference.file, Reach::anywhere), error);
    } catch (const Error&) {
        return {};
    }
}

References references_of(const fs::path& folder, const std::vector<BatchItem>& items) {
    References references;
    for (const BatchItem& item : items)
        if (item.kind == ItemKind::scene) references.emplace(reference_of(folder / item.name), item.name);
    return references;
}

void drop_references(const fs::path& folder, const References& references, std::vector<BatchItem>& items,
                     std::vector<std::string>& notes) {
    std::erase_if(items, [&](const BatchItem& item) {
        const std::optional<std::string> scene = scene_of(folder / item.name, references);
        if (item.kind != ItemKind::video || !scene) return false;
        notes.push_back(shown(item.name) + ": is the reference of " + shown(*scene) + ", which is fitted to it");
        return true;
    });
}

Error refused(const fs::path& folder, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = folder.string(), .place = "", .reason = reason}};
}

void require_folder(const fs::path& folder) {
    std::error_code error;
    if (!fs::exists(folder, error)) throw refused(folder, "no such folder");
    if (!fs::is_directory(folder, error)) throw refused(folder, "is not a folder");
}

}  // namespace

BatchList batch_items(const fs::path& folder, const fs::path& results) {
    require_folder(folder);
    BatchList list;
    list.items = items_of(folder, Walk(folder, results, list.notes).files, list.notes);
    std::sort(list.items.begin(), list.items.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    const References references = references_of(folder, list.items);
    drop_copies(folder, references, list.items, list.notes);
    drop_references(folder, references, list.items, list.notes);
    if (list.items.empty()) {
        std::vector<Fault> faults;
        for (const std::string& note : list.notes) faults.push_back({.file = "", .place = "", .reason = note});
        faults.push_back(
            refused(folder, "holds neither scenes (*.scene.json) nor videos (" + listed(Content::video) + ")")
                .faults()
                .front());
        throw Error(Failure::bad_input, std::move(faults));
    }
    return list;
}

BatchItem batch_item(const fs::path& folder, const std::string& name) {
    require_folder(folder);
    const fs::path path(name.starts_with("./-") ? name.substr(2) : name);
    const auto wrong = [&](const std::string& reason) { return wrong_option("ITEM", "\"" + name + "\" " + reason); };
    if (name.empty() || path.is_absolute() || path.lexically_normal().string() != path.string() ||
        path.begin()->string() == ".." || name == "." || !path.has_filename())
        throw wrong("is not a path below " + folder.string() + " as `lapfx batch list` prints it");
    const std::optional<ItemKind> kind = kind_of(name);
    if (!kind || has_line_break(name))
        throw wrong("is neither a scene (*.scene.json) nor a video (" + listed(Content::video) + ")");
    std::error_code error;
    const fs::file_status status = fs::status(folder / path, error);
    if (!fs::exists(status)) throw wrong("is no file of " + folder.string());
    if (!fs::is_regular_file(status)) throw wrong("of " + folder.string() + " is not a plain file");
    return {no_option(path.generic_string()), *kind};
}

}  // namespace lapfx::commands
