// Drives a UI as a person would, by the names of the widgets on the screen. It has no window and no OpenGL, and a clock
// of its own.
//
//     Harness ui([&](Ui& u) { param(u, "Speed", speed, {.maximum = 60}); });
//     ui.drag("Speed", {40, 0}, Mods::shift);
//     ui.click("Speed", {.clicks = 2}).type("12/2").key(Key::enter);
//     EXPECT_EQ(ui.value("Speed"), 6);
//
// Paths are those of ui/core/tree.h. A target outside the visible part of a scroll area is scrolled to. A target that
// is covered, clipped away or missing throws, with the whole tree in the message.
#pragma once

#include <functional>
#include <string>

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
    glm::vec2 at{0.5F, 0.5F};  ///< fractions of its rectangle
};

class Harness {
  public:
    explicit Harness(std::function<void(Ui&)> build, glm::ivec2 size = {640, 480}, float scale = 1,
                     Shortcuts* shortcuts = nullptr, ImageStore* images = nullptr);
    /// Calls `frame` for every frame from now on, with the time and a function that builds the UI, as a window does.
    Harness& around(std::function<void(double, const std::function<void()>&)> frame);

    /// The fonts of all tests: Inter with slight hinting; settings of the host are ignored.
    static Fonts& fonts();

    Harness& frame(double seconds = 1.0 / 60);  ///< advances the time and makes one frame
    Harness& settle();                          ///< makes frames until none is asked for; throws after 20
    Harness& send(Event event);                 ///< sends the event and makes a frame
    Harness& click(std::string_view path, const Click& click = {});
    Harness& right_click(std::string_view path) { return click(path, {.button = Button::right}); }
    Harness& move_to(std::string_view path, glm::vec2 at = {0.5F, 0.5F});
    Harness& move(glm::vec2 to);
    Harness& press(std::string_view path, glm::vec2 at = {0.5F, 0.5F}, Mods mods = Mods::none);
    Harness& drag_by(glm::vec2 px, Mods mods = Mods::none);  ///< in four moves, with the button that is pressed
    Harness& release(Mods mods = Mods::none);
    Harness& drag(std::string_view path, glm::vec2 px, Mods mods = Mods::none);
    Harness& wheel(std::string_view path, glm::vec2 notches, Mods mods = Mods::none);
    Harness& key(Key key, Mods mods = Mods::none);
    Harness& key(char letter, Mods mods = Mods::none) { return key(key_of(letter), mods); }
    /// Sends each character as the window does: its key, then its text.
    Harness& type(std::string_view utf8);
    Harness& drop(std::string_view path, const std::string& files);
    Harness& focus(std::string_view path);  ///< with Tab, from the present focus

    double value(std::string_view path) const;
    std::string text(std::string_view path) const;
    std::string tip(std::string_view path) const;
    bool is(std::string_view path, Is state) const;
    Rect rect(std::string_view path) const;
    const Node& node(std::string_view path) const;
    bool exists(std::string_view path) const;
    std::string focused() const;  ///< the path of the focus, or ""
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
