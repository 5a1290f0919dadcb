// The items of lapfx batch: the scenes and videos of a folder.
//
//     for (const BatchItem& item : batch_items("videos", "results").items) std::cout << item.name << '\n';
//
// Any thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace lapfx::commands {

enum class ItemKind : std::uint8_t { scene, video };

struct BatchItem {
    std::string name;  ///< its path below the folder, with '/', such as "week_1/operation.mp4"; "./-1.mp4" for "-1.mp4"
    ItemKind kind;

    friend bool operator==(const BatchItem&, const BatchItem&) = default;
};

struct BatchList {
    std::vector<BatchItem> items;    ///< by name, byte by byte
    std::vector<std::string> notes;  ///< for people, one line each: what is left out, and why
};

/// Looks through the folder and those below it, by the names of the files: what they hold is found out by whoever reads
/// them. Left out are other files, hidden ones (".name"), names with a line break, videos with the content of one that
/// comes before them (a scene: of one in the same folder), and videos that a scene of the list has as its reference,
/// because that scene is fitted to them. Links are followed, each folder is looked through once, and neither `results`
/// nor any other folder in which a batch runs or has run is, which is a note, as is a folder that cannot be read.
/// Throws Error (bad_input) where the folder is none, or nothing is left.
BatchList batch_items(const std::filesystem::path& folder, const std::filesystem::path& results = {});

/// An item by its name, whether or not batch_items() would list it. Throws Error (bad_input) for a name that leads out
/// of the folder, is not spelled as in the list, is no scene's or video's, or has no file.
BatchItem batch_item(const std::filesystem::path& folder, const std::string& name);

}  // namespace lapfx::commands
