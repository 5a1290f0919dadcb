// Blood on an organ over time, whatever the model. The simulation owns one, and whoever asks for blood asks this class:
// what lies at a vertex, how much there is, what its wounds do, and what has changed since it was last drawn.
// bleeding_gpu.h is the other side, which draws it.
//
// A model is a function of what is set and of the time: any order of calls gives the same to the last bit. To add one,
// write its enumerator, a class of each side and a row for it in models.cpp and in bleeding_gpu.cpp, and say in
// model_of() which presets ask for it. One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "bleeding/blood_amount.h"
#include "lapfx/bleeding_parameters.h"
#include "lapfx/wound.h"
#include "organ/changed_vertices.h"
#include "organ/surface.h"
#include "preset/factor_curve.h"
#include "tool/log.h"

namespace lapfx::bleeding {

enum class Model {
    spread,  ///< the paper's: a front runs from each wound (bleed_cpu.h)
};
inline constexpr std::size_t model_count = 1;  ///< enumerators

/// The model that a preset asks for. There is one, and presets have no row for it yet.
inline Model model_of(const BleedingParameters&) {
    return Model::spread;
}

/// What lies at a vertex.
struct BloodAt {
    bool any = false;    ///< blood, or so near that noise may show it there
    float value = 0.0f;  ///< bleed value as in parameters.cpp, mm
    float clot = 0.0f;   ///< 0..1
};

/// An array that the GPU has a copy of, for each vertex of the organ or for each of what else the model consists of.
struct DrawnArray {
    const void* data = nullptr;
    std::size_t count = 0;
    std::size_t stride = 0;  ///< bytes of an element
};

class Bleeding {
  public:
    static constexpr std::uint32_t gone = 0xffffffff;  ///< for keep(): a vertex that was not there

    Bleeding() = default;
    Bleeding(const Bleeding&) = delete;
    Bleeding& operator=(const Bleeding&) = delete;
    virtual ~Bleeding() = default;

    virtual Model model() const = 0;

    /// `changed`: the redo bits (lapfx/parameter.h) of what differs from the parameters before, at first those of
    /// BleedingParameters{}. set_clearing() has to follow.
    virtual void set_parameters(const BleedingParameters& parameters, unsigned changed) = 0;
    virtual void set_wounds(std::span<const Wound> wounds) = 0;
    /// Takes suction and irrigation from the tool's log. It must always be the same log.
    virtual void set_clearing(const tool::Log& log) = 0;
    /// The scene's factor on the flow over time (lapfx/curves.h); 1 at first.
    virtual void set_strength(const FactorCurve& strength) = 0;
    /// Takes the place of `former` on the same surface, because gravity or the model has changed: what lay there when
    /// the organ was cut stays, if both are of one model. Do not use `former` afterwards.
    virtual void replace(Bleeding& former) = 0;
    /// The organ was cut at `time`: the blood of `former` on vertices that are still there stays until it is cleared.
    /// `sources`: for each vertex of this organ the vertex that it was of the organ of `former`, or `gone`.
    virtual void keep(const Bleeding& former, std::span<const std::uint32_t> sources, double time) = 0;

    virtual void update(double time) noexcept = 0;

    // At the last update. Vertices are those of the organ.
    virtual BloodAt at(std::uint32_t vertex) const noexcept = 0;
    virtual BloodAmount amount() const noexcept = 0;
    /// Every wound, in the order in which they were set.
    virtual std::span<const WoundStatus> wounds() const = 0;
    /// What is drawn of it, for the model's own side of the GPU, which knows what each array is. Valid while this
    /// object lives.
    virtual std::span<const DrawnArray> drawn() const = 0;
    /// Vertices whose blood is drawn otherwise since somebody has taken them; at first, all.
    virtual ChangedVertices& changed() = 0;
};

/// Keeps a reference to `surface`. `down`: unit, organ space.
std::unique_ptr<Bleeding> make_bleeding(Model model, const Surface& surface, const glm::dvec3& down);

/// How many bleed (wound.h).
int bleeding_wounds(std::span<const WoundStatus> wounds) noexcept;

}  // namespace lapfx::bleeding
