#include "bleeding/point_blur.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace lapfx::bleeding {

namespace {

constexpr std::uint32_t none = 0xffffffff;
constexpr int cells_per_block = 5;  // half a deviation each: blocks of 2.5 deviations, which is how far we look
constexpr double reach = 2.5;       // deviations

/// The Gaussian by the square of the distance, from 0 to the square of the reach.
constexpr int steps = 512;
std::array<double, steps + 1> make_bell() {
    std::array<double, steps + 1> bell;
    for (int i = 0; i <= steps; ++i) bell[static_cast<std::size_t>(i)] = std::exp(-0.5 * reach * reach * i / steps);
    return bell;
}

using Key = std::array<int, 3>;
struct Hash {
    std::size_t operator()(const Key& key) const {
        std::size_t hash = 0;
        for (const int part : key)
            hash = (hash ^ static_cast<std::size_t>(static_cast<unsigned>(part))) * 0x9e3779b97f4a7c15u;
        return hash ^ (hash >> 29);
    }
};
using Numbers = std::unordered_map<Key, std::uint32_t, Hash>;

Key key_of(const glm::dvec3& v) {
    return {static_cast<int>(v.x), static_cast<int>(v.y), static_cast<int>(v.z)};
}

}  // namespace

PointBlur::PointBlur(std::span<const glm::vec3> points, std::span<const float> weights, double deviation)
    : deviation_(deviation), points_(points), weights_(weights), cell_of_(points.size(), none) {
    std::vector<Key> blocks;
    gather(blocks);
    link(blocks);
}

/// Points into cells, cells in the order of their blocks.
void PointBlur::gather(std::vector<Key>& blocks) {
    Numbers cells, known_blocks;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const glm::dvec3 at = glm::floor(glm::dvec3(points_[i]) / (0.5 * deviation_));
        if (!(glm::length(at) < 2e6) || !(weights_[i] > 0.0f)) continue;
        const auto [place, fresh] = cells.try_emplace(key_of(at), static_cast<std::uint32_t>(cells_.size()));
        if (fresh) {
            const Key block = key_of(glm::floor(at / double(cells_per_block)));
            const auto [number, first] = known_blocks.try_emplace(block, static_cast<std::uint32_t>(blocks.size()));
            if (first) blocks.push_back(block);
            cells_.push_back({.block = number->second});
        }
        Cell& cell = cells_[place->second];
        cell.centre += glm::dvec3(points_[i]) * double(weights_[i]);
        cell.weight += double(weights_[i]);
        cell_of_[i] = place->second;
    }
    std::vector<std::uint32_t> order(cells_.size()), rank(cells_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return cells_[a].block < cells_[b].block; });
    std::vector<Cell> sorted;
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        rank[order[i]] = i;
        sorted.push_back(cells_[order[i]]);
        sorted.back().centre /= sorted.back().weight;
    }
    cells_ = std::move(sorted);
    for (std::uint32_t& cell : cell_of_)
        if (cell != none) cell = rank[cell];
}

/// Which cells are in each block and the 26 blocks around it.
void PointBlur::link(const std::vector<Key>& blocks) {
    std::vector<Run> runs(blocks.size());
    for (std::uint32_t i = 0; i < cells_.size(); ++i) {
        Run& run = runs[cells_[i].block];
        if (run.end == 0) run.begin = i;
        run.end = i + 1;
    }
    Numbers numbers;
    for (std::uint32_t i = 0; i < blocks.size(); ++i) numbers.emplace(blocks[i], i);
    neighbours_.resize(blocks.size());
    for (std::size_t b = 0; b < blocks.size(); ++b)
        for (int i = 0; i < 27; ++i) {
            const auto found =
                numbers.find({blocks[b][0] + i % 3 - 1, blocks[b][1] + i / 3 % 3 - 1, blocks[b][2] + i / 9 - 1});
            if (found != numbers.end()) neighbours_[b][static_cast<std::size_t>(i)] = runs[found->second];
        }
}

double PointBlur::mean_at(std::size_t point, std::span<const double> sums, double& weight) const {
    static const std::array<double, steps + 1> bell = make_bell();
    const double scale = steps / (reach * reach * deviation_ * deviation_);
    const glm::dvec3 position(points_[point]);
    double sum = 0.0;
    for (const Run& run : neighbours_[cells_[cell_of_[point]].block])
        for (std::uint32_t c = run.begin; c < run.end; ++c) {
            const glm::dvec3 apart = cells_[c].centre - position;
            const double step = scale * glm::dot(apart, apart);
            if (step > steps) continue;
            const double share = bell[static_cast<std::size_t>(step)];
            sum += share * sums[c];
            weight += share * cells_[c].weight;
        }
    return weight > 0.0 ? sum / weight : 0.0;
}

std::vector<float> PointBlur::operator()(std::span<const float> values) const {
    std::vector<double> sums(cells_.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i)
        if (cell_of_[i] != none) sums[cell_of_[i]] += double(values[i]) * double(weights_[i]);
    std::vector<float> out(values.begin(), values.end());
    for (std::size_t i = 0; i < values.size(); ++i) {
        double weight = 0.0;
        const double mean = cell_of_[i] == none ? 0.0 : mean_at(i, sums, weight);
        if (weight > 0.0) out[i] = static_cast<float>(mean);
    }
    return out;
}

}  // namespace lapfx::bleeding
