#include "cautery/heat_cpu.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lapfx::cautery {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double wound_spacing = 2.5;  // mm between the wounds of a cut line; below the width of any visible pool

double path_length(const ToolContact& contact) {
    return glm::distance(contact.position, contact.to);
}

/// How long the tip heats one place: all the contact when it stands still, else the time to pass over its own
/// width.
double dwell(const ToolContact& contact) {
    const double length = path_length(contact);
    return length <= 2.0 * tip_radius ? contact.duration : contact.duration * 2.0 * tip_radius / length;
}

/// mm; the paper's radial growth of the heated region. Diffusion grows with the square root of time.
double heated_radius(double heated, const CauteryParameters& c) {
    return tip_radius + c.heat_spread * std::sqrt(heated);
}

/// s of heating after which the tip's place has reached `temperature`; infinity when it never does.
double time_to(double temperature, const ToolContact& contact, const CauteryParameters& c) {
    const double rate = c.heat_rate * contact.power;
    if (rate <= 0.0 || temperature > c.maximum_temperature) return never;
    return std::max(0.0, temperature - body_temperature) / rate;
}

/// When this contact opens its tissue, s after the tip has arrived at a place; infinity when it does not.
double opening_delay(const ToolContact& contact, const CauteryParameters& c) {
    switch (contact.action) {
        case ToolAction::cut:
        case ToolAction::tear:
            return 0.0;
        case ToolAction::coagulate:
        case ToolAction::suction:
        case ToolAction::irrigation:
            return never;
        case ToolAction::cauterise:
            break;
    }
    const double delay = time_to(c.cut_temperature, contact, c);
    return delay <= dwell(contact) ? delay : never;
}

/// When `contact` closes the wound; infinity when it does not reach it. Coagulation closes any wound, cautery those that
/// were open before it began: the heat that cuts tissue does not close that very cut.
double closing_time(const ToolContact& contact, const CauteryParameters& c, const Wound& wound) {
    if (!contact.hot() || (contact.action == ToolAction::cauterise && wound.start >= contact.time)) return never;
    const glm::dvec3 point = wound.position;
    const double share = nearest_share(contact, point);
    const glm::dvec3 tip = glm::mix(contact.position, contact.to, share);
    const double delay = time_to(c.coagulation_temperature, contact, c);
    const double heated = dwell(contact);
    if (delay > heated || glm::distance(tip, point) > heated_radius(heated, c) + wound_spacing) return never;
    return contact.time + share * (contact.duration - heated) + delay;
}

}  // namespace

double nearest_share(const ToolContact& contact, glm::dvec3 point) noexcept {
    const glm::dvec3 path = contact.to - contact.position;
    const double squared = glm::dot(path, path);
    return squared > 0.0 ? std::clamp(glm::dot(point - contact.position, path) / squared, 0.0, 1.0) : 0.0;
}

double peak_temperature(const ToolContact& contact, const CauteryParameters& c, glm::dvec3 point,
                        double time) noexcept {
    if (!contact.hot()) return body_temperature;
    const double share = nearest_share(contact, point);
    const double arrived = contact.time + share * (contact.duration - dwell(contact));
    const double heated = std::clamp(time - arrived, 0.0, dwell(contact));
    if (heated <= 0.0) return body_temperature;
    const double rise =
        std::min(c.heat_rate * contact.power * heated, std::max(0.0, c.maximum_temperature - body_temperature));
    const double r = glm::distance(glm::mix(contact.position, contact.to, share), point) / heated_radius(heated, c);
    return body_temperature + rise * std::exp(-r * r);
}

double char_of(double peak, const CauteryParameters& c) noexcept {
    if (peak <= body_temperature) return 0.0;
    // Tissue blanches when it coagulates, browns at the char temperature and is black 150 degrees above it.
    const double cooked = glm::smoothstep(c.coagulation_temperature, c.char_temperature, peak);
    const double burnt = glm::smoothstep(c.char_temperature, c.char_temperature + 150.0, peak);
    return 0.35 * cooked + 0.65 * burnt;
}

double heated_reach(const ToolContact& contact, const CauteryParameters& c) noexcept {
    return contact.hot() ? 2.5 * heated_radius(dwell(contact), c) : 0.0;
}

std::vector<Wound> wounds_of(std::span<const ToolContact> contacts, const CauteryParameters& c) {
    std::vector<Wound> wounds;
    for (const ToolContact& contact : contacts) {
        const double delay = opening_delay(contact, c);
        if (delay == never) continue;
        const int steps = static_cast<int>(std::min(path_length(contact) / wound_spacing, 1000.0));
        for (int i = 0; i <= steps; ++i) {
            const double share = steps > 0 ? static_cast<double>(i) / steps : 0.0;
            wounds.push_back({.position = glm::mix(contact.position, contact.to, share),
                              .start = contact.time + share * (contact.duration - dwell(contact)) + delay,
                              .strength = contact.strength});
        }
    }
    for (Wound& wound : wounds)
        for (const ToolContact& contact : contacts) {
            const double closed = closing_time(contact, c, wound);
            if (closed > wound.start) wound.stop = std::min(wound.stop, closed);
        }
    return wounds;
}

}  // namespace lapfx::cautery
