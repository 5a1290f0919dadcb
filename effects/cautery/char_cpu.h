// Char per vertex, 0..1, from the contacts so far. One thread at a time.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cautery/heat_cpu.h"

namespace lapfx::cautery {

class CharField {
  public:
    /// Keeps a reference to `positions`, mm, per organ vertex.
    explicit CharField(std::span<const glm::vec3> positions)
        : positions_(positions), values_(positions.size(), glm::vec2(0.0f)) {}

    void set(std::span<const ToolContact> contacts, const CauteryParameters& parameters);
    /// Values at `time`; false when none has changed.
    bool update(double time) noexcept;
    std::span<const glm::vec2> values() const { return values_; }

  private:
    struct Heated {
        ToolContact contact;
        std::vector<std::uint32_t> vertices;  // within its reach
    };
    std::span<const glm::vec3> positions_;
    CauteryParameters parameters_;
    std::vector<Heated> heated_;
    std::vector<glm::vec2> values_;
    double updated_ = -1.0;
    bool stale_ = true;
};

}  // namespace lapfx::cautery
