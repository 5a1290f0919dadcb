#include "ui/canvas/scope.h"

#include <glm/gtc/constants.hpp>
#include <stdexcept>

#include "ui/canvas/drag_handle.h"
#include "ui/core/node.h"
#include "ui/value/number.h"

namespace lapfx::ui {

namespace {

constexpr auto cells = static_cast<std::size_t>(scope_side) * scope_side;
constexpr float shown_luma = 150;  // of the vectorscope's own colours
constexpr double most_radius = 255;
constexpr double least_gap = 1;  // between the circles

/// Weights of red and blue in BT.601; green has the rest.
struct {
    float red = 0.299F, blue = 0.114F;
} constexpr w;

std::size_t cell(float column, float row) {
    const auto x = static_cast<std::size_t>(std::clamp(column, 0.0F, 255.0F));
    const auto y = static_cast<std::size_t>(std::clamp(row, 0.0F, 255.0F));
    return y * scope_side + x;
}

template <typename Each>
void each_pixel(const ScopeSource& source, Each&& each) {
    const auto width = static_cast<std::size_t>(std::max(source.size.x, 0));
    const auto height = static_cast<std::size_t>(std::max(source.size.y, 0));
    const auto channels = static_cast<std::size_t>(source.channels);
    if (channels < 3 || channels > 4 || source.bytes.size() < width * height * channels)
        throw std::invalid_argument("a scope needs 3 or 4 bytes for each pixel");
    const auto every = static_cast<std::size_t>(std::max(source.every, 1));
    for (std::size_t y = 0; y < height; y += every) {
        const std::uint8_t* row = source.bytes.data() + y * width * channels;
        for (std::size_t x = 0; x < width; x += every) {
            const std::uint8_t* p = row + x * channels;
            each(x, glm::vec3(p[0], p[1], p[2]));
        }
    }
}

/// Brightness 0..255 by the logarithm of the count, so that a single pixel of many is still visible.
struct Brightness {
    float scale = 0;
    explicit Brightness(const DensityGrid& grid) {
        const std::uint32_t most = *std::max_element(grid.counts.begin(), grid.counts.end());
        scale = most > 0 ? 205.0F / std::log1p(static_cast<float>(most)) : 0.0F;
    }
    std::uint8_t of(std::uint32_t count) const {
        return count == 0 ? std::uint8_t{0}
                          : static_cast<std::uint8_t>(50.0F + scale * std::log1p(static_cast<float>(count)));
    }
};

std::uint8_t code_of(float value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5F, 0.0F, 255.0F));
}

/// Converts chroma to px. The cell of 0 is the 129th of the image, and its middle is at 128.5.
struct ChromaMap {
    Rect square;
    float px_per_code = 1;

    ChromaMap(const Rect& area, float zoom) {
        const float side = std::floor(std::min(area.w, area.h));
        square = {std::floor(area.center().x - side / 2), std::floor(area.center().y - side / 2), side, side};
        px_per_code = std::max(side, 1.0F) / static_cast<float>(scope_side) * std::clamp(zoom, 1.0F, 8.0F);
    }
    glm::vec2 at(glm::vec2 chroma) const { return square.center() + glm::vec2(chroma.x, -chroma.y) * px_per_code; }
    glm::vec2 chroma_at(glm::vec2 at) const {
        const glm::vec2 way = (at - square.center()) / px_per_code;
        return {way.x, -way.y};
    }
    Rect image() const {
        const float side = px_per_code * static_cast<float>(scope_side), cell_of_zero = 128.5F * px_per_code;
        return {square.center().x - cell_of_zero, square.center().y - cell_of_zero, side, side};
    }
};

struct VectorscopeLook {
    ImageHandle image;
    float zoom;
    bool has_key;
    KeyCircles key;
    std::string_view readout;
};

void draw_circle(Painter& painter, glm::vec2 middle, float radius, float width, Color color) {
    constexpr int parts = 64;
    glm::vec2 points[parts + 1];
    for (int i = 0; i <= parts; ++i) {
        const float turn = glm::two_pi<float>() * static_cast<float>(i) / parts;
        points[i] = middle + radius * glm::vec2(std::cos(turn), std::sin(turn));
    }
    painter.polyline(points, width, color);
}

/// Draws boxes at the primaries and their opposites at three quarters of full strength, as on colour bars.
void draw_targets(Painter& painter, const ChromaMap& map) {
    struct Target {
        std::string_view name;
        glm::vec3 code;
    };
    constexpr float full = 191;
    static const Target targets[] = {{"R", {full, 0, 0}},    {"Y", {full, full, 0}}, {"G", {0, full, 0}},
                                     {"C", {0, full, full}}, {"B", {0, 0, full}},    {"M", {full, 0, full}}};
    const Theme& t = painter.theme();
    TextStyle style = painter.text_style(0.85F);
    for (const Target& target : targets) {
        const glm::vec3 at = luma_chroma(target.code);
        const glm::vec2 place = map.at({at.y, at.z});
        const float side = painter.em(0.8F);
        painter.frame({std::round(place.x - side / 2), std::round(place.y - side / 2), side, side}, canvas_ink(t, 0.6F),
                      painter.hairline());
        const bool beside = place.x + 2 * side <= map.square.right();  // else left of it: a small scope has no room
        painter.text({beside ? place.x + side : place.x - 1.5F * side, place.y - side, 2 * side, 2 * side}, target.name,
                     style, canvas_ink(t, 0.6F));
    }
}

void draw_key(Painter& painter, const ChromaMap& map, const VectorscopeLook& look) {
    const Theme& t = painter.theme();
    const glm::vec3 key = luma_chroma(look.key.color);
    const glm::vec2 at = map.at({key.y, key.z});
    const float line = 1.5F * painter.hairline();
    draw_circle(painter, at, static_cast<float>(look.key.chroma_low) * map.px_per_code, line, t.series[0]);
    draw_circle(painter, at, static_cast<float>(look.key.chroma_high) * map.px_per_code, line, t.series[1]);
    const float side = painter.em(0.7F);
    const Rect mark{std::round(at.x - side / 2), std::round(at.y - side / 2), side, side};
    painter.fill(mark, {code_of(look.key.color.r), code_of(look.key.color.g), code_of(look.key.color.b), 255},
                 side / 2);
    painter.frame(mark, canvas_ink(t), painter.hairline(), side / 2);
}

void draw_vectorscope(Painter& painter, const Node& node, const VectorscopeLook& look) {
    const Theme& t = painter.theme();
    const ChromaMap map(node.rect(), look.zoom);
    const Rect& square = map.square;
    painter.ground(square, t.canvas);
    painter.push_clip(square);
    const glm::vec2 zero = glm::round(map.at({0, 0}));
    painter.fill({square.x, zero.y, square.w, painter.hairline()}, canvas_ink(t, 0.16F));
    painter.fill({zero.x, square.y, painter.hairline(), square.h}, canvas_ink(t, 0.16F));
    draw_circle(painter, map.at({0, 0}), 64 * map.px_per_code, painter.hairline(), canvas_ink(t, 0.16F));
    draw_circle(painter, map.at({0, 0}), 127.5F * map.px_per_code, painter.hairline(), canvas_ink(t, 0.16F));
    painter.image(map.image(), look.image, map.px_per_code >= 4);
    draw_targets(painter, map);
    if (look.has_key) draw_key(painter, map, look);
    painter.pop_clip();
    Rect corner = square.inset(painter.em(0.5F), painter.em(0.3F));
    painter.text(corner.cut_bottom(painter.em(1.3F)), look.readout, painter.number_style(), canvas_ink(t));
}

std::string_view chroma_text(Ui& ui, glm::vec2 chroma) {
    char cb[32], cr[32], saturation[32], hue[32];
    const auto turn = static_cast<double>(glm::degrees(std::atan2(chroma.y, chroma.x)));
    return ui.join({"Cb ", format_number(cb, static_cast<double>(chroma.x), 0), "   Cr ",
                    format_number(cr, static_cast<double>(chroma.y), 0), "   ",
                    format_number(saturation, static_cast<double>(glm::length(chroma)), 0), " at ",
                    format_number(hue, turn < 0 ? turn + 360 : turn, 0), "\xC2\xB0"});
}

/// A grip on a circle. Each has another angle, so that grips of the same radius do not cover each other. It is inside
/// the square if possible.
Edit edit_radius(Ui& ui, const ChromaMap& map, glm::vec2 key, float angle, const HandleOptions& handle,
                 const HandleRange& range, Color color, double& radius) {
    const Rect before = map.square;
    const glm::vec2 toward = glm::length(key) < 1 ? glm::vec2(1, 0) : -glm::normalize(glm::vec2(key.x, -key.y));
    const glm::vec2 way(toward.x * std::cos(angle) - toward.y * std::sin(angle),
                        toward.x * std::sin(angle) + toward.y * std::cos(angle));
    const glm::vec2 place = map.at(key) + way * static_cast<float>(radius) * map.px_per_code;
    const glm::vec2 kept = glm::clamp(place, before.at(), before.at() + before.size());
    HandleOptions options = handle;
    options.at += kept;
    const HandleMoves moves = put_handle(ui, options);
    // Only movement along the grip's own direction counts, so that the grip moves as far as the pointer.
    const glm::vec2 at = moves.to - handle.at;
    const auto dragged = static_cast<double>(glm::dot(at - map.at(key), way) / map.px_per_code);
    const Edit edit = edit_by_handle(ui, moves, range, moves.steps.x + moves.steps.y, dragged, radius);
    char buffer[32];
    ui.last().number = ui.number(radius, range.minimum, range.maximum, range.step);
    ui.last().text = ui.copy(format_number(buffer, radius, 1));
    ui.draw_with<draw_knob>(ui.last(), KnobLook{.color = color});
    return edit;
}

void edit_key(Ui& ui, const ChromaMap& map, glm::vec2 origin, KeyCircles& key, VectorscopeResult& result) {
    const glm::vec3 color = luma_chroma(key.color);
    const glm::vec2 at(color.y, color.z);
    constexpr float apart = 0.6F;  // rad
    result.low = edit_radius(
        ui, map, at, -apart,
        {.label = "Chroma low", .tip = "Colours nearer to the key colour than this are removed", .at = -origin},
        {.minimum = 0,
         .maximum = std::max(0.0, key.chroma_high - least_gap),
         .step = 1,
         .reset = key.reset_low,
         .initial = key.initial_low},
        ui.theme().series[0], key.chroma_low);
    result.high = edit_radius(
        ui, map, at, apart,
        {.label = "Chroma high", .tip = "Colours farther from the key colour than this are kept", .at = -origin},
        {.minimum = std::min(key.chroma_low + least_gap, most_radius),
         .maximum = most_radius,
         .step = 1,
         .reset = key.reset_high,
         .initial = key.initial_high},
        ui.theme().series[1], key.chroma_high);
}

struct WaveformLook {
    ImageHandle image;
    float hovered;  ///< luma; negative: none
    std::string_view readout;
};

Rect waveform_area(const Rect& rect, float em) {
    Rect area = rect.inset(0, em * 0.5F);
    area.cut_left(em * 2.2F);
    return area;
}

void draw_waveform(Painter& painter, const Node& node, const WaveformLook& look) {
    const Theme& t = painter.theme();
    painter.ground(node.rect(), t.canvas);
    const Rect area = waveform_area(node.rect(), painter.em(1));
    TextStyle style = painter.number_style();
    style.size = painter.em(0.85F);
    for (const int luma : {0, 64, 128, 192, 255}) {
        const float y = std::round(area.bottom() - area.h * (static_cast<float>(luma) + 0.5F) / scope_side);
        painter.fill({area.x, y, area.w, painter.hairline()}, canvas_ink(t, 0.16F));
        char buffer[32];
        painter.text({node.rect().x, y - painter.em(0.6F), painter.em(1.9F), painter.em(1.2F)},
                     format_number(buffer, luma, 0), style, canvas_ink(t, 0.6F), Align::end);
    }
    painter.image(area, look.image);
    if (look.hovered < 0) return;
    const float y = std::round(area.bottom() - area.h * (look.hovered + 0.5F) / scope_side);
    painter.fill({area.x, y, area.w, painter.hairline()}, canvas_ink(t));
    Rect line = area.inset(painter.em(0.4F), 0);
    painter.text(line.cut_top(painter.em(1.3F)), look.readout, painter.number_style(), canvas_ink(t));
}

}  // namespace

glm::vec3 luma_chroma(glm::vec3 code) {
    const float luma = w.red * code.r + (1 - w.red - w.blue) * code.g + w.blue * code.b;
    return {luma, (code.b - luma) / (2 * (1 - w.blue)), (code.r - luma) / (2 * (1 - w.red))};
}

glm::vec3 rgb_of(glm::vec3 luma_chroma) {
    const float red = luma_chroma.x + 2 * (1 - w.red) * luma_chroma.z;
    const float blue = luma_chroma.x + 2 * (1 - w.blue) * luma_chroma.y;
    return {red, (luma_chroma.x - w.red * red - w.blue * blue) / (1 - w.red - w.blue), blue};
}

void count_chroma(const ScopeSource& source, DensityGrid& grid) {
    grid.counts.assign(cells, 0);
    each_pixel(source, [&](std::size_t, glm::vec3 code) {
        const glm::vec3 at = luma_chroma(code);
        ++grid.counts[cell(std::round(at.y) + 128, 128 - std::round(at.z))];
    });
}

void count_luma(const ScopeSource& source, DensityGrid& grid) {
    grid.counts.assign(cells, 0);
    const auto width = static_cast<float>(std::max(source.size.x, 1));
    each_pixel(source, [&](std::size_t x, glm::vec3 code) {
        const float column = std::floor((static_cast<float>(x) + 0.5F) / width * scope_side);
        ++grid.counts[cell(column, 255 - std::round(luma_chroma(code).x))];
    });
}

void shade_chroma(const DensityGrid& grid, std::vector<std::uint8_t>& rgba) {
    const Brightness brightness(grid);
    rgba.resize(cells * 4);
    for (std::size_t i = 0; i < cells; ++i) {
        const auto x = static_cast<float>(i % scope_side), y = static_cast<float>(i / scope_side);
        const std::uint8_t alpha = brightness.of(grid.counts[i]);
        const glm::vec3 color = alpha == 0 ? glm::vec3(0) : rgb_of({shown_luma, x - 128, 128 - y});
        rgba[4 * i] = code_of(color.r), rgba[4 * i + 1] = code_of(color.g), rgba[4 * i + 2] = code_of(color.b);
        rgba[4 * i + 3] = alpha;
    }
}

void shade_luma(const DensityGrid& grid, Color color, std::vector<std::uint8_t>& rgba) {
    const Brightness brightness(grid);
    rgba.resize(cells * 4);
    for (std::size_t i = 0; i < cells; ++i) {
        rgba[4 * i] = color.r, rgba[4 * i + 1] = color.g, rgba[4 * i + 2] = color.b;
        rgba[4 * i + 3] = brightness.of(grid.counts[i]);
    }
}

ScopeImage::~ScopeImage() {
    if (handle_ != 0) store_.remove(handle_);
}

void ScopeImage::update_chroma(const ScopeSource& source) {
    count_chroma(source, grid_);
    shade_chroma(grid_, rgba_);
    send();
}

void ScopeImage::update_luma(const ScopeSource& source, Color color) {
    count_luma(source, grid_);
    shade_luma(grid_, color, rgba_);
    send();
}

void ScopeImage::send() {
    if (handle_ == 0)
        handle_ = store_.add(glm::ivec2(scope_side), rgba_);
    else
        store_.update(handle_, glm::ivec2(scope_side), rgba_);
}

VectorscopeResult vectorscope(Ui& ui, std::string_view label, ImageHandle image, KeyCircles* key,
                              const VectorscopeOptions& options) {
    VectorscopeResult result;
    Node& node = ui.open(Role::plot, label, Axis::y, Sense::hover);
    node.size[0] = options.width, node.size[1] = options.height;
    node.clips = true;
    node.tip = ui.copy(options.tip);
    ui.follow_size(node);
    const Rect rect = ui.rect_before(node.id);
    const ChromaMap map(rect, options.zoom);
    const Response r = ui.respond(node);
    VectorscopeLook look{.image = image, .zoom = options.zoom, .has_key = key != nullptr, .key = {}, .readout = {}};
    result.over = r.hovered && map.square.contains(r.pointer);
    if (result.over) {
        result.chroma = map.chroma_at(r.pointer);
        look.readout = chroma_text(ui, result.chroma);
        node.text = look.readout;
    }
    if (key != nullptr) {
        edit_key(ui, map, rect.at(), *key, result);
        look.key = *key;
    }
    ui.draw_with<draw_vectorscope>(ui.parent(), look);
    ui.close();
    return result;
}

void waveform(Ui& ui, std::string_view label, ImageHandle image, const WaveformOptions& options) {
    Node& node = ui.leaf(Role::plot, label, Sense::hover);
    node.size[0] = options.width, node.size[1] = options.height;
    node.tip = ui.copy(options.tip);
    const Rect area = waveform_area(ui.rect_before(node.id), ui.em(1));
    const Response r = ui.respond(node);
    WaveformLook look{.image = image, .hovered = -1, .readout = {}};
    if (r.hovered && area.contains(r.pointer)) {
        look.hovered = std::clamp(std::floor((area.bottom() - r.pointer.y) / area.h * scope_side), 0.0F, 255.0F);
        char buffer[32];
        look.readout = ui.join({"Y ", format_number(buffer, static_cast<double>(look.hovered), 0)});
        node.text = look.readout;
    }
    ui.draw_with<draw_waveform>(node, look);
}

}  // namespace lapfx::ui
