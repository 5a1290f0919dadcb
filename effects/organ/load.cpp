// load_organ(): chooses the reader and the unit, then mends and completes.
#include <glm/gtc/matrix_transform.hpp>

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
    image.name = path.filename().string();
    if (const std::string fault = organ::decode_texture(*bytes, image, organ.warnings); !fault.empty())
        organ::refuse(file, "", fault);
    for (Material& material : organ.materials) {
        if (material.base_color_image >= 0) {
            const Image& replaced = organ.images[static_cast<std::size_t>(material.base_color_image)];
            image.wrap_u = replaced.wrap_u;
            image.wrap_v = replaced.wrap_v;
        }
        material.base_color_image = static_cast<int>(organ.images.size());
    }
    if (encoded != nullptr) {
        encoded->resize(organ.images.size());
        encoded->push_back(bytes);
    }
    organ.images.push_back(std::move(image));
    organ.files.push_back(path);
}

/// 3D Slicer writes into the header of a mesh which way its axes point. Empty: the header does not say so.
std::string space_warning(const organ::Bytes& bytes) {
    struct Space {
        std::string_view name;
        const char *axes, *turn;
    };
    constexpr Space spaces[] = {
        {"SPACE=LPS", "x points to the patient's left, y to the back, z to the head", "-90, 0, 0"},
        {"SPACE=RAS", "x points to the patient's right, y to the front, z to the head", "-90, 180, 0"}};
    const std::string_view header(reinterpret_cast<const char*>(bytes.data()),
                                  std::min<std::size_t>(bytes.size(), 512));
    for (const Space& space : spaces)
        if (header.find(space.name) != std::string_view::npos)
            return "its header says " + std::string(space.name) + ": " + space.axes +
                   "; it is drawn as it is stored, and a rotation of " + space.turn +
                   " degrees makes the patient stand and face the view";
    return {};
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
        const std::string space = options.rotation == glm::dvec3(0.0) ? space_warning(bytes) : "";
        if (!space.empty()) raw.warnings.push_back(space);
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
    organ::complete(organ, missing, encoded);
    stages.reach(1.0);
    return organ;
}

Organ load_organ(const std::filesystem::path& path, const OrganOptions& options) {
    return organ::load(path, options, {});
}

}  // namespace lapfx
