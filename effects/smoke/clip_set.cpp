#include "smoke/clip_set.h"

#include <map>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "gl/objects.h"
#include "lapfx/error.h"

namespace lapfx::smoke {

std::filesystem::path find_clip(const std::string& file, const std::filesystem::path& preset_folder,
                                std::span<const std::filesystem::path> search_path);
cv::VideoCapture open_clip(const std::filesystem::path& path);

namespace {
struct Frames {
    ClipInfo info;
    std::vector<cv::Mat> all;
    PictureFormat format;
};
struct Head {
    gl::Texture texture, chroma;
    int index = -1;
};
struct Clip {
    std::shared_ptr<Frames> frames;
    Head heads[2];
};
ColorMatrix matrix601() {
    ColorMatrix m;
    m.matrix = glm::transpose(
        glm::mat3(1.164384f, 0.0f, 1.596027f, 1.164384f, -0.391762f, -0.812968f, 1.164384f, 2.017232f, 0.0f));
    m.offset = {16.0f, 128.0f, 128.0f};
    return m;
}
const ColorMatrix bt601 = matrix601();
}  // namespace

struct ClipSet::State {
    StreamingOptions options;
    std::vector<Clip> clips;
    std::map<std::filesystem::path, std::weak_ptr<Frames>> known;
};

ClipSet::ClipSet(const StreamingOptions& options) : state_(std::make_unique<State>()) {
    state_->options = options;
}
ClipSet::~ClipSet() = default;

void ClipSet::set(std::span<const SmokeClip> clips, const std::filesystem::path& preset_folder,
                  std::span<const std::filesystem::path> search_path) {
    const bool planar = state_->options.scheme == Scheme::resident || state_->options.scheme == Scheme::buffered_planar;
    std::vector<Clip> made;
    for (const SmokeClip& clip : clips) {
        const auto path = find_clip(clip.file, preset_folder, search_path);
        auto frames = state_->known[path].lock();
        if (!frames) {
            frames = std::make_shared<Frames>();
            cv::VideoCapture capture = open_clip(path);
            cv::Mat m;
            const double fps = capture.get(cv::CAP_PROP_FPS);
            while (capture.read(m)) {
                frames->info.times.push_back(static_cast<double>(frames->all.size()) / fps);
                if (planar) {
                    cv::Mat i420;
                    cv::cvtColor(m, i420, cv::COLOR_BGR2YUV_I420);
                    frames->all.push_back(i420);
                } else {
                    frames->all.push_back(m.clone());
                }
                frames->info.size = {m.cols, m.rows};
            }
            frames->info.duration = static_cast<double>(frames->all.size()) / fps;
            frames->format = {.size = frames->info.size, .layout = planar ? Layout::planar : Layout::rgb};
            state_->known[path] = frames;
        }
        Clip c;
        c.frames = frames;
        made.push_back(std::move(c));
    }
    state_->clips = std::move(made);
}
std::size_t ClipSet::size() const {
    return state_->clips.size();
}
const ClipInfo& ClipSet::info(std::size_t clip) const {
    return state_->clips[clip].frames->info;
}
ClipFrame ClipSet::frame(std::size_t clip, int head, int index, Policy) noexcept {
    Clip& c = state_->clips[clip];
    Head& h = c.heads[head];
    const PictureFormat& f = c.frames->format;
    const bool planar = f.layout == Layout::planar;
    if (h.texture.name() == 0) {
        h.texture = gl::Texture({.size = f.size, .format = static_cast<GLenum>(planar ? GL_R8 : GL_RGB8), .layers = 2});
        if (planar) h.chroma = gl::Texture({.size = f.chroma_size(), .format = GL_RG8, .layers = 2});
    }
    if (h.index != index) {
        const cv::Mat& m = c.frames->all[static_cast<std::size_t>(index)];
        if (planar) {
            h.texture.upload(GL_RED, m.data, 1);
            const auto area = static_cast<std::size_t>(f.size.x) * static_cast<std::size_t>(f.size.y);
            const std::size_t quarter = area / 4;
            static std::vector<std::uint8_t> both;
            both.resize(quarter * 2);
            for (std::size_t i = 0; i < quarter; ++i) {
                both[2 * i] = m.data[area + i];
                both[2 * i + 1] = m.data[area + quarter + i];
            }
            h.chroma.upload(GL_RG, both.data(), 1);
        } else {
            h.texture.upload(GL_BGR, m.data, 1);
        }
        h.index = index;
    }
    return {.format = f,
            .color = h.texture.name(),
            .chroma = planar ? h.chroma.name() : 0,
            .layer = 1,
            .matrix = planar ? &bt601 : nullptr};
}
void ClipSet::end_cycle() noexcept {}
std::vector<ClipStatus> ClipSet::status() const {
    return {};
}
StreamingTimes ClipSet::times() const noexcept {
    return {};
}

}  // namespace lapfx::smoke
