// Short news in the lower right corner, for what needs no answer. They go by themselves, errors only by hand. They take the
// keyboard from nobody, but have it when asked: take_focus().
//
//     toasts.add({.kind = ui::ToastKind::good, .text = "Exported 240 frames", .action = "Show", .act = [&] { show(); }});
//     ...
//     toasts.build(u);  // last of all, once a frame
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/core/ui.h"

namespace lapfx::ui {

enum class ToastKind : std::uint8_t { info, good, warning, error };

struct Toast {
    ToastKind kind = ToastKind::info;
    std::string text{};
    std::string action{};         ///< of a button; empty: none
    std::function<void()> act{};  ///< what that does; the toast goes
    double seconds = -1;          ///< that it stays; 0: until it is clicked; negative: as its kind asks for
};

/// UI thread only.
class Toasts {
  public:
    /// The same kind and text again: counts, and stays as long as a new one.
    void add(Toast toast);
    void build(Ui& ui);
    /// The newest that is seen gets the keyboard, for a command to call: up and down go to the others, Enter is the button (without
    /// one the notice goes), Delete lets it go, Esc and this again give the keyboard back. Their time stands meanwhile.
    void take_focus() { wants_focus_ = true; }
    void clear() { all_.clear(); }
    std::size_t size() const { return all_.size(); }  ///< shown and waiting

  private:
    struct Shown {
        Toast toast;
        double left = 0;  ///< s
        int count = 1;
        bool counting = false;  ///< since the build after the one that showed it first
        std::uint64_t serial = 0;
    };
    static constexpr std::size_t most_shown = 4;

    void count_down(double passed);
    /// Gives whether it is to go, and then what is to be done (may be nothing).
    bool build_one(Ui& ui, const Shown& shown, std::function<void()>& act);

    void take_keys(Ui& ui, bool wants_focus, std::size_t& gone);

    std::vector<Shown> all_;  ///< the oldest first
    std::vector<Id> ids_;     ///< of those seen
    Id before_ = 0;           ///< had the keyboard
    std::uint64_t serial_ = 0;
    double time_ = 0;
    bool added_ = false;
    bool hovered_ = false;  ///< or has the keyboard
    bool wants_focus_ = false;
};

}  // namespace lapfx::ui
