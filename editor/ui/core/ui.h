// The core of the toolkit. A frame is: events, then a build (the program calls widgets; each answers at once, from the
// rectangles of the last build), then the layout of the whole tree, then the list of what is drawn.
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
// The functions of a Ui are divided by who calls them, each part a class in a header of its own: Building (building.h)
// is all that most widgets need; Input, Overlays and Inspection follow; what is in this header is for the program that
// owns the Ui.
//
// One thread only, except for wake(). One frame() may call the program several times. It handles one key or button per
// build, so that each event meets a UI that knows of the event before. After the last event it builds again, so
// that widgets above the one that was used show the result as well. It also builds again when layout or hover has
// changed. So a build must depend on nothing but the state of the program and the answers of widgets, and must use each
// answer in the build that gives it.
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
    /// Asks for a frame, from any thread. `set_waker`: the function that wake() calls, on the same thread.
    void wake(const char* reason);
    void set_waker(std::function<void()> waker) { waker_ = std::move(waker); }
    void set_theme(const Theme& theme) { options_.theme = &theme; }
    void set_reduced_motion(bool reduced) { options_.reduced_motion = reduced; }
    void set_shortcuts(Shortcuts* shortcuts) { options_.shortcuts = shortcuts; }
    /// Draws every node of the last frame again. Tests compare this with the list that frame() returned.
    void redraw(DrawList& list);

  private:
    static constexpr int most_rounds = 64;

    void begin(const FrameInput& input);
    bool end();  ///< gives whether another build is needed
    const FrameOutput& emit();
    void add_tooltip();
    bool add_explanation();
    void put_tip(std::string_view tip, const Placement& placement);
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
    Id text_field_of_popup() const;
    bool opens_entry(const Event& event);
    void cancel_held();
    std::uint32_t hit(std::span<const Node> all, glm::vec2 at, Sense senses) const;
    void find_hot(std::span<const Node> all);
    // navigation.cpp: keys
    void route_key(const Event& event);
    bool takes_under_pointer(const Event& event);
    Id picture_for(const Event& event) const;
    bool is_for_picture(const Node& focused, const Event& event) const;
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
