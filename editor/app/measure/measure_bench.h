// The frame of the reference that is shown, with what is measured in it drawn over it: blood, smoke, and what is left
// out. It follows the reference and the scene's `reference.measure`, so a person sees at once what a qualifier does.
//
//     bench.update();                                            // once before each frame
//     bench.show();                                              // by the panel: the picture is wanted
//     ui::image_view(ui, "Measured", bench.picture(), bench.look.state);
//
// Frames are measured by a job and never waited for: the picture comes a little later, and the newest request is the
// next that is met. In exact mode everything is done at once. UI thread.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/measure/measuring.h"
#include "ui/canvas/image_view.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class MeasureWork;

/// Colours of what is drawn over the picture; plots of the amounts have them, too (numbers of the theme's series).
inline constexpr int blood_series = 4, smoke_series = 0;

/// What the pointer does on the picture.
enum class MeasureTool : std::uint8_t {
    none,
    pick_blood,   ///< the next click says what blood is
    draw_part,    ///< clicks are corners of a part
    paint_blood,  ///< drags are strokes over what is blood
    paint_other   ///< and over what is not
};

/// How one looks at it; no part of the document.
struct MeasureLook {
    bool blood = true, smoke = true, left_out = true;  ///< drawn over the picture
    MeasureTool tool = MeasureTool::none;
    std::vector<PicturePlace> drawn;    ///< the corners of a part so far
    std::optional<BloodStroke> stroke;  ///< the one that is being painted
    double brush = 0.012;               ///< its radius, share of the picture's width
    static constexpr double least_brush = 0.002, most_brush = 0.1;
    ui::ViewState state;
    bool paints() const { return tool == MeasureTool::paint_blood || tool == MeasureTool::paint_other; }
};

class MeasureBench {
  public:
    /// All must outlive it.
    MeasureBench(document::Document& document, const Reference& reference, const Measuring& measuring, Jobs& jobs,
                 ui::ImageStore& images, Notices& notices, bool exact);
    ~MeasureBench();
    /// Once before each frame, after those of the reference and of `measuring`.
    void update();

    MeasureLook look;

    /// While the UI is built: update() measures from now on, as long as this is called.
    void show() { wanted_ = true; }
    bool shown() const { return shown_; }
    /// Another frame has to come: what is shown is not what was asked for last, and no job will wake the UI.
    bool stale() const;
    bool busy() const { return static_cast<bool>(job_); }
    /// Somebody has cancelled the job for what is wanted. It begins again when something else is wanted, when the panel
    /// is looked at again, or with measure_again().
    bool given_up() const { return given_up_; }
    void measure_again();

    // --- what is shown -----------------------------------------------------------------------------------------------
    bool ready() const { return ready_; }
    ui::Picture picture() const;
    const match::FrameAmounts& amounts() const { return amounts_; }
    int frame() const { return frame_; }           ///< of the reference
    double baseline() const { return baseline_; }  ///< s: of the frame that it is compared with
    const std::vector<Fault>& faults() const { return faults_; }
    /// Of the scene's strokes: why nothing is learned from them. Empty: it is, or there are none.
    const std::vector<Fault>& stroke_faults() const { return stroke_faults_; }
    bool by_strokes() const { return by_strokes_; }  ///< blood is what looks as the strokes say
    int baselines_decoded() const;  ///< how many frames were decoded to be compared with, since it is looked at

    // --- tuning: undo steps ------------------------------------------------------------------------------------------
    /// The colour around a pixel of picture() is blood: sets the qualifier so that it counts as such.
    void pick_blood(glm::ivec2 at);
    /// The corners of look.drawn become a part that is left out; with fewer than three nothing is added. Ends drawing.
    void close_part();
    /// look.stroke becomes one of the scene's; where that has as many as it can have, a notice says so.
    void add_stroke();
    /// Takes a tool in hand, or lays it down where it is already. What was begun with another is dropped.
    void take_tool(MeasureTool tool);
    void lay_down();

  private:
    friend class MeasureWork;
    class Pixels;
    struct Request;
    struct Result;
    const Request& request() const;  ///< the one that would show what is wanted now
    void let_go();
    void start(const Request& request);
    void take(Result& result);

    document::Document& document_;
    const Reference& reference_;
    const Measuring& measuring_;
    Jobs& jobs_;
    ui::ImageStore& images_;
    Notices& notices_;
    bool exact_;
    bool wanted_ = false, shown_ = false, ready_ = false, given_up_ = false;
    std::shared_ptr<MeasureWork> work_;
    std::shared_ptr<Job> job_;
    std::unique_ptr<Request> asked_;      ///< the last one that was asked for
    std::unique_ptr<Request> requested_;  ///< made by request(); kept, so that its texts are not allocated again
    std::unique_ptr<Pixels> pixels_;
    ui::ImageHandle image_ = 0;
    match::FrameAmounts amounts_;
    int frame_ = -1;
    double baseline_ = 0;
    std::weak_ptr<const VideoReader> opened_;  ///< what is shown is of this one
    std::vector<Fault> faults_, stroke_faults_;
    bool by_strokes_ = false;
};

}  // namespace lapfx::app
