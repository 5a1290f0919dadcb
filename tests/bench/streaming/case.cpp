#include "bench/streaming/case.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "lapfx/effects.h"

namespace lapfx::bench {

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
    return 1e3 * std::chrono::duration<double>(Clock::now() - start).count();
}

/// One scheme with a number of playing clips.
class Case {
  public:
    Case(const HostFrame& host, const Way& way, const Preset& preset, int frames)
        : host_(host),
          step_(way.step),
          frames_(frames),
          late_(way.step > 1),
          effects_(triangle(), preset,
                   {.clip_folders = {},
                    .wait_for_clips = way.late != LateClips::skip,
                    .streaming = {.scheme = way.scheme,
                                  .resolution = way.resolution,
                                  .memory = way.memory,
                                  .late = way.late,
                                  .gpu_timings = true}}) {
        row_.scheme = way.name;
        row_.streams = static_cast<int>(preset.smoke.clips.size());
        row_.open = 1e3 * effects_.streaming_times().open;
        effects_.set_contacts(burning());
    }

    void warm(int frames, double share = 1.0) {
        for (int i = 0; i < frames; ++i) step(share);
    }

    StreamingRow measure() {
        std::vector<double> waits, uploads, totals, shadings, frames;
        const StreamingTimes before = effects_.streaming_times();
        for (int i = 0; i < frames_; ++i) {
            const StreamingTimes at = effects_.streaming_times();
            const auto [total, shading] = step(1.0);
            const StreamingTimes now = effects_.streaming_times();
            waits.push_back(1e3 * (now.wait - at.wait));
            uploads.push_back(1e3 * (now.upload - at.upload));
            totals.push_back(total);
            shadings.push_back(shading);
            frames.push_back(total + shading);
        }
        const StreamingTimes after = effects_.streaming_times();
        row_.retrieve = 1e3 * (after.decode - before.decode) / frames_;
        row_.copy = 1e3 * (after.copy - before.copy) / frames_;
        if (after.shaded > before.shaded)
            row_.gpu = 1e3 * (after.shading - before.shading) / static_cast<double>(after.shaded - before.shaded);
        row_.wait = mean(waits);
        row_.upload = mean(uploads);
        row_.sending = row_.wait + row_.upload;
        row_.sent = static_cast<double>(after.uploaded - before.uploaded) / frames_;
        row_.total = median(totals);
        row_.shading = median(shadings);
        row_.frame = median(frames);
        std::sort(frames.begin(), frames.end());
        row_.spread = 0.5 * (frames[frames.size() * 3 / 4] - frames[frames.size() / 4]);
        row_.fps = 1e3 / mean(frames);
        row_.resident = resident_share();
        return row_;
    }

  private:
    static double mean(const std::vector<double>& values) {
        double sum = 0.0;
        for (const double value : values) sum += value;
        return sum / static_cast<double>(values.size());
    }
    double resident_share() const {
        double resident = 0.0, frames = 0.0;
        for (const ClipStatus& clip : effects_.clips()) {
            resident += clip.resident;
            frames += clip.frames;
        }
        return resident / frames;
    }
    /// Until nothing more is decoded ahead.
    void let_decoders_rest() const {
        constexpr std::chrono::milliseconds rest(30);
        for (std::uint64_t before = 0, now = 1; now != before;) {
            before = effects_.streaming_times().decoded;
            std::this_thread::sleep_for(rest);
            now = effects_.streaming_times().decoded;
        }
    }
    /// ms in the call, and after it until everything is drawn.
    std::pair<double, double> step(double share) {
        if (late_) let_decoders_rest();
        effects_.seek(20.0 + step_ * frame_++ / bench_clip_fps);
        host_.bind(share);
        finish_drawing();
        const auto start = Clock::now();
        effects_.draw_smoke(view_, host_.depth());
        const double total = ms_since(start);
        finish_drawing();
        return {total, ms_since(start) - total};
    }

    const HostFrame& host_;
    const int step_, frames_;
    const bool late_;
    Effects effects_;
    View view_ = looking_on();
    StreamingRow row_;
    int frame_ = 0;
};

}  // namespace

StreamingRow measure(const HostFrame& host, const Way& way, int streams, const BenchClips& clips,
                     const StreamingExtent& extent) {
    Case playing(host, way, smoke_of(streams, clips), extent.measured);
    // Drawn small, so that a loop of the clips only fills the memory.
    if (way.scheme == Scheme::resident) playing.warm(clips.frames() + 10, 0.02);
    playing.warm(extent.warm_up);
    return playing.measure();
}

BenchRow as_bench_row(const StreamingRow& r) {
    return {.of = {{"scheme", r.scheme}, {"streams", std::to_string(r.streams)}},
            .measured = {{"open_ms", r.open},
                         {"retrieve_ms", r.retrieve},
                         {"copy_ms", r.copy},
                         {"wait_ms", r.wait},
                         {"upload_ms", r.upload},
                         {"shading_ms", r.shading},
                         {"gpu_shading_ms", r.gpu},
                         {"total_ms", r.total},
                         {"frame_ms", r.frame},
                         {"frame_spread_ms", r.spread},
                         {"fps", r.fps},
                         {"sent_frames", r.sent},
                         {"sending_ms", r.sending},
                         {"resident", r.resident}}};
}

void keep_best(std::vector<StreamingRow>& rows, const StreamingRow& row) {
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const StreamingRow& other) {
        return other.scheme == row.scheme && other.streams == row.streams;
    });
    if (same == rows.end()) {
        rows.push_back(row);
        return;
    }
    const double sending = std::min(row.sending, same->sending);
    if (row.frame < same->frame) *same = row;
    same->sending = sending;
}

const StreamingRow& find(std::span<const StreamingRow> rows, const Way& way, int streams) {
    return *std::find_if(rows.begin(), rows.end(),
                         [&](const StreamingRow& r) { return r.scheme == way.name && r.streams == streams; });
}

}  // namespace lapfx::bench
