#include "media/clip_index.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string_view>

namespace lapfx::media {

namespace {

constexpr double default_rate = 25.0;     // frames per second for a file that does not say
constexpr double maximum_rate = 1000.0;   // a file that claims more has no usable times
constexpr std::size_t packets_told = 64;  // packets between two reports of progress
constexpr double maximum_time = 1e7;      // s, likewise unusable: 115 days
constexpr double longest_pause = 3600.0;  // s from one frame to the next; after more of it the clock was set
constexpr double unusual_step = 1000.0;   // and times the usual step: a slide show may have steps of hours

struct Entry {
    std::int64_t pts, dts, position, duration;
    bool start;  ///< decoding can start here
};

/// A VP8 or VP9 frame's header (RFC 6386, section 9.1; VP9 bitstream specification, section 6.2).
struct VpxHeader {
    bool shown = true, key = false;
};

VpxHeader vpx_header(AVCodecID codec, const std::uint8_t* data, std::size_t size) {
    if (size == 0) return {};
    const unsigned first = data[0];
    if (codec == AV_CODEC_ID_VP8) return {.shown = (first & 0x10) != 0, .key = (first & 1) == 0};
    // The first three bits after those of the profile: a frame is shown again; not a key frame; shown.
    const bool extra_bit = (first & 0x30) == 0x30;
    const unsigned bits = extra_bit ? first << 1 : first;
    if ((bits & 8) != 0) return {};
    // A superframe, marked by its last byte, packs a hidden frame with one that is shown.
    const bool super = (data[size - 1] & 0xe0) == 0xc0;
    const bool shown = extra_bit ? (first & 1) != 0 : (first & 2) != 0;
    return {.shown = shown || super, .key = (bits & 4) == 0};
}

/// Whether an H.264 packet has an IDR picture: after other key frames, later frames may refer to earlier ones.
bool has_idr(const AVCodecParameters& codec, const AVPacket& packet) {
    constexpr int idr = 5;
    const std::uint8_t *at = packet.data, *const end = at + packet.size;
    const bool with_lengths = codec.extradata_size > 6 && codec.extradata[0] == 1;
    if (!with_lengths) {  // Annex B: start codes
        for (; end - at > 3; ++at)
            if (at[0] == 0 && at[1] == 0 && at[2] == 1 && (at[3] & 31) == idr) return true;
        return false;
    }
    const int bytes = (codec.extradata[4] & 3) + 1;
    while (end - at > bytes) {
        std::int64_t length = 0;
        for (int i = 0; i < bytes; ++i) length = length << 8 | *at++;
        if ((*at & 31) == idr) return true;
        if (length > end - at) return false;
        at += length;
    }
    return false;
}

/// The opacity of the clip is a separate stream with its own key frames (Matroska: BlockAdditional 1, after its
/// number).
bool opacity_can_start(AVCodecID codec, const AVPacket& packet) {
    std::size_t size = 0;
    const std::uint8_t* data = av_packet_get_side_data(&packet, AV_PKT_DATA_MATROSKA_BLOCKADDITIONAL, &size);
    constexpr std::size_t number = 8;
    return data == nullptr || size <= number || vpx_header(codec, data + number, size - number).key;
}

/// Whether decoding from a key frame gives exactly the bytes that decoding from the start gives.
bool can_start(const AVCodecParameters& codec, const AVPacket& packet) {
    if ((packet.flags & AV_PKT_FLAG_KEY) == 0) return false;
    switch (codec.codec_id) {
        case AV_CODEC_ID_H264:
            return has_idr(codec, packet);
        case AV_CODEC_ID_VP8:
        case AV_CODEC_ID_VP9:
            return vpx_header(codec.codec_id, packet.data, static_cast<std::size_t>(packet.size)).key &&
                   opacity_can_start(codec.codec_id, packet);
        case AV_CODEC_ID_HEVC:
        case AV_CODEC_ID_AV1:
        case AV_CODEC_ID_MPEG1VIDEO:
        case AV_CODEC_ID_MPEG2VIDEO:
        case AV_CODEC_ID_MPEG4:
        case AV_CODEC_ID_THEORA:
        case AV_CODEC_ID_FFV1:
        case AV_CODEC_ID_H263:
        case AV_CODEC_ID_FLV1:
        case AV_CODEC_ID_MSMPEG4V2:
        case AV_CODEC_ID_MSMPEG4V3:
        case AV_CODEC_ID_WMV1:
        case AV_CODEC_ID_WMV2:
            return true;
        default: {  // GIF paints on earlier frames; others are unknown
            const AVCodecDescriptor* known = avcodec_descriptor_get(codec.codec_id);
            return known != nullptr && (known->props & AV_CODEC_PROP_INTRA_ONLY) != 0 &&
                   codec.codec_id != AV_CODEC_ID_APNG && codec.codec_id != AV_CODEC_ID_GIF;
        }
    }
}

bool is_hidden(const AVCodecParameters& codec, const AVPacket& packet) {
    if ((packet.flags & AV_PKT_FLAG_DISCARD) != 0) return true;
    return (codec.codec_id == AV_CODEC_ID_VP8 || codec.codec_id == AV_CODEC_ID_VP9) &&
           !vpx_header(codec.codec_id, packet.data, static_cast<std::size_t>(packet.size)).shown;
}

bool is_avi(const MediaFile& file) {
    return std::string_view(file.container()) == "avi";
}

struct Packets {
    std::vector<Entry> shown;
    std::size_t count = 0;  ///< including frames that are not shown
    bool cut = false;       ///< one lacks a part
};

Packets read_packets(MediaFile& file, const std::filesystem::path& path, std::size_t maximum,
                     const work::Stages& stages) {
    double share = 0.0;
    Packets packets;
    std::vector<Entry>& entries = packets.shown;
    const libav::Packet packet(libav::made(av_packet_alloc()));
    const AVCodecParameters& codec = *file.video().codecpar;
    while (file.next(*packet)) {
        if (packets.count++ % packets_told == 0) stages.reach(share = std::max(share, file.read_share()));
        packets.cut = packets.cut || (packet->flags & AV_PKT_FLAG_CORRUPT) != 0;
        if (is_hidden(codec, *packet)) continue;
        if (entries.size() == maximum)
            throw bad_clip(path, "has more than " + std::to_string(maximum) + " frames, the most that are allowed");
        entries.push_back({packet->pts, packet->dts, packet->pos, packet->duration, can_start(codec, *packet)});
        if (file.single_image()) break;  // what follows is a preview or the like
    }
    return packets;
}

/// Whether the packets say when each frame is shown. In AVI they do not: FFmpeg gives the order of decoding, which may
/// differ. Times of concatenated streams start again.
bool has_stamps(const MediaFile& file, const std::vector<Entry>& entries) {
    if (is_avi(file) && file.video().codecpar->video_delay > 0) return false;
    std::int64_t last = AV_NOPTS_VALUE;
    for (const Entry& entry : entries) {
        if (entry.pts == AV_NOPTS_VALUE) return false;
        if (entry.dts == AV_NOPTS_VALUE) continue;
        if (last != AV_NOPTS_VALUE && entry.dts < last) return false;
        last = entry.dts;
    }
    return true;
}

std::vector<std::int64_t> sorted_stamps(const std::vector<Entry>& entries) {
    std::vector<std::int64_t> stamps;
    for (const Entry& entry : entries) stamps.push_back(entry.pts);
    std::sort(stamps.begin(), stamps.end());
    stamps.erase(std::unique(stamps.begin(), stamps.end()), stamps.end());
    return stamps;
}

/// Frames per second that the file claims; 0 when it claims nothing possible.
double claimed_rate(const AVStream& video) {
    for (const AVRational rate : {video.avg_frame_rate, video.r_frame_rate}) {
        const double fps = rate.num > 0 && rate.den > 0 ? av_q2d(rate) : 0.0;
        if (fps >= 1.0 / maximum_time && fps <= maximum_rate) return fps;
    }
    return 0.0;
}

void set_times_by_rate(ClipIndex& index, std::size_t frames, double rate) {
    for (std::size_t i = 0; i < frames; ++i) index.times.push_back(static_cast<double>(i) / rate);
    index.duration = static_cast<double>(frames) / rate;
}

/// By how much the clock of a file jumps between two frames, as words. Stamps of MPEG-TS have 33 bits and start again
/// after a day; FFmpeg takes a step back by more than a minute for that and adds a day.
std::string jump_words(double jump, const AVStream& video, double seconds) {
    const double day = video.pts_wrap_bits < 63 ? std::ldexp(seconds, video.pts_wrap_bits) : 2.0 * maximum_time;
    char text[48];
    if (jump > day / 2.0 && jump < day)
        std::snprintf(text, sizeof text, "back by %.0f s", day - jump);
    else
        std::snprintf(text, sizeof text, "forward by %.1f h", jump / 3600.0);
    return text;
}

/// Takes the time out in which no clock of a camera stood: where it was set while it recorded, or files were joined.
/// Says where that was; empty: nowhere.
std::string close_jumps(std::vector<double>& times, const AVStream& video, double seconds) {
    if (times.size() < 3) return "";
    std::vector<double> steps;
    for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
    std::vector<double> sorted = steps;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>((sorted.size() - 1) / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double usual = *middle;
    std::string told;
    int jumps = 0;
    double taken = 0.0;
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double step = steps[i - 1];
        times[i] -= taken;
        if (!(step > longest_pause && step > unusual_step * usual)) continue;
        char at[32];
        std::snprintf(at, sizeof at, " at %.3f s", times[i - 1] + usual);
        if (jumps++ == 0) told = jump_words(step, video, seconds) + at;
        taken += step - usual;
        times[i] -= step - usual;
    }
    if (jumps == 0) return "";
    if (jumps > 1) told += ", the first of " + std::to_string(jumps) + " such jumps";
    return "its clock jumps " + told + "; it plays on there without a pause";
}

/// Times from `stamps`; false when these are not plausible.
bool set_times_by_stamps(ClipIndex& index, const Entry& last, const AVStream& video) {
    const double seconds = video.time_base.num > 0 && video.time_base.den > 0 ? av_q2d(video.time_base) : 0.0;
    const double first = static_cast<double>(index.stamps.front());
    std::vector<double> times;
    for (const std::int64_t stamp : index.stamps) times.push_back((static_cast<double>(stamp) - first) * seconds);
    std::string jumps = close_jumps(times, video, seconds);
    const double span = times.back();
    const auto steps = static_cast<double>(times.size() - 1);
    if (!(span <= maximum_time) || (steps > 0.0 && !(steps <= span * maximum_rate * 1.01))) return false;
    index.times = std::move(times);
    index.warning = std::move(jumps);
    double shown = static_cast<double>(last.duration) * seconds;
    if (!(shown > 0.0 && shown <= maximum_time)) shown = steps > 0.0 ? span / steps : 1.0 / default_rate;
    index.duration = span + shown;
    return true;
}

void set_points(ClipIndex& index, const std::vector<Entry>& entries) {
    for (const Entry& entry : entries)
        if (entry.start && entry.dts != AV_NOPTS_VALUE)
            index.points.push_back({index.frame_at(entry.pts), entry.pts, entry.dts, entry.position});
    std::stable_sort(index.points.begin(), index.points.end(),
                     [](const SeekPoint& a, const SeekPoint& b) { return a.frame < b.frame; });
    // Of packets with the same time the first is shown.
    const auto same = [](const SeekPoint& a, const SeekPoint& b) { return a.frame == b.frame; };
    index.points.erase(std::unique(index.points.begin(), index.points.end(), same), index.points.end());
}

/// Detects files that end early, where the container counts its packets or its bytes. AVI's count alone proves nothing,
/// because it includes empty packets.
std::string missing(const MediaFile& file, const Packets& packets) {
    if (file.single_image()) return "";
    if (const std::int64_t stated = file.stated_size(); stated > file.size())
        return "the file ends early: " + std::to_string(file.size()) + " of its " + std::to_string(stated) +
               " bytes are there";
    const std::int64_t claimed = file.video().nb_frames, found = static_cast<std::int64_t>(packets.count);
    const bool early = is_avi(file) ? packets.cut : file.ran_out();
    if (!early || claimed <= found) return "";
    const std::string first = std::to_string(found + 1);
    return (claimed == found + 1 ? "frame " + first : "frames " + first + " to " + std::to_string(claimed)) +
           " could not be decoded: the file ends early";
}

}  // namespace

int ClipIndex::frame_at(std::int64_t pts) const {
    const auto after = std::lower_bound(stamps.begin(), stamps.end(), pts);
    if (after == stamps.begin()) return 0;
    const auto index = static_cast<int>(after - stamps.begin());
    if (after == stamps.end()) return index - 1;
    // Differences without overflow, whatever a broken file claims.
    const auto apart = [](std::int64_t a, std::int64_t b) {
        return static_cast<std::uint64_t>(b) - static_cast<std::uint64_t>(a);
    };
    return apart(pts, *after) <= apart(*(after - 1), pts) ? index : index - 1;
}

ClipIndex index_clip(MediaFile& file, const std::filesystem::path& path, int maximum, const work::Stages& stages) {
    const Packets packets = read_packets(file, path, static_cast<std::size_t>(maximum), stages);
    const std::vector<Entry>& entries = packets.shown;
    if (entries.empty()) throw bad_clip(path, "has no frame that can be decoded");
    ClipIndex index;
    if (has_stamps(file, entries)) {
        index.stamps = sorted_stamps(entries);
        const Entry& last = *std::max_element(entries.begin(), entries.end(),
                                              [](const Entry& a, const Entry& b) { return a.pts < b.pts; });
        if (set_times_by_stamps(index, last, file.video()))
            set_points(index, entries);
        else
            index.stamps.clear();
    }
    add_warning(index.warning, missing(file, packets));
    if (index.stamps.empty()) {
        const double rate = claimed_rate(file.video());
        set_times_by_rate(index, entries.size(), rate > 0.0 ? rate : default_rate);
        if (rate == 0.0 && index.warning.empty())
            index.warning = "has no usable times; 25 frames per second are assumed";
    }
    return index;
}

void add_warning(std::string& all, const std::string& one) {
    if (!all.empty() && !one.empty()) all += "; ";
    all += one;
}

ClipIndex index_sequence(const ImageSequence& sequence) {
    ClipIndex index;
    index.sequence = sequence;
    set_times_by_rate(index, static_cast<std::size_t>(sequence.count), default_rate);
    return index;
}

}  // namespace lapfx::media
