// Keys: first the node that has the focus may take them, then shortcuts, then they move the focus.
#include <algorithm>

#include "ui/core/node.h"
#include "ui/core/ui.h"

namespace lapfx::ui {

namespace {

bool takes_when_editing(Key key, Mods mods) {
    if (has(mods, Mods::alt)) return false;
    switch (key) {
        case Key::escape:
        case Key::enter:
        case Key::backspace:
        case Key::del:
        case Key::left:
        case Key::right:
        case Key::up:
        case Key::down:
        case Key::home:
        case Key::end:
        case Key::page_up:
        case Key::page_down:
            return true;
        default:
            break;
    }
    if (!has(mods, Mods::command)) return printable(key);
    if (has(mods, Mods::shift)) return key == key_of('Z');  // the others are the program's
    for (const char c : {'A', 'C', 'V', 'X', 'Z', 'Y'}) {
        if (key == key_of(c)) return true;
    }
    return false;
}

/// Whether a node with these senses takes this key.
bool takes(Sense sense, Key key, Mods mods) {
    const bool plain = !has(mods, Mods::command) && !has(mods, Mods::alt);
    if (has(sense, Sense::every_key)) return true;
    if (key == Key::tab) return plain && !has(mods, Mods::shift) && has(sense, Sense::completes);
    if (has(sense, Sense::editing)) return takes_when_editing(key, mods);
    if (has(sense, Sense::keys) && plain && key != Key::tab && key != Key::f6) return true;
    switch (key) {
        case Key::enter:
            return plain && (has(sense, Sense::activate) || has(sense, Sense::typing) || has(sense, Sense::digits));
        case Key::space:
            return plain && (has(sense, Sense::activate) || has(sense, Sense::typing));
        case Key::left:
        case Key::right:
            return !has(mods, Mods::alt) && has(sense, Sense::arrows_x);
        case Key::up:
        case Key::down:
            return !has(mods, Mods::alt) && has(sense, Sense::arrows_y);
        case Key::page_up:
        case Key::page_down:
            return plain && has(sense, Sense::pages);
        case Key::home:
        case Key::end:
            return !has(mods, Mods::alt) && has(sense, Sense::extremes);
        case Key::backspace:
        case Key::del:
            return plain && has(sense, Sense::erase);
        case Key::escape:
            return has(sense, Sense::escape);
        case Key::menu:
            return has(sense, Sense::context);
        default:
            break;
    }
    if (has(mods, Mods::command) && has(sense, Sense::copying))
        return key == key_of('C') || key == key_of('V') || key == key_of('X');
    if (!plain || !printable(key)) return false;
    const char c = static_cast<char>(key);
    return has(sense, Sense::typing) || (has(sense, Sense::digits) && ((c >= '0' && c <= '9') || c == '-' || c == '.' ||
                                                                       c == ',' || c == '=' || c == '+'));
}

std::string_view keys_of(TypedKeys keys) {
    switch (keys) {
        case TypedKeys::timeline:
            return "FIJKLOX";
        case TypedKeys::plot:
            return "FL=-+";
        case TypedKeys::curve_point:
            return "I0123456789.,-";
        case TypedKeys::comparison:
            return "FX01=-+";
        case TypedKeys::all:
            break;
    }
    return {};
}

bool takes(const Node& node, Key key, Mods mods) {
    const bool plain = !has(mods, Mods::command) && !has(mods, Mods::alt);
    if (plain && printable(key) && key != Key::space && has(node.sense, Sense::typing) &&
        !has(node.sense, Sense::editing) && node.typed != TypedKeys::all &&
        keys_of(node.typed).find(static_cast<char>(key)) == std::string_view::npos)
        return false;
    return takes(node.sense, key, mods);
}

/// A button or combo that was clicked has the keyboard, but shows no ring. Space then runs the program's shortcut, if
/// there is one; with the ring it presses the button.
bool only_activates(Sense sense) {
    return has(sense, Sense::activate) && !has(sense, Sense::typing | Sense::editing | Sense::keys | Sense::every_key);
}

/// Whether the key would open the entry of a number. Without a ring the person works with the pointer: a digit is then
/// a shortcut and must not change the value that was dragged last.
bool begins_entry(Sense sense, Key key) {
    return has(sense, Sense::digits) && !has(sense, Sense::typing | Sense::editing | Sense::keys | Sense::every_key) &&
           printable(key);
}

/// Keys that a node which was only clicked, and shows no ring, leaves to the program: the person looks elsewhere by
/// now. A letter would change the choice of a combo, Home would bring another tab to the front, Delete would close one.
bool leaves(const Node& node, Key key) {
    if (node.role == Role::combo) return printable(key) && key != Key::space;
    if (node.role == Role::tab) return key != Key::left && key != Key::right;
    return begins_entry(node.sense, key);
}

/// Keys that open a menu of the bar.
bool opens_bar(Key key, Mods mods) {
    if (key == Key::f10) return mods == Mods::none;
    return mods == Mods::alt && printable(key);
}

/// Scrolls the area by a page or to an end. Returns whether it could go that way.
bool scroll_area(const Node& area, Key key, float row) {
    if (area.scroll == nullptr || !area.scrolls[1]) return false;
    ScrollState& scroll = *area.scroll;
    const float most = std::max(0.0F, scroll.content.y - scroll.view.y);
    const float page = std::max(1.0F, scroll.view.y - row);  // one row of the last page stays in sight
    float to = key == Key::home ? 0.0F : most;
    if (key == Key::page_up || key == Key::page_down) to = scroll.offset.y + (key == Key::page_up ? -page : page);
    to = std::clamp(to, 0.0F, most);
    const bool moves = to != scroll.offset.y;
    scroll.offset.y = to;
    return moves;
}

/// Keys that a dialog may use, whichever of its nodes has the keyboard.
bool is_chord(Key key, Mods mods) {
    if (key >= Key::f1 && key <= Key::f12) return key != Key::f6;
    const bool arrow = key == Key::left || key == Key::right || key == Key::up || key == Key::down;
    if (has(mods, Mods::alt)) return arrow || printable(key);
    return has(mods, Mods::command) && printable(key);
}

}  // namespace

/// Backspace and Ctrl+C are for the node under the pointer, unless a ring or an open text shows where the keyboard is.
bool Ui::takes_under_pointer(const Event& event) {
    const Node* over = before(hot_);
    const Node* focused = before(focus_);
    if (over == nullptr || hot_ == focus_ || ringed_ || !has(over->sense, Sense::hover_keys)) return false;
    if (focused != nullptr && (has(focused->sense, Sense::editing) || has(focused->sense, Sense::keys))) return false;
    return takes(over->sense & (Sense::erase | Sense::copying), event.key, event.mods);
}

void Ui::route_key(const Event& event) {
    key_ran_shortcut_ = false;
    const Id held_now = active_[0] != 0 ? active_[0] : active_[1] != 0 ? active_[1] : active_[2];
    if (held_now != 0) {  // only what drags is listened to in the middle of a drag
        const Node* held_node = before(held_now);
        if (event.key == Key::escape) return cancel_held();
        if (held_node != nullptr && takes(held_node->sense, event.key, event.mods)) send(held_now, event);
        return;
    }
    if (takes_under_pointer(event)) return send(hot_, event);
    const Node* node = before(focus_);
    if (node != nullptr && event.key == Key::space && !ringed_ &&
        (only_activates(node->sense) || node->role == Role::combo) && press_shortcut(event.key, event.mods)) {
        key_ran_shortcut_ = true;
        return;
    }
    const bool unseen = node != nullptr && !ringed_ && leaves(*node, event.key);
    if (node != nullptr && !unseen && !is_for_picture(*node, event) && takes(*node, event.key, event.mods)) {
        const bool pressed = has(node->sense, Sense::activate) && (event.key == Key::enter || event.key == Key::space);
        if (pressed && event.repeat && !has(node->sense, Sense::editing)) return;  // a button held down is one click
        ringed_ |= !has(node->sense, Sense::editing);  // an entry that was opened by pointer leaves none
        return send(focus_, event);
    }
    key_ran_shortcut_ = press_shortcut(event.key, event.mods);
    if (!key_ran_shortcut_ && is_chord(event.key, event.mods) && send_to_around(event, Sense::chords)) return;
    if (key_ran_shortcut_ || navigate(event) || !printable(event.key)) return;
    // A letter that nothing took goes to the picture under the pointer, if it takes letters.
    if (const Id picture = picture_for(event); picture != 0) send(picture, event);
}

/// The picture under the pointer that takes this letter; 0: none.
Id Ui::picture_for(const Event& event) const {
    for (std::uint32_t i = index_before(hot_); i != no_node; i = nodes_before()[i].parent) {
        const Node& node = nodes_before()[i];
        if (has(node.sense, Sense::hover_keys) && has(node.sense, Sense::typing) && takes(node, event.key, event.mods))
            return node.id;
    }
    return 0;
}

/// Whether a letter that the node with the keyboard has as a key is meant for the picture under the pointer: a timeline
/// that was clicked keeps the keyboard, without a ring, while the person goes on in the picture.
bool Ui::is_for_picture(const Node& focused, const Event& event) const {
    return !ringed_ && focused.typed != TypedKeys::all && printable(event.key) && event.key != Key::space &&
           picture_for(event) != 0;
}

bool Ui::navigate(const Event& event) {
    const bool back = has(event.mods, Mods::shift);
    if (opens_bar(event.key, event.mods)) {
        const bool modal = std::any_of(overlays_.begin(), overlays_.end(),
                                       [](const Overlay& o) { return o.kind == OverlayKind::modal; });
        for (const Node& node : nodes_before())
            if (node.role == Role::menu_bar && !modal) return send(node.id, event), true;
    }
    switch (event.key) {
        case Key::tab:
            has(event.mods, Mods::command) ? move_panel(back ? -1 : 1) : move_focus(back ? -1 : 1);
            return true;
        case Key::f6:
            move_panel(back ? -1 : 1);
            return true;
        case Key::left:
        case Key::right:
        case Key::up:
        case Key::down:
            return move_by_arrow(event.key);
        case Key::page_up:
        case Key::page_down:
            if (has(event.mods, Mods::command)) return send_to_around(event, Sense::tab_keys);
            return scroll_by_key(event.key);
        case Key::home:
        case Key::end:
            return scroll_by_key(event.key);
        case Key::escape:
            if (std::any_of(overlays_.begin(), overlays_.end(),
                            [](const Overlay& o) { return o.kind != OverlayKind::passive; })) {
                close_top_overlay();
            } else if (focus_ == 0 || !ringed_) {  // a node that was only clicked has the keyboard
                set_focus(0);
                send_to_notice(event);
            } else {
                set_focus(0);
            }
            return true;
        default:
            return false;
    }
}

/// The node whose surroundings get the keys that nothing took: the focused one, else the one under the pointer.
std::uint32_t Ui::key_place() {
    const std::uint32_t focused = index_before(focus_);
    return focused != no_node || !pointer_inside_ ? focused : hit(nodes_before(), pointer_, static_cast<Sense>(~0U));
}

/// The newest notice that this key closes.
void Ui::send_to_notice(const Event& event) {
    const auto& all = nodes_before();
    for (std::size_t i = all.size(); i-- > 0;) {
        if (all[i].layer == 0 || !takes(all[i].sense, event.key, event.mods)) continue;
        return send(all[i].id, event);
    }
}

bool Ui::send_to_around(const Event& event, Sense sense) {
    for (std::uint32_t i = key_place(); i != no_node; i = nodes_before()[i].parent) {
        if (!has(nodes_before()[i].sense, sense)) continue;
        send(nodes_before()[i].id, event);
        return true;
    }
    return false;
}

/// Scrolls the innermost area that can go that way, by a page or to its end. A tab stands for the first area of its
/// page.
bool Ui::scroll_by_key(Key key) {
    const std::uint32_t place = key_place();
    if (place != no_node && nodes_before()[place].role == Role::tab) {
        const std::uint32_t strip = nodes_before()[nodes_before()[place].parent].parent;
        const std::uint32_t page = nodes_before()[strip].next;
        for (std::uint32_t i = page; page != no_node && i < nodes_before()[page].end; ++i)
            if (scroll_area(nodes_before()[i], key, row_height())) return again_ = true;
    }
    for (std::uint32_t i = place; i != no_node; i = nodes_before()[i].parent)
        if (scroll_area(nodes_before()[i], key, row_height())) return again_ = true;
    return false;
}

void Ui::move_focus(int step) {
    const auto& all = nodes_before();
    const std::uint8_t layer = focus_layer();
    const auto size = static_cast<int>(all.size());
    const auto fits = [&](int i) {
        return all[static_cast<std::size_t>(i)].layer == layer &&
               has(all[static_cast<std::size_t>(i)].sense, Sense::focus);
    };
    const std::uint32_t current = index_before(focus_);
    int at = current == no_node ? (step > 0 ? -1 : size) : static_cast<int>(current);
    for (int tries = 0; tries < size; ++tries) {
        at += step;
        if (at < 0) at = size - 1;
        if (at >= size) at = 0;
        if (!fits(at)) continue;
        const Id id = all[static_cast<std::size_t>(at)].id;
        set_focus(id, true);
        for (auto& [target, sent] : routed_) {  // a field that gets the keyboard by Tab opens for typing
            if (target == id && sent.kind == EventKind::focus_in) sent.key = Key::tab;
        }
        reveal(id);
        return;
    }
}

void Ui::move_panel(int step) {
    const auto& all = nodes_before();
    const std::uint8_t layer = focus_layer();
    std::vector<std::uint32_t>& firsts = drawn_later_;  // first focusable node of each panel
    firsts.clear();
    int here = -1;
    const std::uint32_t current = index_before(focus_);
    for (std::uint32_t i = 0; i < all.size(); ++i) {
        if (all[i].role != Role::panel || all[i].layer != layer) continue;
        for (std::uint32_t n = i; n < all[i].end; ++n) {
            if (!has(all[n].sense, Sense::focus) || all[n].layer != layer) continue;
            if (current != no_node && current >= i && current < all[i].end) here = static_cast<int>(firsts.size());
            firsts.push_back(n);
            break;
        }
    }
    if (firsts.empty()) return;
    const int count = static_cast<int>(firsts.size());
    const int next = here < 0 ? (step > 0 ? 0 : count - 1) : (here + step + count) % count;
    const Id id = all[firsts[static_cast<std::size_t>(next)]].id;
    set_focus(id, true);
    reveal(id);
}

/// Within lists, menus, tabs: to the nearest node that way, and around the end of it.
bool Ui::move_by_arrow(Key key) {
    const auto& all = nodes_before();
    const std::uint32_t current = index_before(focus_);
    if (current == no_node) return false;
    std::uint32_t group = current;
    while (group != no_node && !arrows_move_focus(all[group].role))
        group = all[group].overlay ? no_node : all[group].parent;
    if (group == no_node) return false;
    const int a = key == Key::left || key == Key::right ? 0 : 1;
    const float sign = key == Key::left || key == Key::up ? -1.0F : 1.0F;
    const glm::vec2 from = all[current].rect().center();
    std::uint32_t best = no_node, around = no_node;
    float best_score = 0, around_score = 0;
    for (std::uint32_t i = group; i < all[group].end; ++i) {
        if (i == current || !has(all[i].sense, Sense::focus) || all[i].layer != all[group].layer) continue;
        const glm::vec2 way = all[i].rect().center() - from;
        const float along = way[a] * sign, across = std::abs(way[1 - a]);
        const float score = std::abs(along) + 3 * across;
        if (along > 0.5F && (best == no_node || score < best_score)) best = i, best_score = score;
        const float far = along - 3 * across;  // the one at the other end of the same row or column
        if (along < -0.5F && (around == no_node || far < around_score)) around = i, around_score = far;
    }
    const std::uint32_t next = best != no_node ? best : around;
    if (next == no_node) return false;
    const Id id = all[next].id;
    set_focus(id, true);
    reveal(id);
    return true;
}

}  // namespace lapfx::ui
