#include "panels/preset_rows.h"

#include <algorithm>
#include <cmath>

#include "app/tuning.h"
#include "ui/shell/menu.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/color_field.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/field.h"
#include "ui/widgets/param.h"
#include "ui/widgets/text_field.h"

namespace lapfx::panels {

namespace {

using app::no_entry;
using app::ParameterEntry;
using app::Tuning;

constexpr std::string_view menu_name = "parameter menu";
constexpr std::size_t most_segments = 3;

/// Which row's menu is open: a favourite has two rows.
struct MenuOf {
    ui::Id row = 0;
};
constexpr ui::Id menu_memory = 0x70726d6d656e75ULL;

struct NameLook {
    std::string_view text;
    bool changed, locked;
    friend bool operator==(const NameLook&, const NameLook&) = default;
};

/// As the labels of numbers are.
void draw_name(ui::Painter& painter, const ui::Node& node, const NameLook& look) {
    const ui::Theme& t = painter.theme();
    ui::Rect column = node.rect();
    column.cut_left(painter.em(ui::caption_inset));
    const ui::Rect dot = column.cut_right(painter.em(0.9F)).inset(painter.em(0.1F), 0);
    if (look.changed) painter.icon(dot, ui::Icon::dot, t.accent);
    if (look.locked) painter.icon(column.cut_right(painter.em(0.9F)), ui::Icon::lock, t.text_dim);
    painter.text(column, look.text, painter.text_style(), t.text);
}

/// One row while it is built.
class RowBuilder {
  public:
    RowBuilder(ui::Ui& ui, app::Editor& editor, std::size_t index, bool with_group)
        : ui_(ui),
          editor_(editor),
          tuning_(editor.tuning()),
          index_(index),
          entry_(app::parameters()[index]),
          row_(*entry_.row),
          title_(range() ? std::string_view(entry_.range_title) : std::string_view(entry_.title)),
          label_(!with_group ? (range() ? std::string_view(entry_.range_name) : row_.name) : title_) {}

    void build() {
        const std::ptrdiff_t before = &ui_.last() - &ui_.parent();
        put();
        const ui::Node* const nodes = &ui_.parent();
        const ui::Id id = nodes[before + 1].id;
        for (const ui::Node* node = nodes + before + 1; node <= &ui_.last(); ++node)
            if (has(node->is, ui::Is::focused)) tuning_.current = index_;
        if (!has_own_menu()) put_menu(before + 1, id);
        put_fault(index_);
        if (range()) put_fault(entry_.high);
    }

  private:
    bool range() const { return entry_.high != no_entry; }
    bool has_own_menu() const { return !range() && (row_.kind == Kind::number || row_.kind == Kind::integer); }
    const Preset& preset() const { return editor_.document.preset(); }
    template <typename T>
    void take(const ui::Edit& edit, const T& value) {
        editor_.document.take(edit, title_, [&](document::Content& c) { entry_.in<T>(c.preset) = value; });
    }

    ui::ParamOptions options() const {
        const Tuning::Range soft = tuning_.range(index_);
        return {.minimum = soft.low,
                .maximum = soft.high,
                .hard_minimum = row_.minimum,
                .hard_maximum = row_.maximum,
                .step = row_.step,
                .unit = row_.unit,
                .scale = row_.scale == Scale::logarithmic ? ui::ValueScale::logarithmic : ui::ValueScale::linear,
                .tip = entry_.tip,
                .locked = tuning_.locked(index_),
                .favourite = tuning_.favourite(index_)};
    }

    void put() {
        if (range()) return put_range();
        switch (row_.kind) {
            case Kind::number:
                return put_number<double>();
            case Kind::integer:
                return put_number<int>();
            case Kind::vector:
                return put_vector();
            default:
                return put_field();
        }
    }

    template <typename T>
    void put_number() {
        T value = entry_.in<T>(preset());
        ui::ParamOptions o = options();
        o.standard = entry_.in<T>(tuning_.standard());
        ui::ParamActions actions;
        const ui::Edit edit = ui::param(ui_, label_, value, o, &actions);
        take(edit, value);
        if (actions.copy_path && ui_.clipboard() != nullptr) ui_.clipboard()->set(entry_.key);
        if (actions.toggle_lock) tuning_.lock(index_, !o.locked);
        if (actions.toggle_favourite) tuning_.mark_favourite(index_, !o.favourite);
        if (actions.range) tuning_.set_range(index_, {actions.range->low, actions.range->high});
    }

    void put_range() {
        const ParameterEntry& upper = app::parameters()[entry_.high];
        double low = entry_.in<double>(preset()), high = upper.in<double>(preset());
        const double standards[] = {entry_.in<double>(tuning_.standard()), upper.in<double>(tuning_.standard())};
        ui::ParamOptions o = options();
        o.tip = ui_.join({entry_.tip, "\n\n", upper.tip});
        const ui::Edit edit = ui::range_param(ui_, label_, low, high, o, standards);
        editor_.document.take(edit, title_, [&](document::Content& c) {
            entry_.in<double>(c.preset) = low;
            upper.in<double>(c.preset) = high;
        });
    }

    void put_vector() {
        glm::dvec3 value = entry_.in<glm::dvec3>(preset());
        const glm::dvec3& standard = entry_.in<glm::dvec3>(tuning_.standard());
        const ui::Edit edit =
            ui::vector_param(ui_, label_, std::span(&value[0], 3), options(), std::span(&standard[0], 3));
        take(edit, value);
    }

    /// Label and field, for what has no label with a dot and a lock of its own.
    void put_field() {
        ui::Node& node = ui_.open(ui::Role::group, label_, ui::Axis::x, ui::Sense::hover);
        node.size[0] = ui::grow();
        node.size[1] = ui::px(ui_.row_height());
        node.minimum[0] = ui_.em(9);
        node.cross = ui::Place::center;
        node.tip = entry_.tip;
        const bool changed = tuning_.changed(index_), locked = tuning_.locked(index_);
        node.is |= when(changed, ui::Is::changed) | when(locked, ui::Is::locked);
        const std::string_view shown = node.shown;
        ui_.respond(node);
        ui::Node& name = ui_.leaf(ui::Role::label, "##name", ui::Sense::hover | ui::Sense::press);
        name.size[0] = ui::fraction(ui::caption_share);
        name.size[1] = ui::grow();
        name.tip = entry_.tip;
        const ui::Response r = ui_.respond(name);
        ui_.draw_with<draw_name>(name, NameLook{shown, changed, locked});
        if (r.pressed && r.clicks == 2) tuning_.reset(index_);
        const std::ptrdiff_t before = &ui_.last() - &ui_.parent();
        put_value();
        take_keys(before + 1);
        ui_.close();
    }

    /// The menu's key and Backspace, from the field, which has the keyboard.
    void take_keys(std::ptrdiff_t at) {
        ui::Node& field = (&ui_.parent())[at];
        if (row_.kind == Kind::text || row_.kind == Kind::path) return;  // these keys are the text's
        field.sense = field.sense | ui::Sense::erase;
        bool reset = false;
        ui_.events_of(field.id, [&](const ui::Event& event) {
            reset |= event.kind == ui::EventKind::key && event.key == ui::Key::backspace;
        });
        if (reset && tuning_.changed(index_)) tuning_.reset(index_);
    }

    void put_value() {
        switch (row_.kind) {
            case Kind::color:
                return put_color();
            case Kind::choice:
                return put_choice();
            case Kind::boolean: {
                bool on = entry_.in<bool>(preset());
                const ui::Edit edit = ui::checkbox(ui_, "On", on, entry_.tip);
                return take(edit, on);
            }
            default: {
                std::string& text = tuning_.text(index_);
                const ui::Edit edit = ui::text_field(
                    ui_, "Text", text, {.tip = entry_.tip, .bytes = 4 * static_cast<std::size_t>(row_.maximum)});
                return take(edit, text);
            }
        }
    }

    void put_color() {
        const glm::dvec3 value = entry_.in<glm::dvec3>(preset());
        const auto code = [&](int i) {
            return static_cast<std::uint8_t>(std::lround(std::clamp(value[i], 0.0, 1.0) * 255));
        };
        ui::Color color{code(0), code(1), code(2), 255};
        const ui::Edit edit = ui::color_field(ui_, "Colour", color, {.tip = entry_.tip});
        take(edit, glm::dvec3(color.r, color.g, color.b) / 255.0);
    }

    void put_choice() {
        int chosen = std::get<int>(row_.get(entry_.owner(preset())));
        const ui::Edit edit = row_.choices.size() <= most_segments
                                  ? ui::segmented(ui_, "Choice", chosen, row_.choices)
                                  : ui::combo(ui_, "Choice", chosen, row_.choices, {.tip = entry_.tip});
        editor_.document.take(edit, title_,
                              [&](document::Content& c) { row_.set(entry_.owner(c.preset), Value(chosen)); });
    }

    /// For rows that are no single number; those have one of the toolkit's with the same items.
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
        if (ui::menu_item(ui_, "Reset", {.icon = ui::Icon::reset, .enabled = changed})) tuning_.reset(index_);
        if (ui::menu_item(ui_, "Copy", {.icon = ui::Icon::copy, .enabled = clipboard != nullptr}))
            clipboard->set(tuning_.copy(index_));
        if (ui::menu_item(ui_, "Paste", {.enabled = clipboard != nullptr})) tuning_.paste(clipboard->get(), index_);
        ui::menu_separator(ui_);
        if (ui::menu_item(ui_, "Copy path", {.enabled = clipboard != nullptr})) clipboard->set(entry_.key);
        if (ui::menu_item(ui_, "Lock for the fit", {.icon = ui::Icon::lock, .checked = locked})) {
            tuning_.lock(index_, !locked);
            if (range()) tuning_.lock(entry_.high, !locked);
        }
        if (ui::menu_item(ui_, "Favourite", {.icon = ui::Icon::star, .checked = favourite}))
            tuning_.mark_favourite(index_, !favourite);
    }

    void put_fault(std::size_t index) {
        const std::string& fault = tuning_.fault(index);
        if (fault.empty()) return;
        const std::string_view key = app::parameters()[index].row->key;
        ui::label(ui_, ui_.join({key, ": ", fault}), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
    }

    ui::Ui& ui_;
    app::Editor& editor_;
    Tuning& tuning_;
    std::size_t index_;
    const ParameterEntry& entry_;
    const Parameter& row_;
    std::string_view title_, label_;
};

}  // namespace

void parameter_row(ui::Ui& ui, app::Editor& editor, std::size_t entry, bool with_group) {
    RowBuilder(ui, editor, entry, with_group).build();
}

}  // namespace lapfx::panels
