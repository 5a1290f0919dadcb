#include "media/clip_player.h"

#include <algorithm>

#include "media/playhead.h"
#include "media/schemes.h"
#include "work/stopwatch.h"

namespace lapfx::media {

namespace {

/// Most frames that a playing clip advances by in one cycle; more is a jump.
constexpr int most_played_steps = 16;

/// To send one frame.
constexpr int most_tries = 4;

/// Maps a buffer's memory; a buffer without memory is dropped.
std::span<std::uint8_t> map(gl::PixelBuffer& buffer) {
    const std::span<std::uint8_t> memory = buffer.map();
    if (memory.empty()) buffer = gl::PixelBuffer();
    return memory;
}

/// Makes buffers of one picture each, and maps their memory.
std::vector<std::span<std::uint8_t>> make_memory(std::vector<gl::PixelBuffer>& buffers, std::size_t count,
                                                 std::size_t bytes) {
    std::vector<std::span<std::uint8_t>> memory;
    for (std::size_t i = 0; i < count; ++i) memory.push_back(map(buffers.emplace_back(bytes)));
    return memory;
}

}  // namespace

ClipFile::ClipFile(const std::filesystem::path& where, const FileStamp& seen, const Decoder& decoder)
    : path(where), stamp(seen), info(decoder.info()), format(decoder.format()), store(format, info.frame_count()) {}

std::size_t head_memory(const PictureFormat& format, Scheme scheme, int buffers) {
    return static_cast<std::size_t>(buffers + ClipStream::spare_slots) * format.bytes() +
           SentFrames::memory(format, scheme);
}

Loop played_frames(const ClipInfo& clip, const SmokeClip& settings) {
    const Loop main = main_loop(clip, settings), fading = fading_loop(clip, settings);
    return {main.first, settings.crossfade > 0.0 ? std::max(main.last, fading.last) : main.last};
}

ClipPlayer::ClipPlayer(DecodePool& pool, std::shared_ptr<ClipFile> file, Decoder decoder, const SmokeClip& settings,
                       Scheme scheme, int buffers)
    : pool_(pool), file_(std::move(file)), scheme_(scheme) {
    heads_[0].loop = main_loop(file_->info, settings);
    heads_[1].loop = fading_loop(file_->info, settings);
    const Layout layout = file_->format.layout;
    for (Head& head : heads_) {
        if (&head == &heads_[1]) {
            if (settings.crossfade <= 0.0) break;
            decoder = Decoder(file_->path, layout, file_->info);
        }
        std::vector<std::span<std::uint8_t>> memory;
        if (row_of(scheme).buffers) {
            memory = make_memory(head.memory, static_cast<std::size_t>(buffers + ClipStream::spare_slots),
                                 file_->format.bytes());
            head.on_gpu.resize(static_cast<std::size_t>(file_->info.frame_count()));
        }
        head.stream = std::make_unique<ClipStream>(pool, std::move(decoder), head.loop, buffers,
                                                   row_of(scheme).stays ? &file_->store.present()
                                                   : memory.empty()     ? nullptr
                                                                        : &head.on_gpu,
                                                   memory);
        head.sent = SentFrames(file_->format, scheme);
    }
}

bool ClipPlayer::stays() const {
    return row_of(scheme_).stays;
}

void ClipPlayer::set_buffers(int buffers) noexcept {
    for (Head& head : heads_) {
        if (!head.stream) continue;
        give_memory(head, buffers);  // before it decodes to its own memory
        head.stream->set_buffers(buffers);
        for (int slot; (slot = head.stream->give_back()) >= 0;)
            head.memory[static_cast<std::size_t>(slot)] = gl::PixelBuffer();
    }
}

/// Buffering: allocates buffers again that were freed, if more are needed.
void ClipPlayer::give_memory(Head& head, int buffers) noexcept {
    const auto made = std::count_if(head.memory.begin(), head.memory.end(), [](const auto& m) { return m.made(); });
    const std::size_t wanted =
        std::min(static_cast<std::size_t>(buffers + ClipStream::spare_slots), head.memory.size());
    for (auto i = static_cast<std::size_t>(made); i < wanted; ++i) {
        gl::PixelBuffer buffer(file_->format.bytes());
        const std::span<std::uint8_t> memory = map(buffer);
        const int slot = memory.empty() ? -1 : head.stream->give(memory);
        if (slot < 0) return;
        head.memory[static_cast<std::size_t>(slot)] = std::move(buffer);
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

void ClipPlayer::Head::ask(int index, Policy how) {
    int steps = 0;
    for (int at = asked; asked >= 0 && at != index && steps <= most_played_steps; ++steps) at = loop.after(at);
    moves = {steps <= most_played_steps ? steps : -1, moves[0], moves[1]};
    asked = index;
    policy = how;
    now = true;
}

/// Expected frames from this cycle to the next: one, unless the clip has advanced by more for some time.
int ClipPlayer::Head::step() const {
    return moves[0] > 1 && moves[0] == moves[1] && moves[0] == moves[2] ? moves[0] : 1;
}

ClipFrame ClipPlayer::frame(int head, int index, Policy policy, StreamingTimes& times) noexcept {
    Head& place = heads_[static_cast<std::size_t>(head)];
    // A clip that will stay on the GPU needs all of its frames, and pipeline sends no frame ahead that could be shown
    // for two cycles.
    if (policy == Policy::skip && !row_of(scheme_).buffers) policy = Policy::latest;
    place.ask(index, policy);
    return stays() ? resident_frame(place, index, policy, times) : streamed_frame(place, index, policy, times);
}

ClipFrame ClipPlayer::resident_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept {
    FrameStore& store = file_->store;
    int shown = index;
    if (!store.has(index)) {
        head.rests = false;
        const ClipStream::LentFrame decoded = head.stream->frame(index, policy, times.wait);
        shown = decoded.bytes.empty() ? -1 : decoded.index;
        if (shown >= 0) keep(decoded, times);
        if (shown != index) ++misses_;
    } else if (!head.rests) {
        head.stream->aim(index);
    }
    if (shown >= 0) head.shown = shown;
    return shown_of(head);
}

ClipFrame ClipPlayer::shown(int head) const noexcept {
    return shown_of(heads_[static_cast<std::size_t>(head)]);
}

ClipFrame ClipPlayer::shown_of(const Head& head) const noexcept {
    if (!stays()) return head.sent.frame(file_->info.color);
    // The frame that was shown last may have been freed since.
    if (head.shown < 0 || !file_->store.has(head.shown)) return {};
    return file_->store.frame(head.shown, file_->info.color);
}

void ClipPlayer::keep(const ClipStream::LentFrame& decoded, StreamingTimes& times) noexcept {
    {
        const work::Stopwatch watch(times.upload);
        times.uploaded_bytes += file_->store.upload(decoded.index, decoded.bytes);
    }
    ++times.uploaded;
    {
        const std::lock_guard lock(pool_.mutex());
        file_->store.mark(decoded.index);
    }
    pool_.wake();
}

/// RenderSmoke of table 1, before it draws: a frame that has been sent is neither waited for nor sent again.
ClipFrame ClipPlayer::streamed_frame(Head& head, int index, Policy policy, StreamingTimes& times) noexcept {
    if (head.sent.holds(index)) {
        head.sent.show(index);
    } else if (policy == Policy::skip && head.late && head.moves[0] >= 0 && head.sent.shown() >= 0) {
        head.sent.show_newest();  // this one is skipped
    } else {
        // The driver may lose what was decoded to its memory; Policy::wait then decodes it again.
        for (int tries = policy == Policy::wait ? most_tries : 1; tries > 0 && !head.sent.holds(index); --tries) {
            const ClipStream::LentFrame decoded = head.stream->frame(index, policy, times.wait);
            send(head, decoded, {}, times);
            head.sent.show(decoded.index);
        }
        head.late = head.sent.shown() != index;
    }
    if (head.sent.shown() != index) ++misses_;
    return shown_of(head);
}

/// With buffering the GPU reads the driver's memory that the frame was decoded to, and fresh memory replaces it. The
/// frame is then on the GPU and need not be decoded again until another frame has replaced it.
void ClipPlayer::send(Head& head, const ClipStream::LentFrame& decoded, std::span<const int> needed,
                      StreamingTimes& times) noexcept {
    if (decoded.bytes.empty() || head.sent.holds(decoded.index)) return;
    const work::Stopwatch watch(times.upload);
    const auto slot = static_cast<std::size_t>(decoded.slot);
    gl::PixelBuffer* from = slot < head.memory.size() && head.memory[slot].made() ? &head.memory[slot] : nullptr;
    const std::size_t bytes = head.sent.send(decoded.index, decoded.bytes, from, needed);
    times.uploaded_bytes += bytes;
    times.uploaded += bytes > 0 ? 1 : 0;
    if (!head.on_gpu.empty()) {
        const std::lock_guard lock(pool_.mutex());
        std::fill(head.on_gpu.begin(), head.on_gpu.end(), std::uint8_t{0});
        head.sent.mark(head.on_gpu);
    }
    if (from != nullptr) head.stream->take(decoded.slot, map(*from));
}

/// FrameCoalescing of table 1: two frames are sent in one cycle and none in the next, after the drawing and without
/// waiting for them. `turn`: this is the cycle in which they are sent. That makes cycles shorter, not their mean: as
/// the paper has it, buffering alone "does not reduce the time spent in CPU-GPU data transfer". What halves it in table
/// 2 (1.55 to 0.78 ms with one clip, 32.4 to 16.2 with 15, while retrieving and shading take as long as before) is that
/// "consecutive video frames are skipped": skip_one().
void ClipPlayer::coalesce(Head& head, bool turn, StreamingTimes& times) noexcept {
    const int step = head.step();
    Ahead ahead;
    for (std::size_t i = 0; i < ahead.size(); ++i)
        ahead[i] = head.loop.after(head.asked, static_cast<int>(i + 1) * step);
    const auto there = [&](int index) { return head.sent.holds(index) || !head.stream->peek(index).bytes.empty(); };
    if (head.policy == Policy::skip) {
        if (turn) head.late = head.outruns_the_display() || !there(ahead[0]) || !there(ahead[1]);
        if (head.late) {
            if (turn) skip_one(head, ahead, times);
            return;
        }
    }
    // The clip is shown in slow motion: the stream continues with the next frame.
    if (head.policy != Policy::skip && head.sent.shown() != head.asked) return;
    if (turn && !head.sent.holds(ahead[1]))
        send_ahead(head, ahead, 2, times);
    else if (!head.sent.holds(ahead[0]))
        send_ahead(head, ahead, 1, times);
    const auto next = std::find_if(ahead.begin(), ahead.end(), [&](int index) { return !head.sent.holds(index); });
    head.stream->aim(next != ahead.end() ? *next : head.loop.after(ahead.back(), step), step);
}

/// A late clip sends one frame instead of two, and shows it in this cycle and the next.
void ClipPlayer::skip_one(Head& head, const Ahead& ahead, StreamingTimes& times) noexcept {
    if (!head.sent.holds(ahead[0])) send(head, head.stream->frame(ahead[0], Policy::skip, times.wait), {}, times);
    head.stream->aim(ahead[2], head.step());
}

/// Sends up to `most` of the next frames that are missing, if they are decoded.
void ClipPlayer::send_ahead(Head& head, const Ahead& ahead, int most, StreamingTimes& times) noexcept {
    for (const int index : ahead) {
        if (most == 0) return;
        if (head.sent.holds(index)) continue;
        const ClipStream::LentFrame decoded = head.stream->peek(index);
        if (decoded.bytes.empty()) return;
        send(head, decoded, ahead, times);
        --most;
    }
}

void ClipPlayer::end_cycle(std::uint64_t cycle, StreamingTimes& times) noexcept {
    for (Head& head : heads_) {
        ++cycle;
        if (!head.stream || head.rests) continue;
        if (stays()) {
            // Frames that are decoded ahead are sent before they are due, so that a clip that plays fast or jumps also
            // becomes complete. It is one frame per cycle, so that no cycle takes long.
            if (const ClipStream::LentFrame decoded = head.stream->peek_any(); !decoded.bytes.empty())
                keep(decoded, times);
            head.rests = head.stream->rest();
        } else if (head.now) {
            // Figure 3: once a frame has been sent, the signal to retrieve the next one is given.
            if (row_of(scheme_).buffers)
                coalesce(head, cycle % 2 != 0, times);
            else if (head.sent.shown() == head.asked)
                head.stream->aim(head.loop.after(head.asked, head.step()));
            head.now = false;
        }
    }
}

std::size_t ClipPlayer::memory() const noexcept {
    std::size_t bytes = 0;
    for (const Head& head : heads_)
        if (head.stream) bytes += head.stream->memory() + SentFrames::memory(file_->format, scheme_);
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

}  // namespace lapfx::media
