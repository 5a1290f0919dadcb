// The core's own amounts of a scene at given times, without drawing: milliseconds for a whole scene. What was worked
// out of blood is kept for a few scenes, since a search often asks for the same blood with other smoke.
//
//     CoreAmounts core(organ);
//     std::vector<Amounts> amounts = core.at(tuned, times);
//
// One thread at a time, any.
#pragma once

#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "lapfx/amounts.h"
#include "match/fit/free_parameter.h"

namespace lapfx::match {

class CoreAmounts {
  public:
    explicit CoreAmounts(std::shared_ptr<const PreparedOrgan> organ) : organ_(std::move(organ)) {}

    /// `times`: s, ascending. Throws Error (bad_input) for values that are not allowed.
    std::vector<Amounts> at(const Tuned& tuned, std::span<const double> times);
    int evaluations() const { return evaluations_; }

  private:
    /// All that blood depends on.
    struct BloodInputs {
        BleedingParameters bleeding;
        VesselParameters vessels;
        CauteryParameters cautery;
        std::vector<ToolContact> contacts;
        Curves curves;  ///< without emission
        glm::dvec3 gravity;
        std::vector<double> times;

        friend bool operator==(const BloodInputs&, const BloodInputs&) = default;
    };
    struct Worked {
        BloodInputs of;
        std::vector<Amounts> amounts;
    };
    static BloodInputs inputs_of(const Tuned& tuned, std::span<const double> times);

    std::shared_ptr<const PreparedOrgan> organ_;
    std::unique_ptr<AmountsModel> model_;
    glm::dvec3 gravity_{0.0};   ///< of model_
    std::deque<Worked> known_;  ///< latest first
    int evaluations_ = 0;
};

}  // namespace lapfx::match
