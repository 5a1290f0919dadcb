#include "app/layouts.h"

#include <algorithm>
#include <cctype>

namespace lapfx::app {

namespace {

using ui::Axis;
using ui::dock_split;
using ui::dock_tabs;
using ui::DockLayout;

struct Standard {
    const char* name;
    DockLayout (*make)();
};

DockLayout tune() {
    return dock_split(Axis::x, 0.70F,
                      dock_split(Axis::y, 0.73F, dock_tabs({"View", "Reference"}),
                                 dock_tabs({"Timeline", "Amounts", "Curves", "Presets"})),
                      dock_tabs({"Preset", "Clips", "Scene", "Keying", "Snapshots", "History"}));
}

DockLayout key() {
    return dock_split(Axis::x, 0.64F,
                      dock_split(Axis::y, 0.82F, dock_tabs({"Keying", "Reference"}),
                                 dock_tabs({"Timeline", "Amounts", "Curves", "Presets"})),
                      dock_split(Axis::y, 0.45F, dock_tabs({"View"}),
                                 dock_tabs({"Clips", "Preset", "Scene", "Snapshots", "History"})));
}

DockLayout compare() {
    return dock_split(
        Axis::x, 0.72F,
        dock_split(Axis::y, 0.67F, dock_tabs({"Reference", "View", "Keying"}),
                   dock_split(Axis::x, 0.5F, dock_tabs({"Timeline", "Curves", "Presets"}), dock_tabs({"Amounts"}))),
        dock_split(Axis::y, 0.66F, dock_tabs({"Preset", "Clips", "Scene"}), dock_tabs({"Snapshots", "History"})));
}

DockLayout stage() {
    return dock_split(
        Axis::x, 0.70F,
        dock_split(Axis::y, 0.62F, dock_tabs({"View", "Reference", "Keying"}),
                   dock_split(Axis::x, 0.55F, dock_tabs({"Timeline", "Presets"}), dock_tabs({"Curves", "Amounts"}))),
        dock_tabs({"Scene", "Preset", "Clips", "Snapshots", "History"}));
}

constexpr std::array standards = {Standard{"Tune", tune}, Standard{"Key", key}, Standard{"Compare", compare},
                                  Standard{"Stage", stage}};

bool same_name(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return std::tolower(static_cast<unsigned char>(c)); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

Layouts::Layouts() {
    choose("Tune");
}

std::vector<std::string> Layouts::names() const {
    std::vector<std::string> names;
    for (const Standard& standard : standards) names.emplace_back(standard.name);
    for (const ui::NamedLayout& own : own_) names.push_back(own.name);
    return names;
}

bool Layouts::standard(std::string_view name) const {
    return std::any_of(standards.begin(), standards.end(), [&](const Standard& s) { return same_name(s.name, name); });
}

bool Layouts::seen(std::string_view panel) const {
    const int leaf = shown.find(panel);
    if (leaf < 0) return false;
    const ui::DockNode& node = shown.nodes[static_cast<std::size_t>(leaf)];
    return node.tabs[static_cast<std::size_t>(node.active)] == panel;
}

bool Layouts::choose(std::string_view name) {
    for (const Standard& standard : standards) {
        if (!same_name(standard.name, name)) continue;
        shown = standard.make();
        name_ = standard.name;
        return true;
    }
    for (const ui::NamedLayout& own : own_) {
        if (!same_name(own.name, name)) continue;
        shown = own.layout;
        name_ = own.name;
        return true;
    }
    return false;
}

bool Layouts::keep(const std::string& name) {
    if (name.empty() || standard(name)) return false;
    remove(name);
    own_.push_back({.name = name, .layout = shown});
    ++version_;
    name_ = name;
    return true;
}

bool Layouts::remove(const std::string& name) {
    ++version_;
    return std::erase_if(own_, [&](const ui::NamedLayout& own) { return same_name(own.name, name); }) > 0;
}

}  // namespace lapfx::app
