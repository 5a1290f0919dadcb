// The reference: the surgery video that is to be matched, alone or against the preview.
#include "app/measure/measuring.h"
#include "app/reference/plate.h"
#include "app/reference/reference.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "app/base/file_filters.h"
#include "app/files/files.h"
#include "app/files/open.h"
#include "app/preview/pick_color.h"
#include "panels/compared_scopes.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/placement.h"
#include "panels/reference_notes.h"
#include "panels/region_shapes.h"
#include "ui/canvas/image_view.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/splitter.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using app::CompareWay;
using app::Reference;
using app::ReferenceComparison;

constexpr float low_panel = 14, least_pictures = 5, low_scopes = 18;                                     // em of height
constexpr float ways_width = 27, list_width = 8, number_width = 9, aspect_width = 7, offset_width = 10;  // em
constexpr float side_width = 8;                                                                          // em
constexpr const auto& ways = app::way_titles;

/// A video becomes the reference; a scene, a preset or an organ is opened, as anywhere in the window.
void take_dropped(app::Files& opens, std::string_view paths) {
    const std::vector<std::string> files = dropped_files(paths);
    if (files.empty()) return;
    const std::filesystem::path first = files.front();
    if (app::is_organ_name(first) || app::is_document_name(first)) return opens.bring(files);
    opens.bring_reference(files.front());  // the panel says so if it is no video
}

void accept_drops(ui::Ui& ui, app::Files& files) {
    ui::Node& panel = ui.parent();
    panel.sense = panel.sense | ui::Sense::drop;
    ui.events_of(panel.id, [&](const ui::Event& event) {
        if (event.kind == ui::EventKind::drop) take_dropped(files, event.paths);
    });
}

/// In the middle of the panel, of a width that reads well.
class Notice {
  public:
    explicit Notice(ui::Ui& ui)
        : ground_(ui, {.width = ui::grow(),
                       .height = ui::grow(),
                       .cross = ui::ChildAlign::center,
                       .main = ui::ChildAlign::center}),
          text_(ui, {.width = ui::px(ui.em(30)), .gap = 0.5F, .cross = ui::ChildAlign::center}) {}

  private:
    ui::Column ground_, text_;
};

void invite(ui::Ui& ui, Reference& reference, app::FileChooser& chooser) {
    const Notice notice(ui);
    ui::label(ui, "The video to match", {.size = 1.25F, .weight = ui::Weight::bold});
    ui::space(ui, 0.2F);
    ui::label(ui, "Drop a surgery video or numbered images here, or open them.", {.tone = ui::Tone::dim});
    ui::label(ui, "It follows the timeline; its offset aligns it with the scene.", {.tone = ui::Tone::dim});
    ui::label(ui, "M changes how it is compared with the preview.", {.tone = ui::Tone::dim});
    ui::space(ui, 0.4F);
    if (const std::size_t slot = reference.comparison().first_kept(); slot < app::Snapshots::count) {
        if (ui::button(ui, ui.join({"Preview next to snapshot ", app::Snapshots::names[slot]}),
                       {.tip = "Snapshots are compared without a video, too", .quiet = true}))
            reference.comparison().show({app::CompareSide::preview, app::side_of(slot)});
    }
    const ui::Row buttons(ui);
    if (ui::button(ui, "Open...", {.icon = ui::Icon::folder, .tip = "Opens a video or images", .primary = true}))
        ask_for_video(reference, chooser);
    if (ui::button(ui, "Sample reference",
                   {.tip = "A video that comes with lapfx, of another operation than the sample scene's"}))
        reference.choose_sample();
}

void ways_out(ui::Ui& ui, Reference& reference, app::FileChooser& chooser) {
    const ui::Row buttons(ui);
    if (ui::button(ui, "Choose another file...",
                   {.icon = ui::Icon::folder, .tip = "Use another video as the reference"}))
        ask_for_video(reference, chooser);
    if (ui::button(ui, "Remove", {.tip = "The scene then has no reference", .quiet = true})) reference.remove();
}

void tell_faults(ui::Ui& ui, Reference& reference, app::FileChooser& chooser, const std::vector<Fault>& faults) {
    const Notice notice(ui);
    ui::label(ui, "This reference cannot be shown", {.size = 1.25F, .weight = ui::Weight::bold});
    for (const Fault& fault : faults)
        ui::label(ui, fault.text(), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    ui::space(ui, 0.4F);
    ways_out(ui, reference, chooser);
}

/// Another reference was chosen and cannot be opened: the former one stays.
void warn_of_refused(ui::Ui& ui, Reference& reference, app::FileChooser& chooser) {
    if (reference.refused().empty()) return;
    ui::label(ui, reference.refused().front().text(), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    const ui::Row buttons(ui);
    if (ui::button(ui, "Choose another file...",
                   {.icon = ui::Icon::folder, .tip = "Use another video as the reference"}))
        ask_for_video(reference, chooser);
    if (ui::button(ui, "Keep this reference", {.tip = "Keeps the one that is shown", .quiet = true}))
        reference.forget_refused();
}

/// The last frame is still there.
void warn_of_faults(ui::Ui& ui, Reference& reference, app::FileChooser& chooser) {
    if (reference.faults().empty() || !reference.refused().empty()) return;
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::label(ui, reference.faults().front().text(), {.tone = ui::Tone::warning, .width = ui::grow()});
    ways_out(ui, reference, chooser);
}

struct Aspect {
    std::string_view name;
    double ratio;
};
constexpr std::array<Aspect, 3> aspects = {{{"As stored", 0}, {"4:3", 4.0 / 3}, {"16:9", 16.0 / 9}}};

/// Videos are often stored squeezed without saying so. An unusual aspect of the scene is also in the list.
void aspect_choice(ui::Ui& ui, document::Document& document) {
    const double now = document.scene().reference.aspect;
    std::array<std::string_view, aspects.size() + 1> names;
    int chosen = -1;
    for (std::size_t i = 0; i < aspects.size(); ++i) {
        names[i] = aspects[i].name;
        if (std::abs(aspects[i].ratio - now) < 1e-3) chosen = static_cast<int>(i);
    }
    char own[32];
    std::snprintf(own, sizeof own, "%.4g:1", now);
    names.back() = own;
    const std::size_t count = chosen < 0 ? names.size() : aspects.size();
    if (chosen < 0) chosen = static_cast<int>(aspects.size());
    const ui::Edit edit = ui::combo(ui, "Aspect", chosen, std::span(names).first(count),
                                    {.tip = "Width over height at which the reference is shown, for a video that is "
                                            "stored squeezed, as 4:3 in 256 x 256",
                                     .width = ui::px(ui.em(aspect_width))});
    if (static_cast<std::size_t>(chosen) >= aspects.size()) return;
    const double ratio = std::round(aspects[static_cast<std::size_t>(chosen)].ratio * 1e4) / 1e4;
    document.take(edit, "Reference aspect", [&](document::Content& c) { c.scene.reference.aspect = ratio; });
}

/// The choice of how to compare: buttons if `in_a_row`, else a list.
void choose_way(ui::Ui& ui, ReferenceComparison& comparison, bool in_a_row) {
    int way = static_cast<int>(comparison.way);
    bool chosen = false;
    if (in_a_row) {
        const Room room(ui, ways_width);
        chosen = ui::segmented(ui, "Compare", way, ways).changed;
    } else {
        chosen = ui::combo(ui, "Compare", way, ways,
                           {.tip = "How the reference and the preview are shown together",
                            .width = ui::px(ui.em(list_width))})
                     .changed;
    }
    if (chosen) comparison.way = static_cast<CompareWay>(way);
}

void gain_field(ui::Ui& ui, ReferenceComparison& comparison) {
    ui::number_field(ui, "Gain", comparison.state.gain,
                     {.minimum = 1,
                      .maximum = 100,
                      .hard_minimum = 1,
                      .hard_maximum = 100,
                      .scale = ui::ValueScale::logarithmic,
                      .standard = 4.0,
                      .tip = "Multiplies the difference, so that small differences become visible",
                      .width = ui::px(ui.em(number_width))});
}

void mix_field(ui::Ui& ui, ReferenceComparison& comparison) {
    ui::ParamOptions options = ui::percent();
    options.hard_minimum = 0, options.hard_maximum = 100;
    options.standard = 50.0, options.tip = "Share of the second picture", options.width = ui::px(ui.em(number_width));
    ui::number_field(ui, "Mix", comparison.state.mix, options);
}

void plate_toggle(ui::Ui& ui, const app::ReferenceLook& look, document::Document& document) {
    bool on = document.scene().plate.use;
    const bool coming = look.plate_progress().has_value();
    ui.push_disabled(coming);  // a second click would take it away: its progress has a button for that
    if (ui::toggle(ui, "Plate", on,
                   {.tip = coming ? "The plate is being made; the cross beside its progress ends that"
                                  : "A clear frame of the reference in place of the organ: then both pictures show the "
                                    "same tissue, and what differs is smoke and blood"}))
        app::show_plate(document, on);
    ui.pop_disabled();
}

/// What lies on the first or the second side.
void side_choice(ui::Ui& ui, ReferenceComparison& comparison, std::size_t side) {
    int chosen = static_cast<int>(comparison.sides[side]);
    if (ui::combo(ui, side == 0 ? "First picture" : "Second picture", chosen, app::side_titles,
                  {.tip = side == 0 ? "What is compared: the preset as it is, the video, or a snapshot"
                                    : "What it is compared with. The one that is on the other side changes places",
                   .width = ui::px(ui.em(side_width))}))
        comparison.put(side, static_cast<app::CompareSide>(chosen));
}

/// `room`: px.
void way_of_comparing(ui::Ui& ui, Reference& reference, const Edited& edited, ui::CommandTable& commands, float room) {
    ReferenceComparison& comparison = reference.comparison();
    app::FileChooser& chooser = edited.chooser;
    const bool two = comparison.way != CompareWay::reference;
    const bool gain = comparison.way == CompareWay::difference, mix = comparison.way == CompareWay::onion;
    const bool video = reference.video() != nullptr;
    const std::string name = reference.file().filename().string();
    const bool in_a_row = room == 0 || room >= ui.em(ways_width + number_width + aspect_width + 2 * side_width + 8);
    enum : std::size_t { compare, first, second, number, swap, scopes, plate, aspect, measure, title, open, count };
    std::array<ui::ToolItem, count> items;
    items[compare] = {.width = ui.em(in_a_row ? ways_width : list_width)};
    items[first] = items[second] = {.width = two ? ui.em(side_width) : 0, .rank = 1};
    items[number] = {.width = gain || mix ? ui.em(number_width) : 0, .rank = 1};
    items[swap] = {.width = two ? ui::tool_width(ui, "Swap") : 0, .rank = 2};
    items[scopes] = {.width = ui::tool_width(ui, "Scopes"), .rank = 2};
    items[plate] = {.width = video ? ui::tool_width(ui, "Plate") : 0, .rank = 2};
    items[aspect] = {.width = video ? ui.em(aspect_width) : 0, .rank = 3};
    items[measure] = {.width = video ? ui::tool_width(ui, "Measure...") : 0, .rank = 4};
    items[title] = {.width = video ? std::min(ui.text_width(name), ui.em(14)) : 0, .rank = 5, .end = true};
    items[open] = {.width = ui.row_height(), .rank = 4};
    ui::toolbar(ui, "Compare tools", room, items, [&](std::size_t item) {
        if (item == compare) choose_way(ui, comparison, in_a_row);
        if (item == first) side_choice(ui, comparison, 0);
        if (item == second) side_choice(ui, comparison, 1);
        if (item == number && gain) gain_field(ui, comparison);
        if (item == number && mix) mix_field(ui, comparison);
        if (item == swap)
            ui::toggle(
                ui, "Swap", comparison.state.swapped,
                {.tip = "Swaps the two pictures (X over the picture). Hold F over it to see the second one alone"});
        if (item == scopes)
            ui::toggle(ui, "Scopes", comparison.scopes_look.on,
                       {.tip = "Levels, waveform and colours of both pictures, next to each other"});
        if (item == plate) plate_toggle(ui, reference.look(), edited.document);
        if (item == aspect) aspect_choice(ui, edited.document);
        if (item == measure &&
            ui::button(ui, "Measure...", {.tip = "Shows the Measure panel: how much blood and smoke there is"}))
            commands.run("window.show_measure");
        if (item == title) {
            ui::label(ui, name, {.tone = ui::Tone::dim, .width = ui::px(items[title].width)});
            ui.last().tip = ui.copy(reference.file().string());
        }
        if (item == open && ui::icon_button(ui, ui::Icon::folder, "Open reference video", {.quiet = true}))
            ask_for_video(reference, chooser);
    });
}

void frame_field(ui::Ui& ui, Reference& reference) {
    const int last = reference.video()->info().frames - 1;
    double frame = reference.frame();
    if (ui::number_field(ui, "Frame", frame,
                         {.maximum = static_cast<double>(std::max(last, 1)),
                          .hard_minimum = 0,
                          .hard_maximum = static_cast<double>(last),
                          .step = 1,
                          .tip = "Frame of the reference. A frame set here is held, whatever the timeline does",
                          .integer = true,
                          .width = ui::px(ui.em(number_width))}))
        reference.hold(static_cast<int>(frame));
}

void offset_field(ui::Ui& ui, const Edited& edited) {
    double offset = edited.document.scene().reference.offset;
    const ui::Edit edit = ui::number_field(ui, "Offset", offset,
                                           ui::seconds({.minimum = -10,
                                                        .maximum = 10,
                                                        .hard_minimum = -86'400,
                                                        .hard_maximum = 86'400,
                                                        .step = 0.01,
                                                        .unit = "s",
                                                        .standard = edited.saved.content().scene.reference.offset,
                                                        .initial = SceneReference{}.offset,
                                                        .tip = "Time in the reference when the scene starts",
                                                        .width = ui::px(ui.em(offset_width))}));
    edited.document.take(edit, "Reference offset", [&](document::Content& c) { c.scene.reference.offset = offset; });
}

void align_button(ui::Ui& ui, Reference& reference) {
    ui.push_disabled(!reference.held());
    if (ui::button(ui, "Align start here",
                   {.tip = "Hold a frame of the reference first. It then belongs to the current time of the scene: "
                           "this sets the offset"}))
        reference.align();
    ui.pop_disabled();
}

/// The time that is shown, with a warning where it is not the one that was asked for.
struct PlaceInTime {
    std::string_view warning, text;
};
PlaceInTime place_in_time(ui::Ui& ui, const Reference& reference) {
    char text[64];
    const double time = reference.time(), duration = reference.video()->info().duration;
    std::snprintf(text, sizeof text, "%.2f of %.2f s", time, duration);
    const std::string_view warning = time < 0                                ? "Before its start"
                                     : time >= duration && !reference.held() ? "After its end"
                                     : !reference.good()                     ? "Frame missing: the one before is shown"
                                     : reference.shown().shows_counted && !reference.shown().counted_shown()
                                         ? "Not measured yet"
                                         : "";
    return {warning, ui.copy(text)};
}

/// `room`: px. Only with a video.
void time_row(ui::Ui& ui, Reference& reference, const Edited& edited, ui::CommandTable& commands, float room) {
    ReferenceComparison& comparison = reference.comparison();
    if (reference.video() == nullptr) return;
    const PlaceInTime place = place_in_time(ui, reference);
    enum : std::size_t { before, frame, after, hold, align, offset, counted, look, places, warning, text, count };
    std::array<ui::ToolItem, count> items;
    items[before] = items[after] = {.width = ui.row_height()};
    items[frame] = {.width = ui.em(number_width)};
    items[hold] = {.width = ui::tool_width(ui, "Hold", true), .rank = 1};
    items[align] = {.width = ui::tool_width(ui, "Align start here"), .rank = 3};
    items[offset] = {.width = ui.em(offset_width), .rank = 2};
    items[counted] = {.width = ui::tool_width(ui, "Counted"), .rank = 2};
    items[look] = {.width = ui::tool_width(ui, "Propose look"), .rank = 3};
    const bool two = comparison.way != CompareWay::reference;
    // Once on, it stays in sight as long as anything does: it is switched off here.
    items[places] = {.width = two ? ui::tool_width(ui, "Move reference") : 0, .rank = comparison.placing ? 1 : 3};
    items[warning] = {.width = place.warning.empty() ? 0 : ui.text_width(place.warning), .rank = 2, .end = true};
    items[text] = {.width = ui.text_width(place.text) + ui.em(1), .rank = 4, .end = true};
    ui::toolbar(ui, "Reference time tools", room, items, [&](std::size_t item) {
        if (item == before &&
            ui::icon_button(ui, ui::Icon::step_back, "Frame before",
                            {.tip = "Moves only the reference back by a frame and holds it there", .quiet = true}))
            reference.step(-1);
        if (item == frame) frame_field(ui, reference);
        if (item == after &&
            ui::icon_button(ui, ui::Icon::step_forward, "Frame after",
                            {.tip = "Moves only the reference on by a frame and holds it there", .quiet = true}))
            reference.step(1);
        if (item == hold) hold_toggle(ui, reference);
        if (item == align) align_button(ui, reference);
        if (item == offset) offset_field(ui, edited);
        if (item == counted)
            ui::toggle(
                ui, "Counted", reference.shown().shows_counted,
                {.tip = "Draws over the reference what was measured in it, as it plays: blood yellow, smoke blue, "
                        "what is left out hatched"});
        if (item == look) ui::command_button(ui, commands, "reference.propose_look");
        if (item == places)
            ui::toggle(ui, "Move reference", comparison.placing,
                       {.tip = "Moves, scales and turns the reference until the same tissue lies at the same place in "
                               "both pictures: by handles, by numbers, or by the endoscope's circle"});
        if (item == warning) ui::label(ui, place.warning, {.tone = ui::Tone::warning});
        if (item == text) {
            ui::label(ui, place.text, {.tone = ui::Tone::dim, .number = true});
            if (!reference.video()->info().warning.empty()) ui.last().tip = ui.copy(reference.video()->info().warning);
        }
    });
    if (comparison.placing && two) placement_row(ui, edited, commands, room);
}

/// The preview is to show it at the same place, as the scene's camera sees it.
void take_color(const Edited& edited, const ReferenceComparison& comparison, const ui::Picture& picture,
                glm::ivec2 at) {
    edited.eyedropper.picked = app::color_around(*picture.pixels, picture.size, at);
    edited.seen.clicked({.shot = comparison.shot(),
                         .size = comparison.size(),
                         .place = (glm::dvec2(at) + 0.5) / glm::dvec2(picture.size)});
}

/// Takes it from the picture that is seen at that place; where both are mixed, from the second.
void take_color(const Edited& edited, const ReferenceComparison& comparison, const ui::CompareResult& result,
                const ui::Picture& first, const ui::Picture& second) {
    const bool mixed = comparison.way == CompareWay::onion || comparison.way == CompareWay::difference;
    const ui::Picture& picture = (mixed && !result.flicker) || result.under == 1 ? second : first;
    if (picture.pixels == nullptr) return;
    take_color(edited, comparison, picture, result.pick);
}

void tell_empty(ui::Ui& ui, std::size_t slot) {
    const std::string_view letter = app::Snapshots::names[slot];
    const Notice notice(ui);
    ui::label(ui, ui.join({"Snapshot ", letter, " is empty"}), {.size = 1.25F, .weight = ui::Weight::bold});
    ui::label(ui, ui.join({"Shift+", letter, " keeps the preset there as it is now."}), {.tone = ui::Tone::dim});
}

void compared(ui::Ui& ui, ReferenceComparison& comparison, const Edited& edited, const ui::Rect& keep_off) {
    ui::Eyedropper& eyedropper = edited.eyedropper;
    constexpr std::array kinds = {ui::CompareKind::side_by_side, ui::CompareKind::side_by_side, ui::CompareKind::wipe,
                                  ui::CompareKind::difference, ui::CompareKind::onion};
    comparison.state.kind = kinds[static_cast<std::size_t>(comparison.way)];
    // The comparison takes letters before any command.
    ui.events_of(ui.id_of("Comparison"), [&](const ui::Event& event) {
        if (event.kind == ui::EventKind::key && event.key == ui::key_of('M') && !event.repeat) comparison.next_way();
    });
    const bool picks = eyedropper.wanted_by != 0;
    const auto [one, other] = comparison.sides;
    const ui::Picture first = comparison.picture(one), second = comparison.picture(other);
    RegionShapes regions{comparison.scopes_look, edited};
    PlacementHandles handles{edited};
    const bool places = comparison.placing && comparison.compares_video() && !picks;
    const bool shapes = comparison.scopes_look.shows_regions() && !picks && !places;
    const ui::CompareResult result =
        ui::compare_view(ui, "Comparison", first, second, comparison.state,
                         {.first_label = app::side_titles[static_cast<std::size_t>(one)],
                          .second_label = app::side_titles[static_cast<std::size_t>(other)],
                          .magnifier = picks,
                          .eyedropper = picks,
                          .sample_box = picks ? app::picked_side : 1,
                          .over = places   ? PlacementHandles::build
                                  : shapes ? RegionShapes::build
                                           : nullptr,
                          .over_with = places ? static_cast<void*>(&handles) : &regions,
                          .keep_off = keep_off,
                          .tip = "Wheel: zoom. Hold F: the second alone. X: swap. M: next way of comparing"});
    if (result.picked) take_color(edited, comparison, result, first, second);
    if (comparison.show_at(result.zoom) || result.picked) ui.build_again();
}

/// `keep_off`: what lies over them.
void pictures(ui::Ui& ui, Reference& reference, const Edited& edited, const ui::Rect& keep_off) {
    ReferenceComparison& comparison = reference.comparison();
    ui::Eyedropper& eyedropper = edited.eyedropper;
    const bool alone = comparison.way == CompareWay::reference;
    if ((alone || comparison.compares_video()) && reference.shown().whole().image == 0) {
        const Notice notice(ui);
        ui::label(ui, "Decoding...", {.tone = ui::Tone::dim});
        return;
    }
    if (const std::size_t slot = comparison.empty_side(); !alone && slot < app::Snapshots::count)
        return tell_empty(ui, slot);
    if (!alone) return compared(ui, comparison, edited, keep_off);
    const bool picks = eyedropper.wanted_by != 0;
    const ui::Picture video = reference.shown().whole();
    RegionShapes regions{comparison.scopes_look, edited};
    const bool shapes = comparison.scopes_look.shows_regions() && !picks;
    const ui::ImageViewResult result =
        ui::image_view(ui, "Video", video, comparison.state.view,
                       {.magnifier = picks,
                        .eyedropper = picks,
                        .sample_box = picks ? app::picked_side : 1,
                        .over = shapes ? RegionShapes::build : nullptr,
                        .over_with = &regions,
                        .keep_off = keep_off,
                        .tip = "Wheel: zoom. 0: whole picture. 1: pixel by pixel. M: next way of comparing"});
    if (!result.picked) return;
    take_color(edited, comparison, video, result.pick);
    ui.build_again();
}

/// The pictures and, where they are wanted, their scopes below. `room`: px.
void pictures_and_scopes(ui::Ui& ui, Reference& reference, const Edited& edited, glm::vec2 room) {
    app::ScopesLook& look = reference.comparison().scopes_look;
    const ui::Rect keep_off = pick_hint_rect(ui, edited.eyedropper);
    if (!look.on) return pictures(ui, reference, edited, keep_off);
    ui::Splitter split(ui, "Pictures and scopes", ui::Axis::y, look.pictures,
                       {.first_minimum = least_pictures, .second_minimum = 8, .standard = app::ScopesLook{}.pictures});
    {
        const ui::Column upper(ui, {.width = ui::grow(), .height = ui::grow()});
        pictures(ui, reference, edited, keep_off);
    }
    split.next();
    compared_scopes(ui, reference, edited, {room.x, (1 - look.pictures) * room.y});
}

/// In a low panel the pictures have nearly all the room, and one scrolls to the tools of time.
void low(ui::Ui& ui, Reference& reference, const Edited& edited, ui::CommandTable& commands, float room) {
    ui::ScrollArea area(ui, "Compared", {.gap = 0.3F});
    {
        const float height = std::max(area.state().view.y - ui.em(0.3F), ui.em(least_pictures));
        const ui::Column held(ui, {.width = ui::grow(), .height = ui::px(height)});
        pictures(ui, reference, edited, pick_hint_rect(ui, edited.eyedropper));
        pick_hint(ui, edited.eyedropper);
    }
    time_row(ui, reference, edited, commands, std::max(1.0F, room - ui.em(1)));
    if (reference.comparison().scopes_look.on) {
        const ui::Column held(ui, {.width = ui::grow(), .height = ui::px(ui.em(low_scopes))});
        compared_scopes(ui, reference, edited, {std::max(1.0F, room - ui.em(1)), ui.em(low_scopes)});
    }
    warn_of_refused(ui, reference, edited.chooser);
    warn_of_faults(ui, reference, edited.chooser);
    reference_notes(ui, reference.look(), edited, commands);
}

void without_video(ui::Ui& ui, Reference& reference, app::FileChooser& chooser) {
    if (reference.opening()) {
        const Notice notice(ui);
        return ui::label(ui, ui.join({"Opening ", reference.opens().filename().string(), "..."}),
                         {.tone = ui::Tone::dim});
    }
    if (!reference.refused().empty()) return tell_faults(ui, reference, chooser, reference.refused());
    reference.named() ? tell_faults(ui, reference, chooser, reference.faults()) : invite(ui, reference, chooser);
}

}  // namespace

void hold_toggle(ui::Ui& ui, Reference& reference) {
    bool held = reference.held();
    if (ui::toggle(ui, "Hold", held,
                   {.icon = ui::Icon::lock, .tip = "Stays at this frame while the timeline moves on"}))
        held ? reference.hold(reference.frame()) : reference.let_go();
}

void ask_for_video(Reference& reference, app::FileChooser& chooser) {
    const std::filesystem::path now = reference.file();
    chooser.ask(
        {.title = "Open reference video", .folder = now.parent_path().string(), .filters = app::clip_filters("Videos")},
        [&reference](const std::vector<std::string>& files) { reference.choose(files.front()); });
}

void reference_panel(ui::Ui& ui, Reference& reference, app::Measuring& measuring, const Edited& edited,
                     app::Files& files, ui::CommandTable& commands) {
    ReferenceComparison& comparison = reference.comparison();
    accept_drops(ui, files);
    reference.follow();
    if (reference.shown().shows_counted) {
        measuring.want();
        if (measuring.due() < ui::never) ui.wake_at(measuring.due(), "the reference is being measured");
    }
    if (reference.video() == nullptr) {
        if (comparison.compares_video()) return without_video(ui, reference, edited.chooser);
        if (comparison.way == CompareWay::reference) comparison.way = CompareWay::beside;  // there is nothing else
    }
    const ui::Rect panel = ui.rect_before(ui.parent().id);
    const float room = panel.w > 0 ? std::max(1.0F, panel.w - 2 * ui.em(0.6F)) : 0.0F;
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow()});
    way_of_comparing(ui, reference, edited, commands, room);
    if (panel.h > 0 && panel.h < ui.em(low_panel)) return low(ui, reference, edited, commands, room);
    time_row(ui, reference, edited, commands, room);
    warn_of_refused(ui, reference, edited.chooser);
    warn_of_faults(ui, reference, edited.chooser);
    reference_notes(ui, reference.look(), edited, commands);
    pictures_and_scopes(ui, reference, edited, {room, panel.h - 2 * ui.row_height() - ui.em(1.6F)});
    pick_hint(ui, edited.eyedropper);
}

/// One for each mark, Alt with its number.

}  // namespace lapfx::panels
