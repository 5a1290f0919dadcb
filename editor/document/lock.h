// A file that only one process at a time can hold. The kernel releases it when the process ends, however it ends.
//
//     if (const auto lock = Lock::take(lock_file(folders.state, document), "...")) edit(document);
//     else tell("is open in another editor (" + holder_of(...) + ")");
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lapfx::document {

class Lock {
  public:
    /// Makes the file and its folder where they are missing. Returns nothing when another process holds it. Throws
    /// Error (runtime) when the file cannot be made or opened.
    static std::optional<Lock> take(const std::filesystem::path& file);

    Lock(Lock&& other) noexcept;
    Lock& operator=(Lock&& other) noexcept;
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
    /// Releases the lock and removes the file.
    ~Lock();

    const std::filesystem::path& file() const { return file_; }

  private:
    Lock(int descriptor, std::filesystem::path file) : descriptor_(descriptor), file_(std::move(file)) {}
    void release() noexcept;

    int descriptor_ = -1;
    std::filesystem::path file_;
};

/// The lock file of a document. It is the same for all spellings of the document's path.
std::filesystem::path lock_file(const std::filesystem::path& state_folder, const std::filesystem::path& document);

/// The process that holds a lock, as it wrote itself into the file: "process 4711 on theatre-2". Empty if the file
/// cannot be read or contains something else.
std::string holder_of(const std::filesystem::path& lock_file);

}  // namespace lapfx::document
