// Opening files, whatever they are: scenes, presets, organs, clips. Used by the editor and by its command line.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "lapfx/authoring/organ_report.h"

namespace lapfx::app {

enum class FileKind { scene, preset, organ, video, unknown };

/// Told by the file's name; of a .json by its "format". Throws Error (bad_input) for a .json that is neither scene nor
/// preset.
FileKind kind_of(const std::filesystem::path& file);

bool is_organ_name(const std::filesystem::path& file);
/// Whether this is the name of a preset or a scene.
bool is_document_name(const std::filesystem::path& file);

/// Why a scene or a preset (`kind`) is not written over what has that name now: only another of its kind is replaced.
/// Empty: there is none, or it is one.
std::string why_not_replaced(FileKind kind, const std::filesystem::path& file);

/// Another unit of an opened organ's file, with which the organ has a usual size.
struct UnitProposal {
    std::string file;  ///< SceneOrgan::file
    double scale = 1;
    std::string reason;
    OrganReport organ;  ///< with that unit
};

/// The files that have been read and will become the document.
struct Opened {
    document::Content content;
    std::filesystem::path scene_file, preset_file;  ///< empty: none of its own
    std::vector<std::string> warnings;
    std::optional<UnitProposal> unit = {};  ///< none: the unit of the organ's file may well be right
};

/// The sample scene with its preset. Throws Error.
Opened open_sample(const std::filesystem::path& data_folder);

/// Opens files into `opened`: a scene replaces everything, a preset the preset, an organ the scene's organ (seen from
/// the front, without events). The scene is always opened first, in whatever order the files are named. Gives the
/// videos among them, which exist and are not opened: what they are for is in their pictures (Files::bring_videos).
/// Throws Error.
std::vector<std::string> open_files(Opened& opened, const std::vector<std::string>& files);

/// The preset that a scene names; the default one if it names none. Throws Error.
Preset preset_of(const Scene& scene);

}  // namespace lapfx::app
