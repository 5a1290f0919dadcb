#include "panels/missing_texture.h"

#include "app/base/file_filters.h"
#include "app/base/paths.h"
#include "app/files/likely_texture.h"
#include "app/preview/preview_host.h"
#include "lapfx/prepared_organ.h"
#include "ui/core/node.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

namespace {

/// Of the organ that is shown; folders are not read in every frame.
struct Known {
    std::uint64_t version = 0;  ///< PreviewHost::organ_version
    std::string file;           ///< of the organ
    std::optional<app::MissingTexture> found;
    bool left = false;  ///< the box over the view was closed
};
constexpr ui::Id known_id = 0x6d69737374657874ULL;

const app::MissingTexture* missing_in(ui::Ui& ui, const Edited& edited, const app::PreviewHost& preview) {
    const Scene& scene = edited.document.scene();
    Known& known = ui.memory<Known>(known_id);
    if (known.version != preview.organ_version() || known.file != scene.organ.file) {
        const bool another = known.file != scene.organ.file;
        known = {
            .version = preview.organ_version(), .file = scene.organ.file, .found = {}, .left = known.left && !another};
        if (const auto organ = preview.organ_of(scene))
            known.found = app::missing_texture(organ->organ(), scene.organ.file);
    }
    return known.found && scene.organ.texture.empty() ? &*known.found : nullptr;
}

void use(document::Document& document, const std::filesystem::path& picture) {
    document.change("Organ: Texture", [&](document::Content& c) {
        c.scene.organ.texture = app::path_for(picture.string(), c.scene.folder);
    });
}

void use_button(ui::Ui& ui, const Edited& edited, const app::MissingTexture& m) {
    if (likely_texture_button(ui, m)) use(edited.document, *m.likely);
}

/// Where no picture near by may be meant.
void choose_button(ui::Ui& ui, const Edited& edited) {
    if (!ui::button(ui, "Choose...", {.tip = "Choose a picture as the organ's texture"})) return;
    edited.chooser.ask(
        {.task = ui::FileTask::open, .title = "Choose a file", .filters = {app::picture_filter()}},
        [&document = edited.document](const std::vector<std::string>& files) { use(document, files.front()); });
}

void told(ui::Ui& ui, const app::MissingTexture& m, ui::Size width) {
    ui::label(ui, ui.join({ui.copy(app::words_of(m)), ": it is shown without one."}),
              {.tone = ui::Tone::warning, .wrap = true, .width = width});
}

}  // namespace

bool likely_texture_button(ui::Ui& ui, const app::MissingTexture& missing) {
    return ui::button(ui, ui.copy(app::offer_of(missing)), {.tip = ui.copy(missing.likely->string())});
}

void texture_notice(ui::Ui& ui, const Edited& edited, const app::PreviewHost& preview) {
    const app::MissingTexture* const m = missing_in(ui, edited, preview);
    if (m == nullptr) return;
    told(ui, *m, ui::grow());
    if (m->likely) use_button(ui, edited, *m);
}

void texture_box(ui::Ui& ui, const Edited& edited, const app::PreviewHost& preview, ui::Size width) {
    const app::MissingTexture* const m = missing_in(ui, edited, preview);
    bool& left = ui.memory<Known>(known_id).left;
    if (m == nullptr || left || edited.document.scene().plate.use) return;
    const ui::Panel panel(ui, "Missing texture", {.width = width, .height = ui::fit(), .padding = 0.6F});
    ui.parent().placed = true;
    ui.parent().placement =
        ui.arena().make(ui::Placement{.fraction = {0.5F, 0}, .offset = {0, ui.em(0.6F)}, .pivot = {0.5F, 0}});
    told(ui, *m, ui::grow());
    const ui::Row row(ui);
    if (m->likely)
        use_button(ui, edited, *m);
    else
        choose_button(ui, edited);
    if (ui::button(ui, "Leave it", {.tip = "The Scene panel tells it, too", .quiet = true})) left = true;
}

}  // namespace lapfx::panels
