#include "output/bundle.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "lapfx/clip.h"
#include "output/files.h"

namespace lapfx::output {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t piece = std::size_t{1} << 20;  // bytes copied at once
constexpr int highest_first = 999;                   // number of a sequence's first image

Fault clip_fault(std::size_t index, const std::string& reason) {
    return {.file = "", .place = "/smoke/clips/" + std::to_string(index) + "/file", .reason = reason};
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

/// The images of "plume_%04d.png", as they are counted when it is played: from the lowest number on, without a gap.
std::vector<fs::path> sequence_files(const fs::path& pattern) {
    const std::string name = pattern.filename().string();
    const std::size_t percent = name.find('%');
    if (percent == std::string::npos || name.find('%', percent + 1) != std::string::npos) return {};
    std::size_t end = percent + 1;
    int digits = 1;
    if (end + 1 < name.size() && name[end] == '0' && name[end + 1] >= '1' && name[end + 1] <= '9') {
        digits = name[end + 1] - '0';
        end += 2;
    }
    if (end >= name.size() || name[end] != 'd') return {};
    const auto file = [&](int number) {
        std::string text = std::to_string(number);
        if (text.size() < static_cast<std::size_t>(digits))
            text.insert(0, static_cast<std::size_t>(digits) - text.size(), '0');
        return pattern.parent_path() / (name.substr(0, percent) + text + name.substr(end + 1));
    };
    int first = 0;
    while (first <= highest_first && !is_file(file(first))) ++first;
    std::vector<fs::path> files;
    for (int i = first; is_file(file(i)); ++i) files.push_back(file(i));
    return files;
}

/// Names within a folder: the same file once, another of the same name beside it as "plume-2.mp4".
class Names {
  public:
    /// Gives whether it is new.
    bool place(const fs::path& source, const std::string& wanted, std::string& name) {
        std::error_code error;
        const fs::path real = fs::weakly_canonical(source, error);
        if (const auto known = names_.find(real); known != names_.end()) {
            name = known->second;
            return false;
        }
        const fs::path path = wanted;
        name = wanted;
        const auto taken = [&] {
            return std::any_of(names_.begin(), names_.end(), [&](const auto& n) { return n.second == name; });
        };
        for (int i = 2; taken(); ++i) name = path.stem().string() + "-" + std::to_string(i) + path.extension().string();
        names_[real] = name;
        return true;
    }

  private:
    std::map<fs::path, std::string> names_;
};

/// An open file, closed at the end of the scope.
struct Descriptor {
    int number = -1;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

struct Copy {
    fs::path from, to;  ///< `to`: relative to the bundle
};

/// Absolute; "ooze/" is called "ooze".
fs::path plain(const fs::path& folder) {
    std::error_code error;
    const fs::path whole = fs::absolute(folder, error).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

class Writer {
  public:
    Writer(const Bundle& bundle, const std::function<bool(double)>& goes_on)
        : bundle_(bundle), goes_on_(goes_on), target_(plain(bundle.folder)), beside_(target_) {
        name_ = target_.filename().string();
    }

    BundleContent write() {
        plan_clips();
        plan_scene();
        for (const Copy& c : copies_) total_ += static_cast<double>(fs::file_size(c.from));
        for (const Copy& c : copies_) copy(c);
        save_preset(preset_, beside_ / (name_ + ".json"));
        if (scene_) save_scene(*scene_, beside_ / (name_ + ".scene.json"));
        write_png(beside_ / "thumbnail.png", bundle_.thumbnail);
        check_preset();
        if (scene_) check_scene();
        check_thumbnail();
        tell(1);
        publish();
        return {.files = copies_.size() + (scene_ ? 3U : 2U),
                .bytes = static_cast<std::size_t>(copied_),
                .clips = preset_.smoke.clips.size()};
    }

  private:
    [[noreturn]] void fail(const fs::path& file, const std::string& reason) const { throw cannot_write(file, reason); }

    void tell(double share) const {
        if (goes_on_ && !goes_on_(share)) fail(target_, "given up");
    }

    void plan_clips() {
        preset_ = bundle_.preset;
        preset_.folder = beside_.path();
        std::vector<Fault> faults;
        Names names;
        for (std::size_t i = 0; i < preset_.smoke.clips.size(); ++i) {
            std::string& file = preset_.smoke.clips[i].file;
            const ClipFiles found = clip_files(file, bundle_.preset.folder, bundle_.clip_folders);
            if (found.files.empty()) {
                faults.push_back(clip_fault(i, "\"" + file + "\": no such clip"));
                continue;
            }
            std::string name;
            // The images of a sequence keep their names, in a folder of their own.
            const std::string wanted = found.sequence ? found.files.front().stem().string() : found.name;
            const bool fresh = names.place(found.files.front(), wanted, name);
            for (const fs::path& from : found.files)
                if (fresh)
                    copies_.push_back(
                        {from, found.sequence ? fs::path("clips") / name / from.filename() : fs::path("clips") / name});
            file = found.sequence ? "clips/" + name + "/" + found.name : "clips/" + name;
        }
        if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    }

    /// A mesh of the scene on its way: with all files that it names, into a folder of its own.
    struct Mesh {
        std::string file;  ///< its new name; empty: the scene has none
        OrganOptions options;
        Organ organ;
    };
    Mesh plan_mesh(const std::string& file, const OrganOptions& options, const std::string& folder) {
        if (file.empty()) return {};
        const fs::path whole = bundle_.scene->folder / file;
        Mesh mesh{
            .file = folder + "/" + whole.filename().string(), .options = options, .organ = load_organ(whole, options)};
        std::set<fs::path> taken;
        for (const fs::path& from : mesh.organ.files) {
            const fs::path to = folder / from.lexically_relative(whole.parent_path());
            if (is_file(from) && taken.insert(to).second) copies_.push_back({from, to});
        }
        return mesh;
    }

    void plan_scene() {
        if (!bundle_.scene) return;
        scene_ = *bundle_.scene;
        scene_->folder = beside_.path();
        scene_->preset = name_ + ".json";
        scene_->reference = {};
        organ_ =
            plan_mesh(scene_->organ.file, {.scale = scene_->organ.scale, .rotation = scene_->organ.rotation}, "organ");
        tool_ = plan_mesh(scene_->tool.file, {.scale = scene_->tool.scale}, "tool");
        scene_->organ.file = organ_.file;
        scene_->tool.file = tool_.file;
    }

    void copy(const Copy& c) {
        const fs::path to = beside_.path() / c.to;
        fs::create_directories(to.parent_path());
        const Descriptor in{::open(c.from.c_str(), O_RDONLY | O_CLOEXEC)};
        if (in.number < 0) fail(c.from, std::string("cannot be read: ") + std::strerror(errno));
        const Descriptor out{::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)};
        if (out.number < 0) fail(target_ / c.to, std::string("cannot be written: ") + std::strerror(errno));
        std::vector<char> buffer(piece);
        for (;;) {
            const ssize_t got = ::read(in.number, buffer.data(), buffer.size());
            if (got < 0) fail(c.from, std::string("cannot be read: ") + std::strerror(errno));
            if (got == 0) break;
            for (ssize_t done = 0; done < got;) {
                const ssize_t put = ::write(out.number, buffer.data() + done, static_cast<std::size_t>(got - done));
                if (put < 0) fail(target_ / c.to, std::string("cannot be written: ") + std::strerror(errno));
                done += put;
            }
            copied_ += static_cast<double>(got);
            tell(total_ > 0 ? 0.9 * std::min(1.0, copied_ / total_) : 0.9);
        }
        if (::fsync(out.number) != 0) fail(target_ / c.to, std::string("cannot be written: ") + std::strerror(errno));
    }

    void check_preset() const {
        const fs::path file = beside_ / (name_ + ".json");
        const Preset loaded = load_preset(file);
        if (write_preset(loaded) != write_preset(preset_))
            fail(target_ / file.filename(), "does not come back as it was written");
        check_clips(loaded, (target_ / file.filename()).string(), {});
    }

    void check_mesh(const Mesh& mesh) const {
        if (mesh.file.empty()) return;
        const Organ& a = mesh.organ;
        const Organ b = load_organ(beside_.path() / mesh.file, mesh.options);
        const auto same_image = [](const Image& x, const Image& y) { return x.pixels == y.pixels; };
        if (a.positions != b.positions || a.indices != b.indices || a.uvs != b.uvs ||
            !std::equal(a.images.begin(), a.images.end(), b.images.begin(), b.images.end(), same_image))
            fail(target_ / mesh.file, "the copy is not the same organ; did its files change meanwhile?");
    }

    void check_scene() const {
        const fs::path file = beside_ / (name_ + ".scene.json");
        if (write_scene(load_scene(file)) != write_scene(*scene_))
            fail(target_ / file.filename(), "does not come back as it was written");
        tell(0.92);
        check_mesh(organ_);
        tell(0.96);
        check_mesh(tool_);
    }

    void check_thumbnail() const {
        const cv::Mat read = cv::imread((beside_ / "thumbnail.png").string());
        if (read.cols != bundle_.thumbnail.width || read.rows != bundle_.thumbnail.height)
            fail(target_ / "thumbnail.png", "does not come back as it was written");
    }

    /// A bundle that is there goes only when the new one has its name.
    void publish() {
        if (const std::string reason = check_bundle_folder(target_); !reason.empty()) fail(target_, reason);
        fs::permissions(beside_.path(), fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                                            fs::perms::others_read | fs::perms::others_exec);
        std::error_code error;
        if (!fs::exists(target_)) {
            fs::rename(beside_.path(), target_, error);
            if (error) fail(target_, "cannot be written: " + error.message());
            return;
        }
        const FolderBeside old(target_);
        fs::rename(target_, old / "old", error);
        if (error) fail(target_, "cannot be replaced: " + error.message());
        fs::rename(beside_.path(), target_, error);
        if (!error) return;
        const std::string reason = error.message();
        fs::rename(old / "old", target_, error);
        fail(target_, "cannot be replaced: " + reason);
    }

    const Bundle& bundle_;
    const std::function<bool(double)>& goes_on_;
    fs::path target_;
    FolderBeside beside_;
    std::string name_;
    Preset preset_;
    std::optional<Scene> scene_;
    Mesh organ_, tool_;
    std::vector<Copy> copies_;
    double total_ = 0, copied_ = 0;  ///< bytes
};

}  // namespace

ClipFiles clip_files(const std::string& clip, const fs::path& preset_folder,
                     const std::vector<fs::path>& clip_folders) {
    const auto look = [&](const fs::path& folder, bool shipped) -> ClipFiles {
        const fs::path path = folder / clip;
        if (is_file(path)) return {.files = {path}, .name = path.filename().string(), .shipped = shipped};
        std::vector<fs::path> files = sequence_files(path);
        return {.files = std::move(files), .name = path.filename().string(), .shipped = shipped, .sequence = true};
    };
    if (clip.empty()) return {};
    ClipFiles found = look(preset_folder, false);
    if (fs::path(clip).filename() != fs::path(clip)) return found;
    for (std::size_t i = 0; i < clip_folders.size() && found.files.empty(); ++i) found = look(clip_folders[i], true);
    return found;
}

Preset preset_in(const fs::path& folder, const Preset& preset, const std::vector<fs::path>& clip_folders,
                 std::vector<Fault>& faults) {
    Preset moved = preset;
    std::error_code error;
    const fs::path to = fs::weakly_canonical(fs::absolute(folder, error), error);
    for (std::size_t i = 0; i < moved.smoke.clips.size(); ++i) {
        std::string& file = moved.smoke.clips[i].file;
        const ClipFiles found = clip_files(file, preset.folder, clip_folders);
        if (found.files.empty()) {
            faults.push_back(clip_fault(i, "\"" + file + "\": no such clip"));
            continue;
        }
        if (found.shipped) {
            if (is_file(to / file))
                faults.push_back(clip_fault(
                    i, "another \"" + file + "\" lies in " + to.string() + " and would be taken for the shipped clip"));
            continue;
        }
        const fs::path source = fs::weakly_canonical(found.files.front().parent_path(), error) / found.name;
        const fs::path relative = source.lexically_relative(to);
        if (relative.empty() || *relative.begin() == "..")
            faults.push_back(clip_fault(i, "\"" + source.string() + "\" lies outside of " + to.string()));
        else
            file = relative.generic_string();
    }
    moved.folder = folder;
    return moved;
}

void export_preset(const Preset& preset, const fs::path& file, const std::vector<fs::path>& clip_folders) {
    std::vector<Fault> faults;
    const Preset moved = preset_in(fs::absolute(file).parent_path(), preset, clip_folders, faults);
    if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    save_preset(moved, file);
    if (write_preset(load_preset(file)) != write_preset(moved))
        throw cannot_write(file, "does not come back as it was written; is the disk sound?");
}

std::string check_bundle_folder(const fs::path& named) {
    const fs::path folder = plain(named);
    if (!folder.has_filename()) return "has no name that files could be called after";
    std::error_code error;
    const fs::file_status status = fs::symlink_status(folder, error);
    if (!fs::exists(status)) return "";
    if (!fs::is_directory(status)) return "is there and is not a folder";
    if (fs::is_empty(folder, error)) return "";
    const std::string name = folder.filename().string();
    const std::vector<std::string> ours{name + ".json", name + ".scene.json", "thumbnail.png", "clips", "organ",
                                        "tool"};
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string found = entry->path().filename().string();
        if (std::find(ours.begin(), ours.end(), found) == ours.end())
            return "is a folder with other things in it (" + found + "): name one that is not there yet";
    }
    if (error) return "cannot be read: " + error.message();
    if (!is_file(folder / (name + ".json")))
        return "is a folder with other things in it: name one that is not there yet";
    return "";
}

BundleContent write_bundle(const Bundle& bundle, const std::function<bool(double)>& goes_on) {
    if (const std::string reason = check_bundle_folder(bundle.folder); !reason.empty())
        throw cannot_write(bundle.folder, reason);
    try {
        return Writer(bundle, goes_on).write();
    } catch (const fs::filesystem_error& error) {
        throw cannot_write(bundle.folder, error.code().message());
    }
}

}  // namespace lapfx::output
