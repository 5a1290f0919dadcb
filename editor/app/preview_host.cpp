#include "app/preview_host.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lapfx::app {

namespace {

constexpr double sample_time = 0.01;  // s between samples of the tool in the hand

bool same_camera(const SceneCamera& a, const SceneCamera& b) {
    return a.eye == b.eye && a.target == b.target && a.up == b.up && a.field_of_view == b.field_of_view &&
           a.exposure == b.exposure && a.vignette == b.vignette;
}

/// What the preview has to be made anew for.
std::string key_of(const Scene& scene) {
    Scene key;
    key.organ = scene.organ;
    key.tool = scene.tool;
    key.light = scene.light;
    key.gravity = scene.gravity;
    key.seed = scene.seed;
    return write_scene(key) + scene.folder.string();
}

}  // namespace

PreviewHost::PreviewHost(const PreviewOptions& options) : options_(options) {}
PreviewHost::~PreviewHost() = default;

ui::ImageHandle PreviewHost::picture() const {
    return preview_ ? target_.texture() : 0;
}

glm::ivec2 PreviewHost::size() const {
    return target_.size();
}

void PreviewHost::follow(const document::Document& document) {
    if (document.version() == followed_ || tool_on_) return;
    followed_ = document.version();
    std::string organ_key = key_of(document.scene());
    if (organ_key != organ_key_) {
        organ_key_ = std::move(organ_key);
        make(document);
        return;
    }
    follow_preset(document.preset());
    follow_scene(document.scene());
}

void PreviewHost::make(const document::Document& document) {
    changed_ = true;
    try {
        preview_ = std::make_unique<Preview>(document.scene(), document.preset(), options_);
        overlay_ = options_.overlay;
        organ_faults_.clear();
        preset_faults_.clear();
        scene_text_ = write_scene(document.scene());
        preset_text_ = write_preset(document.preset());
    } catch (const Error& error) {
        organ_faults_ = error.faults();
    }
}

void PreviewHost::follow_preset(const Preset& preset) {
    if (!preview_) return;
    std::string text = write_preset(preset);
    if (text == preset_text_) return;
    preset_text_ = std::move(text);
    changed_ = true;
    try {
        preview_->set_preset(preset);
        preset_faults_.clear();
    } catch (const Error& error) {
        preset_faults_ = error.faults();
    }
}

void PreviewHost::follow_scene(const Scene& scene) {
    if (!preview_) return;
    std::string text = write_scene(scene);
    if (text == scene_text_) return;
    scene_text_ = std::move(text);
    changed_ = true;
    preview_->set_curves(scene.curves);
    preview_->set_contacts(scene.events);
}

void PreviewHost::resize(glm::ivec2 size) {
    size = glm::clamp(size, glm::ivec2(0), glm::ivec2(8192));
    if (size == target_.size() || size.x < 1 || size.y < 1) return;
    target_.resize(size);
    changed_ = true;
}

bool PreviewHost::draw(const Shot& shot) {
    return draw_into(target_, shot, last_, drawn_);
}

bool PreviewHost::draw_into(PreviewCopy& copy, const Shot& shot) {
    return draw_into(copy.target, shot, copy.shot, copy.revision);
}

bool PreviewHost::draw_into(const Target& target, const Shot& shot, Shot& last, std::uint64_t& drawn) {
    if (!preview_ || target.texture() == 0) return false;
    if (std::exchange(changed_, false)) ++revision_;
    const bool same = shot.time == last.time && same_camera(shot.camera, last.camera) && shot.overlay == last.overlay;
    if (same && drawn == revision_ && !tool_on_ && !late()) return false;
    if (std::exchange(overlay_, shot.overlay) != shot.overlay) preview_->set_overlay(shot.overlay);
    preview_->set_camera(shot.camera);
    preview_->draw(shot.time, target.size(), target.framebuffer());
    last = shot;
    drawn = revision_;
    return true;
}

bool PreviewHost::late() const {
    return false;
}

void PreviewHost::push_sample(double time, glm::dvec3 place, bool touching) {
    tool_.time = time;
    tool_.position = place;
    tool_.touching = touching;
    preview_->tool_queue().push(tool_);
}

void PreviewHost::put_tool(ToolAction action, double power, double strength, double time, glm::dvec3 place) {
    if (!preview_) return;
    // Samples go forwards in time; a log that is set lets time begin anew.
    const std::vector<ToolContact> log(preview_->contacts().begin(), preview_->contacts().end());
    preview_->set_contacts(log);
    contacts_before_ = log.size();
    tool_ = {.time = time, .position = place, .touching = true, .action = action, .power = power, .strength = strength};
    tool_on_ = true;
    push_sample(time, place, true);
}

void PreviewHost::move_tool(double time, glm::dvec3 place) {
    if (!tool_on_) return;
    const double begin = tool_.time;
    const glm::dvec3 from = tool_.position;
    while (tool_.time + sample_time <= time) {
        const double next = tool_.time + sample_time;
        push_sample(next, glm::mix(from, place, (next - begin) / (time - begin)), true);
    }
}

std::vector<ToolContact> PreviewHost::take_tool_off(double time) {
    if (!tool_on_) return {};
    tool_on_ = false;
    changed_ = true;
    push_sample(std::max(time, tool_.time + 1e-3), tool_.position, false);
    // The queue is emptied by seeking.
    if (target_.texture() != 0) preview_->draw(time, target_.size(), target_.framebuffer());
    const std::span<const ToolContact> all = preview_->contacts();
    const std::size_t first = std::min(contacts_before_, all.size());
    scene_text_.clear();  // the document decides what stays, also where it has not changed
    followed_ = 0;
    return {all.begin() + static_cast<std::ptrdiff_t>(first), all.end()};
}

}  // namespace lapfx::app
