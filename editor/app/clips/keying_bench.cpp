#include "app/clips/keying_bench.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "app/base/notices.h"
#include "app/preview/pick_color.h"
#include "app/preview/preview_host.h"
#include "app/preview/scene_pace.h"
#include "app/preview/timeline.h"
#include "app/tuning/parameters.h"
#include "document/tables.h"
#include "lapfx/authoring/clip_roles.h"
#include "lapfx/authoring/compare.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr glm::u8vec3 grey{118, 118, 118};  // middle grey: sRGB of a fifth of the light
constexpr glm::u8vec3 tissue{142, 58, 50};  // a liver under an endoscope has this colour
constexpr int checker_side = 16;            // px
constexpr int scope_samples = 350;          // per side: more would not change what is seen
constexpr int quick_pixels = 720 * 576;     // that can be keyed within a frame when no edges are found

bool same_look(const KeyingLook& a, const KeyingLook& b) {
    const Table& smoke = *preset_table().find("smoke");
    const unsigned differ =
        difference(*smoke.find("keying"), &a.keying, &b.keying) | difference(*smoke.find("clips"), &a.clip, &b.clip);
    return (differ & redo::keyed_frame) == 0 && a.color == b.color && a.extinction == b.extinction;
}

Image flat(glm::u8vec3 color) {
    return {.width = 1, .height = 1, .pixels = {color.r, color.g, color.b, 255}, .name = ""};
}

Image checker(glm::ivec2 size) {
    Image image{.width = size.x, .height = size.y, .pixels = {}, .name = ""};
    image.pixels.reserve(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const std::uint8_t value = ((x / checker_side + y / checker_side) & 1) == 0 ? 150 : 96;
            image.pixels.insert(image.pixels.end(), {value, value, value, 255});
        }
    return image;
}

/// Numbers get as many decimals as steps of the row have, and `more`.
std::string rounded_text(const Parameter& row, const Value& value, int more) {
    const double* const number = std::get_if<double>(&value);
    if (number == nullptr) return text_of(row, value);
    const double decimals = row.step > 0 ? std::max(0.0, std::ceil(-std::log10(row.step) - 1e-9)) : 2;
    const double parts = std::pow(10.0, decimals + more);
    return text_of(row, std::round(parts * *number) / parts);
}

/// "Luma low from 16 to 31"; what differs by less than a step is told apart all the same.
std::string change_text(const Parameter& row, const void* before, const void* after) {
    constexpr int most_more = 6;
    std::string from, to;
    for (int more = 0; from == to && more <= most_more; ++more) {
        from = rounded_text(row, row.get(before), more);
        to = rounded_text(row, row.get(after), more);
    }
    return std::string(row.name) + " from " + from + " to " + to;
}

std::string differing_rows(const Table& table, const void* before, const void* after) {
    std::string changes;
    for (const Parameter& row : table.rows) {
        if (row.get(before) == row.get(after)) continue;
        changes += (changes.empty() ? "" : ", ") + change_text(row, before, after);
    }
    return changes;
}

}  // namespace

struct KeyingBench::Request {
    fs::path path;  ///< empty: nothing is to be shown
    double time = 0;
    KeyingLook look;
    Behind behind = Behind::grey;
    std::shared_ptr<const Image> backdrop;

    bool same_frame(const Request& o) const { return path == o.path && time == o.time; }
    friend bool operator==(const Request& a, const Request& b) {
        return a.same_frame(b) && same_look(a.look, b.look) && a.behind == b.behind && a.backdrop == b.backdrop;
    }
};

struct KeyingBench::Result {
    bool new_frame = false;
    std::array<Image, bench_views> images;  ///< empty: as before
    std::array<std::uint32_t, 256> bins{};
    int frame = 0, frames = 0;
    double time = 0;
    bool broken = false;
};

/// What lies between a request and its pictures; used by one thread at a time.
class BenchWork {
  public:
    using Request = KeyingBench::Request;
    using Result = KeyingBench::Result;

    /// The file is open, its frame is read, and no edges have to be found or smoothed: keying takes less than a frame.
    bool quick(const Request& r) const {
        return reader_ && r.path == path_ && reader_->frame_at(r.time) == index_ &&
               frame_.size.x * frame_.size.y <= quick_pixels && !(r.look.keying.choke > 0) &&
               !(r.look.keying.feather > 0);
    }
    /// Throws Error.
    Result run(const Request& request) {
        Result result;
        result.new_frame = read(request);
        keyed_opacity(frame_, request.look.keying, request.look.clip, opacity_);
        if (result.new_frame) result.images[0] = source_picture(frame_);
        result.images[1] = matte_picture(frame_.size, opacity_);
        result.images[2] = keyed_picture(frame_, request.look, opacity_);
        result.images[3] = composite_picture(frame_, request.look, opacity_, backdrop(request));
        const bool dark = request.look.clip.polarity == ClipPolarity::dark;
        for (const float luma : frame_.luma) {
            const auto bin = static_cast<std::size_t>(std::clamp(luma + 0.5f, 0.0f, 255.0f));
            ++result.bins[dark ? 255 - bin : bin];
        }
        result.frame = index_;
        result.frames = reader_->report().frames;
        result.time = reader_->time_of(index_);
        result.broken = broken_;
        return result;
    }

  private:
    /// Gives whether it is another frame than before.
    bool read(const Request& request) {
        if (!reader_ || request.path != path_) {
            reader_.reset();
            index_ = -1;
            reader_.emplace(request.path);
            path_ = request.path;
        }
        const int index = reader_->frame_at(request.time);
        if (index == index_) return false;
        broken_ = !reader_->read(index, frame_);
        index_ = index;
        return true;
    }
    Image backdrop(const Request& request) const {
        if (request.behind == Behind::checker) return checker(frame_.size);
        if (request.behind == Behind::preview && request.backdrop) return *request.backdrop;
        return flat(request.behind == Behind::tissue ? tissue : grey);
    }

    std::optional<KeyingReader> reader_;
    fs::path path_;
    int index_ = -1;
    bool broken_ = false;
    KeyingFrame frame_;
    std::vector<float> opacity_;
};

glm::vec4 BenchPixels::pixel(glm::ivec2 at) const {
    return pixel_of(image, at);
}

KeyingBench::KeyingBench(ClipShelf& shelf, document::Document& document, const PreviewHost& preview,
                         const Timeline& timeline, const ScenePace& pace, Jobs& jobs, ui::ImageStore& images,
                         Notices& notices, bool exact)
    : shelf_(shelf),
      document_(document),
      preview_(preview),
      timeline_(timeline),
      pace_(pace),
      jobs_(jobs),
      images_(images),
      notices_(notices),
      exact_(exact),
      work_(std::make_shared<BenchWork>()),
      requested_(std::make_unique<Request>()),
      vectors_(images),
      waves_(images) {}

KeyingBench::~KeyingBench() {
    for (const ui::ImageHandle handle : handles_)
        if (handle != 0) images_.remove(handle);
}

const SmokeClip* KeyingBench::clip() const {
    const auto& clips = document_.preset().smoke.clips;
    return shelf_.selected < clips.size() ? &clips[shelf_.selected] : nullptr;
}

const KeyingParameters& KeyingBench::keying_of(const SmokeParameters& smoke, std::size_t clip) {
    return clip < smoke.clips.size() && smoke.clips[clip].own_keying ? smoke.clips[clip].keying : smoke.keying;
}

const KeyingParameters& KeyingBench::keying() const {
    return keying_of(document_.preset().smoke, shelf_.selected);
}

KeyingParameters& KeyingBench::keying_of(document::Content& content, std::size_t clip) {
    auto& clips = content.preset.smoke.clips;
    return clip < clips.size() && clips[clip].own_keying ? clips[clip].keying : content.preset.smoke.keying;
}

void KeyingBench::set_eyedropper(bool on) {
    look.eyedropper = on;
    if (on && !look.grid) look.view = static_cast<int>(BenchView::source);
}

double KeyingBench::standing_at() const {
    const double duration = shelf_.of(shelf_.selected).report.duration;
    return std::min(look.time.value_or(0.4 * duration), duration);
}

const KeyingBench::Request& KeyingBench::request() const {
    Request& wanted = *requested_;
    const SmokeClip* one = clip();
    const ClipFacts& facts = shelf_.of(shelf_.selected);
    if (one == nullptr || !facts.known) return wanted = {};
    const SmokeParameters& smoke = document_.preset().smoke;
    const SmokeMedium medium = row_of(one->role).medium(smoke);
    wanted.path = facts.path;
    wanted.look.keying = keying();
    wanted.look.clip = *one;
    wanted.look.color = medium.color;
    wanted.look.extinction = medium.extinction;
    wanted.time = standing_at();
    if (look.follow) {
        const double end = one->out > one->in ? std::min(one->out, facts.report.duration) : facts.report.duration;
        const double length = std::max(end - one->in, 1e-3);
        wanted.time = one->in + std::fmod(timeline_.time * one->speed, length);
    }
    wanted.behind = look.behind;
    wanted.backdrop = look.behind == Behind::preview ? backdrop_ : nullptr;
    return wanted;
}

bool KeyingBench::stale() const {
    if (job_) return false;
    return !shown_ || !asked_ || !(*asked_ == request()) ||
           (look.behind == Behind::preview && backdrop_time_ != timeline_.time && !timeline_.playing() &&
            preview_.picture() != 0);
}

/// When time has stood still for a frame, the preview shows the present time. A picture that was drawn with fewer
/// pixels is not taken: it will be drawn whole in a moment.
void KeyingBench::follow_backdrop() {
    const double now = timeline_.time;
    const bool stands = now == time_before_ && !timeline_.playing();
    const bool whole = std::isinf(pace_.whole_at());
    time_before_ = now;
    if (look.behind != Behind::preview || !stands || !whole || backdrop_time_ == now || preview_.picture() == 0) return;
    backdrop_ = std::make_shared<const Image>(preview_.read());
    backdrop_time_ = now;
}

void KeyingBench::update(double) {
    if (job_ && job_->cancelled()) {  // whoever lists jobs can cancel it; its thread may still be at work
        job_.reset();
        work_ = std::make_shared<BenchWork>();
    }
    if (suggesting_ && suggesting_->cancelled()) suggesting_.reset();
    if (finding_source_ && finding_source_->cancelled()) finding_source_.reset();
    if (const SmokeClip* one = clip();
        suggestion_ && (one == nullptr || shelf_.selected != suggested_clip_ || one->file != suggested_for_))
        forget_suggestion();
    shown_ = std::exchange(wanted_, false);
    if (job_) return;
    if (!shown_) return let_go();
    follow_backdrop();
    const Request& wanted = request();
    if (asked_ && *asked_ == wanted) return;
    start(wanted);
}

/// While the panel is not seen, no clip is kept open and no pictures are kept; they are made again in a moment when it
/// is.
void KeyingBench::let_go() {
    if (!asked_) return;
    asked_.reset();
    work_ = std::make_shared<BenchWork>();
    backdrop_.reset();
    backdrop_time_ = -1;
    frames_ = 0;
    for (ui::ImageHandle& handle : handles_)
        if (handle != 0) images_.remove(std::exchange(handle, 0));
    for (BenchPixels& pixels : pixels_) pixels.image = {};
}

void KeyingBench::start(const Request& request) {
    asked_ = std::make_unique<Request>(request);
    if (request.path.empty()) {
        frames_ = 0;
        faults_.clear();
        return;
    }
    if (exact_ || work_->quick(request)) {
        try {
            Result result = work_->run(request);
            take(result);
        } catch (const Error& error) {
            frames_ = 0;
            faults_ = error.faults();
        }
        return;
    }
    const auto result = std::make_shared<Result>();
    job_ = jobs_.start(
        "Keying " + request.path.filename().string(),
        [=, work = work_, this](Job&) -> Jobs::Apply {
            *result = work->run(request);
            return [=, this] {
                job_.reset();
                take(*result);
            };
        },
        [this](const std::vector<Fault>& faults) {
            job_.reset();
            frames_ = 0;
            faults_ = faults;
        });
}

void KeyingBench::take(Result& result) {
    faults_.clear();
    frame_ = result.frame, frames_ = result.frames, time_ = result.time, broken_ = result.broken;
    bins_ = result.bins;
    show_pictures(result);
}

void KeyingBench::show_pictures(Result& result) {
    for (std::size_t i = 0; i < bench_views; ++i) {
        if (result.images[i].pixels.empty()) continue;
        pixels_[i].image = std::move(result.images[i]);
        const Image& image = pixels_[i].image;
        const glm::ivec2 size(image.width, image.height);
        if (handles_[i] == 0)
            handles_[i] = images_.add(size, image.pixels);
        else
            images_.update(handles_[i], size, image.pixels);
    }
    if (!result.new_frame) return;
    const Image& source = pixels_[0].image;
    const ui::ScopeSource counted{.bytes = source.pixels,
                                  .size = {source.width, source.height},
                                  .channels = 4,
                                  .every = std::max(1, std::min(source.width, source.height) / scope_samples)};
    vectors_.update_chroma(counted);
    waves_.update_luma(counted);
}

ui::Picture KeyingBench::picture(BenchView view) const {
    const auto i = static_cast<std::size_t>(view);
    if (!ready()) return {};
    const Image& image = pixels_[i].image;
    return {.image = handles_[i],
            .size = {image.width, image.height},
            .pixels = &pixels_[i],
            .transparent = view == BenchView::keyed};
}

// --- suggesting ------------------------------------------------------------------------------------------------------

void KeyingBench::cancel_suggesting() {
    if (suggesting_) suggesting_->cancel();
    suggesting_.reset();
}

void KeyingBench::cancel_finding_source() {
    if (finding_source_) finding_source_->cancel();
    finding_source_.reset();
}

void KeyingBench::forget_suggestion() {
    suggestion_.reset();
    suggestion_changes_.clear();
    suggestion_faults_.clear();
}

std::size_t KeyingBench::sharing() const {
    const auto& clips = document_.preset().smoke.clips;
    return static_cast<std::size_t>(
        std::count_if(clips.begin(), clips.end(), [](const SmokeClip& clip) { return !clip.own_keying; }));
}

/// The differences of the clip itself: "Polarity light to dark, Top 0 to 0.07 of the frame, 1 mask".
std::string KeyingBench::clip_changes(const SmokeClip& before, const SmokeClip& after) {
    const Table& clips = *preset_table().find("smoke")->find("clips");
    std::string changes;
    const auto add = [&](const std::string& text) { changes += (changes.empty() || text.empty() ? "" : ", ") + text; };
    for (const char* key : {"polarity", "edge_fade"}) {
        const Parameter& row = *clips.find_row(key);
        if (row.get(&before) != row.get(&after)) add(change_text(row, &before, &after));
    }
    add(differing_rows(*clips.find("crop"), &before.crop, &after.crop));
    if (before.masks != after.masks)
        add(std::to_string(after.masks.size()) + (after.masks.size() == 1 ? " mask" : " masks"));
    return changes;
}

void KeyingBench::put_suggestion(const KeyingSuggestion& found, std::size_t number, For whose) {
    suggestion_version_ = document_.version();
    suggestion_undoes_ = false;
    suggestion_changes_ = "Nothing changed: this clip has its own opacity";
    if (found.alpha) return;
    const SmokeParameters& now = document_.preset().smoke;
    const KeyingParameters before = keying_of(now, number);
    const SmokeClip clip_before = now.clips[number];
    const bool only = now.clips.size() == 1 && !clip_before.own_keying;
    document_.change("Suggest keying", [&](document::Content& c) {
        SmokeParameters& smoke = c.preset.smoke;
        SmokeClip& clip = smoke.clips[number];
        if (!clip.own_keying) clip.keying = smoke.keying;  // what is not suggested stays as it was
        found.apply(clip);
        if (whose == For::clip && !only) return;
        smoke.keying = std::exchange(clip.keying, clip_before.keying);
        clip.own_keying = false;
    });
    const SmokeClip& clip = now.clips[number];
    std::string changes =
        differing_rows(*preset_table().find("smoke")->find("keying"), &before, &keying_of(now, number));
    if (const std::string more = clip_changes(clip_before, clip); !more.empty())
        changes += (changes.empty() ? "" : ", ") + more;
    const std::size_t many = sharing(), all = now.clips.size();
    const std::string_view own =
        clip_before.own_keying ? "For this clip only: " : "For this clip only (it now has its own keying): ";
    const std::string for_whom = clip.own_keying ? std::string(own)
                                 : many == all   ? "For all clips (" + std::to_string(all) + "): "
                                                 : "For " + std::to_string(many) + " of " + std::to_string(all) +
                                                     " clips, which share their keying: ";
    suggestion_version_ = document_.version();
    suggestion_undoes_ = !changes.empty() || clip.own_keying != clip_before.own_keying;
    suggestion_changes_ = !changes.empty()     ? for_whom + changes
                          : suggestion_undoes_ ? for_whom + "the same values"
                                               : "Nothing changed: these thresholds were set already";
}

void KeyingBench::suggest_for_all() {
    if (!suggestion_ || suggested_clip_ != shelf_.selected) return;
    const KeyingSuggestion found = *suggestion_;
    put_suggestion(found, shelf_.selected, For::all);
}

/// Another clip is shown by now: a notice tells what the panel would have told.
void KeyingBench::tell_suggestion(const KeyingSuggestion& found, const std::string& file) {
    const bool unsure = found.confidence < sure_from;
    notices_.add({.kind = unsure ? ui::ToastKind::warning : ui::ToastKind::info,
                  .text = "Keying for " + fs::path(file).filename().string() + ", " + (unsure ? "only " : "") +
                          std::to_string(std::lround(100 * found.confidence)) + " % sure. " + suggestion_changes_});
    forget_suggestion();
}

std::string_view KeyingBench::suggestion_changes() const {
    return suggestion_version_ == document_.version() ? std::string_view(suggestion_changes_) : std::string_view();
}

void KeyingBench::suggest(For whose) {
    const SmokeClip* one = clip();
    const ClipFacts& facts = shelf_.of(shelf_.selected);
    if (one == nullptr || !facts.known) return;
    cancel_suggesting();
    forget_suggestion();
    const std::string file = one->file;
    const std::size_t number = shelf_.selected;
    const auto apply = [this, file, number, whose](const KeyingSuggestion& found) {
        suggesting_.reset();
        const auto& clips = document_.preset().smoke.clips;
        if (number >= clips.size() || clips[number].file != file) return;
        suggestion_ = found;
        suggestion_->reason = found.reason;
        suggested_for_ = file;
        suggested_clip_ = number;
        put_suggestion(found, number, whose);
        // A selected clip that is gone gives way to the last one, but only in ClipShelf::update(), after this.
        if (std::min(shelf_.selected, clips.size() - 1) != number) tell_suggestion(found, file);
    };
    suggesting_ = jobs_.start(
        "Suggesting keying for " + facts.path.filename().string(),
        [=, path = facts.path](Job&) -> Jobs::Apply {
            const KeyingSuggestion found = suggest_keying(path);
            return [=] { apply(found); };
        },
        [this](const std::vector<Fault>& faults) {
            suggesting_.reset();
            suggestion_faults_ = faults;
        });
}

void KeyingBench::find_source() {
    const SmokeClip* one = clip();
    const ClipFacts& facts = shelf_.of(shelf_.selected);
    if (one == nullptr || !facts.known || finding_source_) return;
    const auto apply = [this, file = one->file, number = shelf_.selected](const SourceSuggestion& found) {
        finding_source_.reset();
        const auto& clips = document_.preset().smoke.clips;
        if (number >= clips.size() || clips[number].file != file) return;
        const std::string name = fs::path(file).filename().string();
        if (!found.found) {
            notices_.add({.kind = ui::ToastKind::warning, .text = "No smoke was found in " + name});
            return;
        }
        document_.change("Source", [&](document::Content& c) { take_source(c.preset.smoke.clips[number], found); });
        notices_.add({.text = found.begins ? "The source is where the smoke of " + name + " begins"
                                           : "The source is where the plume starts in " + name +
                                                 "; the clip does not show how the smoke begins"});
    };
    finding_source_ = jobs_.start(
        "Looking for the source in " + facts.path.filename().string(),
        [=, path = facts.path](Job& job) -> Jobs::Apply {
            const SourceSuggestion found = suggest_source(path, &job.stop());
            return [=] { apply(found); };
        },
        [this](const std::vector<Fault>& faults) {
            finding_source_.reset();
            for (const Fault& fault : faults) notices_.add({.kind = ui::ToastKind::error, .text = fault.text()});
        });
}

}  // namespace lapfx::app
