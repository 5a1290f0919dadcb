#include "organ/gltf_nodes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace lapfx::mesh {

namespace {

void check_length(const std::vector<double>& values, std::size_t wanted, const char* key, int node,
                  const std::string& file) {
    if (!values.empty() && values.size() != wanted)
        refuse(file, "/nodes/" + std::to_string(node) + "/" + key,
               "has " + std::to_string(values.size()) + " numbers, expected " + std::to_string(wanted));
}

glm::dmat4 local_matrix(const tinygltf::Node& node, int index, const std::string& file) {
    check_length(node.matrix, 16, "matrix", index, file);
    check_length(node.translation, 3, "translation", index, file);
    check_length(node.rotation, 4, "rotation", index, file);
    check_length(node.scale, 3, "scale", index, file);
    glm::dmat4 matrix(1.0);
    if (!node.matrix.empty()) {
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return matrix;
    }
    if (!node.translation.empty())
        matrix = glm::translate(matrix, {node.translation[0], node.translation[1], node.translation[2]});
    if (!node.rotation.empty()) {
        const glm::dquat rotation(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
        if (glm::length(rotation) > 1e-12) matrix *= glm::mat4_cast(glm::normalize(rotation));
    }
    if (!node.scale.empty()) matrix = glm::scale(matrix, {node.scale[0], node.scale[1], node.scale[2]});
    return matrix;
}

/// The nodes that no other node has as a child.
std::vector<int> root_nodes(const tinygltf::Model& model) {
    std::vector<bool> child(model.nodes.size(), false);
    for (const tinygltf::Node& node : model.nodes)
        for (const int index : node.children)
            if (index >= 0 && static_cast<std::size_t>(index) < child.size()) child[static_cast<std::size_t>(index)] = true;
    std::vector<int> roots;
    for (std::size_t i = 0; i < child.size(); ++i)
        if (!child[i]) roots.push_back(static_cast<int>(i));
    return roots;
}

std::vector<int> start_nodes(const GltfDocument& document) {
    const tinygltf::Model& model = document.model;
    if (model.defaultScene >= static_cast<int>(model.scenes.size()) || model.defaultScene < -1)
        refuse(document.file, "/scene", "scene " + std::to_string(model.defaultScene) + " is not in the file");
    if (model.scenes.empty()) return root_nodes(model);
    return model.scenes[static_cast<std::size_t>(std::max(model.defaultScene, 0))].nodes;
}

struct Visit {
    int node;
    glm::dmat4 parent;
};

}  // namespace

std::vector<MeshInstance> mesh_instances(const GltfDocument& document) {
    const tinygltf::Model& model = document.model;
    std::vector<MeshInstance> instances;
    if (model.nodes.empty()) {
        for (std::size_t i = 0; i < model.meshes.size(); ++i)
            instances.push_back({static_cast<int>(i), model.meshes[i].name, glm::dmat4(1.0)});
        return instances;
    }
    std::vector<bool> seen(model.nodes.size(), false);
    std::vector<Visit> stack;  // a list, not recursion: a chain of nodes may be as long as the file
    const auto push = [&](const std::vector<int>& nodes, const glm::dmat4& parent) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) stack.push_back({*node, parent});
    };
    push(start_nodes(document), glm::dmat4(1.0));
    while (!stack.empty()) {
        const Visit visit = stack.back();
        stack.pop_back();
        if (visit.node < 0 || static_cast<std::size_t>(visit.node) >= model.nodes.size())
            refuse(document.file, "/nodes", "node " + std::to_string(visit.node) + " is not in the file");
        const auto index = static_cast<std::size_t>(visit.node);
        const tinygltf::Node& node = model.nodes[index];
        if (seen[index])
            refuse(document.file, "/nodes/" + std::to_string(visit.node), "is reached twice: nodes must form trees");
        seen[index] = true;
        const glm::dmat4 matrix = visit.parent * local_matrix(node, visit.node, document.file);
        if (node.mesh >= static_cast<int>(model.meshes.size()) || node.mesh < -1)
            refuse(document.file, "/nodes/" + std::to_string(visit.node) + "/mesh",
                   "mesh " + std::to_string(node.mesh) + " is not in the file");
        if (node.mesh >= 0) instances.push_back({node.mesh, node.name, matrix});
        push(node.children, matrix);
    }
    return instances;
}

}  // namespace lapfx::mesh
