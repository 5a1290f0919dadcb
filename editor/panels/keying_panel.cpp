// The keying bench: a frame of the selected clip on its way to smoke, and the thresholds beside what they do:
// as handles on a histogram and a vectorscope, as numbers, by eyedropper, by suggestion.
#include "app/clips/keying_bench.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lapfx/authoring/clip.h"
#include "lapfx/authoring/keying.h"
#include "panels/clip_parameters.h"
#include "panels/clip_shapes.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/table_rows.h"
#include "ui/canvas/histogram.h"
#include "ui/core/node.h"
#include "ui/shell/progress.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/splitter.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using app::BenchView;
using app::KeyingBench;
using document::Content;
using ui::Icon;

constexpr std::array<std::string_view, app::bench_views> captions = {"Source picture", "Matte: the opacity",
                                                                     "Keyed: the smoke alone", "Composite: laid over"};
constexpr std::array<std::string_view, app::bench_views> view_tips = {
    "The clip's frame as it is", "The smoke's opacity: white is fully smoke",
    "The smoke alone, in its own colour, without what was behind it",
    "The smoke over the background that is chosen above, in the preset's colour, at density 1 and without noise"};

constexpr float clip_time_width = 9;  // em
constexpr float low_bench = 36;       // em: a panel of less height has no room for pictures and thresholds
constexpr float least_pictures = 7;   // em

/// What the panel works on.
struct On {
    KeyingBench& bench;
    app::ClipShelf& shelf;
    const Edited& edited;
    ui::CommandTable& commands;

    document::Document& document() const { return edited.document; }
    const ClipReport& report() const { return shelf.of(shelf.selected).report; }
    bool has_alpha() const { return report().alpha; }
};

// --- above the pictures ----------------------------------------------------------------------------------------------

void clip_choice(ui::Ui& ui, const On& on, ui::Size width) {
    const auto& clips = on.document().preset().smoke.clips;
    std::array<std::string_view, 64> names;
    const std::size_t count = std::min(clips.size(), names.size());
    for (std::size_t i = 0; i < count; ++i)
        names[i] = ui.copy(std::to_string(i + 1) + "  " + std::filesystem::path(clips[i].file).filename().string());
    int chosen = static_cast<int>(on.shelf.selected);
    if (ui::combo(ui, "Clip", chosen, {names.data(), count},
                  {.tip = "The clip that is shown; it can also be chosen in the list of clips", .width = width}))
        on.shelf.selected = static_cast<std::size_t>(std::max(chosen, 0));
}

/// One of a few: side by side, or a list where there is too little room.
ui::Edit choice(ui::Ui& ui, std::string_view name, int& chosen, std::span<const std::string_view> names, float ems,
                bool list) {
    if (list) return ui::combo(ui, name, chosen, names, {.width = ui::px(ui.em(ems))});
    const Room room(ui, ems);
    return ui::segmented(ui, name, chosen, names);
}

void behind_choice(ui::Ui& ui, KeyingBench& bench, float ems, bool list) {
    int behind = static_cast<int>(bench.look.behind);
    if (choice(ui, "Behind", behind, app::behind_titles, ems, list))
        bench.look.behind = static_cast<app::Behind>(behind);
}

void view_choice(ui::Ui& ui, KeyingBench& bench, float ems, bool list) {
    constexpr auto names = [] {
        std::array<std::string_view, 1 + app::bench_views> all{"All"};
        std::copy(app::view_titles.begin(), app::view_titles.end(), all.begin() + 1);
        return all;
    }();
    int shown = bench.look.grid ? 0 : bench.look.view + 1;
    if (!choice(ui, "Views", shown, names, ems, list)) return;
    bench.look.grid = shown == 0;
    if (shown > 0) bench.look.view = shown - 1;
}

void fit_button(ui::Ui& ui, KeyingBench& bench) {
    if (ui::button(ui, "Fit",
                   {.tip = "Shows the whole picture; 0 does the same, 1 shows it pixel by pixel", .quiet = true}))
        bench.look.state = {};
}

/// `room`: px.
void tools(ui::Ui& ui, const On& on, float room) {
    KeyingBench& bench = on.bench;
    const bool lists = room < ui.em(62);
    const float clip = room < ui.em(34) ? 9 : 14, views = lists ? 8 : 25, behind = lists ? 7 : 19;  // em
    const std::array<ui::ToolItem, 4> items = {
        {{.width = ui.em(clip)},
         {.width = ui.em(views), .rank = 1},
         {.width = ui.em(behind), .rank = 2},
         {.width = bench.look.state.fitted ? 0 : ui::tool_width(ui, "Fit"), .rank = 3, .end = true}}};
    ui::toolbar(ui, "Keying tools", room, items, [&](std::size_t item) {
        if (item == 0) clip_choice(ui, on, ui::px(ui.em(clip)));
        if (item == 1) view_choice(ui, bench, views, lists);
        if (item == 2) behind_choice(ui, bench, behind, lists);
        if (item == 3) fit_button(ui, bench);
    });
}

// --- the pictures ----------------------------------------------------------------------------------------------------

void take_color(const On& on, const glm::vec4& value) {
    const std::size_t number = on.shelf.selected;
    on.document().change("Key colour", [&](Content& c) {
        KeyingBench::keying_of(c, number).key_color = glm::clamp(glm::dvec3(value) / 255.0, 0.0, 1.0);
    });
    on.bench.look.eyedropper = false;
}

std::string_view whole(ui::Ui& ui, float value) {
    return ui.copy(std::to_string(std::lround(value)));
}

/// The text about a pixel, for each view: the values that matter there.
std::string_view source_text(ui::Ui& ui, const glm::vec4& v) {
    return ui.join({"Luma ", whole(ui, luma(glm::vec3(v))), "  red ", whole(ui, v.r), "  green ", whole(ui, v.g),
                    "  blue ", whole(ui, v.b)});
}
std::string_view matte_text(ui::Ui& ui, const glm::vec4& v) {
    return ui.join({"Opacity ", whole(ui, v.r / 2.55F), " %"});
}
std::string_view keyed_text(ui::Ui& ui, const glm::vec4& v) {
    return ui.join({"Opacity ", whole(ui, v.a / 2.55F), " %  red ", whole(ui, v.r), "  green ", whole(ui, v.g),
                    "  blue ", whole(ui, v.b)});
}
std::string_view composite_text(ui::Ui& ui, const glm::vec4& v) {
    return ui.join({"Red ", whole(ui, v.r), "  green ", whole(ui, v.g), "  blue ", whole(ui, v.b)});
}
constexpr std::array pixel_texts = {source_text, matte_text, keyed_text, composite_text};

void one_view(ui::Ui& ui, const On& on, BenchView view) {
    KeyingBench& bench = on.bench;
    const auto index = static_cast<std::size_t>(view);
    const bool picks = view == BenchView::source && bench.look.eyedropper;
    ui.push_seed("view");
    const float room = ui.rect_before(ui.id_of(app::view_titles[index])).w;
    ui.pop_seed();
    constexpr std::string_view asks = "Source picture: click its background";
    const bool narrow = room > 0 && room < ui.text_width(picks ? asks : captions[index]);
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.1F});
    ui::label(ui, picks ? (narrow ? "Click its background" : asks) : (narrow ? app::view_titles : captions)[index],
              {.tone = picks ? ui::Tone::warning : ui::Tone::dim, .size = 0.86F});
    ui.last().tip = view_tips[index];
    ui.push_seed("view");
    ClipShapes shapes{bench, on.edited, on.shelf.selected};
    const ui::ImageViewResult result =
        ui::image_view(ui, app::view_titles[index], bench.picture(view), bench.look.state,
                       {.magnifier = picks,
                        .eyedropper = picks,
                        .sample_box = picks ? bench.look.sample_box : 1,
                        .text_of = pixel_texts[index],
                        .over = view == BenchView::source && !picks ? ClipShapes::build : nullptr,
                        .over_with = &shapes,
                        .tip = view_tips[index]});
    ui.pop_seed();
    if (result.picked) take_color(on, result.value);
}

/// `all`: there is room for the four of them.
void pictures(ui::Ui& ui, const On& on, bool all = true) {
    const KeyingBench& bench = on.bench;
    if (!bench.look.grid || !all) {
        one_view(ui, on, static_cast<BenchView>(std::clamp(bench.look.view, 0, 3)));
        return;
    }
    for (const int line : {0, 2}) {
        const ui::Row row(ui, {.width = ui::grow(), .height = ui::grow(), .cross = ui::ChildAlign::stretch});
        one_view(ui, on, static_cast<BenchView>(line));
        one_view(ui, on, static_cast<BenchView>(line + 1));
    }
}

void step_frame(const On& on, int by) {
    KeyingBench& bench = on.bench;
    if (!bench.ready()) return;  // how many frames there are is not known yet
    const ClipReport& report = on.report();
    bench.look.follow = false;
    const double frame = std::clamp(bench.frame() + by, 0, std::max(bench.frames() - 1, 0));
    // The middle of the frame, so that rounding does not reach another one.
    bench.look.time = (frame + 0.5) / std::max(report.frames_per_second, 1e-6);
}

void clip_time(ui::Ui& ui, const On& on) {
    KeyingBench& bench = on.bench;
    const double duration = on.report().duration;
    double time = bench.look.follow ? bench.time() : bench.standing_at();
    const bool moved = ui::number_field(ui, "Clip time", time,
                                        {.maximum = duration,
                                         .hard_minimum = 0,
                                         .hard_maximum = duration,
                                         .step = 0.04,
                                         .unit = "s",
                                         .decimals = 2,
                                         .tip = "The frame of the clip that is shown here",
                                         .width = ui::px(ui.em(clip_time_width))})
                           .changed;
    if (moved) bench.look.time = time, bench.look.follow = false;
}

/// `room`: px.
void scrub(ui::Ui& ui, const On& on, float room) {
    KeyingBench& bench = on.bench;
    const std::string_view place =
        ui.copy("frame " + std::to_string(bench.frame() + 1) + " of " + std::to_string(bench.frames()) +
                (bench.broken() ? ": cannot be decoded, the frame before is shown" : ""));
    const std::array<ui::ToolItem, 5> items = {{{.width = ui.row_height()},
                                                {.width = ui.row_height()},
                                                {.width = ui.em(clip_time_width)},
                                                {.width = ui.text_width(place) + ui.em(1), .rank = 2},
                                                {.width = ui::tool_width(ui, "Follow"), .rank = 1}}};
    ui::toolbar(ui, "Clip time tools", room, items, [&](std::size_t item) {
        if (item == 0 && ui::icon_button(ui, Icon::step_back, "Previous frame", {.quiet = true})) step_frame(on, -1);
        if (item == 1 && ui::icon_button(ui, Icon::step_forward, "Next frame", {.quiet = true})) step_frame(on, 1);
        if (item == 2) clip_time(ui, on);
        if (item == 3)
            ui::label(ui, place, {.tone = bench.broken() ? ui::Tone::warning : ui::Tone::dim, .number = true});
        if (item == 4)
            ui::toggle(ui, "Follow", bench.look.follow,
                       {.tip = "Shows the frame of the timeline, counted from the clip's in point. In the preview a "
                               "clip with a random start may be elsewhere"});
    });
}

// --- the thresholds --------------------------------------------------------------------------------------------------

/// `height`: em.
void luma_histogram(ui::Ui& ui, const On& on, float height) {
    KeyingBench& bench = on.bench;
    const std::size_t number = on.shelf.selected;
    const KeyingParameters& keying = bench.keying();
    const bool dark = bench.clip()->polarity == ClipPolarity::dark, alpha = on.has_alpha();
    ui::Levels levels{.low = keying.luma_low, .high = keying.luma_high};
    const KeyingParameters& saved = on.edited.saved.keying(number);
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.1F});
    ui::label(ui, dark ? "Darkness of this frame (255 - luma)" : "Brightness (luma) of this frame",
              {.tone = ui::Tone::dim, .size = 0.86F});
    ui.push_seed("scope");
    const ui::HistogramResult result =
        ui::histogram(ui, "Luma", {.bins = bench.histogram()}, alpha ? nullptr : &levels,
                      {.reset = {.low = saved.luma_low, .high = saved.luma_high},
                       .initial = ui::Levels{.low = KeyingParameters{}.luma_low, .high = KeyingParameters{}.luma_high},
                       .log_counts = &bench.look.log_counts,
                       .unit = "levels",
                       .tip = "How often each brightness occurs in this frame. Below "
                              "Luma low is background, above Luma high is fully smoke",
                       .height = height});
    ui.pop_seed();
    on.document().take(result.low, "Luma low",
                       [&](Content& c) { KeyingBench::keying_of(c, number).luma_low = levels.low; });
    on.document().take(result.high, "Luma high",
                       [&](Content& c) { KeyingBench::keying_of(c, number).luma_high = levels.high; });
}

void chroma_scope(ui::Ui& ui, const On& on) {
    KeyingBench& bench = on.bench;
    const std::size_t number = on.shelf.selected;
    const KeyingParameters& keying = bench.keying();
    ui::KeyCircles circles{.color = glm::vec3(255.0 * keying.key_color),
                           .chroma_low = keying.chroma_low,
                           .chroma_high = keying.chroma_high,
                           .reset_low = on.edited.saved.keying(number).chroma_low,
                           .reset_high = on.edited.saved.keying(number).chroma_high,
                           .initial_low = KeyingParameters{}.chroma_low,
                           .initial_high = KeyingParameters{}.chroma_high};
    const ui::VectorscopeResult result =
        ui::vectorscope(ui, "Chroma", bench.vectors(), on.has_alpha() ? nullptr : &circles,
                        {.tip = circles.chroma_high > 0 ? "Colours of this frame. Inside the inner circle is "
                                                          "background, outside the outer circle is fully smoke"
                                                        : "Colours of this frame. They are not used while Chroma high "
                                                          "is 0: only brightness (luma) decides what is smoke"});
    on.document().take(result.low, "Chroma low", [&](Content& c) {
        KeyingBench::keying_of(c, number).chroma_low = std::clamp(circles.chroma_low, 0.0, 180.0);
    });
    on.document().take(result.high, "Chroma high", [&](Content& c) {
        KeyingBench::keying_of(c, number).chroma_high = std::clamp(circles.chroma_high, 0.0, 180.0);
    });
}

void scope(ui::Ui& ui, const On& on) {
    KeyingBench& bench = on.bench;
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.1F});
    {
        constexpr std::array<std::string_view, 2> kinds = {"Colours", "Waveform"};
        int kind = bench.look.waveform ? 1 : 0;
        const Room room(ui, 0);
        if (ui::segmented(ui, "Scope", kind, kinds)) bench.look.waveform = kind == 1;
    }
    ui.push_seed("scope");
    if (bench.look.waveform)
        ui::waveform(
            ui, "Luma waveform", bench.waves(),
            {.tip = "Brightness of the frame: its columns from left to right, black at the bottom, white at the top"});
    else
        chroma_scope(ui, on);
    ui.pop_seed();
}

void whose_and_suggest(ui::Ui& ui, const On& on, bool narrow) {
    constexpr std::array<std::string_view, 2> names = {"All clips", "This clip"};
    const std::size_t number = on.shelf.selected;
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::label(ui, "For", {.tone = ui::Tone::dim});
    int own = on.bench.clip()->own_keying ? 1 : 0;
    ui::Edit edit;
    {
        const Room room(ui, narrow ? 0 : 11);
        edit = ui::segmented(ui, "Thresholds for", own, names);
    }
    on.document().take(edit, "Own keying", [&](Content& c) {
        SmokeClip& clip = c.preset.smoke.clips[number];
        if (own == 1) clip.keying = c.preset.smoke.keying;  // begins with the keying that is in use now
        clip.own_keying = own == 1;
    });
    if (!narrow) ui::spacer(ui);
    ui::command_button(ui, on.commands, "clip.suggest", narrow);
}

void pick_color(ui::Ui& ui, const On& on) {
    KeyingBench& bench = on.bench;
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    ui::command_button(ui, on.commands, "clip.eyedropper");
    constexpr std::array<std::string_view, 4> names = {"1 px", "3 x 3", "5 x 5", "11 x 11"};
    constexpr std::array<int, 4> sides = {1, 3, 5, 11};
    int box = static_cast<int>(std::find(sides.begin(), sides.end(), bench.look.sample_box) - sides.begin());
    const Room room(ui, 0);
    if (ui::segmented(ui, "Sample box", box, names)) bench.look.sample_box = sides[static_cast<std::size_t>(box)];
}

/// What the suggestion changed, until the document changes again.
void suggested_changes(ui::Ui& ui, const On& on, bool unsure) {
    const KeyingBench& bench = on.bench;
    const std::string_view changes = bench.suggestion_changes();
    if (changes.empty()) return;
    const std::string_view undo = chord_of(on.commands, "edit.undo");
    ui::label(ui,
              bench.suggestion_undoes() ? ui.join({changes, ". ", undo.empty() ? "Undo" : undo, " undoes it."})
                                        : ui.join({changes, "."}),
              {.tone = unsure ? ui::Tone::warning : ui::Tone::good, .wrap = true, .width = ui::grow()});
}

void told_by_suggest(ui::Ui& ui, const On& on) {
    KeyingBench& bench = on.bench;
    if (bench.suggesting()) {
        if (ui::progress(ui, "Suggesting", -1, {.cancellable = true})) bench.cancel_suggesting();
        return;
    }
    for (const Fault& fault : bench.suggestion_faults())
        ui::label(ui, ui.copy(fault.text()), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    if (!bench.suggestion()) return;
    const KeyingSuggestion& found = *bench.suggestion();
    const bool unsure = found.confidence < KeyingBench::sure_from;
    const std::string percent = std::to_string(std::lround(100 * found.confidence));
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::start});
    {
        const ui::Column lines(ui, {.width = ui::grow(), .gap = 0.2F});
        suggested_changes(ui, on, unsure);
        ui::label(ui,
                  ui.join({unsure ? "Only " : "", percent, " % sure", unsure ? ", check it before you use it" : "",
                           ": ", found.reason}),
                  {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
    }
    if (on.document().preset().smoke.clips.size() > 1 && bench.clip()->own_keying && !found.alpha &&
        ui::button(ui, "Use for all", {.tip = "Uses these thresholds for all clips without keying of their own"}))
        return bench.suggest_for_all();
    if (ui::icon_button(ui, Icon::cross, "Dismiss", {.quiet = true})) bench.forget_suggestion();
}

void rows(ui::Ui& ui, const On& on, bool narrow) {
    const std::size_t number = on.shelf.selected;
    whose_and_suggest(ui, on, narrow);
    told_by_suggest(ui, on);
    pick_color(ui, on);
    const bool alpha = on.has_alpha();
    if (alpha)
        ui::label(ui, "This clip has its own opacity, which is used instead of thresholds.",
                  {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
    static const KeyingParameters standard;
    static const SmokeClip standard_clip;
    const auto clip = [number](Content& c) -> void* {
        return number < c.preset.smoke.clips.size() ? &c.preset.smoke.clips[number] : nullptr;
    };
    const auto keying = [number](Content& c) -> void* { return &KeyingBench::keying_of(c, number); };
    table_row(ui, on.edited, *clip_table().find_row("polarity"), clip,
              {.standard = &standard_clip, .saved = &on.edited.saved.clip(number)});
    for (const Parameter& row : keying_table().rows) {
        ui.push_disabled(alpha && is_threshold(row.key));
        table_row(ui, on.edited, row, keying, {.standard = &standard, .saved = &on.edited.saved.keying(number)});
        ui.pop_disabled();
    }
    frame_rows(ui, on.bench, on.edited, number, on.commands);
}

/// One below the other, for what scrolls.
void thresholds_below(ui::Ui& ui, const On& on) {
    {
        const ui::Column held(ui, {.width = ui::grow(), .height = ui::px(ui.em(12))});
        luma_histogram(ui, on, 10);
    }
    rows(ui, on, true);
    const ui::Column held(ui, {.width = ui::grow(), .height = ui::px(ui.em(16))});
    scope(ui, on);
}

/// `height`: em, that there is room for.
void thresholds(ui::Ui& ui, const On& on, bool narrow, float height) {
    if (narrow) {
        const ui::ScrollArea area(ui, "Thresholds", {.gap = 0.3F});
        return thresholds_below(ui, on);
    }
    const ui::Row row(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.8F, .cross = ui::ChildAlign::stretch});
    {
        const ui::Column scopes(ui, {.width = ui::grow(1.15F), .height = ui::grow()});
        luma_histogram(ui, on, std::max(height - 2.2F, 5.0F));
    }
    {
        const ui::Column held(ui, {.width = ui::grow(0.8F), .height = ui::grow()});
        scope(ui, on);
    }
    const ui::ScrollArea area(ui, "Thresholds", {.width = ui::px(ui.em(27)), .gap = 0.3F});
    rows(ui, on, narrow);
}

// --- without a picture -----------------------------------------------------------------------------------------------

void nothing_to_show(ui::Ui& ui, const On& on) {
    KeyingBench& bench = on.bench;
    const app::ClipFacts& facts = on.shelf.of(on.shelf.selected);
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow(), .padding = 1});
    if (bench.clip() == nullptr) {
        ui::label(ui, "There is no smoke clip to key. Add a video of smoke in front of a plain background.",
                  {.wrap = true, .width = ui::grow()});
        const ui::Row row(ui);
        ui::command_button(ui, on.commands, "clip.add");
        return;
    }
    if (facts.job && !facts.job->cancelled()) {
        if (ui::progress(ui, facts.job->name(), facts.job->progress(), {.cancellable = true})) facts.job->cancel();
        return;
    }
    for (const Fault& fault : facts.faults)
        ui::label(ui, ui.copy(fault.text()), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    for (const Fault& fault : bench.faults())
        ui::label(ui, ui.copy(fault.text()), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    if (facts.known && bench.faults().empty()) return ui::label(ui, "Reading the frame", {.tone = ui::Tone::dim});
    const ui::Row row(ui);
    ui::command_button(ui, on.commands, "clip.replace");
    if (ui::button(ui, "Look again", {.tip = "Checks whether the file is there now"})) on.shelf.look_again();
}

/// In a low panel the pictures have nearly all the room, and one scrolls to the thresholds.
void low(ui::Ui& ui, const On& on, const ui::Rect& room) {
    const float others = 2 * ui.row_height() + ui.em(2.4F), peek = ui.em(3);
    const float height = std::max(room.h - others - peek, ui.em(least_pictures));
    const ui::ScrollArea area(ui, "Bench", {.gap = 0.4F});
    {
        const ui::Column upper(ui, {.width = ui::grow(), .height = ui::px(height)});
        pictures(ui, on, height >= ui.em(2 * least_pictures));
    }
    scrub(ui, on, std::max(1.0F, room.w - ui.em(2.2F)));
    thresholds_below(ui, on);
}

}  // namespace

void keying_panel(ui::Ui& ui, KeyingBench& bench, app::ClipShelf& shelf, const Edited& edited,
                  ui::CommandTable& commands) {
    const On on{bench, shelf, edited, commands};
    bench.show();
    follow_mask_drawing(ui, bench, shelf.selected);
    if (bench.stale()) ui.wake_at(ui.time(), "the keying bench follows");
    const ui::Rect room = ui.rect_before(ui.parent().id);
    const bool narrow = room.w < ui.em(52);
    if (!bench.ready() || bench.clip() == nullptr) return nothing_to_show(ui, on);
    const float width = room.w > 0 ? std::max(1.0F, room.w - 2 * ui.em(0.6F)) : 0.0F;
    if (room.h > 0 && room.h < ui.em(low_bench)) {
        const ui::Column close_together(ui, {.width = ui::grow(), .height = ui::grow(), .gap = 0.1F});
        tools(ui, on, width);
        return low(ui, on, room);
    }
    tools(ui, on, width);
    ui::Splitter split(ui, "Bench", ui::Axis::y, bench.look.scopes,
                       {.first_minimum = 8, .second_minimum = 8, .standard = 0.64F});
    {
        const ui::Column upper(ui, {.width = ui::grow(), .height = ui::grow()});
        pictures(ui, on);
        scrub(ui, on, width);
    }
    split.next();
    thresholds(ui, on, narrow, (1 - bench.look.scopes) * room.h / ui.em(1) - 2);
}

}  // namespace lapfx::panels
