// lapfx render: a scene as a picture, a sequence of pictures or a video.
#include <optional>
#include <utility>

#include "commands/beside.h"
#include "commands/command.h"
#include "commands/options.h"
#include "commands/progress.h"
#include "commands/session.h"
#include "commands/shown_scene.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/formats.h"
#include "output/render_job.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::string scene, preset, output, beside, amounts, layers, size = "1280x1024", backend = "auto", overlay = "none";
    std::string codec = "h264", quality = "good";
    std::vector<std::string> settings;
    double fps = 25.0, from = 0.0, to = -1.0, at = 0.0;
    bool has_at = false, has_span = false, has_codec = false, has_quality = false;
};

/// "none|vessels|...": the keys of a table.
std::string keys_of(const auto& rows, const std::string& separator) {
    std::string keys;
    for (const auto& row : rows) keys += (keys.empty() ? "" : separator) + std::string(row.key);
    return keys;
}

/// "False colour over the tissue. none: nothing; vessels: density of vessels, blue; ..."
std::string help_of(std::string text, const auto& rows) {
    const char* separator = ". ";
    for (const auto& row : rows)
        text += std::exchange(separator, "; ") + std::string(row.key) + ": " + std::string(row.help);
    return text;
}

Overlay parse_overlay(const std::string& text) {
    for (const OverlayRow& row : overlays)
        if (text == row.key) return row.overlay;
    throw wrong_option("--overlay", "\"" + text + "\" is not one of " + keys_of(overlays, ", "));
}

template <typename Value>
Value keyed(const char* option, const std::string& text, std::optional<Value> found, const auto& rows) {
    if (!found) throw wrong_option(option, "\"" + text + "\" is not one of " + keys_of(rows, ", "));
    return *found;
}

/// --codec and --quality; both are of a video.
void parse_compression(const Options& o, output::RenderOptions& options) {
    options.codec = keyed("--codec", o.codec, output::codec_keyed(o.codec), output::codec_rows());
    options.quality = keyed("--quality", o.quality, output::quality_keyed(o.quality), output::quality_rows());
    const auto kind = output::kind_named(o.output);
    if ((o.has_codec || o.has_quality) && kind && kind != output::OutputKind::video)
        throw wrong_option(o.has_codec ? "--codec" : "--quality", "is of a video; \"" + o.output + "\" is none");
    if (o.has_quality && output::row_of(options.codec).lossless)
        throw wrong_option("--quality", "\"" + o.codec + "\" is lossless and has none");
}

output::RenderOptions render_options(const Options& o) {
    output::RenderOptions options{.size = parse_size(o.size),
                                  .fps = o.fps,
                                  .from = o.from,
                                  .overlay = parse_overlay(o.overlay),
                                  .output = o.output,
                                  .amounts = o.amounts,
                                  .layers = o.layers,
                                  .clip_folders = clip_folders()};
    parse_compression(o, options);
    // A single picture without --at is that of the start.
    if (o.has_at || (!o.has_span && output::kind_named(o.output) == output::OutputKind::picture)) options.at = o.at;
    if (o.to >= 0.0) options.to = o.to;
    return options;
}

void require_sound(const output::RenderOptions& options, double duration) {
    if (std::vector<Fault> faults = check(options, duration); !faults.empty())
        throw Error(Failure::bad_input, std::move(faults));
}

void run(const Options& o) {
    const Backend backend = parse_backend(o.backend);
    output::RenderOptions options = render_options(o);
    require_sound(options, o.from + 1.0);  // before anything is loaded, and again with the length of the scene
    check_output("-o", o.output);
    check_output("--amounts", o.amounts);
    for (const std::filesystem::path& file : output::LayerFiles::names(o.layers)) claim_output("--layers", file);
    const std::vector<std::string> chosen = o.preset.empty() ? std::vector<std::string>() : std::vector{o.preset};
    const ShownScene shown = open_shown(o.scene, chosen, o.settings);
    const Scene& scene = shown.scene;
    const Preset& preset = shown.presets.front();
    require_sound(options, scene.duration);
    const Context context = Context::create(backend);
    output::Loaded loaded{.organ = nullptr, .clips = shown.clips};
    std::unique_ptr<output::FramePage> page;
    if (!o.beside.empty()) {
        loaded.organ = prepare_organ(scene, preset.vessels);
        page = beside_page(shown, o.scene, o.beside, options.size, loaded.organ);
    }
    Progress progress("rendering", 0);  // before the job, which begins its file
    output::RenderJob job(scene, preset, std::move(options), loaded, std::move(page));
    print_warnings(job.preview());
    print_plate_note(scene, job.preview());
    print_smoke_notes(scene, preset);
    print_touch_notes(scene, job.preview());
    if (o.has_at) warn_after_end(scene, o.at);
    progress.expect(job.frames());
    for (int told = 0; !job.done();) {
        job.step();
        for (; told < job.drawn(); ++told) progress.step();
    }
    print_clip_warnings(job.preview());
}

}  // namespace

Verb render_verb() {
    const auto o = std::make_shared<Options>();
    Verb verb{.name = "render",
              .help = "Render a scene to a PNG, a PNG sequence or a video, without a display",
              .run = [o] { run(*o); }};
    verb.argument("SCENE", "The scene (.scene.json)", &o->scene, {.required = true});
    verb.option("--preset", "FILE.json", "This preset instead of the one that the scene names", &o->preset);
    verb.option("--set", "KEY=VALUE", "Change one parameter, such as bleeding.speed=8; may be repeated", &o->settings,
                {.one_each = true});
    verb.option("--size", "WxH", "Size in pixels", &o->size, {.shows_default = true});
    verb.option("--fps", "NUMBER", "Frames per second of a sequence or video, 0.1 to 1000", &o->fps,
                {.shows_default = true, .range = Range{0.1, 1000.0}});
    verb.option("--from", "SECONDS", "Time of the first frame; default: 0", &o->from,
                {.range = Range{0.0, 86400.0}, .given = &o->has_span});
    verb.option("--to", "SECONDS", "Time at which it ends; default: the end of the scene", &o->to,
                {.range = Range{0.0, 86400.0}, .given = &o->has_span});
    verb.option("--at", "SECONDS", "Time of a single picture, else --from; not with --from and --to", &o->at,
                {.range = Range{0.0, 86400.0}, .excludes = {"--from", "--to"}, .given = &o->has_at});
    verb.option("--backend", "egl|osmesa|auto", "The OpenGL that draws; auto is EGL, else OSMesa", &o->backend,
                {.shows_default = true});
    verb.option("--overlay", keys_of(overlays, "|"), help_of("False colour over the tissue", overlays), &o->overlay,
                {.shows_default = true});
    verb.option("--codec", keys_of(output::codec_rows(), "|"),
                help_of("How a video is compressed", output::codec_rows()), &o->codec,
                {.shows_default = true, .given = &o->has_codec});
    verb.option("--quality", keys_of(output::quality_rows(), "|"),
                help_of("Quality of a video", output::quality_rows()), &o->quality,
                {.shows_default = true, .given = &o->has_quality});
    verb.option("--beside", "VIDEO",
                "Put this surgery video (or frame_%04d.png) beside each picture, and below both how much blood and "
                "veil they show over time; the scene's own reference lies as the scene has it",
                &o->beside);
    verb.option("--amounts", "FILE.csv",
                "Write the amounts of each frame (blood mm2 and mm3, wounds, haze, burnt mm2, emission) as CSV",
                &o->amounts);
    verb.option("--layers", "DIR",
                "Write what is in each frame, exactly, into this folder: amounts.csv with the columns of lapfx "
                "measure (blood and veil as shares of the view), and pictures of view, blood and veil",
                &o->layers);
    verb.option("-o,--output", "FILE", "out.png, out_%04d.png, or a video: " + listed(Content::video, " or ", true),
                &o->output, {.required = true});
    verb.footer =
        "Examples:\n"
        "  lapfx render samples/lagb.scene.json --at 6 --set bleeding.speed=8 -o out.png\n"
        "  lapfx render samples/lagb.scene.json --at 0 --overlay vessels -o vessels.png\n"
        "  lapfx render samples/lagb.scene.json --to 1 --fps 10 --size 320x256 --amounts amounts.csv -o out.mp4\n"
        "  lapfx render samples/lagb.scene.json --to 1 --fps 10 --size 320x256 --codec ffv1 -o exact.mkv\n"
        "  lapfx render samples/lagb.scene.json --at 6 --size 320x256 --beside samples/reference/operation.mp4 -o "
        "both.png";
    return verb;
}

}  // namespace lapfx::commands
