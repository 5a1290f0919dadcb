// What the preset panel needs beside the values: locks, favourites, what differs from the file, what is wrong, and what
// is done to many parameters at once.
//
//     Tuning& tuning = editor.tuning();
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

#include "app/parameters.h"
#include "document/document.h"

namespace lapfx::app {

class Editor;

class Tuning {
  public:
    struct Range {
        double low, high;
    };

    explicit Tuning(Editor& editor);
    void follow();

    // --- of one parameter --------------------------------------------------------------------------------------------
    bool locked(std::size_t entry) const { return states_[entry].locked; }
    void lock(std::size_t entry, bool locked) { states_[entry].locked = locked; }
    bool favourite(std::size_t entry) const { return states_[entry].favourite; }
    void mark_favourite(std::size_t entry, bool favourite);
    const std::vector<std::size_t>& favourites() const { return favourites_; }  ///< in the order they were marked
    /// Differs from standard(), the preset as it was opened or saved.
    bool changed(std::size_t entry) const { return states_[entry].changed; }
    const Preset& standard() const { return saved_.preset; }
    /// Scene and preset as they were opened or saved: what the dot of a row compares with and Backspace goes back to.
    const document::Content& saved() const { return saved_; }
    /// What was saved of this clip, wherever it stood in the list then: the same file, as often used before it, however
    /// the folder of either names it. Null: it is new.
    const SmokeClip* saved_clip(std::size_t number) const;
    /// What is wrong with it; empty: nothing.
    const std::string& fault(std::size_t entry) const { return states_[entry].fault; }
    /// Where bars and randomising go: what the user has set, else what the table allows.
    Range range(std::size_t entry) const;
    void set_range(std::size_t entry, const Range& range) { states_[entry].range = range; }

    // --- of many -----------------------------------------------------------------------------------------------------
    int changed_in(const ParameterGroup& group) const { return changed_in_[index_of(group)]; }
    int changed_in_all() const { return changed_in_all_; }
    bool all_locked(const ParameterGroup& group) const;
    void lock(const ParameterGroup& group, bool locked);
    /// What is wrong with the preset, but with none of its parameters: with its clips.
    const std::vector<std::string>& other_faults() const { return other_faults_; }

    /// Null stands for all groups. Each is one undo step; locked values stay with randomise(), only with that.
    void reset(const ParameterGroup* group);
    void reset(std::size_t entry);
    /// From the values as they are. The same seed, preset, locks and strength give the same values. Rules between
    /// values hold if they held before. Gives how many values changed.
    int randomise(const ParameterGroup* group);
    static constexpr double standard_strength = 0.1;
    /// How far a value goes at most, of its range; 1: anywhere in it, choices too.
    double strength = standard_strength;
    std::uint64_t seed = 1;  ///< of the next randomise(); it counts on

    std::string copy(const ParameterGroup* group) const;
    /// False, with toasts that say why: nothing of it could be taken.
    bool paste(const std::string& text, const ParameterGroup* group);
    std::string copy(std::size_t entry) const;
    bool paste(const std::string& text, std::size_t entry);

    // --- what the panel shows ----------------------------------------------------------------------------------------
    std::string search;
    bool changed_only = false;
    bool wants_search = false;       ///< the field is to have the keyboard
    std::size_t current = no_entry;  ///< the row that has or had the keyboard
    std::size_t wanted = no_entry;   ///< the row that is to have it, in sight, from the next build of the panel
    void want(std::size_t entry);    ///< nothing that the panel is narrowed to hides it

  private:
    struct State {
        bool locked = false, favourite = false, changed = false;
        std::string fault;
        std::optional<Range> range;
    };
    static std::size_t index_of(const ParameterGroup& group);
    void follow_favourites();
    bool follow_saved(bool scene_changed);
    void follow_saved_clips();
    void follow_values();
    void follow_faults();

    Editor& editor_;
    std::vector<State> states_;  ///< of each entry
    std::vector<int> changed_in_;
    int changed_in_all_ = 0;
    std::vector<std::string> other_faults_, favourite_keys_;
    std::vector<std::size_t> favourites_;
    std::uint64_t followed_ = 0;
    std::shared_ptr<const Preset> saved_preset_;  // that saved_ is of
    std::shared_ptr<const Scene> saved_scene_;
    document::Content saved_;
    std::vector<std::size_t> saved_clips_;  ///< of each clip, its number among the saved ones; no_entry: it is new
    std::vector<std::string> clip_faults_;
};

}  // namespace lapfx::app
