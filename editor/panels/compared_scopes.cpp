#include "panels/compared_scopes.h"

#include <cmath>
#include <string>

#include "app/reference/reference.h"
#include "panels/compared_regions.h"
#include "panels/parts.h"
#include "ui/canvas/histogram.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using app::PictureScopes;
using app::Reference;
using app::ScopesLook;

constexpr std::array<std::string_view, 5> kinds = {"All", "Levels", "Waveform", "Colours", "Regions"};
constexpr float kinds_width = 28, list_width = 8, channel_width = 6;  // em
constexpr float one_line = 64;                                        // em: of this width all of them fit into a line
constexpr float caption_height = 1.5F, least_levels = 3;              // em

/// One of the two pictures.
struct Counted {
    std::string_view name;
    const PictureScopes& scopes;
};

void kind_choice(ui::Ui& ui, ScopesLook& look, bool list) {
    if (list) {
        ui::combo(ui, "Scopes shown", look.kind, kinds,
                  {.tip = "What is counted in the pictures", .width = ui::px(ui.em(list_width))});
        return;
    }
    const Room room(ui, kinds_width);
    ui::segmented(ui, "Scopes shown", look.kind, kinds);
}

void channel_choice(ui::Ui& ui, ScopesLook& look) {
    int channel = static_cast<int>(look.channel);
    if (ui::combo(ui, "Channel", channel, app::channel_titles,
                  {.tip = "What the levels are of", .width = ui::px(ui.em(channel_width))}))
        look.channel = static_cast<app::Channel>(channel);
}

void tools(ui::Ui& ui, ScopesLook& look, const Edited& edited, float room) {
    const bool list = room > 0 && room < ui.em(kinds_width + channel_width + 2);
    const bool levels = look.kind == ScopesLook::all || look.kind == ScopesLook::levels;
    const std::array<ui::ToolItem, 2> items = {
        {{.width = ui.em(list ? list_width : kinds_width)}, {.width = levels ? ui.em(channel_width) : 0, .rank = 1}}};
    ui::toolbar(ui, "Scope tools", room, items,
                [&](std::size_t item) { item == 0 ? kind_choice(ui, look, list) : channel_choice(ui, look); });
    if (look.kind == ScopesLook::regions) region_tools(ui, look, edited, room);
}

/// "Preview, red: mean 112"
std::string_view caption(ui::Ui& ui, const Counted& picture, const ScopesLook& look, int kind) {
    if (kind != ScopesLook::levels || !picture.scopes.counted()) return picture.name;
    constexpr std::array<std::string_view, 4> of = {", luma: mean ", ", red: mean ", ", green: mean ", ", blue: mean "};
    char mean[16];
    const int length = std::snprintf(mean, sizeof mean, "%ld", std::lround(picture.scopes.mean(look.channel)));
    return ui.join({picture.name, of[static_cast<std::size_t>(look.channel)],
                    ui.copy({mean, static_cast<std::size_t>(std::max(length, 0))})});
}

/// `height`: em, of the cell.
void cell(ui::Ui& ui, const Counted& picture, ScopesLook& look, int kind, float height) {
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.1F});
    ui.push_seed(kinds[static_cast<std::size_t>(kind)]);
    ui::label(ui, caption(ui, picture, look, kind), {.tone = ui::Tone::dim, .size = 0.86F, .width = ui::grow()});
    if (kind == ScopesLook::levels)
        ui::histogram(ui, ui.join({"Levels of ", picture.name}), {.bins = picture.scopes.levels(look.channel)}, nullptr,
                      {.log_counts = &look.log_counts,
                       .unit = "levels",
                       .tip = "How often each level occurs, from black on the left to white on the right",
                       .height = std::max(height - caption_height, least_levels)});
    if (kind == ScopesLook::waves)
        ui::waveform(
            ui, ui.join({"Waveform of ", picture.name}), picture.scopes.waves(),
            {.tip = "Luma of the picture's columns from left to right; black at the bottom, white at the top"});
    if (kind == ScopesLook::vectors)
        ui::vectorscope(ui, ui.join({"Colours of ", picture.name}), picture.scopes.vectors(), nullptr,
                        {.tip = "Chroma of the picture; in the middle what has no colour"});
    ui.pop_seed();
}

}  // namespace

void compared_scopes(ui::Ui& ui, Reference& reference, const Edited& edited, glm::vec2 room) {
    app::ReferenceComparison& comparison = reference.comparison();
    ScopesLook& look = comparison.scopes_look;
    const std::array<PictureScopes, 2>& scopes = comparison.scopes();
    const bool alone = comparison.way == app::CompareWay::reference;
    const auto name = [&](std::size_t side) {
        return app::side_titles[static_cast<std::size_t>(alone ? app::CompareSide::reference : comparison.sides[side])];
    };
    const std::array<Counted, 2> both = {{{name(0), scopes[0]}, {name(1), scopes[1]}}};
    const auto pictures = std::span(both).subspan(alone ? 1 : 0);
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.2F});
    tools(ui, look, edited, room.x);
    if (look.kind == ScopesLook::regions)
        return region_figures(ui, reference, edited, {both[0].name, both[1].name}, room.x);
    const bool all = look.kind == ScopesLook::all;
    const bool lines = all && room.x > 0 && room.x < ui.em(one_line) && pictures.size() > 1;
    const float height = std::max(room.y / ui.em(1) - 2.4F, 0.0F) / (lines ? 2 : 1);  // em
    const auto line = [&](std::span<const Counted> shown) {
        const ui::Row row(ui, {.width = ui::grow(), .height = ui::grow(), .cross = ui::ChildAlign::stretch});
        for (int kind = ScopesLook::levels; kind <= ScopesLook::vectors; ++kind)
            for (const Counted& picture : shown)
                if (all || look.kind == kind) cell(ui, picture, look, kind, height);
    };
    if (!lines) return line(pictures);
    for (std::size_t i = 0; i < pictures.size(); ++i) line(pictures.subspan(i, 1));
}

}  // namespace lapfx::panels
