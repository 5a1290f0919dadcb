#include "app/editor.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <tuple>

#include "app/amounts.h"
#include "app/autosave.h"
#include "app/browser.h"
#include "app/exports.h"
#include "app/file_previews.h"
#include "app/files.h"
#include "app/hot_reload.h"
#include "app/keying_bench.h"
#include "app/layouts.h"
#include "app/meter.h"
#include "app/open.h"
#include "app/orbit.h"
#include "app/organ_choice.h"
#include "app/reference.h"
#include "app/settings.h"
#include "app/snapshots.h"
#include "app/tuning.h"

namespace lapfx::app {

namespace {

/// A folder that hangs must not be waited for, not even at the end. Throws std::system_error: there are too many
/// threads.
void run_beside(std::function<void()> work) {
    std::thread(std::move(work)).detach();
}

constexpr double still_longest = 0.5;  // s; a frame that took longer (a stopped process) does not make time jump

}  // namespace

Editor::Editor(ui::ImageStore& image_store, EditorOptions options)
    : preview({.clip_folders = options.clip_folders, .wait_for_clips = options.exact}, jobs, std::move(options.early)),
      file_dialog(options.files != nullptr ? *options.files : ui::system_files(),
                  options.exact ? ui::RunBeside() : run_beside),
      images(image_store),
      options_(std::move(options)),
      settings_(std::make_unique<Settings>(options_.folders)),
      tuning_(std::make_unique<Tuning>(*this)),
      snapshots_(std::make_unique<Snapshots>(*this)),
      amounts_(std::make_unique<AmountsOverTime>(*this)),
      autosave_(std::make_unique<Autosave>(*this)),
      layouts_(std::make_unique<Layouts>()),
      browser_(std::make_unique<Browser>(*this)),
      keying_(std::make_unique<KeyingBench>(*this)),
      organ_choice_(std::make_unique<OrganChoice>(*this)),
      reference_(std::make_unique<Reference>(*this)),
      exports_(std::make_unique<Exports>(*this)),
      file_previews_(std::make_unique<FilePreviews>(*this)),
      files_(std::make_unique<Files>(*this)),
      hot_reload_(std::make_unique<HotReload>(*this)),
      meter_(std::make_unique<Meter>()) {
    timeline.loop = true;
    file_dialog.show_pictures(file_previews_.get());
    document.set_clip_folders(options_.clip_folders);
}

Editor::~Editor() = default;

void Editor::set_ui(ui::Ui& ui) {
    if (ui_ == &ui) return;
    ui_ = &ui;
    jobs.set_wake([&ui] { ui.wake("job"); });
    reference_->set_wake([&ui] { ui.wake("reference"); });
}

void Editor::open(const std::vector<std::string>& files) {
    if (files.size() == 1 && is_organ_name(files.front())) return open_organ(files.front());
    if (!files_->ready_to_open(files)) return;
    Opened opened{.content = document.content(),
                  .scene_file = document.scene_file(),
                  .preset_file = document.preset_file(),
                  .warnings = {}};
    try {
        open_files(opened, files);
    } catch (const Error& error) {
        settings_->forget_missing(files);
        return tell(error);
    }
    files_->put(std::move(opened), files);
}

void Editor::bring(const std::vector<std::string>& files) {
    std::vector<std::string> documents, organs, videos;
    for (const std::string& file : files) {
        const bool written = is_document_name(file);
        std::vector<std::string>& kind = written ? documents : is_organ_name(file) ? organs : videos;
        try {
            if (&kind == &videos) kind_of(file);  // throws where it is neither a video nor a picture
            kind.push_back(file);
        } catch (const Error& error) {
            tell(error);
        }
    }
    if (!documents.empty()) open(documents);
    if (!organs.empty()) open_organ(organs.front());
    if (organs.size() > 1)
        toasts.add({.kind = ui::ToastKind::warning, .text = "A scene has one organ: the first of them is opened"});
    if (!videos.empty()) files_->ask_use(videos);
}

void Editor::open_organ(const std::filesystem::path& file) {
    organ_choice_->open(file);
}

void Editor::ask_file(ui::FileRequest request, std::function<void(const std::vector<std::string>&)> then) {
    // Each kind of file has its own place: organs lie elsewhere than presets.
    if (request.folder.empty())
        request.folder = request.task == ui::FileTask::save ? own_folder(request.title).string()
                                                            : settings_->last_folder(request.title);
    file_asked_ = [this, title = request.title, folder = request.task == ui::FileTask::folder,
                   then = std::move(then)](const std::vector<std::string>& chosen) {
        if (!chosen.empty()) settings_->note_folder(title, folder ? chosen.front() : ui::parent_of(chosen.front()));
        then(chosen);
    };
    file_dialog.open(*ui_, std::move(request));
}

std::filesystem::path Editor::own_folder(const std::string& title, const std::filesystem::path& beside) const {
    for (const std::filesystem::path& folder :
         {std::filesystem::path(settings_->last_folder(title)), beside, options_.folders.documents})
        if (files_->takes_files(folder)) return folder;
    return (options_.files != nullptr ? *options_.files : ui::system_files()).home();
}

void Editor::build_file_dialog() {
    const auto chosen = file_dialog.build(*ui_);
    if (!chosen || !file_asked_) return;
    const auto then = std::exchange(file_asked_, nullptr);
    then(*chosen);
}

void Editor::forget_document(bool scene_too) {
    hold.cancel(*this);
    eyedropper = {};
    clip = 0;
    keying_->shelf.cancel_work();
    keying_->shelf.forget_refused();
    keying_->cancel_suggesting();
    keying_->cancel_finding_source();
    keying_->forget_suggestion();
    snapshots_->forget_before();
    if (!scene_too) return;
    reference_->give_up_choosing();
    selected.clear();
    looking.camera = document.scene().camera;
    timeline.has_range = false;
    seek(timeline.time);
}

void Editor::tell(const std::vector<Fault>& faults) {
    for (const Fault& fault : faults) toasts.add({.kind = ui::ToastKind::error, .text = fault.text()});
    autosave_->soon();
}

double Editor::duration() const {
    return document.scene().duration;
}

void Editor::seek(double time) {
    timeline.time = std::clamp(time, 0.0, duration());
}

Shot Editor::shot() const {
    SceneCamera camera = document.scene().camera;
    if (!looking.endoscope) {
        // The lamp is at the camera: nearer than the scene's the picture would burn out, and an endoscope turns it
        // down, too.
        const double nearer = nearness(camera, looking.camera);
        const double exposure = camera.exposure * std::clamp(nearer * nearer, 0.05, 4.0);
        camera = looking.camera;
        camera.exposure = exposure;
        camera.vignette = 0;
    }
    return {.time = timeline.time, .camera = camera, .overlay = looking.overlay, .scale = scene_scale()};
}

/// A tool in the hand needs time, and may be held beyond the end; else play goes round, or stops.
void Editor::advance(double seconds) {
    if (!playing()) return;
    double time = timeline.time + timeline.speed * seconds;
    const double begin = timeline.has_range ? timeline.range.low : 0;
    const double end = timeline.has_range ? timeline.range.high : duration();
    if (!preview.tool_on() && (time >= end || time < begin)) {
        if (timeline.loop && end > begin) {
            time = begin + std::fmod(std::fmod(time - begin, end - begin) + (end - begin), end - begin);
        } else {
            time = std::clamp(time, begin, end);
            timeline.speed = 0;
        }
    }
    timeline.time = time;
}

/// A widget that went away in the middle of its gesture reports nothing more.
void Editor::tidy_gesture() {
    if (!document.in_gesture() || ui_ == nullptr) return;
    if (ui_->held() == 0 && ui_->focus() == 0) document.commit();
}

/// Places among the events mean others once there are more or fewer, unless whoever made them so has selected anew.
void Editor::tidy_selection() {
    const std::size_t count = document.scene().events.size();
    if (std::exchange(events_before_, count) != count && selected == selected_before_) selected.clear();
    std::erase_if(selected, [&](std::size_t i) { return i >= count; });
    selected_before_ = selected;
}

/// The field that wanted a colour is not shown any more.
void Editor::tidy_eyedropper() {
    if (std::exchange(picked_before_, eyedropper.picked.has_value()) && eyedropper.picked) eyedropper = {};
}

void Editor::update(double now) {
    if (options_.exact) jobs.finish();
    jobs.take();
    if (now_ >= 0) advance(std::clamp(now - now_, 0.0, still_longest));
    now_ = now;
    const bool held = ui_ != nullptr && ui_->held() != 0;
    if (held && playing()) touch(now);  // also while the pointer rests: the next movement is to be seen at once
    hold.update(*this, held);
    tidy_gesture();
    tidy_selection();
    tidy_eyedropper();
    if (!preview.tool_on()) timeline.time = std::clamp(timeline.time, 0.0, duration());
    settings_->update(*this, now);
    if (!options_.exact) autosave_->update(now);
    amounts_->update(now);
    browser_->update(now);
    keying_->update(now);
    reference_->update(now);
    exports_->update(now);
    file_previews_->update();
    hot_reload_->update(now);
    if (options_.exact) return;  // pictures of the editor do not depend on the machine
    if (const auto fault = preview.check_driver(now)) {
        tell({*fault});
        autosave_->update(now);
    }
}

bool Editor::draw_pictures() {
    const bool compared = reference_->draw();
    // What nobody sees is not drawn, as long as something is: amounts follow what was drawn last.
    if (reference_->compares() && !layouts_->seen("View")) return compared;
    return preview.draw(shot()) || compared;
}

/// Following the document may bring what the panels just built knew nothing of: the first picture, a fault, something
/// that loads.
void Editor::follow() {
    const auto told = [this] {
        return std::tuple(preview.picture(), preview.loading().has_value(), preview.preset_faults().size(),
                          preview.organ_faults().size());
    };
    const auto before = told();
    preview.follow(document);
    if (told() != before && ui_ != nullptr) ui_->wake("the preview");
}

double Editor::clock() const {
    if (options_.clock) return options_.clock();
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool Editor::draw() {
    follow();
    return options_.exact ? draw_pictures() : draw_in_turn();
}

bool Editor::draw_in_turn() {
    const bool working = pace_.touched(now_);
    if (!working && options_.software) pace_.expect(meter_->scene.seconds());
    if (!pace_.due(now_)) {
        if (ui_ != nullptr) ui_->wake("the scene's turn");
        return false;
    }
    const double begin = clock();
    meter_->scene.begin();
    const bool drawn = draw_pictures();
    meter_->scene.end();
    meter_->frame(now_, playing(), drawn);
    if (!drawn) {
        pace_.left_out(now_);
        return false;
    }
    // Without a GPU the work is done where it is waited for: here, so that it is known, and not in what the panels
    // draw.
    if (working && options_.software) glFinish();
    pace_.drawn(now_, now_ + clock() - begin);
    return true;
}

bool Editor::wants_frame() const {
    return playing() || preview.tool_on() || preview.late() || exports_->running();
}

}  // namespace lapfx::app
