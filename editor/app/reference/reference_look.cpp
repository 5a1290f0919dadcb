#include "app/reference/reference_look.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tuple>
#include <utility>

#include "app/base/paths.h"
#include "app/base/screen.h"
#include "app/preview/preview_host.h"
#include "app/reference/placed_picture.h"
#include "app/reference/reference.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/preview.h"
#include "lapfx/authoring/round_view.h"
#include "match/explain/scene_look.h"

namespace lapfx::app {

namespace {

constexpr double look_height = 256;  // px of the pictures that a look is proposed from
constexpr int organ_step = 4;        // px of those, between two places that are looked at for the organ
constexpr std::string_view decoding_note = "The frame is still being decoded: the look follows when it is there.";

// Widths over heights that videos are made for, and how far from them a round view may be, as a share.
constexpr std::array usual_aspects = {5.0 / 4, 4.0 / 3, 16.0 / 10, 16.0 / 9};
constexpr double near_aspect = 0.05;
constexpr int most_looked_at = 8;  // frames: in the first ones the view may be dark

Image in_size(const Image& image, glm::ivec2 size) {
    if (glm::ivec2(image.width, image.height) == size) return image;
    Image made{.width = size.x, .height = size.y, .pixels = {}, .name = image.name};
    made.pixels.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    const cv::Mat from(image.height, image.width, CV_8UC4, const_cast<std::uint8_t*>(image.pixels.data()));
    cv::Mat to(size.y, size.x, CV_8UC4, made.pixels.data());
    cv::resize(from, to, to.size(), 0, 0,
               size.x > image.width || size.y > image.height ? cv::INTER_LINEAR : cv::INTER_AREA);
    return made;
}

/// The picture as wide for its height as `shape` is; the side that is squeezed gets shorter.
Image in_shape(const Image& image, glm::dvec2 shape) {
    const double scale = std::min(image.width / shape.x, image.height / shape.y);
    return in_size(image, glm::max(glm::ivec2(glm::round(shape * scale)), glm::ivec2(1)));
}

double rounded(double value) {
    return std::round(value * 1e4) / 1e4;  // short in the file
}

/// The usual aspect with which a view is round that is stored squeezed; none: it is not, or looks like no usual one.
std::optional<double> aspect_for(const Image& frame) {
    const std::optional<double> round = aspect_of_round_view(frame);
    if (!round) return std::nullopt;
    const auto off = [&](double aspect) { return std::abs(std::log(*round / aspect)); };
    if (off(static_cast<double>(frame.width) / frame.height) < near_aspect) return std::nullopt;
    const double nearest = *std::ranges::min_element(usual_aspects, {}, off);
    return off(nearest) < near_aspect ? std::optional(rounded(nearest)) : std::nullopt;
}

/// Where the preview shows the organ through this camera, CV_8U; empty: nobody knows.
cv::Mat organ_in(PreviewHost& preview, const SceneCamera& camera, glm::ivec2 size) {
    Preview* const shown = preview.preview();
    if (shown == nullptr) return {};
    shown->set_camera(camera);  // every picture sets its own
    cv::Mat1b organ(std::max(1, size.y / organ_step), std::max(1, size.x / organ_step), std::uint8_t{0});
    const glm::dvec2 cell = glm::dvec2(size) / glm::dvec2(organ.cols, organ.rows);
    for (int y = 0; y < organ.rows; ++y)
        for (int x = 0; x < organ.cols; ++x)
            if (shown->pick((glm::dvec2(x, y) + 0.5) * cell, size)) organ(y, x) = 255;
    return organ;
}

/// The organ, named the same wherever its scene is saved.
SceneOrgan organ_of(const Scene& scene) {
    SceneOrgan organ = scene.organ;
    organ.file = path_from(scene.folder, organ.file).string();
    organ.texture = path_from(scene.folder, organ.texture).string();
    return organ;
}

bool same_look(const match::SceneLook& a, const match::SceneLook& b) {
    const auto colors = [](const match::SceneLook& look) {
        return std::tie(look.light, look.organ, look.blood_thin, look.blood_deep, look.haze);
    };
    return a.vignette == b.vignette && a.exposure == b.exposure && colors(a) == colors(b);
}

}  // namespace

struct ReferenceLook::Proposed {
    match::SceneLook look;
    // What it was made for.
    Scene scene;
    match::SceneLook before;
    std::uint64_t version = 0;  ///< of the document that still was so

    bool holds(const Scene& now, const match::SceneLook& look_now) const {
        const auto same = [](std::string_view part, const void* a, const void* b) {
            return equal(*scene_table().find(part), a, b);
        };
        const SceneOrgan organ = organ_of(scene), organ_now = organ_of(now);
        return same_look(before, look_now) && !now.plate.use && same("organ", &organ, &organ_now) &&
               same("camera", &scene.camera, &now.camera) && same("light", &scene.light, &now.light) &&
               scene.reference.aspect == now.reference.aspect;
    }
};

ReferenceLook::ReferenceLook(Reference& reference, document::Document& document, PreviewHost& preview, Screen& screen)
    : reference_(reference), document_(document), preview_(preview), screen_(screen) {}
ReferenceLook::~ReferenceLook() = default;

/// `step`: what they tell of.
void ReferenceLook::say(std::vector<std::string> notes, document::WatchedStep step) {
    notes_ = std::move(notes);
    noted_step_ = step;
}

/// Notes of what was undone, and what holds no longer.
void ReferenceLook::update() {
    if (noted_step_ && !noted_step_.in_effect(document_)) forget_notes();
    if (document_.scene().reference.aspect > 0) proposed_aspect_.reset();
    leave_stale();
}

void ReferenceLook::forget() {
    forget_notes();
    leave();
    proposed_aspect_.reset(), looked_for_aspect_ = 0;
}

// --- the circle ------------------------------------------------------------------------------------------------------

void ReferenceLook::look_at() {
    if (document_.scene().reference.aspect > 0 || proposed_aspect_ || looked_for_aspect_ >= most_looked_at) return;
    ++looked_for_aspect_;
    proposed_aspect_ = aspect_for(reference_.image());
    if (proposed_aspect_) screen_.wake("an aspect is proposed");
}

void ReferenceLook::take_aspect() {
    if (!proposed_aspect_) return;
    const double aspect = *std::exchange(proposed_aspect_, std::nullopt);
    document_.change("Reference aspect", [&](document::Content& c) { c.scene.reference.aspect = aspect; });
}

void ReferenceLook::leave_aspect() {
    proposed_aspect_.reset();
    looked_for_aspect_ = most_looked_at;
}

void ReferenceLook::take_circle() {
    reference_.follow();  // the panel may be hidden
    if (reference_.shown_frame() < 0 || reference_.image().pixels.empty())
        return say({"The frame is still being decoded: take the circle when it is there."});
    const SceneReference& reference = document_.scene().reference;
    const std::optional<double> aspect = reference.aspect > 0 ? std::nullopt : proposed_aspect_;
    const glm::ivec2 size = aspect ? reference_.shown().size_with(*aspect) : reference_.shown().size();
    const auto found = on_the_vignette(in_size(reference_.image(), size), reference.placement);
    if (!found) {
        std::vector<std::string> notes = {"This frame of the reference shows no round view of an endoscope."};
        if (!(reference.aspect > 0))
            notes.emplace_back(
                "If its picture looks squeezed, choose its aspect first (As stored, above): only then is the view "
                "round.");
        return say(std::move(notes));
    }
    leave();  // it was proposed for the vignette of before
    document_.change("Take the circle", [&](document::Content& c) {
        if (aspect) c.scene.reference.aspect = *aspect;
        c.scene.reference.placement = *found;
        c.scene.camera.vignette = 1;
    });
    std::vector<std::string> notes = {"The round view of the reference lies on the preview's vignette now."};
    if (aspect) notes.emplace_back("The video is stored squeezed: its aspect is chosen with which the view is round.");
    say(std::move(notes), document::WatchedStep(document_));
}

// --- the plate -------------------------------------------------------------------------------------------------------

std::optional<double> ReferenceLook::plate_progress() const {
    const Scene& scene = document_.scene();
    if (!scene.plate.use || preview_.organ_of(scene)) return std::nullopt;
    const std::optional<Loading> loading = preview_.loading();
    return loading ? std::optional(loading->progress) : std::nullopt;
}

// --- the look --------------------------------------------------------------------------------------------------------

void ReferenceLook::propose() {
    leave();
    if (document_.scene().plate.use)
        return say(
            {"The plate is a frame of the reference and looks like it already. Turn Plate off: then the look of "
             "the organ can be proposed."});
    forget_notes();
    proposes_ = true;
}

/// It waits for the frame of this time: the newest one may be of another.
void ReferenceLook::follow() {
    if (!proposes_) return;
    if (reference_.video() == nullptr || document_.scene().plate.use) {
        proposes_ = false;
        return forget_notes();
    }
    reference_.follow();  // the panel may be hidden
    if (reference_.shown_frame() == reference_.frame()) {
        proposes_ = false;
        return make();
    }
    if (notes_.size() == 1 && notes_[0] == decoding_note) return;
    say({std::string(decoding_note)});
    screen_.wake("a look waits for its frame");
}

void ReferenceLook::make() {
    if (reference_.image().height < 1) return;
    const glm::dvec2 shape(reference_.shown().size());
    const glm::ivec2 size = glm::max(glm::ivec2(glm::round(shape * (look_height / shape.y))), glm::ivec2(1));
    clean_.resize(size);
    const SceneCamera& camera = document_.scene().camera;
    if (!clean_.draw(preview_, {.time = 0, .camera = camera}) && !clean_.drawn()) {
        say({"There is no preview to compare with: load an organ first."});
    } else {
        const match::SceneLook now = match::look_of(document_.scene(), document_.preset());
        match::LookProposal found = match::propose_look(in_shape(reference_.image(), shape), clean_.image(), now,
                                                        organ_in(preview_, camera, size), camera.response());
        say(std::move(found.notes));
        if (found.possible)
            proposed_ = std::make_shared<Proposed>(Proposed{
                .look = found.look, .scene = document_.scene(), .before = now, .version = document_.version()});
    }
    screen_.wake("a look is proposed");
}

void ReferenceLook::leave_stale() {
    if (!proposed_ || proposed_->version == document_.version()) return;
    proposed_->version = document_.version();
    if (proposed_->holds(document_.scene(), match::look_of(document_.scene(), document_.preset()))) return;
    proposed_.reset();
    say({"What the look was proposed for has changed since: propose it again."});
    screen_.wake("a look is left");
}

void ReferenceLook::take() {
    leave_stale();  // what changed it may have come in this very frame
    if (!proposed_) return;
    const match::SceneLook look = std::exchange(proposed_, nullptr)->look;
    forget_notes();
    document_.change("Propose look", [&](document::Content& c) { match::put_look(look, c.scene, c.preset); });
}

void ReferenceLook::leave() {
    if (proposed_ || proposes_) forget_notes();
    proposed_.reset();
    proposes_ = false;
}

}  // namespace lapfx::app
