// Every widget in every state, to look at and to test with: `lapfx gallery`. The pages are independent of windows and
// of the effects core.
//
//     ui::ImageStore images;
//     gallery::State state(images);
//     ui::Ui ui(fonts, {.images = &images, .shortcuts = &state.commands});
//     ui.frame(input, [&](ui::Ui& u) { gallery::build(u, state); });
//
// A page is a function in a file of its own; gallery.cpp lists them.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "gallery/state.h"

namespace lapfx::gallery {

struct Page {
    std::string_view name;
    void (*build)(ui::Ui&, State&);
};
std::span<const Page> pages();
/// The index of the page with this name, in upper or lower case; -1: there is none.
int page_named(std::string_view name);

void build(ui::Ui& ui, State& state);

void overview_page(ui::Ui& ui, State& state);
void basic_page(ui::Ui& ui, State& state);
void text_page(ui::Ui& ui, State& state);
void icons_page(ui::Ui& ui, State& state);
void colors_page(ui::Ui& ui, State& state);
void layout_page(ui::Ui& ui, State& state);
void fields_page(ui::Ui& ui, State& state);
void params_page(ui::Ui& ui, State& state);
void lists_page(ui::Ui& ui, State& state);
void panels_page(ui::Ui& ui, State& state);
void pictures_page(ui::Ui& ui, State& state);
void graphs_page(ui::Ui& ui, State& state);
void shell_page(ui::Ui& ui, State& state);
void overlays_page(ui::Ui& ui, State& state);

}  // namespace lapfx::gallery
