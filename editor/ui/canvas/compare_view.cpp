#include "ui/canvas/compare_view.h"

#include <glm/gtc/constants.hpp>
#include <utility>

#include "ui/canvas/drag_handle.h"
#include "ui/core/node.h"
#include "ui/value/number.h"

namespace lapfx::ui {

namespace {

constexpr double gain_least = 1, gain_most = 100, gain_page = 2;
constexpr double mix_page = 0.1;
constexpr float line_reach = 5;  // px at scale 1, to either side
constexpr double angle_step = glm::pi<double>() / 12;

/// The line of a wipe on the screen, with y down. The first picture is on the side that the normal points away from.
struct WipeLine {
    glm::dvec2 middle{0};  ///< middle of the picture
    glm::dvec2 normal{1, 0};
    double reach = 1;  ///< px from the middle to where the normal leaves the picture

    WipeLine(const View& view, double angle) : normal(std::cos(angle), std::sin(angle)) {
        const glm::dvec2 extent = glm::dvec2(view.size) * view.zoom;
        middle = view.corner + extent / 2.0;
        reach = std::max(1e-6, glm::dot(glm::abs(normal), extent) / 2);
    }
    double position_at(glm::dvec2 at) const { return (glm::dot(at - middle, normal) / reach + 1) / 2; }
    glm::dvec2 along() const { return {-normal.y, normal.x}; }
    /// The point of the line nearest to `to`.
    glm::dvec2 nearest(double position, glm::dvec2 to) const {
        return to + normal * (glm::dot(middle - to, normal) + (2 * position - 1) * reach);
    }
};

glm::dvec2 kept_in(glm::dvec2 at, const Rect& area, float margin) {
    const Rect room = area.inset(std::min(margin, area.w / 2), std::min(margin, area.h / 2));
    return glm::clamp(at, glm::dvec2(room.at()), glm::dvec2(room.at() + room.size()));
}

/// Splits the area into two halves, in the direction that shows the pictures larger.
void split(const Rect& area, glm::ivec2 size, float gap, Rect (&halves)[2]) {
    Rect right = area, below = area;
    const Rect left = right.cut_left(std::floor((area.w - gap) / 2));
    const Rect upper = below.cut_top(std::floor((area.h - gap) / 2));
    right = right.cut_right(left.w), below = below.cut_bottom(upper.h);  // exactly the same size
    const bool stacked = fit_zoom(upper, size) > fit_zoom(left, size);
    halves[0] = stacked ? upper : left, halves[1] = stacked ? below : right;
}

struct ComparedLook {
    Picture pictures[2];
    std::string_view labels[2];
    std::string_view title;  ///< title of the difference
    CompareState state;
    Pick pick;
    bool flicker, grid;
    int side;
    int half;  ///< the half with the pointer, where the readout is shown
    Readout readout;
};

void draw_tag(Painter& painter, const Rect& area, std::string_view text, bool right) {
    if (text.empty()) return;
    const Theme& t = painter.theme();
    const TextStyle style = painter.text_style(1, Weight::bold);
    const float width = std::ceil(painter.fonts().run(text, style).width) + painter.em(1), pad = painter.em(0.5F);
    const float height = painter.em(1.6F);
    if (width + 2 * pad > area.w || height + 2 * pad > area.h) return;
    const Rect tag{right ? area.right() - pad - width : area.x + pad, area.y + pad, width, height};
    painter.fill(tag, with_alpha(t.raised, 0.85F), painter.em(t.radius));
    painter.text(tag, text, style, t.text, Align::center);
}

void draw_line(Painter& painter, const View& view, const CompareState& state) {
    const Theme& t = painter.theme();
    const WipeLine line(view, state.angle);
    const Rect seen = intersect(view.rect(), view.area);
    const glm::dvec2 on = line.nearest(state.position, glm::dvec2(view.area.center()));
    const glm::dvec2 way = line.along() * static_cast<double>(view.area.w + view.area.h);
    painter.push_clip(seen);
    painter.line(glm::vec2(on - way), glm::vec2(on + way), 3 * painter.hairline(), with_alpha(t.canvas, 0.6F));
    painter.line(glm::vec2(on - way), glm::vec2(on + way), painter.hairline(), canvas_ink(t));
    painter.pop_clip();
}

PictureLook plain(const ComparedLook& look, int which) {
    PictureLook picture{.picture = look.pictures[which], .grid = look.grid};
    picture.pick = look.pick, picture.side = look.side;
    return picture;
}

void draw_halves(Painter& painter, const Rect& area, const ComparedLook& look) {
    Rect halves[2];
    split(area, look.pictures[0].size, 2 * painter.hairline(), halves);
    painter.ground(area, painter.theme().border);
    for (int i = 0; i < 2; ++i) {
        painter.ground(halves[i], painter.theme().canvas);
        PictureLook picture = plain(look, i);
        picture.pick.by_keys = look.pick.on;  // the place is marked in the other half as well
        draw_picture(painter, view_of(look.state.view, halves[i], look.pictures[0].size), picture);
        draw_tag(painter, halves[i], look.labels[i], false);
    }
}

void draw_compared(Painter& painter, const Node& node, const ComparedLook& look) {
    const Rect area = node.rect();
    painter.ground(area, painter.theme().canvas);
    const View view = view_of(look.state.view, area, look.pictures[0].size);
    if (look.flicker) {
        draw_picture(painter, view, plain(look, 1));
        return draw_tag(painter, area, look.labels[1], true);
    }
    if (look.state.kind == CompareKind::side_by_side) return draw_halves(painter, area, look);
    PictureLook picture = plain(look, 0);
    picture.second = look.pictures[1].image;
    picture.compare = {.position = static_cast<float>(look.state.position),
                       .angle = static_cast<float>(look.state.angle),
                       .gain = static_cast<float>(look.state.gain),
                       .mix = static_cast<float>(look.state.mix)};
    picture.compare.mode = look.state.kind == CompareKind::wipe    ? CompareMode::wipe
                           : look.state.kind == CompareKind::onion ? CompareMode::onion
                                                                   : CompareMode::difference;
    draw_picture(painter, view, picture);
    if (look.state.kind == CompareKind::wipe) draw_line(painter, view, look.state);
    if (look.state.kind == CompareKind::difference) return draw_tag(painter, area, look.title, false);
    draw_tag(painter, area, look.labels[0], false);
    draw_tag(painter, area, look.labels[1], true);
}

void draw_compared_readout(Painter& painter, const Node& node, const void* arg) {
    const auto& look = *static_cast<const ComparedLook*>(arg);
    if (look.readout.line_count == 0) return;
    Rect halves[2] = {node.rect(), node.rect()};
    if (look.state.kind == CompareKind::side_by_side && !look.flicker)
        split(node.rect(), look.pictures[0].size, 2 * painter.hairline(), halves);
    View view = view_of(look.state.view, halves[look.half], look.pictures[0].size);
    view.area = node.rect();
    draw_readout(painter, view, look.readout);
}

// --- the line of the wipe ---

constexpr std::string_view wipe_name = "Wipe", wipe_angle_name = "Wipe angle";

struct WipeMemory {
    glm::dvec2 pivot{0};  ///< pixels of the picture: the point that the line turns about
    double position = 0.5;
    bool turning = false;
};

Edit edit_position(Ui& ui, const View& view, glm::dvec2 place, CompareState& state) {
    const WipeLine line(view, state.angle);
    const glm::vec2 origin = view.area.at();
    const HandleMoves moves = put_handle(ui, {.label = wipe_name,
                                              .tip = "Drag: move the line. Double click: back to the middle",
                                              .at = glm::vec2(place) - origin});
    const bool upright = std::abs(line.normal.x) >= std::abs(line.normal.y);
    const double paged = std::abs(moves.steps.y) >= 10 ? moves.steps.y : 0;  // the line may have any angle
    const double steps = upright ? std::copysign(1.0, line.normal.x) * moves.steps.x + paged
                                 : std::copysign(1.0, line.normal.y) * -moves.steps.y;
    const Edit edit = edit_by_handle(ui, moves, {.step = 0.01, .reset = 0.5}, steps,
                                     line.position_at(glm::dvec2(moves.to + origin)), state.position);
    ui.last().number = ui.number(state.position, 0, 1, 0.01);
    ui.draw_with<draw_knob>(ui.last(), KnobLook{.color = canvas_ink(ui.theme()), .size = glm::vec2(0.9F)});
    return edit;
}

Edit edit_angle(Ui& ui, const View& view, glm::dvec2 pivot, glm::dvec2 place, CompareState& state) {
    const glm::vec2 origin = view.area.at();
    const HandleMoves moves = put_handle(ui, {.label = wipe_angle_name,
                                              .tip = "Drag: turn the line; Ctrl: in steps of 15 degrees",
                                              .at = glm::vec2(place) - origin});
    Edit edit;
    if (moves.id != 0) {
        WipeMemory& memory = ui.memory<WipeMemory>(moves.id);
        if (!memory.turning) memory.pivot = view.to_picture(glm::vec2(pivot)), memory.position = state.position;
        const glm::dvec2 turn_about = view.to_screen(memory.pivot);
        const glm::dvec2 way = glm::dvec2(moves.to + origin) - turn_about;
        edit = edit_by_handle(
            ui, moves, {.minimum = -glm::pi<double>(), .maximum = glm::pi<double>(), .step = angle_step, .reset = 0},
            moves.steps.x + moves.steps.y, std::atan2(-way.x, way.y), state.angle);
        if (edit.changed) {
            const double passing = WipeLine(view, state.angle).position_at(turn_about);
            state.position = edit.cancelled ? memory.position : std::clamp(passing, 0.0, 1.0);
        }
        memory.turning = (memory.turning || edit.began) && !edit.committed && !edit.cancelled;
    }
    ui.last().number = ui.number(glm::degrees(state.angle), -180, 180, 15);
    ui.draw_with<draw_knob>(ui.last(), KnobLook{.color = canvas_ink(ui.theme(), 0.6F), .size = glm::vec2(0.7F)});
    return edit;
}

Edit edit_wipe(Ui& ui, const View& view, CompareState& state) {
    const float margin = handle_side(ui) / 2;
    const WipeLine line(view, state.angle);
    const glm::dvec2 middle(view.area.center());
    const glm::dvec2 at = kept_in(line.nearest(state.position, middle), view.area, margin);
    const double arm = static_cast<double>(std::min(view.area.w, view.area.h)) / 4;
    const glm::dvec2 tip = kept_in(at + line.along() * arm, view.area, margin);
    Edit edit = edit_position(ui, view, at, state);
    edit |= edit_angle(ui, view, at, tip, state);
    return edit;
}

/// A drag of the line, which can be grabbed anywhere.
struct LineDrag {
    DragWay way;
    bool held = false, changed = false;
    double start = 0.5;
};

bool on_line(const Ui& ui, const View& view, const CompareState& state, glm::vec2 at) {
    if (!intersect(view.rect(), view.area).contains(at)) return false;
    const WipeLine line(view, state.angle);
    const glm::dvec2 place(at);
    return glm::distance(line.nearest(state.position, place), place) <= static_cast<double>(line_reach * ui.scale());
}

void take(Ui& ui, const View& view, LineDrag& drag, const Event& event, CompareState& state, Edit& edit) {
    const glm::vec2 way = drag.way.take(event) * (has(event.mods, Mods::shift) ? 0.1F : 1.0F);
    if (event.kind == EventKind::press) {
        drag.held = event.button == Button::left && !ui.key_down(Key::space) && on_line(ui, view, state, event.at);
        drag.changed = false, drag.start = state.position;
        if (drag.held && event.clicks == 2 && std::exchange(state.position, 0.5) != 0.5)
            edit |= Edit::once(), drag.way.on = false;
    }
    if (!drag.held) return;
    const WipeLine line(view, state.angle);
    const double by = glm::dot(glm::dvec2(way), line.normal) / (2 * line.reach);
    const double next = std::clamp(state.position + by, 0.0, 1.0);
    if (std::exchange(state.position, next) != next) {
        edit.began |= !drag.changed;
        drag.changed = edit.changed = true;
    }
    if (event.kind == EventKind::release) edit.committed |= drag.changed, drag.held = false;
    if (event.kind != EventKind::cancel) return;
    if (drag.changed) state.position = drag.start, edit.changed = edit.cancelled = true;
    drag.held = false;
}

/// Returns whether the line was pressed in this build or is held.
bool edit_line(Ui& ui, Id id, const View& view, const Response& r, CompareState& state, Edit& edit) {
    LineDrag& drag = ui.memory<LineDrag>(id);
    bool taken = drag.held;
    if (state.kind != CompareKind::wipe || view.area.empty()) return drag.held = false;
    ui.events_of(id, [&](const Event& event) {
        take(ui, view, drag, event, state, edit);
        taken |= drag.held;
    });
    if (drag.held || (r.hovered && !r.held && on_line(ui, view, state, r.pointer))) {
        const glm::dvec2 normal = WipeLine(view, state.angle).normal;
        ui.set_cursor(std::abs(normal.x) >= std::abs(normal.y) ? Cursor::resize_x : Cursor::resize_y);
    }
    return taken;
}

// --- keys and values ---

/// Whether the widget with the keyboard takes letters as text or as the beginning of a search.
bool types(Ui& ui, Id focus) {
    const Node* node = ui.before(focus);
    return node != nullptr && node->typed == TypedKeys::all && (node->role != Role::combo || ui.focus_ringed()) &&
           has(node->sense, Sense::typing | Sense::editing | Sense::keys | Sense::every_key);
}

Edit edit_by_key(Ui& ui, Id id, CompareState& state) {
    Edit edit;
    if (ui.memory<LineDrag>(id).held) return edit;  // one edit at a time
    ui.events_of(id, [&](const Event& event) {
        if (event.kind != EventKind::key) return;
        const int page = event.key == Key::page_up ? 1 : event.key == Key::page_down ? -1 : 0;
        const CompareState before = state;
        if (event.key == key_of('X')) state.swapped = !state.swapped;
        if (page != 0 && state.kind == CompareKind::onion)
            state.mix = std::clamp(state.mix + page * mix_page, 0.0, 1.0);
        if (page != 0 && state.kind == CompareKind::difference)
            state.gain = std::clamp(state.gain * std::pow(gain_page, page), gain_least, gain_most);
        if (before.swapped != state.swapped || before.mix != state.mix || before.gain != state.gain)
            edit = Edit::once();
    });
    return edit;
}

Readout readout_of(Ui& ui, const std::string_view (&labels)[2], const CompareResult& result,
                   const CompareOptions& options, const Picture& magnified) {
    Readout readout{.at = result.pick, .side = options.sample_box, .keep_off = options.keep_off};
    const glm::vec4 way = result.second - result.first;
    readout.lines[0] = ui.join({labels[0], "   ", pixel_text(ui, result.first, options.decimals)});
    readout.lines[1] = ui.join({labels[1], "   ", pixel_text(ui, result.second, options.decimals)});
    readout.lines[2] = ui.join({"Change   ", pixel_text(ui, way, options.decimals)});
    readout.lines[3] = place_text(ui, result.pick);
    readout.line_count = 4;
    if (options.eyedropper) {
        readout.swatch = picked_color(*magnified.pixels, magnified.size, result.pick, options.sample_box);
        readout.lines[3] = picked_text(ui, readout.swatch, result.pick);
    }
    if (options.magnifier) readout.image = magnified.image, readout.size = magnified.size;
    return readout;
}

std::string_view gain_text(Ui& ui, double gain) {
    char buffer[32];
    return ui.copy(format_number(buffer, gain, gain < 10 && gain != std::round(gain) ? 1 : 0));
}

/// A node as large as what shows a picture, with what the program builds over it.
void build_over(Ui& ui, std::string_view name, const Rect& whole, const View& view, const CompareOptions& options) {
    Node& node = ui.open(Role::group, name, Axis::y);
    node.placed = true;
    node.placement = ui.arena().make(Placement{.offset = view.area.at() - whole.at()});
    node.size[0] = px(view.area.w), node.size[1] = px(view.area.h);
    node.clips = true;
    options.over(ui, view, options.over_with);
    ui.close();
}

}  // namespace

CompareResult compare_view(Ui& ui, std::string_view label, const Picture& first, const Picture& second,
                           CompareState& state, const CompareOptions& options) {
    CompareResult result;
    Node& node = ui.open(Role::image, label, Axis::y, view_sense | Sense::typing | Sense::pages | Sense::hover_keys);
    node.typed = TypedKeys::comparison;
    node.size[0] = options.width, node.size[1] = options.height;
    node.clips = true;
    node.tip = ui.copy(options.tip);
    ui.follow_size(node);
    const Id id = node.id;
    const Response r = ui.respond(node);
    const bool over = r.hovered || ui.hot() == ui.id_of(wipe_name) || ui.hot() == ui.id_of(wipe_angle_name);
    result.flicker = (r.focused || (over && !types(ui, ui.focus()))) && ui.key_down(key_of('F'));
    result.edit = edit_by_key(ui, id, state);
    const Picture shown[2] = {state.swapped ? second : first, state.swapped ? first : second};
    std::string_view labels[2] = {ui.copy(options.first_label), ui.copy(options.second_label)};
    if (state.swapped) std::swap(labels[0], labels[1]);
    const glm::ivec2 size = glm::max(shown[0].size, glm::ivec2(1));

    const Rect area = ui.rect_before(id);
    Rect halves[2] = {area, area};
    const bool beside = state.kind == CompareKind::side_by_side && !result.flicker;
    if (beside) split(area, size, 2 * std::max(1.0F, std::round(ui.scale())), halves);
    const int half = beside && halves[1].contains(ui.pointer()) ? 1 : 0;
    const ViewState view_before = state.view;
    const bool line_taken = !result.flicker && !options.eyedropper &&
                            edit_line(ui, id, view_of(state.view, area, size), r, state, result.edit);
    steer(ui, node, state.view, halves[half], size, !line_taken && !options.eyedropper);
    const View views[2] = {view_of(state.view, halves[0], size), view_of(state.view, halves[1], size)};
    Pick& pick = ui.memory<Pick>(id);
    move_pick(ui, node, r, pick, std::span(views, beside ? 2 : 1), state.view);
    result.view_changed = state.view != view_before;
    if (options.eyedropper && r.hovered)
        ui.set_cursor(Cursor::crosshair);
    else if (r.held && !line_taken)
        ui.set_cursor(Cursor::move);
    result.zoom = views[0].zoom;
    node.number = ui.number(result.zoom, 0, most_zoom);

    Readout readout;
    if (pick.on && shown[0].pixels != nullptr && shown[1].pixels != nullptr && shown[1].size == shown[0].size) {
        result.has_pick = true;
        result.pick = pick.at;
        result.first = mean_of(*shown[0].pixels, size, pick.at, options.sample_box);
        result.second = mean_of(*shown[1].pixels, size, pick.at, options.sample_box);
        const bool beyond =
            state.kind == CompareKind::wipe &&
            WipeLine(views[0], state.angle).position_at(views[0].to_screen(glm::dvec2(pick.at) + 0.5)) > state.position;
        const bool second_half = half == 1 && !pick.by_keys;  // a place that was picked with keys is in both
        const int under = result.flicker || second_half || beyond ? 1 : 0;
        result.under = state.swapped ? 1 - under : under;
        result.picked = options.eyedropper && eyedropper_clicked(ui, id);
        const Readout text = readout_of(ui, labels, result, options, shown[under]);
        node.text = ui.join({place_text(ui, pick.at), "   ", text.lines[0], "   ", text.lines[1]});
        if (options.readout) readout = text;
    }
    if (state.kind == CompareKind::wipe && !result.flicker && !options.eyedropper)
        result.edit |= edit_wipe(ui, view_of(state.view, area, size), state);
    if (options.over != nullptr && !area.empty()) {
        build_over(ui, "First", area, view_of(state.view, halves[0], size), options);
        if (beside) build_over(ui, "Second", area, view_of(state.view, halves[1], size), options);
    }
    const std::string_view title = ui.join({labels[0], " - ", labels[1], "   x ", gain_text(ui, state.gain)});
    Node& whole = ui.parent();
    if (readout.line_count > 0) whole.tip = {};  // both would be shown at the pointer
    ui.draw_with<draw_compared>(whole, ComparedLook{.pictures = {shown[0], shown[1]},
                                                    .labels = {labels[0], labels[1]},
                                                    .title = title,
                                                    .state = state,
                                                    .pick = pick,
                                                    .flicker = result.flicker,
                                                    .grid = options.grid,
                                                    .side = options.sample_box,
                                                    .half = half,
                                                    .readout = readout});
    whole.draw_over = draw_compared_readout;
    ui.close();
    return result;
}

}  // namespace lapfx::ui
