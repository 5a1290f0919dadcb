// lapfx render: a scene as a picture, a sequence of pictures or a video.
#include <cmath>
#include <iostream>
#include <regex>

#include "commands/command.h"
#include "commands/output.h"
#include "commands/progress.h"
#include "commands/session.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::string scene, preset, output, size = "1280x1024", backend = "auto", overlay = "none";
    std::vector<std::string> settings;
    double fps = 25.0, from = 0.0, to = -1.0, at = -1.0;
    bool has_at = false, has_span = false;
};

Error usage(const std::string& place, const std::string& reason) {
    return {Failure::bad_input, Fault{.file = "", .place = place, .reason = reason}};
}

glm::ivec2 parse_size(const std::string& text) {
    static const std::regex pattern(R"((\d{1,5})x(\d{1,5}))");
    std::smatch match;
    if (!std::regex_match(text, match, pattern))
        throw usage("--size", "\"" + text + "\" is not WIDTHxHEIGHT in pixels, such as 1280x1024");
    const glm::ivec2 size(std::stoi(match[1]), std::stoi(match[2]));
    if (size.x < 1 || size.y < 1 || size.x > 16384 || size.y > 16384)
        throw usage("--size", "\"" + text + "\" is outside 1x1 to 16384x16384");
    return size;
}

Overlay parse_overlay(const std::string& text) {
    constexpr std::pair<const char*, Overlay> names[] = {
        {"none", Overlay::none}, {"vessels", Overlay::vessels}, {"fat", Overlay::fat}, {"bleed", Overlay::bleed}};
    for (const auto& [name, overlay] : names)
        if (text == name) return overlay;
    throw usage("--overlay", "\"" + text + "\" is none of vessels, fat, bleed, none");
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
        throw usage("--to", std::to_string(to) + " s is not after --from " + std::to_string(o.from) + " s");
    const double count = std::ceil((to - o.from) * o.fps - 1e-9);
    if (count > 1e6) throw usage("--to", "more than a million frames");
    std::vector<double> times;
    for (int i = 0; i < static_cast<int>(count); ++i) times.push_back(o.from + i / o.fps);
    return times;
}

void check_output(const Options& o) {
    const bool still = o.output.ends_with(".png") && o.output.find('%') == std::string::npos;
    if (still && o.has_span)
        throw usage("-o", "\"" + o.output + "\" is one picture; with --from and --to name a video or out_%04d.png");
    if (!still && o.has_at) throw usage("-o", "\"" + o.output + "\" is not one picture; --at makes one: name a .png");
    if (!still && !is_sequence_name(o.output) && !is_video_name(o.output))
        throw usage("-o", "\"" + o.output + "\" is none of out.png, out_%04d.png, out.mp4 (.mov, .mkv, .avi)");
}

/// Before the work, not after it.
void check_folder(const std::filesystem::path& output) {
    const std::filesystem::path folder = output.has_parent_path() ? output.parent_path() : ".";
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
        throw Error(Failure::runtime, Fault{.file = output.string(), .place = "", .reason = "its folder is missing"});
}

/// What the user should know of the scene and would not see in the picture.
void print_warnings(const Preview& preview, const Scene& scene, const Options& o) {
    for (const std::string& warning : report(preview.organ()).warnings)
        std::cerr << "lapfx: warning: " << warning << '\n';
    if (o.has_at && o.at > scene.duration)
        std::cerr << "lapfx: warning: --at " << o.at << " s is after the scene's end at " << scene.duration << " s\n";
}

void render_frames(Preview& preview, const Options& o, const std::vector<double>& times, glm::ivec2 size) {
    Progress progress("rendering", static_cast<int>(times.size()));
    std::optional<VideoFile> video;
    if (is_video_name(o.output)) video.emplace(o.output, o.fps, cv::Size(size.x, size.y));
    for (std::size_t i = 0; i < times.size(); ++i) {
        const Image image = preview.image(times[i], size);
        progress.step();
        if (video)
            video->add(image);
        else
            write_png(is_sequence_name(o.output) ? sequence_name(o.output, static_cast<int>(i)) : o.output, image);
    }
    if (video) video->finish();
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
    const Scene scene = load_scene(o.scene);
    const Preset preset = preset_for(scene, o.preset, o.settings);
    const std::vector<double> times = frame_times(o, scene);
    const Context context = Context::create(backend);
    Preview preview(scene, preset, {.clip_folders = clip_folders(), .wait_for_clips = true, .overlay = overlay});
    print_warnings(preview, scene, o);
    render_frames(preview, o, times, size);
}

}  // namespace

void add_render(CLI::App& app) {
    auto o = std::make_shared<Options>();
    const CLI::Validator finite(
        [](const std::string& text) {
            double value = 0.0;  // CLI::Range lets "nan" through, since no comparison with it holds
            return CLI::detail::lexical_cast(text, value) && std::isfinite(value) ? ""
                                                                                  : "\"" + text + "\" is no number";
        },
        "NUMBER");
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
