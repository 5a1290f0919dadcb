// The window of a UI: GLFW's callbacks become events, frames are built when there is a reason and drawn when the
// picture differs.
//
//     window::UiWindow window({.title = "lapfx", .theme = &ui::light_theme()});
//     window.run([&](ui::Ui& u) { ui::label(u, "Hello"); });
//
// Between frames the process sleeps: until an event, until the time a widget asked for, or until Ui::wake() from any
// thread. Ctrl+=, Ctrl+- and Ctrl+0 change the scale. What input methods compose comes as text once it is committed;
// GLFW 3.3 does not tell of it before.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "app/window_place.h"
#include "lapfx/context.h"
#include "ui/core/ui.h"
#include "ui/gl/renderer.h"
#include "window/glfw_window.h"

namespace lapfx::window {

// --- without a window ------------------------------------------------------------------------------------------------

/// What the key says on it: `name` is glfwGetKeyName's answer, null for keys without one. Letters and punctuation
/// follow the layout, so that Ctrl+Z is where Z stands; a key of another script, and the row of digits, is what a US
/// keyboard has there. The number block gives digits or, without NumLock, what else is on it. `none` for keys the UI
/// has no name for.
ui::Key key_from(int glfw_key, const char* name, bool num_lock);
/// GLFW_MOD_ bits as they are after the key `glfw_key` went down or up: X11 tells them from before.
ui::Mods mods_from(int glfw_mods, int glfw_key = GLFW_KEY_UNKNOWN, bool down = false);

inline constexpr float least_scale = 0.75F, most_scale = 3;
/// The next of the steps between least_scale and most_scale; `way` 1 up, -1 down.
float next_scale(float scale, int way);
/// The user's if it is above 0, else LAPFX_SCALE's if `environment` is a number above 0, else the screen's; clamped.
float choose_scale(float user, const char* environment, float screen);

/// What a key does to the scale: 1 up, -1 down, 0 back to the standard; nothing when it is no such key. `name` as for
/// key_from(): where + has a key of its own (German) that one is meant as well.
std::optional<int> scale_step(ui::Key key, const char* name, ui::Mods mods);

/// A pointer that goes on without bounds while the real one stays in the window: that one is put back to the middle
/// when it comes near an edge, and only then, so that devices that tell places instead of movements (tablets, VNC,
/// xdotool), which cannot be put anywhere, are followed as they are and merely end where the window does. GLFW's own
/// disabled pointer puts it back after every movement: with such devices each one counts from the middle, and values
/// run away.
class EndlessPointer {
  public:
    void start(glm::dvec2 real);
    /// Where it is without bounds, when the real one is told to be at `real`.
    glm::dvec2 move(glm::dvec2 real);
    /// Whether the real one is to be put to the middle, floor(size / 2), of a window of `size` now; counts it as done.
    bool put_back(glm::dvec2 real, glm::dvec2 size);

  private:
    // What is added to the real place, and what was before it was put back: events from before are still on their way.
    glm::dvec2 shift_{0}, shift_before_{0}, at_{0};
};

// --- the window ------------------------------------------------------------------------------------------------------

struct UiWindowOptions {
    std::string title = "lapfx";
    glm::ivec2 size{1280, 800};  ///< px at scale 1
    float scale = 0;             ///< the user's; 0: as choose_scale() finds it
    const ui::Theme* theme = &ui::dark_theme();
    bool reduced_motion = false;
    ui::Shortcuts* shortcuts = nullptr;
    ui::ImageStore* images = nullptr;
    std::ostream* log = nullptr;  ///< gets a line for every frame
};

/// What runs in the window. Each in the window's thread, its context current.
/// What a program makes of one frame.
struct UiFrame {
    double now;                          ///< s
    bool visible;                        ///< false: the window is an icon
    const std::function<void()>& build;  ///< to be called once: takes the events that have come, and builds the UI
};

struct UiProgram {
    std::function<void(ui::Ui&)> build;
    /// One frame: calls UiFrame::build, and before and after it does what the program has to. Gives whether pictures of
    /// its own have changed. Empty: only builds.
    std::function<bool(const UiFrame&)> frame;
    std::function<bool()> may_close;  ///< the window is asked to close; false: it stays. May be empty
};

struct WindowStatistics {
    int waits = 0;          ///< times that the process slept, or looked whether there is an event
    int frames = 0;         ///< frames that were built
    int drawn = 0;          ///< of these, drawn
    double ui_seconds = 0;  ///< of the CPU, for the last frame drawn: built, laid out, its list sent
};

class UiWindow {
  public:
    /// Throws Error (no_gl) without a display or OpenGL 4.5, std::runtime_error without fonts.
    explicit UiWindow(const UiWindowOptions& options);
    ~UiWindow();
    UiWindow(const UiWindow&) = delete;
    UiWindow& operator=(const UiWindow&) = delete;

    /// Until the window is closed. What `build` throws comes out here.
    void run(const std::function<void(ui::Ui&)>& build) {
        run(UiProgram{.build = build, .frame = {}, .may_close = {}});
    }
    void run(const UiProgram& program);
    /// Whatever UiProgram::may_close says.
    void close();

    ui::Ui& ui() { return ui_; }
    const Context& context() const { return context_; }
    float scale() const { return scale_; }
    /// From the next frame on; clamped. 0: as choose_scale() finds it.
    void set_scale(float scale);
    /// What the user has chosen by Ctrl+= and its likes or set_scale(), for the settings; 0: nothing.
    float chosen_scale() const { return chosen_scale_; }
    void set_title(const std::string& title);
    /// Where it is; while it is maximised or not shown, where it was before. Where it was put by put(), as far as
    /// monitors allow.
    app::WindowPlace place();
    void put(const app::WindowPlace& place);
    /// s: when the pointer, a key or a wheel did something last; negative: never yet.
    double last_input() const { return last_input_; }
    /// While a job runs the window looks for its results four times a second at least, whatever becomes of its wake().
    void set_busy(bool busy) { busy_ = busy; }
    /// As ui::Renderer::reload; the next frame is drawn with them.
    bool reload_shaders(std::string_view vertex, std::string_view fragment, std::string& fault) {
        stale_ = true;
        return renderer_.reload(vertex, fragment, fault);
    }
    const WindowStatistics& statistics() const { return statistics_; }

  private:
    struct SystemClipboard : ui::Clipboard {
        GLFWwindow* window = nullptr;
        std::string get() override;
        void set(const std::string& text) override;
    };

    static UiWindow& of(GLFWwindow* window) { return *static_cast<UiWindow*>(glfwGetWindowUserPointer(window)); }
    void connect();
    void measure();
    void push(ui::Event event, const char* reason);
    void take_pointer(double x, double y);
    void take_key(int key, int scancode, int action, int bits);
    bool take_scale_key(ui::Key key, const char* name);
    bool chord_is_recorded() const;
    void take_button(int button, bool down);
    void take_drop(int count, const char** paths);
    void want(const char* reason) { reason_ = reason; }
    void wait();
    void frame();
    bool stays();
    void show();
    void show_pointer(const ui::FrameOutput& output);

    UiWindowOptions options_;
    GlfwWindow window_;
    Context context_;
    SystemClipboard clipboard_;
    ui::Fonts fonts_;
    ui::Ui ui_;
    ui::Renderer renderer_;
    const UiProgram* program_ = nullptr;
    bool closed_ = false;
    std::exception_ptr fault_;  ///< thrown in a callback, which GLFW, being C, cannot let through

    float scale_ = 1, screen_scale_ = 1, chosen_scale_ = 0;
    std::string title_;
    glm::ivec2 size_{1};         ///< px of the framebuffer, as long as there is one
    glm::dvec2 px_per_unit_{1};  ///< GLFW's screen coordinates to px
    bool iconified_ = false;
    bool stale_ = true;  ///< what is on the screen is not the last picture
    bool busy_ = false, in_frame_ = false, moved_ = true;
    const char* reason_ = "start";  ///< why a frame is wanted; null: it is not
    std::atomic<bool> woken_ = false;
    double wake_at_ = ui::never, last_frame_ = -1, last_input_ = -1;
    app::WindowPlace place_;  ///< when it was last looked at
    void* queued_ = nullptr;  ///< fence after the last swap

    ui::Mods mods_ = ui::Mods::none;
    glm::vec2 pointer_{0};
    bool locked_ = false;
    glm::dvec2 locked_at_{0};  ///< screen coordinates
    EndlessPointer endless_;
    ui::Cursor cursor_ = ui::Cursor::arrow;
    GLFWcursor* cursors_[8] = {};
    WindowStatistics statistics_;
};

}  // namespace lapfx::window
