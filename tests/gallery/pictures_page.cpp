#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/core/node.h"

namespace lapfx::gallery {

namespace {

void views(ui::Ui& ui, PicturesState& s) {
    constexpr std::array<std::string_view, 4> kinds = {"Wipe", "Side by side", "Onion", "Difference"};
    const ui::Row row(ui, {.width = ui::grow(), .gap = 1, .cross = ui::ChildAlign::start});
    {
        const Part part(ui, "Picture");
        ui.parent().size[0] = ui::grow();
        const ui::Row options(ui);
        ui::checkbox(ui, "Magnifier", s.magnifier);
    }
    const Part part(ui, "Compare");
    ui.parent().size[0] = ui::grow();
    s.kind = static_cast<int>(s.compare.kind);
    if (ui::segmented(ui, "Kind", s.kind, kinds)) s.compare.kind = static_cast<ui::CompareKind>(s.kind);
}

void pictures(ui::Ui& ui, PicturesState& s) {
    const ui::Row row(ui,
                      {.width = ui::grow(), .height = ui::px(ui.em(16)), .gap = 1, .cross = ui::ChildAlign::stretch});
    ui::image_view(ui, "Picture view", s.smoky.picture(), s.view, {.magnifier = s.magnifier, .sample_box = 3});
    ui::compare_view(ui, "Compare view", s.clean.picture(), s.smoky.picture(), s.compare,
                     {.first_label = "clean", .second_label = "smoke", .magnifier = s.magnifier});
}

void scopes(ui::Ui& ui, PicturesState& s) {
    const Part part(ui, "Histogram and scopes");
    const ui::Row row(ui,
                      {.width = ui::grow(), .height = ui::px(ui.em(16)), .gap = 1, .cross = ui::ChildAlign::stretch});
    ui::histogram(ui, "Luma", {.bins = s.luma}, &s.levels, {.log_counts = &s.log_counts});
    ui::vectorscope(ui, "Chroma", s.vectors.handle(), &s.key);
    ui::waveform(ui, "Waveform", s.waves.handle());
}

}  // namespace

void pictures_page(ui::Ui& ui, State& state) {
    views(ui, state.pictures);
    pictures(ui, state.pictures);
    scopes(ui, state.pictures);
}

}  // namespace lapfx::gallery
