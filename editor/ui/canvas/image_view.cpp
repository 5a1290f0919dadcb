#include "ui/canvas/image_view.h"

#include "ui/canvas/drag_handle.h"

namespace lapfx::ui {

namespace {

struct ImageLook {
    PictureLook picture;
    ViewState state;
};

/// Over the picture and the handles: what must not be covered by them.
struct ImageOverLook {
    ImageLook below;
    Readout readout;
    bool has_region;
    PixelRect region;
};

void draw_image(Painter& painter, const Node& node, const ImageOverLook& look) {
    const Theme& t = painter.theme();
    painter.ground(node.rect(), t.canvas);
    const View view = view_of(look.below.state, node.rect(), look.below.picture.picture.size);
    draw_picture(painter, view, look.below.picture);
    if (!look.has_region) return;
    const Rect area = node.rect(), inner = view.pixel_rect(look.region.at, look.region.size);
    const Color shade = with_alpha(t.canvas, 0.5F);
    const Rect whole = intersect(view.rect(), area), hole = intersect(inner, whole);
    painter.fill({whole.x, whole.y, whole.w, hole.y - whole.y}, shade);
    painter.fill({whole.x, hole.bottom(), whole.w, whole.bottom() - hole.bottom()}, shade);
    painter.fill({whole.x, hole.y, hole.x - whole.x, hole.h}, shade);
    painter.fill({hole.right(), hole.y, whole.right() - hole.right(), hole.h}, shade);
    painter.frame(inner, canvas_ink(t), painter.hairline());
}

void draw_readout_over(Painter& painter, const Node& node, const void* arg) {
    const auto& look = *static_cast<const ImageOverLook*>(arg);
    if (look.readout.line_count == 0) return;
    draw_readout(painter, view_of(look.below.state, node.rect(), look.below.picture.picture.size), look.readout);
}

std::string_view value_text(Ui& ui, const ImageViewOptions& options, const glm::vec4& value) {
    return options.text_of != nullptr ? options.text_of(ui, value) : pixel_text(ui, value, options.decimals);
}

Readout readout_of(Ui& ui, const Picture& picture, const ImageViewOptions& options, const ImageViewResult& result) {
    Readout readout{.at = result.pick, .side = options.sample_box};
    readout.lines[0] = value_text(ui, options, result.value);
    readout.lines[1] = ui.join({"pixel ", place_text(ui, result.pick)});
    if (options.sample_box == 3) readout.lines[1] = ui.join({readout.lines[1], "   mean of 3 x 3"});
    if (options.sample_box == 5) readout.lines[1] = ui.join({readout.lines[1], "   mean of 5 x 5"});
    if (options.sample_box == 11) readout.lines[1] = ui.join({readout.lines[1], "   mean of 11 x 11"});
    readout.line_count = 2;
    readout.swatch = color_of(result.value);
    if (options.magnifier) readout.image = picture.image, readout.size = picture.size;
    return readout;
}

// --- the rectangle of interest ---

struct Corner {
    std::string_view label;
    glm::ivec2 side;  ///< 0 the low, 1 the high side; -1: all of it is moved
};
constexpr Corner corners[] = {{"Upper left", {0, 0}},
                              {"Upper right", {1, 0}},
                              {"Lower left", {0, 1}},
                              {"Lower right", {1, 1}},
                              {"Move", {-1, -1}}};

struct RegionMemory {
    PixelRect start;
    bool changed = false;
};

PixelRect moved(PixelRect region, const Corner& corner, glm::ivec2 to, glm::ivec2 size) {
    if (corner.side.x < 0) {
        region.at = glm::clamp(to, glm::ivec2(0), size - region.size);
        return region;
    }
    const glm::ivec2 low = region.at, high = region.at + region.size;
    for (int a = 0; a < 2; ++a) {
        const int from = corner.side[a] == 0 ? std::clamp(to[a], 0, high[a] - 1) : low[a];
        const int end = corner.side[a] == 1 ? std::clamp(to[a], low[a] + 1, size[a]) : high[a];
        region.at[a] = from, region.size[a] = end - from;
    }
    return region;
}

/// Where the handle of a corner is, in pixels; of "Move" the middle, which stands for the upper left.
glm::dvec2 place_of(const PixelRect& region, const Corner& corner) {
    const glm::dvec2 at(region.at), size(region.size);
    return corner.side.x < 0 ? at + size / 2.0 : at + size * glm::dvec2(corner.side);
}

Edit edit_corner(Ui& ui, const View& view, const Corner& corner, PixelRect& region) {
    const glm::vec2 origin = view.area.at();
    const glm::dvec2 place = place_of(region, corner);
    const HandleMoves moves = put_handle(ui, {.label = corner.label, .at = glm::vec2(view.to_screen(place)) - origin});
    ui.last().text = ui.join({place_text(ui, region.at), "   ", place_text(ui, region.size)});
    ui.draw_with<draw_knob>(ui.last(), KnobLook{.color = canvas_ink(ui.theme()), .size = glm::vec2(0.7F)});
    Edit edit;
    if (moves.id == 0) return edit;
    RegionMemory& memory = ui.memory<RegionMemory>(moves.id);
    const PixelRect before = region;
    const glm::dvec2 anchor = corner.side.x < 0 ? glm::dvec2(region.size) / 2.0 : glm::dvec2(0);
    if (moves.steps != glm::dvec2(0)) {
        // Shift is the large step here: there is nothing finer than a pixel.
        const double stride = std::abs(moves.steps.x + moves.steps.y) < 1 ? 100 : 1;
        const glm::dvec2 way = glm::dvec2(moves.steps.x, -moves.steps.y) * stride;
        region = moved(region, corner, glm::ivec2(glm::round(place - anchor + way)), view.size);
        return region != before ? Edit::once() : edit;
    }
    if ((moves.reset || moves.initial) && corner.side.x < 0) {
        region = {{0, 0}, view.size};
        return region != before ? Edit::once() : edit;
    }
    if (moves.dragged) {
        region = moved(region, corner, glm::ivec2(glm::round(view.to_picture(moves.to + origin) - anchor)), view.size);
        edit.changed = region != before;
        if (edit.changed && !memory.changed) memory.start = before, edit.began = true;
        memory.changed |= edit.changed;
    }
    if (memory.changed && moves.released) edit.committed = true;
    if (memory.changed && moves.cancelled) region = memory.start, edit.cancelled = true, edit.changed = true;
    if (moves.released || moves.cancelled) memory.changed = false;
    return edit;
}

void keep_inside(PixelRect& region, glm::ivec2 size) {
    region.at = glm::clamp(region.at, glm::ivec2(0), size - 1);
    region.size = glm::clamp(region.size, glm::ivec2(1), size - region.at);
}

}  // namespace

ImageViewResult image_view(Ui& ui, std::string_view label, const Picture& picture, ViewState& state,
                           const ImageViewOptions& options, PixelRect* region) {
    ImageViewResult result;
    const glm::ivec2 size = glm::max(picture.size, glm::ivec2(1));
    Node& node = ui.open(Role::image, label, Axis::y, view_sense);
    node.size[0] = options.width, node.size[1] = options.height;
    node.clips = true;
    node.tip = ui.copy(options.tip);
    ui.follow_size(node);
    const Id id = node.id;
    const Rect area = ui.rect_before(id);
    const Response r = ui.respond(node);
    result.view_changed = steer(ui, node, state, area, size, !options.eyedropper);
    const View under = view_of(state, area, size);
    node.number = ui.number(under.zoom, 0, most_zoom);
    Pick& pick = ui.memory<Pick>(id);
    const ViewState before = state;
    move_pick(ui, node, r, pick, {&under, 1}, state);
    result.view_changed |= state != before;
    if (options.eyedropper && r.hovered) ui.set_cursor(Cursor::crosshair);
    if (!options.eyedropper && r.held) ui.set_cursor(Cursor::move);

    ImageOverLook look{.below = {{.picture = picture, .nearest = options.nearest, .grid = options.grid}, state},
                       .readout = {},
                       .has_region = region != nullptr,
                       .region = {}};
    if (pick.on && picture.pixels != nullptr && picture.image != 0) {
        result.has_pick = true;
        result.pick = pick.at;
        result.value = mean_of(*picture.pixels, size, pick.at, options.sample_box);
        result.picked = options.eyedropper && eyedropper_clicked(ui, id);
        if (options.readout) look.readout = readout_of(ui, picture, options, result);
        look.below.picture.pick = pick;
        look.below.picture.side = options.sample_box;
        node.text = ui.join({place_text(ui, pick.at), "   ", value_text(ui, options, result.value)});
    }
    if (region != nullptr) {
        keep_inside(*region, size);
        const View view = view_of(state, area, size);
        for (const Corner& corner : corners) result.region |= edit_corner(ui, view, corner, *region);
        look.region = *region;
    }
    if (options.over != nullptr) options.over(ui, view_of(state, area, size), options.over_with);
    Node& whole = ui.parent();
    ui.draw_with<draw_image>(whole, look);
    whole.draw_over = draw_readout_over;
    if (look.readout.line_count > 0) whole.tip = {};  // both belong beside the pointer
    ui.close();
    return result;
}

}  // namespace lapfx::ui
