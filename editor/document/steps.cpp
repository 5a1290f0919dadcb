#include "document/steps.h"

#include <algorithm>

namespace lapfx::document {

namespace {

/// Its place in the history; the history's length: it is none of it.
std::size_t place_of(const Document& document, std::uint64_t step) {
    const auto& steps = document.steps();
    const auto at = std::find_if(steps.begin(), steps.end(), [step](const Step& one) { return one.id == step; });
    return static_cast<std::size_t>(at - steps.begin());
}

}  // namespace

std::uint64_t newest_step(const Document& document) {
    return document.done() > 0 ? document.steps()[document.done() - 1].id : 0;
}

WatchedStep::WatchedStep(const Document& document) : id_(newest_step(document)), last_known_(id_), done_(id_ != 0) {}

bool WatchedStep::in_effect(const Document& document) {
    const auto& steps = document.steps();
    if (id_ == 0) return false;
    if (steps.empty()) return done_ = forgotten_ = false;  // another document: the newest step is never forgotten
    if (forgotten_) return true;
    if (const std::size_t place = place_of(document, id_); place < steps.size())
        done_ = place < document.done();
    else  // Steps are forgotten from the first on, and replaced with all that came after them.
        done_ = forgotten_ = done_ && place_of(document, last_known_) < steps.size();
    last_known_ = steps.back().id;
    return done_;
}

}  // namespace lapfx::document
