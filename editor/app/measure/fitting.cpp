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
constexpr double told_from = 0.1;  // of the progress: before, how long it takes is not known

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

Fitting::Fitting(const Parts& parts)
    : document_(parts.document),
      host_(parts.preview),
      reference_(parts.reference),
      measuring_(parts.measuring),
      tuning_(parts.tuning),
      pace_(parts.pace),
      jobs_(parts.jobs),
      notices_(parts.notices),
      clip_folders_(parts.options.clip_folders),
      exact_(parts.options.exact),
      software_(parts.options.software),
      measured_side_(parts.options.measured_side) {}
Fitting::~Fitting() = default;

bool Fitting::locked(const std::string& key) const {
    const std::size_t entry = parameters().find(key);
    return entry != no_entry && tuning_.locked(entry);
}

std::vector<std::string> Fitting::free_keys(std::vector<std::string> keys) const {
    std::erase_if(keys, [this](const std::string& key) { return locked(key); });
    return keys;
}

const std::vector<match::FrameAmounts>& Fitting::frames() const {
    static const std::vector<match::FrameAmounts> none;
    if (found_ && found_->result && !taken_) return found_->result->after;
    return best_ ? *best_ : none;
}

double Fitting::seconds_left() const {
    const double share = progress();
    return share < told_from ? -1.0 : (now_ - began_) * (1.0 - share) / share;
}

void Fitting::begin(bool proposal_alone) {
    end_run();
    faults_.clear(), lost_clip_.reset();
    leave();
    measuring_asked_ = false;
    asked_ = proposal_alone;
    due_ = now_;                 // a click may be the last thing that happens in this frame
    if (proposal_alone) return;  // it draws nothing
    // Before the reference is measured, which may take minutes.
    if (std::vector<Fault> lost = lost_clips(); !lost.empty())
        fail(std::move(lost));
    else if (!host_.loading() && !host_.preset_faults().empty())
        fail(host_.preset_faults());
}

/// Looks for the file of every clip.
std::vector<Fault> Fitting::lost_clips() {
    std::vector<Fault> faults;
    lost_clip_.reset();
    looked_ = document_.version();
    const Preset& preset = document_.preset();
    for (std::size_t i = 0; i < preset.smoke.clips.size(); ++i) {
        try {
            (void)find_clip(preset.smoke.clips[i].file, preset.folder, clip_folders_);
        } catch (const Error& error) {
            if (!lost_clip_) lost_clip_ = i;
            faults.insert(faults.end(), error.faults().begin(), error.faults().end());
        }
    }
    return faults;
}

void Fitting::forget_found_clip() {
    if (!lost_clip_ || looked_ == document_.version()) return;
    if (lost_clips().empty()) faults_.clear();
}

/// What was found of another video says nothing about this one; what was taken and is undone can be taken again.
void Fitting::follow_document() {
    if (!found_) return;
    if (!reference_.opening() && found_->of.reference != reference_.file()) return leave();
    if (!taken_step_ || taken_ == taken_step_.in_effect(document_)) return;
    taken_ = !taken_;
    if (!taken_ && document::same(found_->start, document_.content())) of_version_ = document_.version();
    ++version_;
}

void Fitting::cancel() {
    if (run_) return run_->cancel();
    if (measuring_asked_) measuring_.cancel();
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
    if (reference_.opening()) return false;
    if (reference_.video() == nullptr) return fail(because("there is no reference to fit to")), false;
    if (measuring_.running()) return false;
    if (measuring_.found() != nullptr && !measuring_.stale()) return true;
    if (!measuring_.faults().empty() && measuring_asked_) return fail(measuring_.faults()), false;
    if (measuring_asked_ && measuring_.cancelled())
        return fail(because("measuring the reference was cancelled")), false;
    measuring_asked_ = true;  // also again, where the scene now says otherwise how
    measuring_.start();
    return false;
}

/// The document and its reference, as they are now.
FitOf Fitting::of_now() const {
    const auto named = [](const fs::path& file, const std::string& name) {
        return !file.empty() ? file.filename().string() : !name.empty() ? name : "not saved";
    };
    const Scene& scene = document_.scene();
    return {.scene = named(document_.scene_file(), scene.name),
            .preset = named(document_.preset_file(), document_.preset().name),
            .reference = measuring_.file(),
            .aspect = scene.reference.aspect,
            .notes = measuring_.found()->notes};
}

/// What a person has chosen, of the document as it is now. `size`: of the pictures.
match::SceneFit Fitting::fit_now(std::shared_ptr<const PreparedOrgan> organ, glm::ivec2 size) const {
    const Scene& scene = document_.scene();
    const double offset = scene.reference.offset;
    match::SceneFit fit{.start = document_.content(),
                        .organ = std::move(organ),
                        .keys = free_keys(look.keys),
                        .reference = measuring_.found()->frames,
                        .offset = offset,
                        .to = scene.duration,
                        .tools = look.tools,
                        .aspect = static_cast<double>(size.x) / size.y,
                        .weights = look.weights,
                        .seed = look.seed,
                        .colors = match::ColorsOfFit::compare,
                        .reference_colors = measuring_.colors()->at_peak(offset, offset + scene.duration)};
    fit.color_keys = free_keys(fit.color_keys);
    if (look.colors && !fit.color_keys.empty()) fit.colors = match::ColorsOfFit::match;
    return fit;
}

/// False while the organ or the clips are still being loaded, or where it cannot begin.
bool Fitting::prepare(double now) {
    const Scene& scene = document_.scene();
    if (scene.organ.file.empty()) return fail(because("there is no organ yet: open a mesh or a scene")), false;
    const std::shared_ptr<const PreparedOrgan> organ = host_.organ_of(scene);
    if (!organ || host_.loading()) {
        if (!host_.loading() && !host_.organ_faults().empty()) fail(host_.organ_faults());
        due_ = now + look_again;
        return false;
    }
    if (!document_.preset_faults().empty()) return fail(document_.preset_faults()), false;
    const glm::ivec2 size =
        match::preview_size(reference_.video()->info().size, scene.reference.aspect, measured_side_);
    steps_ = std::make_unique<RenderSteps>([this] { jobs_.wake(); });
    curve_ = drawn_curve(organ, host_, clip_folders_, exact_ ? nullptr : &steps_,
                         {.size = size, .estimator = match::measure_options(scene.reference.measure).estimator});
    began_ = now, of_version_ = document_.version();
    run_ =
        std::make_unique<FittingRun>(FitWanted{.fit = fit_now(organ, size), .of = of_now(), .proposal_alone = *asked_},
                                     curve_.get(), *steps_, jobs_, !exact_);
    return true;
}

void Fitting::go_on(double now) {
    if (software_ && !exact_ && pace_.touched(now))
        due_ = now + look_again;
    else
        steps_->serve(frame_budget);
    if (std::shared_ptr<const FittingRun::Frames> best = run_->best(); best != best_)
        best_ = std::move(best), ++version_;
    if (!run_->ended()) return;
    if (std::vector<Fault> faults = run_->faults(); !faults.empty()) {
        (void)lost_clips();  // one that has gone meanwhile may be the reason
        return fail(std::move(faults));
    }
    found_ = run_->take();
    if (found_) found_->seconds = now - began_;
    best_.reset();
    asked_.reset();
    end_run();
    ++version_;
}

void Fitting::take() {
    if (!found_ || std::exchange(taken_, true)) return;
    const FitFound& found = *found_;
    const bool moved = !same_tools(found.tuned.scene, found.start.scene);
    const bool tools = !moved || same_tools(found.start.scene, document_.scene());
    bool kept_locked = false;
    const std::uint64_t before = document::newest_step(document_);
    document_.change(found.result ? "Fit" : "Take proposal", [&](document::Content& content) {
        for (const match::FreeParameter& p : found.parameters)
            if (locked(p.key))
                kept_locked = true;
            else if (const double value = p.get(found.tuned); value != p.get(found.start))
                p.set(content, value);
        std::vector<std::string> colors = match::different_colors(found.start, found.tuned);
        kept_locked |= std::erase_if(colors, [this](const std::string& key) { return locked(key); }) > 0;
        match::take_colors(content, found.tuned, colors);
        if (!moved || !tools) return;
        content.scene.events = found.tuned.scene.events;
        content.scene.curves.emission = found.tuned.scene.curves.emission;
    });
    taken_step_ =
        document::newest_step(document_) != before ? document::WatchedStep(document_) : document::WatchedStep();
    if (!tools)
        notices_.add({.kind = ui::ToastKind::warning,
                      .text = "The scene has changed since: its tools stay as they are, the parameters are taken"});
    if (kept_locked) notices_.add({.text = "What has been locked since stays as it is"});
    ++version_;
}

}  // namespace lapfx::app
