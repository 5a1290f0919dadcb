#include "app/tuning/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "app/tuning/parameter_words.h"
#include "document/tables.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/preset.h"

namespace lapfx::app {

namespace {

std::string number_text(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
}

/// "#730809" where 8 bits tell it exactly, as presets write colours.
std::string color_text(const glm::dvec3& color) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string hex = "#", numbers;
    bool exact = true;
    for (int i = 0; i < 3; ++i) {
        const auto code = static_cast<int>(std::lround(std::clamp(color[i], 0.0, 1.0) * 255));
        exact &= std::abs(code / 255.0 - color[i]) < 1e-9;
        hex += {digits[static_cast<std::size_t>(code >> 4)], digits[static_cast<std::size_t>(code & 15)]};
        numbers += (i > 0 ? "," : "") + number_text(color[i]);
    }
    return exact ? hex : numbers;
}

std::string without(std::string_view text, std::string_view end) {
    return std::string(text.ends_with(end) ? text.substr(0, text.size() - end.size()) : text);
}

bool counts(const Parameter& row) {
    return row.kind == Kind::number || row.kind == Kind::integer || row.kind == Kind::vector;
}

std::string tip_of(const ParameterEntry& entry) {
    static const Preset defaults;
    return tip_text(*entry.row, entry.owner(defaults)) + '\n' + entry.key;
}

}  // namespace

std::string tip_text(const Parameter& row, const void* defaults) {
    std::string tip = std::string(row.help) + (row.help.empty() ? "" : "\n") + upper_first(row.expected());
    if (counts(row) && row.unit.empty()) tip += ", no unit";
    const std::string standard = defaults != nullptr ? text_of(row, row.get(defaults)) : std::string();
    return standard.empty() ? tip : tip + "; " + standard + " by default";
}

std::string search_words(std::string_view title, std::string_view key, std::string_view help) {
    std::string words = std::string(title) + ' ' + std::string(key) + ' ' + std::string(help);
    for (std::size_t end = 0; end < key.size();) {
        end = std::min(key.find('.', end + 1), key.size());
        words += ' ' + std::string(everyday_words(key.substr(0, end)));
    }
    return lower(words);
}

std::string text_of(const Parameter& row, const Value& value) {
    switch (row.kind) {
        case Kind::number:
            return number_text(std::get<double>(value));
        case Kind::integer:
            return std::to_string(std::get<int>(value));
        case Kind::boolean:
            return std::get<bool>(value) ? "true" : "false";
        case Kind::choice:
            return std::string(row.choices[static_cast<std::size_t>(std::get<int>(value))]);
        case Kind::color:
            return color_text(std::get<glm::dvec3>(value));
        case Kind::vector: {
            const auto& v = std::get<glm::dvec3>(value);
            return number_text(v.x) + ',' + number_text(v.y) + ',' + number_text(v.z);
        }
        default:
            return std::get<std::string>(value);
    }
}

void* ParameterEntry::owner(Preset& preset) const {
    void* at = &preset;
    for (const Table* next : way) at = next->member(at);
    return at;
}

const void* ParameterEntry::owner(const Preset& preset) const {
    return owner(const_cast<Preset&>(preset));  // only an address is taken, nothing is written
}

bool ParameterEntry::same(const Preset& a, const Preset& b) const {
    if (row->kind == Kind::text || row->kind == Kind::path) return in<std::string>(a) == in<std::string>(b);
    return row->get(owner(a)) == row->get(owner(b));
}

Parameters::Parameters() {
    add(preset_table(), "", {});
    for (const ParameterGroup& group : groups_) pair_bounds(group);
    for (ParameterEntry& entry : entries_) entry.tip = tip_of(entry);
}

void Parameters::add(const Table& table, const std::string& key, const std::vector<const Table*>& way) {
    if (!table.rows.empty()) {
        ParameterGroup group{.table = &table, .key = key, .name = std::string(table.name), .first = entries_.size()};
        for (const Parameter& row : table.rows) {
            ParameterEntry entry{.row = &row, .table = &table, .group = groups_.size(), .way = way};
            entry.key = key.empty() ? std::string(row.key) : key + '.' + std::string(row.key);
            entry.pointer = '/' + entry.key;
            std::replace(entry.pointer.begin(), entry.pointer.end(), '.', '/');
            entry.title = key.empty() ? std::string(row.name) : group.name + ": " + std::string(row.name);
            entry.words = search_words(entry.title, entry.key, row.help);
            entries_.push_back(std::move(entry));
        }
        group.last = entries_.size();
        groups_.push_back(std::move(group));
    }
    for (const Table& child : table.tables) {
        if (child.list != nullptr || child.present != nullptr) continue;
        std::vector<const Table*> on = way;
        on.push_back(&child);
        add(child, key.empty() ? std::string(child.key) : key + '.' + std::string(child.key), on);
    }
}

/// x_low and x_high, with a rule between them, are shown as one range.
void Parameters::pair_bounds(const ParameterGroup& group) {
    constexpr std::string_view low_end = "_low", high_end = "_high";
    for (const Rule& rule : group.table->rules) {
        if (!rule.key.ends_with(low_end)) continue;
        const std::string key = group.key + '.' + std::string(rule.key);
        const std::size_t low = find(key), high = find(without(key, low_end) + std::string(high_end));
        if (low == no_entry || high == no_entry) continue;
        ParameterEntry& entry = entries_[low];
        entry.high = high;
        entries_[high].low = low;
        entry.range_name = without(entry.row->name, " low");
        entry.range_title = group.name + ": " + entry.range_name;
        entry.words += ' ' + entries_[high].words;
    }
}

std::size_t Parameters::find(std::string_view key) const {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& e) { return e.key == key; });
    return found == entries_.end() ? no_entry : static_cast<std::size_t>(found - entries_.begin());
}

std::size_t Parameters::find_pointer(std::string_view at) const {
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& e) { return e.pointer == at; });
    return found == entries_.end() ? no_entry : static_cast<std::size_t>(found - entries_.begin());
}

const ParameterGroup& Parameters::group(std::string_view key) const {
    for (const ParameterGroup& group : groups_)
        if (group.key == key) return group;
    throw std::out_of_range("no group of parameters \"" + std::string(key) + '"');
}

const Parameters& parameters() {
    static const Parameters all;
    return all;
}

}  // namespace lapfx::app
