#include "ui/shell/path_completion.h"

#include <algorithm>

#include "ui/core/node.h"
#include "ui/value/utf8.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/field.h"
#include "ui/widgets/type_ahead.h"

namespace lapfx::ui {

namespace {

constexpr std::string_view overlay = "path completion";

struct RowLook {
    Icon icon;
};

void draw_row(Painter& painter, const Node& node, const RowLook& look) {
    const Theme& t = painter.theme();
    draw_item_ground(painter, node, false);
    Rect rect = node.rect().inset(painter.em(0.5F), 0);
    painter.icon(rect.cut_left(painter.em(1)), look.icon, t.text_dim);
    rect.cut_left(painter.em(0.4F));
    painter.text(rect, node.text, painter.text_style(), t.text);
}

/// The number of bytes that both begin with; it never ends inside a character.
std::size_t same_start(std::string_view a, std::string_view b) {
    std::size_t same = 0;
    while (same < std::min(a.size(), b.size()) && a[same] == b[same]) ++same;
    return std::min(code_point_at(a, same), code_point_at(b, same));
}

}  // namespace

std::string longest_common(std::span<const std::string_view> names, std::string_view typed) {
    if (names.empty()) return std::string(typed);
    std::string_view whole = names[0], rest = names[0].substr(typed.size());
    for (const std::string_view name : names) {
        whole = whole.substr(0, same_start(whole, name));
        rest = rest.substr(0, same_start(rest, name.substr(typed.size())));
    }
    return whole.size() >= typed.size() ? std::string(whole) : std::string(typed).append(rest);
}

void PathCompletion::close() {
    found_.clear();
    common_.clear();
    open_ = waits_ = extends_ = tab_waits_ = false;
    marked_ = no_row, first_ = 0;
}

void PathCompletion::collect(const std::vector<FileEntry>& entries, std::string_view stem, const FolderListing& shown) {
    const bool hidden = stem.starts_with('.');
    for (const FileEntry& entry : entries)
        if (begins_with(entry.name, stem) && shown.wanted(entry, hidden)) found_.push_back({entry.name, entry.folder});
    std::vector<std::string_view> names;
    for (const CompletedName& each : found_) names.emplace_back(each.name);
    common_ = longest_common(names, stem);
    if (found_.size() == 1 && found_[0].folder) common_ += '/';
    const std::size_t kept = std::min(found_.size(), most_found);
    std::partial_sort(found_.begin(), found_.begin() + static_cast<std::ptrdiff_t>(kept), found_.end(),
                      [](const CompletedName& a, const CompletedName& b) {
                          return a.folder != b.folder ? a.folder : natural_less(a.name, b.name);
                      });
    found_.resize(kept);
}

void PathCompletion::search(Ui& ui, std::string_view typed, const FolderListing& shown) {
    const bool tab_waits = tab_waits_;
    close();
    if (typed.empty()) return;
    const std::size_t slash = typed.rfind('/');
    const std::string_view stem = slash == std::string_view::npos ? typed : typed.substr(slash + 1);
    head_ = typed.substr(0, typed.size() - stem.size());
    if (typed == "~") {
        found_.push_back({"~", true});
        common_ = "~/";
    } else {
        const std::string folder = resolve_path(shown.folder, expand_home(head_, files_.home()));
        const std::vector<FileEntry>* entries = folder == shown.folder ? &shown.entries : reader_.read(ui, folder);
        waits_ = entries == nullptr;
        tab_waits_ = waits_ && tab_waits;
        if (waits_) return;
        collect(*entries, stem, shown);
    }
    extends_ = !found_.empty() && common_ != stem;
    open_ = !found_.empty() && !(found_.size() == 1 && !extends_ && !found_[0].folder);
}

void PathCompletion::take(Ui& ui, std::size_t index, std::string& typed, const FolderListing& shown) {
    const CompletedName taken = found_[index];
    typed = head_ + taken.name + (taken.folder ? "/" : "");
    taken.folder ? search(ui, typed, shown) : close();
    ui.build_again();
}

void PathCompletion::take_common(Ui& ui, std::string& typed, const FolderListing& shown) {
    typed = head_ + common_;
    search(ui, typed, shown);
    ui.build_again();
}

void PathCompletion::move(int step) {
    const std::size_t last = found_.size() - 1;
    if (step > 0) marked_ = marked_ == no_row || marked_ == last ? 0 : marked_ + 1;
    if (step < 0) marked_ = marked_ == no_row || marked_ == 0 ? last : marked_ - 1;
    if (marked_ < first_) first_ = marked_;
    if (marked_ >= first_ + rows) first_ = marked_ + 1 - rows;
}

bool PathCompletion::take_key(Ui& ui, Key key, std::string& typed, const FolderListing& shown) {
    switch (key) {
        case Key::tab:
            if (waits_) tab_waits_ = true;
            if (extends_) take_common(ui, typed, shown);
            return true;
        case Key::up:
        case Key::down:
            if (!open_) search(ui, typed, shown);
            if (found_.empty()) return waits_;
            open_ = true;
            move(key == Key::down ? 1 : -1);
            return true;
        case Key::escape: {
            const bool was = open_ || waits_;
            close();
            return was;
        }
        case Key::enter:
            if (!open_ || marked_ == no_row) return false;
            take(ui, marked_, typed, shown);
            return true;
        default:
            return false;
    }
}

/// Builds the rows and returns the one that was clicked.
std::size_t PathCompletion::put_rows(Ui& ui) {
    std::size_t clicked = no_row;
    for (std::size_t i = first_; i < std::min(first_ + rows, found_.size()); ++i) {
        const CompletedName& found = found_[i];
        ui.push_seed(i);
        Node& node = ui.leaf(Role::list_item, "##name", Sense::hover | Sense::press);
        ui.pop_seed();
        node.label = ui.copy(found.name);  // unchanged: a file may be called a##b
        node.text = found.folder ? ui.join({found.name, "/"}) : node.label;
        node.size[0] = grow();
        node.size[1] = px(ui.row_height());
        node.is |= when(i == marked_, Is::selected);
        const Response r = ui.respond(node);
        ui.draw_with<draw_row>(node, RowLook{found.folder ? Icon::folder : Icon::file});
        if (r.clicked) clicked = i;
    }
    return clicked;
}

bool PathCompletion::build(Ui& ui, Id field, std::string& typed, const FolderListing& shown) {
    if (!open_ && !waits_) return false;
    if (ui.focus() != field) {
        close();
        return false;
    }
    bool changed = false;
    if (waits_) {
        const bool tab = tab_waits_;
        search(ui, typed, shown);
        if (!waits_ && tab && extends_) take_common(ui, typed, shown), changed = true;
    }
    if (!open_) return changed;
    using Side = Placement::Side;
    if (!ui.overlay_open(overlay))
        ui.open_overlay(overlay, OverlayKind::passive, {.side = Side::below, .anchor = field});
    Node* root = ui.open_overlay_node(overlay, Role::list, "Suggestions", Axis::y);
    if (root == nullptr) return changed;
    const Rect at = ui.rect_before(field);
    const float pad = ui.em(0.25F), lines = static_cast<float>(std::min(found_.size(), rows + 1));
    const float height = lines * ui.row_height() + 2 * pad, top = at.y - pad - height;
    // The list is above the field if there is room: the buttons to press next, to open or save, are below it.
    if (top >= 0) root->placement = ui.arena().make(Placement{.side = Side::pointer, .rect = {at.x, top, 0, 0}});
    root->size[0] = px(std::max(at.w, ui.em(8)));
    root->size[1] = px(height);
    for (std::uint8_t& each : root->padding) each = static_cast<std::uint8_t>(pad);
    root->clips = true;
    ui.draw_with<draw_popup>(*root, false);
    const std::size_t clicked = put_rows(ui);
    if (found_.size() > rows) {
        const std::string count = std::to_string(found_.size()) + (found_.size() == most_found ? " or more" : "");
        const Row row(
            ui, {.width = grow(), .height = px(ui.row_height()), .cross = ChildAlign::center, .main = ChildAlign::end});
        label(ui, ui.join({count, " names"}), {.tone = Tone::dim, .size = 0.9F});
    }
    ui.close_overlay_node();
    if (clicked == no_row) return changed;
    take(ui, clicked, typed, shown);
    return true;
}

}  // namespace lapfx::ui
