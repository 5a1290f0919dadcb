// What the preset panel needs beside the values: locks, favourites, what differs from the file, what is wrong, and what
// is done to many parameters at once.
//
//     tuning.follow();                                   // once a build: up to date with the document
//     if (tuning.changed(entry)) ...                     // entry: index into app::parameters()
//     tuning.randomise(&parameters().group("bleeding")); // one undo step, within locks and rules
//
// UI thread. follow() works only when the document has changed; all else is looked up.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/tuning/parameters.h"
#include "document/document.h"

namespace lapfx::app {

class Notices;
class PreviewHost;
class Saved;
class Settings;

class Tuning {
  public:
    struct Range {
        double low, high;
    };

    /// All must outlive it.
    Tuning(document::Document& document, Saved& saved, const PreviewHost& preview, Settings& settings,
           Notices& notices);
    void follow();

    // --- of one parameter --------------------------------------------------------------------------------------------
    bool locked(std::size_t entry) const { return states_[entry].locked; }
    void lock(std::size_t entry, bool locked) { states_[entry].locked = locked; }
    bool favourite(std::size_t entry) const { return states_[entry].favourite; }
    void mark_favourite(std::size_t entry, bool favourite);
    const std::vector<std::size_t>& favourites() const { return favourites_; }  ///< in the order they were marked
    /// Differs from standard(), the preset as it was opened or saved.
    bool changed(std::size_t entry) const { return states_[entry].changed; }
    const Preset& standard() const;
    /// What is wrong with it; empty: nothing.
    const std::string& fault(std::size_t entry) const { return states_[entry].fault; }
    /// The range of its bar and of randomising: as the user has set it, else as the table allows.
    Range range(std::size_t entry) const;
    void set_range(std::size_t entry, const Range& range) { states_[entry].range = range; }

    // --- of many -----------------------------------------------------------------------------------------------------
    int changed_in(const ParameterGroup& group) const { return changed_in_[index_of(group)]; }
    int changed_in_all() const { return changed_in_all_; }
    bool all_locked(const ParameterGroup& group) const;
    void lock(const ParameterGroup& group, bool locked);
    /// What is wrong with the preset, but with none of its parameters: with its clips.
    const std::vector<std::string>& other_faults() const { return other_faults_; }

    /// Null stands for all groups. Each call is one undo step. Only randomise() leaves locked values as they are.
    void reset(const ParameterGroup* group);
    void reset(std::size_t entry);
    /// Changes the present values at random. The same seed, preset, locks and strength give the same values. Rules
    /// between values hold if they held before. Gives how many values changed.
    int randomise(const ParameterGroup* group);
    static constexpr double standard_strength = 0.1;
    /// How far a value may move, as a part of its range; at 1 anywhere in it, and choices change, too.
    double strength = standard_strength;
    std::uint64_t seed = 1;  ///< of the next randomise(), which adds 1 to it

    std::string copy(const ParameterGroup* group) const;
    /// False: nothing of it could be taken; notices say why.
    bool paste(const std::string& text, const ParameterGroup* group);
    std::string copy(std::size_t entry) const;
    bool paste(const std::string& text, std::size_t entry);

    // --- what the panel shows ----------------------------------------------------------------------------------------
    std::string search;
    bool changed_only = false;
    std::uint64_t search_from = 0;   ///< what had the keyboard before the search field
    bool wants_search = false;       ///< the search field gets the keyboard in the next build
    std::size_t current = no_entry;  ///< the row that has or had the keyboard
    std::size_t wanted = no_entry;   ///< the row that gets it in the next build of the panel, and comes into sight
    void want(std::size_t entry);    ///< a search that would hide it ends

  private:
    struct State {
        bool locked = false, favourite = false, changed = false;
        std::string fault;
        std::optional<Range> range;
    };
    static std::size_t index_of(const ParameterGroup& group);
    void follow_favourites();
    void follow_values();
    void follow_faults();

    document::Document& document_;
    Saved& saved_;
    const PreviewHost& preview_;
    Settings& settings_;
    Notices& notices_;
    std::vector<State> states_;  ///< each entry has one
    std::vector<int> changed_in_;
    int changed_in_all_ = 0;
    std::vector<std::string> other_faults_, favourite_keys_;
    std::vector<std::size_t> favourites_;
    std::uint64_t followed_ = 0;                  ///< version of the document
    std::shared_ptr<const Preset> saved_preset_;  ///< that the values are compared with
    std::vector<std::string> clip_faults_;
};

}  // namespace lapfx::app
