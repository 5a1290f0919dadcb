// The scene on which the preset is seen: rows from the scene's table, with what is wrong below each.
#include <algorithm>

#include "app/base/file_filters.h"
#include "app/base/paths.h"
#include "app/measure/measuring.h"
#include "app/preview/orbit.h"
#include "app/preview/preview_host.h"
#include "panels/missing_texture.h"
#include "panels/panels.h"
#include "panels/table_rows.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/scroll.h"
#include "ui/widgets/section.h"

namespace lapfx::panels {

namespace {

using document::Content;

/// Faults are looked for once per version of the document, not in every frame.
struct SceneFaults {
    std::uint64_t version = 0;
    std::vector<Fault> all;
};

const Scene& standard_scene() {
    static const Scene standard;
    return standard;
}

void* scene_of(Content& c) {
    return &c.scene;
}

class ScenePanel {
  public:
    ScenePanel(ui::Ui& ui, const Edited& edited, const app::PreviewHost& preview, ui::CommandTable& commands)
        : ui_(ui),
          edited_(edited),
          preview_(preview),
          commands_(commands),
          faults_(ui.memory<SceneFaults>(ui.id_of("scene faults"))) {
        if (edited.document.scene_changes_since(faults_.version) != 0) faults_.all = edited.document.scene_faults();
        faults_.version = edited.document.version();
    }

    void build() {
        const ui::ScrollArea area(ui_, "Scene rows", {.gap = 0.3F, .padding = 0.6F});
        rows_of_scene();
        if (const ui::Section section(ui_, "Organ", options("organ")); section) organ();
        if (const ui::Section section(ui_, "Tool", options("tool")); section) tool();
        if (const ui::Section section(ui_, "Camera", options("camera")); section) camera();
        if (const ui::Section section(ui_, "Light", options("light")); section) light();
        if (const ui::Section section(ui_, "Reference", options("reference")); section) reference();
        if (const ui::Section section(ui_, "Plate", options("plate")); section) plate();
    }

  private:
    ui::SectionOptions options(std::string_view key) {
        const Parameter* const wanted = wanted_row(ui_);
        const auto& rows = table(key).rows;
        const bool here = std::any_of(rows.begin(), rows.end(), [&](const Parameter& row) { return &row == wanted; });
        return {.unfold = here, .tip = table(key).help};
    }
    static const Table& table(std::string_view key) { return *scene_table().find(key); }

    void row(const Table& table, std::string_view key, const OwnerOf& owner, TableRowOptions options = {}) {
        table_row(ui_, edited_, *table.find_row(key), owner, options);
        const std::string_view place = table.key.empty() ? ui_.join({"/", key}) : ui_.join({"/", table.key, "/", key});
        for (const Fault& fault : faults_.all)
            if (fault.place == place) ui::label(ui_, fault.reason, {.tone = ui::Tone::error, .wrap = true});
    }

    void inner_rows(const Table& outer, const Table& inner, const OwnerOf& owner, const TableRowOptions& options) {
        for (const Parameter& parameter : inner.rows) {
            table_row(ui_, edited_, parameter, owner, options);
            const std::string_view place = ui_.join({"/", outer.key, "/", inner.key, "/", parameter.key});
            for (const Fault& fault : faults_.all)
                if (fault.place == place) ui::label(ui_, fault.reason, {.tone = ui::Tone::error, .wrap = true});
        }
    }

    void rows_of_scene() {
        const Table& t = scene_table();
        row(t, "name", scene_of);
        row(t, "duration", scene_of, {.standard = &standard_scene(), .maximum = 60, .minimum = 0.1});
        row(t, "seed", scene_of, {.standard = &standard_scene(), .maximum = 100});
        row(t, "gravity", scene_of, {.standard = &standard_scene(), .maximum = 1, .minimum = -1});
    }

    void organ() {
        const OwnerOf owner = [](Content& c) -> void* { return &c.scene.organ; };
        const Table& t = table("organ");
        if (ui::button(ui_, "Load organ...",
                       {.icon = ui::Icon::folder, .tip = "Use another surface, with its unit and orientation"}))
            commands_.run("file.load_organ");
        const TableRowOptions options{.prefix = "Organ", .standard = &standard_scene().organ};
        if (edited_.document.scene().organ.file.empty()) {
            ui::label(ui_, "No organ yet: load one, or drop a mesh on the window.",
                      {.tone = ui::Tone::dim, .wrap = true});
            return;
        }
        ui::label(ui_, edited_.document.scene().organ.file, {.tone = ui::Tone::dim});
        static const ui::FileFilter pictures = app::picture_filter();
        row(t, "texture", owner, {.prefix = "Organ", .standard = options.standard, .files = &pictures});
        texture_notice(ui_, edited_, preview_);
        row(t, "scale", owner, {.prefix = "Organ", .standard = options.standard, .maximum = 1000});
        row(t, "rotation", owner, {.prefix = "Organ", .standard = options.standard, .maximum = 180, .minimum = -180});
        row(t, "color", owner, options);
    }

    void tool() {
        const OwnerOf owner = [](Content& c) -> void* { return &c.scene.tool; };
        const Table& t = table("tool");
        static const ui::FileFilter meshes = app::mesh_filter();
        row(t, "file", owner, {.prefix = "Tool", .files = &meshes});
        if (edited_.document.scene().tool.file.empty()) return;
        row(t, "scale", owner, {.prefix = "Tool", .standard = &standard_scene().tool, .maximum = 1000});
        row(t, "port", owner, {.prefix = "Tool", .standard = &standard_scene().tool, .maximum = 300, .minimum = -300});
    }

    void camera() {
        const OwnerOf owner = [](Content& c) -> void* { return &c.scene.camera; };
        const Table& t = table("camera");
        const SceneCamera& standard = standard_scene().camera;
        ui::command_button(ui_, commands_, "view.use_view");
        row(t, "eye", owner, {.prefix = "Camera", .maximum = 300, .minimum = -300});
        row(t, "target", owner, {.prefix = "Camera", .maximum = 300, .minimum = -300});
        row(t, "up", owner, {.prefix = "Camera", .standard = &standard, .maximum = 1, .minimum = -1});
        row(t, "field_of_view", owner, {.prefix = "Camera", .standard = &standard, .maximum = 110, .minimum = 20});
        row(t, "exposure", owner, {.prefix = "Camera", .standard = &standard, .maximum = 10, .minimum = 0.1});
        row(t, "vignette", owner, {.prefix = "Camera", .standard = &standard});
        row(t, "white_balance", owner, {.prefix = "Camera", .standard = &standard, .maximum = 2});
        for (const char* key : {"sharpening", "saturation", "lens_falloff", "curve", "toe", "knee"})
            row(t, key, owner, {.prefix = "Camera", .standard = &standard});
        row(t, "white", owner, {.prefix = "Camera", .standard = &standard, .maximum = 8});
    }

    void light() {
        const OwnerOf owner = [](Content& c) -> void* { return &c.scene.light; };
        const Table& t = table("light");
        const SceneLight& standard = standard_scene().light;
        row(t, "intensity", owner, {.prefix = "Light", .standard = &standard, .maximum = 4});
        row(t, "focus_distance", owner, {.prefix = "Light", .standard = &standard, .maximum = 300, .minimum = 10});
        row(t, "beam_angle", owner, {.prefix = "Light", .standard = &standard});
        row(t, "color", owner, {.prefix = "Light", .standard = &standard});
    }

    void reference() {
        const OwnerOf owner = [](Content& c) -> void* { return &c.scene.reference; };
        const Table& t = table("reference");
        const std::string& file = edited_.document.scene().reference.file;
        ui::label(ui_, file.empty() ? std::string_view("No reference yet.") : file, {.tone = ui::Tone::dim});
        row(t, "offset", owner,
            {.prefix = "Reference", .standard = &standard_scene().reference, .maximum = 60, .minimum = -60});
        row(t, "aspect", owner, {.prefix = "Reference", .standard = &standard_scene().reference, .maximum = 4});
        const SceneReference& standard = standard_scene().reference;
        inner_rows(t, *t.find("marks"), [](Content& c) -> void* { return &c.scene.reference.marks; },
                   {.prefix = "Reference", .standard = &standard.marks, .maximum = 60, .minimum = -1});
        inner_rows(t, *t.find("loop"), [](Content& c) -> void* { return &c.scene.reference.loop; },
                   {.prefix = "Reference loop", .standard = &standard.loop, .maximum = 60});
        inner_rows(t, *t.find("placement"), [](Content& c) -> void* { return &c.scene.reference.placement; },
                   {.prefix = "Place the reference", .standard = &standard.placement});
    }

    void plate() {
        const OwnerOf owner = [](Content& c) -> void* { return &c.scene.plate; };
        const Table& t = table("plate");
        const TableRowOptions options{.prefix = "Plate", .standard = &standard_scene().plate};
        row(t, "use", owner, options);
        row(t, "frame", owner, options);
        row(t, "time", owner, {.prefix = "Plate", .standard = options.standard, .maximum = 60});
        row(t, "frames", owner, options);
        row(t, "span", owner, {.prefix = "Plate", .standard = options.standard, .maximum = 10});
        row(t, "depth", owner, options);
        row(t, "distance", owner, {.prefix = "Plate", .standard = options.standard, .maximum = 300});
    }

    ui::Ui& ui_;
    const Edited& edited_;
    const app::PreviewHost& preview_;
    ui::CommandTable& commands_;
    SceneFaults& faults_;
};

}  // namespace

void scene_panel(ui::Ui& ui, const Edited& edited, const app::PreviewHost& preview, ui::CommandTable& commands,
                 ui::Toasts& toasts) {
    ScenePanel(ui, edited, preview, commands).build();
    const Parameter*& wanted = wanted_row(ui);
    if (wanted == nullptr || has_row(app::measure_table(), wanted)) return;  // the Measure panel has those
    toasts.add({.text = std::string(wanted->name) + " is not shown yet: load an organ or a tool first"});
    wanted = nullptr;
}

}  // namespace lapfx::panels
