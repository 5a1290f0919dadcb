#include <numbers>

#include "gallery/gallery.h"
#include "gallery/parts.h"
#include "ui/widgets/param.h"

namespace lapfx::gallery {

namespace {

void kinds(ui::Ui& ui, ParamsState& s) {
    ui::param(ui, "Speed", s.speed,
              {.maximum = 60, .step = 0.5, .unit = "mm/s", .standard = 12, .tip = "Of the blood's edge"}, &s.actions);
    ui::param(ui, "Count", s.count, {.minimum = 1, .maximum = 200, .step = 1, .standard = 20});
    ui::param(ui, "Tilt", s.tilt,
              {.minimum = -180, .maximum = 180, .step = 1, .unit = "deg", .display = 180 / std::numbers::pi});
    ui::param(ui, "Opacity", s.ratio, ui::percent());
    ui::param(ui, "Delay", s.time, ui::seconds({.maximum = 2, .step = 0.05, .standard = 0.25}));
    ui::param(ui, "Single precision", s.single, {.maximum = 1, .step = 0.05});
}

void scales(ui::Ui& ui, ParamsState& s) {
    ui::param(ui, "Logarithmic", s.big,
              {.minimum = 1, .maximum = 1e5, .unit = "Hz", .scale = ui::ValueScale::logarithmic});
    ui::param(ui, "Logarithmic from 0", s.speed, {.maximum = 100, .scale = ui::ValueScale::logarithmic});
}

void states(ui::Ui& ui, ParamsState& s) {
    ui::param(ui, "Changed", s.count, {.minimum = 0, .maximum = 100, .step = 1, .standard = 10});
    ui::param(ui, "Locked", s.locked, {.maximum = 10, .step = 0.1, .locked = true}, &s.actions);
    ui::param(ui, "Beyond the usual range", s.wild, {.maximum = 10, .hard_maximum = 100, .step = 1});
    ui::param(ui, "A name that is a good deal longer than the place there is for it", s.speed, {.maximum = 60});
    ui.push_disabled(true);
    ui::param(ui, "Disabled", s.speed, {.maximum = 60, .unit = "mm/s"});
    ui.pop_disabled();
}

void several(ui::Ui& ui, ParamsState& s) {
    constexpr double luma[] = {0, 255};
    ui::range_param(ui, "Luma", s.low, s.high, {.maximum = 255, .step = 1}, luma);
    ui::vector_param(ui, "Position", std::span(&s.place[0], 3),
                     {.minimum = -500, .maximum = 500, .step = 1, .unit = "mm"});
    ui::vector_param(ui, "Flow", std::span(&s.flow[0], 2), {.minimum = -1, .maximum = 1, .step = 0.01});
}

}  // namespace

void params_page(ui::Ui& ui, State& state) {
    const ui::Row row(ui, {.width = ui::grow(), .gap = 1.5F, .cross = ui::ChildAlign::start});
    {
        const ui::Column column(ui, {.width = ui::grow(), .gap = 1});
        {
            const Part part(ui, "Kinds");
            kinds(ui, state.params);
        }
        const Part part(ui, "Scales");
        scales(ui, state.params);
    }
    const ui::Column column(ui, {.width = ui::grow(), .gap = 1});
    {
        const Part part(ui, "States");
        states(ui, state.params);
    }
    const Part part(ui, "Several numbers");
    several(ui, state.params);
}

}  // namespace lapfx::gallery
