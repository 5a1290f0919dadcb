// A GLSL expression of the real shader files, called from C++ on many inputs.
//
//     GpuFunction noise({"noise.glsl"}, "lapfx_perlin(a.xyz, uint(u_0.x))");   // a: the input, u_0 .. u_2: parameters
//     std::vector<glm::vec4> values = noise(points, {{seed, 0, 0, 0}});
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "gl/program.h"

namespace lapfx::test {

class GpuFunction {
  public:
    /// `expression` gives a vec4. `declarations`: GLSL between the includes and the expression.
    GpuFunction(const std::vector<std::string>& includes, const std::string& expression,
                const std::string& declarations = "");

    std::vector<glm::vec4> operator()(std::span<const glm::vec4> inputs,
                                      const std::array<glm::vec4, 3>& parameters = {}) const;

  private:
    gl::Program program_;
};

/// Compares component `component` of two results. On failure prints the largest difference, where it is, and both
/// values; NaN never passes.
void expect_near(std::span<const glm::vec4> inputs, std::span<const glm::vec4> cpu, std::span<const glm::vec4> gpu,
                 int component, double tolerance, const std::string& what);

}  // namespace lapfx::test
