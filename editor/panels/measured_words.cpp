#include "panels/measured_words.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>

#include "app/base/layouts.h"
#include "app/measure/measuring.h"
#include "app/measure/preview_measuring.h"
#include "app/preview/timeline.h"
#include "app/tuning/key_titles.h"
#include "app/tuning/parameters.h"
#include "app/tuning/tuning.h"
#include "match/compare/likeness_words.h"
#include "panels/measured_colors.h"
#include "panels/table_rows.h"
#include "ui/canvas/axis.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

namespace {

using match::Clause;
using match::Said;

/// Of what is measured now.
struct Words {
    std::uint64_t of_preview = 0, of_reference = 0, of_document = 0;
    std::vector<Clause> clauses;
    std::vector<std::string> sentences;  ///< each clause has one
    match::Likeness likeness;
};

const Words& words_of(ui::Ui& ui, const AmountsParts& on) {
    Words& words = ui.memory<Words>(ui.id_of("measured words"));
    if (words.of_preview == on.preview.version() && words.of_reference == on.measuring.version() &&
        words.of_document == on.document.version())
        return words;
    words.of_preview = on.preview.version(), words.of_reference = on.measuring.version();
    words.of_document = on.document.version();
    const Scene& scene = on.document.scene();
    words.likeness = match::likeness_of(on.preview.frames(), on.measuring.frames(), scene.reference.offset);
    words.clauses = match::clauses(words.likeness, scene.events);
    words.sentences.clear();
    for (const Clause& clause : words.clauses) words.sentences.push_back(clause.sentence());
    return words;
}

/// "events.2.time": 2.
std::optional<std::size_t> event_of(std::string_view key) {
    constexpr std::string_view list = "events.";
    if (!key.starts_with(list)) return {};
    key.remove_prefix(list.size());
    std::size_t event = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), event);
    return error == std::errc() && end != key.data() ? std::optional(event) : std::nullopt;
}

}  // namespace

void go_to_what_mends(ui::Ui& ui, const AmountsParts& on, const std::string& key) {
    if (const std::size_t entry = app::parameters().find(key); entry != app::no_entry) {
        on.layouts.bring_to_front("Preset");
        on.tuning.want(entry);
    } else if (const std::optional<std::size_t> event = event_of(key);
               event && *event < on.document.scene().events.size()) {
        on.layouts.bring_to_front("Timeline");
        on.selected = {*event};
        on.timeline.seek(on.document.scene().events[*event].time);
    } else if (key == exposure_key) {
        on.layouts.bring_to_front("Scene");
        wanted_row(ui) = scene_table().find("camera")->find_row("exposure");
    }
    ui.build_again();
}

namespace {

/// `wrap`: there is room for a second line.
void link(ui::Ui& ui, const AmountsParts& on, const Clause& clause, const std::string& text, bool wrap) {
    if (clause.key.empty())
        return ui::label(
            ui, text,
            {.tone = clause.what == Said::match ? ui::Tone::good : ui::Tone::dim, .wrap = wrap, .width = ui::grow()});
    const bool clicked = ui::button(
        ui, text, {.tip = ui.join({text, ". Goes to what mends it: ", app::title_of(clause.key)}), .quiet = true});
    ui.last().rigid = false;  // in a narrow panel its text is cut
    if (clicked) go_to_what_mends(ui, on, clause.key);
}

/// What is said of one amount, and the root mean square difference.
void line_of(ui::Ui& ui, const AmountsParts& on, const Words& words, std::string_view amount,
             const std::optional<double>& rms, bool wrap) {
    const auto is_of = [&](const Clause& clause) { return clause.amount == amount; };
    if (std::none_of(words.clauses.begin(), words.clauses.end(), is_of)) return;
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    for (std::size_t i = 0; i < words.clauses.size(); ++i)
        if (is_of(words.clauses[i])) link(ui, on, words.clauses[i], words.sentences[i], wrap);
    if (!rms) return;
    // A text that leads nowhere takes all the room that there is.
    const auto grows = [&](const Clause& clause) { return is_of(clause) && clause.key.empty(); };
    if (std::none_of(words.clauses.begin(), words.clauses.end(), grows)) ui::spacer(ui);
    ui::ShortText text;
    text.add("off by ").add(100 * *rms, 1).add(" %");
    ui::label(ui, ui.copy(text.view()), {.tone = ui::Tone::dim, .number = true});
    ui.last().rigid = true;
    ui.last().tip = "Root mean square difference of both curves, in percent of the view";
}

}  // namespace

bool measured_words(ui::Ui& ui, const AmountsParts& on, bool colors) {
    if (on.measuring.found() == nullptr || on.measuring.stale() || on.measuring.begun() || !on.preview.complete() ||
        on.preview.stale() || on.preview.stopped())
        return false;
    const Words& words = words_of(ui, on);
    const ui::Column lines(ui, {.width = ui::grow(), .gap = 0});
    line_of(ui, on, words, "", {}, colors);
    line_of(ui, on, words, "blood", words.likeness.blood.rms, colors);
    line_of(ui, on, words, "veil", words.likeness.veil.rms, colors);
    if (colors) measured_colors(ui, on);
    return true;
}

}  // namespace lapfx::panels
