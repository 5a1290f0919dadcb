#include "window/glfw_window.h"

#include "lapfx/error.h"

namespace lapfx::window {

namespace {

Error no_window() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return {Failure::no_gl,
            Fault{.file = "",
                  .place = "",
                  .reason = std::string("no window can be opened: ") + (reason != nullptr ? reason : "unknown reason") +
                            "; lapfx render works without a display"}};
}

}  // namespace

GlfwWindow::GlfwWindow(glm::ivec2 size, const std::string& title) {
    if (glfwInit() == GLFW_FALSE) throw no_window();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // frames are made off-screen; the window only receives them
    glfwWindowHint(GLFW_CONTEXT_ROBUSTNESS, GLFW_LOSE_CONTEXT_ON_RESET);  // where supported, a reset is reported
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        Error error = no_window();
        glfwTerminate();
        throw error;
    }
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
}

GlfwWindow::~GlfwWindow() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

glm::ivec2 GlfwWindow::framebuffer_size() const {
    glm::ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::dvec2 GlfwWindow::to_pixels(glm::dvec2 place) const {
    glm::ivec2 window(1);
    glfwGetWindowSize(window_, &window.x, &window.y);
    return place * glm::dvec2(framebuffer_size()) / glm::dvec2(glm::max(window, glm::ivec2(1)));
}

}  // namespace lapfx::window
