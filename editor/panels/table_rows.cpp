#include "panels/table_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/paths.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/color_field.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/field.h"
#include "ui/widgets/param.h"
#include "ui/widgets/text_field.h"

namespace lapfx::panels {

namespace {

/// What all kinds of rows need.
struct RowBuild {
    ui::Ui& ui;
    app::Editor& editor;
    const Parameter& row;
    const OwnerOf& owner;
    const TableRowOptions& options;

    void* find(document::Content& content) const { return owner(content); }
    /// To read from: a content that is edited through the document alone.
    const void* now() const { return owner(const_cast<document::Content&>(editor.document.content())); }
    std::string_view name() const { return options.name.empty() ? row.name : options.name; }
    std::string_view tip() const { return ui.join({row.help, row.help.empty() ? "" : "\n", ui.copy(row.expected())}); }
    std::string_view step() const { return options.prefix.empty() ? name() : ui.join({options.prefix, ": ", name()}); }
    template <typename T>
    std::optional<T> standard() const {
        if (options.standard == nullptr) return std::nullopt;
        return std::get<T>(row.get(options.standard));
    }
    ui::Edit take(const ui::Edit& edit, const Value& value) const {
        if (edit.changed && !row.check(value).empty()) return edit;  // the field says why already
        editor.document.take(edit, step(), [&](document::Content& content) {
            if (void* const found = find(content)) row.set(found, value);
        });
        return edit;
    }
};

ui::ParamOptions options_of(const RowBuild& b) {
    const Parameter& row = b.row;
    const bool narrower = b.options.maximum > 0;
    ui::ParamOptions options;
    options.minimum = narrower ? b.options.minimum : row.minimum;
    options.maximum = narrower ? b.options.maximum : row.maximum;
    options.hard_minimum = row.minimum, options.hard_maximum = row.maximum;
    options.step = row.step;
    options.unit = row.unit == "degrees" ? "deg" : row.unit;
    options.scale = row.scale == Scale::logarithmic ? ui::ValueScale::logarithmic : ui::ValueScale::linear;
    options.tip = b.tip();
    return options;
}

ui::Edit number_row(const RowBuild& b, double value) {
    ui::ParamOptions options = options_of(b);
    options.standard = b.standard<double>();
    const ui::Edit edit = ui::param(b.ui, b.name(), value, options);
    return b.take(edit, std::clamp(value, b.row.minimum, b.row.maximum));
}

ui::Edit integer_row(const RowBuild& b, int value) {
    ui::ParamOptions options = options_of(b);
    options.integer = true;
    if (const auto standard = b.standard<int>()) options.standard = *standard;
    const ui::Edit edit = ui::param(b.ui, b.name(), value, options);
    return b.take(edit, value);
}

ui::Edit boolean_row(const RowBuild& b, bool value) {
    const ui::Edit edit = ui::checkbox(b.ui, b.name(), value, b.tip());
    return b.take(edit, value);
}

ui::Edit choice_row(const RowBuild& b, int value) {
    const ui::Edit edit = ui::combo(b.ui, b.name(), value, b.row.choices, {.tip = b.tip(), .caption = true});
    return b.take(edit, value);
}

ui::Edit color_row(const RowBuild& b, glm::dvec3 value) {
    const auto code = [](double v) { return static_cast<std::uint8_t>(std::lround(std::clamp(v, 0.0, 1.0) * 255)); };
    ui::Color color{code(value.x), code(value.y), code(value.z), 255};
    const ui::Edit edit = ui::color_field(b.ui, b.name(), color, {.caption = true, .tip = b.tip()});
    return b.take(edit, glm::dvec3(color.r, color.g, color.b) / 255.0);
}

ui::Edit vector_row(const RowBuild& b, glm::dvec3 value) {
    double values[] = {value.x, value.y, value.z};
    std::optional<glm::dvec3> standard = b.standard<glm::dvec3>();
    const double standards[] = {standard ? standard->x : 0, standard ? standard->y : 0, standard ? standard->z : 0};
    const ui::Edit edit = ui::vector_param(b.ui, b.name(), values, options_of(b),
                                           standard ? std::span<const double>(standards) : std::span<const double>{});
    return b.take(edit, glm::clamp(glm::dvec3(values[0], values[1], values[2]), b.row.minimum, b.row.maximum));
}

ui::Edit text_row(const RowBuild& b, std::string value) {
    const ui::Edit edit = ui::text_field(
        b.ui, b.name(), value,
        {.tip = b.tip(), .bytes = static_cast<std::size_t>(std::max(b.row.maximum, 1.0)), .caption = true});
    return b.take(edit, std::move(value));
}

/// The owner is asked for again when the answer comes: rows, tables and the editor outlive the dialog.
void choose_file(const RowBuild& b) {
    ui::FileFilter filter{.name = std::string(b.options.file_kind), .extensions = {}};
    for (const char* extension : b.options.extensions) filter.extensions.emplace_back(extension);
    std::vector<ui::FileFilter> filters;
    if (!filter.extensions.empty()) filters.push_back(std::move(filter));
    b.editor.ask_file({.task = ui::FileTask::open, .title = "Choose a file", .filters = std::move(filters)},
                      [&editor = b.editor, &row = b.row, owner = b.owner,
                       name = std::string(b.step())](const std::vector<std::string>& files) {
                          const std::string path = app::path_for(files.front(), editor.document.scene().folder);
                          editor.document.change(name, [&](document::Content& content) {
                              if (void* const found = owner(content)) row.set(found, path);
                          });
                      });
}

/// Shown, not typed: a file half named would be looked for with every letter.
ui::Edit path_row(const RowBuild& b, std::string value) {
    ui::Ui& ui = b.ui;
    const ui::Row line(ui, {.width = ui::grow(), .gap = 0, .cross = ui::Place::center});
    ui.push_seed(b.name());
    {
        const ui::Row caption(ui, {.width = ui::fraction(ui::caption_share), .gap = 0});
        ui::space(ui, ui::caption_inset);
        ui::label(ui, b.name(), {.width = ui::grow()});
    }
    ui::text_field(ui, "File", value, {.placeholder = "none", .tip = b.tip(), .read_only = true});
    ui::space(ui, 0.2F);
    ui::Edit edit;
    if (!b.row.required && !value.empty() && ui::icon_button(ui, ui::Icon::cross, "None", {.quiet = true})) {
        value.clear();
        edit = ui::Edit::once();
    }
    if (ui::icon_button(ui, ui::Icon::folder, "Choose...", {.tip = "Choose a file", .quiet = true})) {
        choose_file(b);
    }
    ui.pop_seed();
    return b.take(edit, std::move(value));
}

}  // namespace

ui::Edit table_row(ui::Ui& ui, app::Editor& editor, const Parameter& row, const OwnerOf& owner,
                   const TableRowOptions& options) {
    const RowBuild b{ui, editor, row, owner, options};
    const void* const now = b.now();
    if (now == nullptr) return {};
    Value value = row.get(now);
    switch (row.kind) {
        case Kind::number:
            return number_row(b, std::get<double>(value));
        case Kind::integer:
            return integer_row(b, std::get<int>(value));
        case Kind::boolean:
            return boolean_row(b, std::get<bool>(value));
        case Kind::choice:
            return choice_row(b, std::get<int>(value));
        case Kind::color:
            return color_row(b, std::get<glm::dvec3>(value));
        case Kind::vector:
            return vector_row(b, std::get<glm::dvec3>(value));
        case Kind::text:
            return text_row(b, std::get<std::string>(std::move(value)));
        case Kind::path:
            return path_row(b, std::get<std::string>(std::move(value)));
    }
    return {};
}

ui::Edit table_rows(ui::Ui& ui, app::Editor& editor, const Table& table, const OwnerOf& owner,
                    const TableRowOptions& options) {
    ui::Edit edit;
    for (const Parameter& row : table.rows) edit |= table_row(ui, editor, row, owner, options);
    return edit;
}

}  // namespace lapfx::panels
