// The preview as the editor has it: it follows the document, and draws into a texture that the UI shows. The one place of the
// editor that draws effects; its pixels are those of `lapfx render`. Render thread, context current. No OpenGL in this header.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/target.h"
#include "document/document.h"
#include "lapfx/preview.h"
#include "ui/draw/draw_list.h"

namespace lapfx::app {

/// What one picture shows; its size is that of resize().
struct Shot {
    double time = 0;  ///< s
    SceneCamera camera;
    Overlay overlay = Overlay::none;
};

/// Another place to draw it into, of a size of its own, and what was drawn there last.
struct PreviewCopy {
    Target target;
    Shot shot;
    std::uint64_t revision = 0;  ///< of the host; 0: nothing yet
};

class PreviewHost {
  public:
    explicit PreviewHost(const PreviewOptions& options);
    ~PreviewHost();
    PreviewHost(const PreviewHost&) = delete;
    PreviewHost& operator=(const PreviewHost&) = delete;

    /// Shows the document from the next draw() on. What cannot be shown (a preset whose values contradict each other, a clip that
    /// is gone) leaves what was there before, and is told by faults().
    void follow(const document::Document& document);
    /// Makes room for pictures of this size, px; picture() is another one then. Before the list that shows it is drawn.
    void resize(glm::ivec2 size);
    /// Draws if the picture would differ from the last one; gives whether it did. Nothing is drawn without an organ.
    bool draw(const Shot& shot);
    /// The same into `copy`, whose target has a size.
    bool draw_into(PreviewCopy& copy, const Shot& shot);
    /// Clips play by themselves while time stands only if one is late: whether a draw() would get a better picture.
    bool late() const;

    bool ready() const { return preview_ != nullptr; }
    /// The picture of the last draw(); 0: none yet. Texture name of the UI's renderer.
    ui::ImageHandle picture() const;
    glm::ivec2 size() const;
    /// Read back: what the texture holds.
    Image read() const { return target_.read(); }

    /// What keeps the document from being shown: of the preset and its clips, and of the organ.
    const std::vector<Fault>& preset_faults() const { return preset_faults_; }
    const std::vector<Fault>& organ_faults() const { return organ_faults_; }

    /// Null before the first organ is there. Do not draw with it.
    Preview* preview() { return preview_.get(); }
    const Preview* preview() const { return preview_.get(); }

    // --- a tool in the hand ------------------------------------------------------------------------------------------
    /// From `time` on the tip is on the organ at `place`. The preview shows what it does, the document knows nothing of it yet.
    void put_tool(ToolAction action, double power, double strength, double time, glm::dvec3 place);
    void move_tool(double time, glm::dvec3 place);  ///< straight from where it was, at 100 Hz
    /// What it has done since put_tool(): contacts for the scene's events.
    std::vector<ToolContact> take_tool_off(double time);
    bool tool_on() const { return tool_on_; }

  private:
    void make(const document::Document& document);
    bool draw_into(const Target& target, const Shot& shot, Shot& last, std::uint64_t& drawn);
    void follow_preset(const Preset& preset);
    void follow_scene(const Scene& scene);
    void push_sample(double time, glm::dvec3 place, bool touching);

    PreviewOptions options_;
    std::unique_ptr<Preview> preview_;
    Target target_;
    std::uint64_t followed_ = 0;  ///< version of the document
    std::string scene_text_, preset_text_, organ_key_;
    std::vector<Fault> preset_faults_, organ_faults_;
    bool changed_ = true;
    std::uint64_t revision_ = 1, drawn_ = 0;  ///< of what it shows beside the shot; the one in the target
    Shot last_;
    Overlay overlay_ = Overlay::none;  ///< that the preview has

    bool tool_on_ = false;
    ToolSample tool_;
    std::size_t contacts_before_ = 0;
};

}  // namespace lapfx::app
