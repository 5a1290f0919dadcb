// A file that one process at a time holds. The kernel lets go of it when the process ends, however it ends.
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
    /// Makes the file and its folder where they are missing. Nothing: someone else holds it. Throws Error (runtime)
    /// when it can be neither made nor opened.
    static std::optional<Lock> take(const std::filesystem::path& file);

    Lock(Lock&& other) noexcept;
    Lock& operator=(Lock&& other) noexcept;
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;
    /// Lets go, and takes the file away.
    ~Lock();

    const std::filesystem::path& file() const { return file_; }

  private:
    Lock(int descriptor, std::filesystem::path file) : descriptor_(descriptor), file_(std::move(file)) {}
    void release() noexcept;

    int descriptor_ = -1;
    std::filesystem::path file_;
};

/// The lock of a document: the same however its path is spelled.
std::filesystem::path lock_file(const std::filesystem::path& state_folder, const std::filesystem::path& document);

/// Who wrote itself into a lock: "process 4711 on theatre-2". Empty: nobody that can be read.
std::string holder_of(const std::filesystem::path& lock_file);

}  // namespace lapfx::document
