#include "app/editor.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <tuple>

#include "app/base/file_chooser.h"
#include "app/base/layouts.h"
#include "app/base/saved.h"
#include "app/base/settings.h"
#include "app/browser/browser.h"
#include "app/browser/file_previews.h"
#include "app/clips/clip_shelf.h"
#include "app/clips/keying_bench.h"
#include "app/files/autosave.h"
#include "app/files/exports.h"
#include "app/files/files.h"
#include "app/files/hot_reload.h"
#include "app/files/organ_choice.h"
#include "app/measure/amounts.h"
#include "app/measure/fit_reporting.h"
#include "app/measure/fitting.h"
#include "app/measure/measure_bench.h"
#include "app/measure/measuring.h"
#include "app/measure/preview_measuring.h"
#include "app/meter.h"
#include "app/preview/seen_colors.h"
#include "app/reference/reference.h"
#include "app/tuning/snapshot_previews.h"
#include "app/tuning/snapshots.h"
#include "app/tuning/tuning.h"

namespace lapfx::app {

namespace {

constexpr double longest_step = 0.5;  // s; a frame that took longer (a stopped process) does not make time jump

}  // namespace

Editor::Editor(ui::ImageStore& image_store, EditorOptions options, std::shared_ptr<EarlyLoad> early)
    : preview({.clip_folders = options.clip_folders, .wait_for_clips = options.exact}, jobs, std::move(early)),
      hold(document, preview, timeline, selected, toasts),
      images(image_store),
      options_(std::move(options)),
      settings_(std::make_unique<Settings>(options_.folders)),
      chooser_(std::make_unique<FileChooser>(options_, *settings_, screen_)),
      saved_(std::make_unique<Saved>(document)),
      seen_colors_(std::make_unique<SeenColors>(preview, toasts)),
      tuning_(std::make_unique<Tuning>(document, *saved_, preview, *settings_, toasts)),
      snapshots_(std::make_unique<Snapshots>(document)),
      amounts_(std::make_unique<AmountsOverTime>(document, preview, jobs, options_.exact)),
      autosave_(std::make_unique<Autosave>(document, *snapshots_, toasts, options_.folders.state)),
      layouts_(std::make_unique<Layouts>()),
      browser_(std::make_unique<Browser>(options_, document, *settings_, jobs, images, toasts, screen_)),
      clips_(std::make_unique<ClipShelf>(document, preview, jobs, *settings_, images, toasts, options_.clip_folders,
                                         options_.exact)),
      keying_(std::make_unique<KeyingBench>(*clips_, document, preview, timeline, pace_, jobs, images, toasts,
                                            options_.exact)),
      organ_choice_(std::make_unique<OrganChoice>(document, jobs, *settings_, looking, selected, images)),
      snapshot_previews_(std::make_unique<SnapshotPreviews>(document, *snapshots_, preview, timeline, jobs, images,
                                                            screen_, options_)),
      reference_(std::make_unique<Reference>(document, timeline, preview, *snapshot_previews_, jobs, *settings_, images,
                                             screen_, options_)),
      measuring_(std::make_unique<Measuring>(document, *reference_, options_.measured, jobs, toasts, !options_.exact)),
      measure_bench_(
          std::make_unique<MeasureBench>(document, *reference_, *measuring_, jobs, images, toasts, options_.exact)),
      preview_measuring_(
          std::make_unique<PreviewMeasuring>(document, preview, *reference_, *measuring_, pace_, jobs, options_)),
      fitting_(std::make_unique<Fitting>(Fitting::Parts{.document = document,
                                                        .preview = preview,
                                                        .reference = *reference_,
                                                        .measuring = *measuring_,
                                                        .tuning = *tuning_,
                                                        .pace = pace_,
                                                        .jobs = jobs,
                                                        .notices = toasts,
                                                        .options = options_})),
      fit_reporting_(std::make_unique<FitReporting>(FitReporting::Parts{
          .preview = preview, .pace = pace_, .jobs = jobs, .notices = toasts, .screen = screen_, .options = options_})),
      exports_(std::make_unique<Exports>(Exports::Parts{.document = document,
                                                        .timeline = timeline,
                                                        .looking = looking,
                                                        .reference = *reference_,
                                                        .measuring = *measuring_,
                                                        .preview = preview,
                                                        .jobs = jobs,
                                                        .settings = *settings_,
                                                        .chooser = *chooser_,
                                                        .notices = toasts,
                                                        .screen = screen_,
                                                        .options = options_},
                                         [this](const std::vector<std::string>& made) { files_->open(made); })),
      files_(std::make_unique<Files>(
          Files::Parts{.document = document,
                       .selected = selected,
                       .looking = looking,
                       .autosave = *autosave_,
                       .clips = *clips_,
                       .exports = *exports_,
                       .chooser = *chooser_,
                       .layouts = *layouts_,
                       .organ_choice = *organ_choice_,
                       .reference = *reference_,
                       .settings = *settings_,
                       .snapshots = *snapshots_,
                       .commands = commands,
                       .notices = toasts,
                       .jobs = jobs,
                       .options = options_,
                       .forget_document = [this](bool scene_too) { forget_document(scene_too); }})),
      file_previews_(std::make_unique<FilePreviews>(options_, document, images, screen_)),
      hot_reload_(std::make_unique<HotReload>(document, preview, jobs, toasts, options_.data_folder)),
      meter_(std::make_unique<Meter>()) {
    chooser_->dialog().show_pictures(file_previews_.get());
    reference_->shown().set_counted([this](double time, Image* picture) { return measuring_->counted(time, picture); });
    document.set_clip_folders(options_.clip_folders);
}

Editor::~Editor() = default;

void Editor::set_ui(ui::Ui& ui) {
    if (screen_.ui() == &ui) return;
    screen_.show_on(ui);
    jobs.set_wake([&ui] { ui.wake("job"); });
    reference_->set_wake([&ui] { ui.wake("reference"); });
}

void Editor::forget_document(bool scene_too) {
    hold.cancel();
    eyedropper = {};
    clips_->selected = 0;
    clips_->play_alone({});
    clips_->cancel_work();
    clips_->forget_refused();
    keying_->cancel_suggesting();
    keying_->cancel_finding_source();
    keying_->forget_suggestion();
    snapshots_->forget_before();
    if (!scene_too) return;
    reference_->give_up_choosing();
    reference_->look().leave();
    measuring_->forget();
    preview_measuring_->forget();
    fitting_->forget();
    selected.clear();
    looking.camera = document.scene().camera;
    timeline.follow();
    timeline.seek(timeline.time);
}

Shot Editor::shot() const {
    return {.time = timeline.time,
            .camera = looking.through(document.scene().camera),
            .overlay = looking.overlay,
            .haze = looking.endoscope || clips_->alone(),  // haze is as thick as it is far: from far away it is fog
            .scale = scene_scale()};
}

/// A widget that is no longer built cannot end its gesture: it is ended here.
void Editor::tidy_gesture() {
    const ui::Ui* const ui = screen_.ui();
    if (!document.in_gesture() || ui == nullptr) return;
    if (ui->held() == 0 && ui->focus() == 0) document.commit();
}

/// When events were added or removed, the selected numbers stand for other events: nothing is selected then, unless the
/// same change also selected something.
void Editor::tidy_selection() {
    const std::size_t count = document.scene().events.size();
    if (std::exchange(events_before_, count) != count && selected == selected_before_) selected.clear();
    std::erase_if(selected, [&](std::size_t i) { return i >= count; });
    selected_before_ = selected;
}

/// A colour that was picked, and that no field has taken by the next frame, is dropped: its field is not shown any
/// more.
void Editor::tidy_eyedropper() {
    if (std::exchange(picked_before_, eyedropper.picked.has_value()) && eyedropper.picked) eyedropper = {};
}

bool Editor::frame(double now, const std::function<void()>& build, const FrameOptions& options) {
    const auto taken = [&](FrameStep step) {
        if (options.after) options.after(step);
    };
    const double passed = now_ >= 0 ? std::clamp(now - now_, 0.0, longest_step) : 0;
    now_ = now;

    // 1. Update: all that has happened since the last frame, before the panels show it.
    // Results of jobs come first: everything below works with them.
    if (options_.exact) jobs.finish();
    jobs.take();
    // Time goes on, but not before the first organ is there. Then the tool, which works until that time, and may end
    // there with an undo step.
    timeline.follow();
    const bool nothing_to_see = !preview.ready() && preview.loading().has_value();
    if (!nothing_to_see) timeline.advance(passed, preview.tool_on());
    use_tool();
    // After the tool: its step must not be left open, and has selected its events.
    tidy_gesture();
    tidy_selection();
    tidy_eyedropper();
    if (!preview.tool_on()) timeline.seek(timeline.time);  // an undo may have made the scene shorter
    // These start jobs. With `exact` clips_ waits for all jobs, so the two stand before it.
    amounts_->update(now);
    browser_->update(now);
    // The bench shows one of the clips, so they come first; it and the reference go by the time of above.
    clips_->update(now);
    keying_->update(now);
    snapshot_previews_->update();
    reference_->update(now);
    // What is measured in the frame that the reference shows.
    measuring_->update(now);
    measure_bench_->update();
    // An export, the measuring of the preview, a fit and its report draw pictures; the parts that are quick are done by
    // now. Nothing depends on previews of files.
    exports_->update(now);
    preview_measuring_->update(now);
    fitting_->update(now);
    fit_reporting_->update(now);
    file_previews_->update();
    // What has changed on disk is in the document before the panels show it.
    hot_reload_->update(now);
    // The driver is asked after all that has used it.
    check_driver(now);
    // Last, so that they keep all that was changed above; autosave also looks for faults that were told.
    settings_->update(now);
    if (!options_.exact) autosave_->update(now);
    taken(FrameStep::updated);

    // 2. The panels, with the events that have come: a person changes the document here.
    build();
    taken(FrameStep::built);
    if (!options.visible) return false;

    // 3. The preview takes those changes, so that a picture is never a frame behind its panel.
    follow();
    taken(FrameStep::followed);

    // 4. Pictures, into the textures that the list of the panels shows; the window draws that list next.
    const bool changed = options_.exact ? draw_pictures() : draw_in_turn();
    taken(FrameStep::drawn);
    return changed;
}

void Editor::use_tool() {
    const bool held = screen_.held();
    if (held && timeline.playing())
        touch(now_);  // also while the pointer rests: the next movement is to be seen at once
    hold.update(held);
}

/// Pictures of the editor do not depend on the machine: with `exact` nobody looks.
void Editor::check_driver(double now) {
    if (options_.exact) return;
    if (const auto fault = preview.check_driver(now)) toasts.tell({*fault});
}

bool Editor::draw_pictures() {
    const bool compared = snapshot_previews_->draw() | reference_->draw(scene_scale());
    // The view is not drawn while it is hidden and the comparison is drawn: amounts follow the picture drawn last.
    if (reference_->comparison().wanted() && !layouts_->seen("View")) return compared;
    return preview.draw(shot()) || compared;
}

/// This may bring what the panels that were just built could not show: the first picture, a fault, something that is
/// being loaded. Then another frame is wanted.
void Editor::follow() {
    const auto told = [this] {
        return std::tuple(preview.picture(), preview.loading().has_value(), preview.preset_faults().size(),
                          preview.organ_faults().size());
    };
    const auto before = told();
    preview.play_alone(clips_->alone());
    preview.follow(document);
    if (told() != before) screen_.wake("the preview");
    snapshot_previews_->follow();  // it shares the organ
}

double Editor::clock() const {
    if (options_.clock) return options_.clock();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool Editor::draw_in_turn() {
    const bool working = pace_.touched(now_);
    if (!working && options_.software) pace_.expect(meter_->scene.seconds());
    if (!pace_.due(now_)) {
        screen_.wake_at(pace_.due_at(now_), "the scene's turn");
        return false;
    }
    const double begin = clock();
    meter_->scene.begin();
    const bool drawn = draw_pictures();
    meter_->scene.end();
    meter_->frame(now_, timeline.playing(), drawn);
    if (!drawn) {
        pace_.left_out(now_);
        return false;
    }
    // Without a GPU the work is done when it is waited for. Waiting here makes its cost known, and keeps it out of the
    // drawing of the panels.
    if (working && options_.software) glFinish();
    pace_.drawn(now_, now_ + clock() - begin);
    return true;
}

bool Editor::wants_frame() const {
    return timeline.playing() || preview.tool_on() || preview.late() || snapshot_previews_->late() ||
           exports_->running();
}

}  // namespace lapfx::app
