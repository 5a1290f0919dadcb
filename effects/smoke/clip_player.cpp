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

ClipFile::ClipFile(const std::filesystem::path& where, const Decoder& decoder)
    : path(where), info(decoder.info()), format(decoder.format()), store(format, info.frame_count()) {
    std::error_code error;
    bytes = std::filesystem::file_size(where, error);
    written = std::filesystem::last_write_time(where, error);
}

std::size_t head_memory(const PictureFormat& format, Scheme scheme, int buffers) {
    return static_cast<std::size_t>(buffers + sent_layers(scheme)) * format.bytes();
}

std::size_t ClipPlayer::resident_memory(const ClipFile& file, const SmokeClip& settings) {
    const int last = std::max(main_loop(file.info, settings).last, fading_loop(file.info, settings).last);
    return FrameStore::memory_for(file.format, file.info.frame_count(), main_loop(file.info, settings).first, last);
}

ClipPlayer::ClipPlayer(DecodePool& pool, std::shared_ptr<ClipFile> file, Decoder decoder, const SmokeClip& settings,
                       Scheme scheme, int buffers)
    : pool_(pool), file_(std::move(file)), scheme_(scheme), buffers_(buffers) {
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
    return scheme_ == Scheme::resident ? resident_frame(place, index, policy, times)
                                       : streamed_frame(place, index, policy, times);
}

ClipFrame ClipPlayer::resident_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept {
    FrameStore& store = file_->store;
    if (!store.has(index)) {
        head.rests = false;
        if (const Picture* picture = head.stream->frame(index, policy, times.wait))
            keep(index, *picture, times);
        else
            ++misses_;
    } else if (!head.rests) {
        head.stream->aim(index);
    }
    if (store.has(index) || head.shown < 0) head.shown = index;
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
    const auto found = std::find(head.holds.begin(), head.holds.end(), index);
    if (found != head.holds.end()) {
        head.shown = static_cast<int>(found - head.holds.begin());
        head.stream->aim(index);  // lets the worker go on; the picture is here already
    } else if (const Picture* picture = head.stream->frame(index, policy, times.wait)) {
        send(head, 0, index, *picture, times);
        head.shown = 0;
        // Table 1's FrameCoalescing: two frames go in one cycle and none in the next. Not waited for.
        const int next = head.loop.after(index);
        if (scheme_ != Scheme::pipeline && next != index)
            if (const Picture* following = head.stream->peek(next)) send(head, 1, next, *following, times);
    } else {
        ++misses_;
    }
    return head.sent.frame(std::max(head.shown, 0), file_->info.color);
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
            if (head.holds[0] >= 0) head.stream->aim(head.loop.after(head.holds[0]));
        } else if (scheme_ == Scheme::resident) {
            // What has been decoded ahead goes to the GPU before it is due: a clip that plays fast or is jumped about in
            // becomes whole too. One frame a cycle, so that no frame takes long.
            int index = 0;
            if (const Picture* picture = head.stream->peek_any(index)) keep(index, *picture, times);
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
