#include "panels/table_rows.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <unordered_map>

#include "app/base/paths.h"
#include "app/tuning/parameter_text.h"
#include "app/tuning/parameters.h"
#include "document/tables.h"
#include "ui/canvas/pixels.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/color_field.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/field.h"
#include "ui/widgets/param.h"
#include "ui/widgets/text_field.h"

namespace lapfx::panels {

namespace {

constexpr std::size_t most_segments = 3;

struct NameLook {
    std::string_view text;
    bool changed, locked;
    friend bool operator==(const NameLook&, const NameLook&) = default;
};

/// Looks like the label of a number.
void draw_name(ui::Painter& painter, const ui::Node& node, const NameLook& look) {
    const ui::Theme& t = painter.theme();
    ui::Rect column = node.rect();
    column.cut_left(painter.em(ui::caption_inset));
    const ui::Rect dot = column.cut_right(painter.em(0.9F)).inset(painter.em(0.1F), 0);
    if (look.changed) painter.icon(dot, ui::Icon::dot, t.accent);
    if (look.locked) painter.icon(column.cut_right(painter.em(0.9F)), ui::Icon::lock, t.text_dim);
    painter.text(column, look.text, painter.text_style(), t.text);
}

/// A text as its field shows it, even where it cannot be stored.
struct TextShown {
    std::string text, stored;
};

/// One row while it is built.
struct RowBuild {
    ui::Ui& ui;
    const Edited& edited;
    const Parameter& row;
    const OwnerOf& owner;
    const TableRowOptions& options;
    const void* saved;  ///< a struct like the owner; null: nothing to go back to

    void* find(document::Content& content) const { return owner(content); }
    /// To read from: the content is changed only through the document.
    const void* now() const { return owner(const_cast<document::Content&>(edited.document.content())); }
    template <typename T>
    const T& in(const void* of) const {
        return *static_cast<const T*>(row.member(const_cast<void*>(of)));  // only an address is taken
    }
    template <typename T>
    const T& value() const {
        return in<T>(now());
    }
    bool is_text() const { return row.kind == Kind::text || row.kind == Kind::path; }
    bool changed() const { return saved != nullptr && differs(saved); }
    bool differs(const void* from) const {
        if (is_text()) return value<std::string>() != in<std::string>(from);
        return row.get(now()) != row.get(from);
    }
    std::string_view name() const { return options.name.empty() ? row.name : options.name; }
    std::string_view tip() const { return options.tip.empty() ? tip_of(row) : options.tip; }
    std::string_view step() const {
        if (!options.step.empty()) return options.step;
        return options.prefix.empty() ? name() : ui.join({options.prefix, ": ", name()});
    }
    /// A value that is not allowed is not taken; the field says why.
    ui::Edit take(ui::Edit edit, const Value& next) const {
        if (edit.changed && !row.check(next).empty()) edit.changed = false;
        edited.document.take(edit, step(), [&](document::Content& content) {
            if (void* const found = find(content)) row.set(found, next);
        });
        return edit;
    }
    void reset_to(const void* from) const {
        if (from == nullptr || !differs(from)) return;
        const Value standard = row.get(from);
        if (!row.check(standard).empty()) return;
        edited.document.change("Reset " + std::string(step()), [&](document::Content& content) {
            if (void* const found = find(content)) row.set(found, standard);
        });
    }
};

ui::ParamOptions options_of(const RowBuild& b) {
    ui::ParamOptions options = param_options(b.row);
    if (b.options.maximum > b.options.minimum) options.minimum = b.options.minimum, options.maximum = b.options.maximum;
    options.tip = b.tip();
    options.locked = b.options.locked;
    options.favourite = b.options.favourite;
    return options;
}

template <typename T>
ui::Edit number_row(const RowBuild& b) {
    T value = b.value<T>();
    ui::ParamOptions options = options_of(b);
    if (b.saved != nullptr) options.standard = b.in<T>(b.saved);
    if (b.options.standard != nullptr) options.initial = b.in<T>(b.options.standard);
    const ui::Edit edit = ui::param(b.ui, b.name(), value, options, b.options.actions);
    return b.take(edit, value);
}

/// The letters in front of the numbers.
std::string_view letters_of(const Parameter& row) {
    return row.key == "extinction" ? "RGB" : "XYZ";
}

ui::Edit vector_row(const RowBuild& b) {
    glm::dvec3 value = b.value<glm::dvec3>();
    std::span<const double> standards;
    if (b.saved != nullptr) standards = std::span(&b.in<glm::dvec3>(b.saved)[0], 3);
    ui::ParamOptions options = options_of(b);
    if (b.options.standard != nullptr) options.initials = std::span(&b.in<glm::dvec3>(b.options.standard)[0], 3);
    const ui::Edit edit =
        ui::vector_param(b.ui, b.name(), std::span(&value[0], 3), options, standards, letters_of(b.row));
    return b.take(edit, value);
}

ui::Edit boolean_field(const RowBuild& b) {
    bool on = b.value<bool>();
    const ui::Edit edit = ui::checkbox(b.ui, "On", on, b.tip());
    return b.take(edit, on);
}

ui::Edit choice_field(const RowBuild& b) {
    int chosen = std::get<int>(b.row.get(b.now()));
    const ui::Edit edit = b.row.choices.size() <= most_segments
                              ? ui::segmented(b.ui, "Choice", chosen, b.row.choices)
                              : ui::combo(b.ui, "Choice", chosen, b.row.choices, {.tip = b.tip()});
    return b.take(edit, chosen);
}

glm::dvec3 vector_of(ui::Color color) {
    return glm::dvec3(color.r, color.g, color.b) / 255.0;
}

/// The lamp's colour is what white looks like, and that of vessels is looked for in the organ's own picture: no light
/// falls on them.
bool is_seen_as_it_is(const Parameter& row) {
    return row.key == "vessel_color" || &row == scene_table().find("light")->find_row("color");
}

/// The colour for the field with which the picture shows the one that was picked.
ui::Color as_seen(const RowBuild& b, ui::Color picked) {
    const glm::dvec3 solved = b.edited.seen.solve(b.step(), vector_of(picked), b.value<glm::dvec3>(),
                                                  [&](document::Content& content, const glm::dvec3& color) {
                                                      if (void* const found = b.find(content)) b.row.set(found, color);
                                                  });
    return ui::color_of(glm::vec4(255.0 * solved, 255.0));
}

ui::Edit color_field(const RowBuild& b) {
    const glm::dvec3& value = b.value<glm::dvec3>();
    const auto code = [&](int i) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(value[i], 0.0, 1.0) * 255));
    };
    ui::Color color{code(0), code(1), code(2), 255};
    // The key colour is picked in the Keying panel, because the key is compared with pixels of the clip itself.
    ui::Eyedropper* const dropper = b.row.key == "key_color" ? nullptr : &b.edited.eyedropper;
    const std::function<ui::Color(ui::Color)> solve = [&b](ui::Color picked) { return as_seen(b, picked); };
    const ui::Edit edit = ui::color_field(
        b.ui, "Colour", color,
        {.tip = b.tip(), .eyedropper = dropper, .picked_as = is_seen_as_it_is(b.row) ? nullptr : &solve});
    return b.take(edit, vector_of(color));
}

ui::Edit text_field(const RowBuild& b) {
    TextShown& shown = b.ui.memory<TextShown>(b.ui.id_of("Text"));
    if (const std::string& now = b.value<std::string>(); now != shown.stored) shown.text = shown.stored = now;
    const ui::Edit edit =
        ui::text_field(b.ui, "Text", shown.text,
                       {.tip = b.tip(), .bytes = 4 * static_cast<std::size_t>(std::max(b.row.maximum, 1.0))});
    if (!edit.began && !edit.changed && !edit.committed && !edit.cancelled) return edit;
    const ui::Edit taken = b.take(edit, shown.text);
    if (edit.committed || edit.cancelled) shown.text = b.value<std::string>();  // drops what could not be stored
    return taken;
}

/// When the answer comes the owner is looked up again; rows, tables and the document outlive the dialog.
void choose_file(const RowBuild& b) {
    std::vector<ui::FileFilter> filters;
    if (b.options.files != nullptr) filters.push_back(*b.options.files);
    b.edited.chooser.ask({.task = ui::FileTask::open, .title = "Choose a file", .filters = std::move(filters)},
                         [&document = b.edited.document, &row = b.row, owner = b.owner,
                          name = std::string(b.step())](const std::vector<std::string>& files) {
                             const std::string path = app::path_for(files.front(), document.scene().folder);
                             document.change(name, [&](document::Content& content) {
                                 if (void* const found = owner(content)) row.set(found, path);
                             });
                         });
}

/// The path cannot be typed, because every letter would look for another file.
ui::Edit path_field(const RowBuild& b) {
    ui::Ui& ui = b.ui;
    TextShown& shown = ui.memory<TextShown>(ui.id_of("File"));
    shown.text = b.value<std::string>();
    ui::text_field(ui, "File", shown.text, {.placeholder = "none", .tip = b.tip(), .read_only = true, .path = true});
    ui::space(ui, 0.2F);
    ui::Edit edit;
    if (!b.row.required && !shown.text.empty() &&
        ui::icon_button(ui, ui::Icon::cross, "None", {.tip = "Without a file", .quiet = true}))
        edit = ui::Edit::once();
    if (ui::icon_button(ui, ui::Icon::folder, "Choose...", {.tip = "Choose a file", .quiet = true})) choose_file(b);
    if (!edit.changed) return edit;
    return b.take(edit, std::string());
}

ui::Edit field(const RowBuild& b) {
    switch (b.row.kind) {
        case Kind::color:
            return color_field(b);
        case Kind::choice:
            return choice_field(b);
        case Kind::boolean:
            return boolean_field(b);
        case Kind::path:
            return path_field(b);
        default:
            return text_field(b);
    }
}

/// Takes Backspace from the field that has the keyboard; a field of text keeps it.
void take_resets(const RowBuild& b, ui::Node& node) {
    if (b.is_text() || (b.saved == nullptr && b.options.standard == nullptr)) return;
    node.sense = node.sense | ui::Sense::erase;
    b.ui.events_of(node.id, [&](const ui::Event& event) {
        if (event.kind != ui::EventKind::key || event.key != ui::Key::backspace) return;
        b.reset_to(has(event.mods, ui::Mods::shift) ? b.options.standard : b.saved);
    });
}

/// Name and field, for what has no label with a dot and a lock of its own.
ui::Edit field_row(const RowBuild& b) {
    ui::Ui& ui = b.ui;
    ui::Node& node = ui.open(ui::Role::group, b.name(), ui::Axis::x, ui::Sense::hover);
    node.size[0] = ui::grow();
    node.size[1] = ui::px(ui.row_height());
    node.minimum[0] = ui.em(9);
    node.cross = ui::ChildAlign::center;
    node.tip = b.tip();
    const bool changed = b.changed();
    node.is |= when(changed, ui::Is::changed) | when(b.options.locked, ui::Is::locked);
    const std::string_view shown = node.shown;
    ui.respond(node);
    ui::Node& name = ui.leaf(ui::Role::label, "##name", ui::Sense::hover | ui::Sense::press);
    name.size[0] = ui::fraction(ui::caption_share);
    name.size[1] = ui::grow();
    name.tip = b.tip();
    const ui::Response r = ui.respond(name);
    ui.draw_with<draw_name>(name, NameLook{shown, changed, b.options.locked});
    const std::ptrdiff_t before = &ui.last() - &ui.parent();
    const ui::Edit edit = field(b);
    take_resets(b, (&ui.parent())[before + 1]);
    if (r.pressed && r.clicks == 2) b.reset_to(b.saved);
    ui.close();
    return edit;
}

ui::Edit any_row(const RowBuild& b) {
    switch (b.row.kind) {
        case Kind::number:
            return number_row<double>(b);
        case Kind::integer:
            return number_row<int>(b);
        case Kind::vector:
            return vector_row(b);
        default:
            return field_row(b);
    }
}

}  // namespace

std::string_view tip_of(const Parameter& row) {
    static std::unordered_map<const Parameter*, std::string> tips;
    std::string& tip = tips[&row];
    if (tip.empty()) tip = app::tip_text(row);
    return tip;
}

ui::ParamOptions param_options(const Parameter& row) {
    ui::ParamOptions options;
    options.minimum = options.hard_minimum = row.minimum;
    options.maximum = options.hard_maximum = row.maximum;
    options.step = row.step;
    options.unit = row.unit == "degrees" ? "deg" : row.unit;
    options.zero = app::meaning_of_zero(row);
    options.scale = row.scale == Scale::logarithmic ? ui::ValueScale::logarithmic : ui::ValueScale::linear;
    options.tip = tip_of(row);
    return options;
}

ui::Edit table_row(ui::Ui& ui, const Edited& edited, const Parameter& row, const OwnerOf& owner,
                   const TableRowOptions& options) {
    const void* saved = options.saved;
    if (saved == nullptr) saved = owner(const_cast<document::Content&>(edited.saved.content()));  // only read
    const RowBuild b{ui, edited, row, owner, options, saved};
    if (b.now() == nullptr) return {};
    const std::ptrdiff_t before = &ui.last() - &ui.parent();
    const ui::Edit edit = any_row(b);
    if (wanted_row(ui) == &row) {
        wanted_row(ui) = nullptr;
        go_to_row(ui, before);
    }
    return edit;
}

const Parameter*& wanted_row(ui::Ui& ui) {
    return ui.memory<const Parameter*>(ui::hash_bytes(0, "wanted row"));
}

bool has_row(const Table& table, const Parameter* row) {
    for (const Parameter& each : table.rows)
        if (&each == row) return true;
    return std::any_of(table.tables.begin(), table.tables.end(), [&](const Table& t) { return has_row(t, row); });
}

void go_to_row(ui::Ui& ui, std::ptrdiff_t before, int nth) {
    const ui::Node* const nodes = &ui.parent();
    ui::Id id = 0;
    for (const ui::Node* node = nodes + before + 1; node <= &ui.last() && nth >= 0; ++node)
        if (has(node->sense, ui::Sense::focus)) id = node->id, --nth;
    if (id == 0) return;
    ui.set_focus(id, true);
    ui.reveal(id);
}

ui::Edit table_rows(ui::Ui& ui, const Edited& edited, const Table& table, const OwnerOf& owner,
                    const TableRowOptions& options) {
    ui::Edit edit;
    for (const Parameter& row : table.rows) edit |= table_row(ui, edited, row, owner, options);
    return edit;
}

}  // namespace lapfx::panels
