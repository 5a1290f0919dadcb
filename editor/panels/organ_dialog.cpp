// An organ's unit and orientation, set by looking at its size, before it is loaded.
#include <array>
#include <cstdio>

#include "app/files/organ_choice.h"
#include "lapfx/authoring/organ_report.h"
#include "panels/panels.h"
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

class OrganDialog {
  public:
    OrganDialog(ui::Ui& ui, app::OrganChoice& choice) : ui_(ui), choice_(choice) {}

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
        ui::separator(ui_);
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
    void unit() {
        const int found = app::unit_of(choice_.scale());
        const bool other = found < 0 || choice_.other_unit;
        int chosen = other ? 4 : found;
        ui::label(ui_, "One unit in the file is");
        const ui::Row row(ui_, {.width = ui::grow()});
        if (ui::segmented(ui_, "Unit", chosen, unit_names)) {
            choice_.other_unit = chosen == 4;
            if (chosen < 4) choice_.set_scale(app::length_units[static_cast<std::size_t>(chosen)].millimetres);
        }
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
        const double longest = std::max({size.x, size.y, size.z});
        const auto likely = choice_.likely();
        const bool possible = choice_.possible();
        const auto length = [&](double mm) { return text_of(ui_, mm < 1000 ? "%.4g" : "%.0f", mm); };
        ui::label(
            ui_, ui_.join({length(size.x), " x ", length(size.y), " x ", length(size.z), " mm (width, height, depth)"}),
            {.tone = possible ? ui::Tone::good : ui::Tone::warning, .number = true, .weight = ui::Weight::bold});
        if (possible) return;
        const ui::Row row(ui_, {.width = ui::grow(), .cross = ui::ChildAlign::center});
        if (!likely) {
            ui::label(
                ui_,
                text_of(ui_, "No organ is this large or small: %.0f to %.0f mm are possible. Set the length of a unit.",
                        shortest_organ, longest_organ),
                {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
            return;
        }
        const std::string_view unit = app::length_units[static_cast<std::size_t>(app::unit_of(*likely))].name;
        ui::label(ui_, ui_.join({length(longest), " mm: is the unit ", unit, "?"}),
                  {.tone = ui::Tone::warning, .width = ui::grow()});
        if (ui::button(
                ui_, ui_.join({"Use ", unit}),
                {.tip = text_of(ui_, "Its longest side will then be %.4g mm", longest / choice_.scale() * *likely)})) {
            choice_.set_scale(*likely);
            choice_.other_unit = false;
        }
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
};

}  // namespace

void organ_dialog(ui::Ui& ui, app::OrganChoice& choice, ui::CommandTable& commands) {
    if (choice.take_asked()) ui::open_dialog(ui, dialog_name);
    ui::Dialog dialog(ui, dialog_name, "Load organ",
                      {.width = 34, .height = 30});  // of a fixed size, so that its buttons do not move
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
                        {.label = "Load", .standard = !again && choice.possible(), .enabled = choice.ready()}});
    if (answer == 0U || answer == 1U) choice.give_up();
    if (answer == 1U) commands.run("file.load_organ");
    if (answer == 2U) choice.load();
}

}  // namespace lapfx::panels
