#include "app/measure/side_by_side.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "app/measure/measure_bench.h"
#include "lapfx/authoring/placed_picture.h"
#include "ui/canvas/axis.h"
#include "ui/canvas/plot.h"
#include "ui/core/box.h"
#include "ui/widgets/basic.h"

namespace lapfx::app {

namespace {

constexpr double rows_at_scale_1 = 512;  // px: so high a picture has text of the toolkit's usual size
constexpr float least_scale = 0.75F, most_scale = 3;
constexpr float padding = 0.6F, gap = 0.4F, caption = 1.75F, plots = 11;  // em of the strip
constexpr float line = 1.4F, longest_words = 160;                         // em, of the words
constexpr double frame_slack = 5e-4;  // s: a time that lies on a frame is not the one before
constexpr int reference_series = 1;   // colour of the theme's series, as in the panel Amounts
constexpr double least_most = 2;      // % that a plot shows at least

int even(double value) {
    return 2 * std::max(static_cast<int>(std::lround(value / 2)), 1);
}

float scale_for(int rows) {
    return std::clamp(static_cast<float>(rows / rows_at_scale_1), least_scale, most_scale);
}

/// px between the pictures.
int gap_for(int rows) {
    return even(4 * scale_for(rows));
}

cv::Mat4b pixels_of(const Image& image) {
    return {image.height, image.width, reinterpret_cast<cv::Vec4b*>(const_cast<std::uint8_t*>(image.pixels.data()))};
}

Image blank(glm::ivec2 size) {
    Image image{.width = size.x, .height = size.y, .pixels = {}, .name = ""};
    image.pixels.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    return image;
}

/// The highest end of an interval, %; it gives the plot its scale.
double most_of(std::span<const match::FrameAmounts> frames, match::Curve curve) {
    double most = 0;
    for (const match::FrameAmounts& frame : frames)
        if (match::measurable(frame, curve))
            most = std::max(most, 100 * (curve == match::Curve::blood ? frame.blood : frame.veil).high);
    return most;
}

double most_of(const Compared& compared, match::Curve curve) {
    const double most = std::max(most_of(compared.of_preview, curve), most_of(compared.of_reference, curve));
    return std::clamp(1.05 * most, least_most, 100.0);
}

}  // namespace

glm::ivec2 SideBySide::size_of(glm::ivec2 frame, glm::ivec2 stored, double aspect) {
    if (!(aspect > 0)) aspect = static_cast<double>(stored.x) / std::max(stored.y, 1);
    const float em = scale_for(frame.y) * ui::dark_theme().font_size;
    const int width = even(frame.x + gap_for(frame.y) + frame.y * aspect);
    const float lines = std::ceil(longest_words * em / (static_cast<float>(width) - 2 * padding * em));
    const float strip = 2 * padding + caption + gap + plots + gap + line * lines;
    return {width, even(frame.y + std::ceil(double{strip} * em))};
}

SideBySide::SideBySide(std::shared_ptr<VideoReader> video, Compared compared)
    : video_(std::move(video)),
      compared_(std::move(compared)),
      size_(size_of(compared_.frame, video_->info().size, compared_.reference.aspect)),
      scale_(scale_for(compared_.frame.y)),
      gap_(gap_for(compared_.frame.y)),
      reference_width_(size_.x - gap_ - compared_.frame.x),
      fonts_({.hinting = ui::Hinting::slight}),  // whatever the host prefers
      ui_(fonts_, {.reduced_motion = true}) {
    const glm::ivec2 frame = compared_.frame;
    strip_.resize({size_.x, size_.y - frame.y});
    page_ = blank(size_);
    cv::Mat4b(pixels_of(page_)).setTo(cv::Vec4b(0, 0, 0, 255));
    const double shift = -compared_.reference.offset;
    const ui::Span scene{0, compared_.duration};
    blood_[0].set(compared_.of_preview, blood_curve, 0, scene);
    veil_[0].set(compared_.of_preview, veil_curve, 0, scene);
    blood_[1].set(compared_.of_reference, blood_curve, shift, scene);
    veil_[1].set(compared_.of_reference, veil_curve, shift, scene);
    most_blood_ = most_of(compared_, match::Curve::blood);
    most_veil_ = most_of(compared_, match::Curve::veil);
}

SideBySide::~SideBySide() = default;

const Image& SideBySide::page(double time, const Image& frame) {
    const cv::Mat4b page = pixels_of(page_);
    pixels_of(frame).copyTo(page(cv::Rect(0, 0, frame.width, frame.height)));
    show_reference(time);
    draw_strip(time);
    return page_;
}

/// As the editor compares it: outside of the video its first or last frame, and where a placement leaves nothing,
/// black.
void SideBySide::show_reference(double time) {
    const int wanted = video_->frame_at(time + compared_.reference.offset + frame_slack);
    if (wanted == shown_) return;
    shown_ = wanted;
    video_->read(wanted, read_);  // a frame that cannot be decoded is the one before it
    Image shaped = blank({reference_width_, compared_.frame.y});
    const bool shrinks = read_.height > shaped.height;
    cv::Mat4b into = pixels_of(shaped);
    cv::resize(pixels_of(read_), into, into.size(), 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_LINEAR);
    const double aspect = static_cast<double>(shaped.width) / shaped.height;
    if (compared_.reference.placement.moved()) shaped = placed(shaped, compared_.reference.placement, aspect);
    for (std::size_t i = 3; i < shaped.pixels.size(); i += 4) shaped.pixels[i] = 255;
    const cv::Mat4b page = pixels_of(page_);
    pixels_of(shaped).copyTo(page(cv::Rect(compared_.frame.x + gap_, 0, reference_width_, compared_.frame.y)));
}

void SideBySide::draw_strip(double time) {
    constexpr int most_builds = 10;  // the first page has to settle, the others do with one
    const ui::FrameOutput* output = nullptr;
    for (int i = 0; i < most_builds; ++i) {
        clock_ += 1.0 / 60;
        output =
            &ui_.frame({.size = strip_.size(), .scale = scale_, .time = clock_}, [&](ui::Ui& u) { build(u, time); });
        if (output->wake_at > clock_ + 0.1) break;
    }
    renderer_.draw(*output->list, fonts_, nullptr, strip_.framebuffer());
    strip_.read(drawn_);
    std::memcpy(
        page_.pixels.data() + 4 * static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(compared_.frame.y),
        drawn_.pixels.data(), drawn_.pixels.size());
}

void SideBySide::build(ui::Ui& ui, double time) {
    const ui::Panel panel(ui, "Compared", {.width = ui::grow(), .height = ui::grow(), .gap = gap, .padding = padding});
    {
        const ui::Row captions(ui, {.width = ui::grow(), .height = ui::px(ui.em(caption)), .gap = 0});
        // The right caption begins below the right picture.
        const auto left = static_cast<float>(compared_.frame.x + gap_) - ui.em(padding);
        ui::ShortText at;
        at.add(time, 2).add_unit("s");
        {
            const ui::Row half(ui, {.width = ui::px(left), .gap = 0.6F});
            ui::label(ui, ui.join({"Preview: ", compared_.preview}),
                      {.weight = ui::Weight::medium, .width = ui::grow()});
            ui::label(ui, ui.join({ui.copy(at.view())}), {.number = true});
            ui::space(ui, 0.6F);
        }
        ui::ShortText in_video;
        in_video.add(time + compared_.reference.offset, 2).add_unit("s");
        const ui::Row half(ui, {.width = ui::grow(), .gap = 0.6F});
        ui::label(ui, ui.join({"Reference: ", compared_.video}), {.weight = ui::Weight::medium, .width = ui::grow()});
        ui::label(ui, ui.copy(in_video.view()), {.number = true});
    }
    {
        const ui::Row row(ui, {.width = ui::grow(), .height = ui::px(ui.em(plots)), .gap = 0.6F});
        plot(ui, "Blood", time, blood_series, blood_[0], blood_[1]);
        plot(ui, "Veil", time, smoke_series, veil_[0], veil_[1]);
    }
    ui::label(ui, compared_.words, {.wrap = true, .width = ui::grow()});
}

/// `color`: of the preview's curve.
void SideBySide::plot(ui::Ui& ui, std::string_view name, double time, int color, const MeasuredCurve& preview,
                      const MeasuredCurve& reference) const {
    ui::PlotSeries series[2];
    std::size_t count = 0;
    if (reference.values().size() > 0) series[count++] = reference.series("Reference", reference_series);
    if (preview.values().size() > 0) series[count++] = preview.series("Preview", color);
    ui::PlotState seen{
        .x = {0, compared_.duration}, .y = {0, color == blood_series ? most_blood_ : most_veil_}, .fitted = false};
    ui::plot(ui, name, std::span(series).first(count),
             {.x_unit = "s",
              .y_name = name,
              .y_unit = "%",
              .width = ui::grow(),
              .height = ui::grow(),
              .state = &seen,
              .mark = time});
}

}  // namespace lapfx::app
