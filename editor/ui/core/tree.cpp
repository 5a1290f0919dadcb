#include "ui/core/tree.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "ui/value/closed_list.h"

namespace lapfx::ui {

namespace {

using nlohmann::ordered_json;

constexpr struct {
    Role value;
    std::string_view name;
    bool arrows_move_focus = false;
} roles[] = {
    {Role::none, "none"},
    {Role::window, "window"},
    {Role::panel, "panel"},
    {Role::group, "group"},
    {Role::label, "label"},
    {Role::heading, "heading"},
    {Role::button, "button"},
    {Role::toggle, "toggle"},
    {Role::checkbox, "checkbox"},
    {Role::radio, "radio"},
    {Role::combo, "combo"},
    {Role::text_field, "text field"},
    {Role::search_field, "search field"},
    {Role::slider, "slider"},
    {Role::range, "range"},
    {Role::color, "color"},
    {Role::section, "section"},
    {Role::tab_list, "tab list", true},
    {Role::tab, "tab"},
    {Role::splitter, "splitter"},
    {Role::scroll_area, "scroll area"},
    {Role::scroll_bar, "scroll bar"},
    {Role::list, "list", true},
    {Role::list_item, "list item"},
    {Role::table, "table", true},
    {Role::column_header, "column header"},
    {Role::row, "row"},
    {Role::cell, "cell"},
    {Role::grid, "grid", true},
    {Role::image, "image"},
    {Role::progress, "progress"},
    {Role::status, "status"},
    {Role::tooltip, "tooltip"},
    {Role::menu_bar, "menu bar", true},
    {Role::menu, "menu", true},
    {Role::menu_item, "menu item"},
    {Role::dialog, "dialog"},
    {Role::palette, "palette", true},
    {Role::plot, "plot"},
    {Role::curve, "curve"},
    {Role::timeline, "timeline"},
    {Role::canvas, "canvas"},
    {Role::handle, "handle"},
    {Role::separator, "separator"},
    {Role::link, "link"},
};
static_assert(is_whole(roles));

/// In the order of their bits. The ring of the keyboard is not told apart from the focus.
constexpr std::pair<Is, std::string_view> states[] = {
    {Is::disabled, "disabled"},   {Is::hovered, "hovered"},   {Is::held, "held"},
    {Is::focused, "focused"},     {Is::ringed, ""},           {Is::checked, "checked"},
    {Is::selected, "selected"},   {Is::expanded, "expanded"}, {Is::changed, "changed"},
    {Is::locked, "locked"},       {Is::invalid, "invalid"},   {Is::read_only, "read only"},
    {Is::duplicate, "duplicate"}, {Is::busy, "busy"},         {Is::modal, "modal"}};
consteval bool states_are_whole() {
    for (std::size_t i = 0; i < std::size(states); ++i) {
        if (states[i].first != static_cast<Is>(1U << i)) return false;
    }
    return !is_enumerator<static_cast<Is>(1U << std::size(states))>();
}
static_assert(states_are_whole());

bool named(const Node& node) {
    return !node.label.empty() || node.role == Role::tooltip || node.role == Role::window;
}

std::string number_text(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
}

/// Bytes that are not UTF-8 become U+FFFD, because other programs read the tree.
std::string clean(std::string_view text) {
    return ordered_json::parse(
               ordered_json(std::string(text)).dump(-1, ' ', false, ordered_json::error_handler_t::replace))
        .get<std::string>();
}

bool ends_with_path(const std::string& path, std::string_view tail) {
    return path.ends_with(tail) && (path.size() == tail.size() || path[path.size() - tail.size() - 1] == '/');
}

std::vector<std::uint32_t> matches(std::span<const Node> tree, std::string_view path) {
    const bool anywhere = path.starts_with("**/");
    if (anywhere) path.remove_prefix(3);
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        if (tree[i].label.empty() || !path.ends_with(tree[i].label)) continue;
        const std::string whole = path_of(tree, i);
        if (anywhere ? ends_with_path(whole, path) : whole == path) found.push_back(i);
    }
    return found;
}

ordered_json json_of(std::span<const Node> tree, std::uint32_t index) {
    const Node& node = tree[index];
    ordered_json json;
    json["role"] = name_of(node.role);
    if (!node.label.empty()) json["label"] = clean(node.label), json["path"] = clean(path_of(tree, index));
    if (!node.text.empty()) json["text"] = clean(node.text);
    if (node.number != nullptr) {
        json["value"] = node.number->value;
        json["minimum"] = node.number->minimum;
        json["maximum"] = node.number->maximum;
        if (node.number->step != 0) json["step"] = node.number->step;
    }
    for (const auto& [state, word] : states) {
        if (has(node.is, state) && !word.empty()) json["states"].push_back(word);
    }
    json["rect"] = {node.at[0], node.at[1], node.extent[0], node.extent[1]};
    if (!node.tip.empty()) json["tip"] = clean(node.tip);
    return json;
}

/// Children of a node without a name become children of its parent.
void add_children(std::span<const Node> tree, std::uint32_t index, ordered_json& into) {
    for (std::uint32_t i = index + 1; i < tree[index].end; i = tree[i].end) {
        if (!named(tree[i])) {
            add_children(tree, i, into);
            continue;
        }
        ordered_json child = json_of(tree, i);
        add_children(tree, i, child["children"]);
        if (child["children"].is_null()) child.erase("children");
        into.push_back(std::move(child));
    }
}

}  // namespace

std::string_view name_of(Role role) {
    return roles[static_cast<std::size_t>(role)].name;
}

bool arrows_move_focus(Role role) {
    return roles[static_cast<std::size_t>(role)].arrows_move_focus;
}

std::string path_of(std::span<const Node> tree, std::uint32_t index) {
    std::string path;
    for (std::uint32_t i = index; i != no_node; i = tree[i].parent) {
        if (tree[i].label.empty()) continue;
        path = path.empty() ? std::string(tree[i].label) : std::string(tree[i].label) + "/" + path;
    }
    return path;
}

bool exists(std::span<const Node> tree, std::string_view path) {
    return !matches(tree, path).empty();
}

std::uint32_t find(std::span<const Node> tree, std::string_view path) {
    const auto found = matches(tree, path);
    if (found.size() == 1) return found.front();
    std::string reason = std::string(path) + (found.empty() ? " is not there; there are" : " is there more than once:");
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        const bool listed = found.empty() ? tree[i].id != 0 && !tree[i].label.empty()
                                          : std::find(found.begin(), found.end(), i) != found.end();
        if (listed) reason += "\n  " + path_of(tree, i);
    }
    throw std::invalid_argument(reason);
}

std::string dump_text(std::span<const Node> tree) {
    std::string text;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        const Node& node = tree[i];
        if (!named(node)) continue;
        int depth = 0;
        for (std::uint32_t p = node.parent; p != no_node; p = tree[p].parent) depth += named(tree[p]) ? 1 : 0;
        text += std::string(static_cast<std::size_t>(depth) * 2, ' ') + std::string(name_of(node.role));
        if (!node.label.empty()) text += " \"" + clean(node.label) + "\"";
        if (node.number != nullptr) text += " = " + number_text(node.number->value);
        if (!node.text.empty()) text += " '" + clean(node.text) + "'";
        for (const auto& [state, word] : states) {
            if (has(node.is, state) && !word.empty()) text += " [" + std::string(word) + "]";
        }
        for (const float v : {node.at[0], node.at[1], node.extent[0], node.extent[1]}) text += " " + number_text(v);
        text += "\n";
    }
    return text;
}

std::string dump_json(std::span<const Node> tree) {
    if (tree.empty()) return "{}";
    ordered_json root = json_of(tree, 0);
    add_children(tree, 0, root["children"]);
    return root.dump(1);
}

std::vector<std::string> faults_of(std::span<const Node> tree) {
    std::vector<std::string> faults;
    for (std::uint32_t i = 0; i < tree.size(); ++i) {
        if (has(tree[i].sense, Sense::focus) && tree[i].label.empty())
            faults.push_back(std::string(name_of(tree[i].role)) + " takes the keyboard and has no name");
        if (has(tree[i].is, Is::duplicate))
            faults.push_back(path_of(tree, i) + ": another widget next to it has the same label");
    }
    return faults;
}

}  // namespace lapfx::ui
