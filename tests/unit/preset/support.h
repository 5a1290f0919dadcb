// Shared by the tests of documents.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "lapfx/error.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"

namespace lapfx::test {

/// Lines "FILE: PLACE: REASON" of the error that `run` throws; empty when it throws none.
template <class Run>
std::vector<std::string> faults_of(Run run, Failure expected = Failure::bad_input) {
    std::vector<std::string> lines;
    try {
        run();
    } catch (const Error& error) {
        EXPECT_EQ(error.failure(), expected) << error.what();
        for (const Fault& fault : error.faults()) lines.push_back(fault.text());
    }
    return lines;
}

inline std::vector<std::string> preset_faults(const std::string& json) {
    return faults_of([&] { parse_preset(json, "p.json"); });
}

inline std::vector<std::string> scene_faults(const std::string& json) {
    return faults_of([&] { parse_scene(json, "s.json"); });
}

/// A preset document around its members, which start with a comma or are empty.
inline std::string preset_text(const std::string& members = "") {
    return R"({"format": "lapfx.preset", "version": 1)" + members + "}";
}

/// A scene document around its members, which start with a comma or are empty.
inline std::string scene_text(const std::string& members = R"(, "organ": {"file": "o.ply"})") {
    return R"({"format": "lapfx.scene", "version": 1)" + members + "}";
}

inline std::string read_text(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A temporary folder for a test, removed at its end.
class Folder {
  public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "lapfx-test-XXXXXX").string();
        if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
        path_ = name;
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::permissions(path_, std::filesystem::perms::owner_all, ignored);
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(path_ / name, std::ios::binary) << text;
        return path_ / name;
    }

  private:
    std::filesystem::path path_;
};

/// Calls visit(row, owner, pointer) for every row of a document, lists with their elements.
template <class Visit>
void for_each_row(const Table& table, void* owner, const Visit& visit, const std::string& pointer = "") {
    for (const Parameter& row : table.rows) visit(row, owner, pointer + '/' + std::string(row.key));
    for (const Table& child : table.tables) {
        void* member = child.member(owner);
        const std::string inner = pointer + '/' + std::string(child.key);
        if (!child.list) {
            for_each_row(child, member, visit, inner);
            continue;
        }
        for (std::size_t i = 0; i < child.list->size(member); ++i)
            for_each_row(child, child.list->at(member, i), visit, inner + '/' + std::to_string(i));
    }
}

/// A preset with two clips, so that every row is there.
inline Preset full_preset() {
    Preset preset;
    preset.name = "Full";
    preset.smoke.clips = {{.file = "a.mp4", .own_keying = true}, {.file = "smoke/b.mp4", .own_keying = true}};
    return preset;
}

inline Scene full_scene() {
    Scene scene;
    scene.organ.file = "../organ.ply";
    scene.events = {{}, {.action = ToolAction::tear, .time = 2.0}};
    scene.curves = {.cautery_power = {{1.0, 0.5}}, .bleeding_strength = {{0.5, 2.0}}, .emission = {{3.0, 1.5}}};
    scene.reference.regions = {{.x = 0.1, .y = 0.2, .width = 0.3, .height = 0.4}};
    scene.reference.measure.parts = {{.corners = {{0.1, 0.1}, {0.2, 0.1}, {0.1, 0.3}}}};
    return scene;
}

}  // namespace lapfx::test
