#include "output/bundle.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <map>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/compare.h"
#include "lapfx/authoring/documents.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/formats.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/authoring/pack.h"
#include "lapfx/authoring/picture.h"
#include "lapfx/authoring/prepared_scene.h"
#include "output/files.h"

namespace lapfx::output {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t block = std::size_t{1} << 20;  // bytes copied at once

Fault clip_fault(std::size_t index, const std::string& reason) {
    return {.file = "", .place = "/smoke/clips/" + std::to_string(index) + "/file", .reason = reason};
}

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(path, error);
}

/// The extension of a clip's copy: that of `name` if it is a video's or a picture's, else ".clip".
std::string clip_extension(const std::string& name) {
    const std::string extension = lower(fs::path(name).extension().string());
    const FileFormat* const format = format_named(name);
    return format != nullptr && (format->content == Content::video || format->content == Content::picture) ? extension
                                                                                                           : ".clip";
}

/// An open file, closed at the end of the scope.
struct Descriptor {
    int number = -1;
    ~Descriptor() {
        if (number >= 0) ::close(number);
    }
};

/// A file of the bundle: a copy of `from`, or `bytes` if `from` is empty.
struct Piece {
    fs::path to;  ///< relative to the bundle; made of names of our own
    fs::path from;
    std::vector<std::uint8_t> bytes;

    std::uintmax_t size() const { return from.empty() ? bytes.size() : fs::file_size(from); }
};

/// The absolute path without a slash at its end.
fs::path plain(const fs::path& folder) {
    std::error_code error;
    const fs::path whole = fs::absolute(folder, error).lexically_normal();
    return whole.has_filename() ? whole : whole.parent_path();
}

bool same_material(const Material& a, const Material& b) {
    return a.name == b.name && a.base_color == b.base_color && a.roughness == b.roughness &&
           a.normal_scale == b.normal_scale && a.base_color_image == b.base_color_image &&
           a.normal_image == b.normal_image && a.double_sided == b.double_sided;
}

/// Whether everything that is drawn of the two is the same and has the same names.
bool same_organ(const Organ& a, const Organ& b) {
    const auto same_part = [](const Part& x, const Part& y) {
        return x.name == y.name && x.first_index == y.first_index && x.index_count == y.index_count &&
               x.material == y.material;
    };
    const auto same_image = [](const Image& x, const Image& y) {
        return x.width == y.width && x.height == y.height && x.pixels == y.pixels;
    };
    const auto same = [](const auto& x, const auto& y, const auto& equal) {
        return std::equal(x.begin(), x.end(), y.begin(), y.end(), equal);
    };
    return a.positions == b.positions && a.normals == b.normals && a.uvs == b.uvs && a.colors == b.colors &&
           a.indices == b.indices && same(a.parts, b.parts, same_part) &&
           same(a.materials, b.materials, same_material) && same(a.images, b.images, same_image);
}

class Writer {
  public:
    Writer(const Bundle& bundle, const std::function<bool(double)>& goes_on)
        : bundle_(bundle), goes_on_(goes_on), target_(plain(bundle.folder)), beside_(target_, Beside::Kind::folder) {
        name_ = target_.filename().string();
    }

    BundleContent write() {
        plan_clips();
        plan_scene();
        for (const Piece& piece : pieces_) total_ += static_cast<double>(piece.size());
        for (const Piece& piece : pieces_) put(piece);
        put_named(name_ + ".json", [&](const fs::path& to) { save_preset(preset_, to); });
        if (scene_) put_named(name_ + ".scene.json", [&](const fs::path& to) { save_scene(*scene_, to); });
        put_named("thumbnail.png", [&](const fs::path& to) { write_png(to, bundle_.thumbnail); });
        check_preset();
        if (scene_) check_scene();
        check_thumbnail();
        tell(1);
        publish();
        return {.files = pieces_.size() + (scene_ ? 3U : 2U),
                .bytes = static_cast<std::size_t>(copied_),
                .clips = preset_.smoke.clips.size()};
    }

  private:
    [[noreturn]] void fail(const fs::path& file, const std::string& reason) const { throw cannot_write(file, reason); }

    void tell(double share) const {
        if (goes_on_ && !goes_on_(share)) fail(target_, "cancelled");
    }

    void plan_clips() {
        preset_ = bundle_.preset;
        preset_.folder = beside_.path();
        std::vector<Fault> faults;
        for (std::size_t i = 0; i < preset_.smoke.clips.size(); ++i) {
            std::string& file = preset_.smoke.clips[i].file;
            const ClipFiles found = clip_files(file, bundle_.preset.folder, bundle_.clip_folders);
            if (found.files.empty())
                faults.push_back(clip_fault(i, found.fault));
            else
                file = plan_clip(found);
        }
        if (!faults.empty()) throw Error(Failure::bad_input, std::move(faults));
    }

    /// Plans the copy of a clip and gives its name in the bundle. A file that several clips use is copied once. A
    /// different file of the same name becomes "plume-2.mp4".
    std::string plan_clip(const ClipFiles& found) {
        std::error_code error;
        // A sequence is identified by its pattern, because its first image may also be a clip of its own or the first
        // image of another sequence.
        const fs::path& first = found.files.front();
        const fs::path real = found.sequence ? fs::weakly_canonical(first.parent_path(), error) / found.name
                                             : fs::weakly_canonical(first, error);
        if (const auto known = clips_.find(real); known != clips_.end()) return known->second;
        const std::string extension = clip_extension(found.name), before = found.name.substr(0, found.name.find('%'));
        std::string name =
            clip_names_.give(found.sequence ? before + "frames" : found.name, found.sequence ? "" : extension);
        if (!found.sequence) {
            pieces_.push_back({.to = fs::path("clips") / name, .from = first, .bytes = {}});
        } else {
            // The images go into a folder of their own and are numbered from 0.
            for (std::size_t i = 0; i < found.files.size(); ++i) {
                std::string number = std::to_string(i);
                number.insert(0, 6 - std::min<std::size_t>(6, number.size()), '0');
                pieces_.push_back(
                    {.to = fs::path("clips") / name / (number + extension), .from = found.files[i], .bytes = {}});
                images_.push_back(pieces_.size() - 1);
            }
            name += "/%06d" + extension;
        }
        return clips_[real] = "clips/" + name;
    }

    /// A mesh of the scene. It is copied into a folder of its own with all files that it names.
    struct Mesh {
        std::string file;  ///< its new name; empty: the scene has none
        OrganOptions options;
        Organ organ;
    };
    Mesh plan_mesh(const std::string& file, const OrganOptions& options, const std::string& folder) {
        if (file.empty()) return {};
        const fs::path whole = named_path(bundle_.scene->folder, file, Reach::anywhere);
        Mesh mesh{.file = {}, .options = options, .organ = load_organ(whole, options)};
        for (PackedFile& packed : pack_organ(whole)) {
            if (mesh.file.empty()) mesh.file = folder + '/' + packed.name;
            pieces_.push_back({.to = fs::path(folder) / packed.name, .from = {}, .bytes = std::move(packed.bytes)});
        }
        return mesh;
    }

    void plan_scene() {
        if (!bundle_.scene) return;
        scene_ = *bundle_.scene;
        scene_->folder = beside_.path();
        scene_->preset = name_ + ".json";
        scene_->reference = {};
        scene_->plate.use = false;  // it is a frame of the reference
        organ_ = plan_mesh(scene_->organ.file, organ_options(*bundle_.scene), "organ");
        plan_texture();
        tool_ = plan_mesh(scene_->tool.file, {.scale = scene_->tool.scale}, "tool");
        scene_->organ.file = organ_.file;
        scene_->tool.file = tool_.file;
    }

    /// What goes wrong is told of the file in the bundle: nobody sees the folder that it is written to.
    template <typename Write>
    void put_named(const std::string& name, const Write& write) const {
        try {
            write(beside_ / name);
        } catch (const Error& error) {
            fail(target_ / name, error.faults().front().reason);
        }
    }

    void plan_texture() {
        const fs::path from = organ_.options.texture;
        if (organ_.file.empty() || from.empty()) return;
        scene_->organ.texture = "texture/" + OwnNames().give(from.filename().string(), clip_extension(from.string()));
        pieces_.push_back({.to = scene_->organ.texture, .from = from, .bytes = {}});
        organ_.options.texture = beside_.path() / scene_->organ.texture;
    }

    void put(const Piece& piece) {
        const fs::path to = beside_.path() / piece.to;
        fs::create_directories(to.parent_path());
        const Descriptor out{::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)};
        if (out.number < 0) fail(target_ / piece.to, std::string("cannot be written: ") + std::strerror(errno));
        if (piece.from.empty())
            write_all(out, piece, {reinterpret_cast<const char*>(piece.bytes.data()), piece.bytes.size()});
        else
            copy(out, piece);
        if (::fsync(out.number) != 0)
            fail(target_ / piece.to, std::string("cannot be written: ") + std::strerror(errno));
    }

    void copy(const Descriptor& out, const Piece& piece) {
        const Descriptor in{::open(piece.from.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
        if (in.number < 0) fail(piece.from, std::string("cannot be read: ") + std::strerror(errno));
        for (std::vector<char> buffer(block);;) {
            const ssize_t got = ::read(in.number, buffer.data(), buffer.size());
            if (got < 0) fail(piece.from, std::string("cannot be read: ") + std::strerror(errno));
            if (got == 0) return;
            write_all(out, piece, {buffer.data(), static_cast<std::size_t>(got)});
        }
    }

    void write_all(const Descriptor& out, const Piece& piece, std::string_view bytes) {
        while (!bytes.empty()) {
            const ssize_t put = ::write(out.number, bytes.data(), std::min(bytes.size(), block));
            if (put < 0) fail(target_ / piece.to, std::string("cannot be written: ") + std::strerror(errno));
            bytes.remove_prefix(static_cast<std::size_t>(put));
            copied_ += static_cast<double>(put);
            tell(total_ > 0 ? 0.9 * std::min(1.0, copied_ / total_) : 0.9);
        }
    }

    void check_preset() const {
        const fs::path file = beside_ / (name_ + ".json");
        const Preset loaded = load_preset(file);
        if (!equal(preset_table(), &loaded, &preset_))
            fail(target_ / file.filename(), "is not the same when read back");
        check_clips(loaded, (target_ / file.filename()).string(), {});
        for (const std::size_t image : images_) check_image(pieces_[image]);
    }

    void check_image(const Piece& piece) const {
        try {
            report_clip(beside_.path() / piece.to);
        } catch (const Error& error) {
            throw Error(Failure::bad_input, Fault{piece.from.string(), "", error.faults().front().reason});
        }
    }

    void check_mesh(const Mesh& mesh) const {
        if (mesh.file.empty()) return;
        if (!same_organ(mesh.organ, load_organ(beside_.path() / mesh.file, mesh.options)))
            fail(target_ / mesh.file, "the copy is not the same organ; did its files change meanwhile?");
    }

    void check_scene() const {
        const fs::path file = beside_ / (name_ + ".scene.json");
        if (const Scene loaded = load_scene(file); !equal(scene_table(), &loaded, &*scene_))
            fail(target_ / file.filename(), "is not the same when read back");
        tell(0.92);
        check_mesh(organ_);
        tell(0.96);
        check_mesh(tool_);
    }

    void check_thumbnail() const {
        const Image read = read_image(beside_ / "thumbnail.png").image;
        if (read.width != bundle_.thumbnail.width || read.height != bundle_.thumbnail.height)
            fail(target_ / "thumbnail.png", "is not the same when read back");
    }

    /// Gives the bundle its name. An older bundle is removed only after that.
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
        // The two are exchanged in one operation, so that one of them exists under the name at any time. The old one
        // is removed together with `beside_`.
        if (::renameat2(AT_FDCWD, beside_.path().c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) == 0) return;
        // Where the file system cannot exchange them, the old one gets a name that nothing cleans up: if the process is
        // killed before the next rename, the old one is still there.
        const fs::path old = target_.string() + ".before";
        fs::rename(target_, old, error);
        if (error) fail(target_, "cannot be replaced: " + error.message());
        fs::rename(beside_.path(), target_, error);
        const std::string reason = error.message();
        if (error) {
            fs::rename(old, target_, error);
            fail(target_, "cannot be replaced: " + reason);
        }
        fs::remove_all(old, error);
    }

    const Bundle& bundle_;
    const std::function<bool(double)>& goes_on_;
    fs::path target_;
    Beside beside_;
    std::string name_;
    Preset preset_;
    std::optional<Scene> scene_;
    Mesh organ_, tool_;
    std::vector<Piece> pieces_;
    OwnNames clip_names_;
    std::map<fs::path, std::string> clips_;  ///< names in the bundle, by the path of the file or of the pattern
    std::vector<std::size_t> images_;        ///< pieces of sequences: the preset's check opens only the first of each
    double total_ = 0, copied_ = 0;          ///< bytes
};

}  // namespace

ClipFiles clip_files(const std::string& clip, const fs::path& preset_folder,
                     const std::vector<fs::path>& clip_folders) {
    ClipFiles found;
    try {
        const fs::path path = find_clip(clip, preset_folder, clip_folders);
        const auto lies_in = [&](const fs::path& folder) { return folder / clip == path; };
        found.name = path.filename().string();
        found.shipped = path != preset_folder / clip && std::any_of(clip_folders.begin(), clip_folders.end(), lies_in);
        found.files = clip_images(path);
        found.sequence = !found.files.empty();
        if (!found.sequence) found.files.push_back(path);
    } catch (const Error& error) {
        std::string reason = error.faults().front().reason;
        if (reason.starts_with("no such clip")) reason = "no such clip";
        found.fault = reason.starts_with('"') ? reason : '"' + clip + "\": " + reason;
    }
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
            faults.push_back(clip_fault(i, found.fault));
            continue;
        }
        if (found.shipped) {
            if (is_file(to / file))
                faults.push_back(clip_fault(i, "another \"" + file + "\" is in " + to.string() +
                                                   " and would be used instead of the shipped clip"));
            continue;
        }
        const fs::path source = fs::weakly_canonical(found.files.front().parent_path(), error) / found.name;
        const fs::path relative = source.lexically_relative(to);
        if (relative.empty() || *relative.begin() == "..")
            faults.push_back(clip_fault(i, "\"" + source.string() + "\" is outside " + to.string()));
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
    if (const Preset loaded = load_preset(file); !equal(preset_table(), &loaded, &moved))
        throw cannot_write(file, "is not the same when read back; is the disk damaged?");
}

std::string check_bundle_folder(const fs::path& named) {
    const fs::path folder = plain(named);
    if (!folder.has_filename()) return "has no name to use for the files in it";
    std::error_code error;
    const fs::file_status status = fs::symlink_status(folder, error);
    if (!fs::exists(status)) return "";
    if (!fs::is_directory(status)) return "exists and is not a folder";
    if (fs::is_empty(folder, error)) return "";
    const std::string name = folder.filename().string();
    const std::vector<std::string> ours{name + ".json", name + ".scene.json", "thumbnail.png", "clips", "organ",
                                        "tool"};
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const std::string found = entry->path().filename().string();
        if (std::find(ours.begin(), ours.end(), found) == ours.end())
            return "is a folder with other files in it (" + found + "): choose a name that does not exist yet";
    }
    if (error) return "cannot be read: " + error.message();
    if (!is_file(folder / (name + ".json")))
        return "is a folder with other files in it: choose a name that does not exist yet";
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
