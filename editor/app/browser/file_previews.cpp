#include "app/browser/file_previews.h"

#include <algorithm>

#include "app/base/editor_options.h"
#include "app/base/screen.h"
#include "app/files/open.h"
#include "document/document.h"
#include "lapfx/authoring/formats.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr double thumbnail_at = 0.6;  // share of the scene's duration, the same as in the panel of presets

/// The reason in "lapfx: FILE: reason"; the dialog shows the name above it.
std::string reason_in(std::string fault, const std::string& path) {
    constexpr std::string_view program = "lapfx: ";
    if (fault.starts_with(program)) fault.erase(0, program.size());
    if (fault.starts_with(path + ": ")) fault.erase(0, path.size() + 2);
    return fault;
}

}  // namespace

bool has_picture(std::string_view path) {
    return format_named(path) != nullptr;
}

FilePreviews::~FilePreviews() = default;

FilePreviews::Kept& FilePreviews::kept_for(const std::string& path, const ui::FileEntry& file) {
    const fs::path& scene = document_.scene_file();
    const double time = time_in_scene();
    const auto same = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) { return each.path == path; });
    if (same != kept_.end()) {
        const bool on_same = !is_named_as(Content::document, path) || (same->scene == scene && same->time == time);
        if (on_same && same->bytes == file.size && same->changed == file.changed) return *same;
        if (same->image != 0) images_.remove(same->image);
        kept_.erase(same);
        give_up();
    }
    if (kept_.size() >= most_kept) {
        const auto oldest =
            std::min_element(kept_.begin(), kept_.end(), [](const Kept& a, const Kept& b) { return a.used < b.used; });
        if (oldest->image != 0) images_.remove(oldest->image);
        kept_.erase(oldest);
    }
    return kept_.emplace_back(
        Kept{.path = path, .bytes = file.size, .changed = file.changed, .scene = scene, .time = time});
}

double FilePreviews::time_in_scene() const {
    return thumbnail_at * document_.scene().duration;
}

/// Drops the picture that is being made or waits to be taken: it shows the file as it was.
void FilePreviews::give_up() {
    begun_.clear();
    if (maker_ == nullptr) return;
    maker_->want({});
    maker_->take();
}

/// Scenes, clips and organs that pictures depend on may have been written meanwhile. Pictures of unchanged files are
/// still in the cache.
void FilePreviews::begin() {
    give_up();
    for (const Kept& each : kept_)
        if (each.image != 0) images_.remove(each.image);
    kept_.clear();
    looked_at_.clear();
}

/// One at a time: what was begun before is given up.
void FilePreviews::make(const std::string& path) {
    if (maker_ == nullptr) {
        ThumbnailMaker::Options options;
        options.cache = options_.folders.cache;
        options.clip_folders = options_.clip_folders;
        if (!program_.empty()) options.program = program_;
        options.size = size;
        options.longest = program_.empty() ? longest : std::chrono::hours(1);  // a test has a limit of its own
        options.niceness = niceness;
        options.wake = [this] { screen_.wake("a file's picture"); };
        maker_ = std::make_unique<ThumbnailMaker>(std::move(options));
    }
    const fs::path& open = document_.scene_file();
    const fs::path sample = options_.data_folder / "samples" / "lagb.scene.json";
    maker_->want({{.file = path, .scene = open.empty() ? sample : fs::absolute(open), .time = time_in_scene()}});
    begun_ = path;
}

ui::FilePicture FilePreviews::picture(ui::Ui& ui, const std::string& path, const ui::FileEntry& file) {
    using State = ui::FilePicture::State;
    if (!has_picture(path) || (options_.exact && program_.empty())) return {};
    asked_ = true;
    if (looked_at_ != path) looked_at_ = path, since_ = ui.time();
    Kept& kept = kept_for(path, file);
    kept.used = ++uses_;
    if (kept.made && kept.image != 0) return {.state = State::there, .image = kept.image, .size = kept.size};
    if (kept.made) return {.state = State::failed, .fault = kept.fault};
    if (ui.time() < since_ + rests) {
        ui.wake_at(since_ + rests, "a file is looked at");
    } else if (begun_ != path) {
        make(path);
    }
    return {.state = State::coming};
}

void FilePreviews::take(ThumbnailMaker::Result&& result) {
    const std::string path = result.file.string();
    if (begun_ == path) begun_.clear();
    const auto kept = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& each) { return each.path == path; });
    if (kept == kept_.end() || kept->made) return;
    kept->made = true;
    kept->size = result.size;
    if (!result.rgba.empty()) kept->image = images_.add(result.size, result.rgba);
    kept->fault = result.fault.empty() ? "there is no folder to make pictures in" : reason_in(result.fault, path);
}

void FilePreviews::update() {
    if (maker_ == nullptr) return;
    for (ThumbnailMaker::Result& result : maker_->take()) take(std::move(result));
    const bool asked = std::exchange(asked_, false);
    if (asked) return;
    // A picture that failed is tried again when the file is selected again: the machine may have been busy.
    std::erase_if(kept_, [](const Kept& each) { return each.made && each.image == 0; });
    if (begun_.empty()) return;
    maker_->want({});
    begun_.clear();
}

}  // namespace lapfx::app
