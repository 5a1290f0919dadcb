// The surgery video that is to be matched, and how it is compared with the preview. The scene names it; here it is
// opened, followed by the timeline, and shown.
//
//     reference.choose("operation.mp4");  // the scene's reference from now on: an undo step
//     ...
//     while the panel is built:  reference.follow();  ui::image_view(u, "Video", reference.picture(),
//         reference.compare.view);
//
// UI thread; what decodes is beside it (video_feed.h), but with EditorOptions::exact.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "app/base/editor_options.h"
#include "app/reference/compared_regions.h"
#include "app/reference/drawn_picture.h"
#include "app/reference/picture_scopes.h"
#include "app/reference/video_feed.h"
#include "app/tuning/snapshot_previews.h"
#include "document/document.h"
#include "document/steps.h"
#include "ui/canvas/axis.h"
#include "ui/canvas/compare_view.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class Job;
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

/// How the scopes of the compared pictures are looked at; no part of the document.
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

class Reference {
  public:
    /// px that the preview is drawn at for comparing, at most.
    static constexpr glm::ivec2 largest_compared{1280, 1024};

    /// All must outlive it.
    Reference(document::Document& document, const Timeline& timeline, PreviewHost& preview, SnapshotPreviews& snapshots,
              Jobs& jobs, Settings& settings, ui::ImageStore& images, Screen& screen, const EditorOptions& options);
    ~Reference();

    // --- which ------------------------------------------------------------------------------------------------------
    /// Opens the file in a job and then, as one undo step, makes it the scene's reference, from its first frame on. If
    /// it cannot be opened, refused() says why and the present reference stays. One of several numbered images stands
    /// for all of them.
    void choose(const std::filesystem::path& file);
    /// What was wrong in the last choose(), until another reference comes.
    const std::vector<Fault>& refused() const { return refused_; }
    void forget_refused() { refused_.clear(); }
    /// Another document has been opened: what is being opened is not for that one.
    void give_up_choosing();
    void choose_sample();
    void remove();
    bool named() const { return !file_.empty(); }                ///< the scene names one
    const std::filesystem::path& file() const { return file_; }  ///< where it is
    bool opening() const { return feed_.opening() || choosing_; }
    const std::filesystem::path& opens() const { return choosing_ ? chosen_ : file_; }  ///< while opening()
    const VideoReader* video() const { return feed_.video().get(); }  ///< null: none that can be shown
    /// The same; another one with every opening, also of the same file.
    const std::shared_ptr<const VideoReader>& opened() const { return feed_.video(); }
    const std::vector<Fault>& faults() const { return feed_.faults(); }

    // --- when -------------------------------------------------------------------------------------------------------
    /// s in the reference: the scene's time and the offset, or of the frame that is held. May be outside of it.
    double time() const;
    int frame() const;  ///< the one for that time; -1 without video()
    /// Keeps to this frame whatever the timeline does: to find what belongs to a moment of the scene.
    void hold(int frame);
    void step(int frames) { hold(frame() + frames); }
    void let_go() { held_.reset(); }
    bool held() const { return held_.has_value(); }
    /// An undo step: the offset with which the frame that is held belongs to the scene's time as it is; it is let go.
    void align();
    /// An undo step: what the row of `marks` means happens at time(). Nothing outside of the video.
    void mark(const Parameter& row);
    void clear_marks();                ///< the same: nothing is marked any more
    bool any_mark() const;             ///< something is marked
    static const Table& mark_table();  ///< of ReferenceMarks: a row for each mark
    /// s of the scene, from the reference's first frame to its end; nothing without video().
    std::optional<ui::Span> span() const;

    // --- shown ------------------------------------------------------------------------------------------------------
    /// Called by the panel in every build: asks for the frame of the present time.
    void follow();
    /// The newest frame that has come.
    ui::Picture picture() const;
    const Image& image() const { return feed_.image(); }  ///< the same, as the file has it
    /// image(), for who keeps it: it stays what it is.
    const std::shared_ptr<const Image>& shared_image() const { return feed_.shared_image(); }
    int shown_frame() const { return feed_.frame(); }  ///< its number; -1: none has come
    bool good() const { return feed_.good(); }         ///< the file could give it
    /// What is compared, the first and the second.
    std::array<CompareSide, 2> sides{CompareSide::preview, CompareSide::reference};
    /// Puts it on that side; what lay there changes places with it if it is on the other.
    void put(std::size_t side, CompareSide what);
    bool compares_video() const;  ///< the reference lies on one of the sides; else it need not be there
    /// Slot of a snapshot on one of the sides in which nothing is kept; Snapshots::count: none.
    std::size_t empty_side() const;
    /// Slot of the first snapshot that is kept; Snapshots::count: none.
    std::size_t first_kept() const;
    /// A picture of one of the sides, both of one size. Its image is 0 while there is none.
    ui::Picture compared(CompareSide side);
    /// Both of one size, for compare_view: the scene through its camera at the timeline's time, drawn after this frame;
    /// the reference, counted in the same pixels. Those are the video's, in its aspect.
    ui::Picture compared_preview();
    ui::Picture compared_reference() const;
    /// picture() where the scene places it (SceneReference::placement). What is read of a picture is read of the one
    /// that is seen: scopes, regions and the eyedropper take the placed one where both are compared, and black where it
    /// has nothing; the reference alone, what is measured of it, its plate and a proposal of
    /// the look are of the video as it is stored: they are about all of its tissue, wherever that lies.
    ui::Picture placed_picture() const;
    /// An undo step: placed so that its round view lies on the preview's vignette, which is turned on; of a squeezed
    /// video with its proposed_aspect(). look_notes() say what was found.
    void take_circle();
    /// Width over height at which the round view of the video is round, where the scene has no aspect yet and the video
    /// is stored squeezed: looked for in its first frames that are shown. None: it looks right, or shows no round view,
    /// or that was left.
    const std::optional<double>& proposed_aspect() const { return proposed_aspect_; }
    void take_aspect();  ///< an undo step
    void leave_aspect();
    /// 0..1 while the plate is being made, negative where nobody knows; none: it is not.
    std::optional<double> plate_progress() const;
    bool placing = false;  ///< handles to place it lie over the comparison
    /// As large as compare_view shows them (CompareResult::zoom): the preview is drawn with as many pixels, but pixel
    /// for pixel with the video where both are subtracted or single pixels are looked at. Gives whether that is another
    /// size than before.
    bool show_at(double zoom);
    glm::ivec2 drawn_size() const;     ///< px that the preview is drawn at
    glm::ivec2 compared_size() const;  ///< px of compared_preview()
    Shot compared_shot() const;        ///< what that shows, whole
    /// What was counted in the frame that is shown is drawn over it. Colours are read of the frame as it is.
    bool shows_counted = false;
    bool counted_shown() const { return overlaid_by_.second != 0; }
    /// Of the frame at that time, s: a number for what was counted there, 0 for nothing; drawn over the picture unless
    /// it is null (Measuring::counted).
    using Counted = std::function<std::uint64_t(double time, Image* picture)>;
    void set_counted(Counted draws) { count_ = std::move(draws); }
    CompareWay way = CompareWay::beside;
    void next_way() { way = static_cast<CompareWay>((static_cast<std::size_t>(way) + 1) % way_titles.size()); }
    ui::CompareState compare;  ///< its view also holds for the reference alone
    ScopesLook scopes_look;
    /// While the UI is built: both pictures, or the reference alone, are counted after this frame and whenever they
    /// change, as long as this is called. What was counted last.
    /// Of the first and the second side; of the reference alone they are the second.
    const std::array<PictureScopes, 2>& scopes();
    /// Counted with them while they are what is looked at.
    const ComparedRegions& regions() const { return regions_; }

    // --- look --------------------------------------------------------------------------------------------------------
    /// After this frame, or when frame() is decoded: camera and look as that frame proposes them
    /// (match/explain/scene_look.h), against the preview at 0 s, without blood and smoke. Nothing changes until it is
    /// taken. None while the plate stands in for the organ: it is the reference itself.
    void propose_look();
    /// And neither taken nor left yet. It is left once the organ, camera, light, colours or the plate that it was made
    /// for are others, or the reference is.
    bool look_proposed() const { return look_ != nullptr; }
    void take_look();  ///< one undo step
    void leave_look();
    /// What the last proposal found and what not, a sentence each; of what was done they go when that is undone.
    const std::vector<std::string>& look_notes() const { return look_notes_; }
    void forget_look_notes() { say({}); }

    // --- of the editor -----------------------------------------------------------------------------------------------
    void set_wake(std::function<void()> wake) { feed_.set_wake(std::move(wake)); }
    /// Once before each frame. `now`: s.
    void update(double now);
    /// Once after each frame: draws the preview for comparing, if it is seen. Gives whether it differs.
    /// `scale`: Shot::scale.
    bool draw(double scale);
    std::size_t memory() const;                  ///< bytes on the GPU, with the previews of snapshots
    bool compares() const { return compares_; }  ///< the last build asked for compared_preview()

  private:
    class ReferencePixels;
    /// Number of the frame, the placement and the aspect.
    using PlacedBy = std::tuple<std::uint64_t, double, double, double, double, double>;

    void take(const std::filesystem::path& file, std::shared_ptr<VideoReader> reader);
    void follow_scene(std::shared_ptr<VideoReader> reader = nullptr);
    void show_newest();
    void upload();
    void follow_counted();
    void place_newest();
    bool is_placed() const;
    bool shows_placed() const;  ///< in the panel
    glm::ivec2 shown_size() const;
    glm::ivec2 size_with(double aspect) const;
    ui::Picture drawn(DrawnPicture& picture, const PreviewHost* preview);
    bool draw_compared(double scale);
    bool draw_compared(DrawnPicture& picture, PreviewHost& preview, double scale);
    /// The newest picture of that side, with its number.
    const Image* newest(CompareSide side, std::uint64_t& number) const;
    void count_scopes();
    bool count_regions();
    void follow_video();
    void forget_regions(std::size_t side);
    int frame_of(CompareSide side) const;
    void follow_proposal();
    void make_proposal();
    void leave_stale_look();
    void say(std::vector<std::string> notes, document::WatchedStep step = {});
    void forget_undone();
    void look_for_aspect();

    document::Document& document_;
    const Timeline& timeline_;
    PreviewHost& preview_;
    SnapshotPreviews& snapshots_;
    Jobs& jobs_;
    Settings& settings_;
    ui::ImageStore& images_;
    Screen& screen_;
    std::filesystem::path data_folder_;
    VideoFeed feed_;
    std::filesystem::path file_;
    std::shared_ptr<Job> choosing_;  ///< opens `chosen_`
    std::filesystem::path chosen_;
    std::vector<Fault> refused_;
    std::uint64_t followed_ = 0;  ///< version of the document
    std::optional<int> held_;
    ui::ImageHandle image_ = 0;  ///< of the editor's images
    bool compares_ = false;
    double zoom_ = 0;  ///< pixels of the screen per pixel of compared_size(); 0: not known yet
    DrawnPicture drawn_;
    std::array<DrawnPicture, Snapshots::count> drawn_snapshots_;
    std::array<bool, Snapshots::count> compares_snapshot_{};  ///< the last build asked for them
    std::array<std::uint64_t, Snapshots::count> drawn_by_{};  ///< numbers of the previews that drew them
    std::unique_ptr<ReferencePixels> pixels_, compared_pixels_, placed_pixels_;
    Counted count_;
    Image overlaid_;                                         ///< the frame with what was counted, where counted_shown()
    std::pair<std::uint64_t, std::uint64_t> overlaid_by_{};  ///< number of the frame, and of what is drawn over it
    PlacedBy placed_by_{};
    Image placed_;
    ui::ImageHandle placed_image_ = 0;
    bool proposes_ = false;
    DrawnPicture clean_;  ///< the preview at 0 s, for a proposal
    struct ProposedLook;
    std::shared_ptr<ProposedLook> look_;  ///< null: none is
    std::vector<std::string> look_notes_;
    document::WatchedStep noted_step_;  ///< that the notes tell of; none: of nothing that was done
    std::optional<double> proposed_aspect_;
    int looked_for_aspect_ = 0;  ///< in so many frames of this video
    bool counts_ = false;        ///< the last build asked for scopes()
    std::array<PictureScopes, 2> scopes_;
    ComparedRegions regions_;
    std::uint64_t shown_ = 0;  ///< how many frames have been shown
    /// The pictures that were counted.
    std::array<std::pair<CompareSide, std::uint64_t>, 2> counted_{};
    /// Of what the regions were counted: as long as it is the same, their curve holds.
    struct Subject {
        CompareSide side{};
        std::uint64_t document = 0;          ///< version of what is drawn
        std::uint64_t snapshot = 0;          ///< SnapshotPreviews::id
        std::optional<std::size_t> alone{};  ///< the clip that the preview plays alone
        PlacedBy placed{};                   ///< of the reference: where another part of it lies under a region
        friend bool operator==(const Subject&, const Subject&) = default;
    };
    Subject subject_of(CompareSide side) const;
    struct RegionsOf {
        std::optional<Subject> subject;
        std::uint64_t picture = 0;  ///< number of the one that was counted last
    };
    std::array<RegionsOf, 2> regions_of_{};
    std::weak_ptr<const VideoReader> regions_video_;  ///< whose frames they are of
};

/// "frame_%04d.png" for "frame_0012.png" where more of them are numbered on beside it; else the file itself.
std::filesystem::path whole_sequence(const std::filesystem::path& file);

}  // namespace lapfx::app
