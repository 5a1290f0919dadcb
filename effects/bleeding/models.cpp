#include <algorithm>

#include "bleeding/bleed_cpu.h"
#include "bleeding/bleeding.h"
#include "lapfx/rows.h"

namespace lapfx::bleeding {

namespace {

template <class Made>
std::unique_ptr<Bleeding> made(const Surface& surface, const glm::dvec3& down) {
    return std::make_unique<Made>(surface, down);
}

struct Row {
    Model model;
    std::unique_ptr<Bleeding> (*make)(const Surface& surface, const glm::dvec3& down);
};

constexpr Row rows[] = {
    {.model = Model::spread, .make = made<BleedField>},
};
static_assert(rows_follow<&Row::model>(rows) && std::size(rows) == model_count);

}  // namespace

std::unique_ptr<Bleeding> make_bleeding(Model model, const Surface& surface, const glm::dvec3& down) {
    return rows[static_cast<std::size_t>(model)].make(surface, down);
}

int bleeding_wounds(std::span<const WoundStatus> wounds) noexcept {
    return static_cast<int>(std::ranges::count_if(wounds, &WoundStatus::bleeds));
}

}  // namespace lapfx::bleeding
