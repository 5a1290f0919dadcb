// The core's own amounts of a scene at given times, without drawing: milliseconds for a whole scene. What was worked
// out of blood is kept for a few scenes, since a search often asks for the same blood with other smoke.
//
//     CoreAmounts core(organ);
//     std::vector<Amounts> amounts = core.at(tuned, times);
//
// One thread at a time, any; expect() starts another beside it and waits for it.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "document/content.h"
#include "lapfx/amounts.h"

namespace lapfx::match {

class CoreAmounts {
  public:
    explicit CoreAmounts(std::shared_ptr<const PreparedOrgan> organ) : organ_(std::move(organ)) {}

    /// `times`: s, ascending. Throws Error (bad_input) for values that are not allowed.
    std::vector<Amounts> at(const document::Content& tuned, std::span<const double> times);
    /// Works out the blood of scenes that at() will be asked for next, on two threads. What is not allowed is left for
    /// at() to refuse.
    void expect(std::span<const document::Content> scenes, std::span<const double> times);
    int evaluations() const { return evaluations_; }
    int worked_out() const { return worked_out_; }  ///< scenes whose blood was not known

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
    struct BloodWorkedOut {
        BloodInputs of;
        std::vector<Amounts> amounts;
    };
    struct Model {
        std::unique_ptr<AmountsModel> model;
        glm::dvec3 gravity{0.0};  ///< of model
    };
    static BloodInputs inputs_of(const document::Content& tuned, std::span<const double> times);
    const BloodWorkedOut* known(const BloodInputs& inputs);
    void keep(BloodWorkedOut worked);
    AmountsModel& set(Model& model, const document::Content& tuned) const;

    std::shared_ptr<const PreparedOrgan> organ_;
    std::array<Model, 2> models_;       ///< the first for at()
    std::deque<BloodWorkedOut> known_;  ///< latest first
    int evaluations_ = 0, worked_out_ = 0;
};

}  // namespace lapfx::match
