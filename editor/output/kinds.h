// The kinds of exports, one row for each. The dialog, the commands of the menu, `lapfx render` and the names of files
// are made from these rows. Kinds with frames are drawn by RenderJob and written to the files that `frames` makes.
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lapfx/authoring/formats.h"

namespace lapfx::output {

class FrameFiles;
struct FrameFormat;

enum class OutputKind { preset, bundle, picture, sequence, video };

struct OutputRow {
    OutputKind kind;
    std::string_view title;          ///< "Preset"
    std::string_view help;           ///< says what is written and what its name has to be
    std::string_view ending;         ///< follows the preset's name in the name that is proposed
    std::optional<Content> content;  ///< the content of the files; none: a folder is written
    std::string_view files = {};     ///< the name of the dialog's filter: "Presets"
    std::string_view command = {};   ///< "export.video"; empty: it has no command in the menu
    std::string_view command_title = {}, command_tip = {};
    std::string_view example = {};  ///< a name that `lapfx render -o` takes
    bool numbered = false;          ///< a file for each frame, whose name has the number of the frame
    /// Whether a name is one of this kind; null: this kind has no frames.
    bool (*is_name)(const std::filesystem::path& name) = nullptr;
    /// Makes the files for frames (output/frame_files.h). Throws Error (runtime) when they cannot be written there.
    std::unique_ptr<FrameFiles> (*frames)(const std::filesystem::path& name, const FrameFormat& format) = nullptr;
};

inline constexpr std::size_t output_kind_count = 5;
/// All rows, in the order of OutputKind.
const std::array<OutputRow, output_kind_count>& output_rows();
const OutputRow& row_of(OutputKind kind);
/// Their titles in the order of OutputKind, for a choice among them.
const std::array<std::string_view, output_kind_count>& output_titles();

/// What the name of a kind with frames is to be, for a fault: "a picture is a .png", "a video is an .mp4 or .mov".
std::string wanted_name(OutputKind kind);
/// The kind with frames that a name stands for (out.png, out_%04d.png, out.mp4); the disk is not read.
std::optional<OutputKind> kind_named(const std::filesystem::path& name);

}  // namespace lapfx::output
