// The GLFW window and its OpenGL 4.5 context. The constructor makes both and makes the context current; the destructor
// destroys them in order.
#pragma once

#define GLFW_INCLUDE_NONE  // OpenGL is glad's
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
    /// Converts a place in GLFW's screen coordinates, origin top left, to pixels of the framebuffer. Events come with
    /// such places. Asking GLFW instead gives the place of the pointer now, which after a slow frame is not the place
    /// of the event.
    glm::dvec2 to_pixels(glm::dvec2 place) const;

  private:
    GLFWwindow* window_ = nullptr;
};

}  // namespace lapfx::window
