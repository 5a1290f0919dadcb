#include "smoke/clip_player.h"

#include <algorithm>
#include <chrono>

#include "smoke/playhead.h"

namespace lapfx::smoke {

namespace {

/// Adds the time that it lives to `sum`, s.
class Stopwatch {
  public:
    explicit Stopwatch(double& sum) : sum_(sum), start_(std::chrono::steady_clock::now()) {}
    ~Stopwatch() { sum_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

  private:
    double& sum_;
    std::chrono::steady_clock::time_point start_;
};

/// Frames of a clip that are sent ahead: the paper's pipeline has one, its buffering scheme the current one and the next.
int sent_layers(Scheme scheme) {
    return scheme == Scheme::resident ? 0 : scheme == Scheme::pipeline ? 1 : 2;
}

}  // namespace

ClipFile::ClipFile(const std::filesystem::path& where, const FileStamp& seen, const Decoder& decoder)
    : path(where), stamp(seen), info(decoder.info()), format(decoder.format()), store(format, info.frame_count()) {}

std::size_t head_memory(const PictureFormat& format, Scheme scheme, int buffers) {
    return static_cast<std::size_t>(buffers + ClipStream::spare_slots + sent_layers(scheme)) * format.bytes();
}

Loop played_frames(const ClipInfo& clip, const SmokeClip& settings) {
    const Loop main = main_loop(clip, settings), fading = fading_loop(clip, settings);
    return {main.first, settings.crossfade > 0.0 ? std::max(main.last, fading.last) : main.last};
}

ClipPlayer::ClipPlayer(DecodePool& pool, std::shared_ptr<ClipFile> file, Decoder decoder, const SmokeClip& settings,
                       Scheme scheme, int buffers)
    : pool_(pool), file_(std::move(file)), scheme_(scheme) {
    const int layers = sent_layers(scheme);
    heads_[0].loop = main_loop(file_->info, settings);
    heads_[1].loop = fading_loop(file_->info, settings);
    const Layout layout = file_->format.layout;
    for (Head& head : heads_) {
        if (&head == &heads_[1]) {
            if (settings.crossfade <= 0.0) break;
            decoder = Decoder(file_->path, layout, file_->info);
        }
        head.stream = std::make_unique<ClipStream>(pool, std::move(decoder), head.loop, buffers,
                                                   scheme == Scheme::resident ? &file_->store.present() : nullptr);
        if (layers > 0) head.sent = FrameTextures(file_->format, layers);
    }
}

void ClipPlayer::set_buffers(int buffers) noexcept {
    for (Head& head : heads_)
        if (head.stream) head.stream->set_buffers(buffers);
}

void ClipPlayer::set_loops(const SmokeClip& settings) noexcept {
    heads_[0].loop = main_loop(file_->info, settings);
    heads_[1].loop = fading_loop(file_->info, settings);
    for (Head& head : heads_) {
        head.rests = false;
        if (head.stream) head.stream->set_loop(head.loop);
    }
}

ClipFrame ClipPlayer::frame(int head, int index, Policy policy, StreamingTimes& times) noexcept {
    Head& place = heads_[static_cast<std::size_t>(head)];
    place.asked = index;
    return scheme_ == Scheme::resident ? resident_frame(place, index, policy, times)
                                       : streamed_frame(place, index, policy, times);
}

ClipFrame ClipPlayer::resident_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept {
    FrameStore& store = file_->store;
    int shown = index;
    if (!store.has(index)) {
        head.rests = false;
        const ClipStream::Shown decoded = head.stream->frame(index, policy, times.wait);
        shown = decoded.index;
        if (decoded.picture != nullptr) keep(shown, *decoded.picture, times);
        if (shown != index) ++misses_;
    } else if (!head.rests) {
        head.stream->aim(index);
    }
    if (shown >= 0) head.shown = shown;
    // What was shown last may have been given back since.
    if (head.shown < 0 || !store.has(head.shown)) return {};
    return store.frame(head.shown, file_->info.color);
}

void ClipPlayer::keep(int index, const Picture& picture, StreamingTimes& times) noexcept {
    {
        const Stopwatch watch(times.upload);
        times.uploaded_bytes += file_->store.upload(index, picture);
    }
    ++times.uploaded;
    {
        const std::lock_guard lock(pool_.mutex());
        file_->store.mark(index);
    }
    pool_.wake();
}

ClipFrame ClipPlayer::streamed_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept {
    const auto layer_of = [&](int frame) {
        const auto found = std::find(head.holds.begin(), head.holds.end(), frame);
        return found == head.holds.end() ? -1 : static_cast<int>(found - head.holds.begin());
    };
    if (layer_of(index) >= 0) {
        head.shown = layer_of(index);
        head.stream->aim(index);  // lets the worker go on; the picture is here already
    } else {
        const ClipStream::Shown decoded = head.stream->frame(index, policy, times.wait);
        if (decoded.index != index) ++misses_;
        if (decoded.picture != nullptr && layer_of(decoded.index) < 0)
            send(head, 0, decoded.index, *decoded.picture, times);
        if (decoded.picture != nullptr) head.shown = layer_of(decoded.index);
        // Table 1's FrameCoalescing: two frames go in one cycle and none in the next. Not waited for.
        const int next = head.loop.after(index);
        if (scheme_ != Scheme::pipeline && decoded.index == index && next != index)
            if (const Picture* following = head.stream->peek(next)) send(head, 1, next, *following, times);
    }
    return head.shown < 0 ? ClipFrame{} : head.sent.frame(head.shown, file_->info.color);
}

void ClipPlayer::send(Head& head, int layer, int index, const Picture& picture, StreamingTimes& times) noexcept {
    const Stopwatch watch(times.upload);
    times.uploaded_bytes += head.sent.upload(layer, picture);
    ++times.uploaded;
    head.holds[static_cast<std::size_t>(layer)] = index;
}

void ClipPlayer::end_cycle(StreamingTimes& times) noexcept {
    for (Head& head : heads_) {
        if (!head.stream || head.rests) continue;
        if (scheme_ == Scheme::pipeline) {
            // Figure 3: once a frame has been sent, the signal to retrieve the next one is given.
            if (head.holds[0] >= 0 && head.holds[0] == head.asked) head.stream->aim(head.loop.after(head.asked));
        } else if (scheme_ == Scheme::resident) {
            // What has been decoded ahead goes to the GPU before it is due: a clip that plays fast or is jumped about in
            // becomes whole too. One frame a cycle, so that no frame takes long.
            if (const ClipStream::Shown decoded = head.stream->peek_any(); decoded.picture != nullptr)
                keep(decoded.index, *decoded.picture, times);
            head.rests = head.stream->rest();
        }
    }
}

std::size_t ClipPlayer::memory() const noexcept {
    std::size_t bytes = 0;
    for (const Head& head : heads_)
        if (head.stream)
            bytes += head.stream->memory() + static_cast<std::size_t>(sent_layers(scheme_)) * file_->format.bytes();
    return bytes;
}

ClipStream::Work ClipPlayer::work() const noexcept {
    ClipStream::Work sum;
    for (const Head& head : heads_) {
        if (!head.stream) continue;
        const ClipStream::Work work = head.stream->work();
        sum.decode += work.decode;
        sum.copy += work.copy;
        sum.decoded += work.decoded;
        sum.broken += work.broken;
    }
    return sum;
}

}  // namespace lapfx::smoke
