// Distinguishes a file from another one under the same name.
#pragma once

#include <cstdint>
#include <filesystem>

namespace lapfx::media {

/// For numbered pictures ("plume_%04d.png"), whose name is not a file, it is the stamp of their folder.
struct FileStamp {
    std::uint64_t device = 0, inode = 0, bytes = 0;
    std::int64_t written = 0;  ///< ns

    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// All 0 when there is neither file nor folder.
FileStamp stamp_of(const std::filesystem::path& path);

}  // namespace lapfx::media
