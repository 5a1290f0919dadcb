// The window of a UI: GLFW's callbacks become events, frames are built when there is a reason and drawn when the
// picture differs.
//
//     window::UiWindow window({.title = "lapfx", .theme = &ui::light_theme()});
//     window.run([&](ui::Ui& u) { ui::label(u, "Hello"); });
//
// Between frames the process sleeps: until an event, until the time a widget asked for, or until Ui::wake() from any
// thread. Ctrl+=, Ctrl+- and Ctrl+0 change the scale. Text from input methods arrives when it is committed; GLFW 3.3
// does not report it while it is composed.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>

#include "app/base/window_place.h"
#include "lapfx/context.h"
#include "ui/core/ui.h"
#include "ui/gl/renderer.h"
#include "window/glfw_window.h"

namespace lapfx::window {

// --- without a window ------------------------------------------------------------------------------------------------

/// The key by its label: `name` is the result of glfwGetKeyName, null for keys without one. Letters and punctuation
/// follow the layout, so that Ctrl+Z is where Z is printed. Keys of other scripts and the row of digits are taken as on
/// a US keyboard. The number block gives digits or, without NumLock, the other labels of its keys. Gives `none` for
/// keys that the UI has no name for.
ui::Key key_from(int glfw_key, const char* name, bool num_lock);
/// The modifiers as they are after the key `glfw_key` went down or up: X11 reports GLFW_MOD_ bits from before that.
ui::Mods mods_from(int glfw_mods, int glfw_key = GLFW_KEY_UNKNOWN, bool down = false);

inline constexpr float least_scale = 0.75F, most_scale = 3;
/// The next step between least_scale and most_scale: up if `way` is 1, down if it is -1.
float next_scale(float scale, int way);
/// The scale to use: the user's if it is above 0, else `environment` (LAPFX_SCALE) if it is a number above 0, else the
/// screen's. The result is clamped.
float choose_scale(float user, const char* environment, float screen);

/// What a key does to the scale: 1 up, -1 down, 0 back to the standard; nothing when it is another key. `name` is as
/// for key_from(): on layouts where + has a key of its own (German), that key works as well.
std::optional<int> scale_step(ui::Key key, const char* name, ui::Mods mods);

/// A pointer that moves without bounds while the real one stays in the window. The real one is moved to the middle only
/// when it comes near an edge. Devices that report places instead of movements (tablets, VNC, xdotool) cannot be moved
/// by a program: they are followed as they are, and their movement ends at the edge of the window. GLFW's own disabled
/// pointer moves the real one back after every movement; with such devices each movement then counts from the middle,
/// and values run away.
class EndlessPointer {
  public:
    void start(glm::dvec2 real);
    /// The place without bounds for an event that reports the real pointer at `real`.
    glm::dvec2 move(glm::dvec2 real);
    /// Whether the real pointer is to be moved now to the middle, floor(size / 2), of a window of `size`. If so,
    /// further calls assume that this was done.
    bool put_back(glm::dvec2 real, glm::dvec2 size);

  private:
    // `shift_` is added to the real place. `shift_before_` is its value before the pointer was moved to the middle, for
    // events from before that are still to come.
    glm::dvec2 shift_{0}, shift_before_{0}, at_{0};
};

// --- the window ------------------------------------------------------------------------------------------------------

struct UiWindowOptions {
    std::string title = "lapfx";
    glm::ivec2 size{1280, 800};  ///< px at scale 1
    float scale = 0;             ///< the user's choice; 0: choose_scale() finds one
    const ui::Theme* theme = &ui::dark_theme();
    bool reduced_motion = false;
    ui::Shortcuts* shortcuts = nullptr;
    ui::ImageStore* images = nullptr;
    std::ostream* log = nullptr;  ///< gets a line for every frame, and one when nothing is due soon
};

/// One frame, as UiProgram::frame gets it.
struct UiFrame {
    double now;                          ///< s
    bool visible;                        ///< false: the window is an icon
    const std::function<void()>& build;  ///< to be called once: handles the events that have come, and builds the UI
};

/// The program that runs in the window. Its functions are called in the window's thread, with its context current.
struct UiProgram {
    std::function<void(ui::Ui&)> build;
    /// Does the work of one frame and calls UiFrame::build in the course of it. Returns whether pictures of the program
    /// itself have changed. May be empty: then a frame only builds the UI.
    std::function<bool(const UiFrame&)> frame;
    std::function<bool()> may_close;  ///< called when the window is asked to close; false: it stays. May be empty
};

struct WindowStatistics {
    int waits = 0;          ///< how often the process slept or polled for events
    int frames = 0;         ///< frames that were built
    int drawn = 0;          ///< frames that were drawn as well
    double ui_seconds = 0;  ///< CPU time of the last frame drawn: building, layout, sending its list
};

class UiWindow {
  public:
    /// Throws Error (no_gl) without a display or OpenGL 4.5, std::runtime_error without fonts.
    explicit UiWindow(const UiWindowOptions& options);
    ~UiWindow();
    UiWindow(const UiWindow&) = delete;
    UiWindow& operator=(const UiWindow&) = delete;

    /// Runs until the window is closed. Exceptions of `build` leave this function.
    void run(const std::function<void(ui::Ui&)>& build) {
        run(UiProgram{.build = build, .frame = {}, .may_close = {}});
    }
    void run(const UiProgram& program);
    /// Closes the window without asking UiProgram::may_close.
    void close();

    ui::Ui& ui() { return ui_; }
    const Context& context() const { return context_; }
    float scale() const { return scale_; }
    /// The scale from the next frame on; it is clamped. 0: choose_scale() finds one.
    void set_scale(float scale);
    /// The scale that was chosen with the keys or set_scale(), for the settings; 0: none was.
    float chosen_scale() const { return chosen_scale_; }
    void set_title(const std::string& title);
    /// place() is where the window is or, while it is maximised or not shown, where it was before. put() moves it
    /// there, as far as the monitors allow.
    app::WindowPlace place();
    void put(const app::WindowPlace& place);
    /// s: the time of the last input by pointer, key or wheel; negative: there was none yet.
    double last_input() const { return last_input_; }
    /// While a job runs (`busy`), the window looks for results at least four times a second, even if a wake() is lost.
    void set_busy(bool busy) { busy_ = busy; }
    /// Calls ui::Renderer::reload. The next frame is drawn with the new shaders.
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
    glm::ivec2 size_{1};         ///< px of the framebuffer; the last one while it has no size
    glm::dvec2 px_per_unit_{1};  ///< GLFW's screen coordinates to px
    bool iconified_ = false;
    bool stale_ = true;  ///< the screen does not show the last picture
    bool busy_ = false, in_frame_ = false, moved_ = true;
    const char* reason_ = "start";  ///< why a frame is wanted; null: none is
    std::atomic<bool> woken_ = false;
    double wake_at_ = ui::never, last_frame_ = -1, last_input_ = -1;
    app::WindowPlace place_;  ///< as it was last found
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
