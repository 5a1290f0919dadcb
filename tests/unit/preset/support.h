// Shared by the tests of documents, and by all that need a folder for a while.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "lapfx/error.h"

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

}  // namespace lapfx::test
