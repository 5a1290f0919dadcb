#include <array>

#include "gallery/gallery.h"
#include "gallery/parts.h"

namespace lapfx::gallery {

namespace {

void sizes(ui::Ui& ui) {
    const Part part(ui, "Sizes and weights");
    for (const float size : {0.7F, 0.85F, 1.0F, 1.15F, 1.5F, 2.0F, 3.0F}) {
        const Line line(ui, ui.join({text_of(ui, size, 2), " em"}));
        ui::label(ui, "Hamburgefonstiv", {.size = size});
        ui::label(ui, "medium", {.size = size, .weight = ui::Weight::medium});
        ui::label(ui, "bold 0123456789", {.size = size, .weight = ui::Weight::bold});
    }
}

void digits(ui::Ui& ui) {
    const Part part(ui, "Digits of one width");
    constexpr std::array values = {1.111, 8.888, -40.5, 12345.678, 0.0};
    const ui::Row row(ui, {.gap = 2, .cross = ui::ChildAlign::start});
    for (const bool number : {true, false}) {
        const ui::Column column(ui, {.gap = 0});
        ui::label(ui, number ? "tabular" : "proportional", {.tone = ui::Tone::dim});
        for (const double value : values)
            ui::label(ui, text_of(ui, value, 3),
                      {.align = ui::Align::end, .number = number, .width = ui::px(ui.em(7))});
    }
}

void scripts(ui::Ui& ui) {
    struct Example {
        std::string_view name, text;
    };
    constexpr std::array examples = {
        Example{"Latin", "Ångström, façade, Ørsted, Łódź, ﬁne, Việt Nam"},
        Example{"Greek", "Ξεσκεπάζω την ψυχοφθόρα βδελυγμία"},
        Example{"Cyrillic", "Съешь ещё этих мягких французских булок"},
        Example{"combining", "é ñ ṏ a̐éö̲"},
        Example{"signs", "µm² · 10⁻³ ± 0.5 °C → ≤ ≥ ≈ ∞ √ Σ ∆ ½ € “quoted” … –"},
        Example{"Chinese", "腹腔镜手术模拟"},
        Example{"emoji", "🙂 🔬"},
        Example{"no UTF-8", "a\xffz \xc3 end"},
        Example{"control", "tab\there, bell\a, escape\x1b."},
    };
    const Part part(ui, "Scripts");
    for (const Example& example : examples) {
        const Line line(ui, example.name);
        ui::label(ui, example.text);
    }
}

void cut(ui::Ui& ui) {
    const Part part(ui, "Cut and wrapped");
    for (const float width : {2.0F, 6.0F, 14.0F}) {
        const Line line(ui, ui.join({text_of(ui, width), " em"}));
        ui::label(ui, "Gallbladder fossa, left margin", {.width = ui::px(ui.em(width))});
    }
    const ui::Row row(ui, {.width = ui::grow(), .gap = 1.5F, .cross = ui::ChildAlign::start});
    for (const ui::Align align : {ui::Align::start, ui::Align::center, ui::Align::end}) {
        const ui::Column column(ui, {.width = ui::grow()});
        ui::label(
            ui,
            "The smoke rises from where the hook touches fat, spreads under the abdominal wall and is drawn out by "
            "suction.\nA second paragraph.",
            {.align = align, .wrap = true});
    }
}

}  // namespace

void text_page(ui::Ui& ui, State&) {
    sizes(ui);
    digits(ui);
    scripts(ui);
    cut(ui);
}

}  // namespace lapfx::gallery
