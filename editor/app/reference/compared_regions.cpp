#include "app/reference/compared_regions.h"

#include <algorithm>

namespace lapfx::app {

namespace {

/// Longer videos than this, in frames, are plotted as far as they were seen first.
constexpr std::size_t most_samples = 20'000;

bool same(const ComparedRegion& a, const ComparedRegion& b) {
    return a.x == b.x && a.y == b.y && a.width == b.width && a.height == b.height;
}

bool same(const BloodQualifier& a, const BloodQualifier& b) {
    return a.redness == b.redness && a.rise == b.rise && a.brightness == b.brightness;
}

}  // namespace

double figure_of(const match::RegionFigures& figures, RegionFigure figure) {
    switch (figure) {
        case RegionFigure::brightness: {
            const glm::dvec3& c = figures.color;
            return 100 * (0.299 * c.r + 0.587 * c.g + 0.114 * c.b);
        }
        case RegionFigure::contrast:
            return 100 * figures.contrast;
        case RegionFigure::veil:
            return 100 * figures.veil;
        case RegionFigure::red:
            return 100 * figures.red;
        case RegionFigure::distance:
            break;
    }
    return 0;
}

void ComparedRegions::follow(const std::vector<ComparedRegion>& regions, const BloodQualifier& blood) {
    const bool regions_stay = std::equal(regions.begin(), regions.end(), regions_.begin(), regions_.end(),
                                         [](const auto& a, const auto& b) { return same(a, b); });
    if (regions_stay && same(blood, blood_)) return;
    regions_ = regions;
    blood_ = blood;
    for (std::size_t side = 0; side < sides; ++side) forget(side);
}

void ComparedRegions::forget(std::size_t side) {
    sides_[side].counted = false;
    sides_[side].samples.clear();
    ++version_;
}

void ComparedRegions::count(std::size_t side, const Image& image, int frame) {
    Side& on = sides_[side];
    const std::size_t regions = std::min(regions_.size(), most_compared_regions);
    for (std::size_t i = 0; i < regions; ++i) on.now[i] = match::figures_of(image, regions_[i], blood_);
    on.counted = true;
    ++version_;
    if (frame < 0) return;
    const auto at = std::lower_bound(on.samples.begin(), on.samples.end(), frame,
                                     [](const Sample& sample, int wanted) { return sample.frame < wanted; });
    if (at != on.samples.end() && at->frame == frame)
        at->figures = on.now;
    else if (on.samples.size() < most_samples)
        on.samples.insert(at, {.frame = frame, .figures = on.now});
}

void ComparedRegions::curve(std::size_t side, std::size_t region, RegionFigure figure, std::vector<double>& frames,
                            std::vector<double>& values) const {
    frames.clear();
    values.clear();
    const auto add = [&](int frame, double value) {
        frames.push_back(frame);
        values.push_back(value);
    };
    const std::vector<Sample>& samples = sides_[side].samples;
    if (figure != RegionFigure::distance) {
        for (const Sample& sample : samples) add(sample.frame, figure_of(sample.figures[region], figure));
        return;
    }
    const std::vector<Sample>& others = sides_[1 - side].samples;
    auto other = others.begin();
    for (const Sample& sample : samples) {
        while (other != others.end() && other->frame < sample.frame) ++other;
        if (other != others.end() && other->frame == sample.frame)
            add(sample.frame, match::distance(sample.figures[region], other->figures[region]));
    }
}

}  // namespace lapfx::app
