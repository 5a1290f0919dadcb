// All parameters of the preset, in sections. Every row is made from the parameter table.
#include <charconv>
#include <cmath>
#include <utility>

#include "app/base/layouts.h"
#include "app/clips/clip_shelf.h"
#include "app/editor.h"
#include "app/tuning/tuning.h"
#include "panels/clip_parameters.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/preset_rows.h"
#include "panels/randomise.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/field.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/section.h"
#include "ui/widgets/text_field.h"

namespace lapfx::panels {

namespace {

using app::no_entry;
using app::ParameterEntry;
using app::ParameterGroup;
using app::Tuning;
using ui::Icon;
using ui::key_of;
using ui::Mods;

constexpr std::string_view found_by = "Find by name, key, effect or an everyday word, such as fog";
constexpr std::string_view all_menu = "preset menu", group_menu = "group menu";

/// What the panel works on.
struct On {
    Tuning& tuning;
    const Edited& edited;
    const ui::CommandTable& commands;
    app::Layouts& layouts;
    ui::Toasts& toasts;
    const app::ClipShelf& shelf;
    app::Looking& looking;
};

const ParameterGroup* group_of(const Tuning& tuning) {
    if (tuning.current == no_entry) return nullptr;
    const ParameterGroup& group = app::parameters().groups()[app::parameters()[tuning.current].group];
    return group.key.empty() ? nullptr : &group;
}

void copy_group(const Tuning& tuning, ui::Clipboard* clipboard, ui::Toasts& toasts, const ParameterGroup* group) {
    if (clipboard == nullptr) return;
    clipboard->set(tuning.copy(group));
    toasts.add({.text = group == nullptr ? "Copied the whole preset as JSON"
                                         : group->name + " was copied as JSON: paste it into another preset"});
}

void paste_group(Tuning& tuning, ui::Clipboard* clipboard, const ParameterGroup* group) {
    if (clipboard != nullptr) tuning.paste(clipboard->get(), group);
}

/// The items of the menu for the whole preset (`group` is null) or for a group.
void menu_items(ui::Ui& ui, const On& on, const ParameterGroup* group, ui::Id box_at) {
    Tuning& tuning = on.tuning;
    const bool clipboard = ui.clipboard() != nullptr;
    const int changed = group == nullptr ? tuning.changed_in_all() : tuning.changed_in(*group);
    if (ui::menu_item(ui, group == nullptr ? "Copy all" : "Copy group",
                      {.icon = Icon::copy, .tip = "As JSON, for another editor or a file", .enabled = clipboard}))
        copy_group(tuning, ui.clipboard(), on.toasts, group);
    if (ui::menu_item(ui, group == nullptr ? "Paste parameters" : "Paste group",
                      {.tip = "From JSON in the clipboard", .enabled = clipboard}))
        paste_group(tuning, ui.clipboard(), group);
    if (ui::menu_item(ui, group == nullptr ? "Reset all" : "Reset group",
                      {.icon = Icon::reset,
                       .tip = changed > 0 ? "Back to the saved values" : "Nothing differs from the saved values",
                       .enabled = changed > 0}))
        tuning.reset(group);
    ui::menu_separator(ui);
    const std::string percent = std::to_string(std::lround(100 * tuning.strength));
    if (ui::menu_item(ui, ui.join({"Randomise by ", percent, " %###Randomise"}),
                      {.icon = Icon::dice, .tip = "Changes everything that is not locked, in one undo step"}))
        randomise(tuning, on.edited.document, on.toasts, group);
    if (ui::menu_item(ui, "Strength and seed...", {.tip = "How far randomising goes from the current values"}))
        open_randomise_box(ui, group, box_at);
    ui::menu_separator(ui);
    bool locked = true;
    for (const ParameterGroup& one : app::parameters().groups())
        if (group == nullptr || &one == group) locked &= tuning.all_locked(one);
    if (!ui::menu_item(ui, locked ? "Unlock all" : "Lock all",
                       {.icon = locked ? Icon::unlock : Icon::lock, .tip = "Randomising leaves it unchanged"}))
        return;
    for (const ParameterGroup& one : app::parameters().groups())
        if (group == nullptr || &one == group) tuning.lock(one, !locked);
}

/// Whether Down came in the search field: it goes to the first row that is found.
bool leaves_for_rows(ui::Ui& ui) {
    bool down = false;
    ui.events_of(ui.id_of("Search"), [&](const ui::Event& event) {
        down |= event.kind == ui::EventKind::key && event.key == ui::Key::down;
    });
    return down;
}

/// Esc in the empty search field goes back to what had the keyboard before; if that is gone, the field keeps it.
void leave_search(ui::Ui& ui, app::Tuning& tuning) {
    const ui::Id field = ui.id_of("Search");
    bool escaped = false;
    ui.events_of(field, [&](const ui::Event& event) {
        escaped |= event.kind == ui::EventKind::key && event.key == ui::Key::escape;
    });
    if (!escaped || ui.focus() != 0) return;
    const bool there = tuning.search_from != 0 && ui.before(tuning.search_from) != nullptr;
    ui.set_focus(there ? tuning.search_from : field, true);
}

void tool_row(ui::Ui& ui, const On& on) {
    Tuning& tuning = on.tuning;
    const ui::Row row(ui, {.width = ui::grow(), .cross = ui::ChildAlign::center});
    if (tuning.wants_search) {
        tuning.wants_search = false;
        if (ui.focus() != ui.id_of("Search")) tuning.search_from = ui.focus();
        ui.set_focus(ui.id_of("Search"), true);
    }
    const std::string_view find_keys = chord_of(on.commands, "preset.find");
    constexpr std::string_view asks_for = "Find a parameter";
    const float field = ui.rect_before(ui.id_of("Search")).w;
    const bool narrow = field > 0 && field < ui.text_width(asks_for) + ui.em(4);
    ui::search_field(ui, "Search", tuning.search,
                     {.placeholder = narrow ? "Find" : asks_for,
                      .tip = find_keys.empty() ? found_by : ui.join({found_by, " (", find_keys, ")"})});
    leave_search(ui, tuning);
    ui::toggle(ui, "Changed only", tuning.changed_only,
               {.icon = Icon::dot, .tip = "Only what differs from the saved preset", .quiet = true});
    const ui::Id dice = ui.id_of("Randomise");
    constexpr std::string_view asks = "Randomises what is not locked; asks how far";
    const std::string_view keys = chord_of(on.commands, "preset.randomise");
    if (ui::icon_button(ui, Icon::dice, "Randomise",
                        {.tip = keys.empty() ? asks : ui.join({asks, ". ", keys, " does it at once"}), .quiet = true}))
        open_randomise_box(ui, nullptr, dice);
    randomise_box(ui, tuning, on.edited.document, on.toasts);
    const ui::Id id = ui.id_of("More");
    if (ui::icon_button(ui, Icon::menu, "More", {.tip = "Copy, paste, reset, randomise, lock", .quiet = true}))
        ui::open_menu(ui, all_menu, {.side = ui::Placement::Side::below, .anchor = id});
    if (const ui::Menu menu(ui, all_menu, "Preset menu"); menu) menu_items(ui, on, nullptr, dice);
}

class Sections {
  public:
    Sections(ui::Ui& ui, const On& on) : ui_(ui), on_(on), tuning_(on.tuning) {}

    void build() {
        bool clips = false;
        put_heading();
        put_favourites();
        for (const ParameterGroup& group : app::parameters().groups()) {
            if (group.key.empty()) continue;
            if (!clips && group.key.starts_with("smoke.")) put_clips();
            clips |= group.key.starts_with("smoke.");
            put_group(group);
        }
        if (shown_ == 0 && (searching() || tuning_.changed_only))
            ui::label(ui_, searching() ? "No parameter has this name" : "Nothing differs from the saved preset",
                      {.tone = ui::Tone::dim});
    }

    /// The first row of the sections gets the keyboard.
    void want_first() {
        for (std::size_t i = 0; i < app::parameters().entries().size(); ++i) {
            if (app::parameters().groups()[app::parameters()[i].group].key.empty() || !shows(i)) continue;
            tuning_.wanted = i;
            return;
        }
    }

  private:
    bool searching() const { return !tuning_.search.empty(); }

    bool shows(std::size_t index) const {
        const ParameterEntry& entry = app::parameters()[index];
        if (entry.low != no_entry) return false;  // it is shown in the row of its lower bound
        const bool changed = tuning_.changed(index) || (entry.high != no_entry && tuning_.changed(entry.high));
        if (tuning_.changed_only && !changed) return false;
        return !searching() || ui::contains_words(entry.words, tuning_.search);
    }

    ui::Id row(std::size_t index, RowName called = RowName::in_section) {
        ++shown_;
        return parameter_row(ui_, on_.edited, tuning_, index, called);
    }

    /// Name, description and tags; what is wrong elsewhere.
    void put_heading() {
        for (const std::string& fault : tuning_.other_faults())
            ui::label(ui_, fault, {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
        const ParameterGroup& own = app::parameters().groups().front();
        ui::Node& body = ui_.open(ui::Role::none, {}, ui::Axis::y);  // indented like the rows of sections
        body.gap = ui_.em(ui_.theme().gap);
        body.padding[0] = static_cast<std::uint8_t>(std::min(255.0F, ui_.em(0.8F)));
        for (std::size_t i = own.first; i < own.last; ++i)
            if (shows(i)) row(i);
        ui_.close();
    }

    void put_favourites() {
        if (searching()) return;  // a search finds them in their sections
        bool any = false;
        for (const std::size_t index : tuning_.favourites()) any |= shows(low_of(index));
        if (!any) return;
        const ui::Section section(ui_, "Favourites", {.tip = "Parameters marked as favourites in their menu"});
        if (!section) return;
        float& room = ui_.memory<float>(favourites_memory);  // px for a label, in the last build
        float longest = 0;
        for (const std::size_t index : tuning_.favourites())
            longest = std::max(longest, ui_.text_width(title_with_group(low_of(index))));
        const RowName called = room > 0 && longest > room ? RowName::without_group : RowName::with_group;
        float narrowest = unknown_width;
        bool told = false;
        for (std::size_t i = 0; i < tuning_.favourites().size(); ++i) {  // a menu may remove one meanwhile
            const std::size_t index = tuning_.favourites()[i];
            if (!shows(low_of(index)) || listed_with_low(index)) continue;
            const float width = ui_.rect_before(row(low_of(index), called)).w;
            if (width > 0) narrowest = std::min(narrowest, width);
            told = told || put_not_taken(index);
        }
        if (narrowest == unknown_width) return;
        const float now = narrowest * ui::caption_share - ui_.em(ui::caption_inset + label_marks);
        if (now != std::exchange(room, now)) ui_.build_again();
    }

    static std::size_t low_of(std::size_t index) {
        const std::size_t low = app::parameters()[index].low;
        return low == no_entry ? index : low;
    }
    bool listed_with_low(std::size_t index) const {
        const std::size_t low = app::parameters()[index].low;
        return low != no_entry && tuning_.favourite(low);
    }

    void put_group(const ParameterGroup& group) {
        bool any = false;
        for (std::size_t i = group.first; i < group.last && !any; ++i) any = shows(i);
        if (!any) return;
        // Sections that a search leaves are other ones, all open, so that those from before keep their state.
        const bool narrowed = searching() || tuning_.changed_only;
        const std::string_view label = narrowed ? ui_.join({group.name, "###", group.key, " found"}) : group.name;
        constexpr ui::SectionButton buttons[] = {{Icon::menu, "More"}};
        const ui::Section section(ui_, label,
                                  {.changed = tuning_.changed_in(group),
                                   .open = narrowed || group.key == "bleeding",
                                   .unfold = has_wanted(group),
                                   .tip = group.table->help,
                                   .buttons = buttons});
        ui_.push_seed(group.key);
        const ui::Id owner = ui_.id_of("group");
        ui_.pop_seed();
        ui::Id& menu_of = ui_.memory<ui::Id>(menu_memory);
        if (section.clicked() == 0) {
            menu_of = owner;
            ui::open_menu(ui_, group_menu, {.side = ui::Placement::Side::below, .anchor = ui_.id_of("More")});
        }
        if (menu_of == owner)
            if (const ui::Menu menu(ui_, group_menu, ui_.join({group.name, " menu"})); menu)
                menu_items(ui_, on_, &group, ui_.id_of("More"));
        if (!section) return;
        if (group.key == "smoke.haze") put_endoscope_only();
        bool told = false;
        for (std::size_t i = group.first; i < group.last; ++i) {
            if (!shows(i)) continue;
            told = told || put_not_taken(i);
            row(i);
        }
    }

    /// Where the shown clip does not take the parameter: says so, and leads to what it takes. Once in a section.
    bool put_not_taken(std::size_t index) {
        const NotTaken found = not_taken(on_.edited.document.preset().smoke, on_.shelf, app::parameters()[index].key);
        if (found.why.empty()) return false;
        const std::string number = std::to_string(on_.shelf.selected + 1);
        if (ui::button(ui_, ui_.join({"Clip ", number, found.why, "###Not taken"}),
                       {.icon = Icon::warning, .tip = found.tip}))
            on_.layouts.bring_to_front("Keying");
        return true;
    }

    /// A free look is without haze: what is set here would not be seen.
    void put_endoscope_only() {
        if (on_.looking.endoscope || on_.shelf.alone()) return;
        if (ui::button(ui_, "Only in the endoscope view",
                       {.icon = Icon::info, .tip = "A free look leaves haze out. Click for the endoscope view"}))
            on_.looking.endoscope = true;
    }

    bool has_wanted(const ParameterGroup& group) const {
        return tuning_.wanted >= group.first && tuning_.wanted < group.last;
    }

    void put_clips() {
        if (searching() || tuning_.changed_only) return;
        const std::size_t count = on_.edited.document.preset().smoke.clips.size();
        char digits[8];
        const auto end = std::to_chars(digits, digits + sizeof digits, count).ptr;
        const std::string_view number(digits, static_cast<std::size_t>(end - digits));
        const std::string_view text =
            ui_.join({number, count == 1 ? " clip" : " clips", ": edit in Clips###Edit clips"});
        if (ui::button(ui_, text, {.icon = Icon::link, .tip = "Smoke videos have a panel of their own", .quiet = true}))
            on_.layouts.bring_to_front("Clips");
    }

    static constexpr ui::Id menu_memory = 0x67726d656e75ULL, favourites_memory = 0x6661766f757273ULL;
    static constexpr float unknown_width = 1e9F;
    static constexpr float label_marks = 0.9F;  // em after a label, for the dot
    ui::Ui& ui_;
    const On& on_;
    Tuning& tuning_;
    std::size_t shown_ = 0;
};

}  // namespace

void preset_panel(ui::Ui& ui, Tuning& tuning, const Edited& edited, const ui::CommandTable& commands,
                  app::Layouts& layouts, ui::Toasts& toasts, const app::ClipShelf& shelf, app::Looking& looking) {
    tuning.follow();
    const On on{tuning, edited, commands, layouts, toasts, shelf, looking};
    const ui::Column column(ui, {.width = ui::grow(), .height = ui::grow()});
    tool_row(ui, on);
    const bool to_rows = leaves_for_rows(ui);
    const ui::ScrollArea area(ui, "Parameters", {.gap = ui.theme().gap});
    Sections sections(ui, on);
    if (to_rows) sections.want_first();
    sections.build();
}

void add_preset_commands(app::Editor& editor) {
    Tuning& tuning = editor.tuning();
    const auto with_group = [&tuning] { return group_of(tuning) != nullptr; };
    const auto with_row = [&tuning] { return tuning.current != no_entry; };
    editor.commands.add({.id = "preset.find",
                         .title = "Find parameter",
                         .group = "Preset",
                         .chord = {key_of('F'), Mods::command},
                         .icon = Icon::search,
                         .run =
                             [&editor, &tuning] {
                                 editor.layouts().bring_to_front("Preset");
                                 tuning.wants_search = true;
                             },
                         .tip = std::string(found_by)});
    editor.commands.add({.id = "preset.changed_only",
                         .title = "Show changed parameters only",
                         .group = "Preset",
                         .run =
                             [&editor, &tuning] {
                                 editor.layouts().bring_to_front("Preset");
                                 tuning.changed_only = !tuning.changed_only;
                             },
                         .checked = [&tuning] { return tuning.changed_only; },
                         .tip = "Only what differs from the saved preset"});
    editor.commands.add(
        {.id = "preset.copy_group",
         .title = "Copy group",
         .group = "Preset",
         .chord = {key_of('C'), Mods::command | Mods::shift},
         .icon = Icon::copy,
         .run = [&editor, &tuning] { copy_group(tuning, editor.clipboard(), editor.toasts, group_of(tuning)); },
         .enabled = with_group,
         .tip = "Copies the whole section of the selected parameter, as JSON",
         .missing = "no parameter is selected in the Preset panel"});
    editor.commands.add({.id = "preset.paste",
                         .title = "Paste parameters",
                         .group = "Preset",
                         .chord = {key_of('V'), Mods::command | Mods::alt},
                         .run = [&editor, &tuning] { paste_group(tuning, editor.clipboard(), nullptr); },
                         .enabled = [&editor] { return editor.clipboard() != nullptr; },
                         .tip = "Pastes groups or a whole preset from JSON in the clipboard",
                         .missing = "there is no clipboard"});
    editor.commands.add({.id = "preset.randomise",
                         .title = "Randomise",
                         .group = "Preset",
                         .chord = {key_of('R'), Mods::command},
                         .icon = Icon::dice,
                         .run = [&editor, &tuning] { randomise(tuning, editor.document, editor.toasts, nullptr); },
                         .tip = "Changes all parameters that are not locked"});
    editor.commands.add({.id = "preset.lock",
                         .title = "Lock parameter",
                         .group = "Preset",
                         .icon = Icon::lock,
                         .run = [&tuning] { tuning.lock(tuning.current, !tuning.locked(tuning.current)); },
                         .enabled = with_row,
                         .checked = [&tuning, with_row] { return with_row() && tuning.locked(tuning.current); },
                         .tip = "Randomising leaves the selected parameter unchanged",
                         .missing = "no parameter is selected in the Preset panel"});
    editor.commands.add({.id = "preset.favourite",
                         .title = "Favourite parameter",
                         .group = "Preset",
                         .icon = Icon::star,
                         .run = [&tuning] { tuning.mark_favourite(tuning.current, !tuning.favourite(tuning.current)); },
                         .enabled = with_row,
                         .checked = [&tuning, with_row] { return with_row() && tuning.favourite(tuning.current); },
                         .tip = "Lists the selected parameter first in the Preset panel",
                         .missing = "no parameter is selected in the Preset panel"});
    editor.commands.add({.id = "preset.reset",
                         .title = "Reset preset",
                         .group = "Preset",
                         .icon = Icon::reset,
                         .run = [&tuning] { tuning.reset(nullptr); },
                         .enabled = [&tuning] { return tuning.changed_in_all() > 0; },
                         .tip = "Sets all parameters back to the saved values",
                         .missing = "nothing differs from the saved preset"});
}

}  // namespace lapfx::panels
