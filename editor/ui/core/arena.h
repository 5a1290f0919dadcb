// Memory of one frame: taken in steps, given back all at once. Keeps its blocks, so a steady frame allocates nothing.
#pragma once

#include <cstddef>
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
        std::size_t at = (used_ + alignment - 1) & ~(alignment - 1);
        if (block_ >= blocks_.size() || at + bytes > blocks_[block_].size) {
            next_block(bytes);
            at = 0;
        }
        used_ = at + bytes;
        return blocks_[block_].data.get() + at;
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
    void reset() { block_ = 0, used_ = 0; }
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
    void next_block(std::size_t bytes) {
        const std::size_t next = blocks_.empty() ? 0 : block_ + 1;
        used_ = 0;
        for (block_ = next; block_ < blocks_.size(); ++block_) {
            if (blocks_[block_].size >= bytes) return;
        }
        const std::size_t size = std::max<std::size_t>(bytes, 64 << 10);
        blocks_.push_back({std::make_unique_for_overwrite<std::byte[]>(size), size});
    }

    std::vector<Block> blocks_;
    std::size_t block_ = 0, used_ = 0;
};

}  // namespace lapfx::ui
