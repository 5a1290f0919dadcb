#include "panels/band_strip.h"

#include <algorithm>
#include <memory>
#include <optional>

#include "lapfx/authoring/tissue_report.h"
#include "lapfx/prepared_organ.h"
#include "lapfx/tissue.h"
#include "panels/table_rows.h"
#include "ui/canvas/histogram.h"
#include "ui/widgets/basic.h"

namespace lapfx::panels {

namespace {

/// Counted by a job, whenever the organ or a parameter that matters has changed.
struct Counts {
    std::weak_ptr<const PreparedOrgan> organ;  // weak: it may be freed while nobody looks at this
    double vessel_width = -1;
    std::optional<TissueHistogram> histogram;
    std::vector<Fault> faults;
    std::shared_ptr<app::Job> counting{};
};
struct StripMemory {
    std::shared_ptr<Counts> counts = std::make_shared<Counts>();
};

void count(const document::Document& document, app::Jobs& jobs, const std::shared_ptr<Counts>& counts,
           const std::shared_ptr<const PreparedOrgan>& organ) {
    const VesselParameters parameters = document.preset().vessels;
    if (counts->organ.lock() != organ) *counts = {};
    counts->organ = organ;
    counts->vessel_width = parameters.vessel_width;
    counts->counting = jobs.start(
        "Counting colours of the organ",
        [counts, parameters, organ](app::Job&) -> app::Jobs::Apply {
            return [counts, histogram = tissue_histogram(*organ, parameters)] {
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

void follow(const document::Document& document, const app::PreviewHost& preview, app::Jobs& jobs, StripMemory& memory) {
    Counts& counts = *memory.counts;
    if (counts.counting && counts.counting->cancelled()) counts.counting.reset();  // by the list of jobs
    if (counts.counting) return;
    const std::shared_ptr<const PreparedOrgan> organ = preview.organ_of(document.scene());
    if (organ && (counts.organ.lock() != organ || counts.vessel_width != document.preset().vessels.vessel_width))
        count(document, jobs, memory.counts, organ);
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
constexpr Band vessel_band{"Redness compared with the surroundings",
                           "",
                           "How often each contrast occurs on the organ: how much redder a place is than the tissue "
                           "around it. From Low it counts as vessel, from High fully.",
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
    "How often each hue occurs on the organ (0 red, 90 yellow). Up to Low it is not fat, from High fully.",
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

void levels(ui::Ui& ui, const Edited& edited, const Band& band, std::span<const std::uint32_t> bins) {
    const V& now = edited.document.preset().vessels;
    const V& saved = edited.saved.content().preset.vessels;
    ui::Levels levels{.low = now.*band.low, .high = now.*band.high};
    const ui::HistogramResult result =
        ui::histogram(ui, band.name, {.bins = bins, .minimum = band.minimum, .maximum = band.maximum}, &levels,
                      {.reset = {.low = saved.*band.low, .high = saved.*band.high},
                       .initial = ui::Levels{.low = V{}.*band.low, .high = V{}.*band.high},
                       .step = band.step,
                       .clip_share = 1,
                       .unit = band.unit,
                       .tip = band.tip,
                       .width = ui::grow(1.2F),
                       .height = 4});
    const Table& table = *preset_table().find("vessels");
    edited.document.take(result.low, table.find_row(band.low_key)->name,
                         [&](document::Content& c) { c.preset.vessels.*band.low = levels.low; });
    edited.document.take(result.high, table.find_row(band.high_key)->name,
                         [&](document::Content& c) { c.preset.vessels.*band.high = levels.high; });
}

void rows(ui::Ui& ui, const Edited& edited, std::initializer_list<std::string_view> keys, double maximum) {
    const ui::Column column(ui, {.width = ui::grow(), .gap = 0.2F});
    static const V standard;
    for (const std::string_view key : keys)
        table_row(ui, edited, *preset_table().find("vessels")->find_row(key), vessels_of,
                  {.standard = &standard, .maximum = maximum});
}

}  // namespace

void band_strip(ui::Ui& ui, Overlay overlay, const Edited& edited, const app::PreviewHost& preview, app::Jobs& jobs) {
    if (overlay != Overlay::vessels && overlay != Overlay::fat) return;
    const bool vessels = overlay == Overlay::vessels;
    StripMemory& memory = ui.memory<StripMemory>(ui.id_of("band strip"));
    follow(edited.document, preview, jobs, memory);
    const Counts& counts = *memory.counts;
    const ui::Row row(ui, {.width = ui::grow(), .gap = 0.8F, .padding = 0.4F, .cross = ui::ChildAlign::center});
    const auto& counted = counts.histogram;
    const auto all_zero = [](std::span<const std::uint32_t> bins) {
        return std::all_of(bins.begin(), bins.end(), [](std::uint32_t n) { return n == 0; });
    };
    if (counted && all_zero(counted->contrast) && all_zero(counted->hue)) {
        ui::label(
            ui,
            "This organ has only one colour: vessels and fat cannot be found on it, and every cut bleeds equally. "
            "They can be found on an organ with a texture or vertex colours. The colour of this one is set in "
            "the Scene panel under Organ.",
            {.tone = ui::Tone::warning, .wrap = true, .width = ui::grow()});
        return;
    }
    static const TissueHistogram none;
    const TissueHistogram& shown = counts.histogram ? *counts.histogram : none;
    levels(ui, edited, vessels ? vessel_band : fat_band, vessels ? shown.contrast : shown.hue);
    if (vessels) {
        rows(ui, edited, {"vessel_low", "vessel_high"}, TissueHistogram::most_contrast);
        rows(ui, edited, {"vessel_width", "smoothing"}, 5);
        rows(ui, edited, {"vessel_color", "vessel_tolerance"}, 40);
    } else {
        rows(ui, edited, {"fat_low", "fat_high"}, TissueHistogram::most_hue);
        rows(ui, edited, {"smoothing"}, 5);
    }
    if (!counts.faults.empty())
        ui::label(ui, counts.faults.front().text(), {.tone = ui::Tone::error, .wrap = true, .width = ui::grow()});
}

}  // namespace lapfx::panels
