#include "ui/widgets/dock_layout.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace lapfx::ui {

namespace {

using nlohmann::ordered_json;

constexpr float least_fraction = 0.02F;
constexpr int deepest = 32;  // levels of splits within splits that a file may have
constexpr int version = 1;

int put_copy(const std::vector<DockNode>& from, int index, std::vector<DockNode>& to) {
    const auto at = to.size();
    to.push_back(from[static_cast<std::size_t>(index)]);
    if (to[at].leaf()) return static_cast<int>(at);
    const int first = put_copy(from, to[at].first, to);
    const int second = put_copy(from, to[at].second, to);
    to[at].first = first;
    to[at].second = second;
    return static_cast<int>(at);
}

int first_leaf(const std::vector<DockNode>& nodes) {
    int at = 0;
    while (!nodes[static_cast<std::size_t>(at)].leaf()) at = nodes[static_cast<std::size_t>(at)].first;
    return at;
}

ordered_json json_of(const DockLayout& layout, int index) {
    const DockNode& node = layout.nodes[static_cast<std::size_t>(index)];
    if (node.leaf()) return {{"tabs", node.tabs}, {"active", node.active}};
    return {{"split", node.axis == Axis::x ? "x" : "y"},
            {"fraction", node.fraction},
            {"first", json_of(layout, node.first)},
            {"second", json_of(layout, node.second)}};
}

int read_node(const ordered_json& json, std::vector<DockNode>& nodes, int depth) {
    if (depth > deepest) throw std::invalid_argument("splits are nested too deep");
    const auto at = nodes.size();
    nodes.emplace_back();
    if (json.contains("tabs")) {
        nodes[at].tabs = json.at("tabs").get<std::vector<std::string>>();
        nodes[at].active = json.value("active", 0);
        return static_cast<int>(at);
    }
    const auto axis = json.at("split").get<std::string>();
    if (axis != "x" && axis != "y") throw std::invalid_argument("split is \"" + axis + "\"; allowed are x, y");
    nodes[at].axis = axis == "x" ? Axis::x : Axis::y;
    nodes[at].fraction = json.at("fraction").get<float>();
    const int first = read_node(json.at("first"), nodes, depth + 1);
    const int second = read_node(json.at("second"), nodes, depth + 1);
    nodes[at].first = first;
    nodes[at].second = second;
    return static_cast<int>(at);
}

void rename(std::vector<std::string>& panels, std::span<const RenamedPanel> renamed) {
    for (std::string& panel : panels)
        for (const RenamedPanel& one : renamed)
            if (panel == one.before) panel = one.now;
}

}  // namespace

int DockLayout::find(std::string_view panel) const {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (std::find(nodes[i].tabs.begin(), nodes[i].tabs.end(), panel) != nodes[i].tabs.end())
            return static_cast<int>(i);
    }
    return -1;
}

/// Removes a leaf: its sibling replaces their parent.
void DockLayout::drop_leaf(int leaf) {
    for (DockNode& parent : nodes) {
        if (parent.leaf() || (parent.first != leaf && parent.second != leaf)) continue;
        const int sibling = parent.first == leaf ? parent.second : parent.first;
        const DockNode kept = nodes[static_cast<std::size_t>(sibling)];
        parent = kept;
        return;
    }
}

/// Removes nodes that cannot be reached any more and puts the others in order.
void DockLayout::compact() {
    std::vector<DockNode> kept;
    put_copy(nodes, 0, kept);
    nodes = std::move(kept);
}

/// Removes a panel. It may leave an empty leaf.
void DockLayout::take_out(std::string_view panel) {
    std::erase(closed, panel);
    const int at = find(panel);
    if (at < 0) return;
    DockNode& leaf = nodes[static_cast<std::size_t>(at)];
    const auto tab = std::find(leaf.tabs.begin(), leaf.tabs.end(), panel);
    const int index = static_cast<int>(tab - leaf.tabs.begin());
    leaf.tabs.erase(tab);
    if (leaf.active > index) --leaf.active;
    leaf.active = std::clamp(leaf.active, 0, std::max(0, static_cast<int>(leaf.tabs.size()) - 1));
}

void DockLayout::move(std::string_view panel, int leaf, DockSide side, int position) {
    assert(leaf >= 0 && leaf < static_cast<int>(nodes.size()) && nodes[static_cast<std::size_t>(leaf)].leaf());
    const std::string name(panel);  // `panel` may be a view of a string that is moved
    const int from = find(name);
    const auto index = static_cast<std::size_t>(leaf);
    if (from == leaf && nodes[index].tabs.size() == 1) return;
    if (from == leaf && side == DockSide::center && position >= 0) {
        const auto& tabs = nodes[index].tabs;
        if (std::find(tabs.begin(), tabs.end(), name) - tabs.begin() < position) --position;
    }
    take_out(name);
    if (side == DockSide::center) {
        auto& tabs = nodes[index].tabs;
        const int count = static_cast<int>(tabs.size());
        const int at = position < 0 ? count : std::min(position, count);
        tabs.insert(tabs.begin() + at, name);
        nodes[index].active = at;
    } else {
        const DockNode old = nodes[index];
        const bool before = side == DockSide::left || side == DockSide::top;
        const bool x = side == DockSide::left || side == DockSide::right;
        const int next = static_cast<int>(nodes.size());
        nodes.push_back(old);
        nodes.push_back({.tabs = {name}});
        nodes[index] = {
            .axis = x ? Axis::x : Axis::y, .first = before ? next + 1 : next, .second = before ? next : next + 1};
    }
    if (from >= 0 && nodes[static_cast<std::size_t>(from)].leaf() && nodes[static_cast<std::size_t>(from)].tabs.empty())
        drop_leaf(from);
    compact();
}

void DockLayout::close(std::string_view panel) {
    const std::string name(panel);
    const int from = find(name);
    if (from < 0) return;
    const bool alone = nodes[static_cast<std::size_t>(from)].tabs.size() == 1;
    if (alone && nodes.size() == 1) return;
    take_out(name);
    closed.push_back(name);
    if (alone) drop_leaf(from);
    compact();
}

void DockLayout::show(std::string_view panel) {
    const std::string name(panel);
    if (nodes.empty()) nodes.emplace_back();
    int at = find(name);
    if (at < 0) {
        std::erase(closed, name);
        at = first_leaf(nodes);
        nodes[static_cast<std::size_t>(at)].tabs.push_back(name);
    }
    DockNode& leaf = nodes[static_cast<std::size_t>(at)];
    leaf.active = static_cast<int>(std::find(leaf.tabs.begin(), leaf.tabs.end(), name) - leaf.tabs.begin());
}

void DockLayout::fit(std::span<const std::string_view> panels) {
    if (nodes.empty()) nodes.emplace_back();
    std::vector<std::string_view> left(panels.begin(), panels.end());
    const auto stays = [&](const std::string& name) {  // it is a known panel that has not come before
        const auto at = std::find(left.begin(), left.end(), name);
        if (at == left.end()) return false;
        left.erase(at);
        return true;
    };
    for (DockNode& node : nodes) {
        if (!node.leaf()) node.tabs.clear();
        const bool any = node.active >= 0 && node.active < static_cast<int>(node.tabs.size());
        const std::string front = any ? node.tabs[static_cast<std::size_t>(node.active)] : std::string();
        std::erase_if(node.tabs, [&](const std::string& name) { return !stays(name); });
        const auto at = std::find(node.tabs.begin(), node.tabs.end(), front);
        node.active = at == node.tabs.end() ? 0 : static_cast<int>(at - node.tabs.begin());
        if (!std::isfinite(node.fraction)) node.fraction = 0.5F;
        node.fraction = std::clamp(node.fraction, least_fraction, 1 - least_fraction);
    }
    std::erase_if(closed, [&](const std::string& name) { return !stays(name); });
    for (bool again = true; again;) {  // leaves that are empty now
        again = false;
        for (std::size_t i = 1; i < nodes.size() && !again; ++i) {
            if (!nodes[i].leaf() || !nodes[i].tabs.empty()) continue;
            drop_leaf(static_cast<int>(i));
            compact();
            again = true;
        }
    }
    auto& tabs = nodes[static_cast<std::size_t>(first_leaf(nodes))].tabs;
    tabs.insert(tabs.end(), left.begin(), left.end());
    if (tabs.empty() && !closed.empty()) tabs.push_back(closed.front()), closed.erase(closed.begin());
}

DockLayout dock_tabs(std::initializer_list<std::string_view> panels) {
    DockLayout layout;
    layout.nodes.emplace_back().tabs.assign(panels.begin(), panels.end());
    return layout;
}

DockLayout dock_split(Axis axis, float fraction, const DockLayout& first, const DockLayout& second) {
    DockLayout layout;
    layout.nodes.push_back({.axis = axis, .fraction = fraction});
    const int a = put_copy(first.nodes, 0, layout.nodes);
    const int b = put_copy(second.nodes, 0, layout.nodes);
    layout.nodes[0].first = a;
    layout.nodes[0].second = b;
    return layout;
}

std::string write_layouts(std::span<const NamedLayout> layouts) {
    ordered_json json = {{"version", version}, {"layouts", ordered_json::array()}};
    for (const NamedLayout& each : layouts) {
        ordered_json layout = {{"name", each.name}};
        if (!each.layout.nodes.empty()) layout["root"] = json_of(each.layout, 0);
        if (!each.layout.closed.empty()) layout["closed"] = each.layout.closed;
        json["layouts"].push_back(std::move(layout));
    }
    return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::vector<NamedLayout> read_layouts(std::string_view text, std::span<const std::string_view> panels,
                                      std::span<const RenamedPanel> renamed) {
    try {
        const ordered_json json = ordered_json::parse(text);
        if (const int found = json.at("version").get<int>(); found != version)
            throw std::invalid_argument("version " + std::to_string(found) + " is not known");
        std::vector<NamedLayout> layouts;
        for (const ordered_json& each : json.at("layouts")) {
            NamedLayout named{.name = each.at("name").get<std::string>(), .layout = {}};
            if (each.contains("root")) read_node(each.at("root"), named.layout.nodes, 0);
            if (each.contains("closed")) named.layout.closed = each.at("closed").get<std::vector<std::string>>();
            for (DockNode& node : named.layout.nodes) rename(node.tabs, renamed);
            rename(named.layout.closed, renamed);
            named.layout.fit(panels);
            layouts.push_back(std::move(named));
        }
        return layouts;
    } catch (const nlohmann::json::exception& e) {
        throw std::invalid_argument(std::string("layouts: ") + e.what());
    } catch (const std::invalid_argument& e) {
        throw std::invalid_argument(std::string("layouts: ") + e.what());
    }
}

}  // namespace lapfx::ui
