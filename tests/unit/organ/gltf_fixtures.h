// glTF files for the tests, made from JSON.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "unit/organ/fixtures.h"

namespace lapfx::test {

/// A .glb with a JSON and one binary chunk.
inline std::string glb(const nlohmann::json& json, std::string binary) {
    std::string text = json.dump();
    while (text.size() % 4 != 0) text += ' ';
    while (binary.size() % 4 != 0) binary += '\0';
    std::string body = word(static_cast<std::uint32_t>(text.size())) + "JSON" + text;
    if (!binary.empty()) body += word(static_cast<std::uint32_t>(binary.size())) + std::string("BIN\0", 4) + binary;
    return "glTF" + word(2) + word(static_cast<std::uint32_t>(12 + body.size())) + body;
}

/// One right-angled triangle in the xy plane, counter-clockwise from +z, legs of 0.1 m; no indices.
struct Triangle {
    nlohmann::json json = nlohmann::json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"name": "t", "primitives": [{"attributes": {"POSITION": 0}}]}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36}],
        "buffers": [{"byteLength": 36}]})");
    std::string binary = bytes_of<float>({0, 0, 0, 0.1f, 0, 0, 0, 0.1f, 0});

    /// Appends bytes as a new buffer view and returns its index.
    int add_view(const std::string& bytes) {
        while (binary.size() % 4 != 0) binary += '\0';
        json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
        binary += bytes;
        json["buffers"][0]["byteLength"] = binary.size();
        return static_cast<int>(json["bufferViews"].size()) - 1;
    }
    int add_accessor(const std::string& bytes, int type, int count, const char* shape, bool normalized = false) {
        json["accessors"].push_back({{"bufferView", add_view(bytes)},
                                     {"componentType", type},
                                     {"count", count},
                                     {"type", shape},
                                     {"normalized", normalized}});
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    nlohmann::json& primitive() { return json["meshes"][0]["primitives"][0]; }
    std::string file() const { return glb(json, binary); }
};

}  // namespace lapfx::test
