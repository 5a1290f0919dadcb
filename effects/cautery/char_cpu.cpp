#include "cautery/char_cpu.h"

#include <algorithm>

namespace lapfx::cautery {

namespace {

double distance_to_path(const ToolContact& contact, glm::dvec3 point) {
    return glm::distance(point, glm::mix(contact.position, contact.to, nearest_share(contact, point)));
}

}  // namespace

void CharField::set(std::span<const ToolContact> contacts, const CauteryParameters& parameters) {
    for (const Heated& heated : heated_)
        for (const std::uint32_t v : heated.vertices) values_[v] = glm::vec2(0.0f);
    heated_.clear();
    parameters_ = parameters;
    for (const ToolContact& contact : contacts) {
        if (!contact.hot()) continue;
        Heated heated{.contact = contact, .vertices = {}};
        const double reach = heated_reach(contact, parameters);
        for (std::uint32_t v = 0; v < positions_.size(); ++v)
            if (distance_to_path(contact, glm::dvec3(positions_[v])) <= reach) heated.vertices.push_back(v);
        heated_.push_back(std::move(heated));
    }
    stale_ = true;
}

bool CharField::update(double time) noexcept {
    // Nothing changes while the same contacts are all over or have not begun.
    const auto running = [&](const Heated& h) {
        return std::min(time, updated_) < h.contact.end() && std::max(time, updated_) > h.contact.time;
    };
    if (!stale_ && (time == updated_ || std::none_of(heated_.begin(), heated_.end(), running))) {
        updated_ = time;
        return false;
    }
    stale_ = false;
    updated_ = time;
    for (const Heated& heated : heated_)
        for (const std::uint32_t v : heated.vertices) values_[v] = glm::vec2(0.0f);
    for (const Heated& heated : heated_)
        for (const std::uint32_t v : heated.vertices) {
            const double peak = peak_temperature(heated.contact, parameters_, glm::dvec3(positions_[v]), time);
            values_[v].x = std::max(values_[v].x, static_cast<float>(char_of(peak, parameters_)));
        }
    return true;
}

}  // namespace lapfx::cautery
