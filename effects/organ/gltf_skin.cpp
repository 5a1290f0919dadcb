#include "organ/gltf_skin.h"

#include "organ/gltf_accessor.h"
#include "organ/gltf_nodes.h"

namespace lapfx::organ {

namespace {

/// A file may give a vertex more than four joints, in further sets.
constexpr int most_sets = 4;

/// A skin may have more matrices than joints, but a vertex names a joint by 16 bits.
constexpr std::size_t most_matrices = 65536;

bool is_rest(const glm::dmat4& matrix) {
    constexpr double tolerance = 1e-4;  // of lengths in metres, too
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(matrix[column][row] - (column == row ? 1.0 : 0.0)) < tolerance)) return false;
    return true;
}

/// One set of joints and weights, four of each for a vertex.
struct Influences {
    FloatArray joints, weights;
};

std::vector<Influences> influences_of(GltfDocument& document, const tinygltf::Primitive& primitive,
                                      std::size_t vertices, const std::string& place) {
    std::vector<Influences> sets;
    const auto read = [&](const std::string& name, int accessor) {
        const std::string at = place + "/attributes/" + name;
        return read_floats(document, accessor,
                           {.components_low = 4, .components_high = 4, .least = vertices, .most = vertices}, at);
    };
    for (int i = 0; i < most_sets; ++i) {
        const std::string number = std::to_string(i);
        const auto joints = primitive.attributes.find("JOINTS_" + number),
                   weights = primitive.attributes.find("WEIGHTS_" + number);
        if (joints == primitive.attributes.end() || weights == primitive.attributes.end()) break;
        sets.push_back({read(joints->first, joints->second), read(weights->first, weights->second)});
    }
    return sets;
}

}  // namespace

const std::vector<glm::dmat4>& Skins::matrices(int index, const std::string& place) {
    if (index < 0 || static_cast<std::size_t>(index) >= poses_.size())
        refuse(document_.file, place, "skin " + std::to_string(index) + " is not in the file");
    std::optional<std::vector<glm::dmat4>>& pose = poses_[static_cast<std::size_t>(index)];
    if (pose) return *pose;
    if (places_.empty()) places_ = node_places(document_);
    const GltfSkin& skin = document_.skins[static_cast<std::size_t>(index)];
    const std::string at = "/skins/" + std::to_string(index);
    FloatArray inverse{16, {}};
    const std::size_t joints = skin.joints.size();
    if (skin.inverse_bind >= 0)
        inverse = read_floats(
            document_, skin.inverse_bind,
            {.components_low = 16, .components_high = 16, .least = joints, .most = std::max(joints, most_matrices)},
            at + "/inverseBindMatrices");
    pose.emplace();
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
        const int joint = skin.joints[i];
        if (joint < 0 || static_cast<std::size_t>(joint) >= places_.size())
            refuse(document_.file, at + "/joints/" + std::to_string(i),
                   "node " + std::to_string(joint) + " is not in the file");
        glm::dmat4 bind(1.0);
        for (std::size_t k = 0; k < 16 && !inverse.values.empty(); ++k)
            bind[static_cast<int>(k / 4)][static_cast<int>(k % 4)] = static_cast<double>(inverse.values[16 * i + k]);
        pose->push_back(places_[static_cast<std::size_t>(joint)] * bind);
    }
    return *pose;
}

bool Skins::pose(int skin, const tinygltf::Primitive& primitive, const std::string& place, RawPart& part) {
    const std::vector<Influences> sets = influences_of(document_, primitive, part.positions.size(), place);
    if (sets.empty()) return false;
    const std::vector<glm::dmat4>& joints = matrices(skin, place);
    const auto matrix_of = [&](const Influences& set, std::size_t at) -> const glm::dmat4& {
        const float joint = set.joints.values[at];
        if (!(joint >= 0.0F && joint < static_cast<float>(joints.size())))
            refuse(document_.file, place + "/attributes/JOINTS_" + std::to_string(&set - sets.data()),
                   "names a joint that is not in its skin of " + counted(joints.size(), "joint", "joints"));
        return joints[static_cast<std::size_t>(joint)];
    };
    std::vector<char> mirrored(part.positions.size(), 0);
    for (std::size_t v = 0; v < part.positions.size(); ++v) {
        glm::dmat4 matrix(0.0);
        double sum = 0.0;
        for (const Influences& set : sets)
            for (std::size_t i = 4 * v; i < 4 * v + 4; ++i) {
                const auto weight = static_cast<double>(set.weights.values[i]);
                if (!(weight > 0.0)) continue;
                matrix += weight * matrix_of(set, i);
                sum += weight;
            }
        // Weights should add up to 1; a vertex without any follows its first joint.
        matrix = sum > 0.0 ? matrix / sum : matrix_of(sets.front(), 4 * v);
        const AffineMap map(matrix);
        part.positions[v] = map.point(part.positions[v]);
        if (!part.normals.empty()) part.normals[v] = map.normal(part.normals[v]);
        if (!part.tangents.empty()) part.tangents[v] = map.tangent(part.tangents[v]);
        mirrored[v] = map.mirrors() ? 1 : 0;
        moved_ = moved_ || !is_rest(matrix);
    }
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3)
        if (part.indices[i] < mirrored.size() && mirrored[part.indices[i]] != 0)
            std::swap(part.indices[i + 1], part.indices[i + 2]);
    any_ = true;
    return true;
}

}  // namespace lapfx::organ
