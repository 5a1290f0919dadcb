#include "app/measure/measuring.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/base/jobs.h"
#include "app/base/notices.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/file.h"
#include "output/files.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t least_corners = 3;  // of a polygon

bool same_object(const std::weak_ptr<const VideoReader>& a, const std::shared_ptr<const VideoReader>& b) {
    return !a.owner_before(b) && !b.owner_before(a);
}

}  // namespace

const Table& measure_table() {
    static const Table& table = *scene_table().find("reference")->find("measure");
    return table;
}

match::MeasureOptions measure_options(const ReferenceMeasure& measure) {
    match::MeasureOptions options;
    const MeasuredRegion& region = measure.region;
    options.estimator.blood = measure.blood;
    options.estimator.region = {region.x, region.y, std::min(region.width, 1 - region.x),
                                std::min(region.height, 1 - region.y)};
    for (const LeftOutPart& part : measure.parts) {
        if (part.corners.size() < least_corners) continue;
        match::Part& mask = options.estimator.masks.emplace_back();
        for (const PartCorner& corner : part.corners) mask.emplace_back(corner.x, corner.y);
    }
    if (measure.baseline > 0) options.baseline = measure.baseline;
    options.from = measure.from;
    if (measure.to > 0) options.to = measure.to;
    return options;
}

Measuring::Measuring(document::Document& document, const Reference& reference, Jobs& jobs, Notices& notices)
    : document_(document), reference_(reference), jobs_(jobs), notices_(notices) {}

Measuring::Subject Measuring::subject() const {
    return {.file = reference_.file(), .opened = reference_.opened(), .measure = document_.scene().reference.measure};
}

void Measuring::update() {
    if (running_ && running_->cancelled()) running_.reset();  // by whoever lists jobs
}

void Measuring::forget() {
    cancel();
    faults_.clear();
    found_.reset();
    of_ = {};
    ++version_;
}

void Measuring::cancel() {
    if (running_) running_->cancel();
    running_.reset();
}

void Measuring::start() {
    if (reference_.video() == nullptr) return;
    cancel();
    faults_.clear();
    const Subject of = subject();
    running_ = jobs_.start(
        "Measuring " + of.file.filename().string(),
        [this, of](Job& job) -> Jobs::Apply {
            VideoReader video(of.file, &job.stop());
            const auto progress = [&job](double share) {
                job.set_progress(share);
                return !job.cancelled();
            };
            const auto found =
                std::make_shared<match::Measurement>(match::measure(video, measure_options(of.measure), progress));
            return [this, of, found] {
                running_.reset();
                found_ = std::make_unique<const match::Measurement>(std::move(*found));
                of_ = of;
                ++version_;
            };
        },
        [this, of](const std::vector<Fault>& faults) {
            running_.reset();
            faults_ = faults;
            for (Fault& fault : faults_)
                if (fault.file.empty()) fault.file = of.file.filename().string();
        });
}

bool Measuring::stale() const {
    return found_ && (of_.file != reference_.file() || !same_object(of_.opened, reference_.opened()) ||
                      !equal(measure_table(), &of_.measure, &document_.scene().reference.measure));
}

void Measuring::write(MeasureFile kind, const fs::path& path) {
    if (!found_) return;
    try {
        if (kind == MeasureFile::png)
            output::write_png(path, match::plot_of(*found_));
        else
            write_file(path, kind == MeasureFile::csv ? match::csv_of(*found_) : match::json_of(*found_));
        notices_.add({.text = "Exported " + path.filename().string()});
    } catch (const Error& error) {
        notices_.tell(error.faults());
    }
}

void Measuring::use_frame() {
    if (reference_.video() == nullptr) return;
    // A little after the frame's start, so that rounding does not lead to the frame before; 0 would be "suggested".
    const double time = reference_.video()->time_of(reference_.frame()) + 1e-3;
    document_.change("Baseline",
                     [&](document::Content& c) { c.scene.reference.measure.baseline = std::round(1e3 * time) / 1e3; });
}

void Measuring::suggest() {
    document_.change("Suggest baseline", [](document::Content& c) { c.scene.reference.measure.baseline = 0; });
}

}  // namespace lapfx::app
