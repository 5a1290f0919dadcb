#include <algorithm>

#include "bleeding/bleed_cpu.h"
#include "bleeding/bleeding.h"

namespace lapfx::bleeding {

namespace {

template <class Made>
std::unique_ptr<Bleeding> made(const Surface& surface, const glm::dvec3& down) {
    return std::make_unique<Made>(surface, down);
}

/// In the order of Model.
constexpr std::unique_ptr<Bleeding> (*makers[])(const Surface&, const glm::dvec3&) = {made<BleedField>};
static_assert(std::size(makers) == model_count);

}  // namespace

std::unique_ptr<Bleeding> make_bleeding(Model model, const Surface& surface, const glm::dvec3& down) {
    return makers[static_cast<std::size_t>(model)](surface, down);
}

int bleeding_wounds(std::span<const WoundStatus> wounds) noexcept {
    return static_cast<int>(std::ranges::count_if(wounds, &WoundStatus::bleeds));
}

}  // namespace lapfx::bleeding
