#include "panels/randomise.h"

#include <algorithm>
#include <cmath>

#include "document/words.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/field.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/param.h"

namespace lapfx::panels {

namespace {

constexpr std::string_view box_name = "randomise";
constexpr float box_width = 22;  // em
constexpr double most_seed = 1e9;
constexpr std::size_t most_named = 6;  // of the values that were changed

/// What the box was opened for.
const app::ParameterGroup*& asked_for(ui::Ui& ui) {
    return ui.memory<const app::ParameterGroup*>(ui::hash_bytes(0, "randomise group"));
}

/// "14 values changed by up to 10 % (seed 7): Speed, Level extent, Noise scale and 11 more".
std::string told(const app::Tuning& tuning, std::uint64_t seed, const std::vector<document::Difference>& changed) {
    const auto percent = static_cast<int>(std::lround(100 * tuning.strength));
    std::string text = std::to_string(changed.size()) + (changed.size() == 1 ? " value" : " values") +
                       " changed by up to " + std::to_string(percent) + " % (seed " + std::to_string(seed) + "): ";
    for (std::size_t i = 0; i < std::min(changed.size(), most_named); ++i) text += (i > 0 ? ", " : "") + changed[i].row;
    if (changed.size() > most_named) text += " and " + std::to_string(changed.size() - most_named) + " more";
    return text;
}

void take_back(document::Document& d, ui::Toasts& toasts, std::uint64_t step) {
    if (d.done() > 0 && d.steps()[d.done() - 1].id == step) return d.undo();
    const bool done = std::any_of(d.steps().begin(), d.steps().begin() + static_cast<std::ptrdiff_t>(d.done()),
                                  [&](const document::Step& s) { return s.id == step; });
    toasts.add({.kind = ui::ToastKind::warning,
                .text = done ? "Not undone: other changes were made after it. The History panel can go back to it"
                             : "It has been undone already"});
}

}  // namespace

void randomise(app::Tuning& tuning, document::Document& document, ui::Toasts& toasts,
               const app::ParameterGroup* group) {
    const Preset before = document.preset();
    const std::uint64_t seed = tuning.seed;
    if (tuning.randomise(group) == 0) {
        toasts.add({.kind = ui::ToastKind::warning, .text = "Nothing to randomise: everything is locked"});
        return;
    }
    const std::uint64_t step = document.steps()[document.done() - 1].id;
    toasts.add({.text = told(tuning, seed, document::differences(before, document.preset())),
                .action = "Undo",
                .act = [&document, &toasts, step] { take_back(document, toasts, step); },
                .seconds = 8});
}

void open_randomise_box(ui::Ui& ui, const app::ParameterGroup* group, ui::Id anchor) {
    asked_for(ui) = group;
    ui.open_overlay(box_name, ui::OverlayKind::popup, {.side = ui::Placement::Side::below, .anchor = anchor});
}

void randomise_box(ui::Ui& ui, app::Tuning& tuning, document::Document& document, ui::Toasts& toasts) {
    ui::Node* const box = ui.open_overlay_node(box_name, ui::Role::dialog, "Randomise box", ui::Axis::y);
    if (box == nullptr) return;
    box->size[0] = ui::px(std::min(ui.em(box_width), ui.window().x));
    box->gap = ui.em(ui.theme().gap);
    for (std::uint8_t& pad : box->padding) pad = static_cast<std::uint8_t>(std::min(ui.em(ui.theme().padding), 255.0F));
    ui.draw_with<ui::draw_popup>(*box, true);
    ui::ParamOptions strength = ui::percent({.minimum = 1, .maximum = 100, .step = 1});
    strength.hard_minimum = 1, strength.hard_maximum = 100;
    strength.standard = 100 * app::Tuning::standard_strength;
    strength.tip =
        "How far each value may move from its current value, as a part of its range (the range set in its menu, or the "
        "full one). At 100 % choices and switches change, too";
    ui::param(ui, "Strength", tuning.strength, strength);
    auto seed = static_cast<double>(tuning.seed);
    const ui::ParamOptions seeds{
        .minimum = 1,
        .maximum = 1000,
        .hard_minimum = 1,
        .hard_maximum = most_seed,
        .step = 1,
        .tip = "The same seed, values and strength give the same result; the seed rises by one each time",
        .integer = true};
    if (ui::param(ui, "Seed", seed, seeds).changed) tuning.seed = static_cast<std::uint64_t>(seed);
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::label(ui, "Everything that is not locked", {.tone = ui::Tone::dim, .width = ui::grow()});
    const app::ParameterGroup* const group = asked_for(ui);
    const std::string_view whose = group == nullptr ? std::string_view("all") : group->name;
    if (ui::button(
            ui, ui.join({"Randomise ", whose}),
            {.icon = ui::Icon::dice, .tip = "In one undo step; the box stays open for another try", .primary = true}))
        randomise(tuning, document, toasts, group);
    ui.close_overlay_node();
}

}  // namespace lapfx::panels
