#include "organ/gltf.h"

#include <utility>

#include "organ/gltf_accessor.h"
#include "organ/gltf_codecs.h"
#include "organ/gltf_material.h"
#include "organ/gltf_nodes.h"
#include "organ/gltf_skin.h"

namespace lapfx::organ {

namespace {

/// The accessor of an attribute, or -1.
int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
    const auto found = primitive.attributes.find(name);
    return found == primitive.attributes.end() ? -1 : found->second;
}

/// An attribute with `low` to `high` components and as many elements as there are positions.
FloatArray optional_attribute(GltfDocument& document, const tinygltf::Primitive& primitive, const std::string& name,
                              int low, int high, std::size_t count, const std::string& place) {
    const int accessor = attribute(primitive, name);
    if (accessor < 0) return {low, {}};
    const std::string at = place + "/attributes/" + name;
    return read_floats(document, accessor,
                       {.components_low = low, .components_high = high, .least = count, .most = count}, at);
}

template <class Vector>
std::vector<Vector> vectors(const FloatArray& array, Vector fill) {
    std::vector<Vector> out(array.size(), fill);
    const int components = std::min(array.components, static_cast<int>(Vector::length()));
    for (std::size_t i = 0; i < out.size(); ++i)
        for (int c = 0; c < components; ++c)
            out[i][c] = array.values[i * static_cast<std::size_t>(array.components) + static_cast<std::size_t>(c)];
    return out;
}

/// Strips and fans become single triangles. A remainder of fewer than three corners is counted.
std::vector<std::uint32_t> triangles(std::vector<std::uint32_t> order, int mode, std::size_t& unreadable) {
    if (order.size() < 3 || (mode == TINYGLTF_MODE_TRIANGLES && order.size() % 3 != 0)) unreadable += !order.empty();
    if (mode == TINYGLTF_MODE_TRIANGLES) {
        order.resize(order.size() / 3 * 3);
        return order;
    }
    std::vector<std::uint32_t> out;
    for (std::size_t i = 2; i < order.size(); ++i) {
        const bool fan = mode == TINYGLTF_MODE_TRIANGLE_FAN;
        // Every second triangle of a strip is reversed.
        const std::size_t a = fan ? 0 : i - 2 + i % 2, b = fan ? i - 1 : i - 1 - i % 2;
        out.insert(out.end(), {order[a], order[b], order[i]});
    }
    return out;
}

std::string uv_name(const UvUse& use) {
    return "TEXCOORD_" + std::to_string(use.set);
}

UvUse use_of(const GltfDocument& document, const tinygltf::Primitive& primitive, const std::vector<UvUse>& uses,
             const std::string& place) {
    if (primitive.material >= static_cast<int>(uses.size()) || primitive.material < -1)
        refuse(document.file, place + "/material",
               "material " + std::to_string(primitive.material) + " is not in the file");
    return primitive.material >= 0 ? uses[static_cast<std::size_t>(primitive.material)] : UvUse{};
}

/// Once: where its mesh is shown again, its accessors have their bytes. What read_primitive() does not read is not
/// unpacked: a short file may have thousands of names for the same bytes.
void unpack(GltfDocument& document, tinygltf::Primitive& primitive, const UvUse& use, const std::string& place) {
    const tinygltf::ExtensionMap packed = std::exchange(primitive.extensions, {});
    std::erase_if(primitive.attributes, [&](const auto& attribute) {
        const std::string& name = attribute.first;
        const bool of_skin = name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_");
        return name != "POSITION" && name != "NORMAL" && name != "TANGENT" && name != "COLOR_0" &&
               name != uv_name(use) && !(of_skin && !document.skins.empty());
    });
    for (const auto& [name, object] : packed)
        if (const GltfCodec* const codec = find_codec(name); codec != nullptr && codec->decode_primitive != nullptr)
            codec->decode_primitive(document, primitive, object, place);
}

RawPart read_primitive(GltfDocument& document, const tinygltf::Primitive& primitive, const UvUse& use,
                       const std::string& place, std::size_t& unreadable) {
    const int position = attribute(primitive, "POSITION");
    if (position < 0) refuse(document.file, place + "/attributes", "has no POSITION");
    RawPart part;
    part.material = primitive.material;
    const FloatArray positions =
        read_floats(document, position, {.components_low = 3, .components_high = 3, .least = 0, .most = most_elements},
                    place + "/attributes/POSITION");
    const std::size_t count = positions.size();
    part.positions = vectors<glm::vec3>(positions, glm::vec3(0.0f));
    const auto read = [&](const std::string& name, int low, int high) {
        return optional_attribute(document, primitive, name, low, high, count, place);
    };
    part.normals = vectors<glm::vec3>(read("NORMAL", 3, 3), glm::vec3(0.0f));
    part.tangents = vectors<glm::vec4>(read("TANGENT", 4, 4), glm::vec4(0.0f));
    part.colors = vectors<glm::vec4>(read("COLOR_0", 3, 4), glm::vec4(1.0f));
    part.uvs = vectors<glm::vec2>(read(uv_name(use), 2, 2), glm::vec2(0.0f));
    if (use != UvUse{}) {
        for (glm::vec2& uv : part.uvs) uv = use.apply(uv);
        if (use.rotation != 0.0f || use.scale.x * use.scale.y < 0.0f) part.tangents.clear();  // they follow the UVs
    }

    std::vector<std::uint32_t> order;
    if (primitive.indices >= 0) {
        order = read_indices(document, primitive.indices, place + "/indices");
    } else {
        order.resize(count);
        for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<std::uint32_t>(i);
    }
    part.indices = triangles(std::move(order), primitive.mode, unreadable);
    return part;
}

bool draws_triangles(const tinygltf::Primitive& primitive) {
    return primitive.mode >= TINYGLTF_MODE_TRIANGLES && primitive.mode <= TINYGLTF_MODE_TRIANGLE_FAN;
}

/// Warns about parts of the file that the still surface of an organ does not show.
void warn_of_rest(const GltfDocument& document, std::vector<std::string>& warnings) {
    const tinygltf::Model& model = document.model;
    if (model.nodes.empty() && !model.meshes.empty())
        warnings.push_back("the file has no nodes: all its meshes are used, each at its own coordinates");
    const bool morphs = std::any_of(model.meshes.begin(), model.meshes.end(), [](const tinygltf::Mesh& mesh) {
        return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                           [](const tinygltf::Primitive& primitive) { return !primitive.targets.empty(); });
    });
    if (morphs) warnings.push_back("the file has morph targets: the surface is shown without them");
    for (const std::string& name : model.extensionsUsed)
        if (name == "EXT_mesh_gpu_instancing")
            warnings.push_back("EXT_mesh_gpu_instancing is not read: each mesh is shown once");
}

}  // namespace

RawOrgan read_gltf(const std::filesystem::path& path, const std::string& file, const Bytes& bytes) {
    GltfDocument document = read_gltf_document(path, file, bytes);
    RawOrgan organ;
    organ.warnings = std::move(document.warnings);
    warn_of_rest(document, organ.warnings);
    const std::vector<UvUse> uses = read_materials(document, organ);
    std::size_t left_out = 0, total = 0, hidden_nodes = 0;
    std::vector<char> shown(document.model.meshes.size(), 0);
    Skins skins(document);
    for (const MeshInstance& instance : mesh_instances(document)) {
        shown[static_cast<std::size_t>(instance.mesh)] = 1;
        hidden_nodes += instance.hidden;
        if (instance.hidden) continue;
        tinygltf::Mesh& mesh = document.model.meshes[static_cast<std::size_t>(instance.mesh)];
        for (std::size_t i = 0; i < mesh.primitives.size(); ++i) {
            if (!draws_triangles(mesh.primitives[i])) {
                ++left_out;
                continue;
            }
            const std::string place = "/meshes/" + std::to_string(instance.mesh) + "/primitives/" + std::to_string(i);
            const UvUse use = use_of(document, mesh.primitives[i], uses, place);
            unpack(document, mesh.primitives[i], use, place);
            RawPart part = read_primitive(document, mesh.primitives[i], use, place, organ.unreadable);
            part.name = !mesh.name.empty() ? mesh.name : instance.node;
            total += part.indices.size() / 3;
            if (total > maximum_triangles) refuse(file, "", "has more than 20 million triangles");
            if (instance.skin < 0 || !skins.pose(instance.skin, mesh.primitives[i], place, part))
                transform(part, instance.to_world);
            organ.parts.push_back(std::move(part));
        }
    }
    organ.files.insert(organ.files.begin(), document.files.begin(), document.files.end());
    if (skins.any())
        organ.warnings.push_back(
            std::string("the file has a skeleton: the surface is shown ") +
            (skins.moved() ? "in the pose that its joints have in the file" : "as it was modelled"));
    if (organ.unreadable > 0)
        organ.warnings.push_back(counted(organ.unreadable, "primitive ends", "primitives end") +
                                 " within a triangle, which is left out");
    const auto hidden = static_cast<std::size_t>(std::count(shown.begin(), shown.end(), 0));
    if (hidden > 0) organ.warnings.push_back(counted(hidden, "mesh is", "meshes are") + " not in the scene; left out");
    if (hidden_nodes > 0)
        organ.warnings.push_back(counted(hidden_nodes, "node is", "nodes are") +
                                 " hidden in the file (KHR_node_visibility); left out with " +
                                 (hidden_nodes == 1 ? "its mesh" : "their meshes"));
    organ.holds = shown.empty() ? "no mesh"
                  : hidden_nodes > 0 && organ.parts.empty()
                      ? counted(hidden_nodes, "mesh", "meshes") + " in hidden nodes only"
                  : left_out > 0 ? counted(left_out, "primitive", "primitives") + " of points or lines only"
                  : hidden > 0   ? counted(hidden, "mesh", "meshes") + ", none in the scene"
                                 : "no surface";
    if (left_out > 0)
        organ.warnings.push_back(counted(left_out, "primitive", "primitives") + " of points or lines left out");
    return organ;
}

}  // namespace lapfx::organ
