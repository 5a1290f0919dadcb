#include "app/measure/fitting.h"

#include <algorithm>
#include <utility>

#include "app/base/editor_options.h"
#include "app/base/jobs.h"
#include "app/base/notices.h"
#include "app/measure/drawn_curve.h"
#include "app/measure/measuring.h"
#include "app/preview/preview_host.h"
#include "app/preview/scene_pace.h"
#include "app/reference/reference.h"
#include "app/tuning/tuning.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/compare.h"
#include "match/use/measure_video.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

std::vector<Fault> because(const char* reason) {
    return {{.file = "", .place = "", .reason = reason}};
}

/// Whether the tools of both scenes work alike.
bool same_tools(const Scene& a, const Scene& b) {
    Scene other = b;
    other.events = a.events, other.curves.emission = a.curves.emission;
    return a.organ.file == b.organ.file && equal(scene_table(), &b, &other);
}

}  // namespace

Fitting::Fitting(const Parts& parts) : parts_(parts) {}
Fitting::~Fitting() = default;

bool Fitting::locked(const std::string& key) const {
    const std::size_t entry = parameters().find(key);
    return entry != no_entry && parts_.tuning.locked(entry);
}

std::vector<std::string> Fitting::free_keys(std::vector<std::string> keys) const {
    std::erase_if(keys, [this](const std::string& key) { return locked(key); });
    return keys;
}

const std::vector<match::FrameAmounts>& Fitting::frames() const {
    static const std::vector<match::FrameAmounts> none;
    if (best_) return *best_;
    return found_ && found_->result && !taken_ ? found_->result->after : none;
}

double Fitting::seconds_left() const {
    return remaining_.seconds(now_);
}

void Fitting::begin(bool proposal_alone) {
    end_run();
    faults_.clear(), lost_clip_.reset();
    best_.reset();
    ++version_;
    measuring_asked_ = false;
    asked_ = proposal_alone;
    due_ = now_;                 // a click may be the last thing that happens in this frame
    if (proposal_alone) return;  // it draws nothing
    // Before the reference is measured, which may take minutes.
    if (std::vector<Fault> lost = lost_clips(); !lost.empty())
        fail(std::move(lost));
    else if (!parts_.preview.loading() && !parts_.preview.preset_faults().empty())
        fail(parts_.preview.preset_faults());
}

/// Looks for the file of every clip.
std::vector<Fault> Fitting::lost_clips() {
    std::vector<Fault> faults;
    lost_clip_.reset();
    looked_ = parts_.document.version();
    const Preset& preset = parts_.document.preset();
    for (std::size_t i = 0; i < preset.smoke.clips.size(); ++i) {
        try {
            (void)find_clip(preset.smoke.clips[i].file, preset.folder, parts_.options.clip_folders);
        } catch (const Error& error) {
            if (!lost_clip_) lost_clip_ = i;
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
    }
    return faults;
}

void Fitting::forget_found_clip() {
    if (!lost_clip_ || looked_ == parts_.document.version()) return;
    if (lost_clips().empty()) faults_.clear();
}

/// What was found of another video says nothing about this one; what was taken and is undone can be taken again.
void Fitting::follow_document() {
    if (!found_) return;
    if (!parts_.reference.opening() && found_->of.reference != parts_.reference.file()) return leave();
    if (!taken_step_ || taken_ == taken_step_.in_effect(parts_.document)) return;
    taken_ = !taken_;
    if (!taken_ && document::same(found_->fit.start, parts_.document.content()))
        of_version_ = parts_.document.version();
    ++version_;
}

void Fitting::cancel() {
    if (run_) return run_->cancel();
    if (measuring_asked_) parts_.measuring.cancel();
    asked_.reset();
    end_run();
}

void Fitting::leave() {
    found_.reset(), best_.reset();
    taken_ = false, taken_step_ = {};
    ++version_;
}

void Fitting::forget() {
    asked_.reset();
    end_run();
    leave();
    faults_.clear(), lost_clip_.reset();
}

void Fitting::end_run() {
    run_.reset();
    curve_.reset();
    steps_.reset();
}

void Fitting::fail(std::vector<Fault> faults) {
    asked_.reset();
    end_run();
    best_.reset();
    faults_ = std::move(faults);
    ++version_;
}

void Fitting::update(double now) {
    now_ = now, due_ = never;
    forget_found_clip();
    follow_document();
    if (!asked_) return;
    if (!run_ && (!measured() || !prepare(now))) return;
    go_on(now);
}

/// False while the reference is being measured, or where it cannot be.
bool Fitting::measured() {
    if (parts_.reference.opening()) return false;
    if (parts_.reference.video() == nullptr) return fail(because("there is no reference to fit to")), false;
    if (parts_.measuring.running()) return false;
    if (parts_.measuring.found() != nullptr && !parts_.measuring.stale()) return true;
    if (!parts_.measuring.faults().empty() && measuring_asked_) return fail(parts_.measuring.faults()), false;
    if (measuring_asked_ && parts_.measuring.cancelled())
        return fail(because("measuring the reference was cancelled")), false;
    measuring_asked_ = true;  // also again, where the scene now says otherwise how
    parts_.measuring.start();
    return false;
}

/// The document and its reference, as they are now.
FitOf Fitting::of_now() const {
    const auto named = [](const fs::path& file, const std::string& name) {
        return !file.empty() ? file.filename().string() : !name.empty() ? name : "not saved";
    };
    const Scene& scene = parts_.document.scene();
    return {.scene = named(parts_.document.scene_file(), scene.name),
            .preset = named(parts_.document.preset_file(), parts_.document.preset().name),
            .reference = parts_.measuring.file(),
            .aspect = scene.reference.aspect,
            .notes = parts_.measuring.found()->notes};
}

/// What a person has chosen, of the document as it is now. `size`: of the pictures.
match::SceneFit Fitting::fit_now(std::shared_ptr<const PreparedOrgan> organ, glm::ivec2 size) const {
    const Scene& scene = parts_.document.scene();
    const double offset = scene.reference.offset;
    match::SceneFit fit{.start = parts_.document.content(),
                        .organ = std::move(organ),
                        .keys = free_keys(look.keys),
                        .reference = parts_.measuring.found()->frames,
                        .offset = offset,
                        .to = scene.duration,
                        .tools = look.tools,
                        .aspect = static_cast<double>(size.x) / size.y,
                        .weights = look.weights,
                        .seed = look.seed,
                        .colors = match::ColorsOfFit::compare,
                        .reference_colors = parts_.measuring.colors()->at_peak(offset, offset + scene.duration)};
    fit.color_keys = free_keys(fit.color_keys);
    if (look.colors && !fit.color_keys.empty()) fit.colors = match::ColorsOfFit::match;
    return fit;
}

/// False while the organ or the clips are still being loaded, or where it cannot begin.
bool Fitting::prepare(double now) {
    const Scene& scene = parts_.document.scene();
    if (scene.organ.file.empty()) return fail(because("there is no organ yet: open a mesh or a scene")), false;
    const std::shared_ptr<const PreparedOrgan> organ = parts_.preview.organ_of(scene);
    if (!organ || parts_.preview.loading()) {
        if (!parts_.preview.loading() && !parts_.preview.organ_faults().empty()) fail(parts_.preview.organ_faults());
        due_ = now + look_again;
        return false;
    }
    if (!parts_.document.preset_faults().empty()) return fail(parts_.document.preset_faults()), false;
    const match::PreviewCurve::Options options = match::PreviewCurve::options_for(
        parts_.reference.video()->info().size, scene.reference.aspect,
        match::measure_options(scene.reference.measure).estimator, parts_.options.measured_side);
    steps_ = std::make_unique<RenderSteps>([this] { parts_.jobs.wake(); });
    curve_ = drawn_curve(organ, parts_.preview, parts_.options.clip_folders, parts_.options.exact ? nullptr : &steps_,
                         options);
    curve_->count_plate_by(match::painted_blood(*parts_.measuring.found()));
    began_ = now, run_version_ = parts_.document.version();
    remaining_ = {};
    run_ = std::make_unique<FittingRun>(
        FitWanted{.fit = fit_now(organ, options.size), .of = of_now(), .proposal_alone = *asked_}, curve_.get(),
        *steps_, parts_.jobs, !parts_.options.exact);
    return true;
}

void Fitting::go_on(double now) {
    if (parts_.options.software && !parts_.options.exact && parts_.pace.touched(now))
        due_ = now + look_again;
    else
        steps_->serve(frame_budget);
    remaining_.reached(now, run_->progress());
    if (std::shared_ptr<const FittingRun::Frames> best = run_->best(); best != best_)
        best_ = std::move(best), ++version_;
    if (!run_->ended()) return;
    if (std::vector<Fault> faults = run_->faults(); !faults.empty()) {
        (void)lost_clips();  // one that has gone meanwhile may be the reason
        return fail(std::move(faults));
    }
    best_.reset();
    if (std::optional<FitFound> found = run_->take()) {
        leave();
        found_ = std::move(found);
        found_->seconds = now - began_;
        of_version_ = run_version_;
    }
    asked_.reset();
    end_run();
    ++version_;
}

void Fitting::take() {
    if (!found_ || std::exchange(taken_, true)) return;
    const FitFound& found = *found_;
    const bool moved = !same_tools(found.tuned.scene, found.fit.start.scene);
    const bool tools = !moved || same_tools(found.fit.start.scene, parts_.document.scene());
    bool kept_locked = false;
    const std::uint64_t before = document::newest_step(parts_.document);
    parts_.document.change(found.result ? "Fit" : "Take proposal", [&](document::Content& content) {
        for (const match::FreeParameter& p : found.parameters)
            if (locked(p.key))
                kept_locked = true;
            else if (const double value = p.get(found.tuned); value != p.get(found.fit.start))
                p.set(content, value);
        std::vector<std::string> colors = match::different_colors(found.fit.start, found.tuned);
        kept_locked |= std::erase_if(colors, [this](const std::string& key) { return locked(key); }) > 0;
        match::take_colors(content, found.tuned, colors);
        if (!moved || !tools) return;
        content.scene.events = found.tuned.scene.events;
        content.scene.curves.emission = found.tuned.scene.curves.emission;
    });
    taken_step_ = document::newest_step(parts_.document) != before ? document::WatchedStep(parts_.document)
                                                                   : document::WatchedStep();
    if (!tools)
        parts_.notices.add(
            {.kind = ui::ToastKind::warning,
             .text = "The scene has changed since: its tools stay as they are, the parameters are taken"});
    if (kept_locked) parts_.notices.add({.text = "What has been locked since stays as it is"});
    ++version_;
}

}  // namespace lapfx::app
