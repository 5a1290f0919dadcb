#include "window/viewer.h"

#include <cmath>
#include <cstdio>
#include <numbers>

#include "lapfx/preview.h"
#include "window/glfw_window.h"
#include "window/orbit.h"

namespace lapfx::window {

namespace {

constexpr double still_longest = 0.5;  // s; a frame that took longer (a stopped process) does not make time jump

/// What the user does, turned into a camera, contacts and a time. No drawing.
class Viewer {
  public:
    Viewer(GlfwWindow& window, Preview& preview, const Scene& scene)
        : window_(window),
          preview_(preview),
          contacts_(scene.events),
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
    enum class Drag { none, orbit, pan, cauterise };

    static Viewer& self(GLFWwindow* window) { return *static_cast<Viewer*>(glfwGetWindowUserPointer(window)); }

    void advance(double seconds) {
        time_ += seconds;
        if (drag_ == Drag::cauterise) {
            hold_contact();
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
        char title[160];
        std::snprintf(title, sizeof title, "lapfx  %s %.1f s  blood %.0f mm2  haze %.2f  %s",
                      playing_ ? "playing" : "paused", time_, amounts.blood_area, amounts.haze,
                      drag_ == Drag::cauterise ? "cauterising" : "");
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
        } else if (button == GLFW_MOUSE_BUTTON_LEFT && begin_contact()) {
            drag_ = Drag::cauterise;
        } else {
            drag_ = Drag::orbit;
        }
    }

    /// The left button burns where it meets the organ, for as long as it is held. A burn needs time, so it plays.
    bool begin_contact() {
        const auto hit = preview_.pick(at_, window_.framebuffer_size());
        if (!hit) return false;
        contacts_.push_back({.action = ToolAction::cauterise,
                             .time = time_,
                             .duration = 0.0,
                             .position = hit->position,
                             .to = hit->position});
        preview_.set_contacts(contacts_);
        playing_ = true;
        return true;
    }

    /// After a burn the scene goes on long enough to show what comes of it.
    void end_drag() {
        if (drag_ == Drag::cauterise) duration_ = std::max(duration_, time_ + 10.0);
        drag_ = Drag::none;
    }

    /// Time jumps: whatever is being held ends first.
    void jump(double time) {
        end_drag();
        time_ = std::clamp(time, 0.0, duration_);
    }

    void start_over() {
        drag_ = Drag::none;
        contacts_ = scene_contacts_;
        duration_ = scene_duration_;
        preview_.set_contacts(contacts_);
        jump(0.0);
    }

    void hold_contact() {
        ToolContact& contact = contacts_.back();
        contact.duration = time_ - contact.time;
        duration_ = std::max(duration_, time_);
        preview_.set_contacts(contacts_);
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
    std::vector<ToolContact> contacts_;
    SceneCamera camera_, home_;
    std::vector<ToolContact> scene_contacts_;
    double scene_duration_;
    double duration_;
    double time_ = 0.0;
    bool playing_ = true;
    bool changed_ = true;
    Drag drag_ = Drag::none;
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
