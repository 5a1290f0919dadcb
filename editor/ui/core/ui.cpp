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
    6;  // builds without an event: hover that changes the layout that changes the hover must end

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

std::uint8_t byte_of(float v) {
    return static_cast<std::uint8_t>(std::clamp(v, 0.0F, 255.0F));
}

}  // namespace

Ui::Ui(Fonts& fonts, const UiOptions& options) : fonts_(fonts), options_(options) {}

TextStyle Ui::text_style(float relative_size, Weight weight) const {
    return {.size = em(relative_size), .weight = weight};
}

TextStyle Ui::number_style() const {
    return {.size = em(1), .tabular = true};
}

void Ui::wake(const char* reason) {
    woken_.store(reason);
    if (waker_) waker_();
}

void Ui::wake_at(double time, const char* reason) {
    output_.wake_at = std::min(output_.wake_at, time);
    if (reason_count_ < reasons_.size()) {
        reasons_[reason_count_++] = {time, reason};
    } else {
        std::move(reasons_.begin() + 1, reasons_.end(), reasons_.begin());
        reasons_.back() = {time, reason};
    }
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
    seen_.set_build(build_);
    output_ = {.list = &list_};
    again_ = false;
    woken_.store(nullptr);
    take_events();

    stack_.push_back({no_node, root_seed, 0});
    open(Role::window, {}, Axis::y);
}

const Seen& Ui::claim(const Label& label, bool& duplicate) {
    const Id base = hash_bytes(stack_.back().seed, label.key);
    Seen* seen = &seen_.at(base);
    while (seen->build == build_) {  // the second of one name is told from the first
        duplicate = true;
        const std::uint32_t ordinal = ++seen_.at(base).ordinal;
        seen = &seen_.at(hash_bytes(base + ordinal, {}));
    }
    seen->before_build = seen->build;
    seen->before = seen->node;
    seen->build = build_;
    seen->node = static_cast<std::uint32_t>(nodes().size());
    seen->ordinal = 0;
    return *seen;
}

Node& Ui::add(Role role, std::string_view text, Sense sense, bool overlay) {
    const auto index = static_cast<std::uint32_t>(nodes().size());
    const Level level = stack_.back();
    bool duplicate = false;
    Label label{};
    const Seen* seen = nullptr;
    if (!text.empty()) {
        label = split_label(arena().copy(text));
        if (sense != Sense::none || role == Role::panel || role == Role::group) seen = &claim(label, duplicate);
    }
    static const Node empty;  // copied: clearing 256 bytes is a string instruction, three times slower
    Node& node = nodes().emplace_back(empty);
    if (seen != nullptr) {
        node.id = seen->id;
        node.has_events = seen->events == build_;
    }
    node.role = role;
    node.sense = sense;
    node.label = label.name;
    node.shown = label.shown;
    node.end = index + 1;
    node.parent = level.node;
    node.layer = level.layer;
    node.overlay = overlay;
    if (duplicate) node.is |= Is::duplicate, ++duplicates_now_;
    if (disabled_ > 0 && sense != Sense::none) {
        node.is |= Is::disabled;
        node.sense = Sense::hover;
    }
    if (level.node != no_node && !overlay) {
        Node& parent = nodes()[level.node];
        if (parent.first == no_node) {
            parent.first = index;
        } else {
            nodes()[parent.last].next = index;
        }
        parent.last = index;
    }
    return node;
}

Node& Ui::leaf(Role role, std::string_view label, Sense sense) {
    return add(role, label, sense, false);
}

Node& Ui::open(Role role, std::string_view label, Axis axis, Sense sense) {
    Node& node = add(role, label, sense, false);
    node.axis = axis;
    const Level& level = stack_.back();
    Id seed = node.id != 0 ? node.id : level.seed;
    if (node.id == 0 && !label.empty()) seed = hash_bytes(level.seed, split_label(label).key);
    stack_.push_back({static_cast<std::uint32_t>(nodes().size() - 1), seed, level.layer});
    return node;
}

void Ui::close() {
    assert(stack_.size() > 1 && "close() without open()");
    nodes()[stack_.back().node].end = static_cast<std::uint32_t>(nodes().size());
    stack_.pop_back();
}

void Ui::push_seed(std::string_view key) {
    Level level = stack_.back();
    level.seed = hash_bytes(level.seed, key);
    stack_.push_back(level);
}

void Ui::push_seed(std::uint64_t key) {
    Level level = stack_.back();
    level.seed = hash_bytes(level.seed ^ (key * 0x9e3779b97f4a7c15ULL), {});
    stack_.push_back(level);
}

void Ui::push_disabled(bool disabled) {
    if (disabled || disabled_ > 0) ++disabled_;
}

std::string_view Ui::join(std::initializer_list<std::string_view> parts) {
    std::size_t size = 0;
    for (const std::string_view part : parts) size += part.size();
    char* to = static_cast<char*>(arena().take(size, 1));
    std::size_t at = 0;
    for (const std::string_view part : parts) {
        if (!part.empty()) std::memcpy(to + at, part.data(), part.size());
        at += part.size();
    }
    return {to, size};
}

std::uint32_t Ui::index_before(Id id) {
    if (id == 0) return no_node;
    const Seen* seen = seen_.find(id);
    if (seen == nullptr) return no_node;
    if (seen->build == build_ - 1) return seen->node;
    if (seen->build == build_ && seen->before_build == build_ - 1) return seen->before;
    return no_node;
}

const Node* Ui::before(Id id) {
    const std::uint32_t index = index_before(id);
    return index < nodes_before().size() ? &nodes_before()[index] : nullptr;
}

Rect Ui::rect_before(Id id) {
    const Node* node = before(id);
    return node == nullptr ? Rect{} : node->rect();
}

void Ui::add_tooltip() {
    if (active_[0] != 0 || active_[1] != 0 || active_[2] != 0) return;
    const bool by_keys = hot_ == 0 && ringed_;
    const Id of = by_keys ? focus_ : hot_;
    if (!by_keys && of == pressed_hot_) return;  // known by now; what the press has opened is to be seen
    const Seen* seen = of == 0 ? nullptr : seen_.find(of);
    if (seen == nullptr || seen->build != build_) return;
    const std::string_view tip = nodes()[seen->node].tip;
    if (tip.empty()) return;
    const double due = rested_since_ + (by_keys ? tooltip_by_keys : tooltip_after);
    if (time() < due) return wake_at(due, "tooltip");
    const glm::vec2 away(em(0.6F), em(1.3F));
    const Placement placement =
        by_keys ? Placement{.side = Placement::Side::below, .offset = {0, em(0.2F)}, .anchor = of}
                : Placement{.side = Placement::Side::pointer, .offset = away, .rect = {pointer_.x, pointer_.y, 0, 0}};
    stack_.push_back({0, root_seed, static_cast<std::uint8_t>(overlays_.size() + 1)});
    Node& node = add(Role::tooltip, {}, Sense::none, true);
    node.end = static_cast<std::uint32_t>(nodes().size());
    node.text = tip;
    node.placement = arena().make(placement);
    for (std::uint8_t& pad : node.padding) pad = byte_of(em(0.5F));
    const float widest = em(26), wish = paragraph_width(fonts_, tip, text_style());
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
    const auto alive = [this](Id id) {
        const Seen* seen = id == 0 ? nullptr : seen_.find(id);
        return seen != nullptr && seen->build == build_;
    };
    for (Id& id : active_) {
        if (id != 0 && !alive(id)) id = 0;
    }
    if (focus_ != 0 && !alive(focus_)) focus_ = 0, again_ = true;
    focus_new_overlay();
    const Id hot = hot_;
    find_hot(nodes());
    if (hot != hot_) again_ = true, rested_since_ = time();
    if (queue_head_ < queue_.size()) return true;
    // What was built before the widget that an event was for does not know yet what came of it.
    again_ |= !routed_.empty() || !late_.empty();
    if (again_ && settled_++ < most_settling) return true;
    unsettled_ = again_ ? unsettled_ + 1 : 0;
    return false;
}

std::size_t Ui::memory_used() const {
    const auto bytes = [](const auto& v) { return v.capacity() * sizeof(*v.data()); };
    return bytes(built_[0]) + bytes(built_[1]) + arenas_[0].capacity() + arenas_[1].capacity() +
           bytes(list_.instances) + bytes(list_.clips) + bytes(list_.batches) + seen_.size() * 2 * sizeof(Seen) +
           bytes(queue_) + bytes(routed_);
}

}  // namespace lapfx::ui
