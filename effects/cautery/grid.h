// Finds things in space by place, with a hash of cubic cells. Things are numbers; each can be removed and put in again.
// One thread at a time.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>
#include <vector>

namespace lapfx::cautery {

class Grid {
  public:
    /// `cell` in mm. Places are within +-1e5 mm.
    explicit Grid(double cell) : cell_(cell) {}

    void clear() { cells_.clear(); }
    void insert(std::uint32_t thing, const glm::dvec3& low, const glm::dvec3& high) {
        each_cell(low, high, [&](std::uint64_t key) { cells_[key].push_back(thing); });
    }
    /// Removes a thing from the cells that it was put into: the same box as in insert().
    void remove(std::uint32_t thing, const glm::dvec3& low, const glm::dvec3& high) {
        each_cell(low, high, [&](std::uint64_t key) {
            const auto found = cells_.find(key);
            if (found != cells_.end()) std::erase(found->second, thing);
        });
    }
    /// Things of all cells that the box touches, ascending and each once, replacing the contents of `out`.
    void find(const glm::dvec3& low, const glm::dvec3& high, std::vector<std::uint32_t>& out) const {
        out.clear();
        each_cell(low, high, [&](std::uint64_t key) {
            const auto found = cells_.find(key);
            if (found != cells_.end()) out.insert(out.end(), found->second.begin(), found->second.end());
        });
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
    }

  private:
    template <class Do>
    void each_cell(const glm::dvec3& low, const glm::dvec3& high, Do&& with) const {
        const glm::dvec3 first = glm::floor(low / cell_), last = glm::floor(high / cell_);
        for (double z = first.z; z <= last.z; ++z)
            for (double y = first.y; y <= last.y; ++y)
                for (double x = first.x; x <= last.x; ++x) with(key_of(x) | key_of(y) << 21 | key_of(z) << 42);
    }
    static std::uint64_t key_of(double index) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(index) + (1 << 20)) & 0x1fffff;
    }

    double cell_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace lapfx::cautery
