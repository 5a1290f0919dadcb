// lapfx inspect FILE...: what a mesh, clip, preset, scene or image contains.
#include "commands/inspect.h"

#include <CLI/CLI.hpp>
#include <fstream>

#include "commands/command.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{file.string(), "", reason});
}

/// Checked before anything opens the file: opening a pipe would wait, and decoders accept URLs and devices.
void require_plain_file(const fs::path& file) {
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status)) refuse(file, "no such file");
    if (fs::is_directory(status)) refuse(file, "is a folder, expected a file");
    if (!fs::is_regular_file(status)) refuse(file, "is a pipe or device, expected a plain file");
    if (fs::file_size(file, code) == 0 && !code) refuse(file, "is empty");
}

enum class Kind { organ, image, video, document };

/// A picture that the core does not decode as a texture is inspected as a clip.
Kind kind_of(const FileFormat& format) {
    switch (format.content) {
        case Content::mesh:
            return Kind::organ;
        case Content::document:
            return Kind::document;
        default:
            return format.texture ? Kind::image : Kind::video;
    }
}

/// By the first bytes of the file, for a name that says nothing.
Kind kind_by_content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string head(16, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (const FileFormat* const format = format_beginning(head)) return kind_of(*format);
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && head[first] == '{') return Kind::document;
    if (is_text(file)) refuse(file, "is a text, but not a preset, a scene or a mesh");
    return Kind::video;
}

Kind kind_of(const fs::path& file) {
    if (const FileFormat* const format = format_named(file)) return kind_of(*format);
    return kind_by_content(file);
}

/// A name such as "plume_%04d.png": numbered images, which report_clip() finds. A file of just that name comes first.
bool is_sequence(const fs::path& file) {
    std::error_code code;
    return !fs::exists(file, code) && file.filename().string().find('%') != std::string::npos;
}

void inspect_file(const fs::path& file, bool keying) {
    const bool sequence = is_sequence(file);
    if (!sequence) require_plain_file(file);
    const Kind kind = sequence ? Kind::video : kind_of(file);
    if (keying && kind != Kind::video && kind != Kind::image)
        refuse(file, "is not a clip, so there is no keying to suggest");
    switch (kind) {
        case Kind::organ:
            inspect_organ(file);
            break;
        case Kind::image:
            inspect_image(file);
            if (keying) inspect_keying(file);
            break;
        case Kind::video:
            inspect_video(file);
            if (keying) inspect_keying(file);
            break;
        case Kind::document:
            inspect_document(file);
            break;
    }
}

/// Continues after a bad file, and fails at the end with the faults of all files.
void inspect_files(const std::vector<std::string>& files, bool keying) {
    std::vector<Fault> faults;
    Failure failure = Failure::runtime;
    for (const std::string& file : files) {
        try {
            inspect_file(file, keying);
        } catch (const Error& error) {
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
            if (error.failure() == Failure::bad_input) failure = Failure::bad_input;
        }
    }
    if (!faults.empty()) throw Error(failure, std::move(faults));
}

}  // namespace

void add_inspect(CLI::App& app) {
    CLI::App* verb = app.add_subcommand("inspect", "Show what a mesh, clip, preset, scene or image contains");
    auto files = std::make_shared<std::vector<std::string>>();
    verb->add_option("FILE", *files, "Mesh, video, image, numbered images (smoke_%04d.png), preset or scene")
        ->required();
    auto keying = std::make_shared<bool>(false);
    verb->add_flag(
        "--keying", *keying,
        "Suggest how to separate the smoke of a video from its background, as an entry for a clip in a preset");
    verb->footer(
        "Examples:\n"
        "  lapfx inspect samples/lagb.glb samples/clips/plume_thick.mp4\n"
        "  lapfx inspect --keying samples/clips/plume_thick.mp4\n\n"
        "`lapfx help files` lists the formats.");
    verb->callback([files, keying] { inspect_files(*files, *keying); });
}

}  // namespace lapfx::commands
