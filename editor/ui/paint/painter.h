// Drawing for widgets: shapes, lines, text and pictures into the DrawList of this frame, clipped to the widget's part
// of the screen. Text stands on whole pixels.
#pragma once

#include <string>
#include <string_view>

#include "ui/draw/images.h"
#include "ui/paint/theme.h"
#include "ui/text/fonts.h"

namespace lapfx::ui {

enum class Align : std::uint8_t { start, center, end };

/// Drawn with lines and rectangles, crisp at any scale.
enum class Icon : std::uint8_t {
    none,
    check,
    minus,
    plus,
    cross,
    chevron_right,
    chevron_down,
    chevron_up,
    chevron_left,
    search,
    dot,
    menu,
    lock,
    unlock,
    play,
    pause,
    loop,
    step_back,
    step_forward,
    star,
    star_filled,
    undo,
    folder,
    file,
    eye,
    eyedropper,
    warning,
    error,
    info,
    reset,
    copy,
    dice,
    link,
    gear,
    image,
    sort_up,
    sort_down,
};

inline constexpr std::size_t icon_count = static_cast<std::size_t>(Icon::sort_down) + 1;
std::string_view name_of(Icon icon);  ///< "chevron right"

/// How two pictures are shown over each other. A compare instance (CompareInstance) holds it so: uv[0] position in
/// 1/65535, uv[1] angle in 1/65536 turn, uv[2] gain as a half float, uv[3] mix in 1/65535, radius the mode, border
/// bits: 1 nearest, 2 the first picture is upside down (a host's texture), 4 the second is.
enum class CompareMode : std::uint8_t { wipe, difference, onion };
struct CompareLook {
    CompareMode mode = CompareMode::wipe;
    float position = 0.5F;  ///< wipe: where the line crosses the middle of the rectangle, 0..1 along its normal
    float angle = 0;        ///< wipe, rad: 0 an upright line, the first picture on its left
    float gain = 1;         ///< difference: abs(a - b) * gain, 0.1 to 100
    float mix = 0.5F;       ///< onion: share of the second
    bool nearest = false;
};

class Painter {
  public:
    Painter(DrawList& list, Fonts& fonts, const Theme& theme, float scale);

    const Theme& theme() const { return theme_; }
    Fonts& fonts() const { return fonts_; }
    /// px of `ems` font heights, rounded to whole px.
    float em(float ems) const { return whole(ems * theme_.font_size * scale_); }
    /// One px at scale 1, two from scale 1.75: the width of hairlines.
    float hairline() const { return scale_ < 1.75F ? 1.0F : std::round(scale_); }
    float scale() const { return scale_; }
    TextStyle text_style(float relative_size = 1, Weight weight = Weight::regular) const;
    TextStyle number_style() const;

    void fill(const Rect& rect, Color color, float radius = 0);
    /// The opaque background of what is drawn next. Where nothing lies under it, it is a clear, which costs a software
    /// renderer an eighth of a fill. No instances of the same node may lie under it.
    void ground(const Rect& rect, Color color);
    /// Inside `rect`; `width` is rounded to whole px, 1 at least. Right after the fill of the same rectangle it costs
    /// nothing.
    void frame(const Rect& rect, Color color, float width, float radius = 0);
    /// Full inside, gone `softness` px outside.
    void shadow(const Rect& rect, Color color, float softness, float radius = 0);
    void line(glm::vec2 from, glm::vec2 to, float width, Color color);
    void polyline(std::span<const glm::vec2> points, float width, Color color);
    void gradient(const Rect& rect, Color from, Color to, bool vertical);
    void checker(const Rect& rect, Color light, Color dark, float square);
    /// The whole picture, straight alpha. Rows of a stored image go down from the top; a host's texture has its first
    /// row at the bottom, as OpenGL draws it, and is turned over.
    void image(const Rect& rect, ImageHandle image, bool nearest = false, Color tint = {255, 255, 255, 255});
    void compare(const Rect& rect, ImageHandle first, ImageHandle second, const CompareLook& look);
    /// In the middle of `rect`, as large as its shorter side. Strokes may overlap: give it an opaque colour.
    void icon(const Rect& rect, Icon icon, Color color);
    /// One line, vertically centred; too long: cut with an ellipsis. Returns the width drawn, px; 0 where `rect` is
    /// clipped away.
    float text(const Rect& rect, std::string_view text, const TextStyle& style, Color color,
               Align align = Align::start);
    /// The same with the run at hand: Ui has looked it up to measure it, and it holds until the end of the frame.
    float text(const Rect& rect, std::string_view text, const Run& run, const TextStyle& style, Color color,
               Align align = Align::start);
    /// The same for a path, whose end matters: its beginning gives way to the ellipsis.
    float path(const Rect& rect, std::string_view text, const TextStyle& style, Color color);
    /// Draws a run from a baseline without changes; for text fields, which place runs themselves.
    void run(const Run& run, glm::vec2 baseline, Color color);

    void set_clip(const Rect& rect);   ///< replaces the innermost clip
    void push_clip(const Rect& rect);  ///< within the clip so far
    void pop_clip();
    const Rect& clip() const { return clips_.back().rect; }

    // For the core, once a node: instances of two nodes are never merged, so that those of one can be used again.
    /// `bottom`: no instances lie under the node.
    void begin_node(bool bottom) {
        node_ = {instances(), list_.batches.size(), list_.clears.size(), bottom};
        pictures_ = false;
    }
    std::uint32_t node_begin() const { return node_.instances; }
    std::uint32_t instances() const { return static_cast<std::uint32_t>(list_.instances.size()); }
    /// Whether all since begin_node() was instances within clip(), without pictures. `first`: the first of them.
    bool drawn_plainly(std::uint32_t& first);
    /// Instances of another list, with clip() for theirs. Returns the index of the first.
    std::uint32_t copy(std::span<const Instance> instances);
    /// Leaves room for them without copying. Returns false if that is not possible because their clip has another index
    /// now.
    bool keep_places(std::span<const Instance> instances);

    // For the core, once a frame:
    void clear(const Rect& rect, Color color);  ///< before all else, whatever the order of calls; opaque
    void start(glm::ivec2 size);
    /// Closes the last batch, notes the serials of what is shown.
    void finish(const ImageStore* images);

  private:
    Instance& add(InstanceKind kind, Color color);
    bool frame_last_fill(const Rect& rect, Color color, std::uint8_t border, std::uint8_t radius);
    void need_batch(ImageHandle first, ImageHandle second);
    std::uint8_t clip_index() {
        const ClipLevel& clip = clips_.back();
        return clip.batch != 0 && clip.batch == list_.batches.size() ? clip.index : enter_clip();
    }
    std::uint8_t enter_clip();
    bool hidden(const Rect& rect) const { return !rect.overlaps(clips_.back().rect); }

    DrawList& list_;
    Fonts& fonts_;
    const Theme& theme_;
    float scale_;
    std::vector<ClipLevel>& clips_;  ///< stack
    std::string& elided_;
    struct {
        std::uint32_t instances = 0;
        std::size_t batches = 0, clears = 0;
        bool bottom = false;
    } node_;                 ///< as begin_node() found it
    bool pictures_ = false;  ///< an instance with images since then
};

}  // namespace lapfx::ui
