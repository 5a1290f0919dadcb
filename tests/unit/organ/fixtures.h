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
