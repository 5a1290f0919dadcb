#include "app/files/exports.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "app/base/file_chooser.h"
#include "app/base/jobs.h"
#include "app/base/notices.h"
#include "app/base/screen.h"
#include "app/base/settings.h"
#include "app/files/export_command.h"
#include "app/files/export_trial.h"
#include "app/files/open.h"
#include "app/files/page_making.h"
#include "app/measure/measuring.h"
#include "app/measure/side_by_side.h"
#include "app/preview/looking.h"
#include "app/preview/preview_host.h"
#include "app/preview/timeline.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/file_guard.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/authoring/prepared_scene.h"
#include "output/files.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double step_budget = 0.03;    // s of a frame of the UI
constexpr double beside_the_ui = 1.25;  // the export does not have all of the time
constexpr glm::ivec2 thumbnail_size{320, 256};
constexpr const char* opened_here = "is a file that was opened here; choose another name";

Fault fault(std::string place, std::string reason) {
    return {.file = "", .place = std::move(place), .reason = std::move(reason)};
}

/// "Gastric banding, left" as a file is called: "gastric_banding_left".
std::string file_name(const std::string& text) {
    std::string name;
    for (const char c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            name += lower(c);
        else if (!name.empty() && name.back() != '_')
            name += '_';
    }
    while (!name.empty() && name.back() == '_') name.pop_back();
    return name.empty() ? "preset" : name;
}

}  // namespace

/// One export, from its start to its end.
struct Exports::Running {
    ExportForm form;
    Scene scene;
    Preset preset;
    output::RenderOptions options;
    output::Loaded loaded;
    std::optional<PageWanted> page_wanted;      ///< none: the frames alone
    std::shared_ptr<Job> loading;               ///< what the view does not have
    std::unique_ptr<PageMaking> making;         ///< of the page
    std::unique_ptr<output::RenderJob> render;  ///< of a bundle: its thumbnail
    std::shared_ptr<Job> copying;               ///< of a bundle
    double began = 0;

    void stop_jobs() const {
        for (const auto& job : {loading, copying})
            if (job) job->cancel();
    }
};

Exports::Exports(const Parts& parts, Open open) : parts_(parts), open_(std::move(open)) {}

Exports::~Exports() {
    if (running_) running_->stop_jobs();
}

glm::ivec2 ExportForm::px() const {
    const glm::ivec2 named = export_sizes[static_cast<std::size_t>(std::clamp(size, 0, 6))].px;
    return named.x > 0 ? named : glm::ivec2(width, height);
}

double shown_time(double time) {
    return std::floor(time * 1000 + 1e-6) / 1000;  // never beyond the end of the scene
}

void Exports::propose(OutputKind kind) {
    const document::Document& document = parts_.document;
    form.kind = static_cast<int>(kind);
    form.outside_agreed = false;
    form.at = shown_time(parts_.timeline.time);
    if (parts_.timeline.has_range) {
        form.from = shown_time(parts_.timeline.range.low);
        form.to = shown_time(parts_.timeline.range.high);
    } else {
        form.from = 0;
        form.to = shown_time(parts_.timeline.duration());
    }
    const fs::path& file = document.preset_file();
    const std::string proposed_for = file.string() + "\n" + document.preset().name;
    if (proposed_for == proposed_for_) return;
    proposed_for_ = proposed_for;
    for (const output::OutputRow& row : output::output_rows())
        form.files[static_cast<std::size_t>(row.kind)] = proposed(row.kind, row.ending);
    form.amounts_file = proposed(OutputKind::video, ".csv");
}

std::string Exports::title(OutputKind kind) {
    if (kind == OutputKind::bundle) return "Folder for the bundle";
    return "Export " + std::string(output::row_of(kind).title);
}

std::string Exports::proposed(OutputKind kind, std::string_view ending) const {
    const document::Document& document = parts_.document;
    const fs::path& file = document.preset_file().empty() ? document.scene_file() : document.preset_file();
    std::error_code error;
    const fs::path beside = file.empty() ? fs::path() : fs::weakly_canonical(document::folder_of(file), error);
    const std::string name =
        document.preset_file().empty() ? file_name(document.preset().name) : document.preset_file().stem().string();
    return (parts_.chooser.own_folder(title(kind), beside) / (name + std::string(ending))).string();
}

output::RenderOptions Exports::render_options() const {
    const ExportForm& f = form;
    output::RenderOptions options{.size = f.px(),
                                  .fps = f.fps,
                                  .overlay = f.overlay ? parts_.looking.overlay : Overlay::none,
                                  .output = f.file(),
                                  .codec = f.coded(),
                                  .quality = static_cast<output::Quality>(f.quality),
                                  .clip_folders = parts_.options.clip_folders};
    if (f.what() == OutputKind::picture) {
        options.at = f.at;
    } else {
        options.from = f.from;
        options.to = f.to;
    }
    if (f.amounts) options.amounts = f.amounts_file;
    return options;
}

int Exports::frames() const {
    if (!form.renders()) return 0;
    if (form.what() == OutputKind::picture) return 1;
    const double count = std::ceil((form.to - form.from) * form.fps - 1e-9);
    return count > 0 && count < 1e9 ? static_cast<int>(count) : 0;
}

double Exports::duration() const {
    return parts_.timeline.duration();
}

bool Exports::comparable() const {
    return parts_.reference.video() != nullptr;
}

glm::ivec2 Exports::written_px() const {
    if (!compares()) return form.px();
    return SideBySide::size_of(form.px(), parts_.reference.video()->info().size,
                               parts_.document.scene().reference.aspect);
}

bool Exports::overlaid() const {
    return parts_.looking.overlay != Overlay::none;
}

void Exports::check_preset_file(std::vector<Fault>& faults) const {
    const document::Document& document = parts_.document;
    for (const Fault& found : document.preset_faults()) faults.push_back(fault("preset", found.text()));
    const fs::path file = form.file();
    if (form.what() == OutputKind::preset) {
        if (const std::string why = why_not_replaced(FileKind::preset, file); !why.empty())
            return faults.push_back(fault("-o", why));
        std::vector<Fault> clips;
        output::preset_in(fs::absolute(file).parent_path(), document.preset(), parts_.options.clip_folders, clips);
        for (const Fault& clip : clips) faults.push_back(fault("clips", clip.place + ": " + clip.reason));
        return;
    }
    if (const std::string reason = output::check_bundle_folder(file); !reason.empty())
        faults.push_back(fault("-o", reason));
    for (std::size_t i = 0; i < document.preset().smoke.clips.size(); ++i) {
        const std::string& clip = document.preset().smoke.clips[i].file;
        const output::ClipFiles found = output::clip_files(clip, document.preset().folder, parts_.options.clip_folders);
        if (found.files.empty()) faults.push_back(fault("clips", found.fault));
    }
    if (!outside_.empty() && !form.outside_agreed)
        faults.push_back(fault("outside", "agree to copying the files from elsewhere: check \"Copy these files\""));
}

fs::path Exports::home() const {
    const document::Document& document = parts_.document;
    const fs::path& file = form.with_scene ? document.scene_file() : document.preset_file();
    return file.empty() ? fs::path() : document::folder_of(file);
}

void Exports::look_outside() {
    std::vector<output::SourceFile> found;
    if (form.what() == OutputKind::bundle) {
        const document::Document& document = parts_.document;
        const Scene* scene = form.with_scene ? &document.scene() : nullptr;
        const auto organ = scene != nullptr ? parts_.preview.organ_of(*scene) : nullptr;
        found = output::outside_files(document.preset(), scene, home(), parts_.options.clip_folders,
                                      organ ? std::span(organ->organ().files) : std::span<const fs::path>(),
                                      organ ? tool_files_of(*organ) : std::vector<fs::path>());
        std::erase_if(found, [&](const output::SourceFile& s) { return parts_.chooser.shipped(s.file); });
    }
    if (found == outside_) return;
    outside_ = std::move(found);
    form.outside_agreed = false;  // the person agreed to another list
}

/// Many widgets ask in each frame; files are looked at only when something has changed.
void Exports::look_at_form() {
    if (checked_ == form && checked_version_ == parts_.document.version() &&
        checked_organ_ == parts_.preview.organ_version() && checked_comparable_ == comparable())
        return;
    look_outside();
    checked_ = form;
    checked_version_ = parts_.document.version();
    checked_organ_ = parts_.preview.organ_version();
    checked_comparable_ = comparable();
    faults_.clear();
    replaces_ = false;
    const fs::path file = form.file();
    if (file.empty() || file.filename().empty()) {
        faults_.push_back(fault(
            "-o", form.what() == OutputKind::bundle ? "choose a name for the folder" : "choose a name for the file"));
    } else {
        const bool numbered = output::row_of(form.what()).numbered && output::is_sequence_name(file);
        const fs::path first = numbered ? output::sequence_name(file, 0) : file;
        std::error_code error;
        replaces_ = fs::exists(first, error);
        constexpr int most_looked_for = 10'000;  // the rest is asked for when it is written
        for (int i = 1; first != file && !replaces_ && i < std::min(frames(), most_looked_for); ++i)
            replaces_ = fs::exists(output::sequence_name(file, i), error);
        const fs::path folder = fs::absolute(file, error).parent_path();
        if (!fs::is_directory(folder, error))
            faults_.push_back(fault("-o", "there is no folder " + folder.string()));
        else if (!document::is_writable_folder(folder))
            faults_.push_back(fault("-o", folder.string() + " cannot be written to"));
        else if (form.renders() && (is_read(file) || is_read(first)))
            faults_.push_back(fault("-o", opened_here));
    }
    if (!form.renders()) return check_preset_file(faults_);
    if (output::kind_named(file) != form.what()) faults_.push_back(fault("-o", output::wanted_name(form.what())));
    for (Fault& found : check(render_options(), parts_.timeline.duration()))
        if (found.place != "-o") faults_.push_back(std::move(found));
    if (form.beside && !comparable())
        faults_.push_back(fault("--beside", "there is no reference: open a surgery video first"));
    else if (const std::string reason = output::size_fault(written_px()); compares() && !reason.empty())
        faults_.push_back(fault("--size", "the page with both pictures: " + reason));
    std::error_code error;
    if (form.amounts && !document::is_writable_folder(fs::absolute(form.amounts_file, error).parent_path()))
        faults_.push_back(fault("--amounts", "its folder is missing or cannot be written to"));
    else if (form.amounts && is_read(form.amounts_file))
        faults_.push_back(fault("--amounts", opened_here));
    if (parts_.document.scene().organ.file.empty()) faults_.push_back(fault("scene", "there is no organ to draw"));
    for (const Fault& found : parts_.document.preset_faults()) faults_.push_back(fault("preset", found.text()));
}

const std::vector<Fault>& Exports::faults() {
    try {
        look_at_form();
    } catch (const fs::filesystem_error& error) {  // paths that cannot even be looked at
        faults_ = {fault("-o", error.code().message())};
    }
    return faults_;
}

std::string_view Exports::fault_at(std::string_view place) {
    for (const Fault& found : faults())
        if (found.place == place) return found.reason;
    return {};
}

void Exports::start() {
    checked_version_ = 0;  // files may have come and gone
    if (!faults().empty() || waits()) return;
    if (form.what() == OutputKind::preset) return export_preset();
    trial_.reset();
    running_ = std::make_unique<Running>();
    running_->form = form;
    running_->scene = parts_.document.scene();
    running_->preset = parts_.document.preset();
    running_->options = render_options();
    running_->began = now_;
    if (!compares()) return;
    const Scene& scene = running_->scene;
    const std::string& name = running_->preset.name;
    const bool measured = parts_.measuring.found() != nullptr && !parts_.measuring.stale() && !parts_.measuring.begun();
    PageWanted& wanted = running_->page_wanted.emplace();
    wanted.video = parts_.reference.file();
    wanted.compared = {.frame = running_->options.size,
                       .duration = scene.duration,
                       .preview = name.empty() ? parts_.document.scene_file().filename().string() : name,
                       .video = wanted.video.filename().string(),
                       .reference = scene.reference};
    if (measured) wanted.found = *parts_.measuring.found();
}

/// It is small, so it is written at once, as by saving, and cannot be cancelled.
void Exports::export_preset() {
    checked_version_ = 0;
    try {
        output::export_preset(parts_.document.preset(), form.file(), parts_.options.clip_folders);
        tell_made(form, "Exported " + std::string(ui::name_of_path(form.file())));
    } catch (const Error& error) {
        parts_.notices.tell(error);
    } catch (const std::exception& error) {
        parts_.notices.tell({{.file = form.file(), .place = "", .reason = error.what()}});
    }
}

/// What the view has loaded is used; the rest is loaded by a job.
void Exports::load() {
    Running& running = *running_;
    const std::vector<fs::path>& folders = parts_.options.clip_folders;
    const output::Loaded loaded{.organ = parts_.preview.organ_of(running.scene), .clips = parts_.preview.clip_cache()};
    running.loaded.clips = loaded.clips;
    if (loaded.organ && loaded.clips->knows(running.preset, folders)) {
        running.loaded.organ = loaded.organ;
        return begin();
    }
    running.loading = parts_.jobs.start(
        "Loading for " + std::string(name()),
        [this, scene = running.scene, preset = running.preset, loaded, folders](Job& job) -> Jobs::Apply {
            const auto goes_on = [&](double share) {
                job.set_progress(share);
                return !job.cancelled();
            };
            const auto organ = loaded.organ ? loaded.organ : prepare_organ(scene, preset.vessels, goes_on);
            if (!organ || !loaded.clips->look_through(preset, folders, goes_on)) return {};
            return [this, organ] {
                running_->loading.reset();
                running_->loaded.organ = organ;
            };
        },
        [this](const std::vector<Fault>& faults) { fail(faults); });
}

void Exports::make_page() {
    Running& running = *running_;
    PageWanted wanted = *running.page_wanted;
    wanted.scene = running.scene, wanted.preset = running.preset;
    running.making = std::make_unique<PageMaking>(std::move(wanted),
                                                  PageMaking::Parts{.preview = parts_.preview,
                                                                    .jobs = parts_.jobs,
                                                                    .organ = running.loaded.organ,
                                                                    .clip_folders = parts_.options.clip_folders,
                                                                    .exact = parts_.options.exact,
                                                                    .measured_side = parts_.options.measured_side});
}

/// Outside of the UI's build. For a bundle, first its thumbnail: at the time that the view shows, through the scene's
/// camera.
void Exports::begin() {
    output::RenderOptions options = running_->options;
    if (running_->form.what() == OutputKind::bundle)
        options = {.size = thumbnail_size, .at = parts_.timeline.time, .clip_folders = parts_.options.clip_folders};
    std::unique_ptr<output::FramePage> page;
    if (running_->page_wanted) {
        if (!running_->making) make_page();
        running_->making->serve();
        page = running_->making->take();
        if (!page) return;
        running_->making.reset();
    }
    running_->began = now_;  // what came before has a progress of its own
    running_->render = std::make_unique<output::RenderJob>(running_->scene, running_->preset, std::move(options),
                                                           running_->loaded, std::move(page));
}

void Exports::begin_copying() {
    auto bundle = std::make_shared<output::Bundle>(output::Bundle{.preset = running_->preset,
                                                                  .folder = fs::absolute(running_->form.file()),
                                                                  .clip_folders = parts_.options.clip_folders,
                                                                  .thumbnail = running_->render->image()});
    if (running_->form.with_scene) bundle->scene = running_->scene;
    running_->render.reset();
    running_->copying = parts_.jobs.start(
        "Exporting " + bundle->folder.filename().string(),
        [this, bundle](Job& job) -> Jobs::Apply {
            const output::BundleContent made = write_bundle(*bundle, [&](double share) {
                job.set_progress(share);
                return !job.cancelled();
            });
            return [this, made] { end(std::to_string(made.files) + " files, " + ui::size_text(made.bytes)); };
        },
        [this](const std::vector<Fault>& faults) { fail(faults); });
}

void Exports::cancel() {
    if (!running_) return;
    running_->stop_jobs();
    parts_.notices.add({.text = "Export of " + std::string(name()) + " cancelled: nothing was written"});
    running_.reset();
}

std::string_view Exports::name() const {
    if (!running_) return {};
    const std::string_view file = running_->form.file();
    return ui::name_of_path(file);
}

double Exports::progress() const {
    if (!running_) return 0;
    if (const Job* beside = job()) return beside->progress();
    const bool bundle = running_->form.what() == OutputKind::bundle;
    return running_->render && !bundle ? running_->render->progress() : 0;
}

const Job* Exports::job() const {
    if (!running_) return nullptr;
    if (running_->making) return &running_->making->job();
    return running_->loading ? running_->loading.get() : running_->copying.get();
}

bool Exports::loading() const {
    return running_ && (running_->loading || running_->making);
}

double Exports::seconds_left() const {
    const double share = progress();
    return running_ && !loading() && share > 0.02 ? (now_ - running_->began) * (1 - share) / share : -1;
}

std::string Exports::progress_text() const {
    if (!running_) return {};
    if (running_->making) return "comparing";
    if (!running_->render && !running_->copying) return "loading";
    if (running_->form.what() == OutputKind::bundle) return running_->copying ? "copying and checking" : "thumbnail";
    const output::RenderJob& job = *running_->render;
    if (job.drawn() == job.frames()) return "reading back";
    return std::to_string(job.drawn()) + " of " + std::to_string(job.frames()) +
           (job.frames() == 1 ? " frame" : " frames");
}

void Exports::update(double now) {
    now_ = now;
    follow_estimate();
    if (!running_) return;
    if (const auto& job = running_->loading ? running_->loading : running_->copying) {
        if (job->cancelled()) cancel();  // by the list of jobs
        return;
    }
    try {
        if (!running_->loaded.organ) return load();
        if (!running_->render) return begin();
        const auto start = std::chrono::steady_clock::now();
        do {
            step();
        } while (running_ && running_->render &&
                 std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() < step_budget);
    } catch (const Error& error) {
        fail(error.faults());
    } catch (const std::exception& error) {  // no memory for a picture, an encoder that gives up
        fail({{.file = running_ ? running_->form.file() : "", .place = "", .reason = error.what()}});
    }
}

double Exports::seconds_expected() const {
    if (!trial_ || !trial_->done()) return -1;
    const auto pixels = [](glm::ivec2 size) { return static_cast<double>(size.x) * size.y; };
    return beside_the_ui * trial_->seconds(frames(), pixels(written_px()) / pixels(form.px()));
}

Exports::TriedOf Exports::tried_of() const {
    return {.px = form.px(),
            .fps = form.fps,
            .from = form.from,
            .overlay = form.overlay,
            .codec = form.codec,
            .quality = form.quality,
            .ending = fs::path(form.file()).extension().string(),
            .document = parts_.document.version(),
            .organ = parts_.preview.organ_version()};
}

double Exports::want_estimate() {
    estimate_wanted_ = true;
    if (running_ || parts_.options.exact || frames() < 2) return Settling::never;
    if (tried_of() != tried_of_) return now_;
    return !trial_ && !settling_.due_at(now_) ? settling_.due() : Settling::never;
}

/// One frame alone is there before its time could be told.
void Exports::follow_estimate() {
    const bool wanted = std::exchange(estimate_wanted_, false);
    if (!wanted || running_ || parts_.options.exact || frames() < 2 || !faults().empty()) return trial_.reset();
    if (TriedOf of = tried_of(); of != tried_of_) {
        tried_of_ = std::move(of);
        trial_.reset();
        settling_.change(now_);
        trial_failed_ = false;
    }
    if (trial_failed_ || (trial_ && trial_->done()) || !settling_.due_at(now_)) return;
    if (try_frames()) parts_.screen.wake("the time of an export is tried");
}

/// Gives whether it goes on. Where a trial fails, the export itself tells why.
bool Exports::try_frames() {
    try {
        if (!trial_) {
            const output::Loaded loaded{.organ = parts_.preview.organ_of(parts_.document.scene()),
                                        .clips = parts_.preview.clip_cache()};
            if (!loaded.organ || !loaded.clips->knows(parts_.document.preset(), parts_.options.clip_folders))
                return false;
            trial_ = std::make_unique<ExportTrial>(parts_.document.scene(), parts_.document.preset(), render_options(),
                                                   loaded);
        } else {
            trial_->step();
        }
        return true;
    } catch (const std::exception&) {
        trial_.reset();
        trial_failed_ = true;
        return false;
    }
}

void Exports::step() {
    output::RenderJob& job = *running_->render;
    job.step();
    if (!job.done()) return;
    if (running_->form.what() == OutputKind::bundle) return begin_copying();
    end(job.frames() == 1 ? "" : std::to_string(job.frames()) + " frames");
}

void Exports::end(const std::string& what) {
    const ExportForm form_was = running_->form;
    std::string text = "Exported " + std::string(name());
    if (!what.empty()) text += " (" + what + ")";
    running_.reset();
    tell_made(form_was, text);
}

/// A bundle can be opened, as it will be on another computer. Of other files the notice gives the path.
void Exports::tell_made(const ExportForm& made, const std::string& text) {
    checked_version_ = 0;
    std::error_code error;
    const fs::path path = fs::absolute(made.file(), error);
    parts_.settings.note_folder(title(made.what()), path.parent_path().string());
    ui::Toast toast{.kind = ui::ToastKind::good, .text = text + ", checked"};
    if (made.what() == OutputKind::bundle) {
        toast.action = "Open the bundle";
        const std::string name = path.filename().string() + (made.with_scene ? ".scene.json" : ".json");
        toast.act = [this, file = (path / name).string()] { open_({file}); };
    } else {
        toast.action = "Copy path";
        toast.act = [this, path = path.string()] {
            if (ui::Clipboard* clipboard = parts_.screen.clipboard()) clipboard->set(path);
        };
    }
    parts_.notices.add(std::move(toast));
}

void Exports::fail(const std::vector<Fault>& faults) {
    running_.reset();
    checked_version_ = 0;
    parts_.notices.tell(faults);
}

std::string Exports::command() const {
    return render_command(form, parts_.document, parts_.looking.overlay,
                          compares() ? parts_.reference.file() : fs::path());
}

}  // namespace lapfx::app
