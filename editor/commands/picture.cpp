// lapfx picture: a small picture of any file that the editor opens. File dialogs run it as a child process, so that a
// stranger's file cannot harm the editor.
#include <new>
#include <opencv2/imgproc.hpp>

#include "app/browser/thumbnail_maker.h"
#include "app/files/open.h"
#include "commands/command.h"
#include "commands/options.h"
#include "commands/session.h"
#include "lapfx/authoring/command_line.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/video.h"
#include "output/files.h"

namespace lapfx::commands {

namespace {

struct Options {
    std::string file, output, size = "360x288", backend = "auto";
};

constexpr double in_video = 0.4;  // share of its duration: smoke clips begin with nothing
constexpr double in_scene = 0.6;  // share of its duration, when blood and smoke are both visible

Error refused(const std::string& file, Failure failure, const std::string& reason) {
    return {failure, Fault{.file = file, .place = "", .reason = reason}};
}

/// Keeps its shape, no larger than `most`.
Image fitted(Image image, glm::ivec2 most) {
    const double scale =
        std::min({1.0, static_cast<double>(most.x) / image.width, static_cast<double>(most.y) / image.height});
    if (scale == 1.0) return image;
    Image small{.width = std::max(1, static_cast<int>(std::lround(image.width * scale))),
                .height = std::max(1, static_cast<int>(std::lround(image.height * scale))),
                .pixels = {},
                .name = ""};
    small.pixels.resize(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height) * 4);
    const cv::Mat from(image.height, image.width, CV_8UC4, image.pixels.data());
    cv::Mat to(small.height, small.width, CV_8UC4, small.pixels.data());
    cv::resize(from, to, to.size(), 0, 0, cv::INTER_AREA);
    return small;
}

Image picture_of_video(const std::string& file, glm::ivec2 size) {
    VideoReader video(file);
    Image image;
    const int frame = video.frame_at(in_video * video.info().duration);
    if (!video.read(frame, image) && (frame == 0 || !video.read(0, image)))
        throw refused(file, Failure::bad_input, "is a video of which no frame can be decoded");
    return fitted(std::move(image), size);
}

/// An organ from the front, a preset on the sample scene.
Image picture_of_scene(const std::string& file, app::FileKind kind, glm::ivec2 size, Backend backend) {
    app::Opened opened = kind == app::FileKind::preset ? app::open_sample(data_folder()) : app::Opened{};
    app::open_files(opened, {file});
    Scene& scene = opened.content.scene;
    if (kind == app::FileKind::organ) scene.camera.vignette = 0;  // nobody looks through an endoscope
    const Context context = Context::create(backend);
    Preview preview(scene, opened.content.preset, {.clip_folders = clip_folders(), .wait_for_clips = true});
    return preview.image(kind == app::FileKind::organ ? 0 : in_scene * scene.duration, size);
}

void run(const Options& o) {
    const glm::ivec2 size = parse_size(o.size);
    const Backend backend = parse_backend(o.backend);
    check_picture_name("-o", o.output);
    check_output("-o", o.output);
    app::ThumbnailMaker::limit_process(0);
    try {
        const app::FileKind kind = app::kind_of(o.file);
        output::write_png(o.output, kind == app::FileKind::video ? picture_of_video(o.file, size)
                                                                 : picture_of_scene(o.file, kind, size, backend));
    } catch (const std::bad_alloc&) {
        throw refused(o.file, Failure::runtime, "needs more than 4 GB of memory");
    }
}

}  // namespace

Verb picture_verb() {
    const auto o = std::make_shared<Options>();
    Verb verb{.name = "picture",
              .help = "Make a small picture of any file that the editor opens",
              .footer = "Example:\n  lapfx picture samples/lagb.glb -o organ.png",
              .run = [o] { run(*o); }};
    verb.argument("FILE", "A video (a frame of it), an image, an organ, a scene or a preset", &o->file,
                  {.required = true});
    verb.option("--size", "WxH", "Size in pixels; a video or an image keeps its shape and fits into that", &o->size,
                {.shows_default = true});
    verb.option("--backend", "egl|osmesa|auto", "The OpenGL that draws; auto is EGL, else OSMesa", &o->backend,
                {.shows_default = true});
    verb.option("-o,--output", "FILE", "The picture: out.png", &o->output, {.required = true});
    return verb;
}

}  // namespace lapfx::commands
