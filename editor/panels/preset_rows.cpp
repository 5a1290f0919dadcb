#include "panels/preset_rows.h"

#include <cstdio>

#include "app/tuning/tuning.h"
#include "lapfx/authoring/reach.h"
#include "panels/table_rows.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/menu.h"
#include "ui/widgets/param.h"

namespace lapfx::panels {

namespace {

using app::no_entry;
using app::ParameterEntry;
using app::Tuning;

constexpr std::string_view menu_name = "parameter menu";

/// Which row's menu is open: a favourite has two rows.
struct MenuOf {
    ui::Id row = 0;
};
constexpr ui::Id menu_memory = 0x70726d6d656e75ULL;

/// One row while it is built.
class RowBuilder {
  public:
    RowBuilder(ui::Ui& ui, const Edited& edited, app::Tuning& tuning, std::size_t index, RowName called)
        : ui_(ui),
          listed_apart_(called != RowName::in_section),
          edited_(edited),
          tuning_(tuning),
          index_(index),
          entry_(app::parameters()[index]),
          row_(*entry_.row),
          title_(title_with_group(index)),
          label_(range() ? std::string_view(entry_.range_name) : row_.name) {
        if (called == RowName::with_group) label_ = title_;
        // Two groups may have rows of one name.
        if (called == RowName::without_group) label_ = ui.join({label_, "###", title_});
    }

    ui::Id build() {
        const std::ptrdiff_t before = &ui_.last() - &ui_.parent();
        put();
        const ui::Node* const nodes = &ui_.parent();
        const ui::Id id = nodes[before + 1].id;
        for (const ui::Node* node = nodes + before + 1; node <= &ui_.last(); ++node)
            if (has(node->is, ui::Is::focused)) tuning_.current = index_;
        if (wanted()) {
            go_to_row(ui_, before, tuning_.wanted == index_ ? 0 : 1);
            tuning_.wanted = no_entry;
        }
        if (!has_own_menu()) put_menu(before + 1, id);
        put_fault(index_);
        if (range()) put_fault(entry_.high);
        return id;
    }

  private:
    bool range() const { return entry_.high != no_entry; }
    bool wanted() const {
        return !listed_apart_ && tuning_.wanted != no_entry &&
               (tuning_.wanted == index_ || tuning_.wanted == entry_.high);
    }
    bool has_own_menu() const { return !range() && (row_.kind == Kind::number || row_.kind == Kind::integer); }
    const Preset& preset() const { return edited_.document.preset(); }
    static const Preset& initial() {
        static const Preset defaults;
        return defaults;
    }

    ui::ParamOptions options() const {
        ui::ParamOptions o = param_options(row_);
        const Tuning::Range soft = tuning_.range(index_);
        o.minimum = soft.low, o.maximum = soft.high;
        o.tip = entry_.tip;
        o.locked = tuning_.locked(index_);
        o.favourite = tuning_.favourite(index_);
        return o;
    }

    void put() {
        if (range()) return put_range();
        const Tuning::Range soft = tuning_.range(index_);
        const bool locked = tuning_.locked(index_), favourite = tuning_.favourite(index_);
        ui::ParamActions actions;
        table_row(ui_, edited_, row_, [&entry = entry_](document::Content& c) { return entry.owner(c.preset); },
                  {.name = label_,
                   .step = title_,
                   .tip = entry_.tip,
                   .standard = entry_.owner(initial()),
                   .maximum = soft.high,
                   .minimum = soft.low,
                   .locked = locked,
                   .favourite = favourite,
                   .actions = &actions});
        if (row_.key == "max_extent" && !listed_apart_) reach();
        if (actions.copy_path && ui_.clipboard() != nullptr) ui_.clipboard()->set(entry_.key);
        if (actions.toggle_lock) tuning_.lock(index_, !locked);
        if (actions.toggle_favourite) tuning_.mark_favourite(index_, !favourite);
        if (actions.range) tuning_.set_range(index_, {actions.range->low, actions.range->high});
    }

    /// The extent is that over level tissue; what it lets blood do here depends on the biases.
    void reach() {
        const BloodReach r = blood_reach(preset().bleeding);
        char text[160];
        // Broken by hand: a text that wraps would move the rows below it while a value is dragged.
        const int length =
            std::snprintf(text, sizeof text, "up to %.0f mm level, %.0f downhill,\n%.0f in folds, %.0f down a fold",
                          r.level, r.downhill, r.fold, r.down_fold);
        ui::label(ui_, ui_.copy({text, static_cast<std::size_t>(std::max(length, 0))}),
                  {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
        ui_.last().tip = "At most, mm over the surface, with the lobes of the noise";
    }

    void put_range() {
        const ParameterEntry& upper = app::parameters()[entry_.high];
        double low = entry_.in<double>(preset()), high = upper.in<double>(preset());
        const double standards[] = {entry_.in<double>(tuning_.standard()), upper.in<double>(tuning_.standard())};
        ui::ParamOptions o = options();
        o.tip = ui_.join({entry_.tip, "\n\n", upper.tip});
        const double initials[] = {entry_.in<double>(initial()), upper.in<double>(initial())};
        o.initials = initials;
        const ui::Edit edit = ui::range_param(ui_, label_, low, high, o, standards);
        edited_.document.take(edit, title_, [&](document::Content& c) {
            entry_.in<double>(c.preset) = low;
            upper.in<double>(c.preset) = high;
        });
    }

    /// For rows that are not a single number: a number has a menu of the toolkit with the same items.
    void put_menu(std::ptrdiff_t at, ui::Id id) {
        ui::Node& node = (&ui_.parent())[at];
        node.sense = node.sense | ui::Sense::context;
        bool asked = false;
        glm::vec2 pointer{0};
        ui_.events_of(id, [&](const ui::Event& event) {
            if (event.kind != ui::EventKind::press || event.button != ui::Button::right) return;
            asked = true;
            pointer = event.at;
        });
        ui::Id& menu_of = ui_.memory<MenuOf>(menu_memory).row;
        if (asked) {
            menu_of = id;
            ui::open_menu(ui_, menu_name, {.side = ui::Placement::Side::pointer, .rect = {pointer.x, pointer.y, 0, 0}});
        }
        if (menu_of != id) return;
        if (const ui::Menu menu(ui_, menu_name, ui_.join({label_, " menu"})); menu) put_items();
    }

    void put_items() {
        const bool changed = tuning_.changed(index_) || (range() && tuning_.changed(entry_.high));
        const bool locked = tuning_.locked(index_), favourite = tuning_.favourite(index_);
        ui::Clipboard* const clipboard = ui_.clipboard();
        if (ui::menu_item(ui_, "Reset",
                          {.icon = ui::Icon::reset,
                           .tip = changed ? "Back to the saved value" : "It has the saved value",
                           .enabled = changed}))
            tuning_.reset(index_);
        put_default();
        if (ui::menu_item(ui_, "Copy", {.icon = ui::Icon::copy, .enabled = clipboard != nullptr}))
            clipboard->set(tuning_.copy(index_));
        if (ui::menu_item(ui_, "Paste", {.enabled = clipboard != nullptr})) tuning_.paste(clipboard->get(), index_);
        ui::menu_separator(ui_);
        if (ui::menu_item(ui_, "Copy path", {.enabled = clipboard != nullptr})) clipboard->set(entry_.key);
        if (ui::menu_item(ui_, "Lock", {.icon = ui::Icon::lock, .checked = locked})) {
            tuning_.lock(index_, !locked);
            if (range()) tuning_.lock(entry_.high, !locked);
        }
        if (ui::menu_item(ui_, "Favourite", {.icon = ui::Icon::star, .checked = favourite}))
            tuning_.mark_favourite(index_, !favourite);
    }

    /// The menu item that sets the default value; for a range it sets both ends.
    void put_default() {
        const ParameterEntry* const upper = range() ? &app::parameters()[entry_.high] : nullptr;
        const bool differs =
            !entry_.same(preset(), initial()) || (upper != nullptr && !upper->same(preset(), initial()));
        if (!ui::menu_item(ui_, "Default value",
                           {.shortcut = "Shift+Backspace",
                            .tip = differs ? "What a preset without this value has" : "It has the default value",
                            .enabled = differs}))
            return;
        edited_.document.change("Default of " + std::string(title_), [&](document::Content& c) {
            for (const ParameterEntry* entry : {&entry_, upper})
                if (entry != nullptr) entry->row->set(entry->owner(c.preset), entry->row->get(entry->owner(initial())));
        });
    }

    void put_fault(std::size_t index) {
        const std::string& fault = tuning_.fault(index);
        if (fault.empty()) return;
        const std::string_view key = app::parameters()[index].row->key;
        ui::label(ui_, ui_.join({key, ": ", fault}), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    }

    ui::Ui& ui_;
    bool listed_apart_;  ///< as a favourite: its section has another row of it
    const Edited& edited_;
    Tuning& tuning_;
    std::size_t index_;
    const ParameterEntry& entry_;
    const Parameter& row_;
    std::string_view title_, label_;
};

}  // namespace

ui::Id parameter_row(ui::Ui& ui, const Edited& edited, app::Tuning& tuning, std::size_t entry, RowName called) {
    return RowBuilder(ui, edited, tuning, entry, called).build();
}

std::string_view title_with_group(std::size_t entry) {
    const ParameterEntry& of = app::parameters()[entry];
    return of.high != no_entry ? std::string_view(of.range_title) : std::string_view(of.title);
}

}  // namespace lapfx::panels
