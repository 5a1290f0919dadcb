#include "window/ui_window.h"

#include <glad/gl.h>

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <vector>

#include "ui/core/node.h"

namespace lapfx::window {

namespace {

constexpr double look_for_results = 0.25;  // s, while a job runs: an event from another thread can be lost
constexpr double least_between_frames =
    0.004;                           // s, for frames that only time asks for: some drivers swap without waiting
constexpr double edge_share = 0.4;   // share of the window's size; farther from its middle is near an edge
constexpr double a_long_time = 1e6;  // s: as good as never
constexpr double a_rest = 0.1;       // s without anything to do
constexpr GLuint64 longest_queue_wait = 100'000'000;  // ns

int glfw_shape(ui::Cursor cursor) {
    switch (cursor) {
        case ui::Cursor::text:
            return GLFW_IBEAM_CURSOR;
        case ui::Cursor::move:  // GLFW 3.3 has no shape of its own for it
            return GLFW_HAND_CURSOR;
        case ui::Cursor::resize_x:
            return GLFW_HRESIZE_CURSOR;
        case ui::Cursor::resize_y:
            return GLFW_VRESIZE_CURSOR;
        case ui::Cursor::crosshair:
            return GLFW_CROSSHAIR_CURSOR;
        default:
            return GLFW_ARROW_CURSOR;
    }
}

bool is_modifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}

}  // namespace

std::optional<int> scale_step(ui::Key key, const char* name, ui::Mods mods) {
    if (!has(mods, ui::Mods::command) || has(mods, ui::Mods::alt)) return std::nullopt;
    if (key == ui::key_of('=') || (name != nullptr && std::string_view(name) == "+")) return 1;
    if (has(mods, ui::Mods::shift)) return std::nullopt;  // + may need Shift, the other keys do not
    if (key == ui::key_of('-')) return -1;
    if (key == ui::key_of('0')) return 0;
    return std::nullopt;
}

void EndlessPointer::start(glm::dvec2 real) {
    shift_ = shift_before_ = glm::dvec2(0);
    at_ = real;
}

glm::dvec2 EndlessPointer::move(glm::dvec2 real) {
    const glm::dvec2 now = real + shift_, before = real + shift_before_;
    if (glm::distance(before, at_) < glm::distance(now, at_)) std::swap(shift_, shift_before_);
    return at_ = real + shift_;
}

bool EndlessPointer::put_back(glm::dvec2 real, glm::dvec2 size) {
    const glm::dvec2 from_middle = glm::abs(real - size / 2.0);
    if (from_middle.x < size.x * edge_share && from_middle.y < size.y * edge_share) return false;
    shift_before_ = shift_;
    shift_ += real - glm::floor(size / 2.0);
    return true;
}

std::string UiWindow::SystemClipboard::get() {
    const char* text = glfwGetClipboardString(window);
    return text == nullptr ? "" : text;
}

void UiWindow::SystemClipboard::set(const std::string& text) {
    glfwSetClipboardString(window, text.c_str());
}

UiWindow::UiWindow(const UiWindowOptions& options)
    : options_(options),
      window_(options.size, options.title),
      context_(Context::external(glfwGetProcAddress)),
      ui_(fonts_, {.theme = options.theme,
                   .clipboard = &clipboard_,
                   .images = options.images,
                   .shortcuts = options.shortcuts,
                   .reduced_motion = options.reduced_motion}) {
    clipboard_.window = window_.get();
    glm::vec2 screen(1);
    glfwGetWindowContentScale(window_.get(), &screen.x, &screen.y);
    screen_scale_ = screen.x;
    set_scale(options.scale);
    if (scale_ != 1) {
        const glm::ivec2 size(glm::vec2(options.size) * scale_);
        glfwSetWindowSize(window_.get(), size.x, size.y);
    }
    ui_.set_waker([this] {
        woken_ = true;
        glfwPostEmptyEvent();
    });
    measure();
    connect();
}

UiWindow::~UiWindow() {
    if (queued_ != nullptr) glDeleteSync(static_cast<GLsync>(queued_));
}

void UiWindow::connect() {
    GLFWwindow* w = window_.get();
    glfwSetWindowUserPointer(w, this);
    glfwSetInputMode(w, GLFW_LOCK_KEY_MODS, GLFW_TRUE);  // NumLock
    glfwSetCursorPosCallback(w, [](GLFWwindow* window, double x, double y) { of(window).take_pointer(x, y); });
    glfwSetCursorEnterCallback(w, [](GLFWwindow* window, int entered) {
        if (entered == GLFW_FALSE) of(window).push({.kind = ui::EventKind::pointer_out}, "pointer left");
    });
    glfwSetMouseButtonCallback(w, [](GLFWwindow* window, int button, int action, int bits) {
        of(window).mods_ = mods_from(bits);
        of(window).take_button(button, action == GLFW_PRESS);
    });
    glfwSetScrollCallback(w, [](GLFWwindow* window, double x, double y) {
        of(window).push({.kind = ui::EventKind::wheel, .delta = {x, y}}, "wheel");
    });
    glfwSetKeyCallback(w, [](GLFWwindow* window, int key, int scancode, int action, int bits) {
        of(window).take_key(key, scancode, action, bits);
    });
    glfwSetCharCallback(w, [](GLFWwindow* window, unsigned codepoint) {
        of(window).push({.kind = ui::EventKind::text, .codepoint = codepoint}, "text");
    });
    glfwSetDropCallback(w,
                        [](GLFWwindow* window, int count, const char** paths) { of(window).take_drop(count, paths); });
    glfwSetWindowFocusCallback(w, [](GLFWwindow* window, int focused) {
        if (focused == GLFW_TRUE) return;
        of(window).mods_ = ui::Mods::none;
        of(window).push({.kind = ui::EventKind::focus_lost}, "focus lost");
    });
    glfwSetWindowIconifyCallback(w, [](GLFWwindow* window, int iconified) {
        of(window).iconified_ = iconified == GLFW_TRUE;
        of(window).want("shown or hidden");
    });
    glfwSetWindowContentScaleCallback(w, [](GLFWwindow* window, float x, float) {
        of(window).screen_scale_ = x;
        of(window).set_scale(of(window).chosen_scale_);
    });
    glfwSetWindowPosCallback(w, [](GLFWwindow* window, int, int) { of(window).moved_ = true; });
    glfwSetWindowMaximizeCallback(w, [](GLFWwindow* window, int) { of(window).moved_ = true; });
    glfwSetFramebufferSizeCallback(w, [](GLFWwindow* window, int, int) {
        of(window).moved_ = true;
        of(window).measure();
        of(window).want("size");
    });
    // Some systems stop the loop while the window is resized. Frames are then drawn here.
    glfwSetWindowRefreshCallback(w, [](GLFWwindow* window) {
        UiWindow& self = of(window);
        self.stale_ = true;
        self.want("uncovered");
        self.measure();
        try {
            self.frame();
        } catch (...) {
            self.fault_ = std::current_exception();
        }
    });
}

void UiWindow::measure() {
    const glm::ivec2 size = window_.framebuffer_size();
    if (size.x < 1 || size.y < 1) return;
    stale_ |= size != size_;
    size_ = size;
    px_per_unit_ = window_.to_pixels({1, 1});
}

void UiWindow::push(ui::Event event, const char* reason) {
    event.mods = mods_;
    event.at = pointer_;
    event.time = last_input_ = glfwGetTime();
    ui_.push(std::move(event));
    want(reason);
}

void UiWindow::take_key(int key, int scancode, int action, int bits) {
    const bool down = action != GLFW_RELEASE;
    mods_ = mods_from(bits, key, down);
    if (is_modifier(key)) return push({.kind = ui::EventKind::none}, "modifier");
    const char* name = glfwGetKeyName(key, scancode);
    const ui::Key ours = key_from(key, name, (bits & GLFW_MOD_NUM_LOCK) != 0);
    if (ours == ui::Key::none || (down && take_scale_key(ours, name))) return;
    push({.kind = down ? ui::EventKind::key : ui::EventKind::key_up, .key = ours, .repeat = action == GLFW_REPEAT},
         "key");
}

bool UiWindow::take_scale_key(ui::Key key, const char* name) {
    const std::optional<int> step = scale_step(key, name, mods_);
    if (!step || chord_is_recorded()) return false;
    set_scale(*step == 0 ? options_.scale : next_scale(scale_, *step));
    return true;
}

/// Whether the key editor waits for a chord. If so, it also gets the window's own keys.
bool UiWindow::chord_is_recorded() const {
    const ui::Id focus = ui_.focus();
    for (const ui::Node& node : ui_.tree()) {
        if (focus != 0 && node.id == focus) return has(node.sense, ui::Sense::every_key);
    }
    return false;
}

void UiWindow::take_pointer(double x, double y) {
    glm::dvec2 at(x, y);
    if (locked_) {
        glm::ivec2 size(0);
        glfwGetWindowSize(window_.get(), &size.x, &size.y);
        at = endless_.move(at);
        if (endless_.put_back({x, y}, size)) glfwSetCursorPos(window_.get(), size.x / 2, size.y / 2);
    }
    pointer_ = glm::vec2(at * px_per_unit_);
    push({.kind = ui::EventKind::pointer}, "pointer");
}

void UiWindow::take_button(int button, bool down) {
    constexpr ui::Button buttons[] = {ui::Button::left, ui::Button::right, ui::Button::middle};
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    push({.kind = down ? ui::EventKind::press : ui::EventKind::release, .button = buttons[button]}, "button");
}

void UiWindow::take_drop(int count, const char** paths) {
    std::string lines;
    for (int i = 0; i < count; ++i) lines += std::string(i == 0 ? "" : "\n") + paths[i];
    glm::dvec2 at(0);
    glfwGetCursorPos(window_.get(), &at.x, &at.y);  // no moves are reported while something is dragged in
    pointer_ = glm::vec2(at * px_per_unit_);
    push({.kind = ui::EventKind::drop, .paths = std::move(lines)}, "drop");
}

void UiWindow::set_title(const std::string& title) {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_.get(), title.c_str());
}

void UiWindow::set_scale(float scale) {
    chosen_scale_ = scale;
    const float next = choose_scale(scale, std::getenv("LAPFX_SCALE"), screen_scale_);
    if (next == scale_) return;
    scale_ = next;
    want("scale");
}

app::WindowPlace UiWindow::place() {
    if (!std::exchange(moved_, false)) return place_;
    GLFWwindow* w = window_.get();
    place_.maximized = glfwGetWindowAttrib(w, GLFW_MAXIMIZED) == GLFW_TRUE;
    if (place_.maximized || iconified_) return place_;
    app::ScreenArea& area = place_.area;
    glfwGetWindowPos(w, &area.at.x, &area.at.y);
    glfwGetWindowSize(w, &area.size.x, &area.size.y);
    return place_;
}

void UiWindow::put(const app::WindowPlace& place) {
    int count = 0;
    GLFWmonitor** all = glfwGetMonitors(&count);
    GLFWwindow* w = window_.get();
    int left = 0, top = 0, right = 0, bottom = 0;
    glfwGetWindowFrameSize(w, &left, &top, &right, &bottom);
    std::vector<app::ScreenArea> monitors(static_cast<std::size_t>(std::max(count, 0)));
    for (std::size_t i = 0; i < monitors.size(); ++i) {
        app::ScreenArea& m = monitors[i];
        glfwGetMonitorWorkarea(all[i], &m.at.x, &m.at.y, &m.size.x, &m.size.y);
        m.at += glm::ivec2(left, top);
        m.size = glm::max(m.size - glm::ivec2(left + right, top + bottom), glm::ivec2(1));
    }
    app::WindowPlace wanted = place;
    if (!wanted) {  // nothing is known from before: where the desktop has put it, but no larger than its monitor
        glfwGetWindowPos(w, &wanted.area.at.x, &wanted.area.at.y);
        glfwGetWindowSize(w, &wanted.area.size.x, &wanted.area.size.y);
    }
    const app::WindowPlace fits = app::fitted(wanted, monitors);
    if (!place && fits.area.size == wanted.area.size) return;
    place_ = fits;
    if (!place_) return;
    glfwSetWindowSize(w, place_.area.size.x, place_.area.size.y);
    glfwSetWindowPos(w, place_.area.at.x, place_.area.at.y);
    if (place_.maximized) glfwMaximizeWindow(w);
    measure();
}

void UiWindow::close() {
    closed_ = true;
    glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
}

void UiWindow::run(const UiProgram& program) {
    program_ = &program;
    frame();
    while (glfwWindowShouldClose(window_.get()) == GLFW_FALSE || stays()) {
        wait();
        if (fault_) std::rethrow_exception(std::exchange(fault_, nullptr));
        if (reason_ != nullptr) frame();
    }
    program_ = nullptr;
}

/// Asks the program when the desktop wants to close the window. True: the window stays.
bool UiWindow::stays() {
    if (closed_ || !program_->may_close || program_->may_close()) return false;
    glfwSetWindowShouldClose(window_.get(), GLFW_FALSE);
    want("asked to close");
    return true;
}

/// Sleeps until there may be something to do. `reason_` then says what, or is null.
void UiWindow::wait() {
    ++statistics_.waits;
    const double now = glfwGetTime();
    double until = iconified_ ? ui::never : std::max(wake_at_, last_frame_ + least_between_frames);
    if (busy_) until = std::min(until, now + look_for_results);
    if (options_.log != nullptr && reason_ == nullptr && !woken_ && !busy_ && until - now >= a_rest)
        *options_.log << "rests at " << now << " s" << std::endl;
    if (reason_ != nullptr || woken_ || until <= now) {
        glfwPollEvents();
    } else if (until - now > a_long_time) {
        glfwWaitEvents();
    } else {
        glfwWaitEventsTimeout(until - now);
    }
    if (woken_.exchange(false)) want("woken");
    if (reason_ == nullptr && !iconified_ && glfwGetTime() >= wake_at_)
        want(ui_.wake_reasons().empty() ? "time" : ui_.wake_reasons().back().reason);
    if (reason_ == nullptr && busy_ && glfwGetTime() >= until) want("job");
}

void UiWindow::frame() {
    if (program_ == nullptr || in_frame_) return;
    in_frame_ = true;
    const char* reason = std::exchange(reason_, nullptr);
    if (queued_ != nullptr) {  // at most one picture is queued, so the one on the screen is never older
        glClientWaitSync(static_cast<GLsync>(queued_), GL_SYNC_FLUSH_COMMANDS_BIT, longest_queue_wait);
        glDeleteSync(static_cast<GLsync>(std::exchange(queued_, nullptr)));
    }
    last_frame_ = glfwGetTime();
    const ui::FrameOutput* output = nullptr;
    double build_began = 0, build_ended = 0;
    const auto build_ui = [&] {
        build_began = glfwGetTime();
        output = &ui_.frame({.size = size_, .scale = scale_, .time = last_frame_}, program_->build);
        build_ended = glfwGetTime();
    };
    try {
        const std::function<void()> build = std::ref(build_ui);
        if (program_->frame)
            stale_ |= program_->frame({.now = last_frame_, .visible = !iconified_, .build = build});
        else
            build();
    } catch (...) {
        in_frame_ = false;
        throw;
    }
    in_frame_ = false;
    ++statistics_.frames;
    wake_at_ = output->wake_at;
    show_pointer(*output);
    stale_ |= output->changed;
    const bool drawn = stale_ && !iconified_;
    if (drawn) {
        const double draw_began = glfwGetTime();
        renderer_.draw(*output->list, fonts_, options_.images, 0);
        statistics_.ui_seconds = build_ended - build_began + glfwGetTime() - draw_began;
        show();
    }
    if (options_.log != nullptr)
        *options_.log << "frame " << statistics_.frames << " at " << last_frame_
                      << " s: " << (reason == nullptr ? "asked for" : reason) << (drawn ? ", drawn" : "") << std::endl;
}

void UiWindow::show() {
    glfwSwapBuffers(window_.get());
    queued_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    stale_ = false;
    ++statistics_.drawn;
}

/// Sets the pointer's shape and whether it moves without bounds. When that ends, it returns to the place it had before.
void UiWindow::show_pointer(const ui::FrameOutput& output) {
    GLFWwindow* w = window_.get();
    if (output.pointer_locked != locked_) {
        locked_ = output.pointer_locked;
        glfwSetInputMode(w, GLFW_CURSOR, locked_ ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
        cursor_ = ui::Cursor::arrow;
        glfwSetCursor(w, nullptr);
        if (locked_) {
            glfwGetCursorPos(w, &locked_at_.x, &locked_at_.y);
            endless_.start(locked_at_);
        } else {
            glfwSetCursorPos(w, locked_at_.x, locked_at_.y);
            pointer_ = glm::vec2(locked_at_ * px_per_unit_);
            push({.kind = ui::EventKind::pointer}, "pointer back");
        }
    }
    if (locked_ || output.cursor == cursor_) return;
    if ((output.cursor == ui::Cursor::none) != (cursor_ == ui::Cursor::none))
        glfwSetInputMode(w, GLFW_CURSOR, output.cursor == ui::Cursor::none ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
    cursor_ = output.cursor;
    GLFWcursor*& shape = cursors_[static_cast<int>(cursor_)];
    if (shape == nullptr) shape = glfwCreateStandardCursor(glfw_shape(cursor_));  // glfwTerminate destroys them
    glfwSetCursor(w, shape);
}

}  // namespace lapfx::window
