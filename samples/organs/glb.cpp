#include "glb.h"

#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace organs {
namespace {

/// Appends to the model's single buffer, and gives the offset.
int add_view(tinygltf::Model& model, const void* bytes, std::size_t size, int target) {
    std::vector<unsigned char>& data = model.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = size;
    view.target = target;
    data.resize(data.size() + size);
    std::memcpy(data.data() + view.byteOffset, bytes, size);
    model.bufferViews.push_back(view);
    return static_cast<int>(model.bufferViews.size()) - 1;
}

int add_accessor(tinygltf::Model& model, int view, int component, int type, std::size_t count) {
    tinygltf::Accessor accessor;
    accessor.bufferView = view;
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = count;
    model.accessors.push_back(accessor);
    return static_cast<int>(model.accessors.size()) - 1;
}

int add_floats(tinygltf::Model& model, const std::vector<float>& values, int type, std::size_t width) {
    const int view = add_view(model, values.data(), values.size() * sizeof(float), TINYGLTF_TARGET_ARRAY_BUFFER);
    return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, type, values.size() / width);
}

int add_positions(tinygltf::Model& model, const std::vector<dvec3>& positions) {
    std::vector<float> values;
    std::vector<double> low(3, std::numeric_limits<double>::max());
    std::vector<double> high(3, std::numeric_limits<double>::lowest());
    for (const dvec3& p : positions) {
        for (int axis = 0; axis < 3; ++axis) {
            const float metres = static_cast<float>(p[axis] * 0.001);
            values.push_back(metres);
            const std::size_t i = static_cast<std::size_t>(axis);
            low[i] = std::min(low[i], static_cast<double>(metres));
            high[i] = std::max(high[i], static_cast<double>(metres));
        }
    }
    const int accessor = add_floats(model, values, TINYGLTF_TYPE_VEC3, 3);
    model.accessors.back().minValues = low;
    model.accessors.back().maxValues = high;
    return accessor;
}

int add_vectors(tinygltf::Model& model, const std::vector<dvec3>& vectors, bool with_sign) {
    std::vector<float> values;
    for (const dvec3& v : vectors) {
        for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<float>(v[axis]));
        if (with_sign) values.push_back(1.0f);
    }
    return with_sign ? add_floats(model, values, TINYGLTF_TYPE_VEC4, 4)
                     : add_floats(model, values, TINYGLTF_TYPE_VEC3, 3);
}

int add_uvs(tinygltf::Model& model, const std::vector<dvec2>& uvs) {
    std::vector<float> values;
    for (const dvec2& uv : uvs) {
        values.push_back(static_cast<float>(uv.x));
        values.push_back(static_cast<float>(uv.y));
    }
    return add_floats(model, values, TINYGLTF_TYPE_VEC2, 2);
}

/// Gaps lose blue and green before red, because light reaches them through tissue.
int add_colors(tinygltf::Model& model, const std::vector<double>& light) {
    std::vector<std::uint16_t> values;
    const auto code = [](double x) { return static_cast<std::uint16_t>(std::lround(clamp01(x) * 65535.0)); };
    for (const double open : light) {
        values.insert(values.end(),
                      {code(std::pow(open, 0.7)), code(std::pow(open, 1.35)), code(std::pow(open, 1.5)), 65535});
    }
    const int view = add_view(model, values.data(), values.size() * 2, TINYGLTF_TARGET_ARRAY_BUFFER);
    const int accessor =
        add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_VEC4, light.size());
    model.accessors.back().normalized = true;
    return accessor;
}

int add_indices(tinygltf::Model& model, const Mesh& mesh) {
    if (mesh.positions.size() > 65535) {
        const int view =
            add_view(model, mesh.indices.data(), mesh.indices.size() * 4, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
        return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                            mesh.indices.size());
    }
    const std::vector<std::uint16_t> values(mesh.indices.begin(), mesh.indices.end());
    const int view = add_view(model, values.data(), values.size() * 2, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, values.size());
}

int add_texture(tinygltf::Model& model, const std::string& name, const std::vector<std::uint8_t>& jpeg) {
    if (jpeg.empty()) return -1;
    tinygltf::Image image;
    image.name = name;
    image.bufferView = add_view(model, jpeg.data(), jpeg.size(), 0);
    image.mimeType = "image/jpeg";
    model.images.push_back(image);
    tinygltf::Texture texture;
    texture.sampler = 0;
    texture.source = static_cast<int>(model.images.size()) - 1;
    model.textures.push_back(texture);
    return static_cast<int>(model.textures.size()) - 1;
}

int add_material(tinygltf::Model& model, const Surface& surface) {
    tinygltf::Material material;
    material.name = surface.name;
    material.doubleSided = surface.double_sided;
    tinygltf::PbrMetallicRoughness& look = material.pbrMetallicRoughness;
    look.baseColorFactor = {surface.color.x, surface.color.y, surface.color.z, 1.0};
    look.roughnessFactor = surface.roughness;
    look.metallicFactor = surface.metallic;
    look.baseColorTexture.index = add_texture(model, surface.name + " colour", surface.color_jpeg);
    material.normalTexture.index = add_texture(model, surface.name + " normal", surface.normal_jpeg);
    material.normalTexture.scale = surface.normal_scale;
    model.materials.push_back(material);
    return static_cast<int>(model.materials.size()) - 1;
}

void add_surface(tinygltf::Model& model, const Surface& surface) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = add_material(model, surface);
    primitive.indices = add_indices(model, surface.mesh);
    primitive.attributes["POSITION"] = add_positions(model, surface.mesh.positions);
    primitive.attributes["NORMAL"] = add_vectors(model, surface.mesh.normals, false);
    primitive.attributes["TANGENT"] = add_vectors(model, surface.mesh.tangents, true);
    primitive.attributes["TEXCOORD_0"] = add_uvs(model, surface.mesh.uvs);
    primitive.attributes["COLOR_0"] = add_colors(model, surface.mesh.light);
    tinygltf::Mesh mesh;
    mesh.name = surface.name;
    mesh.primitives.push_back(primitive);
    model.meshes.push_back(mesh);
    tinygltf::Node node;
    node.name = surface.name;
    node.mesh = static_cast<int>(model.meshes.size()) - 1;
    model.nodes.push_back(node);
    model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()) - 1);
}

void check(const std::filesystem::path& path) {
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error;
    std::string warning;
    if (!loader.LoadBinaryFromFile(&model, &error, &warning, path.string()) || !warning.empty()) {
        throw std::runtime_error(path.string() + ": does not load again: " + error + warning);
    }
    for (const tinygltf::Image& image : model.images) {
        if (image.width <= 0) throw std::runtime_error(path.string() + ": " + image.name + " does not decode");
    }
}

}  // namespace

void write_glb(const std::filesystem::path& path, const std::string& name, const std::vector<Surface>& surfaces) {
    tinygltf::Model model;
    model.asset.version = "2.0";
    model.asset.generator = "lapfx sample organs";
    model.buffers.emplace_back();
    model.scenes.emplace_back();
    model.scenes[0].name = name;
    model.defaultScene = 0;
    tinygltf::Sampler sampler;
    sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.wrapS = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    for (const Surface& surface : surfaces) {
        if (model.samplers.empty() && !surface.color_jpeg.empty()) model.samplers.push_back(sampler);
        add_surface(model, surface);
    }
    tinygltf::TinyGLTF writer;
    if (!writer.WriteGltfSceneToFile(&model, path.string(), true, true, false, true)) {
        throw std::runtime_error(path.string() + ": cannot be written");
    }
    check(path);
    std::size_t triangles = 0;
    for (const Surface& surface : surfaces) triangles += surface.mesh.indices.size() / 3;
    std::cout << path.string() << ": " << surfaces.size() << " parts, " << triangles << " triangles, "
              << std::filesystem::file_size(path) << " bytes\n";
}

}  // namespace organs
