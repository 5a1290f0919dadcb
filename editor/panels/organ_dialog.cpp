// An organ's unit and orientation, set by looking at its size, before it is loaded.
#include <array>
#include <cstdio>

#include "app/files/organ_choice.h"
#include "lapfx/authoring/organ_report.h"
#include "panels/missing_texture.h"
#include "panels/panels.h"
#include "panels/table_rows.h"
#include "ui/canvas/drag_handle.h"
#include "ui/core/node.h"
#include "ui/shell/dialog.h"
#include "ui/shell/progress.h"
#include "ui/widgets/basic.h"
#include "ui/widgets/combo.h"
#include "ui/widgets/param.h"
#include "ui/widgets/scroll.h"

namespace lapfx::panels {

namespace {

constexpr std::string_view dialog_name = "organ";
constexpr std::size_t most_warnings = 4;
/// The units, and last one that is typed.
constexpr auto unit_names = [] {
    std::array<std::string_view, app::length_units.size() + 1> names{};
    for (std::size_t i = 0; i < app::length_units.size(); ++i) names[i] = app::length_units[i].name;
    names.back() = "Other";
    return names;
}();

template <typename... Values>
std::string_view text_of(ui::Ui& ui, const char* format, Values... values) {
    char text[160];
    const int length = std::snprintf(text, sizeof text, format, values...);
    return ui.copy({text, std::min(sizeof text - 1, static_cast<std::size_t>(std::max(length, 0)))});
}

constexpr float picture_height = 10;  // em
constexpr double shown_bar = 10;      // mm

struct OrganLook {
    ui::ImageHandle image;
    float bar;  ///< px of the image
    std::string_view text;
};

void draw_organ(ui::Painter& painter, const ui::Node& node, const OrganLook& look) {
    const ui::Theme& t = painter.theme();
    const ui::Rect all = node.rect();
    painter.fill(all, t.canvas, painter.em(t.radius));
    const glm::vec2 size(app::OrganChoice::picture_size);
    const float scale = std::min(all.w / size.x, all.h / size.y);
    const glm::vec2 shown = glm::floor(size * scale), corner = glm::floor(all.center() - 0.5F * shown);
    painter.image({corner.x, corner.y, shown.x, shown.y}, look.image);
    const float inset = painter.em(0.6F), height = painter.em(0.25F);
    const float width = std::clamp(look.bar * scale, painter.hairline(), all.w - 2 * inset);
    const ui::Rect bar{all.x + inset, all.bottom() - inset - height, width, height};
    painter.fill(bar, ui::canvas_ink(t));
    painter.text({bar.x, bar.y - painter.em(1.5F), all.w - 2 * inset, painter.em(1.4F)}, look.text,
                 painter.text_style(), ui::canvas_ink(t));
}

/// A dialog that has just opened gets it after this build.
bool has_keyboard(ui::Ui& ui) {
    const ui::Node* const focused = ui.before(ui.focus());
    return focused != nullptr && focused->layer == ui.parent().layer;
}

class OrganDialog {
  public:
    OrganDialog(ui::Ui& ui, app::OrganChoice& choice)
        : ui_(ui), choice_(choice), read_(has_keyboard(ui) && choice.take_read()) {}

    void content() {
        ui::label(ui_, ui_.copy(choice_.file().filename().string()), {.weight = ui::Weight::bold});
        ui::label(ui_, ui_.copy(choice_.file().parent_path().string()), {.tone = ui::Tone::dim});
        if (choice_.reading()) {
            ui::progress(ui_, "Reading", -1);
            return;
        }
        for (const Fault& fault : choice_.faults())
            ui::label(ui_, fault.text(), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
        if (!choice_.ready()) return;
        const OrganReport& report = choice_.report();
        ui::label(ui_, text_of(ui_, "%zu vertices, %zu triangles, %zu %s", report.vertices, report.triangles,
                               report.components, report.components == 1 ? "piece" : "pieces"));
        if (!choice_.texture().empty())
            ui::label(ui_, ui_.join({"Its texture is ", ui_.copy(choice_.texture().filename().string())}));
        missing_texture();
        picture();
        unit();
        size();
        if (choice_.takes_events())
            ui::label(
                ui_,
                "The events on the timeline belong to the previous organ and will be removed. Undo brings both back.",
                {.tone = ui::Tone::dim, .wrap = true, .width = ui::grow()});
        ui::separator(ui_);
        orientation();
        warnings();
    }

  private:
    /// Above all else: without its texture an organ is of one colour.
    void missing_texture() {
        const app::MissingTexture* const m = choice_.missing_texture();
        if (m == nullptr) return;
        const ui::Row row(ui_, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        ui::label(ui_, ui_.join({ui_.copy(app::words_of(*m)), "."}),
                  {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
        if (!m->likely) return;
        const std::filesystem::path likely = *m->likely;
        if (likely_texture_button(ui_, *m)) choice_.use_texture(likely);
    }

    /// Small enough that what has to be decided stays in sight.
    void picture() {
        const ui::ImageHandle image = choice_.picture();
        if (image == 0) return;
        ui::Node& node = ui_.leaf(ui::Role::image, "Organ");
        node.size[0] = ui::grow();
        node.size[1] = ui::px(ui_.em(picture_height));
        const double bar = shown_bar / std::max(choice_.picture_pixel(), 1e-12);
        const std::string_view text = bar > app::OrganChoice::picture_size.x ? "10 mm is wider than this"
                                      : bar < 1                              ? "10 mm is less than a pixel"
                                                                             : "10 mm";
        node.text = text;
        node.tip = "From the front. The bar is 10 mm long with the unit that is chosen";
        node.number = ui_.number(bar, 0, 1e12);
        ui_.draw_with<draw_organ>(node, OrganLook{image, static_cast<float>(std::min(bar, 1e6)), text});
    }

    void unit() {
        const int found = app::unit_of(choice_.scale());
        const bool other = found < 0 || choice_.other_unit;
        int chosen = other ? 4 : found;
        ui::label(ui_, "One unit in the file is");
        const ui::Row row(ui_, {.width = ui::grow()});
        const std::ptrdiff_t before = &ui_.last() - &ui_.parent();
        if (ui::segmented(ui_, "Unit", chosen, unit_names)) {
            choice_.other_unit = chosen == 4;
            if (chosen < 4) choice_.set_scale(app::length_units[static_cast<std::size_t>(chosen)].millimetres);
        }
        if (read_ && !choice_.possible()) go_to_row(ui_, before);
        double scale = choice_.scale();
        ui_.push_disabled(chosen != 4);
        if (ui::number_field(ui_, "Length", scale,
                             {.minimum = 0.001,
                              .maximum = 1000,
                              .hard_minimum = 1e-6,
                              .hard_maximum = 1e6,
                              .unit = "mm",
                              .scale = ui::ValueScale::logarithmic,
                              .tip = "Length of one unit of the file"}))
            choice_.set_scale(scale);
        ui_.pop_disabled();
    }

    void orientation() {
        int up = app::up_axis_of(choice_.rotation());
        static const auto names = [] {
            std::array<std::string_view, app::up_axes.size()> all;
            for (std::size_t i = 0; i < all.size(); ++i) all[i] = app::up_axes[i].name;
            return all;
        }();
        if (ui::combo(ui_, "Up in the file", up, names,
                      {.tip = "The axis that points up in the file; y is up in the scene",
                       .placeholder = "turned freely",
                       .caption = true}) &&
            up >= 0)
            choice_.set_rotation(app::up_axes[static_cast<std::size_t>(up)].rotation);
        double turned[] = {choice_.rotation().x, choice_.rotation().y, choice_.rotation().z};
        if (ui::vector_param(ui_, "Rotation", turned,
                             {.minimum = -180,
                              .maximum = 180,
                              .hard_minimum = -360,
                              .hard_maximum = 360,
                              .step = 1,
                              .unit = "deg",
                              .tip = "Turns about the x, then the y, then the z axis"}))
            choice_.set_rotation({turned[0], turned[1], turned[2]});
    }

    void size() {
        const glm::dvec3 size = choice_.size();
        const auto likely = choice_.likely();
        const bool possible = choice_.possible();
        const auto length = [&](double mm) { return text_of(ui_, mm < 1000 ? "%.4g" : "%.0f", mm); };
        ui::label(
            ui_, ui_.join({length(size.x), " x ", length(size.y), " x ", length(size.z), " mm (width, height, depth)"}),
            {.tone = possible && !likely ? ui::Tone::good : ui::Tone::warning,
             .number = true,
             .weight = ui::Weight::bold});
        if (likely) return propose(*likely);
        if (possible) return;
        ui::label(
            ui_,
            text_of(ui_, "No organ is this large or small: %.0f to %.0f mm are possible. Set the length of a unit.",
                    shortest_organ, longest_organ),
            {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
    }

    /// Another unit, which gets the keyboard as soon as it is known.
    void propose(double scale) {
        const ui::Row row(ui_, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        ui::label(ui_, choice_.reason(), {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
        const std::string_view unit = app::length_units[static_cast<std::size_t>(app::unit_of(scale))].name;
        if (ui::button(ui_, ui_.join({"Use ", unit}), {.tip = "Takes that unit; the size above changes"})) {
            choice_.set_scale(scale);
            choice_.other_unit = false;
        }
        if (read_) ui_.set_focus(ui_.last().id, true);
    }

    void warnings() {
        const std::vector<std::string> all = choice_.warnings();
        if (all.empty()) return;
        ui::separator(ui_);
        for (std::size_t i = 0; i < std::min(all.size(), most_warnings); ++i)
            ui::label(ui_, all[i], {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
        if (all.size() > most_warnings)
            ui::label(ui_, text_of(ui_, "and %zu more", all.size() - most_warnings), {.tone = ui::Tone::dim});
    }

    ui::Ui& ui_;
    app::OrganChoice& choice_;
    bool read_;  ///< since the last build
};

}  // namespace

void organ_dialog(ui::Ui& ui, app::OrganChoice& choice, ui::CommandTable& commands) {
    if (choice.take_asked()) ui::open_dialog(ui, dialog_name);
    ui::Dialog dialog(ui, dialog_name, "Load organ",
                      {.width = 34, .height = 38});  // the size is fixed, so that buttons do not move
    if (dialog.cancelled()) choice.give_up();
    if (!dialog) return;
    {
        const ui::ScrollArea area(ui, "About it", {.gap = 0.4F});
        OrganDialog(ui, choice).content();
    }
    const bool again = !choice.faults().empty();
    const auto answer =
        dialog.buttons({{.label = "Cancel", .cancel = true},
                        {.label = "Choose another...", .tip = "Choose another file"},
                        {.label = "Load",
                         .standard = !again && (choice.reading() || (choice.possible() && !choice.likely())),
                         .enabled = choice.ready()}});
    if (answer == 0U || answer == 1U) choice.give_up();
    if (answer == 1U) commands.run("file.load_organ");
    if (answer == 2U) choice.load();
}

}  // namespace lapfx::panels
