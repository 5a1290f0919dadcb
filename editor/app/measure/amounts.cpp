#include "app/measure/amounts.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#include "app/preview/preview_host.h"
#include "lapfx/authoring/compare.h"

namespace lapfx::app {

namespace {

constexpr double look_again = 0.05;   // s
constexpr double sample_time = 0.05;  // s, within the counts below
constexpr double fewest = 60, most = 600;

/// Whether the amounts of both are the same, as far as the tables know.
bool same_amounts(const document::Content& a, const document::Content& b) {
    const unsigned differ =
        difference(scene_table(), &a.scene, &b.scene) | difference(preset_table(), &a.preset, &b.preset);
    return (differ & redo::amounts) == 0 && a.scene.folder == b.scene.folder;
}

}  // namespace

void AmountSeries::add(double time, const Amounts& amounts) {
    times.push_back(time);
    for (std::size_t i = 0; i < values.size(); ++i) values[i].push_back(plotted_amounts[i].member.of(amounts));
}

/// Kept from job to job, so that what has not changed is not worked out again. A job that was cancelled may still use
/// it for a moment.
struct AmountsOverTime::Model {
    /// Frees its memory, also the organ, which nobody else may need. False while a job uses it. UI thread.
    bool let_go() {
        const std::unique_lock lock(mutex, std::try_to_lock);
        if (!lock) return false;
        model.reset(), organ.reset();
        return true;
    }

    std::mutex mutex;
    std::shared_ptr<const PreparedOrgan> organ;  // what it was made of
    glm::dvec3 gravity{0.0};
    std::optional<AmountsModel> model;

    AmountsModel& of(const std::shared_ptr<const PreparedOrgan>& wanted, const glm::dvec3& down) {
        if (model && wanted == organ && down == gravity) return *model;
        model.reset();
        model.emplace(wanted, AmountsOptions{.gravity = down});
        organ = wanted;
        gravity = down;
        return *model;
    }
};

AmountsOverTime::AmountsOverTime(const document::Document& document, const PreviewHost& preview, Jobs& jobs, bool exact)
    : document_(document), preview_(preview), jobs_(jobs), exact_(exact), model_(std::make_shared<Model>()) {}
AmountsOverTime::~AmountsOverTime() {
    if (job_) job_->cancel();
}

bool AmountsOverTime::stale() const {
    return followed_ != document_.version() || known_ != wanted_content_;
}

void AmountsOverTime::update(double now) {
    due_ = Settling::never;
    if (job_ && job_->cancelled()) {  // the list of jobs can cancel it: it starts again when something changes
        job_.reset();
        known_ = asked_;
        stopped_ = true;
        ++version_;
    }
    if (std::exchange(wanted_, false)) {
        held_ = true;
        follow(now);
    } else if (held_ && !job_) {  // nobody looks any more: the results stay, the model goes
        held_ = !model_->let_go();
    }
}

void AmountsOverTime::follow(double now) {
    const std::uint64_t organ = preview_.organ_version();
    if (followed_ != document_.version() || organ_ != organ) {
        const bool may_differ = (document_.changes_since(followed_) & redo::amounts) != 0;
        const auto differ = [&] { return !of_ || !same_amounts(*of_, document_.content()); };
        if (wanted_content_ == 0 || organ_ != organ || (may_differ && differ()))
            ++wanted_content_, settling_.change(now);
        followed_ = document_.version(), organ_ = organ;
    }
    if (wanted_content_ == known_ || (job_ && asked_ == wanted_content_)) return;
    if (job_) job_->cancel(), job_.reset();
    const bool settled = scene_ == nullptr || exact_ || settling_.due_at(now);
    if (settled)
        start();
    else
        due_ = settling_.due();
    if (settled && !job_ && known_ != wanted_content_) due_ = now + look_again;  // the organ is still being loaded
}

/// The organ is still being loaded, or the preview knows why it cannot be.
void AmountsOverTime::without_organ() {
    const std::vector<Fault>& faults = preview_.organ_faults();
    if (preview_.loading() || faults.empty()) return;
    known_ = asked_, scene_.reset(), ++version_;
    faults_ = faults;
}

void AmountsOverTime::start() {
    asked_ = wanted_content_, of_.reset();
    stopped_ = false;
    const Scene& scene = document_.scene();
    if (scene.organ.file.empty()) {
        known_ = asked_, scene_.reset(), faults_.clear(), ++version_;
        return;
    }
    const std::shared_ptr<const PreparedOrgan> organ = preview_.organ_of(scene);
    if (organ == nullptr) return without_organ();
    of_ = std::make_shared<const document::Content>(document_.content());
    const auto work = [model = model_, of = of_, asked = asked_, organ, this](Job& job) -> Jobs::Apply {
        const std::lock_guard lock(model->mutex);
        const document::Content& content = *of;
        auto series = std::make_shared<AmountSeries>();
        if (job.cancelled()) return {};
        AmountsModel& amounts = model->of(organ, content.scene.gravity);
        amounts.set(content.preset, content.scene.events, content.scene.curves);
        const int count = static_cast<int>(std::clamp(std::ceil(content.scene.duration / sample_time), fewest, most));
        for (int i = 0; i <= count && !job.cancelled(); ++i) {
            const double time = content.scene.duration * i / count;
            series->add(time, amounts.at(time));
            job.set_progress(static_cast<double>(i) / count);
        }
        return [this, asked, series] {
            job_.reset(), faults_.clear();
            scene_ = series, known_ = asked, ++version_;
        };
    };
    job_ = jobs_.start("Amounts", work, [this, asked = asked_](const std::vector<Fault>& faults) {
        job_.reset(), scene_.reset();
        faults_ = faults, known_ = asked, ++version_;
    });
}

}  // namespace lapfx::app
