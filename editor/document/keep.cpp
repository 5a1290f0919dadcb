#include "document/keep.h"

#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "document/hash.h"
#include "document/tables.h"
#include "lapfx/authoring/file.h"

namespace lapfx::document {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_file = std::size_t{32} << 20U;
constexpr std::size_t snapshot_slots = 4;

Json disk_json(const OnDisk& disk) {
    return disk.exists ? Json(hex_of(disk.hash)) : Json(nullptr);
}

OnDisk disk_from(const Json& json) {
    if (!json.is_string()) return {};
    return {.exists = true, .hash = std::strtoull(json.get_ref<const std::string&>().c_str(), nullptr, 16)};
}

std::string text_at(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

template <typename Number>
Number number_at(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_number_integer() ? found->get<Number>() : Number{};
}

bool flag_at(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_boolean() && found->get<bool>();
}

/// A file name as JSON. File names may consist of any bytes, but JSON is UTF-8.
Json path_json(const fs::path& path) {
    std::error_code error;  // absolute, because the next editor may start in another folder
    const std::string bytes = path.empty() ? "" : fs::absolute(path, error).lexically_normal().native();
    try {
        (void)Json(bytes).dump();
        return bytes;
    } catch (const Json::exception&) {
        return "";  // the work is then kept without the name of its file
    }
}

Json document_json(const Json& text, const fs::path& folder, const fs::path& file, const OnDisk& disk, bool unsaved) {
    return {{"file", path_json(file)},
            {"folder", path_json(folder)},
            {"on_disk", disk_json(disk)},
            {"unsaved", unsaved},
            {"content", text}};
}

/// Replaces bytes that are not UTF-8, which a file's name may contain: the work matters more than that name.
Json parsed(std::string text) {
    Json json = Json::parse(text, nullptr, false);
    if (!json.is_discarded()) return json;
    for (char& c : text)
        if (static_cast<signed char>(c) < 0) c = '?';
    return Json::parse(text, nullptr, false);
}

/// The file that saving would write to. An editor keeps it as an absolute path of a document; anything else is refused.
fs::path file_at(const Json& json, const std::string& what, std::vector<std::string>& told) {
    const fs::path file = fs::path(text_at(json, "file")).lexically_normal();
    if (file.empty() || (file.is_absolute() && file.extension() == ".json")) return file;
    told.push_back(what + " /file: \"" + file.string() + "\" is not an absolute path of a .json file");
    return {};
}

template <typename Document>
Document read_document(const Table& table, const Json& json, const std::string& what, std::vector<std::string>& told) {
    Document document;
    const auto content = json.find("content");
    const std::string text = content == json.end() ? "" : content->dump();
    for (const std::string& fault : read_what_can_be(table, &document, text)) told.push_back(what + ' ' + fault);
    document.folder = fs::path(text_at(json, "folder")).lexically_normal();
    if (!document.folder.empty() && !document.folder.is_absolute()) {
        told.push_back(what + " /folder: \"" + document.folder.string() + "\" is not an absolute path");
        document.folder.clear();
    }
    return document;
}

struct Session {
    fs::path folder;
    std::vector<fs::path> files;  ///< the newest first
    fs::file_time_type time;
};

/// The kept files in `folder`, the newest first.
std::vector<fs::path> kept_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end(), std::greater<>());  // they are numbered with leading zeros
    return files;
}

std::vector<Session> sessions(const fs::path& all) {
    std::vector<Session> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(all, error)) {
        std::error_code ignored;
        if (!entry.is_directory(ignored) || entry.is_symlink(ignored)) continue;
        Session session{.folder = entry.path(), .files = kept_files(entry.path()), .time = {}};
        if (session.files.empty()) continue;
        session.time = fs::last_write_time(session.files.front(), ignored);
        found.push_back(std::move(session));
    }
    std::sort(found.begin(), found.end(), [](const Session& a, const Session& b) {
        return a.time != b.time ? a.time > b.time : a.folder > b.folder;
    });
    return found;
}

/// Removes up to `most` files of an ended editor, the oldest first, and leaves `kept` of them. Removes its folder, too,
/// when no file is left. A folder that cannot be locked is left alone: it belongs to another user, or another process
/// is using it.
void drop_oldest(Session& session, std::size_t most, std::size_t kept) {
    std::error_code error;
    try {
        const std::optional<Lock> lock = Lock::take(session.folder / "lock");
        for (; lock && most > 0 && session.files.size() > kept; --most) {
            fs::remove(session.files.back(), error);
            session.files.pop_back();
        }
    } catch (const Error&) {
        return;
    }
    if (session.files.empty()) fs::remove(session.folder, error);  // only when it is empty
}

/// Removes files that ended editors left behind, the oldest first. The newest file of each editor is removed only when
/// all the others are.
void drop_oldest(const fs::path& all, const fs::path& own) {
    std::vector<Session> found = sessions(all);
    std::size_t count = 0;
    for (const Session& session : found) count += session.files.size();
    for (const bool newest_too : {false, true}) {
        for (auto session = found.rbegin(); session != found.rend() && count > KeepFolder::most_in_all; ++session) {
            if (session->folder == own) continue;
            const std::size_t before = session->files.size();
            drop_oldest(*session, count - KeepFolder::most_in_all, newest_too ? 0 : 1);
            count -= before - session->files.size();
        }
    }
}

}  // namespace

std::string write_kept(const Kept& kept) {
    const Content& c = kept.content;
    Json json{{"format", "lapfx.autosave"},
              {"version", 1},
              {"time", kept.time},
              {"scene", document_json(parsed(write_scene(c.scene)), c.scene.folder, kept.scene_file, kept.scene_disk,
                                      kept.scene_unsaved)},
              {"preset", document_json(parsed(write_preset(c.preset)), c.preset.folder, kept.preset_file,
                                       kept.preset_disk, kept.preset_unsaved)},
              {"snapshots", Json::array()}};
    for (const KeptSnapshot& snapshot : kept.snapshots)
        json["snapshots"].push_back({{"slot", snapshot.slot},
                                     {"time", snapshot.time},
                                     {"file", path_json(snapshot.file)},
                                     {"folder", path_json(snapshot.preset.folder)},
                                     {"content", parsed(write_preset(snapshot.preset))}});
    return json.dump(1) + '\n';
}

Kept read_kept(const fs::path& file, std::vector<std::string>& told) {
    const Json json = Json::parse(read_file(file, longest_file), nullptr, false);
    const auto refuse = [&](const char* reason) { throw Error(Failure::bad_input, Fault{file.string(), "", reason}); };
    if (!json.is_object() || text_at(json, "format") != "lapfx.autosave") refuse("not a file that the editor keeps");
    if (number_at<int>(json, "version") != 1) refuse("kept by another version of lapfx");
    const auto scene = json.find("scene"), preset = json.find("preset"), snapshots = json.find("snapshots");
    if (scene == json.end() || !scene->is_object() || preset == json.end() || !preset->is_object())
        refuse("scene or preset is missing");
    Kept kept{.time = number_at<std::int64_t>(json, "time"),
              .content = {read_document<Scene>(scene_table(), *scene, "scene", told),
                          read_document<Preset>(preset_table(), *preset, "preset", told)},
              .scene_file = file_at(*scene, "scene", told),
              .preset_file = file_at(*preset, "preset", told),
              .scene_disk = disk_from(scene->value("on_disk", Json())),
              .preset_disk = disk_from(preset->value("on_disk", Json())),
              .scene_unsaved = flag_at(*scene, "unsaved"),
              .preset_unsaved = flag_at(*preset, "unsaved"),
              .snapshots = {}};
    if (snapshots == json.end() || !snapshots->is_array()) return kept;
    for (const Json& snapshot : *snapshots) {
        const auto slot = snapshot.is_object() ? number_at<std::int64_t>(snapshot, "slot") : -1;
        if (slot < 0 || slot >= static_cast<std::int64_t>(snapshot_slots)) continue;
        kept.snapshots.push_back({.slot = static_cast<std::size_t>(slot),
                                  .time = number_at<std::int64_t>(snapshot, "time"),
                                  .preset = read_document<Preset>(preset_table(), snapshot, "snapshot", told),
                                  .file = file_at(snapshot, "snapshot", told)});
    }
    return kept;
}

void KeepFolder::write(const Kept& kept) {
    std::error_code error;
    if (lock_ && !fs::exists(lock_->file(), error)) remove();  // someone has removed the folder
    for (unsigned attempt = 0; !lock_; ++attempt) {
        own_ = all_ / (hex_of(static_cast<std::uint64_t>(kept.time)).substr(6) + '-' + std::to_string(::getpid()) +
                       '-' + std::to_string(attempt));
        lock_ = Lock::take(own_ / "lock");
        if (!kept_files(own_).empty()) lock_.reset();  // they belong to another editor that used the same name
    }
    std::string number = std::to_string(++count_);
    number.insert(0, 8 - std::min<std::size_t>(8, number.size()), '0');
    write_file(own_ / (number + ".json"), write_kept(kept));
    const std::vector<fs::path> files = kept_files(own_);
    for (std::size_t i = most_files; i < files.size(); ++i) fs::remove(files[i], error);
    drop_oldest(all_, own_);
}

void KeepFolder::remove() {
    std::error_code error;
    if (!own_.empty())
        for (const fs::path& file : kept_files(own_)) fs::remove(file, error);
    lock_.reset();
    if (!own_.empty()) fs::remove(own_, error);  // only when it is empty
    own_.clear();
    count_ = 0;
}

std::vector<LeftBehind> find_left_behind(const fs::path& folder) {
    std::vector<LeftBehind> found;
    for (Session& session : sessions(folder)) {
        try {
            std::optional<Lock> lock = Lock::take(session.folder / "lock");
            if (!lock) continue;
            const auto time = std::chrono::file_clock::to_sys(session.time);
            found.push_back(
                {.folder = session.folder,
                 .lock = std::move(*lock),
                 .files = std::move(session.files),
                 .time = std::chrono::duration_cast<std::chrono::seconds>(time.time_since_epoch()).count()});
        } catch (const Error&) {
            continue;  // a folder that cannot be locked cannot be taken over either
        }
    }
    return found;
}

void discard(LeftBehind left) {
    std::error_code error;
    for (const fs::path& file : left.files) {
        fs::remove(file, error);
        if (error) throw Error(Failure::runtime, Fault{file.string(), "", "cannot be removed: " + error.message()});
    }
    { const Lock released = std::move(left.lock); }
    fs::remove(left.folder, error);
}

}  // namespace lapfx::document
