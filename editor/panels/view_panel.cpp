// The preview: what the preset looks like on the organ, looked at and worked on with the tool in the hand.
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "app/base/file_filters.h"
#include "app/base/paths.h"
#include "app/clips/clip_shelf.h"
#include "app/editor.h"
#include "app/files/organ_choice.h"
#include "app/preview/events.h"
#include "app/preview/orbit.h"
#include "app/reference/plate.h"
#include "app/reference/reference.h"
#include "document/words.h"
#include "lapfx/authoring/letters.h"
#include "lapfx/authoring/table_walk.h"
#include "panels/band_strip.h"
#include "panels/missing_texture.h"
#include "panels/panels.h"
#include "panels/parts.h"
#include "panels/said_beside.h"
#include "panels/titles.h"
#include "ui/canvas/viewport.h"
#include "ui/core/node.h"
#include "ui/shell/progress.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"
#include "ui/widgets/toolbar.h"

namespace lapfx::panels {

namespace {

using ui::Key;
using ui::Mods;

constexpr float low_window = 18;     // em of height
constexpr float choice_width = 8;    // em
constexpr float bar_padding = 0.3F;  // em
constexpr double work_by_key = 0.5;  // s
constexpr double key_turn = 5.0 * std::numbers::pi / 180;
constexpr double zoom_notch = 1.15;

/// The names of the tools. The first is what the left button does without a tool.
constexpr auto tool_names = [] {
    std::array<std::string_view, 1 + tool_action_count> names{"Look around"};
    for (const ToolActionRow& row : tool_actions) names[1 + static_cast<std::size_t>(row.action)] = row.title;
    return names;
}();

int tool_index(const app::ToolInHand& tool) {
    return tool.action ? 1 + static_cast<int>(*tool.action) : 0;
}

void take_tool(app::ToolHold& hold, app::ToolInHand& tool, int index) {
    if (hold.on()) hold.end();
    tool.action.reset();
    if (index > 0) tool.action = static_cast<ToolAction>(index - 1);
}

/// mm around the tip that the tool works on: a parameter of the preset.
double reach_of(ToolAction action, const Preset& preset) {
    return std::get<double>(value_at(preset_table(), &preset, row_of(action).reach));
}

/// What lies under the pointer; looked for again only when it may have changed.
struct Under {
    glm::vec2 pointer{-1};
    std::uint64_t version = 0;
    glm::dvec3 eye{0}, target{0};
    std::optional<OrganHit> hit;
    TissueSample tissue;
};

enum class Drag : std::uint8_t { none, orbit, pan, tool, fixed };

struct ViewMemory {
    Drag drag = Drag::none;
    SaidBeside said;
    Under under;
};

class ViewPanel {
  public:
    ViewPanel(ui::Ui& ui, const ViewParts& on)
        : ui_(ui), on_(on), memory_(ui.memory<ViewMemory>(ui.id_of("view memory"))) {}

    void build() {
        const float width = ui_.rect_before(ui_.id_of("Preview")).w;
        const ui::Column column(ui_, {.width = ui::grow(), .height = ui::grow(), .gap = 0});
        bar(width);
        band_strip(ui_, on_.looking.overlay, on_.edited, on_.preview, on_.jobs);
        ui::Node& stage = ui_.open(ui::Role::none, {}, ui::Axis::y);
        stage.size[0] = stage.size[1] = ui::grow();
        stage.clips = true;
        const ui::ViewportResult view = ui::viewport(ui_, "Preview", on_.preview.picture());
        const glm::ivec2 wanted = on_.half_resolution ? (view.size + 1) / 2 : view.size;
        if (wanted != on_.preview.size()) {
            on_.preview.resize(wanted);
            ui_.build_again();
        }
        underlay(view);
        look_under(view);
        if (on_.edited.eyedropper.wanted_by != 0) {
            memory_.drag = Drag::none;
            pick_in_view(ui_, view, on_.edited, on_.preview);
        } else {
            work(view);
            keys(view);
            mark(view);
        }
        readout();
        put_said(ui_, memory_.said, view.size);
        solo();
        texture_box(ui_, on_.edited, on_.preview, box_width());
        loading();
        faults();
        pick_hint(ui_, on_.edited.eyedropper);
        ui_.close();
    }

  private:
    // --- above the picture ---
    enum Tools : std::size_t { tool, power, strength, overlay, under, share, endoscope, plate, use, whole, tool_count };

    void bar(float room) {
        const ui::Column padded(ui_, {.width = ui::grow(), .padding = bar_padding});
        room = room > 0 ? std::max(1.0F, room - 2 * ui_.em(bar_padding)) : 0.0F;
        const bool hot = on_.tool.action && row_of(*on_.tool.action).hot;
        const bool cutting = on_.tool.action && divides(*on_.tool.action);
        const float choice = ui_.em(choice_width);
        std::array<ui::ToolItem, tool_count> items;
        items[power] = {.width = hot ? choice : 0, .rank = 1};
        items[strength] = {.width = cutting ? choice : 0, .rank = 1};
        items[overlay] = {.width = choice, .rank = 3, .end = true};
        // In a very low window the menu of tools would not fit: keys and the View menu have these, too.
        const bool low = ui_.window().y < ui_.em(low_window);
        items[under] = {.width = low ? 0 : ui::tool_width(ui_, "Underlay"), .rank = 4};
        items[share] = {.width = shows_underlay() && !low ? choice : 0, .rank = 1};
        items[endoscope] = {.width = ui::tool_width(ui_, "Endoscope view"), .rank = 2};
        const Scene& scene = on_.edited.document.scene();
        const bool has_plate = !low && (scene.plate.use || !scene.reference.file.empty());
        items[plate] = {.width = has_plate ? ui::tool_width(ui_, "Plate") : 0, .rank = 3};
        items[use] = {.width = on_.looking.endoscope ? 0 : ui::tool_width(ui_, "Use view as endoscope"), .rank = 4};
        items[whole] = {.width = ui::tool_width(ui_, "Frame the organ"), .rank = 5};
        // The tools' values have room beside them, shown or not: else the tools would fold up when one is chosen.
        const float values = 2 * choice + ui::tool_width(ui_, "More...");
        const bool in_a_row = room == 0 || tools_width() + values + 4 * ui_.em(ui_.theme().gap) <= room;
        items[tool] = {.width = in_a_row ? tools_width() : choice};
        ui::toolbar(ui_, "View tools", room, items, [&](std::size_t item) { put(item, in_a_row); });
    }

    void put(std::size_t item, bool in_a_row) {
        switch (item) {
            case tool:
                return tool_choice(in_a_row);
            case power:
                return percent_field("Power", on_.tool.power, 100, "Cautery power of the next events");
            case strength:
                return strength_field();
            case overlay:
                return overlay_choice();
            case under:
                ui::command_button(ui_, on_.commands, "view.underlay");
                return;
            case share:
                return percent_field("Underlay share", on_.looking.underlay_share, 50,
                                     "Share of the reference where it is shown over the view");
            case endoscope:
                ui::command_button(ui_, on_.commands, "view.endoscope");
                return;
            case plate:
                ui::command_button(ui_, on_.commands, "view.plate");
                return;
            case use:
                ui::command_button(ui_, on_.commands, "view.use_view");
                return;
            default:
                ui::command_button(ui_, on_.commands, "view.frame");
        }
    }

    float tools_width() {
        float width = 0;
        for (const std::string_view name : tool_names) width += ui_.text_width(name) + ui_.em(1.4F);
        return width;
    }

    void tool_choice(bool in_a_row) {
        int chosen = tool_index(on_.tool);
        if (in_a_row) {
            const ui::Row box(ui_, {.width = ui::px(tools_width())});
            if (ui::segmented(ui_, "Tool", chosen, tool_names)) take_tool(on_.hold, on_.tool, chosen);
        } else if (ui::combo(
                       ui_, "Tool", chosen, tool_names,
                       {.tip = "What the left button does on the organ", .width = ui::px(ui_.em(choice_width))})) {
            take_tool(on_.hold, on_.tool, chosen);
        }
    }

    void overlay_choice() {
        int chosen = static_cast<int>(on_.looking.overlay);
        if (ui::combo(ui_, "Overlay", chosen, overlay_titles(),
                      {.tip = "Colours the organ by vessels, fat or bleeding tendency",
                       .width = ui::px(ui_.em(choice_width))}))
            on_.looking.overlay = static_cast<Overlay>(chosen);
    }

    bool shows_underlay() const { return on_.looking.underlay && on_.reference.video() != nullptr; }

    void percent_field(std::string_view name, double& value, double standard, std::string_view tip) {
        ui::ParamOptions options = ui::percent();
        options.hard_minimum = 0, options.hard_maximum = 100, options.standard = standard;
        options.tip = tip;
        options.width = ui::px(ui_.em(choice_width));
        ui::number_field(ui_, name, value, options);
    }

    void strength_field() {
        ui::number_field(ui_, "Strength", on_.tool.strength,
                         {.maximum = 3,
                          .hard_minimum = 0,
                          .hard_maximum = 10,
                          .step = 0.05,
                          .standard = 1,
                          .tip = "Strength of the next wounds: a factor on the preset's speed",
                          .width = ui::px(ui_.em(choice_width))});
    }

    // --- in the picture ---
    /// How many times as much of the height is seen as the camera's angle of view says: a plate is shown whole in a
    /// view that is narrower than it, too.
    double widened(const ui::ViewportResult& view) const {
        const Scene& scene = on_.edited.document.scene();
        const VideoReader* const video = on_.reference.video();
        const SceneCamera seen = on_.looking.through(scene.camera), &own = scene.camera;
        const bool own_camera = seen.eye == own.eye && seen.target == own.target && seen.up == own.up &&
                                seen.field_of_view == own.field_of_view;
        if (!scene.plate.use || !own_camera || video == nullptr || view.size.x < 1 || !on_.preview.organ_of(scene))
            return 1;
        const glm::dvec2 stored(video->info().size);
        const double aspect = scene.reference.aspect > 0 ? scene.reference.aspect : stored.x / stored.y;
        return std::max(1.0, aspect * view.size.y / view.size.x);
    }

    /// The reference of this time as high as the view, in the middle: at the same angle of view it covers what it
    /// shows.
    void underlay(const ui::ViewportResult& view) {
        if (!shows_underlay()) return;
        on_.reference.follow();
        const ui::Picture picture = on_.reference.shown().placed();
        if (picture.image == 0 || view.size.y < 1) return;
        ui::Node& node = ui_.leaf(ui::Role::image, "Reference picture");
        const float height = std::round(static_cast<float>(view.size.y / widened(view)));
        node.placed = true;
        node.placement = ui_.arena().make(ui::Placement{.fraction = {0.5F, 0.5F}, .pivot = {0.5F, 0.5F}});
        node.size[0] =
            ui::px(std::round(height * static_cast<float>(picture.size.x) / static_cast<float>(picture.size.y)));
        node.size[1] = ui::px(height);
        const double alpha = std::clamp(on_.looking.underlay_share, 0.0, 1.0);
        ui_.draw_with<draw_underlay>(node,
                                     UnderlayLook{picture.image, static_cast<std::uint8_t>(std::lround(255 * alpha))});
    }
    struct UnderlayLook {
        ui::ImageHandle image;
        std::uint8_t alpha;
    };
    static void draw_underlay(ui::Painter& painter, const ui::Node& node, const UnderlayLook& look) {
        painter.image(node.rect(), look.image, false, {255, 255, 255, look.alpha});
    }

    void look_under(const ui::ViewportResult& view) {
        Under& u = memory_.under;
        const Preview* const preview = on_.preview.preview();
        if (preview == nullptr || !(view.hovered || on_.hold.on()) || view.size.x < 1) {
            u = {};
            return;
        }
        const SceneCamera& camera = preview->camera();
        if (u.pointer == view.pointer && u.version == on_.edited.document.version() && u.eye == camera.eye &&
            u.target == camera.target)
            return;
        u = {.pointer = view.pointer,
             .version = on_.edited.document.version(),
             .eye = camera.eye,
             .target = camera.target,
             .hit = preview->pick(glm::dvec2(view.pointer), view.size),
             .tissue = {}};
        if (u.hit) u.tissue = preview->tissue(u.hit->position);
    }

    Drag drag_for(const ui::ViewportResult& view) const {
        const bool left = view.button == ui::Button::left, shift = has(view.mods, Mods::shift);
        if (left && !shift && on_.tool.action && memory_.under.hit) return Drag::tool;
        if (left && !shift && stays()) return Drag::fixed;
        return view.button == ui::Button::middle || (left && shift) ? Drag::pan : Drag::orbit;
    }

    void work(const ui::ViewportResult& view) {
        SceneCamera& camera = on_.looking.camera;
        const auto& hit = memory_.under.hit;
        if (view.pressed) {
            memory_.drag = drag_for(view);
            if (memory_.drag == Drag::tool) on_.hold.begin(on_.tool, hit->position);
            if (memory_.drag == Drag::orbit && view.clicks == 2 && hit) {
                look_freely(view.pointer);
                app::center_on(camera, hit->position);
            }
        }
        if (memory_.drag == Drag::tool && hit) on_.hold.move(hit->position);
        const double height = std::max(view.size.y, 1);
        if (view.drag != glm::vec2(0)) {
            if (memory_.drag == Drag::orbit || memory_.drag == Drag::pan) look_freely(view.pointer);
            if (memory_.drag == Drag::orbit)
                app::orbit(camera, -double(view.drag.x) * std::numbers::pi / height,
                           double(view.drag.y) * std::numbers::pi / height);
            if (memory_.drag == Drag::pan) app::pan(camera, view.drag, height);
            if (memory_.drag == Drag::fixed) say_fixed(view.pointer);
        }
        if (view.wheel != 0)
            zoom(std::pow(zoom_notch, -double(view.wheel)), hit ? &hit->position : nullptr, view.pointer);
        if (view.cancelled && memory_.drag == Drag::tool) on_.hold.cancel();
        if (view.released && memory_.drag == Drag::tool) on_.hold.end();
        if (view.released || view.cancelled) memory_.drag = Drag::none;
        if (memory_.drag != Drag::none) ui_.set_cursor(ui::Cursor::move);
        if (on_.tool.action && hit) ui_.set_cursor(ui::Cursor::crosshair);
    }

    void zoom(double factor, const glm::dvec3* place, glm::vec2 at) {
        if (stays()) return say_fixed(at);
        look_freely(at);
        SceneCamera& camera = on_.looking.camera;
        place != nullptr ? app::zoom_at(camera, factor, *place) : app::zoom(camera, factor);
    }

    /// With a tool in the hand a movement beside the organ must not take the endoscope's view away.
    bool stays() const { return on_.looking.endoscope && on_.tool.action.has_value(); }

    /// "Key E", or what the command is called where it has no key.
    std::string_view way(std::string_view command) {
        const std::string_view keys = chord_of(on_.commands, command);
        if (!keys.empty()) return ui_.join({"Key ", keys});
        return on_.commands[on_.commands.index_of(command)].title;
    }

    void say_fixed(glm::vec2 at) {
        say_beside(ui_, memory_.said,
                   ui_.join({"The tool works in the endoscope's view. ", way("tool.look"), " looks around"}), at);
    }

    /// Looking around begins with what the endoscope sees.
    void look_freely(glm::vec2 at) {
        if (!on_.looking.endoscope) return;
        on_.looking.endoscope = false;
        on_.looking.camera = on_.edited.document.scene().camera;
        say_beside(ui_, memory_.said,
                   ui_.join({"You look around freely. ", way("view.endoscope"), " goes back to the endoscope"}), at);
    }

    void keys(const ui::ViewportResult& view) {
        for (const ui::ViewportKey& key : view.keys) {
            if (key.key == Key::escape) {
                on_.hold.cancel();
                memory_.drag = Drag::none;
            } else if (!look_by(key, view) && !work_by(key, view)) {
                ui_.press_shortcut(key.key, key.mods);
            }
        }
    }

    bool look_by(const ui::ViewportKey& key, const ui::ViewportResult& view) {
        const double turn = has(key.mods, Mods::shift) ? key_turn / 5 : key_turn;
        glm::dvec2 by(0);
        if (key.key == Key::left) by.x = -turn;
        if (key.key == Key::right) by.x = turn;
        if (key.key == Key::up) by.y = turn;
        if (key.key == Key::down) by.y = -turn;
        const bool nearer = key.key == ui::key_of('='), farther = key.key == ui::key_of('-');
        if (by == glm::dvec2(0) && !nearer && !farther) return false;
        const glm::vec2 at = view.hovered ? view.pointer : glm::vec2(view.size) / 2.0F;
        if (by == glm::dvec2(0)) return zoom(nearer ? 1 / zoom_notch : zoom_notch, nullptr, at), true;
        if (stays()) return say_fixed(at), true;
        look_freely(at);
        app::orbit(on_.looking.camera, by.x, by.y);
        return true;
    }

    bool work_by(const ui::ViewportKey& key, const ui::ViewportResult& view) {
        const Preview* const preview = on_.preview.preview();
        if (key.key != Key::enter || !on_.tool.action || preview == nullptr || view.size.x < 1) return false;
        if (key.repeat || on_.hold.on()) return true;
        const auto hit = preview->pick(glm::dvec2(view.size) / 2.0, view.size);
        if (hit)
            on_.hold.begin_for(on_.tool, hit->position, work_by_key);
        else
            on_.toasts.add({.kind = ui::ToastKind::info, .text = "The organ is not in the middle of the view"});
        return true;
    }

    /// A ring as large as what the tool would work on.
    void mark(const ui::ViewportResult& view) {
        const Under& u = memory_.under;
        if (!on_.tool.action || !u.hit) return;
        const SceneCamera& camera = on_.preview.preview()->camera();
        const double depth = glm::dot(u.hit->position - camera.eye, glm::normalize(camera.target - camera.eye));
        const double px_per_mm =
            view.size.y / (2 * widened(view) * std::max(depth, 1.0) * std::tan(glm::radians(camera.field_of_view) / 2));
        const double reach = reach_of(*on_.tool.action, on_.edited.document.preset());
        const float radius = std::clamp(static_cast<float>(reach * px_per_mm), ui_.em(0.35F), ui_.em(40));
        ui::Node& ring = ui_.leaf(ui::Role::none, {});
        ring.placed = true;
        ring.placement = ui_.arena().make(ui::Placement{.offset = view.pointer - glm::vec2(radius)});
        ring.size[0] = ring.size[1] = ui::px(2 * radius);
        const bool acts = on_.hold.on();
        ui_.draw_with<draw_ring>(ring, acts);
    }
    static void draw_ring(ui::Painter& painter, const ui::Node& node, const bool& acts) {
        const ui::Rect rect = node.rect();
        const float line = painter.hairline();
        painter.frame(rect.inset(-line), {0, 0, 0, 140}, 3 * line, rect.w / 2 + line);
        painter.frame(rect, acts ? painter.theme().accent_hover : ui::Color{255, 255, 255, 230}, line, rect.w / 2);
    }

    /// Tissue and distance under the pointer, in the lower left corner.
    void readout() {
        const Under& u = memory_.under;
        if (!u.hit || (!on_.tool.action && on_.looking.overlay == Overlay::none)) return;
        char text[128];
        const double bleeds =
            u.tissue.bleeds * (on_.tool.action ? app::strength_here(*on_.tool.action, u.tissue) : 1.0);
        const int length =
            u.tissue.known
                ? std::snprintf(text, sizeof text, "vessels %.0f %%   fat %.0f %%   would bleed %.1f   %.0f mm away",
                                100 * u.tissue.vessels, 100 * u.tissue.fat, bleeds, u.hit->distance)
                : std::snprintf(text, sizeof text, "vessels and fat not known   would bleed %.2g   %.0f mm away",
                                bleeds, u.hit->distance);
        put_in_corner(ui_, "Under the pointer", {text, static_cast<std::size_t>(std::max(length, 0))});
    }

    /// Only one clip is shown, which must not be taken for the preset.
    void solo() {
        const auto& alone = on_.clips.alone();
        const auto& clips = on_.edited.document.preset().smoke.clips;
        if (!alone || *alone >= clips.size()) return;
        const ui::Panel panel(ui_, "Solo", {.width = ui::fit(), .height = ui::fit(), .padding = 0.4F});
        place({.fraction = {0, 0}, .offset = {ui_.em(0.6F), ui_.em(0.6F)}, .pivot = {0, 0}});
        const ui::Row row(ui_, {.cross = ui::ChildAlign::center});
        ui::label(
            ui_,
            ui_.join({"Only ", ui_.copy(std::filesystem::path(clips[*alone].file).filename().string()), " is shown"}),
            {.tone = ui::Tone::warning});
        if (ui::button(ui_, "Show all clips", {.tip = "The preview then shows the whole preset again"}))
            on_.clips.play_alone({});
    }

    /// What is being loaded; the former organ stays until it is ready.
    void loading() {
        const auto loading = on_.preview.loading();
        if (!loading) return;
        const ui::Panel panel(ui_, "Loading", {.width = box_width(), .height = ui::fit(), .padding = 0.6F});
        const float y = on_.preview.ready() ? 0.0F : 0.5F;
        place({.fraction = {0.5F, y}, .offset = {0, y > 0 ? 0 : ui_.em(0.6F)}, .pivot = {0.5F, y}});
        const bool is_plate =
            on_.edited.document.scene().plate.use && !on_.preview.organ_of(on_.edited.document.scene());
        if (!ui::progress(ui_, is_plate ? "Making the plate" : ui_.join({"Loading ", loading->name}), loading->progress,
                          {.cancellable = true}))
            return;
        is_plate ? app::show_plate(on_.edited.document, false) : on_.preview.cancel_loading();
    }

    // --- what keeps it from being shown ---
    ui::Size box_width() {
        const float room = ui_.rect_before(ui_.id_of("Preview")).w;
        return ui::px(room > 0 ? std::min(ui_.em(30), room) : ui_.em(30));
    }
    void faults() {
        if (!on_.preview.organ_faults().empty())
            organ_fault(on_.preview.organ_faults().front());
        else if (!on_.preview.preset_faults().empty())
            preset_fault(on_.preview.preset_faults());
    }

    void organ_fault(const Fault& fault) {
        const ui::Panel panel(ui_, "Organ fault", {.width = box_width(), .height = ui::fit(), .padding = 1});
        place({.fraction = {0.5F, 0.5F}, .pivot = {0.5F, 0.5F}});
        if (on_.edited.document.scene().plate.use) return plate_fault(fault);
        const std::string& file = on_.edited.document.scene().organ.file;
        ui::heading(ui_, file.empty() ? "No organ yet" : "The scene cannot be shown");
        ui::label(ui_,
                  file.empty() ? "Load a surface (" + listed(Content::mesh) + "), or drop one here." : fault.text(),
                  {.tone = file.empty() ? ui::Tone::dim : ui::Tone::error, .wrap = true, .width = ui::grow()});
        const ui::Row buttons(ui_);
        if (ui::button(ui_, file.empty() ? "Choose..." : "Choose another...",
                       {.icon = ui::Icon::folder, .tip = "Load another organ", .primary = true}))
            on_.commands.run("file.load_organ");
        if (!file.empty() && ui::button(ui_, "Unit and orientation...",
                                        {.tip = "Read this organ again, with another unit or orientation"}))
            on_.organ_choice.open(app::path_from(on_.edited.document.scene().folder, file));
        if (on_.edited.document.undo_changes_organ()) undo_button();
    }

    /// Only where the last step brought the fault: any other work is not to go.
    void undo_button() {
        document::Document& document = on_.edited.document;
        const std::string& step = document.steps()[document.done() - 1].name;
        if (ui::button(ui_, "Undo", {.icon = ui::Icon::undo, .tip = ui_.join({"Undoes: ", step})})) document.undo();
    }

    void plate_fault(const Fault& fault) {
        ui::heading(ui_, "The plate cannot be shown");
        ui::label(ui_, fault.text(), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
        if (ui::button(ui_, "Show the organ", {.tip = "Turns the plate off", .primary = true}))
            on_.commands.run("view.plate");
    }

    /// The picture shows everything except what is wrong.
    void preset_fault(const std::vector<Fault>& faults) {
        const ui::Panel panel(ui_, "Preset fault", {.width = box_width(), .height = ui::fit(), .padding = 0.6F});
        place({.fraction = {0.5F, 1}, .offset = {0, -ui_.em(2.8F)}, .pivot = {0.5F, 1}});
        const std::string more = faults.size() > 1 ? " (and " + std::to_string(faults.size() - 1) + " more)" : "";
        ui::label(ui_, "Not shown because of a fault:", {.tone = ui::Tone::warning});
        ui::label(ui_, document::fault_text(faults.front(), on_.edited.document.preset()) + more,
                  {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
        const ui::Row buttons(ui_);
        Fault fault = faults.front();
        if (const auto clip = clip_of(fault)) {
            fault.place = "/smoke/clips/" + std::to_string(*clip) + "/file";
            clip_ways_out(*clip);
        }
        if (on_.edited.document.undo_mends(fault)) undo_button();
    }

    /// The preset's clip whose file is meant.
    std::optional<std::size_t> clip_of(const Fault& fault) const {
        const Preset& preset = on_.edited.document.preset();
        const std::vector<SmokeClip>& clips = preset.smoke.clips;
        const std::filesystem::path file(fault.file);
        std::optional<std::size_t> of_this_name;
        for (std::size_t i = clips.size(); i-- > 0;) {
            const std::string place = "/smoke/clips/" + std::to_string(i);
            if (fault.place == place || fault.place == place + "/file") return i;
            if (!fault.place.empty()) continue;
            if (document::real_clip(clips[i].file, preset.folder) == file) return i;
            if (std::filesystem::path(clips[i].file).filename() == file.filename()) of_this_name = i;
        }
        return of_this_name;
    }

    void clip_ways_out(std::size_t clip) {
        const bool finds =
            ui::button(ui_, "Find file...", {.icon = ui::Icon::folder, .tip = "Another file for the clip"});
        const bool removes = ui::button(ui_, "Remove clip", {.tip = "Takes the clip out of the preset; a file stays"});
        if (finds || removes) {
            on_.clips.selected = clip;
            on_.commands.run(finds ? "clip.replace" : "clip.remove");
        }
    }

    void place(const ui::Placement& placement) {
        ui_.parent().placed = true;
        ui_.parent().placement = ui_.arena().make(placement);
    }

    ui::Ui& ui_;
    const ViewParts& on_;
    ViewMemory& memory_;
};

}  // namespace

void view_panel(ui::Ui& ui, const ViewParts& parts) {
    ViewPanel(ui, parts).build();
}

void add_tool_commands(app::Editor& editor) {
    const auto add = [&editor](std::string_view key, char shortcut, int index, std::string tip) {
        editor.commands.add({.id = "tool." + std::string(key),
                             .title = std::string(tool_names[static_cast<std::size_t>(index)]),
                             .group = "Tool",
                             .chord = {ui::key_of(shortcut), Mods::none},
                             .run = [&editor, index] { take_tool(editor.hold, editor.tool, index); },
                             .checked = [&editor, index] { return tool_index(editor.tool) == index; },
                             .tip = std::move(tip)});
    };
    add("look", '0', 0, "The left button turns the view");
    for (const ToolActionRow& row : tool_actions) {
        add(row.key, row.shortcut, 1 + static_cast<int>(row.action),
            upper_first(std::string(row.help)) + ". Hold it on the organ to use it there; an event records it");
    }
}

}  // namespace lapfx::panels
