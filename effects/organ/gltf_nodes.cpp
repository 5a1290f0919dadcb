#include "organ/gltf_nodes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

namespace lapfx::organ {

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
            if (index >= 0 && static_cast<std::size_t>(index) < child.size())
                child[static_cast<std::size_t>(index)] = true;
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

bool is_hidden(const tinygltf::Node& node) {
    const auto found = node.extensions.find("KHR_node_visibility");
    if (found == node.extensions.end() || !found->second.IsObject() || !found->second.Has("visible")) return false;
    const tinygltf::Value& visible = found->second.Get("visible");
    return visible.IsBool() && !visible.Get<bool>();
}

struct Visit {
    int node;
    std::size_t depth;
    glm::dmat4 parent;
    bool hidden;
};

/// A node may have several parents (the specification forbids it, but viewers show it at each), so a short file can
/// describe an enormous number of places.
constexpr std::size_t most_visits = 1'000'000;

class Walk {
  public:
    explicit Walk(const GltfDocument& document) : document_(document), model_(document.model) {}

    std::vector<MeshInstance> run() {
        push(start_nodes(document_), {.node = -1, .depth = 1, .parent = glm::dmat4(1.0), .hidden = false});
        for (std::size_t visits = 0; !stack_.empty(); ++visits) {
            if (visits == most_visits) refuse(document_.file, "/nodes", "lead to more than a million instances");
            const Visit visit = stack_.back();
            stack_.pop_back();
            enter(visit);
        }
        return std::move(instances_);
    }

  private:
    /// The last one first, so that they leave the stack in order.
    void push(const std::vector<int>& nodes, Visit visit) {
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            visit.node = *node;
            stack_.push_back(visit);
        }
    }

    void enter(const Visit& visit) {
        if (visit.node < 0 || static_cast<std::size_t>(visit.node) >= model_.nodes.size())
            refuse(document_.file, "/nodes", "node " + std::to_string(visit.node) + " is not in the file");
        const std::string place = "/nodes/" + std::to_string(visit.node);
        if (visit.depth > model_.nodes.size()) refuse(document_.file, place, "is its own ancestor");
        const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(visit.node)];
        const glm::dmat4 matrix = visit.parent * local_matrix(node, visit.node, document_.file);
        if (node.mesh >= static_cast<int>(model_.meshes.size()) || node.mesh < -1)
            refuse(document_.file, place + "/mesh", "mesh " + std::to_string(node.mesh) + " is not in the file");
        const bool hidden = visit.hidden || is_hidden(node);
        if (node.mesh >= 0)
            instances_.push_back(
                {.mesh = node.mesh, .node = node.name, .to_world = matrix, .skin = node.skin, .hidden = hidden});
        push(node.children, {.node = -1, .depth = visit.depth + 1, .parent = matrix, .hidden = hidden});
    }

    const GltfDocument& document_;
    const tinygltf::Model& model_;
    std::vector<Visit> stack_;  // a list, not recursion: a chain of nodes may be as long as the file
    std::vector<MeshInstance> instances_;
};

}  // namespace

std::vector<MeshInstance> mesh_instances(const GltfDocument& document) {
    if (!document.model.nodes.empty()) return Walk(document).run();
    std::vector<MeshInstance> instances;
    for (std::size_t i = 0; i < document.model.meshes.size(); ++i)
        instances.push_back({.mesh = static_cast<int>(i), .node = document.model.meshes[i].name});
    return instances;
}

std::vector<glm::dmat4> node_places(const GltfDocument& document) {
    const std::vector<tinygltf::Node>& nodes = document.model.nodes;
    constexpr int none = -1;
    std::vector<int> parent(nodes.size(), none);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const int child : nodes[i].children)
            if (child >= 0 && static_cast<std::size_t>(child) < nodes.size())
                parent[static_cast<std::size_t>(child)] = static_cast<int>(i);
    std::vector<glm::dmat4> places(nodes.size(), glm::dmat4(1.0));
    std::vector<char> known(nodes.size(), 0);
    std::vector<int> up;  // from a node to the first that is known
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
        up.clear();
        int node = i;
        for (; node != none && !known[static_cast<std::size_t>(node)]; node = parent[static_cast<std::size_t>(node)]) {
            if (up.size() == nodes.size())
                refuse(document.file, "/nodes/" + std::to_string(node), "is its own ancestor");
            up.push_back(node);
        }
        for (; !up.empty(); node = up.back(), up.pop_back()) {
            const auto below = static_cast<std::size_t>(up.back());
            const glm::dmat4 above = node == none ? glm::dmat4(1.0) : places[static_cast<std::size_t>(node)];
            places[below] = above * local_matrix(nodes[below], up.back(), document.file);
            known[below] = 1;
        }
    }
    return places;
}

}  // namespace lapfx::organ
