#include "app/reference/reference_comparison.h"

#include <algorithm>
#include <utility>

#include "app/base/screen.h"
#include "app/base/settings.h"
#include "app/preview/timeline.h"
#include "app/reference/reference.h"

namespace lapfx::app {

namespace {

constexpr std::uint64_t placed_bit = std::uint64_t{1} << 63U;  // of the number of a picture

}  // namespace

ReferenceComparison::ReferenceComparison(const Reference& reference, const document::Document& document,
                                         const Timeline& timeline, PreviewHost& preview, SnapshotPreviews& snapshots,
                                         const Settings& settings, ui::ImageStore& images, Screen& screen)
    : reference_(reference),
      document_(document),
      timeline_(timeline),
      preview_(preview),
      snapshots_(snapshots),
      settings_(settings),
      screen_(screen),
      scopes_{PictureScopes(images), PictureScopes(images)} {
    state.kind = ui::CompareKind::side_by_side;
}

void ReferenceComparison::update() {
    follow_video();  // also one that has changed on disk
    compares_ = counts_ = false;
    compares_snapshot_.fill(false);
}

bool ReferenceComparison::draw(double scale) {
    const bool changed = draw_pictures(scale);
    if (counts_) count_scopes();
    return changed;
}

bool ReferenceComparison::shows_placed() const {
    return reference_.shown().is_placed() && way != CompareWay::reference;
}

/// What was counted of the regions belongs to frames of the video before.
void ReferenceComparison::follow_video() {
    if (!regions_video_.owner_before(reference_.opened()) && !reference_.opened().owner_before(regions_video_)) return;
    regions_video_ = reference_.opened();
    for (std::size_t side = 0; side < regions_of_.size(); ++side) forget_regions(side);
}

void ReferenceComparison::forget_regions(std::size_t side) {
    regions_.forget(side);
    regions_of_[side] = {};
}

glm::ivec2 ReferenceComparison::size() const {
    const glm::dvec2 size(reference_.shown().size()), room = glm::dvec2(largest) / size;
    return glm::max(glm::ivec2(glm::round(size * std::min({1.0, room.x, room.y}))), glm::ivec2(1));
}

glm::ivec2 ReferenceComparison::drawn_size() const {
    const glm::ivec2 counted = size();
    if (zoom_ <= 0 || zoom_ >= ui::grid_zoom || way == CompareWay::difference) return counted;
    const glm::dvec2 room = glm::dvec2(largest) / glm::dvec2(counted);
    const double scale = std::min({settings_.half_resolution ? zoom_ / 2 : zoom_, room.x, room.y});
    return glm::max(glm::ivec2(glm::round(glm::dvec2(counted) * scale)), glm::ivec2(1));
}

bool ReferenceComparison::show_at(double zoom) {
    const glm::ivec2 before = drawn_size();
    zoom_ = zoom;
    return drawn_size() != before;
}

void ReferenceComparison::put(std::size_t side, CompareSide what) {
    if (sides[1 - side] == what) sides[1 - side] = sides[side];
    sides[side] = what;
}

void ReferenceComparison::show(const std::array<CompareSide, 2>& both) {
    sides = both;
    if (way == CompareWay::reference) way = CompareWay::beside;
}

bool ReferenceComparison::compares_video() const {
    return std::ranges::find(sides, CompareSide::reference) != sides.end();
}

std::size_t ReferenceComparison::empty_side() const {
    for (const CompareSide side : sides)
        if (const std::size_t slot = slot_of(side); slot < Snapshots::count && !snapshots_.kept(slot)) return slot;
    return Snapshots::count;
}

std::size_t ReferenceComparison::first_kept() const {
    std::size_t slot = 0;
    while (slot < Snapshots::count && !snapshots_.kept(slot)) ++slot;
    return slot;
}

/// Its size may be known only now; it is drawn after this build, before the window shows it.
ui::Picture ReferenceComparison::drawn(DrawnPicture& picture, const PreviewHost* preview) {
    picture.resize(drawn_size());
    picture.counted = size();
    if (preview == nullptr || (!preview->ready() && !preview->organ_faults().empty()))
        return {.image = 0, .size = size()};
    return {.image = picture.texture(), .size = size(), .pixels = picture.drawn() ? &picture : nullptr};
}

ui::Picture ReferenceComparison::picture(CompareSide side) {
    if (side == CompareSide::preview) return preview();
    if (side == CompareSide::reference) return reference();
    const std::size_t slot = slot_of(side);
    snapshots_.want(slot);
    compares_snapshot_[slot] = true;
    return drawn(drawn_snapshots_[slot], snapshots_.at(slot));
}

ui::Picture ReferenceComparison::preview() {
    compares_ = true;
    return drawn(drawn_, &preview_);
}

ui::Picture ReferenceComparison::reference() const {
    return reference_.shown().placed_in(size());
}

const std::array<PictureScopes, 2>& ReferenceComparison::scopes() {
    counts_ = true;
    return scopes_;
}

/// The frame of the reference that what is shown on a side belongs to; below 0: none.
int ReferenceComparison::frame_of(CompareSide side) const {
    if (side == CompareSide::reference) return reference_.shown_frame();
    if (reference_.held() || reference_.video() == nullptr) return -1;
    const double now = reference_.time() + Reference::frame_slack;
    return now < 0 || now >= reference_.video()->info().duration ? -1 : reference_.frame();
}

/// What a side of the comparison shows, as far as its curves hold for it.
ReferenceComparison::Subject ReferenceComparison::subject_of(CompareSide side) const {
    if (side == CompareSide::reference) {
        Subject of{.side = side};
        if (shows_placed()) of.placed = reference_.shown().place();
        return of;
    }
    Subject of{.side = side, .document = document_.version()};
    if (side == CompareSide::preview)
        of.alone = preview_.alone();
    else
        of.snapshot = snapshots_.id(slot_of(side));
    return of;
}

bool ReferenceComparison::count_regions() {
    const SceneReference& scene = document_.scene().reference;
    const std::uint64_t before = regions_.version();
    regions_.follow(scene.regions, scene.measure.blood);
    const bool alone = way == CompareWay::reference, others = regions_.version() != before;
    for (std::size_t i = alone ? 1 : 0; i < regions_of_.size(); ++i) {
        const CompareSide side = alone ? CompareSide::reference : sides[i];
        RegionsOf& of = regions_of_[i];
        if (const Subject subject = subject_of(side); subject != of.subject) {
            forget_regions(i);
            of.subject = subject;
        }
        std::uint64_t number = 0;
        const Image* const image = newest(side, number);
        if (image == nullptr || (!others && of.picture == number && regions_.counted(i))) continue;
        of.picture = number;
        regions_.count(i, *image, frame_of(side));
    }
    return regions_.version() != before;
}

bool ReferenceComparison::draw_pictures(double scale) {
    bool changed = compares_ && draw(drawn_, preview_, scale);
    for (std::size_t slot = 0; slot < drawn_snapshots_.size(); ++slot) {
        PreviewHost* const preview = snapshots_.at(slot);
        if (!compares_snapshot_[slot] || preview == nullptr) continue;
        if (std::exchange(drawn_by_[slot], snapshots_.number(slot)) != snapshots_.number(slot))
            drawn_snapshots_[slot].forget();
        changed |= draw(drawn_snapshots_[slot], *preview, scale);
    }
    return changed;
}

Shot ReferenceComparison::shot() const {
    return {.time = timeline_.time, .camera = document_.scene().camera, .overlay = Overlay::none};
}

bool ReferenceComparison::draw(DrawnPicture& picture, PreviewHost& preview, double scale) {
    Shot scaled = shot();
    scaled.scale = scale;
    const bool first = !picture.drawn();
    if (!picture.draw(preview, scaled)) return false;
    if (first) screen_.wake("a picture that is compared");  // the panel may have been built without it
    return true;
}

std::size_t ReferenceComparison::memory() const {
    std::size_t bytes = drawn_.memory() + snapshots_.memory();
    for (const DrawnPicture& picture : drawn_snapshots_) bytes += picture.memory();
    return bytes;
}

const Image* ReferenceComparison::newest(CompareSide side, std::uint64_t& number) const {
    if (side == CompareSide::reference) {
        number = reference_.shown().number();
        if (reference_.shown_frame() < 0) return nullptr;
        if (!shows_placed()) return &reference_.image();
        number |= placed_bit;
        return &reference_.shown().placed_image();
    }
    const bool now = side == CompareSide::preview;
    const DrawnPicture& picture = now ? drawn_ : drawn_snapshots_[slot_of(side)];
    number = picture.serial();
    const bool seen = now ? compares_ : compares_snapshot_[slot_of(side)];
    return seen && picture.drawn() ? &picture.image() : nullptr;
}

/// The panel was built with what had been counted before: it is built again when that differs.
void ReferenceComparison::count_scopes() {
    bool changed = false;
    const bool alone = way == CompareWay::reference;
    for (std::size_t i = alone ? 1 : 0; i < scopes_.size(); ++i) {
        const CompareSide side = alone ? CompareSide::reference : sides[i];
        std::uint64_t number = 0;
        const Image* const image = newest(side, number);
        if (image == nullptr || counted_[i] == std::pair(side, number)) continue;
        counted_[i] = {side, number};
        scopes_[i].count(*image);
        changed = true;
    }
    changed |= scopes_look.shows_regions() && count_regions();
    if (changed) screen_.wake("scopes");
}

}  // namespace lapfx::app
