// The same screens in our toolkit and in Dear ImGui, for `lapfx bench ui`. CPU only: from events to a draw list.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace lapfx::bench {

enum class Screen {
    mixed_100,  ///< buttons, sliders, checkboxes, text fields, formatted texts in equal parts, all visible
    mixed_1000,
    rows_10000,   ///< a list that shows the rows within 600 px
    plots,        ///< 256 bars and 8 curves of 512 points
    million,      ///< a curve of a million points, panned in each frame; ours alone
    small,        ///< the first at 640x400, as pictures in tests are
    sliders_368,  ///< panels full of sliders are drawn at 1920x1080
};

struct Drawn {
    std::size_t bytes = 0;  ///< that would go to the GPU
    int calls = 0;
    std::size_t elements = 0;  ///< instances, or vertices
};

/// One toolkit showing one screen at a time.
class Toolkit {
  public:
    virtual ~Toolkit() = default;
    virtual void show(Screen screen) = 0;
    /// Ours: from now on every frame has other colours than the one before, so that nothing drawn can be reused.
    virtual void change_all(bool) {}
    /// Builds a frame, up to the draw list. The mouse does not move.
    virtual Drawn frame() = 0;
    /// Draws the last frame with OpenGL 4.5 into `framebuffer`, of the screen's size; the context is current.
    virtual void draw(unsigned framebuffer) = 0;
    virtual std::size_t memory() const { return 0; }
};

struct ScreenSize {
    int width, height;
};
/// Large enough that all of it can be seen.
inline ScreenSize size_of(Screen screen) {
    switch (screen) {
        case Screen::mixed_100:
            return {1600, 900};
        case Screen::mixed_1000:
            return {1600, 6400};
        case Screen::rows_10000:
            return {500, 600};
        case Screen::plots:
            return {1280, 1000};
        case Screen::million:
            return {1280, 500};
        case Screen::small:
            return {640, 400};
        case Screen::sliders_368:
            return {1920, 1080};
    }
    return {1, 1};
}

std::unique_ptr<Toolkit> make_ours();
std::unique_ptr<Toolkit> make_imgui();

}  // namespace lapfx::bench
