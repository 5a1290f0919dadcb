// lapfx inspect FILE...: what a mesh, clip, preset, scene or image contains.
#include "commands/inspect.h"

#include "commands/command.h"
#include "commands/file_kind.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{file.string(), "", reason});
}

void inspect_file(const fs::path& file, bool keying) {
    const FileKind kind = kind_of_file(file);
    if (keying && kind != FileKind::video && kind != FileKind::image)
        refuse(file, "is not a clip, so there is no keying to suggest");
    switch (kind) {
        case FileKind::organ:
            inspect_organ(file);
            break;
        case FileKind::image:
            inspect_image(file);
            if (keying) inspect_keying(file);
            break;
        case FileKind::video:
            inspect_video(file);
            if (keying) inspect_keying(file);
            break;
        case FileKind::document:
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

Verb inspect_verb() {
    const auto files = std::make_shared<std::vector<std::string>>();
    const auto keying = std::make_shared<bool>(false);
    Verb verb{.name = "inspect",
              .help = "Show what a mesh, clip, preset, scene or image contains",
              .footer =
                  "Examples:\n"
                  "  lapfx inspect samples/lagb.glb samples/clips/plume_thick.mp4\n"
                  "  lapfx inspect --keying samples/clips/plume_thick.mp4\n\n"
                  "`lapfx help files` lists the formats.",
              .run = [files, keying] { inspect_files(*files, *keying); }};
    verb.argument("FILE", "Mesh, video, image, numbered images (smoke_%04d.png), preset or scene", files.get(),
                  {.required = true});
    verb.flag("--keying",
              "Suggest how to separate the smoke of a video from its background, as an entry for a clip in a preset",
              keying.get());
    return verb;
}

}  // namespace lapfx::commands
