#include "advection.h"

#include <cmath>

#include "parallel.h"

namespace clips {

ActiveBlocks::ActiveBlocks(glm::ivec3 samples)
    : samples_(samples),
      count_((samples + (edge - 1)) / edge),
      blocks_(std::size_t(count_.x) * count_.y * count_.z, 1) {}

void ActiveBlocks::set_all() {
    std::fill(blocks_.begin(), blocks_.end(), std::uint8_t(1));
}

void ActiveBlocks::find(const Field& field, float threshold, float reach) {
    std::vector<std::uint8_t> holds(blocks_.size(), 0);
    for_slabs(count_.z, [&](int begin, int end) {
        for (int k = begin * edge; k < std::min(end * edge, samples_.z); ++k)
            for (int j = 0; j < samples_.y; ++j)
                for (int i = 0; i < samples_.x; ++i)
                    if (field.at(i, j, k) > threshold) holds[block(i / edge, j / edge, k / edge)] = 1;
    });
    std::fill(blocks_.begin(), blocks_.end(), std::uint8_t(0));
    const int grow = std::max(1, int(std::ceil(reach / float(edge))));
    for (int z = 0; z < count_.z; ++z)
        for (int y = 0; y < count_.y; ++y)
            for (int x = 0; x < count_.x; ++x) {
                if (!holds[block(x, y, z)]) continue;
                const glm::ivec3 low = glm::max(glm::ivec3(x, y, z) - grow, glm::ivec3(0));
                const glm::ivec3 high = glm::min(glm::ivec3(x, y, z) + grow, count_ - 1);
                for (int c = low.z; c <= high.z; ++c)
                    for (int b = low.y; b <= high.y; ++b)
                        for (int a = low.x; a <= high.x; ++a) blocks_[block(a, b, c)] = 1;
            }
}

Advector::Advector(const Field& lattice)
    : guess_(lattice.size, lattice.origin, lattice.spacing),
      result_(guess_),
      from_(guess_.values.size()),
      active_(lattice.size) {}

void Advector::trace(const Flow& flow, float dt, const SmallEddies& eddies) {
    for_slabs(guess_.size.z, [&](int begin, int end) {
        active_.runs(begin, end, [&](int i_begin, int i_end, int j, int k) {
            for (int i = i_begin; i < i_end; ++i) {
                const glm::vec3 x = guess_.position(i, j, k);
                const glm::vec3 start = flow.sample(x);
                glm::vec3 speed = flow.sample(x - 0.5f * dt * start);
                if (eddies.tile)
                    speed += eddies.share * glm::length(start) * eddies.tile->sample(x * eddies.scale + eddies.drift);
                from_[guess_.index(i, j, k)] = x - dt * speed;
            }
        });
    });
}

void Advector::advect(Field& field) {
    const int planes = field.size.z;
    std::fill(guess_.values.begin(), guess_.values.end(), 0.0f);
    std::fill(result_.values.begin(), result_.values.end(), 0.0f);
    for_slabs(planes, [&](int begin, int end) {
        active_.runs(begin, end, [&](int i_begin, int i_end, int j, int k) {
            for (int i = i_begin; i < i_end; ++i) {
                const std::size_t n = field.index(i, j, k);
                guess_.values[n] = field.sample(from_[n]);
            }
        });
    });
    // Advecting back and forward again shows the error of the round trip; half of it belongs to one way. Where the
    // correction leaves the range of its samples it would ring, so the first-order value stays there.
    for_slabs(planes, [&](int begin, int end) {
        active_.runs(begin, end, [&](int i_begin, int i_end, int j, int k) {
            for (int i = i_begin; i < i_end; ++i) {
                const std::size_t n = field.index(i, j, k);
                const glm::vec3 ahead = 2.0f * field.position(i, j, k) - from_[n];
                const float corrected = guess_.values[n] + 0.5f * (field.values[n] - guess_.sample(ahead));
                const glm::vec2 range = field.bounds(field.cube(from_[n]));
                const bool inside = corrected >= range.x && corrected <= range.y;
                result_.values[n] = inside ? corrected : guess_.values[n];
            }
        });
    });
    std::swap(field.values, result_.values);
}

}  // namespace clips
