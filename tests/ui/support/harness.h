// Drives a UI as a person would, by the names of what is on the screen; no window, no OpenGL, a clock of its own.
//
//     Harness ui([&](Ui& u) { param(u, "Speed", speed, {.maximum = 60}); });
//     ui.drag("Speed", {40, 0}, Mods::shift);
//     ui.click("Speed", {.clicks = 2}).type("12/2").key(Key::enter);
//     EXPECT_EQ(ui.value("Speed"), 6);
//
// Paths are those of ui/core/tree.h. What is scrolled out of sight is scrolled to; a target that is covered, clipped
// away or missing throws, with the whole tree in the message.
#pragma once

#include <functional>
#include <string>

#include "ui/core/tree.h"
#include "ui/core/ui.h"

namespace lapfx::ui {

struct TestClipboard : Clipboard {
    std::string text;
    std::string get() override { return text; }
    void set(const std::string& t) override { text = t; }
};

struct Click {
    int clicks = 1;
    Button button = Button::left;
    Mods mods = Mods::none;
    glm::vec2 at{0.5F, 0.5F};  ///< of its rectangle
};

class Harness {
  public:
    explicit Harness(std::function<void(Ui&)> build, glm::ivec2 size = {640, 480}, float scale = 1,
                     Shortcuts* shortcuts = nullptr, ImageStore* images = nullptr);
    /// Makes every frame from now on, as a window's program does: with the time, and what builds the UI.
    Harness& around(std::function<void(double, const std::function<void()>&)> frame);

    /// Fonts of all tests: Inter, slight hinting, whatever the host says.
    static Fonts& fonts();

    Harness& frame(double seconds = 1.0 / 60);  ///< time goes on by so much, then one frame
    Harness& settle();                          ///< frames until none is asked for; throws after 20
    Harness& send(Event event);                 ///< and a frame
    Harness& click(std::string_view path, const Click& click = {});
    Harness& right_click(std::string_view path) { return click(path, {.button = Button::right}); }
    Harness& move_to(std::string_view path, glm::vec2 at = {0.5F, 0.5F});
    Harness& move(glm::vec2 to);
    Harness& press(std::string_view path, glm::vec2 at = {0.5F, 0.5F}, Mods mods = Mods::none);
    Harness& drag_by(glm::vec2 px, Mods mods = Mods::none);  ///< with what is pressed, in four moves
    Harness& release(Mods mods = Mods::none);
    Harness& drag(std::string_view path, glm::vec2 px, Mods mods = Mods::none);
    Harness& wheel(std::string_view path, glm::vec2 notches, Mods mods = Mods::none);
    Harness& key(Key key, Mods mods = Mods::none);
    Harness& key(char letter, Mods mods = Mods::none) { return key(key_of(letter), mods); }
    /// Each character as the window gives it: its key, then its text.
    Harness& type(std::string_view utf8);
    Harness& drop(std::string_view path, const std::string& files);
    Harness& focus(std::string_view path);  ///< by Tab, from where it is

    double value(std::string_view path) const;
    std::string text(std::string_view path) const;
    std::string tip(std::string_view path) const;
    bool is(std::string_view path, Is state) const;
    Rect rect(std::string_view path) const;
    const Node& node(std::string_view path) const;
    bool exists(std::string_view path) const;
    std::string focused() const;  ///< path, or ""
    std::string dump() const;

    Ui& ui() { return ui_; }
    const FrameOutput& output() const { return *output_; }
    TestClipboard& clipboard() { return clipboard_; }
    ImageStore& images() { return *ui_.options().images; }
    double time = 100;
    glm::ivec2 size;
    float scale;

  private:
    glm::vec2 reach(std::string_view path, glm::vec2 at);

    TestClipboard clipboard_;
    ImageStore images_;
    std::function<void(Ui&)> build_;
    std::function<void(double, const std::function<void()>&)> around_;
    Ui ui_;
    const FrameOutput* output_ = nullptr;
    glm::vec2 pointer_{0};
};

}  // namespace lapfx::ui
