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
// One thread, but wake(). The program is called again within one frame() while events are left (one key or button at a
// time, so that each meets a UI that knows of the one before), once more after an event (so that what stands above a
// widget shows what came of it, too), and when layout or hover changed: what it does must follow from its own state and
// from what widgets answer, each answer used in the build that it is given in.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "ui/core/arena.h"
#include "ui/core/event.h"
#include "ui/core/node.h"
#include "ui/core/overlay.h"
#include "ui/core/state_table.h"
#include "ui/core/theme.h"
#include "ui/draw/images.h"
#include "ui/draw/painter.h"
#include "ui/text/fonts.h"

namespace lapfx::ui {

/// What shortcuts go to: the command table (shell/commands.h).
class Shortcuts {
  public:
    virtual ~Shortcuts() = default;
    /// Runs what belongs to the chord; gives whether there was anything.
    virtual bool press(Key key, Mods mods) = 0;
};

struct UiOptions {
    const Theme* theme = &dark_theme();
    Clipboard* clipboard = nullptr;
    ImageStore* images = nullptr;
    Shortcuts* shortcuts = nullptr;
    bool reduced_motion = false;  ///< carets do not blink, progress does not run
    bool debug = false;           ///< labels that clash are framed in red
};

struct FrameInput {
    glm::ivec2 size{1280, 720};  ///< px of the framebuffer; below 1 counts as 1
    float scale = 1;             ///< 0.5 to 4
    double time = 0;             ///< s, any origin, never backwards
};

enum class Cursor : std::uint8_t { arrow, text, hand, resize_x, resize_y, move, crosshair, none };

inline constexpr double never = 1e300;

struct FrameOutput {
    const DrawList* list = nullptr;  ///< until the next frame
    bool changed = true;             ///< the picture differs from the last one
    Cursor cursor = Cursor::arrow;
    bool pointer_locked = false;  ///< hide the pointer and let it go on without bounds; put it back afterwards
    Rect caret{};                 ///< where text is typed, for input methods; empty: nowhere
    double wake_at = never;  ///< s: the next frame is due then although nothing may happen; `time` or before: at once
};

/// Why a frame was asked for.
struct WakeReason {
    double time = 0;
    const char* reason = "";
};

/// What happened to one widget since the last build.
struct Response {
    bool hovered = false, held = false, focused = false;
    bool pressed = false, released = false;  ///< left button
    bool clicked = false;                    ///< released over it, or Enter or space
    bool cancelled = false;
    bool context = false;  ///< right button, or the Menu key
    bool focus_in = false, focus_out = false;
    bool by_tab = false;           ///< focus_in through Tab
    std::uint8_t clicks = 0;       ///< of `pressed`: 2 is a double click
    Button button = Button::left;  ///< of `held` and `pressed`
    Mods mods = Mods::none;
    glm::vec2 pointer{0};  ///< px in the window
    glm::vec2 pressed_at{0};
    glm::vec2 drag{0};  ///< px that the held pointer moved since the last build
    float wheel = 0;    ///< notches
};

/// What came of an edit; bits, since all may happen in one frame. A gesture is began, changed any number of times, and
/// then either committed or cancelled; when cancelled the value is as it was. An undo step lies between began and
/// committed. One gesture at a time: all three at once, from a widget with one open, belong to that one. A widget that
/// is no longer built in the middle of a gesture reports nothing more: for a listener that is a commit, as soon as
/// nothing is held and focused.
struct Edit {
    bool began = false, changed = false, committed = false, cancelled = false;
    explicit operator bool() const { return changed; }
    static Edit once() { return {.began = true, .changed = true, .committed = true, .cancelled = false}; }
    Edit& operator|=(const Edit& o) {
        began |= o.began, changed |= o.changed, committed |= o.committed, cancelled |= o.cancelled;
        return *this;
    }
};

class Ui {
  public:
    explicit Ui(Fonts& fonts, const UiOptions& options = {});
    Ui(const Ui&) = delete;
    Ui& operator=(const Ui&) = delete;

    // --- one frame -----------------------------------------------------------------------------------------------
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
    void wake_at(double time, const char* reason);
    std::span<const WakeReason> wake_reasons() const { return {reasons_.data(), reason_count_}; }  ///< the last 64
    void clear_wake_reasons() { reason_count_ = 0; }

    void set_theme(const Theme& theme) { options_.theme = &theme; }
    void set_reduced_motion(bool reduced) { options_.reduced_motion = reduced; }
    void set_shortcuts(Shortcuts* shortcuts) { options_.shortcuts = shortcuts; }
    const UiOptions& options() const { return options_; }
    const Theme& theme() const { return *options_.theme; }
    Fonts& fonts() { return fonts_; }
    float scale() const { return input_.scale; }
    double time() const { return input_.time; }
    glm::vec2 window() const { return glm::vec2(input_.size); }
    /// px of `ems` font heights, whole.
    float em(float ems) const { return whole(ems * theme().font_size * input_.scale); }
    float row_height() const { return em(theme().row_height); }
    TextStyle text_style(float relative_size = 1, Weight weight = Weight::regular) const;
    TextStyle number_style() const;
    float text_width(std::string_view text) { return fonts_.run(text, text_style()).width; }

    // --- building: for widgets -----------------------------------------------------------------------------------
    // References to nodes are good until the next node is added.
    /// A node without children. `label` as in id.h; empty: it has no id and senses nothing.
    Node& leaf(Role role, std::string_view label, Sense sense = Sense::none);
    /// A node whose children come until close(). Without a label it changes no ids: a mere arrangement.
    Node& open(Role role, std::string_view label, Axis axis, Sense sense = Sense::none);
    void close();
    Node& parent() { return nodes()[stack_.back().node]; }
    Node& last() { return nodes().back(); }  ///< the newest node
    /// Ids of what is built until pop_seed() differ by `key`: for loops over things that have names of their own.
    void push_seed(std::string_view key);
    void push_seed(std::uint64_t key);
    void pop_seed() { stack_.pop_back(); }
    /// The id that a node with this label would have here: for what must be known of it before it is built.
    Id id_of(std::string_view label) const { return hash_bytes(stack_.back().seed, split_label(label).key); }
    void push_disabled(bool disabled);
    void pop_disabled() { --disabled_, disabled_ = std::max(disabled_, 0); }
    bool disabled() const { return disabled_ > 0; }

    /// Another build follows in this frame when layout gives `node` another size than it had: for what is placed inside
    /// it by its size of before, and for pictures that are made to its size.
    void follow_size(const Node& node) { followed_.push_back(static_cast<std::uint32_t>(&node - nodes().data())); }

    /// What happened to it, and its states hovered, held, focused, ringed. Once for each node.
    Response respond(Node& node);
    /// Events of this build for `id`, in order.
    template <typename F>
    void events_of(Id id, F&& each) const {
        for (const auto& [target, event] : routed_) {
            if (target == id) each(event);
        }
    }
    bool has_events(Id id) {
        const Seen* s = seen_.find(id);
        return s != nullptr && s->events == build_;
    }
    /// Of the last build; null: it was not there. Any widget's place before this frame's layout is the one of before.
    const Node* before(Id id);
    Rect rect_before(Id id);
    /// What the last build had where the next node will stand; null: nothing. For what has no id.
    const Node* in_place_before() const {
        const std::size_t index = built_[now_].size();
        return index < nodes_before().size() ? &nodes_before()[index] : nullptr;
    }

    /// State that outlives frames. Made on first use, kept as long as the Ui.
    template <typename T>
    T& memory(Id id) {
        auto& slot = memory_[id ^ reinterpret_cast<std::uintptr_t>(&type_mark<T>)];
        if (!slot) slot = std::make_unique<Slot<T>>();
        return static_cast<Slot<T>*>(slot.get())->value;
    }

    /// `look` is copied. Function draws from it, from the node and from the painter's theme and scale alone: where T
    /// has an operator== and nothing of these has changed, what it drew in the last frame is used again.
    template <auto Function, typename T>
    void draw_with(Node& node, const T& look) {
        node.arg = arena().make(look);
        node.drawer = &drawer_of<Function, T>;
    }
    std::string_view copy(std::string_view text) { return arena().copy(text); }
    std::string_view join(std::initializer_list<std::string_view> parts);
    Arena& arena() { return arenas_[now_]; }
    const Number* number(double value, double minimum, double maximum, double step = 0) {
        return arena().make(Number{value, minimum, maximum, step});
    }

    // --- pointer and keyboard ------------------------------------------------------------------------------------
    Id hot() const { return hot_; }
    Id held(Button button = Button::left) const { return active_[static_cast<int>(button)]; }
    Id focus() const { return focus_; }
    bool focus_ringed() const { return ringed_; }
    void set_focus(Id id, bool by_keyboard = false);
    glm::vec2 pointer() const { return pointer_; }
    bool pointer_inside() const { return pointer_inside_; }
    Mods mods() const { return mods_; }
    /// Whether a key is down now; for a flicker on a held key.
    bool key_down(Key key) const;
    void set_cursor(Cursor cursor) { output_.cursor = cursor; }
    void lock_pointer() { output_.pointer_locked = true; }
    void set_caret(const Rect& caret) { output_.caret = caret; }
    Clipboard* clipboard() const { return options_.clipboard; }
    /// Scrolls every area around it so that it can be seen; from the next build on.
    void reveal(Id id);
    /// Runs what belongs to the chord unless a dialog is in the way; gives whether there was anything.
    bool press_shortcut(Key key, Mods mods);
    /// The program is called once more before this frame is drawn: what was built earlier in it rests on what has
    /// changed since.
    void build_again() { again_ = true; }
    /// Files dropped where no node wanted them, one a line; empty: none in this build.
    std::string_view dropped() const { return dropped_; }

    // --- overlays ------------------------------------------------------------------------------------------------
    void open_overlay(std::string_view name, OverlayKind kind, const Placement& placement);
    void close_overlay(std::string_view name);
    void close_top_overlay();
    /// Those over it that can have the keyboard, the top one first; gives whether there were any.
    bool close_overlays_over(std::string_view name);
    bool overlay_open(std::string_view name) const;
    /// Open, and no other that can have the keyboard lies over it.
    bool overlay_on_top(std::string_view name) const;
    /// Opens its node when the overlay is open (then close_overlay_node() must follow), else gives null. An overlay
    /// that is not built in a frame is closed. `label`: what it is called in the tree.
    Node* open_overlay_node(std::string_view name, Role role, std::string_view label, Axis axis);
    void close_overlay_node() { close(); }
    std::size_t overlay_count() const { return overlays_.size(); }

    // --- after a frame: tests, dumps, accessibility ---------------------------------------------------------------
    /// Of the last frame() that came to its end.
    std::span<const Node> tree() const { return tree_; }
    std::size_t duplicates() const { return duplicates_; }
    int builds() const { return static_cast<int>(build_); }  ///< so far
    /// The last frame, every node drawn anew: what frame() gave has to be the same picture.
    void redraw(DrawList& list);
    std::size_t memory_used() const;  ///< bytes, of nodes, arenas, tables and draw list

  private:
    static constexpr int most_rounds = 64;
    struct SlotBase {
        virtual ~SlotBase() = default;
    };
    template <typename T>
    struct Slot : SlotBase {
        T value{};
    };
    template <typename T>
    static inline char type_mark = 0;
    template <typename T>
    static constexpr auto same_looks() -> bool (*)(const void*, const void*) {
        if constexpr (requires(const T& a) { a == a; }) {
            return [](const void* a, const void* b) { return *static_cast<const T*>(a) == *static_cast<const T*>(b); };
        } else {
            return nullptr;
        }
    }
    template <auto Function, typename T>
    static constexpr Drawer drawer_of = {
        [](Painter& p, const Node& n, const void* look) { Function(p, n, *static_cast<const T*>(look)); },
        same_looks<T>()};
    struct Level {
        std::uint32_t node;
        Id seed;
        std::uint8_t layer;
    };

    void begin(const FrameInput& input);
    bool end();  ///< gives whether another build is needed
    const FrameOutput& emit();
    std::vector<Node>& nodes() { return built_[now_]; }
    const std::vector<Node>& nodes_before() const { return built_[1 - now_]; }
    const Seen& claim(const Label& label, bool& duplicate);
    Node& add(Role role, std::string_view label, Sense sense, bool overlay);
    void add_tooltip();
    void close_overlay_at(std::size_t index);
    void close_popups();
    void drop_overlays_not_built();
    void remember_anchors();
    void focus_new_overlay();
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
    void send(Id target, const Event& event);
    void take(Response& response, const Node& node, const Event& event);
    std::uint32_t hit(std::span<const Node> all, glm::vec2 at, Sense senses) const;
    void find_hot(std::span<const Node> all);
    std::uint32_t index_before(Id id);
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
    std::uint8_t focus_layer() const;

    Fonts& fonts_;
    UiOptions options_;
    FrameInput input_;
    FrameOutput output_;
    DrawList list_, shown_;  ///< of this frame and of the one before
    /// What `shown_` was drawn with. Where it is another now, nothing of it can be used again.
    struct DrawnWith {
        const Theme* theme = nullptr;
        float scale = 0;
        std::uint32_t resets = 0, build = 0;
        friend bool operator==(const DrawnWith&, const DrawnWith&) = default;
    } drawn_with_;
    bool reuse_ = false;
    bool drawn_anew_ = false;  ///< else all instances are those of `shown_`, in their places

    std::vector<Node> built_[2];
    Arena arenas_[2];
    int now_ = 0;
    std::uint32_t build_ = 0;
    std::span<const Node> tree_;
    std::vector<Level> stack_;
    std::vector<std::uint32_t> followed_;     ///< nodes of follow_size()
    std::vector<std::uint32_t> drawn_later_;  ///< nodes that draw once their children have
    StateTable seen_;
    std::unordered_map<Id, std::unique_ptr<SlotBase>> memory_;
    int disabled_ = 0;
    std::size_t duplicates_ = 0, duplicates_now_ = 0;

    std::vector<Event> queue_;
    std::size_t queue_head_ = 0;
    std::vector<std::pair<Id, Event>> routed_;
    std::vector<std::pair<Id, Event>> late_;  ///< sent by widgets or the program, for the next build
    bool routing_ = false;
    bool key_ran_shortcut_ = false;  ///< the text that comes with the key is no text then
    int unsettled_ = 0;              ///< frames in a row that did not come to rest
    bool letters_missing_ = false;   ///< in the frame before
    std::string dropped_;
    Id pressed_hot_ = 0;  ///< was pressed since the pointer came to it
    Id hot_ = 0, hot_shown_ = 0, active_[3] = {}, focus_ = 0, reveal_ = 0;
    bool ringed_ = false, pointer_inside_ = false;
    glm::vec2 pointer_{-1, -1}, moved_{0}, pressed_at_{0}, rested_at_{-1, -1};
    double rested_since_ = 0, last_press_ = -1e9, scrolled_at_ = -1e9;
    Id last_pressed_ = 0;
    int clicks_ = 0;
    Mods mods_ = Mods::none;
    std::vector<Key> keys_down_;
    Id typed_for_ = 0;       ///< had the keyboard when the newest key went down
    bool key_came_ = false;  ///< and no text or key_up since
    bool again_ = false;     ///< another build is wanted before drawing
    bool fresh_ = true;      ///< the next build is the first of its frame
    int settled_ = 0;        ///< builds of this frame that no event asked for

    std::vector<Overlay> overlays_;
    std::vector<std::uint32_t> overlay_roots_;  ///< node of each overlay built, in order of overlays_

    std::function<void()> waker_;
    std::atomic<const char*> woken_ = nullptr;
    std::array<WakeReason, 64> reasons_;
    std::size_t reason_count_ = 0;
};

/// Children side by side or below each other.
struct BoxOptions {
    Size width = fit(), height = fit();
    float gap = -1;     ///< em; negative: the theme's
    float padding = 0;  ///< em
    ChildAlign cross = ChildAlign::stretch, main = ChildAlign::start;
};
class Box {
  public:
    Box(Ui& ui, Axis axis, const BoxOptions& options);
    ~Box() { ui_.close(); }
    Box(const Box&) = delete;
    Box& operator=(const Box&) = delete;

  private:
    Ui& ui_;
};
struct Row : Box {
    explicit Row(Ui& ui, const BoxOptions& options = {.cross = ChildAlign::center}) : Box(ui, Axis::x, options) {}
};
struct Column : Box {
    explicit Column(Ui& ui, const BoxOptions& options = {}) : Box(ui, Axis::y, options) {}
};
/// A ground with a name: F6 goes from one to the next.
class Panel {
  public:
    Panel(Ui& ui, std::string_view label,
          const BoxOptions& options = {.width = grow(), .height = grow(), .padding = 0.6F});
    ~Panel() { ui_.close(); }
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;

  private:
    Ui& ui_;
};
/// What is left over goes here.
void spacer(Ui& ui, float weight = 1);
/// Nothing, of so many em along the parent's axis.
void space(Ui& ui, float ems);

}  // namespace lapfx::ui
