#include "panels/band_strip.h"

#include <memory>
#include <optional>

#include "lapfx/tissue.h"
#include "panels/table_rows.h"
#include "ui/canvas/histogram.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

namespace {

/// Counted beside the UI, whenever the organ or what the counts depend on is another.
struct Counts {
    std::string organ_key;
    double vessel_width = -1;
    std::shared_ptr<const Organ> organ;
    std::optional<TissueHistogram> histogram;
    std::vector<Fault> faults;
    std::shared_ptr<app::Job> counting{};
};
struct StripMemory {
    std::shared_ptr<Counts> counts = std::make_shared<Counts>();
    std::uint64_t version = 0;  ///< of the document, when last looked at
};

std::string key_of(const Scene& scene) {
    const glm::dvec3& r = scene.organ.rotation;
    return (scene.folder / scene.organ.file).string() + ' ' + std::to_string(scene.organ.scale) + ' ' +
           std::to_string(r.x) + ' ' + std::to_string(r.y) + ' ' + std::to_string(r.z);
}

void count(app::Editor& editor, const std::shared_ptr<Counts>& counts) {
    const Scene& scene = editor.document.scene();
    const VesselParameters parameters = editor.document.preset().vessels;
    std::string key = key_of(scene);
    if (counts->organ_key != key) *counts = {};
    counts->organ_key = std::move(key);
    counts->vessel_width = parameters.vessel_width;
    counts->counting = editor.jobs.start(
        "Counting colours of the organ",
        [counts, parameters, organ = counts->organ, file = scene.folder / scene.organ.file,
         options = OrganOptions{.scale = scene.organ.scale, .rotation = scene.organ.rotation}](app::Job&) mutable {
            if (!organ) organ = std::make_shared<Organ>(load_organ(file, options));
            const TissueHistogram histogram = tissue_histogram(*organ, parameters);
            return [counts, organ, histogram] {
                counts->organ = organ;
                counts->histogram = histogram;
                counts->faults.clear();
                counts->counting.reset();
            };
        },
        [counts](const std::vector<Fault>& faults) {
            counts->faults = faults;
            counts->counting.reset();
        });
}

void follow(app::Editor& editor, StripMemory& memory) {
    auto& counting = memory.counts->counting;
    if (counting && counting->cancelled()) counting.reset();  // by whoever lists jobs
    if (memory.version == editor.document.version() || counting || !editor.preview.ready()) return;
    memory.version = editor.document.version();
    const Counts& counts = *memory.counts;
    if (counts.vessel_width == editor.document.preset().vessels.vessel_width &&
        counts.organ_key == key_of(editor.document.scene()))
        return;
    count(editor, memory.counts);
}

/// One of the two overlays.
struct Band {
    std::string_view name, unit, tip;
    double VesselParameters::*low;
    double VesselParameters::*high;
    std::string_view low_key, high_key;
    double minimum, maximum, step;
};

using V = VesselParameters;
constexpr Band vessel_band{
    "Redness beside its surroundings",
    "",
    "How often each contrast occurs on the organ: how much redder a place is than the tissue around it. From Low on it "
    "counts as vessel, from High wholly.",
    &V::vessel_low,
    &V::vessel_high,
    "vessel_low",
    "vessel_high",
    TissueHistogram::least_contrast,
    TissueHistogram::most_contrast,
    0.01};
constexpr Band fat_band{
    "Hue",
    "deg",
    "How often each hue occurs on the organ (0 red, 90 yellow). Up to Low it is not fat, from High wholly.",
    &V::fat_low,
    &V::fat_high,
    "fat_low",
    "fat_high",
    TissueHistogram::least_hue,
    TissueHistogram::most_hue,
    1};

void* vessels_of(document::Content& content) {
    return &content.preset.vessels;
}

void levels(ui::Ui& ui, app::Editor& editor, const Band& band, std::span<const std::uint32_t> bins) {
    const V& now = editor.document.preset().vessels;
    static const V standard;
    ui::Levels levels{.low = now.*band.low, .high = now.*band.high};
    const ui::HistogramResult result =
        ui::histogram(ui, band.name, {.bins = bins, .minimum = band.minimum, .maximum = band.maximum}, &levels,
                      {.reset = {.low = standard.*band.low, .high = standard.*band.high},
                       .step = band.step,
                       .clip_share = 1,
                       .unit = band.unit,
                       .tip = band.tip,
                       .width = ui::grow(1.2F),
                       .height = 4});
    const Table& table = *preset_table().find("vessels");
    editor.document.take(result.low, table.find_row(band.low_key)->name,
                         [&](document::Content& c) { c.preset.vessels.*band.low = levels.low; });
    editor.document.take(result.high, table.find_row(band.high_key)->name,
                         [&](document::Content& c) { c.preset.vessels.*band.high = levels.high; });
}

void rows(ui::Ui& ui, app::Editor& editor, std::initializer_list<std::string_view> keys, double maximum) {
    const ui::Column column(ui, {.width = ui::grow(), .gap = 0.2F});
    static const V standard;
    for (const std::string_view key : keys)
        table_row(ui, editor, *preset_table().find("vessels")->find_row(key), vessels_of,
                  {.standard = &standard, .maximum = maximum});
}

}  // namespace

void band_strip(ui::Ui& ui, app::Editor& editor) {
    const Overlay overlay = editor.looking.overlay;
    if (overlay != Overlay::vessels && overlay != Overlay::fat) return;
    const bool vessels = overlay == Overlay::vessels;
    StripMemory& memory = ui.memory<StripMemory>(ui.id_of("band strip"));
    follow(editor, memory);
    const Counts& counts = *memory.counts;
    const ui::Row row(ui, {.width = ui::grow(), .gap = 0.8F, .padding = 0.4F, .cross = ui::Place::center});
    static const TissueHistogram none;
    const TissueHistogram& shown = counts.histogram ? *counts.histogram : none;
    levels(ui, editor, vessels ? vessel_band : fat_band, vessels ? shown.contrast : shown.hue);
    if (vessels) {
        rows(ui, editor, {"vessel_low", "vessel_high"}, TissueHistogram::most_contrast);
        rows(ui, editor, {"vessel_width", "smoothing"}, 5);
    } else {
        rows(ui, editor, {"fat_low", "fat_high"}, TissueHistogram::most_hue);
        rows(ui, editor, {"smoothing"}, 5);
    }
    if (!counts.faults.empty())
        ui::label(ui, counts.faults.front().text(), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
}

}  // namespace lapfx::panels
