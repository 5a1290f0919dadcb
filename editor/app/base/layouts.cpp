#include "app/base/layouts.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "lapfx/authoring/letters.h"

namespace lapfx::app {

namespace {

using ui::dock_tabs;
using ui::DockLayout;

constexpr glm::vec2 least_window{58, 30};  // em, for panels beside each other

/// All panels in one group, in their order, with the front panel of the first group in front.
DockLayout stack_of(const DockLayout& layout) {
    DockLayout stack = dock_tabs({});
    stack.nodes.front().tabs.clear();
    stack.closed = layout.closed;
    bool first = true;
    for (const ui::DockNode& node : layout.nodes) {
        if (!node.leaf()) continue;
        std::vector<std::string>& tabs = stack.nodes.front().tabs;
        if (std::exchange(first, false)) stack.nodes.front().active = node.active;
        tabs.insert(tabs.end(), node.tabs.begin(), node.tabs.end());
    }
    return stack;
}

}  // namespace

void Layouts::set_panels(std::vector<std::string_view> names, std::vector<StandardLayout> standard,
                         std::vector<ui::RenamedPanel> renamed) {
    panels_ = std::move(names);
    standard_ = std::move(standard);
    renamed_ = std::move(renamed);
    for (const StandardLayout& layout : standard_) check(layout.make(), layout.name);
    choose(standard_.front().name);
}

void Layouts::check(const DockLayout& layout, std::string_view name) const {
    for (const ui::DockNode& node : layout.nodes)
        for (const std::string& tab : node.tabs)
            if (std::find(panels_.begin(), panels_.end(), tab) == panels_.end())
                throw std::logic_error("layout " + std::string(name) + ": " + tab + " is not a panel");
}

void Layouts::bring_to_front(std::string_view panel) {
    if (std::find(panels_.begin(), panels_.end(), panel) == panels_.end())
        throw std::logic_error(std::string(panel) + " is not a panel");
    shown.show(panel);
}

void Layouts::show(ui::DockLayout layout) {
    if (stacked_) {
        shown = stack_of(layout);
        wide_ = std::move(layout);
    } else {
        shown = std::move(layout);
    }
}

void Layouts::fit_window(glm::vec2 ems) {
    const bool small = ems.x < least_window.x || ems.y < least_window.y;
    if (small == stacked_) return;
    if (small) {
        stacked_ = true;
        return show(std::move(shown));
    }
    const DockLayout stack = shown;
    shown = arranged();
    stacked_ = false;
    for (const ui::DockNode& node : stack.nodes)
        if (node.leaf() && !node.tabs.empty()) shown.show(node.tabs[static_cast<std::size_t>(node.active)]);
}

const DockLayout& Layouts::arranged() const {
    if (!stacked_) return shown;
    for (const std::string& panel : shown.closed)
        if (wide_.find(panel) >= 0) wide_.close(panel);
    for (const ui::DockNode& node : shown.nodes)
        for (const std::string& panel : node.tabs)
            if (wide_.find(panel) < 0) wide_.show(panel);
    return wide_;
}

std::vector<std::string> Layouts::names() const {
    std::vector<std::string> names;
    for (const StandardLayout& standard : standard_) names.emplace_back(standard.name);
    for (const ui::NamedLayout& own : own_) names.push_back(own.name);
    return names;
}

bool Layouts::standard(std::string_view name) const {
    return std::any_of(standard_.begin(), standard_.end(),
                       [&](const StandardLayout& s) { return same_letters(s.name, name); });
}

bool Layouts::seen(std::string_view panel) const {
    const int leaf = shown.find(panel);
    if (leaf < 0) return false;
    const ui::DockNode& node = shown.nodes[static_cast<std::size_t>(leaf)];
    return node.tabs[static_cast<std::size_t>(node.active)] == panel;
}

bool Layouts::choose(std::string_view name) {
    for (const StandardLayout& standard : standard_) {
        if (!same_letters(standard.name, name)) continue;
        DockLayout layout = standard.make();
        layout.fit(panels_);  // a panel that it does not name comes into its first group
        show(std::move(layout));
        name_ = standard.name;
        return true;
    }
    for (const ui::NamedLayout& own : own_) {
        if (!same_letters(own.name, name)) continue;
        show(own.layout);
        name_ = own.name;
        return true;
    }
    return false;
}

bool Layouts::keep(const std::string& name) {
    if (name.empty() || standard(name)) return false;
    remove(name);
    own_.push_back({.name = name, .layout = arranged()});
    ++version_;
    name_ = name;
    return true;
}

bool Layouts::remove(const std::string& name) {
    ++version_;
    return std::erase_if(own_, [&](const ui::NamedLayout& own) { return same_letters(own.name, name); }) > 0;
}

}  // namespace lapfx::app
