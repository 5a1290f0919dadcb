#include "ui/core/ui.h"

#include <cassert>

#include "ui/core/layout.h"
#include "ui/core/paragraph.h"

namespace lapfx::ui {

namespace {

constexpr double tooltip_after = 0.5;    // s that the pointer rests
constexpr double tooltip_by_keys = 0.9;  // s that the focus stays
constexpr Id root_seed = 0x6c617066782e7569ULL;
constexpr int most_settling =
    6;  // builds in a row without an event: hover may change the layout, which changes the hover

void draw_tooltip(Painter& painter, const Node& node, const TextStyle& style) {
    const Rect rect = node.rect();
    painter.shadow(rect, painter.theme().shadow, painter.em(0.5F), painter.em(0.3F));
    painter.fill(rect, painter.theme().raised, painter.em(0.3F));
    painter.frame(rect, painter.theme().border, painter.hairline(), painter.em(0.3F));
    draw_paragraph(painter, node.inside(), node.text, style, painter.theme().text);
}

float tooltip_height(Ui& ui, const Node& node, float width) {
    const auto pads = static_cast<float>(node.padding[0] + node.padding[2]);
    return paragraph_height(ui.fonts(), node.text, ui.text_style(), width - pads) +
           static_cast<float>(node.padding[1] * 2);
}

/// The area of rows that scroll around a node, as far as it is seen; empty: there is none.
Rect rows_around(std::span<const Node> all, std::uint32_t index) {
    for (std::uint32_t i = index; i < all.size() && !all[i].overlay; i = all[i].parent)
        if (all[i].scroll != nullptr && all[i].scrolls[1]) return all[i].seen();
    return {};
}

constexpr float widest_tip = 26, tip_pad = 0.5F;  // em

std::uint8_t byte_of(float v) {
    return static_cast<std::uint8_t>(std::clamp(v, 0.0F, 255.0F));
}

}  // namespace

UiState::UiState(Fonts& fonts, const UiOptions& options) : fonts_(fonts), options_(options) {}
UiState::~UiState() = default;

void Ui::wake(const char* reason) {
    woken_.store(reason);
    if (waker_) waker_();
}

void Ui::begin(const FrameInput& input) {
    if (fresh_) fonts_.next_frame(), settled_ = 0;
    fresh_ = false;
    input_ = input;
    input_.size = glm::max(input.size, glm::ivec2(1));
    input_.scale = std::isfinite(input.scale) ? std::clamp(input.scale, 0.5F, 4.0F) : 1.0F;
    ++build_;
    now_ = 1 - now_;
    nodes().clear();
    arena().reset();
    stack_.clear();
    followed_.clear();
    overlay_roots_.assign(overlays_.size(), no_node);
    disabled_ = 0;
    duplicates_now_ = 0;
    output_ = {.list = &list_};
    again_ = false;
    woken_.store(nullptr);
    take_events();

    stack_.push_back({no_node, root_seed, 0});
    open(Role::window, {}, Axis::y);
}

void Ui::add_tooltip() {
    if (add_explanation()) return;
    if (active_[0] != 0 || active_[1] != 0 || active_[2] != 0) return;
    const bool by_keys = hot_ == 0 && ringed_;
    const Id of = by_keys ? focus_ : hot_;
    if (!by_keys && of == pressed_hot_) return;  // a tooltip must not cover what the press has opened
    const std::uint32_t index = index_now(of);
    if (index == no_node) return;
    const std::string_view tip = nodes()[index].tip;
    if (tip.empty()) return;
    const double due = rested_since_ + (by_keys ? tooltip_by_keys : tooltip_after);
    if (time() < due) return wake_at(due, "tooltip");
    const glm::vec2 away(em(0.6F), em(1.3F));
    Placement placement =
        by_keys ? Placement{.side = Placement::Side::below, .offset = {0, em(0.2F)}, .anchor = of}
                : Placement{.side = Placement::Side::pointer, .offset = away, .rect = {pointer_.x, pointer_.y, 0, 0}};
    // Of a row it lies beside the rows, where there is room: the row below is the one that is read next.
    const Rect rows = rows_around(nodes_before(), index_before(of));
    const float width = em(widest_tip + 2 * tip_pad) + em(0.2F);
    if (!rows.empty() && (rows.right() + width <= window().x || rows.x - width >= 0))
        placement = {
            .side = Placement::Side::right_of, .offset = {em(0.2F), 0}, .rect = {rows.x, rect_before(of).y, rows.w, 0}};
    put_tip(tip, placement);
}

/// What explain() said: below its node, as long as that is there.
bool Ui::add_explanation() {
    const bool said_now = explained_.build == build_;
    if (explained_.of == 0 || explained_.text.empty() || (!said_now && time() >= explained_.until)) return false;
    if (index_now(explained_.of) == no_node) return false;
    if (time() < explained_.until) wake_at(explained_.until, "explanation");
    put_tip(arena().copy(explained_.text),
            {.side = Placement::Side::below, .offset = {0, em(0.2F)}, .anchor = explained_.of});
    return true;
}

void Ui::put_tip(std::string_view tip, const Placement& placement) {
    stack_.push_back({0, root_seed, static_cast<std::uint8_t>(overlays_.size() + 1)});
    Node& node = add(Role::tooltip, {}, Sense::none, true);
    node.end = static_cast<std::uint32_t>(nodes().size());
    node.text = tip;
    node.placement = arena().make(placement);
    for (std::uint8_t& pad : node.padding) pad = byte_of(em(tip_pad));
    const float widest = em(widest_tip), wish = paragraph_width(fonts_, tip, text_style());
    node.size[0] = px(std::ceil(std::min(wish, widest)) + static_cast<float>(node.padding[0] * 2));
    node.height_for_width = tooltip_height;
    draw_with<draw_tooltip>(node, text_style());
    overlay_roots_.push_back(static_cast<std::uint32_t>(nodes().size() - 1));
    stack_.pop_back();
}

bool Ui::end() {
    close();  // the window's own node
    assert(stack_.size() == 1 && "open() without close()");
    drop_overlays_not_built();
    add_tooltip();
    again_ |= lay_out(*this, nodes(), window());
    for (const std::uint32_t i : followed_) again_ |= nodes()[i].rect().size() != rect_before(nodes()[i].id).size();
    duplicates_ = duplicates_now_;
    for (Id& id : active_) {
        if (index_now(id) == no_node) id = 0;
    }
    if (focus_ != 0 && index_now(focus_) == no_node) focus_ = 0, again_ = true;
    focus_new_overlay();
    const Id hot = hot_;
    find_hot(nodes());
    if (hot != hot_) again_ = true, rested_since_ = time();
    if (queue_head_ < queue_.size()) return true;
    // Nodes built before the one that an event was for do not show its effect yet.
    again_ |= !routed_.empty() || !late_.empty();
    if (again_ && settled_++ < most_settling) return true;
    unsettled_ = again_ ? unsettled_ + 1 : 0;
    return false;
}

std::span<const Node> Inspection::tree() const {
    return tree_ == nullptr ? std::span<const Node>() : *tree_;
}

std::size_t Inspection::memory_used() const {
    const auto bytes = [](const auto& v) { return v.capacity() * sizeof(*v.data()); };
    return bytes(built_[0]) + bytes(built_[1]) + arenas_[0].capacity() + arenas_[1].capacity() +
           bytes(list_.instances) + bytes(list_.clips) + bytes(list_.batches) + seen_.size() * 2 * sizeof(Seen) +
           bytes(queue_) + bytes(routed_);
}

}  // namespace lapfx::ui
