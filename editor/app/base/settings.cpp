#include "app/base/settings.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/base/layouts.h"
#include "app/base/notices.h"
#include "lapfx/authoring/file.h"

namespace lapfx::app {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_recent = 12, most_listed = 1000;
constexpr std::size_t longest_file = std::size_t{1} << 20U;
constexpr std::string_view shown_layout = "(shown)";
constexpr float least_scale = 0.75F, most_scale = 3;
constexpr std::int64_t most_screen = 1 << 20;  // no desktop is larger

/// Reads one key after the other; one of the wrong type is told, and left as it was.
class Reader {
  public:
    Reader(const Json& json, std::vector<std::string>& faults) : json_(json), faults_(faults) {}

    void flag(const char* key, bool& value) {
        if (const Json* j = find(key); j != nullptr && expect(j->is_boolean(), key, "true or false")) value = *j;
    }
    void number(const char* key, float& value, float low, float high) {
        const Json* j = find(key);
        if (j == nullptr || !expect(j->is_number(), key, "a number")) return;
        const auto read = j->get<float>();
        if (expect(read == 0 || (read >= low && read <= high), key, "0, or a number from 0.75 to 3")) value = read;
    }
    void text(const char* key, std::string& value) {
        if (const Json* j = find(key); j != nullptr && expect(j->is_string(), key, "a string")) value = *j;
    }
    void list(const char* key, std::vector<std::string>& value, std::size_t most) {
        const Json* j = find(key);
        if (j == nullptr || !expect(j->is_array(), key, "a list of strings")) return;
        value.clear();
        for (const Json& item : *j)
            if (expect(item.is_string(), key, "a list of strings") && value.size() < most) value.push_back(item);
    }
    void texts(const char* key, std::map<std::string, std::string>& value, std::size_t most) {
        const Json* j = find(key);
        if (j == nullptr || !expect(j->is_object(), key, "an object of strings")) return;
        value.clear();
        for (const auto& [name, item] : j->items())
            if (expect(item.is_string(), key, "an object of strings") && value.size() < most) value[name] = item;
    }
    void place(const char* key, WindowPlace& value) {
        const Json* j = find(key);
        if (j == nullptr || !expect(j->is_object(), key, "an object")) return;
        const auto whole = [&](const char* name) {
            const auto found = j->find(name);
            return found != j->end() && found->is_number_integer()
                       ? std::clamp(found->get<std::int64_t>(), -most_screen, most_screen)
                       : most_screen + 1;
        };
        const std::int64_t x = whole("x"), y = whole("y"), width = whole("width"), height = whole("height");
        const bool good = std::max({x, y, width, height}) <= most_screen && width > 0 && height > 0;
        if (!expect(good, key, "x, y, width and height, whole numbers of screen units")) return;
        const auto maximized = j->find("maximized");
        value = {.area = {.at = {x, y}, .size = {width, height}},
                 .maximized = maximized != j->end() && maximized->is_boolean() && maximized->get<bool>()};
    }
    void object(const char* key, std::string& value) {
        if (const Json* j = find(key); j != nullptr && expect(j->is_object(), key, "an object")) value = j->dump();
    }

  private:
    const Json* find(const char* key) const {
        const auto found = json_.find(key);
        return found == json_.end() ? nullptr : &*found;
    }
    bool expect(bool holds, const char* key, const char* what) {
        if (!holds) faults_.push_back(std::string("/") + key + ": expected " + what);
        return holds;
    }
    const Json& json_;
    std::vector<std::string>& faults_;
};

Json parsed_or(const std::string& text, Json otherwise) {
    Json json = Json::parse(text, nullptr, false);
    return json.is_discarded() ? std::move(otherwise) : json;
}

}  // namespace

Settings::Settings(document::Folders folders) : folders_(std::move(folders)) {
    read();
}

void Settings::note_recent(const std::string& file) {
    std::error_code error;
    const fs::path whole = fs::absolute(file, error);
    const std::string name = error ? file : whole.lexically_normal().string();
    std::erase(recent, name);
    recent.insert(recent.begin(), name);
    if (recent.size() > most_recent) recent.resize(most_recent);
}

void Settings::forget_missing(const std::vector<std::string>& files) {
    for (const std::string& file : files) {
        std::error_code error;
        const std::string name = fs::absolute(file, error).lexically_normal().string();
        if (!fs::exists(name, error)) std::erase(recent, name);
    }
}

std::string Settings::last_folder(const std::string& title) const {
    const auto found = last_folders_.find(title);
    return found == last_folders_.end() ? std::string() : found->second;
}

void Settings::read() {
    if (folders_.config.empty()) return;
    const fs::path file = folders_.config / "settings.json";
    std::error_code error;
    if (!fs::exists(file, error)) return;
    try {
        read_ = read_file(file, longest_file);
        apply(read_);
    } catch (const Error& fault) {
        read_.clear();
        const fs::path aside = folders_.config / "settings.broken.json";
        fs::rename(file, aside, error);
        faults_.push_back(fault.faults().front().text() +
                          (error ? "; it could not be renamed" : "; renamed to " + aside.filename().string()) +
                          ", the standard settings are used");
    }
}

void Settings::apply(const std::string& text) {
    const fs::path file = folders_.config / "settings.json";
    const Json json = Json::parse(text, nullptr, false);
    if (!json.is_object())
        throw Error(Failure::bad_input,
                    Fault{file.string(), "", json.is_discarded() ? "not JSON" : "not a JSON object"});
    std::vector<std::string> faults;
    Reader reader(json, faults);
    reader.flag("light", light);
    reader.flag("reduced_motion", reduced_motion);
    reader.flag("half_resolution", half_resolution);
    reader.flag("hint_seen", hint_seen);
    reader.number("scale", scale, least_scale, most_scale);
    reader.place("window", window);
    reader.list("recent", recent, most_recent);
    std::erase_if(recent, [&](const std::string& name) {
        const bool whole = fs::path(name).is_absolute();
        if (!whole) faults.push_back("/recent: \"" + name + "\" is not an absolute path");
        return !whole;
    });
    reader.list("favourites", favourites, most_listed);
    reader.list("file_folders", file_folders_, most_recent);
    reader.texts("last_folders", last_folders_, most_listed);
    reader.list("preset_folders", preset_folders, most_listed);
    reader.list("preset_stars", preset_stars, most_listed);
    reader.text("layout", layout_name_);
    reader.object("layouts", layouts_text_);
    reader.object("keys", keys_text_);
    for (const std::string& fault : faults) faults_.push_back(file.string() + ": " + fault);
}

void Settings::connect(ui::CommandTable& commands, Layouts& layouts, ui::FileDialog& dialog, Notices& notices) {
    parts_ = {&commands, &layouts, &dialog, &notices};
    if (!keys_text_.empty())
        for (const std::string& fault : commands.from_json(keys_text_)) faults_.push_back("settings: " + fault);
    if (!layouts_text_.empty()) try {
            std::vector<ui::NamedLayout> all = ui::read_layouts(layouts_text_, layouts.panels(), layouts.renamed());
            const auto shown =
                std::find_if(all.begin(), all.end(), [](const auto& l) { return l.name == shown_layout; });
            std::optional<ui::DockLayout> last;
            if (shown != all.end()) {
                last = std::move(shown->layout);
                all.erase(shown);
            }
            layouts.set_own(std::move(all));
            layouts.choose(layout_name_);
            if (last) layouts.shown = std::move(*last);
        } catch (const std::invalid_argument& fault) {
            faults_.push_back(std::string("settings: layouts: ") + fault.what());
        }
    if (!file_folders_.empty()) dialog.set_recent(file_folders_);
    for (const std::string& fault : faults_) notices.add({.kind = ui::ToastKind::warning, .text = fault});
    faults_.clear();
    written_ = state();
}

Settings::State Settings::state() const {
    return {.light = light,
            .reduced_motion = reduced_motion,
            .half_resolution = half_resolution,
            .hint_seen = hint_seen,
            .scale = scale,
            .window = window,
            .recent = recent,
            .favourites = favourites,
            .file_folders = parts_.dialog->recent(),
            .preset_folders = preset_folders,
            .preset_stars = preset_stars,
            .last_folders = last_folders_,
            .layout_name = parts_.layouts->name(),
            .shown = parts_.layouts->arranged(),
            .commands = parts_.commands->version(),
            .own_layouts = parts_.layouts->version()};
}

std::string Settings::text() const {
    std::vector<ui::NamedLayout> layouts = parts_.layouts->own();
    layouts.push_back({.name = std::string(shown_layout), .layout = parts_.layouts->arranged()});
    Json json = parsed_or(read_, Json::object());
    json["version"] = 1;
    json["light"] = light;
    json["scale"] = std::round(scale * 1000.0) / 1000.0;
    if (window)
        json["window"] = {{"x", window.area.at.x},
                          {"y", window.area.at.y},
                          {"width", window.area.size.x},
                          {"height", window.area.size.y},
                          {"maximized", window.maximized}};
    json["reduced_motion"] = reduced_motion;
    json["half_resolution"] = half_resolution;
    json["hint_seen"] = hint_seen;
    json["recent"] = recent;
    json["favourites"] = favourites;
    json["file_folders"] = parts_.dialog->recent();
    json["last_folders"] = last_folders_;
    json["preset_folders"] = preset_folders;
    json["preset_stars"] = preset_stars;
    json["layout"] = parts_.layouts->name();
    json["layouts"] = parsed_or(ui::write_layouts(layouts), Json::object());
    json["keys"] = parsed_or(parts_.commands->to_json(), Json::object());
    // Names of files are any bytes.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

void Settings::update(double now) {
    if (!connected() || folders_.config.empty()) return;
    if (settling_.due_at(now)) return write();
    // Comparing costs next to nothing; copies are made when something has changed.
    const bool same = written_.light == light && written_.reduced_motion == reduced_motion &&
                      written_.half_resolution == half_resolution && written_.hint_seen == hint_seen &&
                      written_.scale == scale && written_.window == window && written_.recent == recent &&
                      written_.favourites == favourites && written_.file_folders == parts_.dialog->recent() &&
                      written_.last_folders == last_folders_ && written_.preset_folders == preset_folders &&
                      written_.preset_stars == preset_stars && written_.layout_name == parts_.layouts->name() &&
                      written_.shown == parts_.layouts->arranged() && written_.commands == parts_.commands->version() &&
                      written_.own_layouts == parts_.layouts->version();
    same ? settling_.clear() : settling_.change(now);
}

void Settings::write() {
    if (!connected() || folders_.config.empty()) return;
    settling_.clear();
    State now = state();
    if (now == written_) return;
    written_ = std::move(now);
    try {
        fs::create_directories(folders_.config);
        write_file(folders_.config / "settings.json", text());
    } catch (const std::exception& fault) {
        if (!told_)
            parts_.notices->add(
                {.kind = ui::ToastKind::warning, .text = std::string("Settings are not kept: ") + fault.what()});
        told_ = true;
    }
}

}  // namespace lapfx::app
