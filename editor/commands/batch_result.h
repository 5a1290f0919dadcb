// What lapfx batch found for an item, as the file result.json in the item's folder, from which table and index are
// made.
//
//     write_file(folder / result_name, text_of(result));      // last of all that is written: the item is done
//     std::optional<BatchResult> done = read_result(folder);
//
// Any thread.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "commands/batch_list.h"
#include "match/fit/fit.h"
#include "match/video/episode.h"

namespace lapfx::commands {

/// The files of an item's folder.
inline constexpr const char *result_name = "result.json", *lock_name = "running.lock", *report_name = "report.html",
                            *preset_name = "fitted.json", *fitted_scene_name = "fitted.scene.json",
                            *curves_name = "curves.csv", *amounts_name = "amounts.csv";

struct BatchParameter {
    std::string key, unit;
    double before = 0.0, after = 0.0, low = 0.0, high = 0.0;
    bool determined = false;

    friend bool operator==(const BatchParameter&, const BatchParameter&) = default;
};

struct BatchPicture {
    std::string name;  ///< "Reference at 2.40 s"
    std::string jpeg;  ///< the bytes of a file
};

/// Peak and mean of an amount of the video, 0..1; and how far the scene is from it, root mean square.
struct BatchAmount {
    std::optional<double> peak = {}, mean = {}, before = {}, after = {};
};

struct BatchResult {
    ItemKind kind = ItemKind::video;
    bool fitted = false;                   ///< else only measured
    std::string input = {};                ///< ContentHash of all that it was made from
    std::vector<std::string> faults = {};  ///< one line each; none: it is done
    bool unfinished = false;               ///< the faults are none of the input: the next run does it
    double seconds = 0.0;                  ///< that it took
    bool ended_early = false;
    double from = 0.0, to = 0.0;  ///< s, of the scene or of the video that was only measured
    BatchAmount blood = {}, veil = {};
    std::vector<BatchParameter> parameters = {};
    std::vector<match::TargetPoint> target = {};  ///< at most 60
    std::vector<match::FrameAmounts> before = {}, after = {};
    std::vector<BatchPicture> pictures = {};
    std::vector<std::string> notes = {};  ///< of measuring
};

/// "done", "failed" or "unfinished".
const char* state_of(const BatchResult& result);

std::string text_of(const BatchResult& result);
/// Throws Error (bad_input) for what text_of() would not have written; `name` stands in messages.
BatchResult parse_result(const std::string& text, const std::string& name);

/// Of an item's folder; nothing where there is none, or none that can be read: such an item is not done.
std::optional<BatchResult> read_result(const std::filesystem::path& folder);
/// Whether a batch runs in the folder, was killed there, or has left a result.
bool is_of_batch(const std::filesystem::path& folder);

}  // namespace lapfx::commands
