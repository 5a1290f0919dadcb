#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/widgets/color_field.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/text_field.h"

namespace lapfx::gallery {

namespace {

void text_fields(ui::Ui& ui, FieldsState& state) {
    const Part part(ui, "Text fields");
    {
        const Line line(ui, "plain");
        ui::text_field(ui, "Name", state.name, {.caption = true});
        ui::text_field(ui, "Empty", state.empty, {.placeholder = "What it is for"});
        ui::text_field(ui, "Other scripts", state.unicode);
    }
    {
        const Line line(ui, "states");
        ui::text_field(ui, "Wrong", state.wrong, {.tip = "apples is not a unit", .invalid = true});
        ui::text_field(ui, "Read only", state.long_line, {.read_only = true});
        ui::text_field(ui, "Monospace", state.code, {.monospace = true});
    }
    {
        const Line line(ui, "disabled", true);
        ui::text_field(ui, "Name", state.name, {.caption = true});
        ui::text_field(ui, "Empty", state.empty, {.placeholder = "What it is for"});
        ui::search_field(ui, "Search", state.search);
    }
    const Line line(ui, "search");
    ui::search_field(ui, "Find a clip", state.search, {.placeholder = "Clips"});
    ui::search_field(ui, "Find nothing", state.empty, {.placeholder = "Presets"});
}

void choices(ui::Ui& ui, FieldsState& state) {
    constexpr std::array<std::string_view, 3> views = {"Matte", "Holdout", "False colour"};
    constexpr std::array<std::string_view, 4> clips = {"plume_left.mov", "plume_right.mov", "haze_slow.mov",
                                                       "a clip with a name that is too long for its place.mov"};
    const Part part(ui, "Choices");
    for (const bool disabled : {false, true}) {
        const Line line(ui, disabled ? "disabled" : "enabled", disabled);
        ui::segmented(ui, "View", state.view, views);
        ui::combo(ui, "Clip", state.clip, clips, {.caption = true});
        ui::combo(ui, "Nothing chosen", state.nothing, clips, {.placeholder = "Choose a clip"});
    }
    const Line line(ui, "ten thousand");
    ui::combo(ui, "Frame", state.frame, state.frames);
}

void colors(ui::Ui& ui, FieldsState& state) {
    const Part part(ui, "Colours");
    {
        const Line line(ui, "enabled");
        ui::color_field(ui, "Tissue", state.tissue, {.caption = true});
        ui::color_field(ui, "Glass", state.glass, {.alpha = true, .caption = true});
    }
    const Line line(ui, "disabled", true);
    ui::color_field(ui, "Tissue", state.tissue, {.caption = true});
}

}  // namespace

void fields_page(ui::Ui& ui, State& state) {
    text_fields(ui, state.fields);
    choices(ui, state.fields);
    colors(ui, state.fields);
}

}  // namespace lapfx::gallery
