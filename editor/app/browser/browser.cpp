#include "app/browser/browser.h"

#include <algorithm>
#include <map>

#include "app/base/jobs.h"
#include "app/base/notices.h"
#include "app/base/screen.h"
#include "app/base/settings.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/letters.h"
#include "ui/value/id.h"
#include "ui/widgets/combo.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_files = 2000;  // read from one folder; more are left out
constexpr std::size_t longest = std::size_t{4} << 20;
constexpr double thumbnail_at = 0.6;  // of the scene's duration: blood and smoke are both there

/// "slow, venous" as two.
std::vector<std::string> split_tags(std::string_view text) {
    std::vector<std::string> tags;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        std::string_view tag = text.substr(0, comma);
        text.remove_prefix(std::min(comma + 1, text.size()));
        while (tag.starts_with(' ')) tag.remove_prefix(1);
        while (tag.ends_with(' ')) tag.remove_suffix(1);
        std::string one = lower(tag);
        if (!one.empty() && std::find(tags.begin(), tags.end(), one) == tags.end()) tags.push_back(std::move(one));
    }
    return tags;
}

/// The text after "format": in a file that may be cut off anywhere; empty: there is none.
std::string_view format_of(std::string_view text) {
    constexpr std::string_view key = "\"format\"", space = " \t\r\n";
    const std::size_t found = text.find(key);
    if (found == std::string_view::npos) return {};
    text.remove_prefix(found + key.size());
    text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
    if (!text.starts_with(':')) return {};
    text.remove_prefix(1);
    text.remove_prefix(std::min(text.find_first_not_of(space), text.size()));
    if (!text.starts_with('"')) return {};
    return text.substr(1, text.find('"', 1) - 1);
}

/// Scenes and schemas lie in such folders, too. A file whose format cannot be told may be a broken preset.
bool other_kind(std::string_view text) {
    const std::string_view format = format_of(text);
    return format == "lapfx.scene" || (format.empty() && text.find("\"$schema\"") != std::string_view::npos);
}

std::string tip_of(const PresetFile& file, const Preset& preset) {
    std::string tip = preset.description;
    if (!preset.tags.empty()) tip += (tip.empty() ? "" : "\n") + preset.tags;
    return tip + (tip.empty() ? "" : "\n") + file.file.string();
}

/// Never that of nothing.
std::uint64_t key_of(const fs::path& path) {
    return ui::hash_bytes(0, path.string()) >> 1;
}

/// False: the file is no preset.
bool read_preset(const fs::path& path, PresetFile& file) {
    std::error_code error;
    file.file = path;
    file.name = path.stem().string();
    file.key = key_of(path);
    file.modified = fs::last_write_time(path, error);
    try {
        const std::string text = read_file(path, longest);
        if (other_kind(text)) return false;
        const Preset preset = parse_preset(text, path.string(), path.parent_path());
        if (!preset.name.empty()) file.name = preset.name;
        file.tags = split_tags(preset.tags);
        file.words = lower(file.name + ' ' + preset.description + ' ' + preset.tags + ' ' + path.stem().string());
        file.tip = tip_of(file, preset);
    } catch (const Error& failure) {
        const std::vector<Fault>& faults = failure.faults();
        file.fault = faults.front().text();
        if (faults.size() > 1) file.fault += "\nand " + std::to_string(faults.size() - 1) + " more";
        file.words = lower(file.name);
        file.tip = "Cannot be opened: " + file.fault;
    }
    return true;
}

}  // namespace

Browser::Browser(const EditorOptions& options, document::Document& document, Settings& settings, Jobs& jobs,
                 ui::ImageStore& images, Notices& notices, Screen& screen)
    : options_(options),
      document_(document),
      settings_(settings),
      jobs_(jobs),
      images_(images),
      notices_(notices),
      screen_(screen) {}
Browser::~Browser() = default;

std::vector<fs::path> Browser::folders() const {
    std::vector<fs::path> all{options_.data_folder / "presets"};
    if (!document_.preset_file().empty()) all.push_back(fs::absolute(document_.preset_file()).parent_path());
    for (const std::string& folder : settings_.preset_folders) all.emplace_back(folder);
    return all;
}

Browser::ScannedPresets Browser::look(const std::vector<fs::path>& folders) {
    std::vector<fs::path> paths;
    std::error_code error;
    for (const fs::path& folder : folders) {
        std::size_t count = 0;
        for (fs::directory_iterator it(folder, error), end; !error && it != end && count < most_files;
             it.increment(error)) {
            if (!is_named_as(Content::document, it->path()) || !it->is_regular_file(error)) continue;
            paths.push_back(fs::absolute(it->path()).lexically_normal());
            ++count;
        }
        error.clear();  // a folder that is gone has no presets
    }
    std::sort(paths.begin(), paths.end());
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    ScannedPresets found;
    for (const fs::path& path : paths) {
        PresetFile file;
        if (read_preset(path, file)) found.files.push_back(std::move(file));
    }
    return found;
}

void Browser::scan() {
    stale_ = false;
    scanned_beside_ = document_.preset_file();
    current_ = scanned_beside_.empty() ? fs::path() : fs::absolute(scanned_beside_).lexically_normal();
    current_key_ = key_of(current_);
    scanned_saved_ = document_.saved_preset();
    scanning_ = jobs_.start(
        "Presets",
        [this, all = folders()](Job&) -> Jobs::Apply {
            auto found = std::make_shared<ScannedPresets>(look(all));
            return [this, found] { take(std::move(*found)); };
        },
        [this](const std::vector<Fault>& faults) {
            scanning_.reset();
            notices_.tell(faults);
        });
}

/// Pictures of files that are still there stay until there are newer ones.
void Browser::take(ScannedPresets found) {
    scanning_.reset();
    for (PresetFile& file : files_) {
        const auto same = std::find_if(found.files.begin(), found.files.end(), [&](const PresetFile& other) {
            return other.file == file.file && other.fault.empty();
        });
        if (same != found.files.end()) {
            same->image = file.image;
        } else if (file.image != 0) {
            images_.remove(file.image);
        }
    }
    files_ = std::move(found.files);
    sorted_ = false;
    count_tags();
    want_thumbnails();
}

void Browser::count_tags() {
    std::map<std::string, int> counts;
    for (const PresetFile& file : files_)
        for (const std::string& tag : file.tags) ++counts[tag];
    tags_.clear();
    for (const auto& [tag, count] : counts) tags_.push_back(tag);
    std::stable_sort(tags_.begin(), tags_.end(),
                     [&](const std::string& a, const std::string& b) { return counts.at(a) > counts.at(b); });
    std::erase_if(chosen_tags_, [&](const std::string& tag) { return !counts.contains(tag); });
}

void Browser::start_maker() {
    ThumbnailMaker::Options options;
    options.cache = options_.folders.cache;
    options.clip_folders = options_.clip_folders;
    options.program = program_;
    options.render = renders_ && !options_.exact;
    options.wake = [this] { screen_.wake("thumbnail"); };
    maker_ = std::make_unique<ThumbnailMaker>(std::move(options));
}

void Browser::render_with(const fs::path& program) {
    program_ = program;
    ThumbnailMaker::Options options;
    options.cache = options_.folders.cache;
    options.clip_folders = options_.clip_folders;
    options.program = program_;
    options.longest = std::chrono::hours(1);  // a test has a limit of its own
    maker_ = std::make_unique<ThumbnailMaker>(std::move(options));
}

/// On the scene that is open, as it lies in its file; without one, on the sample.
void Browser::want_thumbnails() {
    if (maker_ == nullptr) start_maker();
    const fs::path& open = document_.scene_file();
    scene_ = open.empty() ? options_.data_folder / "samples" / "lagb.scene.json" : fs::absolute(open);
    std::vector<ThumbnailMaker::Request> requests;
    for (const PresetFile& file : files_)
        if (file.fault.empty())
            requests.push_back({.file = file.file, .scene = scene_, .time = thumbnail_at * document_.scene().duration});
    maker_->want(std::move(requests));
    if (options_.exact) maker_->finish();
}

void Browser::take_thumbnails() {
    if (maker_ == nullptr) return;
    for (const ThumbnailMaker::Result& result : maker_->take()) {
        const auto file =
            std::find_if(files_.begin(), files_.end(), [&](const auto& f) { return f.file == result.file; });
        if (file == files_.end()) continue;
        if (!result.fault.empty()) file->tip += "\nNo picture: " + result.fault;
        if (result.rgba.empty()) continue;
        if (file->image == 0) {
            file->image = images_.add(result.size, result.rgba);
        } else {
            images_.update(file->image, result.size, result.rgba);
        }
    }
}

void Browser::show() {
    shown_ = true;
    if (!seen_) screen_.wake("presets are searched");  // the search begins with the next update()
}

void Browser::update(double) {
    if (scanning_ && scanning_->cancelled()) scanning_.reset();  // the list of jobs cancels; "Look again" begins anew
    take_thumbnails();
    const bool seen = std::exchange(shown_, false);
    if (!seen) {
        if (seen_ && maker_ != nullptr) maker_->want({});
        seen_ = false;
        return;
    }
    const bool came = !std::exchange(seen_, true);
    stale_ |= came || scanned_beside_ != document_.preset_file() || scanned_saved_ != document_.saved_preset();
    if (stale_ && !scanning_) scan();
}

const std::vector<std::size_t>& Browser::found() {
    if (sorted_ && found_for_ == search && found_order_ == order && found_stars_ == stars_only) return found_;
    sorted_ = true;
    found_for_ = search;
    found_order_ = order;
    found_stars_ = stars_only;
    found_.clear();
    for (std::size_t i = 0; i < files_.size(); ++i) {
        const PresetFile& file = files_[i];
        const bool tagged = std::all_of(chosen_tags_.begin(), chosen_tags_.end(), [&](const std::string& tag) {
            return std::find(file.tags.begin(), file.tags.end(), tag) != file.tags.end();
        });
        if (tagged && (!stars_only || starred(i)) && ui::contains_words(file.words, search)) found_.push_back(i);
    }
    std::stable_sort(found_.begin(), found_.end(), [&](std::size_t a, std::size_t b) {
        if (order == PresetOrder::newest) return files_[a].modified > files_[b].modified;
        return lower(files_[a].name) < lower(files_[b].name);
    });
    return found_;
}

bool Browser::has_tag(std::string_view tag) const {
    return std::find(chosen_tags_.begin(), chosen_tags_.end(), tag) != chosen_tags_.end();
}

void Browser::choose_tag(std::string_view tag, bool on) {
    std::erase(chosen_tags_, tag);
    if (on) chosen_tags_.emplace_back(tag);
    sorted_ = false;
}

bool Browser::starred(std::size_t file) const {
    const std::vector<std::string>& stars = settings_.preset_stars;
    return std::find(stars.begin(), stars.end(), files_[file].file.native()) != stars.end();
}

void Browser::star(std::size_t file, bool on) {
    std::vector<std::string>& stars = settings_.preset_stars;
    std::erase(stars, files_[file].file.string());
    if (on) stars.push_back(files_[file].file.string());
    sorted_ = false;
}

bool Browser::current(std::size_t file) const {
    return files_[file].file == current_;
}

void Browser::take_values(std::size_t index) {
    const fs::path file = files_[index].file;
    try {
        Preset preset = load_preset(file);
        const Preset& open = document_.preset();
        std::error_code error;
        // Its own clips cannot be named from another folder: a preset's paths stay inside its own.
        const bool own_clips =
            preset.folder != open.folder &&
            std::any_of(preset.smoke.clips.begin(), preset.smoke.clips.end(),
                        [&](const SmokeClip& c) { return fs::exists(preset.folder / c.file, error); });
        if (own_clips) {
            preset.smoke.clips = open.smoke.clips;
            notices_.add(
                {.kind = ui::ToastKind::warning,
                 .text = "The clips of " + preset.name +
                         " are in its own folder, so the clips stay as they were: open the preset to use its clips"});
        }
        const std::string name = preset.name;
        preset.name = open.name;
        preset.description = open.description;
        preset.tags = open.tags;
        preset.folder = open.folder;
        document_.change("Values of " + name, [&](document::Content& c) { c.preset = std::move(preset); });
    } catch (const Error& failure) {
        notices_.tell(failure);
    }
}

void Browser::add_folder(const fs::path& folder) {
    std::vector<std::string>& all = settings_.preset_folders;
    const std::string text = fs::absolute(folder).lexically_normal().string();
    if (std::find(all.begin(), all.end(), text) == all.end()) all.push_back(text);
    stale_ = true;
}

void Browser::remove_folder(const fs::path& folder) {
    std::erase(settings_.preset_folders, folder.string());
    stale_ = true;
}

const std::vector<std::string>& Browser::own_folders() const {
    return settings_.preset_folders;
}

bool Browser::busy() const {
    return !seen_ || stale_ || scanning_ != nullptr || (maker_ != nullptr && maker_->busy());
}

}  // namespace lapfx::app
