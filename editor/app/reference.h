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
#include <optional>
#include <string>
#include <vector>

#include "app/editor_options.h"
#include "app/preview_host.h"
#include "app/video_feed.h"
#include "document/document.h"
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

class Reference {
  public:
    /// px that the preview is drawn at for comparing, at most.
    static constexpr glm::ivec2 largest_compared{1280, 1024};

    /// All must outlive it.
    Reference(document::Document& document, const Timeline& timeline, PreviewHost& preview, Jobs& jobs,
              Settings& settings, ui::ImageStore& images, Screen& screen, const EditorOptions& options);
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
    /// s of the scene, from the reference's first frame to its end; nothing without video().
    std::optional<ui::Span> span() const;

    // --- shown ------------------------------------------------------------------------------------------------------
    /// Called by the panel in every build: asks for the frame of the present time.
    void follow();
    /// The newest frame that has come.
    ui::Picture picture() const;
    bool good() const { return feed_.good(); }  ///< the file could give it
    /// Both of one size, for compare_view: the scene through its camera at the timeline's time, drawn after this frame;
    /// the reference, counted in the same pixels. Those are the video's, in its aspect.
    ui::Picture compared_preview();
    ui::Picture compared_reference() const;
    /// As large as compare_view shows them (CompareResult::zoom): the preview is drawn with as many pixels, but pixel
    /// for pixel with the video where both are subtracted or single pixels are looked at. Gives whether that is another
    /// size than before.
    bool show_at(double zoom);
    glm::ivec2 drawn_size() const;  ///< px that the preview is drawn at
    CompareWay way = CompareWay::beside;
    ui::CompareState compare;  ///< its view also holds for the reference alone

    // --- of the editor -----------------------------------------------------------------------------------------------
    void set_wake(std::function<void()> wake) { feed_.set_wake(std::move(wake)); }
    /// Once before each frame. `now`: s.
    void update(double now);
    /// Once after each frame: draws the preview for comparing, if it is seen. Gives whether it differs.
    /// `scale`: Shot::scale.
    bool draw(double scale);
    std::size_t memory() const { return copy_.target.memory(); }  ///< bytes on the GPU
    bool compares() const { return compares_; }                   ///< the last build asked for compared_preview()

  private:
    class ReferencePixels;
    class PreviewPixels;

    void put(const std::filesystem::path& file, std::shared_ptr<VideoReader> reader);
    void follow_scene(std::shared_ptr<VideoReader> reader = nullptr);
    void show_newest();
    glm::ivec2 shown_size() const;
    glm::ivec2 compared_size() const;

    document::Document& document_;
    const Timeline& timeline_;
    PreviewHost& preview_;
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
    PreviewCopy copy_;
    std::unique_ptr<ReferencePixels> pixels_, compared_pixels_;
    std::unique_ptr<PreviewPixels> preview_pixels_;
};

/// "frame_%04d.png" for "frame_0012.png" where more of them are numbered on beside it; else the file itself.
std::filesystem::path whole_sequence(const std::filesystem::path& file);

}  // namespace lapfx::app
