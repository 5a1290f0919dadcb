// lapfx sheet: many pictures in one, times across and presets down, to compare presets with each other and with real
// frames.
#include <opencv2/imgproc.hpp>

#include "commands/command.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "commands/shown_scene.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/authoring/preview.h"
#include "output/files.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::string scene, output, size = "320x256", backend = "auto";
    std::vector<std::string> presets, settings;
    std::vector<double> times;
};

struct Row {
    Preset preset;
    std::string label;
};

constexpr int gap = 4;           // pixels between cells
constexpr int largest = 16'384;  // pixels, a side of the sheet

/// Where the cells are: a line of text above the first row for the times, and one above each row for its preset.
struct Layout {
    glm::ivec2 cell, count;  ///< pixels; columns and rows
    int text;                ///< pixels, height of a line

    glm::ivec2 size() const { return {gap + count.x * (cell.x + gap), text + count.y * (text + cell.y + gap)}; }
    glm::ivec2 corner(int column, int row) const {
        return {gap + column * (cell.x + gap), text + row * (text + cell.y + gap) + text};
    }
};

/// The name and the file, because two presets may have the same name. OpenCV's letters are ASCII.
std::string label_of(const Preset& preset, const std::filesystem::path& file) {
    std::string label = preset.name.empty() ? file.stem().string() : preset.name;
    if (!file.empty()) label += " (" + file.filename().string() + ")";
    if (label.empty()) label = "built-in values";
    for (char& c : label)
        if (c < ' ' || c > '~') c = '?';
    return label;
}

std::string time_label(double time) {
    char text[32];
    std::snprintf(text, sizeof text, "%g s", time);
    return text;
}

/// Draws `label` into the line of text above `corner`, smaller where it would not fit into `width`.
void put_label(const cv::Mat& sheet, const std::string& label, glm::ivec2 corner, int width, int height) {
    double scale = height / 36.0;
    int below = 0;
    const cv::Size wanted = cv::getTextSize(label, cv::FONT_HERSHEY_SIMPLEX, scale, 1, &below);
    if (wanted.width > width) scale *= static_cast<double>(width) / wanted.width;
    cv::putText(sheet, label, {corner.x, corner.y - height / 4 - 1}, cv::FONT_HERSHEY_SIMPLEX, scale,
                {235, 235, 235, 255}, 1, cv::LINE_AA);
}

Image blank(glm::ivec2 size) {
    Image sheet{.width = size.x, .height = size.y, .pixels = {}, .name = ""};
    sheet.pixels.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4, 24);
    return sheet;
}

cv::Mat view_of(const Image& image) {
    return {image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data())};
}

std::vector<Row> rows_of(const Options& o, const ShownScene& shown) {
    std::vector<Row> rows;
    for (std::size_t i = 0; i < shown.presets.size(); ++i)
        rows.push_back(
            {shown.presets[i], label_of(shown.presets[i], o.presets.empty() ? shown.scene.preset : o.presets[i])});
    return rows;
}

Image draw_sheet(Preview& preview, const std::vector<Row>& rows, const std::vector<double>& times,
                 const Layout& layout) {
    Progress progress("rendering", layout.count.x * layout.count.y);
    Image sheet = blank(layout.size());
    const cv::Mat pixels = view_of(sheet);
    for (int x = 0; x < layout.count.x; ++x)
        put_label(pixels, time_label(times[static_cast<std::size_t>(x)]), {layout.corner(x, 0).x, layout.text},
                  layout.cell.x, layout.text);
    for (int y = 0; y < layout.count.y; ++y) {
        const Row& row = rows[static_cast<std::size_t>(y)];
        preview.set_preset(row.preset);
        put_label(pixels, row.label, layout.corner(0, y), layout.size().x - 2 * gap, layout.text);
        for (int x = 0; x < layout.count.x; ++x) {
            const Image cell = preview.image(times[static_cast<std::size_t>(x)], layout.cell);
            const glm::ivec2 at = layout.corner(x, y);
            view_of(cell).copyTo(pixels(cv::Rect(at.x, at.y, layout.cell.x, layout.cell.y)));
            progress.step();
        }
    }
    return sheet;
}

void run(const Options& o) {
    const glm::ivec2 cell = parse_size(o.size);
    const Backend backend = parse_backend(o.backend);
    check_picture_name("-o", o.output);
    check_output("-o", o.output);
    const ShownScene shown = open_shown(o.scene, o.presets, o.settings);
    const Scene& scene = shown.scene;
    const std::vector<Row> rows = rows_of(o, shown);
    // Text that can be read next to a cell of any size.
    const Layout layout{.cell = cell,
                        .count = {static_cast<int>(o.times.size()), static_cast<int>(rows.size())},
                        .text = glm::clamp(cell.y / 12, 16, 40)};
    // In doubles, because many large cells overflow an int.
    if (glm::any(
            glm::greaterThan(glm::dvec2(layout.count) * glm::dvec2(cell + gap + layout.text), glm::dvec2(largest))))
        throw wrong_option("--size", std::to_string(layout.count.x) + " by " + std::to_string(layout.count.y) +
                                         " pictures of " + o.size + " are more than a sheet of " +
                                         std::to_string(largest) + " pixels a side");
    const Context context = Context::create(backend);
    Preview preview(scene, rows.front().preset,
                    {.clip_folders = clip_folders(), .wait_for_clips = true, .clip_cache = shown.clips});
    print_warnings(preview);
    for (const double time : o.times) warn_after_end(scene, time);
    output::write_png(o.output, draw_sheet(preview, rows, o.times, layout));
    print_clip_warnings(preview);
}

}  // namespace

Verb sheet_verb() {
    const auto o = std::make_shared<Options>();
    Verb verb{.name = "sheet",
              .help = "Render a sheet of pictures: times across, presets down, with labels",
              .run = [o] { run(*o); }};
    verb.argument("SCENE", "The scene (.scene.json)", &o->scene, {.required = true});
    verb.option("--preset", "FILE.json", "A row with this preset; may be repeated. Default: the preset of the scene",
                &o->presets, {.one_each = true});
    verb.option("--at", "TIMES", "Times of the columns in seconds: 1,3,6,10", &o->times,
                {.required = true, .one_each = true, .separator = ',', .range = Range{0.0, 86400.0}});
    verb.option("--set", "KEY=VALUE", "Change one parameter in every row; may be repeated", &o->settings,
                {.one_each = true});
    verb.option("--size", "WxH", "Size of each picture in pixels", &o->size, {.shows_default = true});
    verb.option("--backend", "egl|osmesa|auto", "The OpenGL that draws; auto is EGL, else OSMesa", &o->backend,
                {.shows_default = true});
    verb.option("-o,--output", "FILE", "The sheet: sheet.png", &o->output, {.required = true});
    verb.footer =
        "Example:\n"
        "  lapfx sheet samples/lagb.scene.json --preset presets/slow_ooze.json --preset presets/brisk_bleed.json "
        "--at 3,6 -o sheet.png";
    return verb;
}

}  // namespace lapfx::commands
