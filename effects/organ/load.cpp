// load_organ(): which reader, which unit, then mending and completing.
#include <glm/gtc/matrix_transform.hpp>

#include "organ/gltf.h"
#include "organ/load.h"
#include "organ/mend.h"
#include "organ/obj.h"
#include "organ/openmesh_formats.h"
#include "organ/ply.h"

namespace lapfx {

namespace {

using organ::Bytes;
using organ::Format;

bool starts(const Bytes& bytes, std::string_view text) {
    return bytes.size() >= text.size() && std::equal(text.begin(), text.end(), bytes.begin());
}

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

organ::RawOrgan read(Format format, const std::filesystem::path& path, const std::string& file, const Bytes& bytes) {
    switch (format) {
        case Format::gltf:
            if (lower_extension(path) == ".glb" && !starts(bytes, "glTF"))
                organ::refuse(file, "", "is not a binary glTF: it does not start with glTF");
            return organ::read_gltf(path, file, bytes);
        case Format::obj:
            return organ::read_obj(path, file, bytes);
        case Format::ply:
            return organ::read_ply(file, bytes);
        case Format::stl:
            return organ::read_stl(file, bytes);
        case Format::off:
            return organ::read_off(file, bytes);
        case Format::unknown:
            break;
    }
    organ::refuse_format(file);
}

glm::dmat4 to_millimetres(double scale, const glm::dvec3& degrees) {
    const glm::dvec3 angle = glm::radians(degrees);
    glm::dmat4 matrix(1.0);
    matrix = glm::rotate(matrix, angle.z, {0.0, 0.0, 1.0});
    matrix = glm::rotate(matrix, angle.y, {0.0, 1.0, 0.0});
    matrix = glm::rotate(matrix, angle.x, {1.0, 0.0, 0.0});
    return glm::scale(matrix, glm::dvec3(scale));
}

}  // namespace

organ::Format organ::format_of(const std::filesystem::path& path, const Bytes& bytes) {
    if (starts(bytes, "glTF")) return Format::gltf;
    if (starts(bytes, "ply\n") || starts(bytes, "ply\r")) return Format::ply;
    const std::string extension = lower_extension(path);
    if (extension == ".gltf" || extension == ".glb") return Format::gltf;
    if (extension == ".obj") return Format::obj;
    if (extension == ".ply") return Format::ply;
    if (extension == ".stl" || extension == ".stla" || extension == ".stlb") return Format::stl;
    if (extension == ".off") return Format::off;
    return Format::unknown;
}

void organ::refuse_format(const std::string& file) {
    refuse(file, "", "is not a mesh that can be read: .glb, .gltf, .obj, .ply, .stl or .off");
}

Organ organ::load(const std::filesystem::path& path, const OrganOptions& options, const work::Stages& stages,
                  std::vector<Encoded>* encoded) {
    const std::string file = path.string();
    if (!std::isfinite(options.scale) || options.scale < 0.0)
        organ::refuse(file, "", "scale " + std::to_string(options.scale) + " is not above 0");
    organ::RawOrgan raw;
    Format format = Format::unknown;
    stages.reach(0.0);
    {
        const Bytes bytes = organ::read_file(path, file);
        stages.reach(0.1);
        format = format_of(path, bytes);
        raw = read(format, path, file, bytes);
    }
    stages.reach(0.7);
    const double scale = options.scale > 0.0 ? options.scale : format == Format::gltf ? 1000.0 : 1.0;
    organ::Missing missing;
    std::vector<std::filesystem::path> files = std::move(raw.files), unread = std::move(raw.unread_files);
    if (encoded != nullptr) *encoded = std::move(raw.encoded);
    Organ organ = organ::mend(std::move(raw), file, scale, missing);
    organ::transform(organ, to_millimetres(scale, options.rotation));
    organ.name = path.stem().string();
    organ.scale = scale;
    organ.files = std::move(files);
    organ.files.insert(organ.files.begin(), path);
    organ.unread_files = std::move(unread);
    stages.reach(0.85);
    organ::complete(organ, missing);
    stages.reach(1.0);
    return organ;
}

Organ load_organ(const std::filesystem::path& path, const OrganOptions& options) {
    return organ::load(path, options, {});
}

}  // namespace lapfx
