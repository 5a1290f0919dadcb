// What the scene's regions look like in the two pictures that are compared, now and over the reference's time.
//
//     regions.follow(scene.reference.regions, blood);       // others than before: everything is forgotten
//     regions.count(0, preview_image, frame);               // whenever a picture has changed
//     regions.count(1, video_image, frame);
//     plot(regions.curve(0, region, RegionFigure::veil));
//
// Curves fill as the timeline plays or is dragged: what was once seen stays until it would differ. UI thread.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lapfx/organ.h"
#include "lapfx/scene.h"
#include "match/compare/region.h"

namespace lapfx::app {

/// What is plotted of a region.
enum class RegionFigure : std::uint8_t { brightness, contrast, veil, red, distance };
struct RegionFigureRow {
    std::string_view title;
    std::string_view help;
    std::string_view unit;
};
inline constexpr std::array<RegionFigureRow, 5> region_figures = {{
    {"Brightness", "Luma of the region's mean colour", "%"},
    {"Contrast", "Standard deviation of the luma", "%"},
    {"Veil", "Mean dark channel: the least of red, green and blue near by, which smoke lifts", "%"},
    {"Red area", "Share of the area that is as red as the Measure panel says of blood", "%"},
    {"Distance", "Between the mean colours of both pictures, CIE 1976: 2 is just seen, 10 is plain", ""},
}};
/// In the row's unit. The distance is of two: not for this.
double figure_of(const match::RegionFigures& figures, RegionFigure figure);

class ComparedRegions {
  public:
    static constexpr std::size_t sides = 2;

    void follow(const std::vector<ComparedRegion>& regions, const BloodQualifier& blood);
    /// Another picture lies there, or it would look different now.
    void forget(std::size_t side);
    /// `frame`: of the reference, which the picture belongs to; below 0: it belongs to none and is in no curve.
    void count(std::size_t side, const Image& image, int frame);

    bool counted(std::size_t side) const { return sides_[side].counted; }
    const match::RegionFigures& now(std::size_t side, std::size_t region) const { return sides_[side].now[region]; }
    /// Fills places (frames of the reference, ascending) and values in the figure's unit. The distance, where both
    /// pictures were seen at that frame, is the same on either side.
    void curve(std::size_t side, std::size_t region, RegionFigure figure, std::vector<double>& frames,
               std::vector<double>& values) const;
    std::uint64_t version() const { return version_; }  ///< grows with every change of a figure

  private:
    using Figures = std::array<match::RegionFigures, most_compared_regions>;
    struct Sample {
        int frame = 0;
        Figures figures;
    };
    struct Side {
        bool counted = false;
        Figures now;
        std::vector<Sample> samples;  ///< ascending frames
    };

    std::vector<ComparedRegion> regions_;
    BloodQualifier blood_;
    std::array<Side, sides> sides_;
    std::uint64_t version_ = 0;
};

}  // namespace lapfx::app
