#include "window/viewer.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "lapfx/preview.h"
#include "window/glfw_window.h"
#include "window/orbit.h"

namespace lapfx::window {

namespace {

constexpr double sample_time = 0.01;   // s between samples of the tool that the pointer is
constexpr double still_longest = 0.5;  // s; a frame that took longer (a stopped process) does not make time jump

/// What the user does, turned into a camera, contacts and a time. No drawing.
class Viewer {
  public:
    Viewer(GlfwWindow& window, Preview& preview, const Scene& scene)
        : window_(window),
          preview_(preview),
          camera_(scene.camera),
          home_(scene.camera),
          scene_contacts_(scene.events),
          scene_duration_(scene.duration),
          duration_(scene.duration) {
        glfwSetWindowUserPointer(window.get(), this);
        glfwSetMouseButtonCallback(window.get(), [](GLFWwindow* w, int button, int action, int) {
            self(w).button(button, action == GLFW_PRESS);
        });
        glfwSetCursorPosCallback(window.get(), [](GLFWwindow* w, double x, double y) { self(w).moved({x, y}); });
        glfwSetScrollCallback(window.get(), [](GLFWwindow* w, double, double y) { self(w).scrolled(y); });
        glfwSetKeyCallback(window.get(), [](GLFWwindow* w, int key, int, int action, int) {
            if (action != GLFW_RELEASE) self(w).key(key);
        });
        glfwSetWindowRefreshCallback(window.get(), [](GLFWwindow* w) { self(w).changed_ = true; });
        glfwSetFramebufferSizeCallback(window.get(), [](GLFWwindow* w, int, int) { self(w).changed_ = true; });
    }

    void run() {
        double before = glfwGetTime();
        while (glfwWindowShouldClose(window_.get()) == GLFW_FALSE) {
            playing_ || changed_ ? glfwPollEvents() : glfwWaitEvents();
            const double now = glfwGetTime();
            if (playing_) advance(std::min(now - before, still_longest));
            before = now;
            if (playing_ || changed_) draw();
        }
    }

  private:
    enum class Drag { none, orbit, pan, tool };

    /// What the left button does, by number key.
    struct Tool {
        ToolAction action;
        const char* name;
    };
    static constexpr Tool tools[] = {{ToolAction::cauterise, "1 cauterise"}, {ToolAction::cut, "2 cut"},
                                     {ToolAction::coagulate, "3 coagulate"}, {ToolAction::tear, "4 tear"},
                                     {ToolAction::suction, "5 suction"},     {ToolAction::irrigation, "6 irrigation"}};

    static Viewer& self(GLFWwindow* window) { return *static_cast<Viewer*>(glfwGetWindowUserPointer(window)); }

    void advance(double seconds) {
        time_ += seconds;
        if (drag_ == Drag::tool) {
            hold_tool();
        } else if (time_ > duration_) {
            time_ = 0.0;
        }
    }

    void draw() {
        changed_ = false;
        const glm::ivec2 size = window_.framebuffer_size();
        if (size.x < 1 || size.y < 1) {  // minimised: nothing to draw, and no busy loop
            glfwWaitEventsTimeout(0.1);
            return;
        }
        preview_.draw(time_, size);
        glfwSwapBuffers(window_.get());
        show_state();
    }

    void show_state() {
        const Amounts amounts = preview_.amounts();
        char title[200];
        std::snprintf(title, sizeof title, "lapfx  %s %.1f s  blood %.0f mm2  haze %.2f  tool: %s",
                      playing_ ? "playing" : "paused", time_, amounts.blood_area, amounts.haze, tools[tool_].name);
        if (title_ != title) glfwSetWindowTitle(window_.get(), title);
        title_ = title;
    }

    void button(int button, bool pressed) {
        changed_ = true;
        if (!pressed) {
            if (button == button_) end_drag();
            return;
        }
        if (drag_ != Drag::none) return;
        button_ = button;
        const bool shift = glfwGetKey(window_.get(), GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS;
        if (button == GLFW_MOUSE_BUTTON_MIDDLE || (shift && button == GLFW_MOUSE_BUTTON_RIGHT)) {
            drag_ = Drag::pan;
        } else if (button == GLFW_MOUSE_BUTTON_LEFT && put_tool_on()) {
            drag_ = Drag::tool;
        } else {
            drag_ = Drag::orbit;
        }
    }

    /// The left button is a tool on the organ for as long as it is held, and follows the pointer. It needs time, so it plays.
    bool put_tool_on() {
        const auto hit = preview_.pick(at_, window_.framebuffer_size());
        if (!hit) return false;
        // Samples go forwards in time; a log that is set lets time begin anew.
        const std::vector<ToolContact> log(preview_.contacts().begin(), preview_.contacts().end());
        preview_.set_contacts(log);
        tip_ = hit->position;
        sampled_ = time_;
        push_sample(time_, tip_, true);
        playing_ = true;
        return true;
    }

    void push_sample(double time, const glm::dvec3& tip, bool touching) {
        preview_.tool_queue().push(
            {.time = time, .position = tip, .touching = touching, .action = tools[tool_].action});
    }

    /// As a tool would have sent them while the last frame was drawn.
    void hold_tool() {
        const auto hit = preview_.pick(at_, window_.framebuffer_size());
        const glm::dvec3 from = tip_, to = hit ? hit->position : tip_;
        const double begin = sampled_;
        while (sampled_ + sample_time <= time_) {
            sampled_ += sample_time;
            push_sample(sampled_, glm::mix(from, to, (sampled_ - begin) / (time_ - begin)), true);
        }
        tip_ = to;
        duration_ = std::max(duration_, time_);
    }

    /// Afterwards the scene goes on long enough to show what comes of it.
    void end_drag() {
        if (drag_ == Drag::tool) {
            push_sample(sampled_ + 1e-3, tip_, false);
            duration_ = std::max(duration_, time_ + 10.0);
        }
        drag_ = Drag::none;
    }

    /// Time jumps: whatever is being held ends first.
    void jump(double time) {
        end_drag();
        time_ = std::clamp(time, 0.0, duration_);
    }

    void start_over() {
        drag_ = Drag::none;
        duration_ = scene_duration_;
        preview_.set_contacts(scene_contacts_);
        jump(0.0);
    }

    void moved(glm::dvec2 place) {
        const glm::dvec2 now = window_.to_pixels(place), by = now - at_;
        at_ = now;
        if (drag_ != Drag::orbit && drag_ != Drag::pan) return;
        const double height = window_.framebuffer_size().y;
        if (drag_ == Drag::orbit) orbit(camera_, by.x / height * std::numbers::pi, by.y / height * std::numbers::pi);
        if (drag_ == Drag::pan) pan(camera_, by, height);
        show_camera();
    }

    void scrolled(double notches) {
        zoom(camera_, std::pow(0.9, notches));
        show_camera();
    }

    void key(int key) {
        changed_ = true;
        if (const int tool = key - GLFW_KEY_1; tool >= 0 && tool < static_cast<int>(std::size(tools))) {
            end_drag();
            tool_ = static_cast<std::size_t>(tool);
            return;
        }
        switch (key) {
            case GLFW_KEY_SPACE:
                end_drag();
                playing_ = !playing_;
                break;
            case GLFW_KEY_HOME:
                camera_ = home_;
                show_camera();
                break;
            case GLFW_KEY_R:
                start_over();
                break;
            case GLFW_KEY_RIGHT:
                jump(time_ + 0.1);
                break;
            case GLFW_KEY_LEFT:
                jump(time_ - 0.1);
                break;
            case GLFW_KEY_ESCAPE:
                glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
                break;
            default:
                break;
        }
    }

    void show_camera() {
        preview_.set_camera(camera_);
        changed_ = true;
    }

    GlfwWindow& window_;
    Preview& preview_;
    SceneCamera camera_, home_;
    std::vector<ToolContact> scene_contacts_;
    double scene_duration_;
    double duration_;
    double time_ = 0.0;
    bool playing_ = true;
    bool changed_ = true;
    Drag drag_ = Drag::none;
    std::size_t tool_ = 0;  // into tools
    glm::dvec3 tip_{0.0};   // while the tool is on
    double sampled_ = 0.0;  // s, of its last sample
    int button_ = 0;
    glm::dvec2 at_{0.0};
    std::string title_;
};

}  // namespace

void view(const Scene& scene, const Preset& preset, const std::vector<std::filesystem::path>& clip_folders) {
    GlfwWindow window({1024, 820}, "lapfx");
    const Context context = Context::external(glfwGetProcAddress);
    Preview preview(scene, preset, {.clip_folders = clip_folders});
    Viewer(window, preview, scene).run();
}

}  // namespace lapfx::window
