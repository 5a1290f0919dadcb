#include "app/reference.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <utility>

#include "app/paths.h"
#include "app/pick_color.h"
#include "app/screen.h"
#include "app/settings.h"
#include "app/timeline.h"
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

/// The frame that is shown; with a size, it is sampled as if it had that many pixels.
class Reference::ReferencePixels : public ui::PickSource {
  public:
    explicit ReferencePixels(const Image& image) : image_(image) {}
    glm::ivec2 size{0};
    glm::vec4 pixel(glm::ivec2 at) const override {
        if (size.x < 1 || size.y < 1) return pixel_of(image_, at);
        const glm::dvec2 scale = glm::dvec2(image_.width, image_.height) / glm::dvec2(size);
        return pixel_of(image_, glm::ivec2((glm::dvec2(at) + 0.5) * scale));
    }

  private:
    const Image& image_;
};

/// Read back from the GPU when a pixel is asked for, once per picture; sampled as if it had as many pixels as the
/// reference.
class Reference::PreviewPixels : public ui::PickSource {
  public:
    explicit PreviewPixels(const Target& target) : target_(target) {}
    glm::ivec2 size{1};
    void forget() { known_ = false; }
    glm::vec4 pixel(glm::ivec2 at) const override {
        if (!std::exchange(known_, true)) image_ = target_.read();
        const glm::dvec2 scale = glm::dvec2(image_.width, image_.height) / glm::dvec2(size);
        return pixel_of(image_, glm::ivec2((glm::dvec2(at) + 0.5) * scale));
    }

  private:
    const Target& target_;
    mutable Image image_;
    mutable bool known_ = false;
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

Reference::Reference(document::Document& document, const Timeline& timeline, PreviewHost& preview, Jobs& jobs,
                     Settings& settings, ui::ImageStore& images, Screen& screen, const EditorOptions& options)
    : document_(document),
      timeline_(timeline),
      preview_(preview),
      jobs_(jobs),
      settings_(settings),
      images_(images),
      screen_(screen),
      data_folder_(options.data_folder),
      feed_(options.exact),
      pixels_(std::make_unique<ReferencePixels>(feed_.image())),
      compared_pixels_(std::make_unique<ReferencePixels>(feed_.image())),
      preview_pixels_(std::make_unique<PreviewPixels>(copy_.target)) {
    compare.kind = ui::CompareKind::side_by_side;
}

Reference::~Reference() {
    if (image_ != 0) images_.remove(image_);
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
                put(whole, reader);
                settings_.note_recent(file.string());
            };
        },
        [this, file](const std::vector<Fault>& faults) {
            choosing_.reset();
            refused_ = faults;
            settings_.forget_missing({file.string()});
        });
}

void Reference::put(const fs::path& file, std::shared_ptr<VideoReader> reader) {
    const std::string name = named_in(document_.scene().folder, file);
    document_.change("Reference video", [&](document::Content& c) { c.scene.reference = {.file = name}; });
    follow_scene(std::move(reader));
}

void Reference::choose_sample() {
    choose(data_folder_ / sample);
}

void Reference::remove() {
    give_up_choosing();
    document_.change("Remove reference", [](document::Content& c) { c.scene.reference = {}; });
    follow_scene();
}

double Reference::time() const {
    if (held_ && video() != nullptr) return video()->time_of(std::min(*held_, video()->info().frames - 1));
    return timeline_.time + document_.scene().reference.offset;
}

int Reference::frame() const {
    if (video() == nullptr) return -1;
    // Half a thousandth more: a sum of time and offset may fall just short of a frame's own time.
    return held_ ? std::min(*held_, video()->info().frames - 1) : video()->frame_at(time() + 5e-4);
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
    compare.view = {};
    feed_.open(file_, std::move(reader));
}

void Reference::show_newest() {
    const Image& image = feed_.image();
    const glm::ivec2 size(image.width, image.height);
    if (feed_.frame() < 0 || image.pixels.empty()) return;
    if (image_ == 0)
        image_ = images_.add(size, image.pixels);
    else
        images_.update(image_, size, image.pixels);
}

void Reference::update(double) {
    if (choosing_ && choosing_->cancelled()) choosing_.reset();  // by the list of jobs
    follow_scene();
    if (feed_.take()) show_newest();
    compares_ = false;
}

void Reference::follow() {
    follow_scene();
    const int wanted = frame();
    if (wanted < 0) return;
    const int before = feed_.frame();
    feed_.want(wanted);
    if (feed_.frame() != before) show_newest();  // with `exact` the frame is there at once
}

ui::Picture Reference::picture() const {
    if (feed_.frame() < 0 || image_ == 0) return {};
    pixels_->size = shown_size();
    return {.image = image_, .size = shown_size(), .pixels = pixels_.get()};
}

/// In the aspect that the scene gives it; the side that is stretched grows, so that no pixel is lost.
glm::ivec2 Reference::shown_size() const {
    const glm::dvec2 stored = glm::max(glm::dvec2(feed_.image().width, feed_.image().height), glm::dvec2(1));
    const double aspect = document_.scene().reference.aspect;
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

ui::Picture Reference::compared_preview() {
    // Its size may be known only now; it is drawn after this build, before the window shows it.
    compares_ = true;
    if (copy_.target.size() != drawn_size()) {
        copy_.target.resize(drawn_size());
        copy_.revision = 0;
    }
    if (!preview_.ready() && !preview_.organ_faults().empty()) return {.image = 0, .size = compared_size()};
    preview_pixels_->size = compared_size();
    return {.image = copy_.target.texture(),
            .size = compared_size(),
            .pixels = copy_.revision == 0 ? nullptr : preview_pixels_.get()};
}

ui::Picture Reference::compared_reference() const {
    compared_pixels_->size = compared_size();
    return {.image = image_, .size = compared_size(), .pixels = compared_pixels_.get()};
}

bool Reference::draw(double scale) {
    if (!compares_ || copy_.target.texture() == 0) return false;
    const Shot shot{
        .time = timeline_.time, .camera = document_.scene().camera, .overlay = Overlay::none, .scale = scale};
    const bool first = copy_.revision == 0;
    if (!preview_.draw_into(copy_, shot)) return false;
    if (first) screen_.wake("the preview next to the reference");  // the panel may have been built without it
    preview_pixels_->forget();
    return true;
}

}  // namespace lapfx::app
