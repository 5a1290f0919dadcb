// All results of lapfx batch together: as a table, and as a page that shows each with its curves and pictures.
//
//     const std::vector<BatchEntry> entries = batch_entries("results");
//     write_file("results/table.csv", table_csv(entries));
//     write_file("results/index.html", index_html(entries));
//
// Any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "commands/batch_result.h"

namespace lapfx::commands {

struct BatchEntry {
    std::string item;
    std::optional<BatchResult> result;  ///< nothing: not finished, it is being done or was killed
    bool report = false;                ///< there is one beside the result
};

/// Of a folder of results, by name. Links are not followed. Throws Error (bad_input) where it is no folder or holds
/// none.
std::vector<BatchEntry> batch_entries(const std::filesystem::path& results);

/// That of its result.
const char* state_of(const BatchEntry& entry);

/// One row for each: what is not known is empty. The columns of parameters are those of all results together:
/// KEY_before, KEY_after, KEY_low, KEY_high, KEY_determined (yes or no). `report`: from the folder of the results.
std::string table_csv(const std::vector<BatchEntry>& entries);

/// One file without scripts that loads nothing; its links lead to the reports beside it. By name, or in one of the
/// orders that it offers. Names and faults in it may hold anything.
std::string index_html(const std::vector<BatchEntry>& entries);

/// Of a path below the page's folder, for a link.
std::string relative_url(const std::string& path);

}  // namespace lapfx::commands
