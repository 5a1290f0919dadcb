// The parameters of a preset in one list, made from the parameter table: what the rows of the preset panel, locks,
// favourites and search go by. Lists of objects (smoke clips) are not in it.
//
//     const app::Parameters& all = app::parameters();
//     for (const app::ParameterEntry& entry : all.of(all.group("smoke.keying"))) std::cout << entry.key << '\n';
//
// Made once, then never changed; any thread.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lapfx/parameter.h"

namespace lapfx {
struct Preset;
}

namespace lapfx::app {

inline constexpr std::size_t no_entry = ~std::size_t{0};

/// One row of the table, at its place in a preset.
struct ParameterEntry {
    const Parameter* row = nullptr;
    const Table* table = nullptr;
    std::size_t group = 0;
    std::string key{};                ///< "smoke.keying.luma_low"
    std::string pointer{};            ///< "/smoke/keying/luma_low", as faults name it
    std::string title{};              ///< "Keying: Luma low", where the group is not seen
    std::string tip{};                ///< tip_text() and the key
    std::string words{};              ///< what search looks into
    std::size_t high = no_entry;      ///< where this is a lower bound: the upper one
    std::size_t low = no_entry;       ///< where this is an upper bound: the lower one
    std::string range_name{};         ///< of both: "Luma"
    std::string range_title{};        ///< "Keying: Luma"
    std::vector<const Table*> way{};  ///< from the root to its struct

    void* owner(Preset& preset) const;
    const void* owner(const Preset& preset) const;
    template <typename T>
    T& in(Preset& preset) const {
        return *static_cast<T*>(row->member(owner(preset)));
    }
    template <typename T>
    const T& in(const Preset& preset) const {
        return in<T>(const_cast<Preset&>(preset));  // only an address is taken, nothing is written
    }
    /// No text is copied.
    bool same(const Preset& a, const Preset& b) const;
};

/// One struct of parameters, a section of the panel.
struct ParameterGroup {
    const Table* table = nullptr;
    std::string key{};   ///< "smoke.keying"; empty: the preset's own name, description, tags
    std::string name{};  ///< "Keying"
    std::size_t first = 0, last = 0;
};

class Parameters {
  public:
    Parameters();
    const std::vector<ParameterEntry>& entries() const { return entries_; }
    const std::vector<ParameterGroup>& groups() const { return groups_; }
    const ParameterEntry& operator[](std::size_t entry) const { return entries_[entry]; }
    std::span<const ParameterEntry> of(const ParameterGroup& group) const {
        return std::span(entries_).subspan(group.first, group.last - group.first);
    }
    std::size_t find(std::string_view key) const;             ///< no_entry: none has it
    std::size_t find_pointer(std::string_view at) const;      ///< no_entry: none has it
    const ParameterGroup& group(std::string_view key) const;  ///< throws std::out_of_range

  private:
    void add(const Table& table, const std::string& key, const std::vector<const Table*>& way);
    void pair_bounds(const ParameterGroup& group);

    std::vector<ParameterEntry> entries_;
    std::vector<ParameterGroup> groups_;
};

/// Those of presets.
const Parameters& parameters();

/// What search looks into, in lower case: title, key, help, and the everyday words of the key and of the groups it is
/// in.
std::string search_words(std::string_view title, std::string_view key, std::string_view help);

/// The text of a row's tooltip: what it does, with the paper's term; range and unit; its default if `defaults`, a
/// struct like its owner, is given.
std::string tip_text(const Parameter& row, const void* defaults = nullptr);

/// The value as text that set_parameter() reads: "4.5", "true", "light", "#5d0f11", "1,2,3".
std::string text_of(const Parameter& row, const Value& value);

}  // namespace lapfx::app
