// The heart of the toolkit. A frame is: events -> the program says what there is (calls; each answers at once from
// where things were before) -> layout of the whole tree -> instances to draw.
//
//     ui::Ui ui(fonts, {.theme = &ui::dark_theme()});
//     ui.push({.kind = ui::EventKind::press, .at = {40, 20}});
//     const ui::FrameOutput& out = ui.frame({.size = {1280, 720}, .scale = 1.0F, .time = now}, [&](ui::Ui& u) {
//         ui::Column column(u);
//         if (ui::button(u, "Reset")) reset();
//         ui::param(u, "Speed", speed, {.minimum = 0, .maximum = 60, .unit = "mm/s"});
//     });
//     if (out.changed) renderer.draw(*out.list);
//
// A Ui has four faces, each in a header of its own, each a class over the one before: Building, which is all that most
// widgets use; Input; Overlays; Inspection. They are one object, and nothing in them is virtual.
//
// One thread, but wake(). The program is called again within one frame() while events are left (one key or button at a
// time, so that each meets a UI that knows of the one before), once more after an event (so that what stands above a
// widget shows what came of it, too), and when layout or hover changed: what it does must follow from its own state and
// from what widgets answer, each answer used in the build that it is given in.
#pragma once

#include "ui/core/inspection.h"

namespace lapfx::ui {

class Ui : public Inspection {
  public:
    explicit Ui(Fonts& fonts, const UiOptions& options = {}) : Inspection(fonts, options) {}

    /// An event for the next frame. Strings that are no UTF-8 and numbers that are not finite are taken as they come.
    void push(Event event) { queue_.push_back(std::move(event)); }
    template <typename Build>
    const FrameOutput& frame(const FrameInput& input, Build&& build) {
        for (int rounds = 0; rounds < most_rounds; ++rounds) {
            begin(input);
            build(*this);
            if (!end()) break;
        }
        return emit();
    }
    /// From any thread: a frame is wanted. `set_waker`: what that calls (it may come from any thread, too).
    void wake(const char* reason);
    void set_waker(std::function<void()> waker) { waker_ = std::move(waker); }
    void set_theme(const Theme& theme) { options_.theme = &theme; }
    void set_reduced_motion(bool reduced) { options_.reduced_motion = reduced; }
    void set_shortcuts(Shortcuts* shortcuts) { options_.shortcuts = shortcuts; }
    /// The last frame, every node drawn anew: for tests that what frame() gave is the same picture.
    void redraw(DrawList& list);

  private:
    static constexpr int most_rounds = 64;

    void begin(const FrameInput& input);
    bool end();  ///< gives whether another build is needed
    const FrameOutput& emit();
    void add_tooltip();
    void draw_all(Painter& painter, bool keep);
    void copy_kept_places(std::uint32_t count);
    bool take_shown();
    void draw_layer(std::uint32_t from, std::uint32_t to, std::uint8_t layer, Painter& painter, bool keep);
    void draw_node(std::uint32_t index, bool bottom, Painter& painter, bool keep);

    // routing.cpp: events against the nodes of the last build
    void take_events();
    void route(Event& event);
    void route_pointer(const Event& event);
    void route_press(Event& event);
    void route_release(const Event& event);
    void route_wheel(const Event& event);
    void route_text(const Event& event);
    void route_drop(Event& event);
    bool opens_entry(const Event& event);
    void cancel_held();
    std::uint32_t hit(std::span<const Node> all, glm::vec2 at, Sense senses) const;
    void find_hot(std::span<const Node> all);
    // navigation.cpp: keys
    void route_key(const Event& event);
    bool takes_under_pointer(const Event& event);
    bool navigate(const Event& event);
    void move_focus(int step);
    void move_panel(int step);
    bool move_by_arrow(Key key);
    bool scroll_by_key(Key key);
    void send_to_notice(const Event& event);
    bool send_to_around(const Event& event, Sense sense);
    std::uint32_t key_place();
};

}  // namespace lapfx::ui

#include "ui/core/box.h"
