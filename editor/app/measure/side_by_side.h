// The page that one sends to a colleague: the preview's picture beside the reference's, and below them how much blood
// and veil both show over the scene's time. `lapfx render --beside` and the editor's exports write it.
//
//     auto page = std::make_unique<SideBySide>(std::make_shared<VideoReader>(file), std::move(compared));
//     output::RenderJob job(scene, preset, options, loaded, std::move(page));
//
// Both pictures are as high as the frame. The reference has its own shape, and lies as the scene places it. The curves
// are drawn with the toolkit, so they look as in the editor. Render thread, context current.
#pragma once

#include <memory>
#include <string_view>

#include "app/measure/compared.h"
#include "app/measure/measured_curve.h"
#include "app/preview/target.h"
#include "lapfx/authoring/video.h"
#include "output/frame_page.h"
#include "ui/core/ui.h"
#include "ui/gl/renderer.h"

namespace lapfx::app {

class SideBySide : public output::FramePage {
  public:
    /// px of a page with frames of `frame` px and a video of `stored` px that is shown in `aspect`
    /// (SceneReference::aspect).
    static glm::ivec2 size_of(glm::ivec2 frame, glm::ivec2 stored, double aspect);

    /// Throws std::runtime_error without fonts.
    SideBySide(std::shared_ptr<VideoReader> video, Compared compared);
    ~SideBySide() override;

    glm::ivec2 size() const override { return size_; }
    const Image& page(double time, const Image& frame) override;

  private:
    void show_reference(double time);
    void draw_strip(double time);
    void build(ui::Ui& ui, double time);
    void plot(ui::Ui& ui, std::string_view name, double time, int color, const MeasuredCurve& preview,
              const MeasuredCurve& reference) const;

    std::shared_ptr<VideoReader> video_;
    Compared compared_;
    glm::ivec2 size_{0};
    float scale_ = 1;  ///< of the strip's text
    int gap_ = 0, reference_width_ = 0;
    ui::Fonts fonts_;
    ui::Ui ui_;
    ui::Renderer renderer_;
    Target strip_;                           ///< below the pictures
    MeasuredCurve blood_[2], veil_[2];       ///< the first is the preview's, the second the reference's
    double most_blood_ = 0, most_veil_ = 0;  ///< %
    double clock_ = 0;                       ///< s, of the toolkit
    int shown_ = -1;                         ///< the frame of the reference that the page has
    Image page_, read_, drawn_;
};

}  // namespace lapfx::app
