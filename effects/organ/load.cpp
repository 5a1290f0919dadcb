// load_organ(): chooses the reader and the unit, then mends and completes.
#include <glm/gtc/matrix_transform.hpp>

#include "media/image.h"
#include "organ/formats.h"
#include "organ/load.h"
#include "organ/mend.h"

namespace lapfx {

namespace {

glm::dmat4 to_millimetres(double scale, const glm::dvec3& degrees) {
    const glm::dvec3 angle = glm::radians(degrees);
    glm::dmat4 matrix(1.0);
    matrix = glm::rotate(matrix, angle.z, {0.0, 0.0, 1.0});
    matrix = glm::rotate(matrix, angle.y, {0.0, 1.0, 0.0});
    matrix = glm::rotate(matrix, angle.x, {1.0, 0.0, 0.0});
    return glm::scale(matrix, glm::dvec3(scale));
}

/// The picture in place of all textures of the base colour. Throws Error.
void give_texture(Organ& organ, const std::filesystem::path& path, std::vector<organ::Encoded>* encoded) {
    const std::string file = path.string();
    const auto bytes = std::make_shared<const organ::Bytes>(organ::read_file(path, file));
    Image image;
    if (const std::string fault = media::decode_image(*bytes, image); !fault.empty()) organ::refuse(file, "", fault);
    image.name = path.filename().string();
    for (Material& material : organ.materials) material.base_color_image = static_cast<int>(organ.images.size());
    if (encoded != nullptr) {
        encoded->resize(organ.images.size());
        encoded->push_back(bytes);
    }
    organ.images.push_back(std::move(image));
    organ.files.push_back(path);
}

}  // namespace

void organ::require_usable(const OrganOptions& options, const std::string& file) {
    if (!std::isfinite(options.scale) || options.scale < 0.0)
        organ::refuse(file, "", "scale " + std::to_string(options.scale) + " is not above 0");
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(options.rotation[k]))
            organ::refuse(file, "", "rotation " + std::to_string(options.rotation[k]) + " is not a number of degrees");
}

void organ::place(Organ& organ, const OrganOptions& options, std::vector<Encoded>* encoded) {
    organ::transform(organ, to_millimetres(organ.scale, options.rotation));
    if (!options.texture.empty()) give_texture(organ, options.texture, encoded);
}

Organ organ::load(const std::filesystem::path& path, const OrganOptions& options, const work::Stages& stages,
                  std::vector<Encoded>* encoded) {
    const std::string file = path.string();
    organ::require_usable(options, file);
    organ::RawOrgan raw;
    double unit = 1.0;
    stages.reach(0.0);
    {
        const Bytes bytes = organ::read_file(path, file);
        stages.reach(0.1);
        const MeshFormat& format = mesh_format(path, file, bytes);
        unit = format.unit;
        raw = format.read(path, file, bytes);
    }
    stages.reach(0.7);
    const double scale = options.scale > 0.0 ? options.scale : unit;
    organ::Missing missing;
    std::vector<std::filesystem::path> files = std::move(raw.files), unread = std::move(raw.unread_files);
    if (encoded != nullptr) *encoded = std::move(raw.encoded);
    Organ organ = organ::mend(std::move(raw), file, scale, missing);
    organ.name = path.stem().string();
    organ.scale = scale;
    organ.files = std::move(files);
    organ.files.insert(organ.files.begin(), path);
    organ.unread_files = std::move(unread);
    organ::place(organ, options, encoded);
    stages.reach(0.85);
    organ::complete(organ, missing);
    stages.reach(1.0);
    return organ;
}

Organ load_organ(const std::filesystem::path& path, const OrganOptions& options) {
    return organ::load(path, options, {});
}

}  // namespace lapfx
