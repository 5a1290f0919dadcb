#include "app/preview/preview_host.h"

#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "app/base/paths.h"
#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/clip_roles.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/prepared_scene.h"

namespace lapfx::app {

namespace {

bool same_camera(const SceneCamera& a, const SceneCamera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up && a.field_of_view == b.field_of_view &&
           a.response() == b.response();
}

/// The name says what the organ is loaded from.
std::string organ_name(const Scene& scene) {
    return std::filesystem::path(scene.plate.use ? scene.reference.file : scene.organ.file).filename().string();
}

/// Leaves out what the other clips show, and what other roles show without a clip, such as an even haze.
void leave_alone(SmokeParameters& smoke, const std::optional<std::size_t>& clip) {
    if (!clip || *clip >= smoke.clips.size()) return;
    for (std::size_t i = 0; i < smoke.clips.size(); ++i)
        if (i != *clip) smoke.clips[i].weight = 0;
    for (const ClipRoleRow& row : clip_roles)
        if (row.role != smoke.clips[*clip].role) row.leave_out(smoke);
}

}  // namespace

PreviewHost::PreviewHost(const PreviewOptions& options, Jobs& jobs, std::shared_ptr<EarlyLoad> early)
    : options_(options), jobs_(jobs), early_(std::move(early)) {
    options_.clip_cache = early_ ? early_->clips : std::make_shared<ClipCache>();
}
PreviewHost::~PreviewHost() = default;

ui::ImageHandle PreviewHost::picture() const {
    return preview_ ? target_.texture() : 0;
}

glm::ivec2 PreviewHost::size() const {
    return target_.size();
}

// --- following -------------------------------------------------------------------------------------------------------

void PreviewHost::follow(const document::Document& document) {
    if (tool_.on()) return;
    if ((organ_job_ && organ_job_->cancelled()) || (clips_job_ && clips_job_->cancelled())) cancel_loading();
    if (document.version() != followed_ || wanted_alone_ != alone_) {
        if (document.scene_changes_since(followed_) != 0) wanted_.scene = document.scene();
        const unsigned changed = document.preset_changes_since(followed_);
        if (changed != 0 || wanted_alone_ != alone_) take_preset(document, changed);
        followed_ = document.version();
        stale_ = true;
    }
    // What jobs bring makes it stale again: in exact mode all of it is waited for, else there is one turn.
    do {
        if (!std::exchange(stale_, false)) return;
        if (!asked_scene_ || !same_organ(*asked_scene_, wanted_.scene)) {
            const bool shown = asked_scene_ && preview_ && organ_of(wanted_.scene);
            asked_scene_ = wanted_.scene;
            shown ? keep_organ() : load_organ();
        }
        // One that cannot be shown, for a gravity without direction, waits until the scene is another one.
        if (ready_organ_ && show(ready_organ_)) ready_organ_ = nullptr;
        follow_preset();
        follow_scene();
        if (options_.wait_for_clips) jobs_.finish();
    } while (options_.wait_for_clips);
}

/// The one copy of it. What is shown until then stays known: the two change places.
void PreviewHost::take_preset(const document::Document& document, unsigned changed) {
    if (std::exchange(shows_wanted_, false)) {
        std::swap(good_, wanted_.preset);
        if (!preset_due_) differ_ = 0;
    }
    wanted_.preset = document.preset();
    wanted_faults_ = document.preset_faults();
    leave_alone(wanted_.preset.smoke, alone_);
    // While one clip smokes alone, the document does not know what differs.
    if (alone_ || wanted_alone_) changed |= redo::clips;
    wanted_alone_ = alone_;
    if (differ_) *differ_ |= changed;
    preset_due_ = true;
}

/// The one that is shown is wanted again: what is on its way is not.
void PreviewHost::keep_organ() {
    if (organ_job_) std::exchange(organ_job_, nullptr)->cancel();
    ready_organ_ = nullptr;
    organ_files_ = files_of(*organ_);
    organ_faults_.clear();
    scene_fault_ = false;
    ++organ_version_;
}

void PreviewHost::load_organ() {
    if (organ_job_) organ_job_->cancel();
    // A document without an organ, which an editor begins with, is not the one that it was for.
    std::shared_ptr<EarlyLoad> early = organ_name(wanted_.scene).empty() ? nullptr : std::exchange(early_, nullptr);
    const bool in_time = early && same_organ(early->scene, wanted_.scene);
    if (early && !in_time) early->stopped = true;  // the job keeps it until it has ended
    ready_organ_ = nullptr;
    organ_files_.clear();
    organ_faults_.clear();  // of the one before: who waits for this one would take them for its own
    scene_fault_ = false;
    const auto work = [content = wanted_, early, in_time, options = options_, this](Job& job) -> Jobs::Apply {
        const auto tell = [&](double share) {
            job.set_progress(share);
            return !job.cancelled();
        };
        auto organ = in_time ? wait_for(*early, job) : prepare_organ(content.scene, content.preset.vessels, tell);
        if (!organ || !options.clip_cache->look_through(content.preset, options.clip_folders,
                                                        [&](double) { return !job.cancelled(); }))
            return {};
        return [this, organ] {
            organ_job_ = nullptr;
            ready_organ_ = organ;
            stale_ = true;
        };
    };
    const auto failed = [this](const std::vector<Fault>& faults) {
        organ_job_ = nullptr;
        organ_faults_ = faults;
        scene_fault_ = false;
        ++organ_version_;
    };
    organ_job_ = jobs_.start("Loading " + organ_name(wanted_.scene), work, failed);
}

/// The organ that was waited for. What is wrong with the preset or with its clips keeps no organ from being shown.
bool PreviewHost::show(const std::shared_ptr<const PreparedOrgan>& organ) {
    changed_ = true;
    const auto make = [&](const Preset& preset) {
        try {
            preview_ = std::make_unique<Preview>(wanted_.scene, preset, organ, options_);
            clips_shown_ = false;
            glReleaseShaderCompiler();  // a software renderer's is large
            organ_faults_.clear();
            scene_fault_ = false;
            return true;
        } catch (const Error& error) {
            organ_faults_ = error.faults();
            return false;
        }
    };
    organ_files_ = files_of(*organ);
    const Preset whole = document::mended(wanted_.preset, shown_preset());
    Preset bare = whole;
    bare.smoke.clips.clear();
    const bool known = options_.clip_cache->knows(whole, options_.clip_folders);
    if (!(known && make(whole)) && !make(bare)) return false;
    organ_ = organ;
    ++organ_version_;
    overlay_ = options_.overlay;
    shown_scene_ = wanted_.scene;
    examine_again();  // clips that were not there yet, and what is wrong with the preset
    return true;
}

void PreviewHost::examine_again() {
    preset_due_ = true;
    differ_.reset();
}

void PreviewHost::follow_preset() {
    if (!preview_ || !std::exchange(preset_due_, false)) return;
    std::optional<unsigned> differ = std::exchange(differ_, std::nullopt);
    if (differ && (*differ & redo::clips) != 0) {  // a document that was opened again says that all may differ
        differ = difference(preset_table(), &good_, &wanted_.preset);
        if (good_.folder != wanted_.preset.folder) *differ |= redo::clips;
    }
    if (differ == 0U) {
        shows_wanted_ = true;
        return;
    }
    changed_ = true;
    const bool whole = wanted_faults_.empty();
    if (whole && clips_shown_ && differ && (*differ & redo::clips) == 0) return show_wanted(*differ);
    // One value that cannot be shown keeps no other from being seen.
    Preset mended;
    if (!whole) mended = document::mended(wanted_.preset, shown_preset());
    const Preset& preset = whole ? wanted_.preset : mended;
    if (!options_.clip_cache->knows(preset, options_.clip_folders)) {
        look_through_clips();
        return show_parameters(preset);
    }
    if (clips_job_) std::exchange(clips_job_, nullptr)->cancel();
    try {
        preview_->set_preset(preset);
        if (!whole) good_ = std::move(mended);
        shows_wanted_ = clips_shown_ = whole;
        preset_faults_ = wanted_faults_;
    } catch (const Error& error) {
        clips_shown_ = false;
        preset_faults_ = error.faults();
        show_parameters(preset);
    }
}

/// A move of a slider: the preview is told what differs, and nothing is copied or compared.
void PreviewHost::show_wanted(unsigned changed) {
    try {
        preview_->set_parameters(wanted_.preset, changed);
        shows_wanted_ = true;
        preset_faults_.clear();
    } catch (const Error& error) {
        preset_faults_ = error.faults();
    }
}

/// Those clips that play, whichever `preset` has, continue; everything else changes at once.
void PreviewHost::show_parameters(const Preset& preset) {
    try {
        preview_->set_parameters(preset);
        Preset shown = preset;
        shown.folder = shown_preset().folder;
        shown.smoke.clips = shown_preset().smoke.clips;
        good_ = std::move(shown);
        shows_wanted_ = false;
        if (clips_job_) preset_faults_ = wanted_faults_;
    } catch (const Error& error) {
        preset_faults_ = error.faults();
    }
}

void PreviewHost::look_through_clips() {
    clips_shown_ = false;
    std::vector<std::filesystem::path> files = clip_files(wanted_.preset);
    if (clips_job_ && files == opening_) return;
    if (clips_job_) clips_job_->cancel();
    opening_ = std::move(files);
    const auto work = [preset = wanted_.preset, options = options_, this](Job& job) -> Jobs::Apply {
        options.clip_cache->look_through(preset, options.clip_folders, [&](double share) {
            job.set_progress(share);
            return !job.cancelled();
        });
        return [this] {
            clips_job_ = nullptr;
            examine_again();
            stale_ = true;
        };
    };
    const auto failed = [this](const std::vector<Fault>& faults) {
        clips_job_ = nullptr;
        preset_faults_ = faults;
    };
    clips_job_ = jobs_.start("Opening clips", work, failed);
}

void PreviewHost::follow_scene() {
    const Scene& scene = wanted_.scene;
    if (!preview_ || !preview_->takes(scene)) return;  // its organ is on its way
    if (shown_scene_ && equal(scene_table(), &scene, &*shown_scene_)) return;
    shown_scene_ = scene;
    changed_ = true;
    try {
        preview_->set_scene(scene);
        if (std::exchange(scene_fault_, false)) organ_faults_.clear();
    } catch (const Error& error) {
        organ_faults_ = error.faults();
        scene_fault_ = true;
    }
}

// --- loading ---------------------------------------------------------------------------------------------------------

std::optional<Loading> PreviewHost::loading() const {
    const std::shared_ptr<Job>& job = organ_job_ ? organ_job_ : clips_job_;
    if (!job) return std::nullopt;
    return Loading{
        .name = organ_job_ ? organ_name(wanted_.scene) : "clips", .progress = job->progress(), .job = job.get()};
}

void PreviewHost::cancel_loading() {
    if (organ_job_) {
        std::exchange(organ_job_, nullptr)->cancel();
        organ_faults_ = {{.file = organ_name(wanted_.scene),
                          .place = "",
                          .reason = "loading was cancelled; Reload from disk loads it again"}};
        ++organ_version_;
    }
    if (clips_job_) {
        std::exchange(clips_job_, nullptr)->cancel();
        preset_faults_ = {{.file = "",
                           .place = "/smoke/clips",
                           .reason = "opening was cancelled; Reload from disk opens them again"}};
    }
}

void PreviewHost::reload_clips(const std::vector<std::filesystem::path>& changed) {
    for (const std::filesystem::path& path : changed) options_.clip_cache->forget(path);
    if (changed.empty()) options_.clip_cache->forget();
    examine_again();
    stale_ = true;
}

void PreviewHost::reload_organ() {
    asked_scene_.reset();
    stale_ = true;
}

void PreviewHost::reload_shaders(const std::filesystem::path& folder) {
    if (!preview_) return;
    preview_->reload_shaders(folder);
    changed_ = true;
}

std::vector<std::filesystem::path> PreviewHost::clip_files(const Preset& preset) const {
    return clip_places(preset, options_.clip_folders);
}

std::vector<std::filesystem::path> PreviewHost::organ_files(const Scene& scene) const {
    std::vector<std::filesystem::path> files = organ_files_;
    for (const std::string& file : {scene.organ.file, scene.organ.texture, scene.tool.file})
        if (std::filesystem::path path = path_from(scene.folder, file); !path.empty()) files.push_back(std::move(path));
    for (std::filesystem::path& file : files) file = std::filesystem::absolute(file).lexically_normal();
    std::sort(files.begin(), files.end());
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
}

std::shared_ptr<const PreparedOrgan> PreviewHost::organ_of(const Scene& scene) const {
    return organ_ && made_for(*organ_, scene) ? organ_ : nullptr;
}

MemoryUse PreviewHost::memory_use() const {
    MemoryUse use = preview_ ? preview_->memory_use() : MemoryUse{};
    use.targets += target_.memory() + small_.memory() + tried_.memory();
    return use;
}

// --- drawing ---------------------------------------------------------------------------------------------------------

void PreviewHost::resize(glm::ivec2 size) {
    size = glm::clamp(size, glm::ivec2(0), glm::ivec2(8192));
    if (size == target_.size() || size.x < 1 || size.y < 1) return;
    target_.resize(size);
    changed_ = true;
    pixels_known_ = false;
}

bool PreviewHost::draw(const Shot& shot) {
    const bool drawn = draw_into(target_, shot, last_, drawn_);
    if (drawn) pixels_known_ = false;
    return drawn;
}

const Image& PreviewHost::pixels() {
    if (!std::exchange(pixels_known_, true)) {
        target_.read(pixels_);
        ++read_back_;
    }
    return pixels_;
}

bool PreviewHost::draw_into(PreviewCopy& copy, const Shot& shot) {
    return draw_into(copy.target, shot, copy.shot, copy.revision);
}

bool PreviewHost::draw_into(const Target& target, const Shot& wanted, Shot& last, std::uint64_t& drawn) {
    if (!preview_ || driver_.lost() || target.texture() == 0) return false;
    // The camera that is set may already be that of the organ on its way.
    Shot shot = wanted;
    if (organ_job_ && drawn != 0) shot.camera = last.camera;
    if (std::exchange(changed_, false)) ++revision_;
    const bool same = shot.time == last.time && same_camera(shot.camera, last.camera) && shot.overlay == last.overlay &&
                      shot.haze == last.haze && shot.scale <= last.scale;
    if (same && drawn == revision_ && !tool_.on() && !late()) return false;
    if (std::exchange(overlay_, shot.overlay) != shot.overlay) preview_->set_overlay(shot.overlay);
    preview_->set_camera(shot.camera);
    preview_->set_haze_shown(shot.haze);
    if (shot.scale < 1)
        draw_stretched(target, shot);
    else
        preview_->draw(shot.time, target.size(), target.framebuffer());
    last = shot;
    drawn = revision_;
    driver_.drawn();
    return true;
}

void PreviewHost::draw_stretched(const Target& target, const Shot& shot) {
    const glm::ivec2 to = target.size();
    small_.resize(glm::max(glm::ivec2(glm::round(glm::dvec2(to) * shot.scale)), glm::ivec2(1)));
    preview_->draw(shot.time, small_.size(), small_.framebuffer());
    glBlitNamedFramebuffer(small_.framebuffer(), target.framebuffer(), 0, 0, small_.size().x, small_.size().y, 0, 0,
                           to.x, to.y, GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

Image PreviewHost::picture_with(const std::function<void(document::Content&)>& change, const Shot& shot,
                                glm::ivec2 size) {
    document::Content tried{.scene = shown_scene_ ? *shown_scene_ : wanted_.scene, .preset = shown_preset()};
    const Scene scene = tried.scene;
    change(tried);
    const bool other_scene = !equal(scene_table(), &scene, &tried.scene);
    auto as_before = [&](const void*) {
        if (other_scene) preview_->set_scene(scene);
        preview_->set_parameters(shown_preset());
        driver_.drawn();
    };
    const std::unique_ptr<const PreviewHost, decltype(as_before)> restore(this, as_before);
    preview_->set_parameters(tried.preset);
    if (other_scene) preview_->set_scene(tried.scene);
    if (std::exchange(overlay_, shot.overlay) != shot.overlay) preview_->set_overlay(shot.overlay);
    preview_->set_camera(shot.camera);
    preview_->set_haze_shown(shot.haze);
    tried_.resize(size);
    preview_->draw(shot.time, size, tried_.framebuffer());
    return tried_.read();
}

bool PreviewHost::late() const {
    return preview_ && !driver_.lost() && preview_->late();
}

void PreviewHost::put_tool(ToolAction action, double power, double strength, double time, glm::dvec3 place) {
    if (preview_)
        tool_.put(*preview_, {.time = time,
                              .position = place,
                              .touching = true,
                              .action = action,
                              .power = power,
                              .strength = strength});
}

void PreviewHost::move_tool(double time, glm::dvec3 place) {
    if (tool_.on()) tool_.move(*preview_, time, place);
}

std::vector<ToolContact> PreviewHost::take_tool_off(double time) {
    if (!tool_.on()) return {};
    tool_.take_off(*preview_, time);
    changed_ = true;
    // The queue is emptied by seeking.
    if (target_.texture() != 0) preview_->draw(time, target_.size(), target_.framebuffer());
    pixels_known_ = false;
    shown_scene_.reset();  // the document decides what stays, also where it has not changed
    stale_ = true;
    return tool_.done(*preview_);
}

}  // namespace lapfx::app
