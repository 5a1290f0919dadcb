// Memory of one frame: taken in steps, given back all at once. Keeps its blocks, so a steady frame allocates nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <new>
#include <string_view>
#include <type_traits>
#include <vector>

namespace lapfx::ui {

class Arena {
  public:
    void* take(std::size_t bytes, std::size_t alignment = alignof(std::max_align_t)) {
        const std::uintptr_t at = (cursor_ + alignment - 1) & ~std::uintptr_t{alignment - 1};
        if (at + bytes > limit_) [[unlikely]]
            return next_block(bytes);
        cursor_ = at + bytes;
        return reinterpret_cast<void*>(at);
    }
    template <typename T>
    T* make(const T& value) {
        static_assert(std::is_trivially_destructible_v<T>, "nothing in an arena is destroyed");
        return new (take(sizeof(T), alignof(T))) T(value);
    }
    std::string_view copy(std::string_view text) {
        if (text.empty()) return {};
        char* to = static_cast<char*>(take(text.size(), 1));
        std::memcpy(to, text.data(), text.size());
        return {to, text.size()};
    }
    void reset() {
        block_ = 0;
        if (!blocks_.empty()) enter(0);
    }
    std::size_t capacity() const {
        std::size_t all = 0;
        for (const Block& block : blocks_) all += block.size;
        return all;
    }

  private:
    struct Block {
        std::unique_ptr<std::byte[]> data;
        std::size_t size = 0;
    };
    void enter(std::size_t block) {
        block_ = block;
        cursor_ = reinterpret_cast<std::uintptr_t>(blocks_[block].data.get());
        limit_ = cursor_ + blocks_[block].size;
    }
    /// Memory of `new[]` is aligned for everything.
    void* next_block(std::size_t bytes) {
        std::size_t next = blocks_.empty() ? 0 : block_ + 1;
        while (next < blocks_.size() && blocks_[next].size < bytes) ++next;
        if (next == blocks_.size()) {
            const std::size_t size = std::max<std::size_t>(bytes, 64 << 10);
            blocks_.push_back({std::make_unique_for_overwrite<std::byte[]>(size), size});
        }
        enter(next);
        cursor_ += bytes;
        return blocks_[next].data.get();
    }

    std::vector<Block> blocks_;
    std::size_t block_ = 0;
    std::uintptr_t cursor_ = 0, limit_ = 0;  ///< of the block in use
};

}  // namespace lapfx::ui
