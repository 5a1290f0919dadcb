// What is exported: one row for each kind, from which the dialog, the commands of the menu, `lapfx render` and the
// names of files get theirs. Those with frames are drawn by RenderJob and go where `frames` says.
#pragma once

#include <array>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string_view>

#include "lapfx/authoring/formats.h"

namespace lapfx::output {

class FrameFiles;

enum class OutputKind { preset, bundle, picture, sequence, video };

struct OutputRow {
    OutputKind kind;
    std::string_view title;          ///< "Preset"
    std::string_view help;           ///< what is written, and what its name has to be
    std::string_view ending;         ///< of the name that is proposed, behind the preset's
    std::optional<Content> content;  ///< of the files; none: a folder
    std::string_view files = {};     ///< of the dialog's filter: "Presets"
    std::string_view command = {};   ///< "export.video"; empty: none of its own in the menu
    std::string_view command_title = {}, command_tip = {};
    std::string_view example = {};  ///< a name, as `lapfx render -o` takes it
    /// Whether a name is one of this kind; null: it is not a kind that has frames.
    bool (*is_name)(const std::filesystem::path& name) = nullptr;
    /// Where its frames go, `count` of them. Throws Error (runtime) when they cannot be written there.
    std::unique_ptr<FrameFiles> (*frames)(const std::filesystem::path& name, double fps, glm::ivec2 size,
                                          int count) = nullptr;
};

inline constexpr std::size_t output_kind_count = 5;
/// By OutputKind.
const std::array<OutputRow, output_kind_count>& output_rows();
const OutputRow& row_of(OutputKind kind);
/// For a choice among them, by OutputKind.
const std::array<std::string_view, output_kind_count>& output_titles();

/// By the name alone, of a kind that has frames: out.png, out_%04d.png, out.mp4.
std::optional<OutputKind> kind_named(const std::filesystem::path& name);

}  // namespace lapfx::output
