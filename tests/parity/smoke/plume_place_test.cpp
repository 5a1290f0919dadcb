// shaders/plume.glsl and its CPU reference in effects/smoke/plume.h agree.
#include "smoke/plume.h"
#include "support/gpu_function.h"
#include "support/gpu_test.h"

namespace lapfx::smoke {
namespace {

class PlumePlaceParity : public test::GpuTest {};

TEST_F(PlumePlaceParity, EveryPlaceSourceAndWidening) {
    const test::GpuFunction gpu({"plume.glsl"}, "vec4(lapfx_plume_place(a.xy, u_0.xy, u_0.z), 0.0)");
    std::vector<glm::vec4> inputs;
    for (float x = 0.0f; x <= 1.0f; x += 0.0625f)
        for (float y = 0.0f; y <= 1.0f; y += 0.0625f) inputs.emplace_back(x, y, 0.0f, 0.0f);
    for (const glm::vec2 source : {glm::vec2(0.5f, 0.92f), glm::vec2(0.2f, 0.5f), glm::vec2(0.8f, 0.0f)})
        for (const float widening : {1.0f, 1.5f, 7.0f}) {
            std::vector<glm::vec4> cpu;
            for (const glm::vec4& i : inputs) {
                const PlumePlace place = plume_place(glm::vec2(i), source, widening);
                cpu.emplace_back(place.uv, place.thickness, 0.0f);
            }
            const std::vector<glm::vec4> found = gpu(inputs, {glm::vec4(source, widening, 0.0f)});
            for (int c = 0; c < 3; ++c)
                test::expect_near(inputs, cpu, found, c, 1e-5, "widening " + std::to_string(widening));
        }
}

}  // namespace
}  // namespace lapfx::smoke
