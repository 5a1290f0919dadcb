#include "app/measure/measuring.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/base/jobs.h"
#include "app/base/not_opened.h"
#include "app/base/notices.h"
#include "app/measure/blood_strokes.h"
#include "app/measure/measuring_run.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/file.h"
#include "match/use/measure_video.h"
#include "output/files.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double between_looks = 0.25;  // s between two states of a curve that grows

/// Of what the scene says, not of the video.
bool of_scene(const Fault& fault) {
    return fault.place.starts_with("/");
}

bool same_object(const std::weak_ptr<const VideoReader>& a, const std::shared_ptr<const VideoReader>& b) {
    return !a.owner_before(b) && !b.owner_before(a);
}

}  // namespace

const Table& measure_table() {
    static const Table& table = *scene_table().find("reference")->find("measure");
    return table;
}

Measuring::Measuring(document::Document& document, const Reference& reference, std::shared_ptr<MeasuredVideos> known,
                     Jobs& jobs, Notices& notices, bool by_itself)
    : document_(document),
      reference_(reference),
      known_(known ? std::move(known) : std::make_shared<MeasuredVideos>()),
      jobs_(jobs),
      notices_(notices),
      by_itself_(by_itself) {}
Measuring::~Measuring() = default;

Measuring::Subject Measuring::subject() const {
    return {.file = reference_.file(),
            .opened = reference_.opened(),
            .written = written_,
            .measure = document_.scene().reference.measure};
}

/// A file that was opened again is the same as long as nobody has written to it.
bool Measuring::is_now(const Subject& of) const {
    if (of.file != reference_.file() || !equal(measure_table(), &of.measure, &document_.scene().reference.measure))
        return false;
    return same_object(of.opened, reference_.opened()) ||
           (reference_.video() != nullptr && of.written && same_object(dated_, reference_.opened()) &&
            of.written == written_);
}

Measuring::Measured* Measuring::of_now() const {
    for (const auto& measured : all_)
        if (is_now(measured->of)) return measured.get();
    return nullptr;
}

bool Measuring::begun() const {
    const Measured* const now = of_now();
    return now != nullptr && now->run != nullptr;
}

double Measuring::progress() const {
    const Measured* const now = of_now();
    return now != nullptr && now->run ? now->run->progress() : 0;
}

std::span<const match::FrameAmounts> Measuring::frames() const {
    if (const Measured* const now = of_now(); now != nullptr && now->run && !now->frames.empty()) return now->frames;
    return found_ ? std::span(found_->found->frames) : std::span<const match::FrameAmounts>();
}

std::uint64_t Measuring::serial() const {
    if (const Measured* const now = of_now(); now != nullptr && now->run && !now->frames.empty()) return now->serial;
    return found_serial_;
}

void Measuring::update(double now) {
    if (running_ && running_->cancelled()) cancel();  // by whoever lists jobs
    if (!same_object(dated_, reference_.opened())) {
        dated_ = reference_.opened();
        std::error_code error;
        const fs::file_time_type written = fs::last_write_time(reference_.file(), error);
        written_ = error ? std::nullopt : std::optional(written);
    }
    if (!followed_ || !is_now(*followed_)) {
        followed_ = subject();
        settling_.change(now);
        rest();
        faults_.clear();
        ++version_;
    }
    if (Measured* const measured = of_now()) take(*measured);
    due_ = Settling::never;
    if (std::exchange(wanted_, false)) follow(now);
}

/// Somebody looks.
void Measuring::follow(double now) {
    if (!running_) {
        const Measured* const known = of_now();
        const bool complete = known != nullptr && !known->run;
        const bool stopped = stopped_ && is_now(*stopped_);
        if (!by_itself_ || reference_.video() == nullptr || complete || stopped) return;
        if (!settling_.due_at(now)) {
            due_ = settling_.due();
            return;
        }
        start();
    }
    due_ = now + between_looks;
}

void Measuring::forget() {
    rest();
    faults_.clear();
    all_.clear();
    found_.reset();
    of_ = {};
    found_serial_ = 0;
    followed_.reset(), stopped_.reset();
    ++version_;
}

void Measuring::rest() {
    if (running_) running_->cancel();
    running_.reset();
}

void Measuring::cancel() {
    rest();
    stopped_ = subject();
    ++version_;
}

/// One to go on with.
Measuring::Measured& Measuring::begin() {
    if (Measured* const known = of_now(); known != nullptr && known->run) return *known;
    const bool anew = std::erase_if(all_, [this](const auto& measured) { return is_now(measured->of); }) > 0;
    if (all_.size() >= kept) all_.erase(all_.begin());
    const Subject of = subject();
    if (std::shared_ptr<const MeasuredVideo> earlier = anew ? nullptr : known(of)) {
        all_.push_back(std::make_unique<Measured>(
            Measured{.serial = ++serials_, .of = of, .run = nullptr, .frames = {}, .counted = {}, .found = earlier}));
        return *all_.back();
    }
    all_.push_back(std::make_unique<Measured>(
        Measured{.serial = ++serials_,
                 .of = of,
                 .run = std::make_unique<MeasuringRun>(of.file, match::measure_options(of.measure), jobs_),
                 .frames = {},
                 .counted = {},
                 .found = nullptr}));
    return *all_.back();
}

/// From an earlier document; null: it is not known, or cannot be, because the reference is several files.
std::shared_ptr<const MeasuredVideo> Measuring::known(const Subject& of) const {
    return of.written ? known_->find({.file = of.file, .written = *of.written, .measure = of.measure}) : nullptr;
}

void Measuring::start() {
    if (reference_.video() == nullptr) return;
    rest();
    faults_.clear();
    stopped_.reset();
    Measured& measured = begin();
    if (measured.run) {
        running_ = jobs_.open("Measuring " + measured.of.file.filename().string(), {});
        measured.run->go_on(running_);
    }
    ++version_;
}

/// What has come of it since.
void Measuring::take(Measured& measured) {
    if (measured.run) {
        const std::size_t before = measured.frames.size();
        measured.run->take(measured.frames, measured.counted);
        if (measured.frames.size() != before) ++version_;
        if (!measured.run->ended()) return;
        end(measured);
        if (!measured.found) return std::erase_if(all_, [&](const auto& m) { return m.get() == &measured; }), void();
    }
    if (found_ == measured.found) return;
    found_ = measured.found;
    found_serial_ = measured.serial;
    of_ = measured.of;
    ++version_;
}

void Measuring::end(Measured& measured) {
    if (std::shared_ptr<const match::Measurement> found = measured.run->found()) {
        measured.found = std::make_shared<const MeasuredVideo>(
            MeasuredVideo{std::move(found), measured.run->colors(), std::exchange(measured.counted, {})});
        const Subject& of = measured.of;
        if (of.written) known_->keep({.file = of.file, .written = *of.written, .measure = of.measure}, measured.found);
    } else {
        faults_ = measured.run->faults();
        for (Fault& fault : faults_)
            if (fault.file.empty() && !of_scene(fault)) fault.file = measured.of.file.filename().string();
        stopped_ = measured.of;
    }
    measured.run.reset();
    measured.frames = {};
    running_.reset();
    ++version_;
}

std::uint64_t Measuring::counted(double time, Image* picture) const {
    const Measured* const now = of_now();
    if (now == nullptr) return 0;
    const CountedFrames& counted = now->found ? now->found->counted : now->counted;
    const bool there = picture != nullptr ? counted.draw(time, *picture) : counted.has(time);
    return there ? now->serial : 0;
}

std::size_t Measuring::memory() const {
    std::size_t bytes = known_->memory();
    for (const auto& measured : all_)
        if (!measured->found)
            bytes += measured->counted.memory();
        else if (!known_->holds(*measured->found))
            bytes += measured->found->counted.memory();
    return bytes;
}

bool Measuring::stale() const {
    return found_ && !is_now(of_);
}

void Measuring::write(MeasureFile kind, const fs::path& path) {
    if (!found_) return;
    try {
        require_not_opened(path);
        if (kind == MeasureFile::png)
            output::write_png(path, match::plot_of(*found_->found));
        else
            write_file(path, kind == MeasureFile::csv ? match::csv_of(*found_->found) : match::json_of(*found_->found));
        notices_.add({.text = "Exported " + path.filename().string()});
    } catch (const Error& error) {
        notices_.tell(error.faults());
    }
}

void Measuring::use_frame() {
    if (reference_.video() == nullptr) return;
    const double time = time_within(*reference_.video(), reference_.frame());  // never 0, which is "suggested"
    document_.change("Baseline", [&](document::Content& c) { c.scene.reference.measure.baseline = time; });
}

void Measuring::suggest() {
    document_.change("Suggest baseline", [](document::Content& c) { c.scene.reference.measure.baseline = 0; });
}

}  // namespace lapfx::app
