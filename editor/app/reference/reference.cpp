#include "app/reference/reference.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "app/base/paths.h"
#include "app/base/screen.h"
#include "app/base/settings.h"
#include "app/preview/pick_color.h"
#include "app/preview/timeline.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/placed_picture.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* sample = "samples/reference/operation.mp4";
/// s: a sum of time and offset may fall just short of a frame's own time.
constexpr double frame_slack = 5e-4;
constexpr std::uint64_t placed_bit = std::uint64_t{1} << 63U;  // of the number of a picture

/// The name of a file in a scene in `folder`: relative if it is in that folder or below.
std::string named_in(const fs::path& folder, const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(fs::absolute(file), error);
    if (error) return fs::absolute(file).string();
    if (folder.empty()) return whole.string();  // a scene without a file
    const fs::path relative = whole.lexically_relative(fs::weakly_canonical(fs::absolute(folder), error));
    const bool below = !error && !relative.empty() && *relative.begin() != "..";
    return below ? relative.generic_string() : whole.string();
}

}  // namespace

/// The frame that is shown; with a size, it is sampled as if it had that many pixels.
class Reference::ReferencePixels : public ui::PickSource {
  public:
    explicit ReferencePixels(std::function<const Image&()> image) : image_(std::move(image)) {}
    glm::ivec2 size{0};
    glm::vec4 pixel(glm::ivec2 at) const override {
        const Image& image = image_();
        if (size.x < 1 || size.y < 1) return pixel_of(image, at);
        const glm::dvec2 scale = glm::dvec2(image.width, image.height) / glm::dvec2(size);
        return pixel_of(image, glm::ivec2((glm::dvec2(at) + 0.5) * scale));
    }

  private:
    const std::function<const Image&()> image_;
};

fs::path whole_sequence(const fs::path& file) {
    const std::string stem = file.stem().string();
    std::size_t digits = 0;
    while (digits < stem.size() && digits < 9 &&
           std::isdigit(static_cast<unsigned char>(stem[stem.size() - 1 - digits])))
        ++digits;
    if (digits == 0 || !is_named_as(Content::picture, file) || stem.find('%') != std::string::npos) return file;
    const std::string before = stem.substr(0, stem.size() - digits), extension = file.extension().string();
    const long number = std::stol(stem.substr(before.size()));
    const auto numbered = [&](long n) {
        std::string text = std::to_string(n);
        if (text.size() < digits) text.insert(0, digits - text.size(), '0');
        std::error_code error;
        return fs::is_regular_file(file.parent_path() / (before + text + extension), error);
    };
    if (!numbered(number + 1) && (number == 0 || !numbered(number - 1))) return file;
    return file.parent_path() / (before + "%0" + std::to_string(digits) + "d" + extension);
}

Reference::Reference(document::Document& document, const Timeline& timeline, PreviewHost& preview,
                     SnapshotPreviews& snapshots, Jobs& jobs, Settings& settings, ui::ImageStore& images,
                     Screen& screen, const EditorOptions& options)
    : document_(document),
      timeline_(timeline),
      preview_(preview),
      snapshots_(snapshots),
      jobs_(jobs),
      settings_(settings),
      images_(images),
      screen_(screen),
      data_folder_(options.data_folder),
      feed_(options.exact),
      pixels_(std::make_unique<ReferencePixels>([this]() -> const Image& { return feed_.image(); })),
      compared_pixels_(std::make_unique<ReferencePixels>([this]() -> const Image& { return feed_.image(); })),
      placed_pixels_(std::make_unique<ReferencePixels>([this]() -> const Image& { return placed_; })),
      scopes_{PictureScopes(images), PictureScopes(images)} {
    compare.kind = ui::CompareKind::side_by_side;
}

Reference::~Reference() {
    if (image_ != 0) images_.remove(image_);
    if (placed_image_ != 0) images_.remove(placed_image_);
}

void Reference::give_up_choosing() {
    if (choosing_) choosing_->cancel();
    choosing_.reset();
    refused_.clear();
}

void Reference::choose(const fs::path& file) {
    give_up_choosing();
    const fs::path whole = chosen_ = whole_sequence(file);
    choosing_ = jobs_.start(
        "Opening " + whole.filename().string(),
        [this, file, whole](Job& job) -> Jobs::Apply {
            auto reader = std::make_shared<VideoReader>(whole, &job.stop());
            return [this, file, whole, reader] {
                choosing_.reset();
                take(whole, reader);
                settings_.note_recent(file.string());
            };
        },
        [this, file](const std::vector<Fault>& faults) {
            choosing_.reset();
            refused_ = faults;
            settings_.forget_missing({file.string()});
        });
}

void Reference::take(const fs::path& file, std::shared_ptr<VideoReader> reader) {
    const std::string name = named_in(document_.scene().folder, file);
    document_.change("Reference video", [&](document::Content& c) {
        // The same file again is stored as it was.
        c.scene.reference = {.file = name, .aspect = c.scene.reference.file == name ? c.scene.reference.aspect : 0};
        c.scene.plate.frame = PlateFrame::clearest;  // the chosen one is of the former video
        c.scene.plate.time = 0;
    });
    follow_scene(std::move(reader));
}

void Reference::choose_sample() {
    choose(data_folder_ / sample);
}

void Reference::remove() {
    give_up_choosing();
    document_.change("Remove reference", [](document::Content& c) {
        c.scene.reference = {};
        c.scene.plate.use = false;
    });
    follow_scene();
}

double Reference::time() const {
    if (held_ && video() != nullptr) return video()->time_of(std::min(*held_, video()->info().frames - 1));
    return timeline_.time + document_.scene().reference.offset;
}

int Reference::frame() const {
    if (video() == nullptr) return -1;
    return held_ ? std::min(*held_, video()->info().frames - 1) : video()->frame_at(time() + frame_slack);
}

void Reference::hold(int frame) {
    if (video() != nullptr) held_ = std::clamp(frame, 0, video()->info().frames - 1);
}

void Reference::align() {
    if (!held_ || video() == nullptr) return;
    const double offset = time() - timeline_.time;
    document_.change("Align reference", [&](document::Content& c) {
        c.scene.reference.offset = std::round(offset * 1e4) / 1e4;  // far below a frame, and short in the file
    });
    held_.reset();
}

const Table& Reference::mark_table() {
    static const Table& marks = *scene_table().find("reference")->find("marks");
    return marks;
}

void Reference::mark(const Parameter& row) {
    if (video() == nullptr || time() < 0 || time() > video()->info().duration) return;
    const double now = std::round(time() * 1e4) / 1e4;
    document_.change("Mark: " + std::string(row.name),
                     [&](document::Content& c) { row.set(&c.scene.reference.marks, now); });
}

void Reference::clear_marks() {
    document_.change("Clear marks", [](document::Content& c) { c.scene.reference.marks = {}; });
}

bool Reference::any_mark() const {
    const ReferenceMarks &marks = document_.scene().reference.marks, none;
    return !equal(mark_table(), &marks, &none);
}

std::optional<ui::Span> Reference::span() const {
    if (video() == nullptr) return std::nullopt;
    const double begin = -document_.scene().reference.offset;
    return ui::Span{begin, begin + video()->info().duration};
}

void Reference::follow_scene(std::shared_ptr<VideoReader> reader) {
    if (document_.scene_changes_since(std::exchange(followed_, document_.version())) == 0) return;
    const Scene& scene = document_.scene();
    const fs::path file = path_from(scene.folder, scene.reference.file);
    if (file == file_) return;
    file_ = file;
    refused_.clear();
    held_.reset();
    forget_look_notes();
    leave_look();
    proposed_aspect_.reset(), looked_for_aspect_ = 0;
    compare.view = {};
    feed_.open(file_, std::move(reader));
    follow_video();
}

/// What was counted of the regions belongs to frames of the video before.
void Reference::follow_video() {
    if (!regions_video_.owner_before(opened()) && !opened().owner_before(regions_video_)) return;
    regions_video_ = opened();
    for (std::size_t side = 0; side < regions_of_.size(); ++side) forget_regions(side);
}

void Reference::forget_regions(std::size_t side) {
    regions_.forget(side);
    regions_of_[side] = {};
}

void Reference::show_newest() {
    if (feed_.frame() < 0 || feed_.image().pixels.empty()) return;
    ++shown_;
    upload();
    place_newest();
    look_for_aspect();
}

/// With what was counted in it, where that is wanted and known.
void Reference::upload() {
    const Image* image = &feed_.image();
    overlaid_by_ = {shown_, 0};
    if (shows_counted && count_) {
        overlaid_ = feed_.image();
        overlaid_by_.second = count_(video()->time_of(feed_.frame()), &overlaid_);
        if (counted_shown()) image = &overlaid_;
    }
    const glm::ivec2 size(image->width, image->height);
    if (image_ == 0)
        image_ = images_.add(size, image->pixels);
    else
        images_.update(image_, size, image->pixels);
}

/// It was switched, or has been measured.
void Reference::follow_counted() {
    if (feed_.frame() < 0 || feed_.image().pixels.empty() || video() == nullptr) return;
    const std::uint64_t wanted = shows_counted && count_ ? count_(video()->time_of(feed_.frame()), nullptr) : 0;
    if (overlaid_by_ == std::pair(shown_, wanted)) return;
    upload();
    std::get<0>(placed_by_) = 0;  // it is placed again
}

bool Reference::is_placed() const {
    return document_.scene().reference.placement.moved() && placed_image_ != 0;
}

bool Reference::shows_placed() const {
    return is_placed() && way != CompareWay::reference;
}

/// Made anew when the frame, the scene's placement or the shape has changed.
void Reference::place_newest() {
    const Image& image = feed_.image();
    const ReferencePlacement& now = document_.scene().reference.placement;
    const glm::dvec2 shape(shown_size());
    const PlacedBy by{feed_.frame() < 0 ? 0 : shown_, now.right, now.up, now.scale, now.rotation, shape.x / shape.y};
    if (by == placed_by_) return;
    const bool same_frame = std::get<0>(by) == std::get<0>(placed_by_);
    placed_by_ = by;
    if (same_frame) std::get<0>(placed_by_) = ++shown_;  // scopes count it again
    if (!now.moved() || feed_.frame() < 0 || image.pixels.empty()) return;
    placed_ = placed(image, now, shape.x / shape.y);
    Image with_counted;
    if (counted_shown()) with_counted = placed(overlaid_, now, shape.x / shape.y);
    const Image& shown = counted_shown() ? with_counted : placed_;
    const glm::ivec2 size(shown.width, shown.height);
    placed_image_ != 0 ? images_.update(placed_image_, size, shown.pixels)
                       : void(placed_image_ = images_.add(size, shown.pixels));
}

void Reference::update(double) {
    if (choosing_ && choosing_->cancelled()) choosing_.reset();  // by the list of jobs
    follow_scene();
    forget_undone();
    leave_stale_look();
    if (feed_.take()) show_newest();
    follow_video();  // also one that has changed on disk
    compares_ = counts_ = false;
    compares_snapshot_.fill(false);
}

void Reference::follow() {
    follow_scene();
    const int wanted = frame();
    if (wanted < 0) return;
    const int before = feed_.frame();
    feed_.want(wanted);
    if (feed_.frame() != before) show_newest();  // with `exact` the frame is there at once
    follow_counted();
    place_newest();
    follow_video();
}

ui::Picture Reference::picture() const {
    if (feed_.frame() < 0 || image_ == 0) return {};
    pixels_->size = shown_size();
    return {.image = image_, .size = shown_size(), .pixels = pixels_.get()};
}

/// In the aspect that the scene gives it.
glm::ivec2 Reference::shown_size() const {
    return size_with(document_.scene().reference.aspect);
}

/// The side that is stretched grows, so that no pixel is lost. 0: as stored.
glm::ivec2 Reference::size_with(double aspect) const {
    if (feed_.image().width < 1) return largest_compared;  // without a video: that of `lapfx render`
    const glm::dvec2 stored = glm::max(glm::dvec2(feed_.image().width, feed_.image().height), glm::dvec2(1));
    if (!(aspect > 0)) return glm::ivec2(stored);
    return glm::max(glm::ivec2(glm::round(glm::max(stored, {stored.y * aspect, stored.x / aspect}))), glm::ivec2(1));
}

glm::ivec2 Reference::compared_size() const {
    const glm::dvec2 size(shown_size()), room = glm::dvec2(largest_compared) / size;
    return glm::max(glm::ivec2(glm::round(size * std::min({1.0, room.x, room.y}))), glm::ivec2(1));
}

glm::ivec2 Reference::drawn_size() const {
    const glm::ivec2 counted = compared_size();
    if (zoom_ <= 0 || zoom_ >= ui::grid_zoom || way == CompareWay::difference) return counted;
    const glm::dvec2 room = glm::dvec2(largest_compared) / glm::dvec2(counted);
    const double scale = std::min({settings_.half_resolution ? zoom_ / 2 : zoom_, room.x, room.y});
    return glm::max(glm::ivec2(glm::round(glm::dvec2(counted) * scale)), glm::ivec2(1));
}

bool Reference::show_at(double zoom) {
    const glm::ivec2 before = drawn_size();
    zoom_ = zoom;
    return drawn_size() != before;
}

void Reference::put(std::size_t side, CompareSide what) {
    if (sides[1 - side] == what) sides[1 - side] = sides[side];
    sides[side] = what;
}

bool Reference::compares_video() const {
    return std::ranges::find(sides, CompareSide::reference) != sides.end();
}

std::size_t Reference::empty_side() const {
    for (const CompareSide side : sides)
        if (const std::size_t slot = slot_of(side); slot < Snapshots::count && !snapshots_.kept(slot)) return slot;
    return Snapshots::count;
}

std::size_t Reference::first_kept() const {
    std::size_t slot = 0;
    while (slot < Snapshots::count && !snapshots_.kept(slot)) ++slot;
    return slot;
}

/// Its size may be known only now; it is drawn after this build, before the window shows it.
ui::Picture Reference::drawn(DrawnPicture& picture, const PreviewHost* preview) {
    picture.resize(drawn_size());
    picture.counted = compared_size();
    if (preview == nullptr || (!preview->ready() && !preview->organ_faults().empty()))
        return {.image = 0, .size = compared_size()};
    return {.image = picture.texture(), .size = compared_size(), .pixels = picture.drawn() ? &picture : nullptr};
}

ui::Picture Reference::compared(CompareSide side) {
    if (side == CompareSide::preview) return compared_preview();
    if (side == CompareSide::reference) return compared_reference();
    const std::size_t slot = slot_of(side);
    snapshots_.want(slot);
    compares_snapshot_[slot] = true;
    return drawn(drawn_snapshots_[slot], snapshots_.at(slot));
}

ui::Picture Reference::compared_preview() {
    compares_ = true;
    return drawn(drawn_, &preview_);
}

ui::Picture Reference::compared_reference() const {
    ReferencePixels& pixels = is_placed() ? *placed_pixels_ : *compared_pixels_;
    pixels.size = compared_size();
    return {.image = is_placed() ? placed_image_ : image_, .size = compared_size(), .pixels = &pixels};
}

ui::Picture Reference::placed_picture() const {
    ui::Picture shown = picture();
    if (shown.image != 0 && is_placed()) shown.image = placed_image_;
    return shown;
}

const std::array<PictureScopes, 2>& Reference::scopes() {
    counts_ = true;
    return scopes_;
}

/// The frame of the reference that what is shown on a side belongs to; below 0: none.
int Reference::frame_of(CompareSide side) const {
    if (side == CompareSide::reference) return feed_.frame();
    if (held_ || video() == nullptr) return -1;
    const double now = time() + frame_slack;
    return now < 0 || now >= video()->info().duration ? -1 : frame();
}

/// What a side of the comparison shows, as far as its curves hold for it.
Reference::Subject Reference::subject_of(CompareSide side) const {
    if (side == CompareSide::reference) {
        Subject of{.side = side};
        if (shows_placed()) of.placed = placed_by_, std::get<0>(of.placed) = 0;  // of whatever frame
        return of;
    }
    Subject of{.side = side, .document = document_.version()};
    if (side == CompareSide::preview)
        of.alone = preview_.alone();
    else
        of.snapshot = snapshots_.id(slot_of(side));
    return of;
}

bool Reference::count_regions() {
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

bool Reference::draw(double scale) {
    if (proposes_) follow_proposal();
    const bool changed = draw_compared(scale);
    if (counts_) count_scopes();
    return changed;
}

bool Reference::draw_compared(double scale) {
    bool changed = compares_ && draw_compared(drawn_, preview_, scale);
    for (std::size_t slot = 0; slot < drawn_snapshots_.size(); ++slot) {
        PreviewHost* const preview = snapshots_.at(slot);
        if (!compares_snapshot_[slot] || preview == nullptr) continue;
        if (std::exchange(drawn_by_[slot], snapshots_.number(slot)) != snapshots_.number(slot))
            drawn_snapshots_[slot].forget();
        changed |= draw_compared(drawn_snapshots_[slot], *preview, scale);
    }
    return changed;
}

Shot Reference::compared_shot() const {
    return {.time = timeline_.time, .camera = document_.scene().camera, .overlay = Overlay::none};
}

bool Reference::draw_compared(DrawnPicture& picture, PreviewHost& preview, double scale) {
    Shot shot = compared_shot();
    shot.scale = scale;
    const bool first = !picture.drawn();
    if (!picture.draw(preview, shot)) return false;
    if (first) screen_.wake("a picture that is compared");  // the panel may have been built without it
    return true;
}

std::size_t Reference::memory() const {
    std::size_t bytes = drawn_.memory() + snapshots_.memory();
    for (const DrawnPicture& picture : drawn_snapshots_) bytes += picture.memory();
    return bytes;
}

const Image* Reference::newest(CompareSide side, std::uint64_t& number) const {
    if (side == CompareSide::reference) {
        number = shown_;
        if (feed_.frame() < 0) return nullptr;
        if (!shows_placed()) return &feed_.image();
        number |= placed_bit;
        return &placed_;
    }
    const bool now = side == CompareSide::preview;
    const DrawnPicture& picture = now ? drawn_ : drawn_snapshots_[slot_of(side)];
    number = picture.serial();
    const bool seen = now ? compares_ : compares_snapshot_[slot_of(side)];
    return seen && picture.drawn() ? &picture.image() : nullptr;
}

/// The panel was built with what had been counted before: it is built again when that differs.
void Reference::count_scopes() {
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
