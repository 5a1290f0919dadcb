#include "smoke/particles_cpu.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "smoke/noise.h"

namespace lapfx::smoke {

namespace {

constexpr double shortest_life = 0.6;  // a speck lives at least this share of `lifetime`
constexpr double fading = 0.4;         // a speck fades in this last share of its life
constexpr double slowest = 0.3;        // a speck has at least this share of `speed`
constexpr double smallest = 0.35;      // a speck has at least this share of `size`

/// The random numbers of one speck, one after the other.
class Chance {
  public:
    Chance(std::uint32_t contact, int number, std::uint32_t seed) : contact_(contact), number_(number), seed_(seed) {}
    std::uint32_t bits() { return noise_hash({static_cast<int>(contact_), number_, drawn_++}, seed_); }
    /// 0 <= x < 1
    double unit() { return static_cast<double>(bits() >> 8) / static_cast<double>(1u << 24); }

  private:
    std::uint32_t contact_;
    int number_, drawn_ = 0;
    std::uint32_t seed_;
};

/// A number for a contact, which it keeps while it continues, whatever other contacts there are.
std::uint32_t number_of(const ToolContact& contact) {
    std::uint32_t h = 0;
    for (const double value : {contact.time, contact.position.x, contact.position.y, contact.position.z}) {
        const auto bits = std::bit_cast<std::uint64_t>(value + 0.0);  // -0 is 0
        h = noise_hash({static_cast<int>(bits >> 32), static_cast<int>(bits & 0xffffffffu), static_cast<int>(h)}, 9u);
    }
    return h;
}

/// A direction in the half space around `up`, all equally likely (Archimedes: heights over the disc are evenly
/// distributed).
glm::dvec3 direction(Chance& chance, const glm::dvec3& up) {
    const double height = chance.unit(), angle = 2.0 * std::numbers::pi * chance.unit();
    const glm::dvec3 across = std::abs(up.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(across, up)), ahead = glm::cross(up, right);
    const double radius = std::sqrt(1.0 - height * height);
    return height * up + radius * (std::cos(angle) * right + std::sin(angle) * ahead);
}

struct Source {
    const ToolContact& contact;
    double share;  ///< share of the births that happen
    std::uint32_t number;
};

/// Speck `n` of a source at `time`; false when it does not exist then.
bool find(const Source& source, int n, const ParticleParameters& p, const glm::dvec3& up, std::uint32_t seed,
          double time, Particle& particle) {
    Chance chance(source.number, n, seed);
    const double born = source.contact.time + (n + chance.unit()) / p.rate;
    if (chance.unit() >= source.share || born >= source.contact.end() || time < born) return false;
    const double age = time - born, life = p.lifetime * (shortest_life + (1.0 - shortest_life) * chance.unit());
    if (age >= life) return false;
    // Most specks are small.
    const double size = smallest + (1.0 - smallest) * std::pow(chance.unit(), 2.0);
    const double speed = p.speed * (slowest + (1.0 - slowest) * chance.unit());
    const glm::dvec3 start = speed * direction(chance, up), sinking = settling * size * size * up;
    const double flown = drag_time * -std::expm1(-age / drag_time);
    particle.position = glm::vec3(source.contact.tip(born) + flown * (start + sinking) - age * sinking);
    particle.diameter = static_cast<float>(p.size * size);
    particle.opacity = static_cast<float>(std::min((1.0 - age / life) / fading, 1.0));
    particle.glow = static_cast<float>(std::exp(-age / glow_time));
    particle.shape = chance.bits();
    return true;
}

}  // namespace

std::size_t particles_at(std::span<const BurnPart> parts, const ParticleParameters& parameters, glm::dvec3 up,
                         std::uint32_t seed, double time, std::span<Particle> into) noexcept {
    const std::size_t most = std::min(into.size(), most_particles);
    std::size_t count = 0;
    if (!(parameters.rate > 0.0) || !(parameters.lifetime > 0.0) || !std::isfinite(time)) return 0;
    for (std::size_t i = parts.size(); i-- > 0;) {
        const ToolContact& contact = parts[i].contact;
        const double share = std::clamp(contact.power, 0.0, 1.0) * parts[i].fat;
        if (!(share > 0.0) || !(time >= contact.time) || !(time < contact.end() + parameters.lifetime)) continue;
        const Source source{contact, share, number_of(contact)};
        // A long contact has made many specks by now; only those of the last lifetime can still exist.
        const double now = (std::min(time, contact.end()) - contact.time) * parameters.rate;
        const double gone = (time - parameters.lifetime - contact.time) * parameters.rate - 1.0;
        if (!(now < 1e9)) continue;  // an impossible time
        const int first = static_cast<int>(std::max(gone, 0.0));
        for (int n = static_cast<int>(now); n >= first && count < most; --n)
            if (find(source, n, parameters, up, seed, time, into[count])) ++count;
    }
    return count;
}

}  // namespace lapfx::smoke
