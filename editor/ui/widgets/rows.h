// What tables and thumbnails have in common: lines of items, of which only those in sight are built; a selection; the
// keys and presses that move it. The list has the keyboard, not its items.
//
// Press selects; with Ctrl one more or one less, with Shift from the last to this one (where several may be selected).
// Arrows, PageUp, PageDown, Home and End go to another item and select it, with Shift all between; Enter or a double
// click opens. Letters go to the next item that begins with them, where items have names.
#pragma once

#include "ui/widgets/scroll.h"

namespace lapfx::ui {

/// A callable for the time of one call; keeps nothing, allocates nothing.
template <typename Signature>
class FunctionRef;
template <typename Result, typename... Arguments>
class FunctionRef<Result(Arguments...)> {
  public:
    template <typename F>
    FunctionRef(const F& f)  // NOLINT: is given as it is
        : object_(&f), call_([](const void* object, Arguments... arguments) -> Result {
              return (*static_cast<const F*>(object))(arguments...);
          }) {}
    Result operator()(Arguments... arguments) const { return call_(object_, arguments...); }

  private:
    const void* object_;
    Result (*call_)(const void*, Arguments...);
};

inline constexpr std::size_t no_row = ~std::size_t{0};
inline constexpr std::uint64_t no_key = ~std::uint64_t{0};

/// Which items are selected, by keys of the program's: sorting and filtering keep it.
struct Selection {
    std::vector<std::uint64_t> keys;  ///< ascending
    std::uint64_t current = no_key;   ///< where the keyboard is
    std::uint64_t anchor = no_key;    ///< where Shift selects from

    bool has(std::uint64_t key) const { return std::binary_search(keys.begin(), keys.end(), key); }
    void only(std::uint64_t key);
    void toggle(std::uint64_t key);
    void add(std::uint64_t key);
    void clear() { keys.clear(), current = anchor = no_key; }
};

using NameOf = FunctionRef<std::string_view(std::size_t)>;

struct RowListOptions {
    std::size_t count = 0;
    float line_height = 24;   ///< px
    std::size_t columns = 1;  ///< items in a line
    bool multiple = false;
    const NameOf* name_of = nullptr;  ///< of an item, to be found by typing; must last as long as the list
    ScrollOptions area;
};

struct RowEvents {
    bool selected = false;         ///< the selection has changed
    std::size_t opened = no_row;   ///< Enter or a double click
    std::size_t context = no_row;  ///< right button or Menu key: for a menu; it is selected by then
    std::size_t marked = no_row;   ///< space, where only one can be selected
    std::size_t hovered = no_row;  ///< under the pointer
};

class RowList {
  public:
    using KeyOf = FunctionRef<std::uint64_t(std::size_t)>;

    /// `key_of(item)`: different for each item, never no_key. Called for the items in sight, and for all items when a
    /// key moves the selection. Must last as long as the list.
    RowList(Ui& ui, std::string_view label, Selection& selection, const KeyOf& key_of, const RowListOptions& options);

    std::size_t first() const { return std::min(window_.first() * options_.columns, options_.count); }
    std::size_t last() const { return std::min(window_.last() * options_.columns, options_.count); }
    /// Call it once for each item that is built, with a node that senses `item_sense`. Sets its states selected and
    /// hovered.
    Response respond(std::size_t item, Node& node);
    static constexpr Sense item_sense = Sense::hover | Sense::press | Sense::context;
    /// Whether this item shows the ring of the keyboard.
    bool ringed(std::size_t item) const;
    const RowEvents& events() const { return events_; }
    ScrollArea& area() { return area_; }

  private:
    void take_keys();
    void open(std::size_t item);
    void take_letter(const Event& event);
    void go(std::size_t item, Mods mods);
    void select_between(std::uint64_t from, std::size_t to);
    std::size_t find(std::uint64_t key) const;

    Ui& ui_;
    Selection& selection_;
    KeyOf key_of_;
    RowListOptions options_;
    RowEvents events_;
    ScrollArea area_;
    LineWindow window_;
};

/// The item that a key leads to from `at` (no_row: from nowhere); no_row: none of these keys. `page`: lines in sight.
std::size_t item_after(Key key, std::size_t at, std::size_t count, std::size_t columns, std::size_t page);

/// The ground of an item: selected, hovered, where the keyboard is.
void draw_item_ground(Painter& painter, const Node& node, bool ringed);

}  // namespace lapfx::ui
