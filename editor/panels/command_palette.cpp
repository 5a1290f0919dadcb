// Ctrl+P: commands, and the parameters of preset and scene, from their tables; the same words find them as in the
// Preset panel.
#include "app/base/layouts.h"
#include "app/tuning/parameters.h"
#include "app/tuning/tuning.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/table_rows.h"
#include "ui/shell/palette.h"

namespace lapfx::panels {

namespace {

/// What the palette lists beside commands: the preset's parameters in their order, then rows of the scene.
class Rows {
  public:
    Rows() {
        for (const app::ParameterEntry& entry : app::parameters().entries())
            items_.push_back({.title = entry.key == entry.row->key ? "Preset: " + entry.title : entry.title,
                              .note = entry.key,
                              .words = entry.words,
                              .tip = entry.tip});
        add(scene_table(), "Scene", "scene");
    }
    std::span<const ui::PaletteItem> items() const { return items_; }
    /// The panel with the row.
    std::string_view panel(std::size_t item) const {
        if (item < app::parameters().entries().size()) return "Preset";
        return items_[item].note.starts_with("scene.reference.measure.") ? "Measure" : "Scene";
    }
    const Parameter& scene_row(std::size_t item) const {
        return *scene_rows_[item - app::parameters().entries().size()];
    }

  private:
    void add(const Table& table, const std::string& name, const std::string& key) {
        for (const Parameter& row : table.rows) {
            if (row.kind == Kind::path && table.key != "tool") continue;  // loaded by commands, which are listed
            const std::string title = name + ": " + std::string(row.name), path = key + '.' + std::string(row.key);
            items_.push_back({.title = title,
                              .note = path,
                              .words = app::search_words(title, path, row.help),
                              .tip = std::string(tip_of(row))});
            scene_rows_.push_back(&row);
        }
        for (const Table& child : table.tables)
            if (child.list == nullptr) add(child, std::string(child.name), key + '.' + std::string(child.key));
    }

    std::vector<ui::PaletteItem> items_;
    std::vector<const Parameter*> scene_rows_;
};

}  // namespace

void command_palette(ui::Ui& ui, ui::CommandTable& commands, app::Layouts& layouts, app::Tuning& tuning) {
    static const Rows rows;
    ui::palette(ui, commands, rows.items(), [&](std::size_t item) {
        const bool of_preset = item < app::parameters().entries().size();
        layouts.bring_to_front(rows.panel(item));
        if (of_preset)
            tuning.want(item);
        else
            wanted_row(ui) = &rows.scene_row(item);
        ui.build_again();
    });
}

}  // namespace lapfx::panels
