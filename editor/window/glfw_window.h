// The GLFW window and its OpenGL 4.5 context: made, current, and destroyed in order.
#pragma once

#include <GLFW/glfw3.h>

#include <glm/glm.hpp>
#include <string>

namespace lapfx::window {

class GlfwWindow {
  public:
    /// Throws Error (no_gl) with GLFW's reason.
    GlfwWindow(glm::ivec2 size, const std::string& title);
    ~GlfwWindow();
    GlfwWindow(const GlfwWindow&) = delete;
    GlfwWindow& operator=(const GlfwWindow&) = delete;

    GLFWwindow* get() const { return window_; }
    glm::ivec2 framebuffer_size() const;
    /// The pointer in framebuffer pixels, origin top left.
    glm::dvec2 pointer() const;

  private:
    GLFWwindow* window_ = nullptr;
};

}  // namespace lapfx::window
