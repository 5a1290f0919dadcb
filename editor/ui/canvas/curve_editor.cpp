#include "ui/canvas/curve_editor.h"

#include <cassert>

#include "ui/canvas/curve_drawing.h"
#include "ui/core/node.h"
#include "ui/value/expression.h"
#include "ui/value/utf8.h"

namespace lapfx::ui {

using namespace curve_drawing;

namespace {

constexpr double least_distance = 1e-4;  // between two points, as a share of the range of x
constexpr std::size_t no_point = static_cast<std::size_t>(-1);

/// The state that is kept from frame to frame.
struct Memory {
    enum class Drag : std::uint8_t { none, points, box };
    Drag drag = Drag::none;
    bool began = false;  ///< the curve has been changed by this drag
    bool adds = false;   ///< a box adds to the earlier selection
    std::size_t grabbed = 0;
    glm::vec2 from{0}, last{0}, way{0};
    Curve before;
    std::vector<std::uint8_t> selected, selected_before;  ///< each point has one
    std::vector<CurvePoint> scratch;
    std::vector<Id> ids;              ///< the points had them when they were built last
    std::size_t entering = no_point;  ///< the point whose values are typed
    bool invalid = false;
    std::string entry;
};

class Editing {
  public:
    Editing(Ui& ui, Memory& memory, Curve& curve, const CurveEditorOptions& options, const Frame& frame)
        : ui_(ui), m_(memory), curve_(curve), o_(options), f_(frame) {
        m_.selected.resize(curve.size());
        if (m_.grabbed >= curve.size()) m_.drag = Memory::Drag::none;  // the program has changed the curve
        if (m_.entering >= curve.size()) m_.entering = no_point;
    }
    Edit edit;

    void ground(const Event& e) {
        if (e.kind == EventKind::press) {
            m_.from = m_.last = e.at;
            m_.selected_before = m_.selected;
            m_.drag = Memory::Drag::box, m_.grabbed = 0;
            m_.adds = has(e.mods, Mods::shift);
            if (!m_.adds) select_none();
            if (e.clicks == 2) insert_and_drag(e);
            return;
        }
        if (e.kind == EventKind::key) return keys(no_point, e);
        drag(e);
    }
    void point(std::size_t i, const Event& e) {
        switch (e.kind) {
            case EventKind::press:
                return press(e);
            case EventKind::key:
                return keys(i, e);
            case EventKind::text:
                return typed(i, e.codepoint);
            case EventKind::focus_out:
                if (m_.entering == i) take_entry(), m_.entering = no_point;
                return;
            case EventKind::focus_in:
                return;
            default:
                return drag(e);
        }
    }

  private:
    bool acted_on(std::size_t i, std::size_t focused) const {
        return focused != no_point && m_.selected[focused] == 0 ? i == focused : m_.selected[i] != 0;
    }
    void select_none() { std::fill(m_.selected.begin(), m_.selected.end(), std::uint8_t{0}); }
    void select_only(std::size_t i) {
        select_none();
        m_.selected[i] = 1;
    }

    void start(Memory::Drag drag, const Event& e) {
        m_.drag = drag, m_.began = false;
        m_.before = curve_;
        m_.from = m_.last = e.at, m_.way = {0, 0};
    }
    void press(const Event& e) {
        std::size_t nearest = 0;  // two points may share the place that was pressed
        for (std::size_t i = 1; i < curve_.size(); ++i) {
            if (glm::distance(place_of(f_, curve_.point(i)), e.at) <
                glm::distance(place_of(f_, curve_.point(nearest)), e.at))
                nearest = i;
        }
        if (nearest < m_.ids.size()) ui_.set_focus(m_.ids[nearest]);
        if (e.clicks == 2) return open_entry(nearest);
        if (has(e.mods, Mods::shift)) {
            m_.selected[nearest] ^= 1;
        } else if (m_.selected[nearest] == 0) {
            select_only(nearest);
        }
        m_.grabbed = nearest;
        start(Memory::Drag::points, e);
    }
    void insert_and_drag(const Event& e) {
        start(Memory::Drag::points, e);
        const auto in = [](const Span& s, double v) { return std::clamp(v, s.low, s.high); };
        const auto i = insert(in(o_.x, f_.x.value_at(e.at.x)), in(o_.y, f_.y.value_at(e.at.y)));
        if (!i) {
            m_.drag = Memory::Drag::none;
            return;
        }
        m_.grabbed = *i;
        m_.scratch.assign(curve_.points().begin(), curve_.points().end());
        m_.began = edit.began = edit.changed = true;
    }
    std::optional<std::size_t> insert(double x, double y) {
        const auto i = curve_.insert(x, y);
        if (!i) return i;
        m_.selected.assign(curve_.size(), 0);
        m_.selected[*i] = 1;
        m_.entering = no_point;
        return i;
    }

    void drag(const Event& e) {
        if (m_.drag == Memory::Drag::none) return;
        if (e.kind == EventKind::cancel) return cancel();
        if (e.kind != EventKind::pointer && e.kind != EventKind::release) return;
        m_.way += (e.at - m_.last) * (has(e.mods, Mods::shift) ? 0.1F : 1.0F);
        m_.last = e.at;
        if (m_.drag == Memory::Drag::box) select_box(m_.adds);
        if (m_.drag == Memory::Drag::points && (m_.began || glm::distance(e.at, m_.from) > 3 * ui_.scale()))
            move(has(e.mods, Mods::command));
        if (e.kind != EventKind::release) return;
        if (m_.began) edit.committed = true;
        m_.drag = Memory::Drag::none, m_.began = false;
    }
    void cancel() {
        if (m_.drag == Memory::Drag::box) m_.selected = m_.selected_before;
        if (m_.began) {
            curve_ = m_.before;
            m_.selected.resize(curve_.size());
            edit.changed = edit.cancelled = true;
        }
        m_.selected.resize(curve_.size());
        m_.drag = Memory::Drag::none, m_.began = false;
    }
    void report() {
        if (!m_.began) edit.began = true;
        m_.began = edit.changed = true;
    }
    void select_box(bool add) {
        const glm::vec2 low = glm::min(m_.from, m_.last), high = glm::max(m_.from, m_.last);
        for (std::size_t i = 0; i < curve_.size(); ++i) {
            const glm::vec2 at = place_of(f_, curve_.point(i));
            const bool inside = at.x >= low.x && at.y >= low.y && at.x <= high.x && at.y <= high.y;
            const bool kept = add && i < m_.selected_before.size() && m_.selected_before[i] != 0;
            m_.selected[i] = inside || kept ? 1 : 0;
        }
    }
    /// Moves the selected points from their places at the beginning of the drag. An inserted point moves from the place
    /// where it was inserted.
    void move(bool in_steps) {
        const bool inserted = m_.before.size() != curve_.size();
        if (!inserted) m_.scratch.assign(m_.before.points().begin(), m_.before.points().end());
        if (m_.scratch.size() != curve_.size()) return;
        const CurvePoint& p = m_.scratch[m_.grabbed];
        double dx = m_.way.x / f_.x.scale(), dy = m_.way.y / f_.y.scale();
        if (in_steps) dx = snap(p.x + dx, o_.x_step) - p.x, dy = snap(p.y + dy, o_.y_step) - p.y;
        if (shift_points(dx, dy, m_.grabbed)) report();
    }
    /// Moves the points of m_.scratch as far as neighbours and ranges allow and makes them the curve. Returns whether
    /// it changed.
    bool shift_points(double dx, double dy, std::size_t focused) {
        const auto& points = m_.scratch;
        const double apart = least_distance * o_.x.length();
        double x_low = -1e300, x_high = 1e300, y_low = -1e300, y_high = 1e300;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!acted_on(i, focused)) continue;
            const CurvePoint& p = points[i];
            const bool left = i > 0 && !acted_on(i - 1, focused);
            const bool right = i + 1 < points.size() && !acted_on(i + 1, focused);
            x_low = std::max(x_low, std::max(o_.x.low, left ? points[i - 1].x + apart : o_.x.low) - p.x);
            x_high = std::min(x_high, std::min(o_.x.high, right ? points[i + 1].x - apart : o_.x.high) - p.x);
            y_low = std::max(y_low, o_.y.low - p.y), y_high = std::min(y_high, o_.y.high - p.y);
        }
        dx = x_low <= x_high ? std::clamp(dx, x_low, x_high)
                             : 0;  // 0: it is outside already, or between two close points
        dy = y_low <= y_high ? std::clamp(dy, y_low, y_high) : 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (acted_on(i, focused)) m_.scratch[i].x += dx, m_.scratch[i].y += dy;
        }
        const bool good = Curve::valid(m_.scratch);
        const bool changed =
            good && !std::equal(points.begin(), points.end(), curve_.points().begin(), curve_.points().end());
        if (changed) curve_.set_points(m_.scratch);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (acted_on(i, focused)) m_.scratch[i].x -= dx, m_.scratch[i].y -= dy;
        }
        return changed;
    }

    void keys(std::size_t focused, const Event& e) {
        if (m_.drag != Memory::Drag::none && m_.began) return;  // one edit at a time
        if (m_.entering != no_point && focused == m_.entering) return entry_keys(e);
        const double factor = has(e.mods, Mods::shift) ? 0.1 : has(e.mods, Mods::command) ? 10 : 1;
        switch (e.key) {
            case Key::left:
                return nudge(focused, -factor, 0);
            case Key::right:
                return nudge(focused, factor, 0);
            case Key::down:
                return nudge(focused, 0, -factor);
            case Key::up:
                return nudge(focused, 0, factor);
            case Key::del:
            case Key::backspace:
                return erase(focused);
            default:
                break;
        }
        if (focused == no_point) return;
        if (e.key == Key::enter) open_entry(focused);
        if (e.key == Key::space) m_.selected[focused] ^= 1;
        if (e.key == key_of('I')) insert_after(focused);
    }
    void nudge(std::size_t focused, double x, double y) {
        m_.scratch.assign(curve_.points().begin(), curve_.points().end());
        if (shift_points(x * o_.x_step, y * o_.y_step, focused)) edit |= Edit::once();
    }
    void erase(std::size_t focused) {
        const std::size_t count = curve_.size();
        for (std::size_t i = count; i-- > 0;) {
            if (acted_on(i, focused)) curve_.erase(i);
        }
        if (curve_.size() == count) return;
        m_.selected.assign(curve_.size(), 0);
        if (focused != no_point) ui_.set_focus(m_.ids[std::min(focused, curve_.size() - 1)], true);
        edit |= Edit::once();
    }
    void insert_after(std::size_t i) {
        const std::size_t a = i + 1 < curve_.size() ? i : i - 1;
        if (curve_.size() < 2) return;
        const double x = (curve_.point(a).x + curve_.point(a + 1).x) / 2;
        if (insert(x, curve_.evaluate(x))) edit |= Edit::once();
    }

    // --- what is typed ---
    void open_entry(std::size_t i) {
        m_.entering = i, m_.invalid = false;
        m_.entry.clear();
    }
    void typed(std::size_t i, char32_t c) {
        const bool number = (c >= U'0' && c <= U'9') || c == U'-' || c == U'.' || c == U',' || c == U'(';
        if (m_.entering != i) {
            if (!number) return;
            open_entry(i);
        }
        if (c < 32 || c > 126 || m_.entry.size() >= 64) return;
        m_.entry += static_cast<char>(c);
        m_.invalid = false;
    }
    void entry_keys(const Event& e) {
        if (e.key == Key::escape) m_.entering = no_point;
        if (e.key == Key::backspace && !m_.entry.empty()) m_.entry.pop_back();
        if (e.key != Key::enter) return;
        if (m_.entry.empty() || take_entry()) {
            m_.entering = no_point;
        } else {
            m_.invalid = true;
        }
    }
    bool take_entry() {
        const std::size_t i = m_.entering;
        if (i >= curve_.size() || m_.entry.empty()) return false;
        const CurvePoint& p = curve_.point(i);
        const std::string_view text = m_.entry;
        const std::size_t split = text.find(';');
        const auto number = [](std::string_view part, std::string_view unit, double current) {
            return evaluate(part, {.unit = unit, .current = current});
        };
        const auto y = number(split == text.npos ? text : text.substr(split + 1), o_.y_unit, p.y);
        const auto x = split == text.npos ? std::variant<double, ExpressionError>(p.x)
                                          : number(text.substr(0, split), o_.x_unit, p.x);
        for (const auto* part : {&x, &y})
            if (const auto* error = std::get_if<ExpressionError>(part)) {
                if (i < m_.ids.size())
                    ui_.explain(
                        m_.ids[i],
                        '"' + m_.entry + "\" was not taken: " + error->reason + "; allowed are a value, or time; value",
                        Ui::explained_for);
                return false;
            }
        const double dx = std::get<double>(x) - p.x, dy = std::get<double>(y) - p.y;
        select_only(i);
        m_.scratch.assign(curve_.points().begin(), curve_.points().end());
        if (shift_points(dx, dy, i)) edit |= Edit::once();
        return true;
    }

    Ui& ui_;
    Memory& m_;
    Curve& curve_;
    const CurveEditorOptions& o_;
    const Frame& f_;
};

// --- nodes ---

/// Puts the middle of `node` at the place of a point, relative to the graph, whose size is not known yet.
void put_at(Ui& ui, Node& node, const Frame& f, const CurvePoint& point) {
    const auto part = [](const Span& s, double v) {
        return static_cast<float>((std::clamp(v, s.low, s.high) - s.low) / s.length());
    };
    const float u = part(f.x.span, point.x), v = 1 - part(f.y.span, point.y);
    const glm::vec2 offset{f.left - (f.left + f.right) * u, f.top - (f.top + f.bottom) * v};
    node.placed = true;
    node.placement = ui.arena().make(Placement{.fraction = {u, v}, .offset = offset, .pivot = {0.5F, 0.5F}});
    node.size[0] = node.size[1] = px(ui.row_height());
}

void put_point(Ui& ui, Memory& m, const Curve& curve, const CurveEditorOptions& o, const Frame& f, std::size_t i) {
    ShortText name;
    name.add("Point ").add(static_cast<double>(i + 1), 0);
    Sense sense =
        Sense::hover | Sense::press | Sense::focus | Sense::arrows_x | Sense::arrows_y | Sense::erase | Sense::typing;
    if (m.entering == i) sense = sense | Sense::escape;
    Node& node = ui.leaf(Role::handle, name.view(), sense);
    if (m.entering != i) node.typed = TypedKeys::curve_point;
    m.ids.push_back(node.id);
    const CurvePoint& p = curve.point(i);
    put_at(ui, node, f, p);
    ShortText text;
    text.add(p.x, decimals_of(o.x_step) + 1).add_unit(o.x_unit).add("; ");
    text.add(p.y, decimals_of(o.y_step) + 1).add_unit(o.y_unit);
    node.text = ui.copy(text.view());
    node.tip = node.text;
    node.number = ui.number(p.y, o.y.low, o.y.high, o.y_step);
    const Response r = ui.respond(node);
    if (r.hovered || r.held) ui.set_cursor(Cursor::move);
    node.is |= when(m.selected[i] != 0, Is::selected) | when(m.entering == i && m.invalid, Is::invalid);
    ui.draw_with<draw_point>(node, true);
}

}  // namespace

Edit curve_editor(Ui& ui, std::string_view label, Curve& curve, const CurveEditorOptions& options) {
    assert(options.x.length() > 0 && options.y.length() > 0);
    Node& node = ui.open(Role::curve, label, Axis::x,
                         Sense::hover | Sense::press | Sense::focus | Sense::erase | Sense::arrows_x | Sense::arrows_y);
    const Id id = node.id;
    node.size[0] = options.width.kind == SizeKind::fit ? px(ui.em(24)) : options.width;
    node.size[1] = options.height.kind == SizeKind::fit ? px(ui.em(14)) : options.height;
    node.tip = ui.copy(options.tip);
    ui.respond(node);
    Memory& m = ui.memory<Memory>(id);
    const Frame f = frame_of(ui, ui.rect_before(id), options);
    Editing editing(ui, m, curve, options, f);
    if (!f.graph.empty()) {  // handle all events before anything is built
        if (ui.has_events(id)) ui.events_of(id, [&](const Event& e) { editing.ground(e); });
        for (std::size_t i = 0; i < m.ids.size() && i < curve.size(); ++i) {
            if (ui.has_events(m.ids[i])) ui.events_of(m.ids[i], [&](const Event& e) { editing.point(i, e); });
        }
    }
    m.ids.clear();
    for (std::size_t i = 0; i < curve.size(); ++i) put_point(ui, m, curve, options, f, i);

    Look look{&curve, options, {}, m.entering, ui.copy(m.entry), m.invalid};
    look.options.x_name = ui.copy(options.x_name), look.options.x_unit = ui.copy(options.x_unit);
    look.options.y_name = ui.copy(options.y_name), look.options.y_unit = ui.copy(options.y_unit);
    if (m.drag == Memory::Drag::box) {
        const glm::vec2 low = glm::min(m.from, m.last), high = glm::max(m.from, m.last);
        look.box = intersect({low.x, low.y, high.x - low.x, high.y - low.y}, f.graph);
    }
    Node& me = ui.parent();
    ShortText text;
    text.add(static_cast<double>(curve.size()), 0).add(curve.size() == 1 ? " point" : " points");
    me.text = ui.copy(text.view());
    if (!std::isnan(options.live))
        me.number = ui.number(curve.evaluate(options.live), options.y.low, options.y.high, options.y_step);
    me.is |= when(options.standard != nullptr && !(*options.standard == curve), Is::changed);
    ui.draw_with<draw_ground>(me, look);
    me.draw_over = draw_entry;
    ui.close();
    return editing.edit;
}

}  // namespace lapfx::ui
