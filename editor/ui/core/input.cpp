#include "ui/core/input.h"

#include <algorithm>
#include <utility>

#include "ui/core/node.h"

namespace lapfx::ui {

bool Input::key_down(Key key) const {
    return std::find(keys_down_.begin(), keys_down_.end(), key) != keys_down_.end();
}

void Input::send(Id target, const Event& event) {
    if (target == 0) return;
    if (!routing_) {  // its widget may have been built already; the next build tells it
        late_.emplace_back(target, event);
        again_ = true;
        return;
    }
    routed_.emplace_back(target, event);
    seen_.at(target, *this).events = build_;
}

void Input::set_focus(Id id, bool by_keyboard) {
    ringed_ = by_keyboard && id != 0;
    if (id == focus_) return;
    send(std::exchange(focus_, id), {.kind = EventKind::focus_out, .time = time()});
    send(focus_, {.kind = EventKind::focus_in, .time = time()});
    rested_since_ = time();
    again_ = true;
}

/// Uses the layout of the last build; a node that is new is revealed by the next one.
void Input::reveal(Id id) {
    const std::uint32_t index = index_before(id);
    if (index == no_node || index >= nodes_before().size()) {
        reveal_ = id;
        again_ = true;
        return;
    }
    Rect rect = nodes_before()[index].rect();
    for (std::uint32_t i = nodes_before()[index].parent; i != no_node; i = nodes_before()[i].parent) {
        const Node& area = nodes_before()[i];
        if (area.overlay && area.scroll == nullptr) break;
        if (area.scroll == nullptr) continue;
        const Rect view = area.inside();
        for (int a = 0; a < 2; ++a) {
            if (!area.scrolls[a]) continue;
            const float low = a == 0 ? rect.x : rect.y, high = a == 0 ? rect.right() : rect.bottom();
            const float from = a == 0 ? view.x : view.y, to = a == 0 ? view.right() : view.bottom();
            const float by = low < from ? low - from : high > to ? std::min(high - to, low - from) : 0.0F;
            area.scroll->offset[a] += by;
            rect = rect.moved(a == 0 ? glm::vec2(-by, 0) : glm::vec2(0, -by));
            if (by != 0) again_ = true;
        }
    }
}

bool Input::press_shortcut(Key key, Mods mods) {
    const bool modal =
        std::any_of(overlays_.begin(), overlays_.end(), [](const Overlay& o) { return o.kind == OverlayKind::modal; });
    // Letters that are typed while a popup is open are not for what lies below.
    const bool popup = std::any_of(overlays_.begin(), overlays_.end(), [](const Overlay& o) {
        return o.kind == OverlayKind::popup || o.kind == OverlayKind::submenu;
    });
    if (popup && printable(key) && !has(mods, Mods::command) && !has(mods, Mods::alt)) return false;
    if (modal || options_.shortcuts == nullptr || !options_.shortcuts->press(key, mods)) return false;
    again_ = true;
    return true;
}

void Input::explain(Id of, std::string_view text, double seconds) {
    explained_.of = of;
    if (explained_.text != text) explained_.text = text;
    explained_.until = seconds > 0 ? time() + seconds : 0;
    explained_.build = build_;
}

void Input::wake_at(double time, const char* reason) {
    output_.wake_at = std::min(output_.wake_at, time);
    if (reason_count_ < reasons_.size()) {
        reasons_[reason_count_++] = {time, reason};
    } else {
        std::move(reasons_.begin() + 1, reasons_.end(), reasons_.begin());
        reasons_.back() = {time, reason};
    }
}

}  // namespace lapfx::ui
