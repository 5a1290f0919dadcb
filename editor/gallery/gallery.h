// Every widget in every state, to look at and to test against: `lapfx gallery`. Knows nothing of windows and of the effects core.
//
//     gallery::State state;
//     ui.frame(input, [&](ui::Ui& u) { gallery::build(u, state); });
//
// A page is a function in a file of its own; gallery.cpp lists them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "ui/widgets/basic.h"

namespace lapfx::gallery {

/// What the pages show and change. Steady frames allocate nothing.
struct State {
    int page = 0;       ///< into pages()
    bool bare = false;  ///< the page alone, without list and switches
    bool light = false;
    bool reduced_motion = false;
    float scale = 1;  ///< that of the window, to be set before each frame; another one afterwards is wanted

    bool close = false;  ///< the window is to be closed

    // Basic
    bool on = true, off = false, quiet_on = true;
    ui::Tristate some = ui::Tristate::mixed;
    int clicks = 0;
    // Overlays
    int answers = 0;
};

struct Page {
    std::string_view name;
    void (*build)(ui::Ui&, State&);
};
std::span<const Page> pages();
/// -1: there is none of this name; case does not matter.
int page_named(std::string_view name);

void build(ui::Ui& ui, State& state);

void overview_page(ui::Ui& ui, State& state);
void basic_page(ui::Ui& ui, State& state);
void text_page(ui::Ui& ui, State& state);
void icons_page(ui::Ui& ui, State& state);
void colors_page(ui::Ui& ui, State& state);
void layout_page(ui::Ui& ui, State& state);
void overlays_page(ui::Ui& ui, State& state);

}  // namespace lapfx::gallery
