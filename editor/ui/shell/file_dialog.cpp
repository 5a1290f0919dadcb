#include "ui/shell/file_dialog.h"

#include <algorithm>
#include <utility>

#include "ui/core/node.h"
#include "ui/shell/dialog.h"
#include "ui/value/letters.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/literal.h"
#include "ui/widgets/text_field.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view overlay = "file dialog", question = "file dialog replace";
constexpr float width = 56, height = 36, places_width = 11;  // em
constexpr float preview_width = 16, preview_from = 50;       // em: in a narrower window the list needs the room
constexpr std::string_view name_field = "Name", list_name = "Files";
constexpr std::size_t most_recent = 6;
constexpr std::size_t most_crumbs = 5;  // of the path bar; the folders above are reached from the first of them
constexpr TableColumn columns[] = {{.title = "Name", .width = 23},
                                   {.title = "Size", .width = 6, .align = Align::end},
                                   {.title = "Changed", .width = 11}};

bool has_extension(std::string_view name, std::string_view extension) {
    return name.size() > extension.size() && same_letters(name.substr(name.size() - extension.size()), extension);
}

std::string_view verb_of(FileTask task) {
    return task == FileTask::save ? "Save" : task == FileTask::folder ? "Choose folder" : "Open";
}

}  // namespace

void FileDialog::open(Ui& ui, FileRequest request) {
    request_ = std::move(request);
    if (request_.title.empty()) request_.title = verb_of(request_.task);
    if (!request_.filters.empty() || request_.task != FileTask::folder) request_.filters.push_back({"All files", {}});
    filter_ = 0;
    name_ = request_.name;
    filter_names_.clear();
    for (const FileFilter& each : request_.filters) filter_names_.push_back(each.name);
    table_.selection.clear();
    selected_.clear();
    looked_at_.reset();
    count_.clear();
    completion_.close();
    makes_folder_ = false;
    fresh_ = true;
    places_ = files_.places();
    done_.reset();
    replaces_.clear();
    if (pictures_ != nullptr) pictures_->begin();
    if (table_.sort_column < 0) table_.sort_column = 0;
    const std::string start = !request_.folder.empty() ? request_.folder : folder_.empty() ? files_.home() : folder_;
    go(resolve_path("/", start));
    open_dialog(ui, overlay);
}

/// Opens a folder. If it cannot be read, the dialog stays in the present one and says why.
void FileDialog::go(const std::string& folder) {
    std::vector<FileEntry> entries;
    const std::string fault = files_.list(folder, entries);
    fault_.clear();
    if (!fault.empty()) {
        fault_ = "\"" + folder + "\" cannot be read: " + fault;
        if (!folder_.empty() && folder != folder_) return arrange();
        entries.clear();
    }
    folder_ = folder;
    entries_ = std::move(entries);
    table_.selection.clear();
    selected_.clear();
    looked_at_.reset();
    completion_.close();
    completion_.forget();
    makes_folder_ = false;
    count_.clear();
    if (request_.task != FileTask::save) name_.clear();
    arrange();
}

bool FileDialog::passes(const FileEntry& entry, bool hidden) const {
    if (!hidden && entry.name.starts_with('.')) return false;
    if (entry.folder) return true;
    if (request_.task == FileTask::folder) return false;
    const auto index = static_cast<std::size_t>(filter_);
    if (index >= request_.filters.size() || request_.filters[index].extensions.empty()) return true;
    const auto& all = request_.filters[index].extensions;
    return std::any_of(all.begin(), all.end(),
                       [&](const std::string& each) { return has_extension(entry.name, each); });
}

/// Sorts the entries. Folders always come first.
void FileDialog::arrange() {
    shown_.clear();
    for (std::uint32_t i = 0; i < entries_.size(); ++i) {
        if (passes(entries_[i], hidden_)) shown_.push_back(i);
    }
    const int column = table_.sort_column;
    const bool down = table_.descending;
    std::sort(shown_.begin(), shown_.end(), [&](std::uint32_t i, std::uint32_t k) {
        const FileEntry &a = entries_[i], &b = entries_[k];
        if (a.folder != b.folder) return a.folder;
        if (column == 1 && a.size != b.size) return (a.size < b.size) != down;
        if (column == 2 && a.changed != b.changed) return (a.changed < b.changed) != down;
        return column == 0 && down ? natural_less(b.name, a.name) : natural_less(a.name, b.name);
    });
}

std::uint64_t FileDialog::key_of(std::size_t row) const {
    return hash_bytes(1, entry(row).name) >> 1;  // never no_key
}

void FileDialog::build_path_bar(Ui& ui) {
    std::string next;
    {
        const Row row(ui, {.width = grow(), .cross = ChildAlign::center});
        if (icon_button(ui, Icon::chevron_up, "Folder above", {.tip = "Folder above (Alt+Up)", .quiet = true}))
            next = parent_of(folder_);
        std::size_t begin = folder_.size();  // where the first part that is shown begins
        for (std::size_t i = 0; i < most_crumbs && begin > 0; ++i) begin = folder_.rfind('/', begin - 1);
        if (begin == 0 && button(ui, "/", {.quiet = true})) next = "/";
        ui.push_seed("path");
        for (std::size_t at = begin; at < folder_.size() && folder_.size() > 1;) {
            const std::size_t end = std::min(folder_.find('/', at + 1), folder_.size());
            ui.push_seed(end);
            const std::string_view name = std::string_view(folder_).substr(at + 1, end - at - 1);
            if (literal_button(ui, name, {.quiet = true})) next = folder_.substr(0, end);
            ui.last().rigid = false;
            ui.pop_seed();
            at = end;
        }
        ui.pop_seed();
        spacer(ui);
        if (button(ui, "New folder", {.icon = Icon::plus, .tip = "Make a folder here (Ctrl+Shift+N)", .quiet = true}))
            begin_folder();
        if (toggle(ui, "Hidden files", hidden_,
                   {.icon = Icon::eye, .tip = "Show hidden files (Ctrl+H)", .quiet = true}))
            arrange();
        if (icon_button(ui, Icon::reset, "Read again", {.tip = "Read again (F5)", .quiet = true})) next = folder_;
    }
    if (!next.empty()) go(next);
}

/// A folder's path in this width, px: folders at its beginning give way, its own name stays.
static std::string_view short_path(Ui& ui, std::string_view path, float room) {
    std::string_view shown = path;
    for (std::size_t from = 0; ui.text_width(shown) > room;) {
        from = path.find('/', from + 1);
        if (from == path.npos) return name_of_path(path);
        shown = ui.join({"\u2026", path.substr(from)});
    }
    return shown;
}

void FileDialog::build_places(Ui& ui) {
    const std::string* chosen = nullptr;
    {
        const Column column(ui, {.width = px(ui.em(places_width)), .height = grow(), .gap = 0.1F});
        const auto place = [&](std::string_view name, const std::string& path) {
            if (literal_button(
                    ui, name,
                    {.icon = Icon::folder, .tip = path, .quiet = true, .on = path == folder_, .width = grow()}))
                chosen = &path;
            ui.last().rigid = false;
        };
        ui.push_seed("places");
        for (const FilePlace& each : places_) place(each.name, each.path);
        ui.pop_seed();
        if (!recent_.empty()) label(ui, "Recent", {.tone = Tone::dim});
        for (const std::string& each : recent_) {
            ui.push_seed(each);
            place(short_path(ui, each, ui.em(places_width - 3)), each);
            ui.pop_seed();
        }
    }
    if (chosen != nullptr) go(*chosen);
}

void FileDialog::build_table(Ui& ui) {
    const auto cell = [this](std::size_t row, std::size_t column) {
        const FileEntry& e = entry(row);
        TableCell out;
        if (column == 0) return TableCell{.text = e.name, .icon = e.folder ? Icon::folder : Icon::file};
        if (column == 2) {
            date_text(e.changed, cell_);
        } else {
            cell_ = e.folder ? std::string() : size_text(e.size);
        }
        return TableCell{.text = cell_, .tone = Tone::dim, .number = true};
    };
    const auto key = [this](std::size_t row) { return key_of(row); };
    const RowList::KeyOf keys(key);
    const TableEvents events =
        table(ui, list_name, table_, columns, shown_.size(), cell,
              {.multiple = request_.task == FileTask::open_many, .key_of = &keys, .letters = true});
    if (events.sorted) arrange();
    if (events.selected) select_from_table();
    if (events.opened >= shown_.size()) return;
    if (entry(events.opened).folder) {
        go(resolve_path(folder_, entry(events.opened).name));
    } else {
        select_from_table();
        accepts_ = true;
    }
}

void FileDialog::look_at(const FileEntry* entry) {
    looked_at_.reset();
    if (entry == nullptr) return;
    std::string about;
    date_text(entry->changed, about);
    if (!entry->folder) about = size_text(entry->size) + ", " + about;
    looked_at_ = LookedAt{resolve_path(folder_, entry->name), *entry, std::move(about)};
}

/// Takes the selected entries, if their kind can be chosen. The name goes into the field.
void FileDialog::select_from_table() {
    selected_.clear();
    completion_.close();
    const FileEntry* current = nullptr;
    for (std::size_t row = 0; row < shown_.size(); ++row) {
        if (table_.selection.current == key_of(row) && table_.selection.has(key_of(row))) current = &entry(row);
        const bool wanted = entry(row).folder == (request_.task == FileTask::folder);
        if (wanted && table_.selection.has(key_of(row))) selected_.push_back(entry(row).name);
    }
    look_at(current);
    count_ = selected_.size() > 1 ? std::to_string(selected_.size()) + " files" : std::string();
    if (selected_.size() == 1) name_ = selected_[0];
    if (selected_.size() != 1 && request_.task != FileTask::save) name_.clear();
}

void FileDialog::begin_folder() {
    if (makes_folder_) return;
    new_folder_ = "New folder";
    makes_folder_ = folder_fresh_ = true;
    fault_.clear();
}

/// Ends the entry of a new folder; the keyboard returns to where the dialog starts.
void FileDialog::end_folder() {
    makes_folder_ = false;
    fresh_ = true;
    fault_.clear();
}

void FileDialog::make_folder() {
    const std::string path = folder_ + (folder_ == "/" ? "" : "/") + new_folder_;
    std::string fault;
    if (new_folder_.empty()) {
        fault = "a name is missing";
    } else if (new_folder_ == "." || new_folder_ == "..") {
        fault = "this name means another folder";
    } else if (new_folder_.find('/') != std::string::npos) {
        fault = "a name has no \"/\"";
    } else {
        fault = files_.make_folder(path);
    }
    if (!fault.empty()) {
        fault_ = "\"" + new_folder_ + "\" cannot be made: " + fault;
        return;
    }
    end_folder();
    go(path);
}

/// The field for a new folder's name, above the list in which the folder will be.
void FileDialog::build_new_folder(Ui& ui) {
    if (!makes_folder_) return;
    bool makes = false, gives_up = false;
    {
        const Row row(ui, {.width = grow(), .cross = ChildAlign::center});
        if (text_field(ui, "Name of the new folder", new_folder_, {.bytes = 255, .keys_outside = true})) fault_.clear();
        const Id field = ui.id_of("Name of the new folder");
        if (std::exchange(folder_fresh_, false)) ui.set_focus(field, true);
        ui.events_of(field, [&](const Event& event) {
            if (event.kind != EventKind::key) return;
            makes |= event.key == Key::enter;
            gives_up |= event.key == Key::escape;
        });
        takes_enter_ |= makes;
        makes |=
            icon_button(ui, Icon::check, "Make the folder", {.tip = "Make it and go there (Enter)", .primary = true});
        gives_up |= icon_button(ui, Icon::cross, "No new folder", {.tip = "No new folder (Esc)", .quiet = true});
    }
    if (makes) make_folder();
    if (gives_up) end_folder();
    if (makes || gives_up) ui.build_again();
}

/// Handles keys that nothing in the dialog took.
void FileDialog::take_chords(Ui& ui, Id dialog) {
    std::string next;
    ui.events_of(dialog, [&](const Event& event) {
        if (event.kind != EventKind::key) return;
        const bool command = has(event.mods, Mods::command), shift = has(event.mods, Mods::shift);
        if (command && shift && event.key == ui::key_of('N')) begin_folder();
        if (command && event.key == ui::key_of('H')) hidden_ = !hidden_, arrange();
        if (command && event.key == ui::key_of('L')) ui.set_focus(ui.id_of(name_field), true);
        if (has(event.mods, Mods::alt) && event.key == Key::up) next = parent_of(folder_);
        if (event.key == Key::f5) next = folder_;
    });
    if (!next.empty()) go(next);
}

void FileDialog::take_name_keys(Ui& ui, Id field, const PathCompletion::FolderListing& shown) {
    ui.events_of(field, [&](const Event& event) {
        if (event.kind != EventKind::key || has(event.mods, Mods::command)) return;
        if (completion_.take_key(ui, event.key, name_, shown)) {
            takes_enter_ |= event.key == Key::enter;
        } else if (event.key == Key::escape) {
            leaves_ = true;
        } else if (event.key == Key::down) {
            go_to_list(ui);
        }
    });
}

/// Moves the keyboard from the field below the list into the list.
void FileDialog::go_to_list(Ui& ui) {
    ui.set_focus(ui.id_of(list_name), true);
    if (shown_.empty() || !table_.selection.keys.empty() || !name_.empty()) return;
    table_.selection.only(key_of(0));
    select_from_table();
    ui.build_again();
}

void FileDialog::build_name(Ui& ui) {
    const Row row(ui, {.width = grow(), .cross = ChildAlign::center});
    const std::string_view hint = count_.empty() ? std::string_view("Name, or a path") : count_;
    const auto wanted = [this](const FileEntry& each, bool hidden) { return passes(each, hidden || hidden_); };
    const FunctionRef<bool(const FileEntry&, bool)> is_wanted = wanted;
    const PathCompletion::FolderListing shown{folder_, entries_, is_wanted};
    const Id field = ui.id_of(name_field);
    if (text_field(ui, name_field, name_, {.placeholder = hint, .keys_outside = true})) {
        fault_.clear();
        completion_.search(ui, name_, shown);
    }
    Node& node = ui.last();
    if (node.id == field && completion_.completes()) node.sense = node.sense | Sense::completes;
    const Node* focused = ui.before(ui.focus());
    if (fresh_ && focused != nullptr && focused->layer == node.layer) {
        ui.set_focus(field, ui.focus_ringed());
        fresh_ = false;
    }
    take_name_keys(ui, field, shown);
    if (completion_.build(ui, field, name_, shown)) fault_.clear();
    if (request_.filters.size() < 2) return;
    if (combo(ui, "Kind of file", filter_, filter_names_, {.width = px(ui.em(12))})) arrange();
}

void FileDialog::accept(Ui& ui) {
    fault_.clear();
    completion_.close();
    if (name_.empty()) return accept_selected();
    const bool listed = selected_.size() == 1 && name_ == selected_[0];  // a file may be called ~
    accept_typed(ui, resolve_path(folder_, listed ? name_ : expand_home(name_, files_.home())));
}

void FileDialog::accept_selected() {
    if (request_.task == FileTask::folder) return choose({folder_});
    if (selected_.empty()) {
        fault_ = request_.task == FileTask::save ? "A name is missing" : "Nothing is chosen";
        return;
    }
    std::vector<std::string> paths;
    for (const std::string& each : selected_) paths.push_back(resolve_path(folder_, each));
    choose(std::move(paths));
}

void FileDialog::accept_typed(Ui& ui, std::string path) {
    using Kind = FileSystem::Kind;
    Kind kind = files_.kind(path);
    if (kind == Kind::folder && request_.task == FileTask::folder) return choose({std::move(path)});
    if (kind == Kind::folder) {
        if (request_.task == FileTask::save) name_ = request_.name;
        return go(path);
    }
    if (request_.task == FileTask::folder || (request_.task != FileTask::save && kind == Kind::nothing)) {
        fault_ = "\"" + path + "\" " + (kind == Kind::file ? "is not a folder" : "does not exist");
        return;
    }
    if (request_.task != FileTask::save) return choose({std::move(path)});
    const auto& filters = request_.filters;
    const auto index = std::min(static_cast<std::size_t>(filter_), filters.size() - 1);
    if (name_of_path(path).find('.') == std::string_view::npos && !filters[index].extensions.empty()) {
        path += filters[index].extensions[0];
        kind = files_.kind(path);
    }
    const std::string folder(parent_of(path));
    if (files_.kind(folder) != Kind::folder) {
        fault_ = "There is no folder \"" + folder + "\"";
    } else if (kind == Kind::file) {
        replaces_ = path;
        open_dialog(ui, question);
    } else {
        choose({std::move(path)});
    }
}

/// A folder has no picture, and a narrow window needs the room for names.
bool FileDialog::previews(const Ui& ui) const {
    return pictures_ != nullptr && request_.task != FileTask::folder && ui.window().x >= ui.em(preview_from);
}

std::optional<std::vector<std::string>> FileDialog::build(Ui& ui) {
    if (!ui.overlay_open(overlay)) return std::nullopt;
    accepts_ = leaves_ = takes_enter_ = false;
    const bool pictures = previews(ui);
    {
        Dialog dialog(ui, overlay, request_.title, {.width = width + (pictures ? preview_width : 0), .height = height});
        take_chords(ui, dialog.id());
        build_path_bar(ui);
        {
            const Row row(ui, {.width = grow(), .height = grow(), .cross = ChildAlign::stretch});
            build_places(ui);
            {
                const Column list(ui, {.width = grow(), .height = grow()});
                build_new_folder(ui);
                build_table(ui);
            }
            if (pictures) file_preview(ui, *pictures_, looked_at_ ? &*looked_at_ : nullptr, preview_width);
        }
        if (!fault_.empty()) literal(ui, fault_, Tone::error);
        build_name(ui);
        const auto pressed = dialog.buttons(
            {{.label = "Cancel", .cancel = true}, {.label = verb_of(request_.task), .standard = true}}, true);
        if (pressed == 0 || leaves_) dialog.close();
        if ((pressed == 1 && !takes_enter_) || accepts_) accept(ui);
    }
    const auto answer =
        ask(ui, question, "Replace the file?",
            ui.join({"\"", name_of_path(replaces_), "\" exists already. Its content will be lost."}),
            {{.label = "Replace"}, {.label = "Cancel", .standard = true, .cancel = true}}, Tone::warning);
    if (answer == 0) choose({replaces_});
    if (!done_) return std::nullopt;
    ui.close_overlays_over(overlay);
    ui.close_overlay(overlay);
    const std::string used =
        request_.task == FileTask::folder ? done_->front() : std::string(parent_of(done_->front()));
    std::erase(recent_, used);
    recent_.insert(recent_.begin(), used);
    if (recent_.size() > most_recent) recent_.pop_back();
    return std::exchange(done_, std::nullopt);
}

}  // namespace lapfx::ui
