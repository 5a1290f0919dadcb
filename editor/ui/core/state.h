// All data of a Ui. The classes Building, Input, Overlays, Inspection and Ui each derive from the one before: they
// divide the functions by who calls them, and all reach the data without another pointer. Only their headers include
// this one. What a node is made of is known here only by name: a widget that lays one out includes node.h.
#pragma once

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "ui/core/arena.h"
#include "ui/core/event.h"
#include "ui/core/node_parts.h"
#include "ui/core/overlay.h"
#include "ui/core/state_table.h"
#include "ui/draw/images.h"
#include "ui/paint/painter.h"
#include "ui/paint/theme.h"
#include "ui/text/fonts.h"

namespace lapfx::ui {

/// Receives shortcuts: the command table (shell/commands.h).
class Shortcuts {
  public:
    virtual ~Shortcuts() = default;
    /// Runs the command of the chord. Returns whether there was one.
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

enum class Cursor : std::uint8_t { arrow, text, resize_x, resize_y, move, crosshair, none };

inline constexpr double never = 1e300;

struct FrameOutput {
    const DrawList* list = nullptr;  ///< until the next frame
    bool changed = true;             ///< the picture differs from the last one
    Cursor cursor = Cursor::arrow;
    bool pointer_locked = false;  ///< hide the pointer and let it move without bounds; put it back afterwards
    Rect caret{};                 ///< where text is typed, for input methods; empty: nowhere
    double wake_at = never;  ///< s: the next frame is due then although nothing may happen; `time` or before: at once
};

/// Why a frame was asked for.
struct WakeReason {
    double time = 0;
    const char* reason = "";
};

class UiState {
  public:
    UiState(const UiState&) = delete;
    UiState& operator=(const UiState&) = delete;

  protected:
    UiState(Fonts& fonts, const UiOptions& options);
    ~UiState();

    struct SlotBase {
        virtual ~SlotBase() = default;
    };
    template <typename T>
    struct Slot : SlotBase {
        T value{};
    };
    struct Level {
        std::uint32_t node;
        Id seed;
        std::uint8_t layer;
    };

    std::vector<Node>& nodes() { return built_[now_]; }
    const std::vector<Node>& nodes_before() const { return built_[1 - now_]; }

    Fonts& fonts_;
    UiOptions options_;
    FrameInput input_;
    FrameOutput output_;
    DrawList list_, shown_;  ///< the list of this frame, and that of the one before
    /// What `shown_` was drawn with. If any of it differs now, nothing of `shown_` can be used again.
    struct DrawnWith {
        const Theme* theme = nullptr;
        float scale = 0;
        std::uint32_t resets = 0, build = 0;
        friend bool operator==(const DrawnWith&, const DrawnWith&) = default;
    } drawn_with_;
    bool reuse_ = false;
    bool drawn_anew_ = false;  ///< false: so far all instances are equal to those of `shown_`

    std::vector<Node> built_[2];
    Arena arenas_[2];
    int now_ = 0;
    std::uint32_t build_ = 0;
    const std::vector<Node>* tree_ = nullptr;  ///< of the last frame that was completed
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
    bool letters_missing_ = false;   ///< letters were missing in the frame before
    std::string dropped_;
    Id pressed_hot_ = 0;  ///< was pressed since the pointer came to it
    Id hot_ = 0, active_[3] = {}, focus_ = 0, reveal_ = 0;
    bool ringed_ = false, pointer_inside_ = false;
    glm::vec2 pointer_{-1, -1}, moved_{0}, pressed_at_{0}, rested_at_{-1, -1};
    double rested_since_ = 0, last_press_ = -1e9, scrolled_at_ = -1e9;
    Id last_pressed_ = 0;
    int clicks_ = 0;
    Mods mods_ = Mods::none;
    std::vector<Key> keys_down_;
    Id typed_for_ = 0;       ///< had the keyboard when the newest key went down
    bool key_came_ = false;  ///< a key came, and no text or key_up since
    bool again_ = false;     ///< another build is wanted before drawing
    bool fresh_ = true;      ///< the next build is the first of its frame
    int settled_ = 0;        ///< builds of this frame that no event asked for

    /// What explain() said last.
    struct Explained {
        Id of = 0;
        std::string text;
        double until = 0;         ///< s
        std::uint32_t build = 0;  ///< in which it was said
    } explained_;

    std::vector<Overlay> overlays_;
    std::vector<std::uint32_t> overlay_roots_;  ///< node of each overlay built, in order of overlays_

    std::function<void()> waker_;
    std::atomic<const char*> woken_ = nullptr;
    std::array<WakeReason, 64> reasons_;
    std::size_t reason_count_ = 0;
};

}  // namespace lapfx::ui
