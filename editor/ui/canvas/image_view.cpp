#include "ui/canvas/image_view.h"

#include "ui/canvas/drag_handle.h"
#include "ui/core/node.h"

namespace lapfx::ui {

namespace {

struct ImageLook {
    PictureLook picture;
    ViewState state;
};

/// The picture, and what is drawn over it and over the program's own widgets there.
struct ImageOverLook {
    ImageLook below;
    Readout readout;
};

void draw_image(Painter& painter, const Node& node, const ImageOverLook& look) {
    painter.ground(node.rect(), painter.theme().canvas);
    draw_picture(painter, view_of(look.below.state, node.rect(), look.below.picture.picture.size), look.below.picture);
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
    Readout readout{.at = result.pick, .side = options.sample_box, .keep_off = options.keep_off};
    readout.lines[0] = value_text(ui, options, result.value);
    readout.lines[1] = ui.join({"pixel ", place_text(ui, result.pick)});
    if (options.sample_box == 3) readout.lines[1] = ui.join({readout.lines[1], "   mean of 3 x 3"});
    if (options.sample_box == 5) readout.lines[1] = ui.join({readout.lines[1], "   mean of 5 x 5"});
    if (options.sample_box == 11) readout.lines[1] = ui.join({readout.lines[1], "   mean of 11 x 11"});
    readout.line_count = 2;
    readout.swatch = color_of(result.value);
    if (options.eyedropper) {
        readout.swatch = picked_color(*picture.pixels, picture.size, result.pick, options.sample_box);
        readout.lines[readout.line_count++] = picked_text(ui, readout.swatch, result.pick);
    }
    if (options.magnifier) readout.image = picture.image, readout.size = picture.size;
    return readout;
}

}  // namespace

ImageViewResult image_view(Ui& ui, std::string_view label, const Picture& picture, ViewState& state,
                           const ImageViewOptions& options) {
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

    ImageOverLook look{.below = {{.picture = picture, .grid = options.grid}, state}, .readout = {}};
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
    if (options.over != nullptr) options.over(ui, view_of(state, area, size), options.over_with);
    Node& whole = ui.parent();
    ui.draw_with<draw_image>(whole, look);
    whole.draw_over = draw_readout_over;
    if (look.readout.line_count > 0) whole.tip = {};  // both belong beside the pointer
    ui.close();
    return result;
}

}  // namespace lapfx::ui
