// lapfx measure: amounts of blood and smoke of a surgery video.
#include <cmath>
#include <iostream>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "commands/command.h"
#include "commands/measured_part.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "commands/say.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/video.h"
#include "match/frame/counted.h"
#include "match/use/measure_video.h"
#include "output/files.h"

namespace lapfx::commands {

namespace {

constexpr int progress_steps = 100;

struct Options {
    std::string video, output, json, plot, overlay, region, view;
    std::string strokes;
    std::vector<std::string> masks;
    std::optional<double> baseline, to;
    double from = 0.0;
    BloodQualifier blood;
};

/// What is far below all noise is nothing.
double shown(double amount) {
    constexpr double least = 1e-6;
    return amount < least ? 0.0 : amount;
}

void print(const char* name, const match::Measurement& found, match::Curve curve) {
    const bool course_only = curve == match::Curve::veil && found.course_only;
    const match::Episode& episode = curve == match::Curve::veil ? found.veil : found.blood;
    std::cout << name << ": ";
    if (course_only)
        std::cout << "course only, no level" << (episode.peak_at ? "" : ", no change");
    else if (episode.peak)
        std::cout << "peak " << shown(*episode.peak) << ", mean " << shown(*episode.mean) << ", area "
                  << shown(*episode.area) << " s";
    else
        std::cout << match::without_episode(found, curve);
    const std::pair<const char*, const std::optional<double>*> times[] = {
        {"onset", &episode.onset}, {"rise", &episode.rise}, {"peak at", &episode.peak_at}, {"decay", &episode.decay}};
    for (const auto& [word, time] : times)
        if (*time) std::cout << ", " << word << ' ' << **time << " s";
    std::cout << '\n';
}

std::string baseline_text(std::optional<double> baseline, bool suggested) {
    return baseline ? match::seconds_text(*baseline) + (suggested ? ", suggested" : "") : "none";
}

void print(const match::Measurement& found) {
    std::cout.precision(3);
    std::cout << "baseline: " << baseline_text(found.baseline, found.suggested) << '\n';
    for (const match::Shot& shot : found.shots) {
        if (found.shots.size() == 1) break;
        std::cout << "shot " << match::seconds_text(shot.from) << " to " << match::seconds_text(shot.to) << ": ";
        if (shot.baseline)
            std::cout << "baseline " << baseline_text(shot.baseline, shot.suggested) << '\n';
        else
            std::cout << "no baseline: " << match::row_of(shot.why).help << '\n';
    }
    print("blood", found, match::Curve::blood);
    print("veil", found, match::Curve::veil);
}

/// What library faults call by the name of a member is an option here.
Error at_option(const Error& error, const std::string& file) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) {
        if (!fault.file.empty()) continue;  // of another file, at a place in it
        fault.file = file;
        if (!fault.place.empty() && error.failure() == Failure::bad_input) fault.place = "--" + fault.place;
    }
    return {error.failure(), std::move(faults)};
}

/// The frames that are measured with what was counted drawn over them; nothing without the option. It has the video's
/// mean rate: where that varies, a frame is repeated or left out, so that each is shown at its own time.
class OverlayFile {
  public:
    OverlayFile(const std::string& path, const VideoInfo& info) : rate_(info.frames_per_second) {
        if (!path.empty()) {
            const cv::Size size = even(info.size);
            file_.emplace(path, rate_, glm::ivec2(size.width, size.height));
        }
    }
    explicit operator bool() const { return file_.has_value(); }
    /// `estimator`: null where no baseline serves; the frame stays as it is then.
    void add(const Image& frame, const match::Estimator* estimator, const match::FrameAmounts& amounts) {
        if (!start_) start_ = amounts.time;
        hold_until(amounts.time);
        last_ = frame;
        if (estimator != nullptr) match::draw_counted(last_, *estimator, amounts);
        make_even(last_);
        if (frames_ <= at(amounts.time)) write();
    }
    /// `end`: when the last frame is gone, s.
    void finish(double end) {
        if (!file_) return;
        hold_until(end);
        Progress progress("checking the video", frames_);
        while (file_->check()) progress.step();
        file_->publish();
    }

  private:
    /// A video has even sides.
    static cv::Size even(glm::ivec2 size) { return {size.x + size.x % 2, size.y + size.y % 2}; }
    /// Adds its last column and row once more, where a side is odd.
    static void make_even(Image& frame) {
        const cv::Size size = even({frame.width, frame.height});
        if (size.width == frame.width && size.height == frame.height) return;
        std::vector<std::uint8_t> pixels(4 * static_cast<std::size_t>(size.area()));
        const cv::Mat from(frame.height, frame.width, CV_8UC4, frame.pixels.data());
        cv::Mat to(size, CV_8UC4, pixels.data());
        cv::copyMakeBorder(from, to, 0, size.height - frame.height, 0, size.width - frame.width, cv::BORDER_REPLICATE);
        frame.width = size.width, frame.height = size.height;
        frame.pixels = std::move(pixels);
    }
    int at(double time) const { return static_cast<int>(std::lround((time - *start_) * rate_)); }
    void write() {
        file_->add(last_);
        ++frames_;
    }
    void hold_until(double time) {
        while (frames_ > 0 && frames_ < at(time)) write();
    }

    double rate_;  // frames per second
    std::optional<output::VideoFile> file_;
    std::optional<double> start_;  // s of the video that is measured
    Image last_;                   // as the video has it, with what was counted
    int frames_ = 0;
};

/// When the last frame that was measured gives way to the next.
double end_of(const match::Measurement& found, const VideoReader& video) {
    const int next = video.frame_at(found.frames.back().time) + 1;
    return next < video.info().frames ? video.time_of(next) : video.info().duration;
}

match::Measurement measure(VideoReader& video, const Options& o) {
    match::MeasureOptions options{.baseline = o.baseline, .from = o.from, .to = o.to};
    options.estimator.blood = o.blood;
    if (!o.region.empty()) options.estimator.region = region_of(o.region, video.info().size);
    if (!o.view.empty()) options.estimator.round_view = round_view_of(o.view, video.info().size);
    for (const std::string& text : o.masks)
        for (match::MaskPolygon& mask : masks_of(text, video.info().size))
            options.estimator.masks.push_back(std::move(mask));
    if (!o.strokes.empty()) options.strokes = strokes_of(o.strokes, video.info().size);
    Progress progress("measuring", progress_steps);
    OverlayFile overlay(o.overlay, video.info());  // after Progress: Ctrl-C leaves nothing of it
    if (overlay)
        options.measured = [&overlay](const Image& frame, const match::Estimator* estimator,
                                      const match::FrameAmounts& amounts) { overlay.add(frame, estimator, amounts); };
    try {
        match::Measurement found = match::measure_video(video, {.options = options}, [&](double share) {
                                       progress.to(share);
                                       return true;
                                   }).found;
        overlay.finish(end_of(found, video));  // before anything else is written: a full disk is found by now
        return found;
    } catch (const Error& error) {
        throw at_option(error, o.video);
    }
}

void check_outputs(const Options& o) {
    const std::string extension = std::filesystem::path(o.output).extension().string();
    if (extension != ".csv" && extension != ".json")
        throw wrong_option("--output", "\"" + o.output + "\" ends neither in .csv nor in .json");
    if (!o.json.empty() && std::filesystem::path(o.json).extension() != ".json")
        throw wrong_option("--json", "\"" + o.json + "\" does not end in .json");
    if (!o.plot.empty()) check_picture_name("--plot", o.plot);
    if (!o.overlay.empty() && !output::is_video_name(o.overlay))
        throw wrong_option("--overlay", "\"" + o.overlay + "\" is not the name of a video, such as out.mp4");
    for (const auto& [option, file] :
         {std::pair{"--output", &o.output}, {"--json", &o.json}, {"--plot", &o.plot}, {"--overlay", &o.overlay}})
        check_output(option, *file);
}

void run(const Options& o) {
    check_outputs(o);
    VideoReader video(o.video);
    if (!video.info().warning.empty()) say(o.video + ": " + video.info().warning);
    const match::Measurement found = measure(video, o);
    const bool json = std::filesystem::path(o.output).extension() == ".json";
    write_file(o.output, json ? match::json_of(found) : match::csv_of(found));
    if (!o.json.empty()) write_file(o.json, match::json_of(found));
    if (!o.plot.empty()) output::write_png(o.plot, match::plot_of(found));
    print(found);
    for (const std::string& text : found.notes) say(o.video + ": " + text);
}

/// A row of the scene's qualifier of blood, as an option: its limits and its help.
void add_blood(Verb& verb, const char* key, double& value) {
    const Parameter& row = *scene_table().find("reference")->find("measure")->find("blood")->find_row(key);
    std::string_view help = row.help;
    if (help.ends_with('.')) help.remove_suffix(1);  // the default follows
    verb.option("--" + std::string(key), "NUMBER", std::string(help), &value,
                {.shows_default = true, .range = Range{row.minimum, row.maximum}});
}

/// The words of the column `flags`.
std::string flag_words() {
    std::string words;
    for (const match::ToldRow& row : match::told_rows) words += (words.empty() ? "" : " ") + std::string(row.key);
    return words;
}

}  // namespace

Verb measure_verb() {
    const auto o = std::make_shared<Options>();
    Verb verb{
        .name = "measure", .help = "Measure how much blood and smoke a surgery video shows", .run = [o] { run(*o); }};
    verb.argument("VIDEO", "The video, or numbered images: frame_%04d.png", &o->video, {.required = true});
    verb.option("--baseline", "S",
                "Time of a clear frame, s; 0 is the first frame. It serves the shots that show its tissue; the "
                "others, and all if it is left out, get the clearest of their own frames, or an earlier one that is "
                "nearly as clear",
                &o->baseline, {.number = Number::finite});
    verb.option("--roi", "x,y,w,h", "The part that is measured, in pixels, or in fractions if none is above 1",
                &o->region);
    verb.option("--view", "x,y,r",
                "The round view of the endoscope: its middle and radius, in pixels, or in fractions of width, "
                "height and height if x and y are not above 1. Left out, it is looked for",
                &o->view);
    verb.option("--mask", "POLYGON|FILE.json",
                "A polygon that is left out, such as an instrument: its corners x,y,x,y,x,y..., as --roi, or a "
                "JSON file of polygons, [[[x,y],...],...]; may be repeated",
                &o->masks, {.one_each = true});
    verb.option("--blood", "FILE.json",
                "Strokes that a person painted over one frame or more: what they mark as blood is learned, and all "
                "that looks like it is found in each frame, whatever the baseline held",
                &o->strokes);
    verb.option("--from", "S", "First time that is measured, s", &o->from, {.number = Number::finite});
    verb.option("--to", "S", "Last time that is measured, s", &o->to, {.number = Number::finite});
    add_blood(verb, "redness", o->blood.redness);
    add_blood(verb, "rise", o->blood.rise);
    add_blood(verb, "brightness", o->blood.brightness);
    verb.option("--json", "FILE", "Write all that was found to this file, too", &o->json);
    verb.option("--plot", "FILE", "Draw both amounts over time, with their intervals, into this PNG", &o->plot);
    verb.option("--overlay", "FILE",
                "Write the measured frames as a video (.mp4) with what was counted drawn over them: blood "
                "yellow, veil blue, what is left out dark and hatched",
                &o->overlay);
    verb.option("-o,--output", "FILE", "The amounts of each frame: .csv, or .json with all that was found", &o->output,
                {.required = true});
    verb.footer =
        "Blood is the share of the view that is blood now and was not in the baseline, veil how much of the light\n"
        "smoke takes: 1 - transmission, mean over the view. Both are 0 to 1, with an interval that holds the true one\n"
        "in about nine of ten pictures whose amounts are known (lapfx bench measure); real videos can be farther off.\n"
        "The black surround, instruments and burnt-in text are left out.\n\n"
        "Light is what smoke adds, mean over the view, in linear light before the camera's gain: a share of white. "
        "Bright\n"
        "smoke near the lens adds much of it and hides little. Gain is the factor of the camera against the baseline, "
        "1\n"
        "as there: cameras darken while bright smoke is in view. A veil that lies evenly over the view and throws no\n"
        "light back counts as gain, whose interval is wide for that reason.\n\n"
        "Peak, mean, area under the curve, onset (10 % of the way to the peak), rise (10 % to 90 %) and decay (until\n"
        "half is gone) are those of the curve smoothed over 0.2 s. Where fewer than half of the frames have an amount\n"
        "it has none of them, and where it changes by no more than the error of measuring it has no times.\n\n"
        "With --blood, blood is all that is in view; its interval is from half to twice of it, give or take .005, and\n"
        "holds the true one in about seven of ten real frames (lapfx bench measure --labelled). Three strokes over\n"
        "blood, also where it is thin, and six over what is none, folds in shadow and instruments among them, will "
        "do;\n"
        "a second frame helps, and one behind smoke if there is smoke. The file is\n"
        "  {\"format\": \"lapfx.blood_strokes\", \"version\": 1, \"without_blood\": 0.4, \"strokes\": [\n"
        "    {\"time\": 2.5, \"marks\": \"blood\", \"radius\": 6, \"points\": [[310,200],[335,214]]},\n"
        "    {\"time\": 2.5, \"marks\": \"other\", \"radius\": 12, \"points\": [[120,80],[180,96]]}]}\n"
        "with times in s, points and radii in pixels; if no coordinate of the file is above 1, all are fractions, "
        "radii\n"
        "of the width. without_blood is the time of a frame that has neither blood nor smoke; it tells how much else\n"
        "looks like blood. Left out, the baseline counts as one if hardly anything in it looks as the strokes say. "
        "The\n"
        "editor's Measure panel paints strokes over the reference and writes such a file; fit, compare and report use\n"
        "those of their scene.\n\n"
        "The columns of the CSV are time,blood,blood_low,blood_high,veil,veil_low,veil_high,flags,light,light_low,\n"
        "light_high,gain,gain_low,gain_high. What is not measurable is empty, and the flags say why, words with one\n"
        "space between them:\n  " +
        flag_words() +
        "\n\n"
        "The JSON also has the plume: how much of the veil stands out over an even one, the mean of what is above its\n"
        "median. It is missing where the baseline does not lie well.\n\n"
        "Each shot is measured against a clear frame of its own; a bag or the inside of a trocar that fills the view\n"
        "ends a shot. Where every frame of a shot is hazy, its onset, rise, peak and decay are told and no level: the\n"
        "veil is empty (no_baseline), and the JSON has a course, 0 to 1 within the shot, of which only the order\n"
        "counts. A frame that the file cannot give is empty (missing).\n\n"
        "Example:\n  lapfx measure samples/reference/operation.mp4 --to 2 -o amounts.csv --plot amounts.png";
    return verb;
}

}  // namespace lapfx::commands
