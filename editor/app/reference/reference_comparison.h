// How the reference is compared with the preview, and with snapshots of presets: which picture lies on which side,
// drawn and counted in the same pixels, and what scopes and regions say of both.
//
//     while the panel is built:  ui::compare_view(u, "Comparison", comparison.picture(comparison.sides[0]),
//                                                 comparison.picture(comparison.sides[1]), comparison.state);
//     after each frame:          comparison.draw(scene_scale);
//
// No part of the document. UI thread, context current.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "app/reference/compared_regions.h"
#include "app/reference/drawn_picture.h"
#include "app/reference/picture_scopes.h"
#include "app/reference/reference_picture.h"
#include "app/tuning/snapshot_previews.h"
#include "document/document.h"
#include "ui/canvas/compare_view.h"

namespace lapfx::app {

class Reference;
class Screen;
class Settings;
class Timeline;

enum class CompareWay : std::uint8_t { reference, beside, wipe, difference, onion };
inline constexpr std::array<std::string_view, 5> way_titles = {"Reference", "Side by side", "Wipe", "Difference",
                                                               "Onion"};

/// What can lie on a side of the comparison: the document's preset, the video, or a snapshot of a preset.
enum class CompareSide : std::uint8_t { preview, reference, a, b, c, d };
inline constexpr std::array<std::string_view, 2 + Snapshots::count> side_titles = {
    "Preview", "Reference", "Snapshot A", "Snapshot B", "Snapshot C", "Snapshot D"};
constexpr CompareSide side_of(std::size_t slot) {
    return static_cast<CompareSide>(static_cast<std::size_t>(CompareSide::a) + slot);
}
/// Snapshots::count for what is none.
constexpr std::size_t slot_of(CompareSide side) {
    return side < CompareSide::a ? Snapshots::count
                                 : static_cast<std::size_t>(side) - static_cast<std::size_t>(CompareSide::a);
}

/// How the scopes of the compared pictures are looked at.
struct ScopesLook {
    enum Kind : int { all, levels, waves, vectors, regions };
    bool on = false;
    int kind = all;
    Channel channel = Channel::luma;  ///< of the levels
    bool log_counts = true;
    float pictures = 0.6F;   ///< share of the panel that the pictures have
    std::size_t region = 0;  ///< of the scene's: the one that is plotted
    RegionFigure figure = RegionFigure::veil;
    bool shows_regions() const { return on && kind == regions; }
};

class ReferenceComparison {
  public:
    static constexpr glm::ivec2 largest =
        ReferencePicture::without_video;  ///< px that the preview is drawn at, at most

    /// All must outlive it; it is a part of `reference`.
    ReferenceComparison(const Reference& reference, const document::Document& document, const Timeline& timeline,
                        PreviewHost& preview, SnapshotPreviews& snapshots, const Settings& settings,
                        ui::ImageStore& images, Screen& screen);
    ReferenceComparison(const ReferenceComparison&) = delete;
    ReferenceComparison& operator=(const ReferenceComparison&) = delete;

    // --- sides -------------------------------------------------------------------------------------------------------
    /// What is compared, the first and the second.
    std::array<CompareSide, 2> sides{CompareSide::preview, CompareSide::reference};
    /// Puts it on that side; what lay there changes places with it if it is on the other.
    void put(std::size_t side, CompareSide what);
    bool compares_video() const;  ///< the reference lies on one of the sides; else it need not be there
    /// Slot of a snapshot on one of the sides in which nothing is kept; Snapshots::count: none.
    std::size_t empty_side() const;
    /// Slot of the first snapshot that is kept; Snapshots::count: none.
    std::size_t first_kept() const;
    /// Both, next to each other where the reference was shown alone.
    void show(const std::array<CompareSide, 2>& both);
    CompareWay way = CompareWay::beside;
    void next_way() { way = static_cast<CompareWay>((static_cast<std::size_t>(way) + 1) % way_titles.size()); }
    ui::CompareState state;  ///< its view also holds for the reference alone
    bool placing = false;    ///< handles to place the reference lie over the comparison

    // --- pictures ----------------------------------------------------------------------------------------------------
    /// A picture of one of the sides, both of one size. Its image is 0 while there is none.
    ui::Picture picture(CompareSide side);
    /// Both of one size, for compare_view: the scene through its camera at the timeline's time, drawn after this frame;
    /// the reference, counted in the same pixels. Those are the video's, in its aspect.
    ui::Picture preview();
    ui::Picture reference() const;
    /// As large as compare_view shows them (CompareResult::zoom): the preview is drawn with as many pixels, but pixel
    /// for pixel with the video where both are subtracted or single pixels are looked at. Gives whether that is another
    /// size than before.
    bool show_at(double zoom);
    glm::ivec2 drawn_size() const;  ///< px that the preview is drawn at
    glm::ivec2 size() const;        ///< px of preview()
    Shot shot() const;              ///< what that shows, whole

    // --- figures -----------------------------------------------------------------------------------------------------
    ScopesLook scopes_look;
    /// While the UI is built: both pictures, or the reference alone, are counted after this frame and whenever they
    /// change, as long as this is called. What was counted last, of the first and the second side; of the reference
    /// alone they are the second.
    const std::array<PictureScopes, 2>& scopes();
    /// Counted with them while they are what is looked at.
    const ComparedRegions& regions() const { return regions_; }

    // --- of the editor -----------------------------------------------------------------------------------------------
    void update();        ///< once before each frame
    void follow_video();  ///< it may be another one
    /// Once after each frame: draws what is compared, if it is seen, and counts it. Gives whether it differs. `scale`:
    /// Shot::scale.
    bool draw(double scale);
    bool wanted() const { return compares_; }  ///< the last build asked for preview()
    std::size_t memory() const;                ///< bytes on the GPU, with the previews of snapshots

  private:
    /// Of what the regions were counted: as long as it is the same, their curve holds.
    struct Subject {
        CompareSide side{};
        std::uint64_t document = 0;          ///< version of what is drawn
        std::uint64_t snapshot = 0;          ///< SnapshotPreviews::id
        std::optional<std::size_t> alone{};  ///< the clip that the preview plays alone
        ReferencePicture::Place placed{};    ///< of the reference: where another part of it lies under a region
        friend bool operator==(const Subject&, const Subject&) = default;
    };
    struct RegionsOf {
        std::optional<Subject> subject;
        std::uint64_t picture = 0;  ///< number of the one that was counted last
    };

    bool shows_placed() const;  ///< in the panel
    ui::Picture drawn(DrawnPicture& picture, const PreviewHost* preview);
    bool draw_pictures(double scale);
    bool draw(DrawnPicture& picture, PreviewHost& preview, double scale);
    /// The newest picture of that side, with its number.
    const Image* newest(CompareSide side, std::uint64_t& number) const;
    void count_scopes();
    bool count_regions();
    void forget_regions(std::size_t side);
    int frame_of(CompareSide side) const;
    Subject subject_of(CompareSide side) const;

    const Reference& reference_;
    const document::Document& document_;
    const Timeline& timeline_;
    PreviewHost& preview_;
    SnapshotPreviews& snapshots_;
    const Settings& settings_;
    Screen& screen_;
    bool compares_ = false;
    double zoom_ = 0;  ///< pixels of the screen per pixel of size(); 0: not known yet
    DrawnPicture drawn_;
    std::array<DrawnPicture, Snapshots::count> drawn_snapshots_;
    std::array<bool, Snapshots::count> compares_snapshot_{};  ///< the last build asked for them
    std::array<std::uint64_t, Snapshots::count> drawn_by_{};  ///< numbers of the previews that drew them
    bool counts_ = false;                                     ///< the last build asked for scopes()
    std::array<PictureScopes, 2> scopes_;
    std::array<std::pair<CompareSide, std::uint64_t>, 2> counted_{};  ///< the pictures that were counted
    ComparedRegions regions_;
    std::array<RegionsOf, 2> regions_of_{};
    std::weak_ptr<const VideoReader> regions_video_;  ///< whose frames they are of
};

}  // namespace lapfx::app
