#include "media/file_stamp.h"

#include <sys/stat.h>

namespace lapfx::media {

FileStamp stamp_of(const std::filesystem::path& path) {
    struct stat found {};
    const bool is_file = ::stat(path.c_str(), &found) == 0;
    if (!is_file && ::stat(path.parent_path().c_str(), &found) != 0) return {};
    constexpr std::int64_t second = 1'000'000'000;
    return {.device = found.st_dev,
            .inode = found.st_ino,
            .bytes = is_file ? static_cast<std::uint64_t>(found.st_size) : 0,
            .written = found.st_mtim.tv_sec * second + found.st_mtim.tv_nsec};
}

}  // namespace lapfx::media
