#include "lapfx/authoring/video.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "media/decoder.h"

namespace lapfx {

namespace {

constexpr int maximum_frames = 10'000'000;  // four days at 25 frames a second
constexpr int maximum_side = 8192;          // px, as everywhere

/// Enlarged to square pixels, so that no row or column of the file is lost.
glm::ivec2 with_square_pixels(glm::ivec2 size, double pixel_aspect) {
    const glm::dvec2 wide(pixel_aspect > 1 ? pixel_aspect : 1.0, pixel_aspect < 1 ? 1.0 / pixel_aspect : 1.0);
    const glm::ivec2 shown(glm::round(glm::dvec2(size) * wide));
    return glm::max(shown.x, shown.y) <= maximum_side ? shown : size;
}

std::uint8_t over_black(std::uint8_t value, std::uint8_t opacity) {
    return static_cast<std::uint8_t>((value * opacity + 127) / 255);
}

}  // namespace

struct VideoReader::State {
    State(const std::filesystem::path& path, const std::atomic<bool>* stop)
        : decoder(media::open_stoppable(path, media::Layout::rgb, maximum_frames, stop)) {
        const media::ClipInfo& clip = decoder.info();
        stored = with_square_pixels(clip.size, clip.pixel_aspect);
        if (stored != clip.size) decoder.scale_to(stored);
        info = {.size = clip.turn.transposed ? glm::ivec2(stored.y, stored.x) : stored,
                .frames = clip.frame_count(),
                .duration = clip.duration,
                .frames_per_second = clip.frame_count() / clip.duration,
                .codec = clip.codec,
                .warning = clip.warning};
    }

    void put(Image& into) const;

    media::Decoder decoder;
    VideoInfo info;
    glm::ivec2 stored{0};  ///< px, before it is turned
    media::Picture picture;
};

/// Rotates as the file asks for: takes source pixels in their order and puts each into its place.
void VideoReader::State::put(Image& into) const {
    const media::Turn turn = decoder.info().turn;
    into.width = info.size.x;
    into.height = info.size.y;
    into.pixels.resize(static_cast<std::size_t>(info.size.x) * static_cast<std::size_t>(info.size.y) * 4);
    const std::ptrdiff_t column = 4, row = std::ptrdiff_t{4} * info.size.x;
    std::ptrdiff_t along = turn.transposed ? row : column, down = turn.transposed ? column : row;
    std::uint8_t* to = into.pixels.data();
    if (turn.mirrored.x) to += along * (stored.x - 1), along = -along;
    if (turn.mirrored.y) to += down * (stored.y - 1), down = -down;
    const std::uint8_t* from = picture.bytes.data();
    const std::uint8_t* opacity = decoder.format().alpha ? from + decoder.format().color_bytes() : nullptr;
    for (int y = 0; y < stored.y; ++y, to += down) {
        std::uint8_t* pixel = to;
        for (int x = 0; x < stored.x; ++x, pixel += along, from += 3) {
            const std::uint8_t a = opacity != nullptr ? *opacity++ : 255;
            for (int c = 0; c < 3; ++c) pixel[c] = a == 255 ? from[c] : over_black(from[c], a);
            pixel[3] = 255;
        }
    }
}

VideoReader::VideoReader(const std::filesystem::path& path, const std::atomic<bool>* stop)
    : state_(std::make_unique<State>(path, stop)) {}
VideoReader::VideoReader(VideoReader&&) noexcept = default;
VideoReader& VideoReader::operator=(VideoReader&&) noexcept = default;
VideoReader::~VideoReader() = default;

const VideoInfo& VideoReader::info() const {
    return state_->info;
}

int VideoReader::frame_at(double time) const {
    return state_->decoder.info().frame_at(time);
}

double VideoReader::time_of(int frame) const {
    assert(frame >= 0 && frame < state_->info.frames);
    return state_->decoder.info().times[static_cast<std::size_t>(frame)];
}

bool VideoReader::read(int frame, Image& into, const std::atomic<bool>* stop) noexcept {
    assert(frame >= 0 && frame < state_->info.frames);
    const bool good = state_->decoder.read(frame, state_->picture, stop);
    if (!good && stop != nullptr && stop->load(std::memory_order_relaxed)) return false;
    if (state_->picture.bytes.size() != state_->decoder.format().bytes()) return false;  // no memory
    try {
        state_->put(into);
    } catch (const std::bad_alloc&) {
        return false;
    }
    return good;
}

}  // namespace lapfx
