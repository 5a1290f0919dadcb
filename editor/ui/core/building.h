// What a widget is written with: nodes, what happened to them, and how they look. A widget is a function that takes the
// Ui, adds a node, asks what happened to it, and says how it is drawn:
//
//     bool lamp(Ui& ui, std::string_view label, Color color) {
//         Node& node = ui.leaf(Role::button, label, Sense::hover | Sense::press);
//         node.size[0] = node.size[1] = px(ui.row_height());
//         const Response r = ui.respond(node);
//         ui.draw_with<draw_lamp>(node, color);  // void draw_lamp(Painter&, const Node&, const Color&)
//         return r.clicked;
//     }
//
// Few need more: pointer and keyboard as such (input.h), menus and dialogs (overlays.h).
#pragma once

#include <initializer_list>
#include <string_view>

#include "ui/core/state.h"

namespace lapfx::ui {

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

/// What an edit did; several may be true in one frame. A gesture begins, changes the value any number of times, and
/// ends: committed, or cancelled, with the value as it was before. What lies between began and committed is one undo
/// step. A widget has one gesture at a time: if began, changed and committed come together while a gesture is open,
/// they belong to it. A widget that the program stops building in the middle of a gesture reports nothing more. Its
/// listener takes that for a commit as soon as no node is held or has the keyboard.
struct Edit {
    bool began = false, changed = false, committed = false, cancelled = false;
    explicit operator bool() const { return changed; }
    static Edit once() { return {.began = true, .changed = true, .committed = true, .cancelled = false}; }
    Edit& operator|=(const Edit& o) {
        began |= o.began, changed |= o.changed, committed |= o.committed, cancelled |= o.cancelled;
        return *this;
    }
};

class Building : public UiState {
  public:
    // --- measures ------------------------------------------------------------------------------------------------
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

    // --- nodes ---------------------------------------------------------------------------------------------------
    // References to nodes are good until the next node is added.
    /// A node without children. `label` as in id.h; empty: it has no id and senses nothing.
    Node& leaf(Role role, std::string_view label, Sense sense = Sense::none);
    /// A node whose children come until close(). Without a label it changes no ids: a mere arrangement.
    Node& open(Role role, std::string_view label, Axis axis, Sense sense = Sense::none);
    void close();
    Node& parent();
    Node& last();  ///< the newest node
    /// Until pop_seed(), all ids differ by `key`. For loops whose widgets have the same labels in each round.
    void push_seed(std::string_view key);
    void push_seed(std::uint64_t key);
    void pop_seed() { stack_.pop_back(); }
    /// The id that a node with this label would have here, for asking about it before it is built.
    Id id_of(std::string_view label) const { return hash_bytes(stack_.back().seed, split_label(label).key); }
    void push_disabled(bool disabled);
    void pop_disabled() { --disabled_, disabled_ = std::max(disabled_, 0); }
    bool disabled() const { return disabled_ > 0; }

    /// If layout changes the size of `node`, another build follows in this frame. For widgets that use their size of
    /// the last build, and for pictures that are rendered at that size.
    void follow_size(const Node& node);

    /// Returns what happened to the node and sets its states hovered, held, focused and ringed. Once for each node.
    Response respond(Node& node);
    /// Events of this build for `id`, in order.
    template <typename F>
    void events_of(Id id, F&& each) const {
        for (const auto& [target, event] : routed_) {
            if (target == id) each(event);
        }
    }
    bool has_events(Id id) const {
        if (routed_.empty()) return false;
        const Seen* seen = seen_.find(id);
        return seen != nullptr && seen->events == build_;
    }
    /// The node in the last build; null: it was not there. Until layout runs, the last build is where a widget knows
    /// its rectangle from.
    const Node* before(Id id) const;
    Rect rect_before(Id id) const;
    /// The node of the last build at the index of the next node; null: none. For nodes without an id.
    const Node* in_place_before() const;

    /// State that outlives frames. Made on first use, kept as long as the Ui.
    template <typename T>
    T& memory(Id id) {
        auto& slot = memory_[id ^ reinterpret_cast<std::uintptr_t>(&type_mark<T>)];
        if (!slot) slot = std::make_unique<Slot<T>>();
        return static_cast<Slot<T>*>(slot.get())->value;
    }

    /// `look` is copied. Function uses nothing but the look, the node, and the painter's theme and scale: if T has an
    /// operator== and none of these has changed, the drawing of the last frame is used again.
    template <auto Function, typename T>
    void draw_with(Node& node, const T& look) {
        set_drawer(node, drawer_of<Function, T>, arena().make(look));
    }
    std::string_view copy(std::string_view text) { return arena().copy(text); }
    std::string_view join(std::initializer_list<std::string_view> parts);
    Arena& arena() { return arenas_[now_]; }
    const Number* number(double value, double minimum, double maximum, double step = 0) {
        return arena().make(Number{value, minimum, maximum, step});
    }

  protected:
    using UiState::UiState;
    Node& add(Role role, std::string_view label, Sense sense, bool overlay);
    /// The index of a node in the last build and in this one; no_node: it is not there, or not yet.
    std::uint32_t index_before(Id id) const;
    std::uint32_t index_now(Id id) const;

  private:
    friend StateTable;
    bool is_alive(const Seen& seen) const {
        return seen.events == build_ || index_now(seen) != no_node || index_before(seen) != no_node;
    }
    std::uint32_t index_before(const Seen& seen) const;
    std::uint32_t index_now(const Seen& seen) const;
    Id claim(Id base, bool& duplicate);
    void take(Response& response, const Node& node, const Event& event);
    static void set_drawer(Node& node, const Drawer& drawer, const void* look);
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
};

}  // namespace lapfx::ui
