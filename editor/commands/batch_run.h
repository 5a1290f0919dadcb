// One item of lapfx batch: fitted or measured, into a folder of its own.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "commands/batch_list.h"
#include "commands/fit_run.h"

namespace lapfx::commands {

struct BatchRunOptions {
    std::filesystem::path folder, results;  ///< of the items; what is written goes into a folder for each item
    FitOptions fit = {};                    ///< files.scene: with which videos are fitted; empty: they are measured
    bool again = false;                     ///< items that are done are done again
};

/// Where an item's files are written.
std::filesystem::path folder_of(const std::filesystem::path& results, const BatchItem& item);

/// The result file is written last and makes the item done. It holds a hash of all that went in: what is fitted and
/// how, and the contents of the video, of the scene with all files that it names, and of the preset with its clips. An
/// item that is done from the same is told and not done again. One whose input is at fault is done, too; of one that
/// fails otherwise the result says why, and the next run does it again, as what was killed.
/// A lock that the kernel releases (flock) keeps two processes from one item: the second tells so and does nothing.
///
/// `out`: one line on what was done, or why not. Throws Error: that of run_fit() or of measuring, and bad_input again
/// where it did so before.
void run_item(const BatchRunOptions& options, const BatchItem& item, std::ostream& out);

}  // namespace lapfx::commands
