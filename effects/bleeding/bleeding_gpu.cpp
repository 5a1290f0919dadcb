#include "bleeding/bleeding_gpu.h"

#include "bleeding/bleed_gpu.h"
#include "lapfx/rows.h"

namespace lapfx::bleeding {

namespace {

template <class Made>
std::unique_ptr<BleedingGpu> made(std::size_t vertices) {
    return std::make_unique<Made>(vertices);
}

struct Row {
    Model model;
    ModelShaders shaders;
    std::unique_ptr<BleedingGpu> (*make)(std::size_t vertices);
};

constexpr Row rows[] = {
    {.model = Model::spread, .shaders = {"wounded.vert", "wounded.frag", "bleeding.glsl"}, .make = made<BleedGpu>},
};
static_assert(rows_follow<&Row::model>(rows) && std::size(rows) == model_count);

}  // namespace

const ModelShaders& shaders_of(Model model) {
    return rows[static_cast<std::size_t>(model)].shaders;
}

std::unique_ptr<BleedingGpu> make_bleeding_gpu(Model model, std::size_t vertices) {
    return rows[static_cast<std::size_t>(model)].make(vertices);
}

}  // namespace lapfx::bleeding
