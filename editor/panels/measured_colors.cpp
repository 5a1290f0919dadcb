#include "panels/measured_colors.h"

#include <algorithm>
#include <array>

#include "app/measure/measuring.h"
#include "app/measure/preview_measuring.h"
#include "app/tuning/key_titles.h"
#include "document/document.h"
#include "match/compare/color_likeness.h"
#include "match/video/peak_colors.h"
#include "panels/measured_words.h"
#include "ui/canvas/axis.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

namespace {

using match::ColorLikeness;
using match::MeasuredColors;

struct ColorLine {
    const char *name, *where;
    std::optional<double> ColorLikeness::*apart;
    std::optional<glm::dvec3> MeasuredColors::*color;
    const char* key;  ///< of what mends it
};
constexpr std::array<ColorLine, 3> parts = {{
    {"blood", "of all frames that show it", &ColorLikeness::blood, &MeasuredColors::blood, "bleeding.color_thin"},
    {"smoke", "where the veil is densest", &ColorLikeness::smoke, &MeasuredColors::smoke, "smoke.haze.color"},
    {"tissue", "of the baselines", &ColorLikeness::tissue, &MeasuredColors::tissue, exposure_key},
}};

/// Of what is measured now.
struct Colors {
    std::uint64_t of_preview = 0, of_reference = 0, of_document = 0;
    MeasuredColors preview, reference;
    ColorLikeness likeness;
};

/// At the times that both have.
void compare(Colors& colors, const AmountsParts& on) {
    const double offset = on.document.scene().reference.offset;
    const auto reference = on.measuring.frames();
    colors.preview = colors.reference = {};
    if (!reference.empty()) {
        const double from = std::max(0.0, reference.front().time - offset);
        const double to = std::min(on.document.scene().duration, reference.back().time - offset);
        colors.preview = on.preview.colors()->at_peak(from, to).colors;
        colors.reference = on.measuring.colors()->at_peak(from + offset, to + offset).colors;
    }
    colors.likeness = match::likeness_of(colors.preview, colors.reference);
}

const Colors& colors_of(ui::Ui& ui, const AmountsParts& on) {
    Colors& colors = ui.memory<Colors>(ui.id_of("measured colours"));
    if (colors.of_preview == on.preview.version() && colors.of_reference == on.measuring.version() &&
        colors.of_document == on.document.version())
        return colors;
    colors.of_preview = on.preview.version(), colors.of_reference = on.measuring.version();
    colors.of_document = on.document.version();
    compare(colors, on);
    return colors;
}

/// "smoke unknown": why.
void unknown(ui::Ui& ui, const Colors& colors, const ColorLine& part, std::string_view end) {
    const bool theirs = !(colors.reference.*part.color);
    ui::label(ui, ui.join({part.name, " unknown", end}), {.tone = ui::Tone::dim});
    ui.last().tip =
        ui.join({theirs ? "The reference" : "The preview", " shows too little ", part.name, " to tell its colour"});
}

void known(ui::Ui& ui, const AmountsParts& on, const ColorLine& part, double apart, std::string_view end) {
    ui::ShortText text;
    text.add(part.name).add(" ").add(apart, 1).add(end);
    const bool clicked = ui::button(
        ui, ui.join({text.view(), "###", part.name}),
        {.tip = ui.join(
             {"How far the colour of ", part.name, " is from the reference's, ", part.where,
              ": CIE Delta E 2000. About 1 is just noticeable. Goes to what mends it: ", app::title_of(part.key)}),
         .quiet = true});
    ui.last().rigid = false;
    if (clicked) go_to_what_mends(ui, on, part.key);
}

}  // namespace

void measured_colors(ui::Ui& ui, const AmountsParts& on) {
    if (on.preview.colors() == nullptr || on.measuring.colors() == nullptr) return;
    const Colors& colors = colors_of(ui, on);
    ui::Node& line = ui.open(ui::Role::group, "Colours", ui::Axis::x);
    line.size[0] = ui::grow();
    line.cross = ui::ChildAlign::center;
    line.gap = ui.em(0.3F);
    ui::label(ui, "Colours:", {.tone = ui::Tone::dim});
    for (const ColorLine& part : parts) {
        const std::string_view end = &part == &parts.back() ? "" : ",";
        if (const std::optional<double>& apart = colors.likeness.*part.apart)
            known(ui, on, part, *apart, end);
        else
            unknown(ui, colors, part, end);
    }
    ui::label(ui, "Delta E", {.tone = ui::Tone::dim});
    ui.close();
}

}  // namespace lapfx::panels
