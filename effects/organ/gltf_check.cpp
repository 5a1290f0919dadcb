#include "organ/gltf_check.h"

#include <nlohmann/json.hpp>

#include "organ/raw.h"

namespace lapfx::organ {

namespace {

using nlohmann::json;

/// Members that are whole numbers everywhere in the parts that an organ is read from.
constexpr std::string_view whole_numbers[] = {
    "buffer",   "bufferView", "byteLength", "byteOffset", "byteStride", "componentType", "count",
    "material", "mesh",       "mode",       "scene",      "source",     "skin",          "inverseBindMatrices",
    "sampler",  "wrapS",      "wrapT",      "magFilter",  "minFilter"};

std::string shown(const json& value) {
    const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    return text.size() > 40 ? text.substr(0, 40) + "..." : text;
}

/// parse() has converted floats with whole values to integers.
void check_number(const json& value, const std::string& place, const std::string& file) {
    if (!value.is_number_integer()) refuse(file, place, "is " + shown(value) + ", expected a whole number");
}

void check_members(const json& object, const std::string& place, const std::string& file) {
    if (!object.is_object()) refuse(file, place, "is " + shown(object) + ", expected an object");
    for (const std::string_view key : whole_numbers)
        if (const auto found = object.find(key); found != object.end() && !found->is_null())
            check_number(*found, place + "/" + std::string(key), file);
}

void check_there(const json& object, std::initializer_list<const char*> keys, const std::string& place,
                 const std::string& file) {
    for (const char* key : keys)
        if (!object.contains(key)) refuse(file, place + "/" + key, "is missing");
}

const json& list(const json& object, const char* key, const std::string& place, const std::string& file) {
    static const json none = json::array();
    const auto found = object.find(key);
    if (found == object.end()) return none;
    if (!found->is_array()) refuse(file, place + "/" + key, "is not an array");
    return *found;
}

void check_indices(const json& object, const char* key, const std::string& place, const std::string& file) {
    std::size_t i = 0;
    for (const json& index : list(object, key, place, file))
        check_number(index, place + "/" + key + "/" + std::to_string(i++), file);
}

void check_sparse(const json& accessor, const std::string& place, const std::string& file) {
    const auto sparse = accessor.find("sparse");
    if (sparse == accessor.end()) return;
    check_members(*sparse, place + "/sparse", file);
    for (const char* key : {"indices", "values"})
        if (const auto part = sparse->find(key); part != sparse->end())
            check_members(*part, place + "/sparse/" + key, file);
}

void check_primitives(const json& mesh, const std::string& place, const std::string& file) {
    std::size_t i = 0;
    for (const json& primitive : list(mesh, "primitives", place, file)) {
        const std::string at = place + "/primitives/" + std::to_string(i++);
        check_members(primitive, at, file);
        if (const auto indices = primitive.find("indices"); indices != primitive.end())
            check_number(*indices, at + "/indices", file);
        check_there(primitive, {"attributes"}, at, file);
        const auto attributes = primitive.find("attributes");
        if (!attributes->is_object())
            refuse(file, at + "/attributes", "is " + shown(*attributes) + ", expected an object");
        for (const auto& [name, index] : attributes->items()) check_number(index, at + "/attributes/" + name, file);
    }
}

/// Checks the references of a material, and removes impossible ones.
class MaterialMender {
  public:
    MaterialMender(json& material, std::string place, std::vector<std::string>& warnings)
        : material_(material), place_(std::move(place)), warnings_(warnings) {}

    void mend() {
        texture(material_, "normalTexture", place_);
        if (json* pbr = object(material_, "pbrMetallicRoughness", place_))
            texture(*pbr, "baseColorTexture", place_ + "/pbrMetallicRoughness");
        if (json* extensions = object(material_, "extensions", place_)) {
            const std::string at = place_ + "/extensions";
            if (json* old = object(*extensions, "KHR_materials_pbrSpecularGlossiness", at))
                texture(*old, "diffuseTexture", at + "/KHR_materials_pbrSpecularGlossiness");
        }
    }

  private:
    /// A member that has to be an object; null when there is none.
    json* object(json& parent, const char* key, const std::string& place) {
        const auto found = parent.find(key);
        if (found == parent.end()) return nullptr;
        if (found->is_object()) return &*found;
        take_out(parent, key, place + "/" + key, "is " + shown(*found) + ", expected an object");
        return nullptr;
    }

    void texture(json& parent, const char* key, const std::string& place) {
        json* use = object(parent, key, place);
        if (!use) return;
        const std::string at = place + "/" + key;
        const auto index = use->find("index");
        if (index == use->end()) return take_out(parent, key, at, "has no index");
        if (!index->is_number_unsigned())
            return take_out(parent, key, at + "/index", "is " + shown(*index) + ", expected a whole number from 0");
        if (const auto set = use->find("texCoord"); set != use->end() && !set->is_number_unsigned())
            take_out(*use, "texCoord", at + "/texCoord", "is " + shown(*set) + ", expected a whole number from 0");
        for (const char* number : {"scale", "strength"})
            if (const auto value = use->find(number); value != use->end() && !value->is_number())
                take_out(*use, number, at + "/" + number, "is " + shown(*value) + ", expected a number");
        if (json* extensions = object(*use, "extensions", at))
            object(*extensions, "KHR_texture_transform", at + "/extensions");
    }

    void take_out(json& parent, const char* key, const std::string& place, const std::string& what) {
        warnings_.push_back(place + " " + what + "; left out");
        parent.erase(key);
    }

    json& material_;
    std::string place_;
    std::vector<std::string>& warnings_;
};

}  // namespace

void check_structure(const json& document, const std::string& file) {
    check_members(document, "", file);
    const auto each = [&](const char* key, const auto& check) {
        std::size_t i = 0;
        for (const json& entry : list(document, key, "", file)) {
            const std::string place = std::string("/") + key + "/" + std::to_string(i++);
            check_members(entry, place, file);
            check(entry, place);
        }
    };
    const auto nothing_else = [](const json&, const std::string&) {};
    for (const char* key : {"buffers", "images", "samplers", "textures"}) each(key, nothing_else);
    each("bufferViews", [&](const json& entry, const std::string& place) {
        check_there(entry, {"buffer", "byteLength"}, place, file);
    });
    each("accessors", [&](const json& entry, const std::string& place) {
        check_there(entry, {"componentType", "count", "type"}, place, file);
        check_sparse(entry, place, file);
    });
    each("meshes", [&](const json& entry, const std::string& place) { check_primitives(entry, place, file); });
    each("nodes", [&](const json& entry, const std::string& place) { check_indices(entry, "children", place, file); });
    each("skins", [&](const json& entry, const std::string& place) { check_indices(entry, "joints", place, file); });
    each("scenes", [&](const json& entry, const std::string& place) { check_indices(entry, "nodes", place, file); });
    list(document, "materials", "", file);
}

void mend_materials(json& document, std::vector<std::string>& warnings) {
    const auto materials = document.find("materials");
    if (materials == document.end()) return;
    std::size_t i = 0;
    for (json& material : *materials) {
        const std::string place = "/materials/" + std::to_string(i++);
        if (material.is_object()) {
            MaterialMender(material, place, warnings).mend();
        } else {
            warnings.push_back(place + " is " + shown(material) + ", expected an object; left out");
            material = json::object();  // the numbers of the others stay
        }
    }
}

}  // namespace lapfx::organ
