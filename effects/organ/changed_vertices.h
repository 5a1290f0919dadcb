// Which elements of a per-vertex array have changed since they were last sent to the GPU, as runs. Neighbouring changes
// are sent together, so that a pool of blood costs a few calls and hardly any extra bytes. Allocates nothing after
// construction. One thread at a time.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace lapfx {

/// Half-open range of vertices.
struct VertexRun {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    friend bool operator==(const VertexRun&, const VertexRun&) = default;
};

class ChangedVertices {
  public:
    explicit ChangedVertices(std::size_t vertices)
        : vertices_(static_cast<std::uint32_t>(vertices)), marked_(vertices / block + 1, false) {
        blocks_.reserve(marked_.size());
        runs_.reserve(marked_.size());
    }

    void mark(std::uint32_t vertex) noexcept {
        const std::uint32_t b = vertex / block;
        if (marked_[b]) return;
        marked_[b] = true;
        blocks_.push_back(b);
    }
    void mark_all() noexcept {
        for (std::uint32_t v = 0; v < vertices_; v += block) mark(v);
    }
    bool empty() const noexcept { return blocks_.empty(); }

    /// The runs that hold every marked vertex, ascending, and forgets them. Valid until the next call.
    std::span<const VertexRun> take() noexcept {
        std::sort(blocks_.begin(), blocks_.end());
        runs_.clear();
        for (const std::uint32_t b : blocks_) {
            marked_[b] = false;
            const VertexRun run{b * block, std::min((b + 1) * block, vertices_)};
            if (!runs_.empty() &&
                run.begin <= runs_.back().end + block)  // sending one clean block costs less than another call
                runs_.back().end = run.end;
            else
                runs_.push_back(run);
        }
        blocks_.clear();
        return runs_;
    }

  private:
    static constexpr std::uint32_t block = 16;  // vertices; two cache lines of a pair of floats

    std::uint32_t vertices_;
    std::vector<char> marked_;  // per block
    std::vector<std::uint32_t> blocks_;
    std::vector<VertexRun> runs_;
};

}  // namespace lapfx
