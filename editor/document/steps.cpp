#include "document/steps.h"

#include <algorithm>

namespace lapfx::document {

std::uint64_t newest_step(const Document& document) {
    return document.done() > 0 ? document.steps()[document.done() - 1].id : 0;
}

bool in_effect(const Document& document, std::uint64_t step) {
    const auto first = document.steps().begin();
    return std::any_of(first, first + static_cast<std::ptrdiff_t>(document.done()),
                       [step](const Step& one) { return one.id == step; });
}

}  // namespace lapfx::document
