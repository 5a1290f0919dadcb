#include "match/explain/scene_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "lapfx/preset.h"
#include "match/picture/colors.h"
#include "match/picture/instruments.h"
#include "match/picture/round_view.h"
#include "match/picture/view.h"

namespace lapfx::match {

namespace {

constexpr int worked_height = 240;    // px
constexpr double trimmed = 0.1;       // share of the values that is left out at either end of a mean
constexpr double least_code = 18;     // darker pixels are unlit
constexpr double least_tissue = 0.3;  // of the view
constexpr int least_pixels = 400;     // of the worked size: fewer say nothing
constexpr double least_exposure = 0.01, most_exposure = 100;

// What is overexposed, as light before the curve, where 1 is white.
constexpr double bright_end = 0.98;  // share of the tissue that is darker: the rest are highlights
constexpr double most_tissue = 0.8;  // at the bright end, unless the video's is brighter
constexpr double most_haze = 0.7;    // of a dense veil
constexpr double most_blood = 0.45;  // beyond it, blood is coral

// Highlights: they have the colour of the lamp.
constexpr double highlight_share = 0.02;  // the brightest of the view
constexpr double highlight_code = 140;    // that they have at least
constexpr double clipped_code = 252;      // brighter says nothing about colour
constexpr double highlight_color = 0.4;   // saturation that they have at most
constexpr int least_highlights = 25;      // px

// Blood and haze.
constexpr float blood_redness = 3.2F;   // redness (colors.h)
constexpr float blood_brightest = 200;  // code value of its red
constexpr double least_blood = 0.004;   // share of the view
constexpr double haze_light = 0.06;     // linear: light that even the darkest channel near by has
constexpr double haze_color = 0.45;     // saturation that it has at most
constexpr double least_haze = 0.05;     // share of the view
constexpr int haze_reach = 5;           // px

using Vec = glm::dvec3;  // red, green, blue

Vec linear_color(const Vec& srgb) {
    Vec made;
    for (int c = 0; c < 3; ++c) made[c] = static_cast<double>(linear_of(static_cast<float>(255 * srgb[c])));
    return made;
}

Vec srgb_color(const Vec& linear) {
    Vec made;
    for (int c = 0; c < 3; ++c)
        made[c] = static_cast<double>(code_of(static_cast<float>(std::max(0.0, linear[c])))) / 255;
    return glm::clamp(made, 0.0, 1.0);
}

double largest(const Vec& color) {
    return std::max({color.r, color.g, color.b});
}

double luminance(const Vec& linear) {
    return 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b;
}

/// The fall-off of light that shaders/post.glsl draws with a vignette, at a place of a picture.
double fall_off(cv::Size size, int x, int y, double vignette, double lens_falloff) {
    const glm::dvec2 from = glm::dvec2(x + 0.5, y + 0.5) - 0.5 * glm::dvec2(size.width, size.height);
    const double radius = glm::length(from) / (0.5 * size.height);
    const double t = std::clamp((radius - 0.35) / (1.15 - 0.35), 0.0, 1.0);
    return glm::mix(1.0, 1 - lens_falloff * t * t * (3 - 2 * t), vignette);
}

/// A picture at the worked size, with what of it counts.
struct WorkedPicture {
    cv::Mat code, linear, view, counts;  // CV_8UC3 and CV_32FC3 BGR; CV_8U
    int viewed = 0;                      // px in the view
};

WorkedPicture worked(const Image& image) {
    WorkedPicture w;
    if (image.width < 1 || image.height < 1 || image.pixels.empty()) return w;
    const double scale = std::min(1.0, static_cast<double>(worked_height) / image.height);
    const cv::Size size(std::max(1, static_cast<int>(std::lround(image.width * scale))),
                        std::max(1, static_cast<int>(std::lround(image.height * scale))));
    shrink(image, size, w.code);
    to_linear(w.code, w.linear);
    w.view = view_of(w.code);
    w.counts = w.view & ~instruments_of(w.code, w.view);
    w.viewed = cv::countNonZero(w.view);
    // No instrument hides so much: it is dense smoke, which is as grey.
    if (cv::countNonZero(w.counts) < least_tissue * w.viewed) w.counts = w.view.clone();
    return w;
}

Vec at(const cv::Mat& linear, int x, int y) {
    const auto& p = linear.at<cv::Vec3f>(y, x);
    return {p[2], p[1], p[0]};
}

double brightest_code(const cv::Mat& code, int x, int y) {
    const auto& p = code.at<cv::Vec3b>(y, x);
    return std::max({p[0], p[1], p[2]});
}

double saturation(const cv::Mat& code, int x, int y) {
    const auto& p = code.at<cv::Vec3b>(y, x);
    const double most = std::max({p[0], p[1], p[2]}), least = std::min({p[0], p[1], p[2]});
    return most > 0 ? (most - least) / most : 0;
}

template <typename F>
void each_pixel(const cv::Mat& mask, const F& f) {
    for (int y = 0; y < mask.rows; ++y) {
        const auto* row = mask.ptr<std::uint8_t>(y);
        for (int x = 0; x < mask.cols; ++x)
            if (row[x] != 0) f(x, y);
    }
}

/// Light before the camera's curve, for a picture that was drawn with one vignette and is to have another one.
class LightBefore {
  public:
    LightBefore(const WorkedPicture& w, const CameraResponse& response, double drawn, double wanted)
        : w_(w), response_(response), drawn_(drawn), wanted_(wanted) {}

    Vec at(int x, int y) const {
        const Vec light = match::at(w_.linear, x, y);
        const double before = fall_off(w_.code.size(), x, y, drawn_, response_.lens_falloff),
                     after = fall_off(w_.code.size(), x, y, wanted_, response_.lens_falloff);
        const bool lens_after = response_.curve == ResponseCurve::shoulder;
        Vec made;
        for (int c = 0; c < 3; ++c)
            made[c] = lens_after ? light_shown_as(light[c] / before, response_) * after
                                 : light_shown_as(light[c], response_) / before * after;
        return made;
    }

  private:
    const WorkedPicture& w_;
    const CameraResponse& response_;
    double drawn_, wanted_;
};

/// Light of the lit tissue before the curve, without its brightest and darkest parts, channel by channel.
std::optional<Vec> tissue_light(const WorkedPicture& w, const LightBefore& before) {
    std::array<std::vector<double>, 3> values;
    each_pixel(w.counts, [&](int x, int y) {
        const double most = brightest_code(w.code, x, y);
        if (most < least_code || most >= clipped_code) return;
        const Vec light = before.at(x, y);
        for (int c = 0; c < 3; ++c) values[static_cast<std::size_t>(c)].push_back(light[c]);
    });
    if (values[0].size() < least_pixels) return std::nullopt;
    Vec mean(0.0);
    for (int c = 0; c < 3; ++c) {
        auto& all = values[static_cast<std::size_t>(c)];
        std::sort(all.begin(), all.end());
        const auto cut = static_cast<std::size_t>(trimmed * static_cast<double>(all.size()));
        double sum = 0;
        for (std::size_t i = cut; i < all.size() - cut; ++i) sum += all[i];
        mean[c] = sum / static_cast<double>(all.size() - 2 * cut);
    }
    return glm::max(mean, Vec(1e-4));
}

/// The brightest channel at the bright end of the tissue, as tissue_light(). `gain`: what each channel is brightened
/// by.
double brightest_light(const WorkedPicture& w, const LightBefore& before, const Vec& gain) {
    std::vector<double> values;
    each_pixel(w.counts, [&](int x, int y) {
        if (brightest_code(w.code, x, y) < least_code) return;
        values.push_back(largest(before.at(x, y) * gain));
    });
    if (values.empty()) return 0;
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(bright_end * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), end, values.end());
    return *end;
}

/// The lamp's colour by what is reflected without colour, linear, 1 as its largest channel.
std::optional<Vec> lamp_color(const WorkedPicture& w) {
    std::vector<int> codes;
    each_pixel(w.view, [&](int x, int y) { codes.push_back(static_cast<int>(brightest_code(w.code, x, y))); });
    if (codes.empty()) return std::nullopt;
    const auto place = static_cast<std::ptrdiff_t>((1 - highlight_share) * static_cast<double>(codes.size() - 1));
    std::nth_element(codes.begin(), codes.begin() + place, codes.end());
    const double least = std::max(highlight_code, static_cast<double>(codes[static_cast<std::size_t>(place)]));
    Vec sum(0.0);
    int count = 0;
    each_pixel(w.view, [&](int x, int y) {
        const double most = brightest_code(w.code, x, y);
        if (most < least || most >= clipped_code || saturation(w.code, x, y) > highlight_color) return;
        sum += at(w.linear, x, y);
        ++count;
    });
    if (count < least_highlights) return std::nullopt;
    return sum / largest(sum);
}

/// The mean light of blood, or none where too little of the view is that red.
std::optional<Vec> blood_light(const WorkedPicture& w) {
    cv::Mat redness;
    redness_of(w.linear, redness);
    Vec sum(0.0);
    int count = 0;
    each_pixel(w.counts, [&](int x, int y) {
        const double red = w.code.at<cv::Vec3b>(y, x)[2];
        if (redness.at<float>(y, x) < blood_redness || red < least_code || red > static_cast<double>(blood_brightest))
            return;
        sum += at(w.linear, x, y);
        ++count;
    });
    if (count < least_blood * w.viewed) return std::nullopt;
    return sum / static_cast<double>(count);
}

/// The mean light where a veil lies over everything: no channel of any pixel near by is dark, and colours are pale.
std::optional<Vec> haze_light_of(const WorkedPicture& w) {
    cv::Mat channels[3], darkest;
    cv::split(w.linear, channels);
    cv::min(channels[0], channels[1], darkest);
    cv::min(darkest, channels[2], darkest);
    cv::erode(darkest, darkest, cv::getStructuringElement(cv::MORPH_ELLIPSE, {2 * haze_reach + 1, 2 * haze_reach + 1}));
    Vec sum(0.0);
    int count = 0;
    each_pixel(w.view, [&](int x, int y) {
        if (darkest.at<float>(y, x) < haze_light || saturation(w.code, x, y) > haze_color ||
            brightest_code(w.code, x, y) >= clipped_code)
            return;
        sum += at(w.linear, x, y);
        ++count;
    });
    if (count < least_haze * w.viewed) return std::nullopt;
    return sum / static_cast<double>(count);
}

/// The hue and saturation of `light` under this lamp, as bright as `now`, sRGB.
Vec with_hue_of(const Vec& light, const Vec& lamp, const Vec& now) {
    const Vec own = light / glm::max(lamp, Vec(0.05)), before = linear_color(now);
    const Vec made = own * (luminance(before) / std::max(luminance(own), 1e-6));
    return srgb_color(made / std::max(1.0, largest(made)));
}

/// Exposure, lamp and tissue so that the tissue of the preview has the light of the reference's.
void balance(const Vec& gain, const std::optional<Vec>& lamp, const SceneLook& now, SceneLook& look) {
    const Vec light = linear_color(now.light), organ = linear_color(now.organ);
    const Vec wanted = now.exposure * light * organ * gain;
    const Vec shown = lamp.value_or(light / std::max(largest(light), 1e-6));
    const Vec tissue = wanted / glm::max(shown, Vec(0.02));
    look.light = srgb_color(shown);
    look.organ = srgb_color(tissue / largest(tissue));
    look.exposure = std::clamp(largest(tissue), least_exposure, most_exposure);
}

/// With less light, where it would be overexposed as it is lit and exposed now; else the same to the last bit.
Vec unbleached(const Vec& color, const SceneLook& look, double most) {
    const double shown = largest(linear_color(color) * linear_color(look.light)) * look.exposure;
    return shown > most ? srgb_color(linear_color(color) * (most / shown)) : color;
}

/// Blood and haze as bright as the exposure allows. Those that were brighter than that before stay.
void guard_colors(const SceneLook& now, LookProposal& made) {
    struct Guarded {
        Vec SceneLook::*color;
        double most;
    };
    bool darker = false;
    for (const Guarded& each : {Guarded{&SceneLook::blood_thin, most_blood},
                                {&SceneLook::blood_deep, most_blood},
                                {&SceneLook::haze, most_haze}}) {
        Vec& color = made.look.*each.color;
        const double before = largest(linear_color(now.*each.color) * linear_color(now.light)) * now.exposure;
        const Vec guarded = unbleached(color, made.look, std::max(each.most, before));
        darker = darker || guarded != color;
        color = guarded;
    }
    if (darker) made.notes.emplace_back("Blood or haze would be overexposed: they are darker for it.");
}

/// "1.9 to 2.4: ".
std::string exposure_text(double before, double after) {
    char text[64];
    std::snprintf(text, sizeof text, "Exposure %.3g to %.3g: ", before, after);
    return text;
}

LookProposal impossible(const SceneLook& now, std::string why) {
    return {.possible = false, .look = now, .notes = {std::move(why)}};
}

}  // namespace

SceneLook look_of(const Scene& scene, const Preset& preset) {
    return {.vignette = scene.camera.vignette,
            .exposure = scene.camera.exposure,
            .light = scene.light.color,
            .organ = scene.organ.color,
            .blood_thin = preset.bleeding.color_thin,
            .blood_deep = preset.bleeding.color_deep,
            .haze = preset.smoke.haze.color};
}

void put_look(const SceneLook& look, Scene& scene, Preset& preset) {
    // Rounded to what is short in the file; what is the same stays to the last bit.
    const auto put_color = [](Vec& color, const Vec& wanted) {
        if (wanted != color) color = glm::round(wanted * 255.0) / 255.0;
    };
    scene.camera.vignette = look.vignette;
    if (look.exposure != scene.camera.exposure) scene.camera.exposure = std::round(look.exposure * 1e4) / 1e4;
    put_color(scene.light.color, look.light);
    put_color(scene.organ.color, look.organ);
    put_color(preset.bleeding.color_thin, look.blood_thin);
    put_color(preset.bleeding.color_deep, look.blood_deep);
    put_color(preset.smoke.haze.color, look.haze);
}

LookProposal propose_look(const Image& reference, const Image& preview, const SceneLook& now, const cv::Mat& organ,
                          const CameraResponse& response) {
    const WorkedPicture video = worked(reference);
    WorkedPicture ours = worked(preview);
    if (video.viewed < least_pixels) return impossible(now, "This frame of the reference is black.");
    if (ours.viewed < least_pixels) return impossible(now, "The preview is black: light the organ first.");
    if (!organ.empty()) {  // the dark cavity beside it is no tissue
        cv::Mat seen;
        cv::resize(organ, seen, ours.code.size(), 0, 0, cv::INTER_NEAREST);
        ours.counts &= seen;
    }
    LookProposal made{.possible = true, .look = now, .notes = {}};
    SceneLook& look = made.look;
    look.vignette = disc_of(video.view) ? 1 : 0;
    made.notes.emplace_back(look.vignette > 0 ? "The view is round: vignette on."
                                              : "No round view is found in this frame: vignette off.");
    const LightBefore in_video(video, response, 0, 0), in_ours(ours, response, now.vignette, look.vignette);
    const auto theirs = tissue_light(video, in_video), own = tissue_light(ours, in_ours);
    if (!theirs) return impossible(now, "This frame shows too little lit tissue.");
    if (!own) return impossible(now, "The preview shows too little lit tissue.");
    const auto haze = haze_light_of(video);
    const auto lamp = haze ? std::nullopt : lamp_color(video);  // behind smoke, highlights have its colour
    const Vec gain = *theirs / *own;
    const double white = std::max(most_tissue, brightest_light(video, in_video, Vec(1)));
    const double ours_white = std::max(white, brightest_light(ours, in_ours, Vec(1)));
    const double brightest = brightest_light(ours, in_ours, gain);
    const double held = std::min(1.0, ours_white / std::max(brightest, 1e-6));
    balance(gain * held, lamp, now, look);
    made.notes.push_back(
        exposure_text(now.exposure, look.exposure) +
        (haze   ? "exposure and tissue colour follow the tissue; behind smoke the lamp keeps its colour."
         : lamp ? "exposure and tissue colour follow the tissue, the lamp's colour the highlights."
                : "exposure and tissue colour follow the tissue; without clear highlights the lamp keeps its colour."));
    if (held < 1) made.notes.emplace_back("More exposure would bleach the brightest tissue of the preview.");
    const Vec shown = linear_color(look.light);
    if (const auto blood = blood_light(video)) {
        look.blood_thin = with_hue_of(*blood, shown, now.blood_thin);
        look.blood_deep = with_hue_of(*blood, shown, now.blood_deep);
        made.notes.emplace_back("Blood takes the hue of what is reddest; its brightness stays.");
    } else {
        made.notes.emplace_back("No blood is seen: its colours stay.");
    }
    if (haze) {
        look.haze = with_hue_of(*haze, shown, now.haze);
        made.notes.emplace_back("Haze takes the hue of the veil; its brightness stays.");
    } else {
        made.notes.emplace_back("No veil is seen: the haze keeps its colour.");
    }
    guard_colors(now, made);
    return made;
}

}  // namespace lapfx::match
