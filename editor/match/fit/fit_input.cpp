#include "match/fit/fit_input.h"

#include <algorithm>
#include <string>

#include "lapfx/error.h"

namespace lapfx::match {

void require_something(const FitInput& input) {
    const auto refuse = [](const std::string& reason) {
        throw Error(Failure::bad_input, Fault{.file = "", .place = "", .reason = reason});
    };
    if (input.parameters.empty()) refuse("no parameter is free: there is nothing to fit");
    if (input.target.size() < 2)
        refuse("the reference has fewer than two measured moments within the scene: nothing to fit to");
    const Weights& weights = input.weights;
    if (weights.blood == 0.0 && weights.veil == 0.0)
        refuse("the weights of blood and of the veil are 0: there is nothing to fit to");
    const bool bleeds = shows_blood(input.target);
    const bool any = std::any_of(input.target.begin(), input.target.end(), [&](const TargetPoint& aim) {
        return (aim.blood && weights.blood > 0.0 && bleeds) || (aim.veil && weights.veil > 0.0);
    });
    if (!any && !bleeds && weights.blood > 0.0 &&
        std::any_of(input.target.begin(), input.target.end(), [](const TargetPoint& aim) { return aim.blood; }))
        refuse(
            "no bleeding is seen in the reference, and its veil does not count or is not measurable: nothing to fit "
            "to");
    if (!any) refuse("neither blood nor veil of the reference is measurable within the scene: nothing to fit to");
}

bool moves_tools(const FitInput& input) {
    const Scene &start = input.start.scene, &before = input.before->scene;
    return start.events != before.events || start.curves.emission != before.curves.emission;
}

FitInput without_proposal(const FitInput& input) {
    FitInput without = input;
    without.start = *without.before;
    without.before.reset();
    without.parameters.resize(without.parameters.size() - input.of_proposal);
    return without;
}

}  // namespace lapfx::match
