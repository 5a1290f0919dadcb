// lapfx render: a scene as a picture, a sequence of pictures or a video.
#include <cmath>
#include <regex>

#include "commands/command.h"
#include "commands/options.h"
#include "commands/output.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "lapfx/file.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::string scene, preset, output, amounts, size = "1280x1024", backend = "auto", overlay = "none";
    std::vector<std::string> settings;
    double fps = 25.0, from = 0.0, to = -1.0, at = -1.0;
    bool has_at = false, has_span = false;
};

Overlay parse_overlay(const std::string& text) {
    constexpr std::pair<const char*, Overlay> names[] = {
        {"none", Overlay::none}, {"vessels", Overlay::vessels}, {"fat", Overlay::fat}, {"bleed", Overlay::bleed}};
    for (const auto& [name, overlay] : names)
        if (text == name) return overlay;
    throw wrong_option("--overlay", "\"" + text + "\" is none of vessels, fat, bleed, none");
}

/// Number `index` of a sequence named like out_%04d.png.
std::string sequence_name(const std::string& pattern, int index) {
    static const std::regex number(R"(%(0?)(\d*)d)");
    std::smatch match;
    std::regex_search(pattern, match, number);
    std::string digits = std::to_string(index);
    const std::size_t width = match[2].length() > 0 ? std::stoul(match[2]) : 0;
    if (digits.size() < width) digits.insert(0, width - digits.size(), match[1].length() > 0 ? '0' : ' ');
    return match.prefix().str() + digits + match.suffix().str();
}

bool is_sequence_name(const std::string& name) {
    static const std::regex pattern(R"([^%]*%0?\d{0,2}d[^%]*\.png)");
    return std::regex_match(name, pattern);
}

/// Times of the frames, s. A span holds the frame at `from` and not the one at `to`.
std::vector<double> frame_times(const Options& o, const Scene& scene) {
    if (o.has_at) return {o.at};
    const double to = o.to >= 0.0 ? o.to : scene.duration;
    if (to <= o.from)
        throw wrong_option("--to", std::to_string(to) + " s is not after --from " + std::to_string(o.from) + " s");
    const double count = std::ceil((to - o.from) * o.fps - 1e-9);
    if (count > 1e6) throw wrong_option("--to", "more than a million frames");
    std::vector<double> times;
    for (int i = 0; i < static_cast<int>(count); ++i) times.push_back(o.from + i / o.fps);
    return times;
}

void check_output(const Options& o) {
    const bool still = o.output.ends_with(".png") && o.output.find('%') == std::string::npos;
    if (still && o.has_span)
        throw wrong_option("-o",
                           "\"" + o.output + "\" is one picture; with --from and --to name a video or out_%04d.png");
    if (!still && o.has_at)
        throw wrong_option("-o", "\"" + o.output + "\" is not one picture; --at makes one: name a .png");
    if (!still && !is_sequence_name(o.output) && !is_video_name(o.output))
        throw wrong_option("-o", "\"" + o.output + "\" is none of out.png, out_%04d.png, out.mp4 (.mov, .mkv, .avi)");
}

/// A line of --amounts: what a trainee would be scored by, exact, without looking at pixels.
std::string amounts_line(double time, const Amounts& a) {
    std::array<char, 160> line{};
    std::snprintf(line.data(), line.size(), "%.4f,%.3f,%.3f,%d,%d,%.5f\n", time, a.blood_area, a.blood_volume, a.wounds,
                  a.bleeding_wounds, a.haze);
    return line.data();
}

void render_frames(Preview& preview, const Options& o, const std::vector<double>& times, glm::ivec2 size) {
    Progress progress("rendering", static_cast<int>(times.size()));
    std::optional<VideoFile> video;
    std::string amounts = "time_s,blood_area_mm2,blood_volume_mm3,wounds,bleeding_wounds,haze\n";
    if (is_video_name(o.output)) video.emplace(o.output, o.fps, cv::Size(size.x, size.y));
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Image image = preview.image(times[i], size);
        amounts += amounts_line(times[i], preview.amounts());
        progress.step();
        if (video)
            video->add(image);
        else
            write_png(is_sequence_name(o.output) ? sequence_name(o.output, static_cast<int>(i)) : o.output, image);
    }
    if (video) video->finish();
    if (!o.amounts.empty()) write_file(o.amounts, amounts);
}

void run(Options o) {
    const glm::ivec2 size = parse_size(o.size);
    const Backend backend = parse_backend(o.backend);
    const Overlay overlay = parse_overlay(o.overlay);
    // A single picture without --at is that of the start.
    if (!o.has_at && !o.has_span && o.output.ends_with(".png") && o.output.find('%') == std::string::npos) {
        o.has_at = true;
        o.at = 0.0;
    }
    check_output(o);
    check_folder(o.output);
    if (!o.amounts.empty()) check_folder(o.amounts);
    const Scene scene = load_scene(o.scene);
    const Preset preset = preset_for(scene, o.preset, o.settings);
    const std::vector<double> times = frame_times(o, scene);
    const Context context = Context::create(backend);
    Preview preview(scene, preset, {.clip_folders = clip_folders(), .wait_for_clips = true, .overlay = overlay});
    print_warnings(preview);
    if (o.has_at) warn_after_end(scene, o.at);
    render_frames(preview, o, times, size);
    print_clip_warnings(preview);
}

}  // namespace

void add_render(CLI::App& app) {
    auto o = std::make_shared<Options>();
    const CLI::Validator finite = finite_number();
    CLI::App* verb =
        app.add_subcommand("render", "Render a scene to a PNG, a PNG sequence or a video, without a display");
    verb->add_option("SCENE", o->scene, "The scene (.scene.json)")->required();
    verb->add_option("--preset", o->preset, "This preset instead of the one that the scene names");
    verb->add_option("--set", o->settings, "Change one parameter: KEY=VALUE, such as bleeding.speed=8; repeatable")
        ->allow_extra_args(false);
    verb->add_option("--size", o->size, "WxH in pixels")->capture_default_str();
    verb->add_option("--fps", o->fps, "Frames per second of a sequence or video")
        ->check(finite)
        ->check(CLI::Range(0.1, 1000.0))
        ->capture_default_str();
    auto* from = verb->add_option("--from", o->from, "First frame, s")->check(finite)->check(CLI::Range(0.0, 86400.0));
    auto* to = verb->add_option("--to", o->to, "End, s; the scene's end if not given")
                   ->check(finite)
                   ->check(CLI::Range(0.0, 86400.0));
    auto* at =
        verb->add_option("--at", o->at, "One picture at this time, s")->check(finite)->check(CLI::Range(0.0, 86400.0));
    at->excludes(from)->excludes(to);
    verb->add_option("--backend", o->backend, "egl, osmesa or auto (EGL, else OSMesa)")->capture_default_str();
    verb->add_option(
            "--overlay", o->overlay,
            "False colour over the tissue: vessels or fat (their density), bleed (isolines of the bleed value, "
            "every 2 mm)")
        ->capture_default_str();
    verb->add_option("--amounts", o->amounts,
                     "Write the amounts of each frame (blood mm2 and mm3, wounds, haze) as CSV");
    verb->add_option("-o,--output", o->output, "out.png, out_%04d.png, or a video: out.mp4, .mov, .mkv, .avi")
        ->required();
    verb->footer("Example: lapfx render samples/lagb.scene.json --at 6 --set bleeding.speed=8 -o out.png");
    verb->callback([o, from, to, at] {
        o->has_at = at->count() > 0;
        o->has_span = from->count() + to->count() > 0;
        run(*o);
    });
}

}  // namespace lapfx::commands
