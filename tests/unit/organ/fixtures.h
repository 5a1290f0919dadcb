// Small files for the tests of the organ loaders, and the path of the folder of real ones.
#pragma once

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "lapfx/error.h"
#include "lapfx/organ.h"
#include "support/folders.h"

namespace lapfx::test {

namespace fs = std::filesystem;

/// A temporary folder for each test, removed at its end.
class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "lapfx-organ-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~TemporaryFolder() { fs::remove_all(path_); }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    fs::path write(const std::string& name, const std::string& content) const {
        std::ofstream(path_ / name, std::ios::binary) << content;
        return path_ / name;
    }
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

/// The text of the one fault that loading throws; "" when it does not throw.
inline std::string fault_of(const fs::path& file, const OrganOptions& options = {}) {
    try {
        load_organ(file, options);
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), Failure::bad_input);
        EXPECT_EQ(error.faults().size(), 1u);
        EXPECT_EQ(error.faults().front().file, file.string());
        EXPECT_EQ(error.faults().front().text().find('\n'), std::string::npos);
        const Fault& fault = error.faults().front();
        return fault.place.empty() ? fault.reason : fault.place + ": " + fault.reason;
    }
    return {};
}

inline bool has_warning(const std::vector<std::string>& warnings, const std::string& text) {
    for (const std::string& warning : warnings)
        if (warning.find(text) != std::string::npos) return true;
    return false;
}

/// Bytes of numbers, as in a glTF buffer.
template <class T>
std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

inline std::string word(std::uint32_t value) {
    return bytes_of<std::uint32_t>({value});
}

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

/// A cube of 10 mm from 0 to 10 as OBJ, outwards.
constexpr const char* cube_obj =
    "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 0 0 10\nv 10 0 10\nv 10 10 10\nv 0 10 10\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// The folder of real meshes, which is not part of the project; empty when it is missing.
inline fs::path data_folder() {
    const char* given = std::getenv("LAPFX_TEST_DATA");
    const fs::path folder = given ? fs::path(given) : source_folder() / ".." / "shared" / "data";
    return fs::is_directory(folder / "organs") ? folder : fs::path();
}

/// The signed volume; above 0 when the triangles face outwards.
inline double volume(const Organ& organ) {
    double sum = 0.0;
    for (std::size_t i = 0; i < organ.indices.size(); i += 3) {
        const glm::dvec3 a(organ.positions[organ.indices[i]]), b(organ.positions[organ.indices[i + 1]]),
            c(organ.positions[organ.indices[i + 2]]);
        sum += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sum;
}

}  // namespace lapfx::test
