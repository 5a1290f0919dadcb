#include "app/reference/reference.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "app/base/paths.h"
#include "app/base/settings.h"
#include "app/preview/timeline.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/formats.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* sample = "samples/reference/operation.mp4";

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
      jobs_(jobs),
      settings_(settings),
      data_folder_(options.data_folder),
      feed_(options.exact),
      shown_(feed_, document, images),
      comparison_(*this, document, timeline, preview, snapshots, settings, images, screen),
      look_(*this, document, preview, screen) {}

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
    look_.forget();
    comparison_.state.view = {};
    feed_.open(file_, std::move(reader));
    comparison_.follow_video();
}

void Reference::show_newest() {
    if (feed_.frame() < 0 || feed_.image().pixels.empty()) return;
    shown_.show_newest();
    look_.look_at();
}

void Reference::update(double) {
    if (choosing_ && choosing_->cancelled()) choosing_.reset();  // by the list of jobs
    follow_scene();
    look_.update();
    if (feed_.take()) show_newest();
    comparison_.update();
}

void Reference::follow() {
    follow_scene();
    const int wanted = frame();
    if (wanted < 0) return;
    const int before = feed_.frame();
    feed_.want(wanted);
    if (feed_.frame() != before) show_newest();  // with `exact` the frame is there at once
    shown_.follow();
    comparison_.follow_video();
}

bool Reference::draw(double scale) {
    look_.follow();
    return comparison_.draw(scale);
}

}  // namespace lapfx::app
