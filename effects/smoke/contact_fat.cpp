#include "smoke/contact_fat.h"

#include <algorithm>
#include <cmath>

#include "smoke/noise.h"

namespace lapfx::smoke {

namespace {

constexpr std::size_t most_known = 1u << 16;  // places; with more it starts again
constexpr double farthest = 1e6;              // mm: no organ is that far away, and the cell fits into an int

}  // namespace

std::size_t ContactFat::Hash::operator()(const glm::ivec3& cell) const {
    return noise_hash(cell, 0);
}

double ContactFat::at(const glm::dvec3& place, const Sample& sample) {
    const glm::ivec3 cell(glm::round(place / grid));
    if (const auto found = known_.find(cell); found != known_.end()) return found->second;
    if (known_.size() >= most_known) known_.clear();
    return known_[cell] = std::clamp(sample(grid * glm::dvec3(cell)), 0.0, 1.0);
}

double ContactFat::along(const ToolContact& contact, const Sample& sample) {
    const auto usable = [](const glm::dvec3& p) {
        return std::abs(p.x) < farthest && std::abs(p.y) < farthest && std::abs(p.z) < farthest;  // nor NaN
    };
    if (!usable(contact.position) || !usable(contact.to)) return 0.0;
    const double length = glm::distance(contact.position, contact.to);
    const int places = std::min(1 + static_cast<int>(std::ceil(std::min(length, 1000.0) / spacing)), most_places);
    double sum = 0.0;
    for (int i = 0; i < places; ++i)
        sum += at(places > 1 ? glm::mix(contact.position, contact.to, static_cast<double>(i) / (places - 1))
                             : contact.position,
                  sample);
    return sum / places;
}

}  // namespace lapfx::smoke
