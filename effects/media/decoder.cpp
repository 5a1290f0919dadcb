#include "media/decoder.h"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <utility>

#include "media/clip_index.h"
#include "media/color_tags.h"
#include "media/deinterlacer.h"
#include "media/file_stamp.h"
#include "media/frame_converter.h"
#include "media/frame_reader.h"
#include "work/stopwatch.h"

extern "C" {
#include <libavutil/display.h>
#include <libavutil/pixdesc.h>
}

namespace lapfx::media {

namespace fs = std::filesystem;

namespace {

constexpr int maximum_side = 8192;  // pixels: 8K
constexpr int a_few = 4;            // frames up to which decoding is preferred to seeking
constexpr int first_frames = 4;     // that are looked at for fields

/// A frame that was decoded, and its number; -1 when there is none.
struct Decoded {
    libav::Frame frame{libav::made(av_frame_alloc())};
    int number = -1;

    void clear() {
        av_frame_unref(frame.get());
        number = -1;
    }
    void take(Decoded& other) {
        av_frame_unref(frame.get());
        av_frame_move_ref(frame.get(), other.frame.get());
        number = std::exchange(other.number, -1);
    }
};

/// The rotation that the file asks for: in each frame, or once for all of them.
const std::int32_t* display_matrix(const AVFrame& frame, const AVStream& video) {
    constexpr std::size_t bytes = 9 * sizeof(std::int32_t);
    const AVFrameSideData* own = av_frame_get_side_data(&frame, AV_FRAME_DATA_DISPLAYMATRIX);
    if (own != nullptr && own->size >= bytes) return reinterpret_cast<const std::int32_t*>(own->data);
    std::size_t size = 0;
    const std::uint8_t* data = av_stream_get_side_data(&video, AV_PKT_DATA_DISPLAYMATRIX, &size);
    return data != nullptr && size >= bytes ? reinterpret_cast<const std::int32_t*>(data) : nullptr;
}

/// The nearest quarter turn: (x, y) is shown at (m[0] x + m[3] y, m[1] x + m[4] y).
std::optional<Turn> turn_of(const AVFrame& frame, const AVStream& video) {
    const std::int32_t* m = display_matrix(frame, video);
    if (m == nullptr) return std::nullopt;
    const auto size = [](std::int32_t v) { return std::abs(static_cast<std::int64_t>(v)); };
    const bool transposed = size(m[1]) + size(m[3]) > size(m[0]) + size(m[4]);
    return Turn{.mirrored = {(transposed ? m[1] : m[0]) < 0, (transposed ? m[3] : m[4]) < 0}, .transposed = transposed};
}

/// The turn by EXIF's number.
Turn turn_of(int orientation) {
    constexpr int last = 8;
    constexpr Turn turns[last + 1] = {
        {},
        {},
        {.mirrored = {true, false}, .transposed = false},
        {.mirrored = {true, true}, .transposed = false},
        {.mirrored = {false, true}, .transposed = false},
        {.mirrored = {false, false}, .transposed = true},
        {.mirrored = {false, true}, .transposed = true},
        {.mirrored = {true, true}, .transposed = true},
        {.mirrored = {true, false}, .transposed = true},
    };
    return turns[std::clamp(orientation, 0, last)];
}

/// An implausible value counts as square.
double pixel_aspect_of(const AVFrame& frame, const AVStream& video) {
    constexpr double most = 10.0;
    for (const AVRational aspect :
         {video.sample_aspect_ratio, video.codecpar->sample_aspect_ratio, frame.sample_aspect_ratio}) {
        const double ratio = aspect.num > 0 && aspect.den > 0 ? av_q2d(aspect) : 0.0;
        if (ratio >= 1.0 / most && ratio <= most) return ratio;
    }
    return 1.0;
}

/// The order of fields that the container claims; a decoder says it of each frame.
bool claims_fields(const AVStream& video) {
    return video.codecpar->field_order > AV_FIELD_PROGRESSIVE;
}

/// Codecs whose videos may begin with progressive frames and go on with interlaced ones.
bool may_change_scan(AVCodecID codec) {
    return codec == AV_CODEC_ID_H264 || codec == AV_CODEC_ID_MPEG2VIDEO || codec == AV_CODEC_ID_MPEG4 ||
           codec == AV_CODEC_ID_VC1;
}

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

int ClipInfo::frame_at(double time) const {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    return std::max(0, static_cast<int>(after - times.begin()) - 1);
}

struct Decoder::State {
    State(const fs::path& clip, Layout wanted) : path(clip), stamp(stamp_of(clip)), layout(wanted) {}

    void look_through(int maximum_frames, const work::Stages& stages);
    void open_known(const ClipInfo& known);
    void describe(const AVFrame& frame, const ClipIndex& found);
    void describe_light(const AVFrame& frame);
    DecodableFrames count_decodable(const work::Stages& stages);
    bool begins_interlaced();
    bool brings_opacity();
    Step decode_to(int index, const std::atomic<bool>* stop);
    Step decode_image(int index, const std::atomic<bool>* stop);
    Step advance(int index, const std::atomic<bool>* stop);
    Step step(Decoded& into, const std::atomic<bool>* stop);
    Step jump(int index, const std::atomic<bool>* stop);
    Step jump_with_before(int index, const std::atomic<bool>* stop);
    std::ptrdiff_t points_up_to(int frame) const;
    bool reach(int index, const std::atomic<bool>* stop);
    const AVFrame& progressive();
    bool write(int index, std::span<std::uint8_t> into);
    void rest();
    void wake();

    const fs::path path;
    const FileStamp stamp;  ///< before it was opened
    const Layout layout;
    ClipInfo info;
    glm::ivec2 size{0};  ///< of pictures
    std::shared_ptr<const ClipIndex> index;
    std::unique_ptr<FrameReader> reader;  ///< none for a sequence of images
    std::unique_ptr<FrameConverter> converter;
    Deinterlacer deinterlacer;
    Decoded before;           ///< the good frame before `shown`, if the clip is interlaced
    Decoded shown;            ///< the last good frame up to the one that was read last
    Decoded ahead;            ///< the good frame after it, if it is already decoded
    Decoded next;             ///< scratch
    bool placed = true;       ///< the reader is directly behind `shown` and `ahead`
    bool from_start = false;  ///< the last jump found no seek point, so that all frames up to here were decoded
    bool ended = false, rests = false;
    std::vector<bool> failed;  ///< images of a sequence that could not be read: they are not tried again
    double decode_seconds = 0.0;
};

/// The next good frame of the file. Its number is unchanged unless there is one.
Step Decoder::State::step(Decoded& into, const std::atomic<bool>* stop) {
    return reader->next(*index, *into.frame, into.number, stop);
}

void Decoder::State::look_through(int maximum_frames, const work::Stages& stages) {
    const std::optional<ImageSequence> sequence = find_sequence(path, maximum_frames);
    auto found = std::make_shared<ClipIndex>();
    if (sequence) {
        *found = index_sequence(*sequence);
        reader = std::make_unique<FrameReader>(sequence->file(0));
    } else {
        reader = std::make_unique<FrameReader>(path);
        *found = index_clip(reader->file(), path, maximum_frames, stages);
        reader->restart();
    }
    index = found;
    ClipIndex one_image;
    one_image.times = {0.0};
    if (reader->next(sequence ? one_image : *index, *shown.frame, shown.number, nullptr) != Step::frame)
        throw bad_clip(path, "has no frame that can be decoded");
    found->color = color_of(*shown.frame);
    describe(*shown.frame, *found);
    if (sequence) reader.reset();
    info.alpha = has_alpha(shown.frame->format) && brings_opacity();
}

DecodableFrames Decoder::State::count_decodable(const work::Stages& stages) {
    const int frames = info.frame_count();
    DecodableFrames found;
    for (int at = 0; at < frames; ++at) {
        if (decode_to(at, nullptr) == Step::frame && shown.number == at) {
            ++found.count;
            found.end = at + 1 < frames ? info.times[static_cast<std::size_t>(at) + 1] : info.duration;
        }
        stages.reach(static_cast<double>(at + 1) / frames);
    }
    return found;
}

void Decoder::State::describe(const AVFrame& frame, const ClipIndex& found) {
    info.size = size = {frame.width, frame.height};
    if (frame.width < 1 || frame.height < 1) throw bad_clip(path, "contains no picture");
    if (frame.width > maximum_side || frame.height > maximum_side)
        throw bad_clip(path, "is " + std::to_string(frame.width) + "x" + std::to_string(frame.height) +
                                 " pixels; at most " + std::to_string(maximum_side) + " a side are allowed");
    info.codec = avcodec_get_name(reader->file().video().codecpar->codec_id);
    const char* format = av_get_pix_fmt_name(static_cast<AVPixelFormat>(frame.format));
    info.pixel_format = format == nullptr ? "unknown" : format;
    info.color = matrix_of(found.color);
    info.turn = turn_of(frame, reader->file().video()).value_or(turn_of(reader->file().orientation()));
    info.pixel_aspect = pixel_aspect_of(frame, reader->file().video());
    info.times = found.times;
    info.duration = found.duration;
    info.warning = found.warning;
    add_warning(info.warning, reader->warning());
    describe_light(frame);
    info.index = index;
}

/// Transfer, primaries and fields: what is done about them, and what is not.
void Decoder::State::describe_light(const AVFrame& frame) {
    add_warning(info.warning, color_warning(frame));
    const ColorTags tags = color_tags(frame);
    info.transfer = info.codec == "exr" ? "linear light, converted to sRGB" : transfer_words(tags);
    info.primaries = primaries_words(tags);
    info.interlaced = is_interlaced(frame) || claims_fields(reader->file().video()) || begins_interlaced();
    if (!info.interlaced) return;
    const bool can = Deinterlacer::can(frame.format);
    const char* order = !is_interlaced(frame)        ? " in places"
                        : frame.top_field_first != 0 ? ", top field first"
                                                     : ", bottom field first";
    info.scan = std::string("interlaced") + order + (can ? "; deinterlaced" : "; shown as it is");
    if (!can) add_warning(info.warning, "is interlaced, which is not undone in pixel format " + info.pixel_format);
}

/// Whether one of the frames after the first is: a recording of a broadcast may begin with progressive ones. Only a few
/// are looked at, for each of them costs a decode in every clip that is opened.
bool Decoder::State::begins_interlaced() {
    if (!may_change_scan(reader->file().video().codecpar->codec_id)) return false;
    bool found = false;
    for (int looked = 1; looked < first_frames && !found; ++looked) {
        if (step(next, nullptr) != Step::frame) break;
        found = is_interlaced(*next.frame);
    }
    next.clear();
    placed = false;
    return found;
}

/// Whether the clip uses the opacity of its pixel format, which GIFs and PNGs always have. Four frames show it.
bool Decoder::State::brings_opacity() {
    for (int quarter = 0; quarter < 4; ++quarter) {
        const int at = info.frame_count() * quarter / 4;
        if (decode_to(at, nullptr) == Step::frame && shown.number == at && !is_opaque(*shown.frame)) return true;
    }
    return false;
}

void Decoder::State::open_known(const ClipInfo& known) {
    info = known;
    size = known.size;
    index = known.index;
    if (!index->sequence) reader = std::make_unique<FrameReader>(path);
}

/// How many seek points are at `frame` or before it.
std::ptrdiff_t Decoder::State::points_up_to(int frame) const {
    const auto after = std::upper_bound(index->points.begin(), index->points.end(), frame,
                                        [](int f, const SeekPoint& point) { return f < point.frame; });
    return after - index->points.begin();
}

/// Goes to a frame up to `frame` where decoding can start and succeeds, the last one or one not far before it;
/// otherwise to the first frame, from where everything is decoded.
Step Decoder::State::jump(int frame, const std::atomic<bool>* stop) {
    for (Decoded* one : {&before, &shown, &ahead}) one->clear();
    placed = ended = from_start = false;
    // From a broken frame all frames up to the next good one are decoded. So of many broken ones in a row only a few
    // are tried, each twice as far away as the one before.
    std::ptrdiff_t left = points_up_to(frame);
    for (std::ptrdiff_t back = 1; left > 0; left -= back, back *= 2) {
        const SeekPoint& point = index->points[static_cast<std::size_t>(left - 1)];
        if (!reader->seek(point)) continue;
        const Step result = step(next, stop);
        if (result == Step::stopped) return result;
        // If that frame itself is broken, later frames depend on earlier ones.
        if (result == Step::frame && next.number == point.frame) {
            shown.take(next);
            placed = true;
            return Step::frame;
        }
    }
    next.clear();
    reader->restart();
    placed = from_start = true;
    return Step::frame;
}

/// Continues to the last good frame up to `frame`, and to those beside it if the clip is interlaced.
Step Decoder::State::advance(int frame, const std::atomic<bool>* stop) {
    while (!ended && (shown.number < frame || (info.interlaced && ahead.number < 0))) {
        if (ahead.number >= 0) {
            if (ahead.number > frame) break;
            if (info.interlaced) before.take(shown);
            shown.take(ahead);
            continue;
        }
        const Step result = step(next, stop);
        if (result == Step::stopped) return result;
        if (result == Step::end)
            ended = true;
        else
            ahead.take(next);
    }
    return Step::frame;
}

/// Goes to `frame` of an interlaced clip with the good frame before it, so that it is the same from wherever decoding
/// starts.
Step Decoder::State::jump_with_before(int frame, const std::atomic<bool>* stop) {
    for (int from = frame - 1;; from = shown.number - 1) {
        if (jump(from, stop) == Step::stopped || advance(frame, stop) == Step::stopped) {
            placed = false;
            return Step::stopped;
        }
        // Where decoding started at `shown`, the good frame before it is still unknown.
        if (before.number >= 0 || from_start) return Step::frame;
    }
}

/// Makes `shown` the frame `frame`, or the last good one before it, if there is any.
Step Decoder::State::decode_to(int frame, const std::atomic<bool>* stop) {
    if (index->sequence) return decode_image(frame, stop);
    const int reached = std::max(shown.number, ahead.number);
    const bool here = shown.number <= frame && (ended || ahead.number > frame);
    const std::ptrdiff_t points = points_up_to(frame);
    const bool far = points > 0 && index->points[static_cast<std::size_t>(points - 1)].frame > reached + a_few;
    if (!placed || (!here && (shown.number > frame || far))) {
        if (info.interlaced) return jump_with_before(frame, stop);
        if (jump(frame, stop) == Step::stopped) return Step::stopped;
    }
    return advance(frame, stop);
}

/// The same for a sequence, whose images are opened one by one.
Step Decoder::State::decode_image(int frame, const std::atomic<bool>* stop) {
    ClipIndex one_image;
    one_image.times = {0.0};
    failed.resize(static_cast<std::size_t>(index->sequence->count), false);
    if (shown.number > frame) shown.clear();
    for (int at = frame; at > shown.number; --at) {
        if (stop != nullptr && stop->load(std::memory_order_relaxed)) return Step::stopped;
        const auto place = static_cast<std::size_t>(at);
        if (failed[place]) continue;
        failed[place] = true;
        try {
            FrameReader image(index->sequence->file(at));
            if (image.next(one_image, *next.frame, next.number, nullptr) != Step::frame) continue;
        } catch (const Error&) {  // missing or broken: the one before is shown
            continue;
        }
        failed[place] = false;
        shown.take(next);
        shown.number = at;
        break;
    }
    return Step::frame;
}

void Decoder::State::rest() {
    for (Decoded* one : {&before, &shown, &ahead, &next}) one->clear();
    deinterlacer = {};
    reader.reset();
    rests = true;
}

void Decoder::State::wake() {
    if (!rests) return;
    if (stamp_of(path) != stamp) throw bad_clip(path, "is another file than the one that was opened");
    if (!index->sequence) reader = std::make_unique<FrameReader>(path);
    placed = true;
    ended = rests = false;
}

/// False when it was stopped.
bool Decoder::State::reach(int frame, const std::atomic<bool>* stop) {
    assert(frame >= 0 && frame < info.frame_count());
    const double start = seconds();
    wake();
    const Step result = decode_to(frame, stop);
    decode_seconds += seconds() - start;
    return result != Step::stopped;
}

/// The frame that was reached, of whole rows.
const AVFrame& Decoder::State::progressive() {
    if (!is_interlaced(*shown.frame)) return *shown.frame;
    const work::Stopwatch watch(decode_seconds);
    return deinterlacer.convert(before.number < 0 ? nullptr : before.frame.get(), *shown.frame,
                                ahead.number < 0 ? nullptr : ahead.frame.get());
}

/// Writes the frame that was reached; gives whether it is `frame` itself.
bool Decoder::State::write(int frame, std::span<std::uint8_t> into) {
    assert(into.size() == converter->format().bytes());
    if (shown.number < 0) {
        converter->make_black(into);
        return false;
    }
    converter->convert(progressive(), into);
    return shown.number == frame;
}

Decoder::Decoder(const fs::path& path, Layout layout, int maximum_frames, const work::Stages& stages)
    : state_(std::make_unique<State>(path, layout)) {
    state_->look_through(maximum_frames, stages);
    state_->converter = std::make_unique<FrameConverter>(format(), state_->index->color);
}

Decoder::Decoder(const fs::path& path, Layout layout, const ClipInfo& known)
    : state_(std::make_unique<State>(path, layout)) {
    assert(known.index != nullptr);
    state_->open_known(known);
    state_->converter = std::make_unique<FrameConverter>(format(), state_->index->color);
}

Decoder::Decoder(Decoder&&) noexcept = default;
Decoder& Decoder::operator=(Decoder&&) noexcept = default;
Decoder::~Decoder() = default;

const ClipInfo& Decoder::info() const {
    return state_->info;
}

PictureFormat Decoder::format() const {
    return {.size = state_->size, .layout = state_->layout, .alpha = state_->info.alpha};
}

DecodableFrames Decoder::count_decodable(const work::Stages& stages) {
    return state_->count_decodable(stages);
}

void Decoder::scale_to(glm::ivec2 size) {
    state_->size = size;
    state_->converter = std::make_unique<FrameConverter>(format(), state_->index->color);
}

bool Decoder::read(int index, Picture& into, const std::atomic<bool>* stop) noexcept {
    const std::size_t bytes = format().bytes();
    try {
        if (!state_->reach(index, stop)) return false;
        into.bytes.resize(bytes);
        return state_->write(index, into.bytes);
    } catch (const std::exception&) {  // no memory, or the file is not a video any more
    }
    try {
        if (into.bytes.size() == bytes) return false;
        into.bytes.resize(bytes);
        state_->converter->make_black(into.bytes);
    } catch (const std::bad_alloc&) {  // it keeps its contents
    }
    return false;
}

bool Decoder::read(int index, std::span<std::uint8_t> into, const std::atomic<bool>* stop) noexcept {
    try {
        return state_->reach(index, stop) && state_->write(index, into);
    } catch (const std::exception&) {
    }
    state_->converter->make_black(into);
    return false;
}

void Decoder::rest() noexcept {
    state_->rest();
}

bool Decoder::rests() const {
    return state_->rests;
}

double Decoder::decode_seconds() const {
    return state_->decode_seconds + state_->converter->convert_seconds();
}

double Decoder::copy_seconds() const {
    return state_->converter->copy_seconds();
}

std::int64_t Decoder::decoded_packets() const {
    return state_->reader ? state_->reader->packets() : 0;
}

Decoder open_stoppable(const fs::path& path, Layout layout, int maximum_frames, const std::atomic<bool>* stop) {
    const Progress progress = [stop](double) { return stop == nullptr || !stop->load(std::memory_order_relaxed); };
    try {
        return {path, layout, maximum_frames, work::Stages(progress)};
    } catch (const work::Stopped&) {
        throw Error(Failure::runtime, Fault{.file = path.string(), .place = "", .reason = "was not read to its end"});
    }
}

}  // namespace lapfx::media
