// A new folder for what a benchmark needs on the disk; it goes with the object.
#pragma once

#include <filesystem>

namespace lapfx::bench {

class ScratchFolder {
  public:
    /// Throws Error (runtime) when it cannot be made.
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace lapfx::bench
