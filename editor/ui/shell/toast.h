// Notices in the lower right corner that need no answer. They go by themselves, except for errors; the newest lies at
// the bottom and is always seen. Those that have gone, or had no room, are kept in a log. They never take the keyboard;
// take_focus() gives it to them.
//
//     toasts.add({.kind = ui::ToastKind::good, .text = "Exported 240 frames", .action = "Show",
//                 .act = [&] { show(); }});
//     ...
//     toasts.build(u);  // last of all, once a frame
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "ui/core/ui.h"

namespace lapfx::ui {

enum class ToastKind : std::uint8_t { info, good, warning, error };

struct Toast {
    ToastKind kind = ToastKind::info;
    std::string text{};
    std::string action{};         ///< text of its button; empty: none
    std::function<void()> act{};  ///< what that does; the toast goes
    double seconds = -1;          ///< that it stays; 0: until it is closed; negative: as its kind asks for
};

/// A line of the log.
struct ToastNote {
    ToastKind kind = ToastKind::info;
    std::string text;
    int count = 1;    ///< times in a row
    double time = 0;  ///< s, of the newest, as Ui::time()
};

/// UI thread only.
class Toasts {
  public:
    static constexpr std::size_t most_kept = 4;     ///< that can be on the screen
    static constexpr std::size_t most_notes = 200;  ///< the log has no more; the oldest go first

    /// The same kind and text again: counts, becomes the newest, and stays as long as a new one. Where there are too
    /// many, the oldest that would go by itself gives way, else the oldest.
    void add(Toast toast);
    /// Esc closes the newest when nothing else has a use for it.
    void build(Ui& ui);
    /// The newest gets the keyboard, for a command to call: up and down go to the others, Enter is the button (without
    /// one the notice goes), Delete and Esc close it, and this again gives the keyboard back. Their time stands
    /// meanwhile.
    void take_focus() { wants_focus_ = true; }
    /// A dialog of all there were.
    void open_log(Ui& ui);
    std::span<const ToastNote> log() const { return log_; }  ///< the oldest first
    void clear() { all_.clear(), hidden_ = 0; }
    std::size_t size() const { return all_.size(); }  ///< on the screen, or without room there

  private:
    struct ListedToast {
        Toast toast;
        double left = 0;  ///< s
        int count = 1;
        bool seen = false;  ///< in the last build: its time goes on
        std::uint64_t serial = 0;
    };
    /// What happened to a notice in a build.
    struct Answer {
        bool gone = false;
        std::function<void()> act{};
    };

    void note(const Toast& toast);
    void count_down(double passed);
    std::size_t first_in_sight(Ui& ui) const;
    Answer build_one(Ui& ui, ListedToast& shown);
    void build_rest(Ui& ui, std::size_t out_of_sight);
    void build_log(Ui& ui);
    void take_keys(Ui& ui, bool wants_focus, std::size_t& gone);

    std::vector<ListedToast> all_;  ///< the oldest first
    std::vector<ToastNote> log_;
    std::vector<Id> ids_;  ///< of those seen
    Id before_ = 0;        ///< had the keyboard
    std::uint64_t serial_ = 0;
    std::size_t hidden_ = 0;  ///< that gave way since there was none last
    double time_ = 0;
    bool added_ = false;
    bool hovered_ = false;  ///< the pointer is over it, or it has the keyboard
    bool wants_focus_ = false;
};

}  // namespace lapfx::ui
