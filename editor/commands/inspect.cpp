// lapfx inspect FILE...: what a mesh, clip, preset, scene or image holds.
#include "commands/inspect.h"

#include <fstream>

#include "commands/command.h"
#include "lapfx/error.h"

namespace lapfx::commands {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& file, const std::string& reason) {
    throw Error(Failure::bad_input, Fault{file.string(), "", reason});
}

/// Checked before anything opens the file: a pipe would be waited for, and decoders take URLs and devices.
void require_plain_file(const fs::path& file) {
    std::error_code code;
    const fs::file_status status = fs::status(file, code);
    if (!fs::exists(status)) refuse(file, "no such file");
    if (fs::is_directory(status)) refuse(file, "is a folder, expected a file");
    if (!fs::is_regular_file(status)) refuse(file, "is a pipe or device, expected a plain file");
    if (fs::file_size(file, code) == 0 && !code) refuse(file, "is empty");
}

enum class Kind { organ, image, video, document };

struct Extension {
    const char* text;
    Kind kind;
};
constexpr Extension extensions[] = {
    {".glb", Kind::organ},  {".gltf", Kind::organ}, {".obj", Kind::organ}, {".ply", Kind::organ},
    {".stl", Kind::organ},  {".off", Kind::organ},  {".png", Kind::image}, {".jpg", Kind::image},
    {".jpeg", Kind::image}, {".webp", Kind::image}, {".bmp", Kind::image}, {".json", Kind::document},
    {".mp4", Kind::video},  {".mov", Kind::video},  {".m4v", Kind::video}, {".webm", Kind::video},
    {".mkv", Kind::video},  {".avi", Kind::video},  {".mpg", Kind::video}, {".mpeg", Kind::video}};

/// By what the file starts with; for a name that says nothing.
Kind kind_by_content(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string head(16, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    if (head.starts_with("glTF") || head.starts_with("ply\n") || head.starts_with("ply\r")) return Kind::organ;
    if (head.starts_with("\x89PNG") || head.starts_with("\xff\xd8\xff") || head.substr(8, 4) == "WEBP")
        return Kind::image;
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    if (first != std::string::npos && head[first] == '{') return Kind::document;
    return Kind::video;
}

Kind kind_of(const fs::path& file) {
    std::string extension = file.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const Extension& known : extensions)
        if (extension == known.text) return known.kind;
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

/// Goes on after a bad file, and fails at the end with the faults of all.
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
    verb->add_option("FILE", *files,
                     "Mesh (.glb .gltf .obj .ply .stl .off), video (.mp4 .mov .webm .mkv .avi ...), preset or scene "
                     "(.json), image (.png .jpg .webp .bmp), numbered images (smoke_%04d.png)")
        ->required();
    auto keying = std::make_shared<bool>(false);
    verb->add_flag(
        "--keying", *keying,
        "Suggest how to separate the smoke of a video from its background, as an entry for a clip in a preset");
    verb->callback([files, keying] { inspect_files(*files, *keying); });
}

}  // namespace lapfx::commands
