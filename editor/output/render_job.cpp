#include "output/render_job.h"

#include <array>
#include <chrono>
#include <cmath>

#include "lapfx/authoring/file.h"
#include "output/files.h"

namespace lapfx::output {

namespace {

constexpr int longest_side = 16'384;
constexpr double most_pixels = 8192.0 * 8192.0;  // 4 GB of a frame
constexpr double longest_time = 86'400, most_frames = 1e6;

/// A number as a person writes it.
std::string text_of(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", value);
    return text.data();
}

std::string text_of(glm::ivec2 size) {
    return std::to_string(size.x) + "x" + std::to_string(size.y);
}

class Faults {
  public:
    void add(const char* place, std::string reason) {
        all_.push_back({.file = "", .place = place, .reason = std::move(reason)});
    }
    bool in_range(const char* place, double value, double low, double high, const char* unit) {
        if (value >= low && value <= high) return true;  // false for NaN
        add(place, text_of(value) + " is outside " + text_of(low) + " to " + text_of(high) + unit);
        return false;
    }
    std::vector<Fault> take() { return std::move(all_); }

  private:
    std::vector<Fault> all_;
};

void check_size(const RenderOptions& o, Faults& faults) {
    if (const std::string fault = size_fault(o.size); !fault.empty())
        faults.add("--size", fault);
    else if (kind_named(o.output) == OutputKind::video && (o.size.x % 2 != 0 || o.size.y % 2 != 0))
        faults.add("--size", text_of(o.size) + ": the sides of a video must be even");
}

void check_times(const RenderOptions& o, double duration, Faults& faults) {
    if (o.at) {
        faults.in_range("--at", *o.at, 0, longest_time, " s");
        return;
    }
    const double to = o.to.value_or(duration);
    const bool fps_fits = faults.in_range("--fps", o.fps, 0.1, 1000, " frames a second");
    if (!faults.in_range("--from", o.from, 0, longest_time, " s") ||
        !faults.in_range("--to", to, 0, longest_time, " s"))
        return;
    if (to <= o.from)
        faults.add("--to", text_of(to) + " s is not after the first frame at " + text_of(o.from) + " s");
    else if (fps_fits && (to - o.from) * o.fps > most_frames)
        faults.add("--to", "more than a million frames");
}

/// "out.png, out_%04d.png, out.mp4 (.mov, .mkv, .avi)"
std::string frame_examples() {
    std::string text;
    for (const OutputRow& row : output_rows()) {
        if (row.example.empty()) continue;
        text += (text.empty() ? "" : ", ") + std::string(row.example);
        if (row.kind != OutputKind::video) continue;
        const std::vector<std::string> all = extensions(*row.content, true);
        for (std::size_t i = 1; i < all.size(); ++i) text += (i == 1 ? " (" : ", ") + all[i];
        text += ')';
    }
    return text;
}

void check_output(const RenderOptions& o, Faults& faults) {
    if (o.output.empty()) return;
    const std::string name = "\"" + o.output.string() + "\"";
    const auto kind = kind_named(o.output);
    if (!kind)
        faults.add("-o", name + " is not one of " + frame_examples());
    else if (*kind == OutputKind::picture && !o.at)
        faults.add("-o", name + " is one picture; for several choose a video or out_%04d.png");
    else if (*kind != OutputKind::picture && o.at)
        faults.add("-o", name + " is not a single picture; for a single time choose a .png");
    if (kind == OutputKind::video)
        if (const std::string fault = codec_fault(o.codec, o.output); !fault.empty()) faults.add("--codec", fault);
    if (!o.amounts.empty() && o.amounts == o.output) faults.add("--amounts", "is also the file of the pictures");
}

double clock_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::string size_fault(glm::ivec2 size) {
    if (size.x < 1 || size.y < 1 || size.x > longest_side || size.y > longest_side)
        return text_of(size) + " is outside 1x1 to 16384x16384";
    if (static_cast<double>(size.x) * size.y > most_pixels)
        return text_of(size) + " has more pixels than a frame can have: at most as many as 8192x8192";
    return {};
}

std::vector<Fault> check(const RenderOptions& options, double duration) {
    Faults faults;
    check_size(options, faults);
    check_times(options, duration, faults);
    check_output(options, faults);
    return faults.take();
}

/// The span includes the frame at `from`, but not the one at `to`.
std::vector<double> frame_times(const RenderOptions& o, double duration) {
    if (o.at) return {*o.at};
    const int count = static_cast<int>(std::ceil((o.to.value_or(duration) - o.from) * o.fps - 1e-9));
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(o.from + i / o.fps);
    return times;
}

RenderJob::RenderJob(const Scene& scene, const Preset& preset, RenderOptions options, const Loaded& loaded,
                     std::unique_ptr<FramePage> page)
    : options_(std::move(options)), page_(std::move(page)) {
    if (std::vector<Fault> faults = check(options_, scene.duration); !faults.empty())
        throw Error(Failure::bad_input, std::move(faults));
    const glm::ivec2 written = page_ ? page_->size() : options_.size;
    if (const std::string fault = size_fault(written); !fault.empty())
        throw Error(Failure::bad_input,
                    Fault{.file = "", .place = "--size", .reason = "the page with both pictures: " + fault});
    times_ = frame_times(options_, scene.duration);
    // What it reads is known before the first file is begun (file_guard.h).
    preview_ =
        std::make_unique<Preview>(scene, preset, loaded.organ ? loaded.organ : prepare_organ(scene, preset.vessels),
                                  PreviewOptions{.clip_folders = options_.clip_folders,
                                                 .wait_for_clips = true,
                                                 .overlay = options_.overlay,
                                                 .clip_cache = loaded.clips});
    if (!options_.output.empty())
        files_ = make_frame_files(options_.output, {.fps = options_.fps,
                                                    .size = written,
                                                    .count = static_cast<int>(times_.size()),
                                                    .codec = options_.codec,
                                                    .quality = options_.quality});
    if (!options_.amounts.empty()) require_replaceable(options_.amounts);
    if (!options_.layers.empty())
        layers_ =
            std::make_unique<LayerFiles>(options_.layers, options_.fps, options_.size, static_cast<int>(times_.size()));
    amounts_ = amounts_head();
}

RenderJob::~RenderJob() = default;

double RenderJob::progress() const {
    if (done_) return 1;
    // Reading back is quick compared with drawing.
    return (0.95 * static_cast<double>(drawn_) + 0.05 * static_cast<double>(checked_)) /
           static_cast<double>(times_.size());
}

void RenderJob::step() {
    if (done_) return;
    try {
        if (drawn_ < times_.size())
            draw();
        else if (files_ && files_->check())
            ++checked_;
        else if (layers_ && layers_->check())
            return;
        else
            publish();
    } catch (...) {
        files_.reset();
        layers_.reset();
        done_ = true;
        throw;
    }
}

void RenderJob::draw() {
    const double time = times_[drawn_];
    const double begin = clock_now();
    image_ = preview_->image(time, options_.size);
    const double drawn = clock_now();
    amounts_ += amounts_line(time, preview_->amounts());
    if (files_) files_->add(page_ ? page_->page(time, image_) : image_);
    drawing_seconds_ += drawn - begin;
    writing_seconds_ += clock_now() - drawn;
    if (layers_) layers_->add(time, preview_->layers(time, options_.size));
    ++drawn_;
    if (!files_ && !layers_ && options_.amounts.empty()) done_ = drawn_ == times_.size();
}

/// The amounts are written first: if that fails (a full disk), no pictures may be left without them.
void RenderJob::publish() {
    if (!options_.amounts.empty()) write_file(options_.amounts, amounts_);
    if (layers_) layers_->publish();
    if (files_) files_->publish();
    files_.reset();
    layers_.reset();
    done_ = true;
}

}  // namespace lapfx::output
