#include "ui/shell/file_preview.h"

#include "ui/core/node.h"
#include "ui/value/utf8.h"
#include "ui/widgets/literal.h"

namespace lapfx::ui {

namespace {

constexpr float aspect = 1.25F;           // of the frame: that of an endoscope's picture
constexpr std::size_t fault_bytes = 200;  // that are shown; the tooltip has all

struct PictureLook {
    ImageHandle image;
    glm::vec2 size;
    Icon icon;
    std::string_view hint;  ///< shown instead of everything else
    friend bool operator==(const PictureLook&, const PictureLook&) = default;
};

void draw_picture(Painter& painter, const Node& node, const PictureLook& look) {
    const Theme& t = painter.theme();
    const Rect rect = node.rect();
    if (!look.hint.empty()) {
        painter.text(rect, look.hint, painter.text_style(), t.text_dim, Align::center);
        return;
    }
    painter.fill(rect, t.canvas);
    if (look.image == 0) {
        if (look.icon != Icon::none) painter.icon(rect.inset(rect.w * 0.4F, rect.h * 0.4F), look.icon, t.text_dim);
        return;
    }
    const float scale = std::min(rect.w / look.size.x, rect.h / look.size.y);
    const glm::vec2 size = glm::max(glm::round(look.size * scale), glm::vec2(1));
    const glm::vec2 at = glm::round(rect.center() - size / 2.0F);
    painter.image({at.x, at.y, size.x, size.y}, look.image);
}

Icon icon_of(const FileEntry& file, FilePicture::State state) {
    if (file.folder) return Icon::folder;
    return state == FilePicture::State::coming ? Icon::image : Icon::file;
}

/// The beginning of a long text; no character is cut.
std::string_view shortened(Ui& ui, std::string_view text) {
    if (text.size() <= fault_bytes) return text;
    return ui.join({text.substr(0, code_point_at(text, fault_bytes)), "..."});
}

std::string_view words_for(const LookedAt* file, FilePicture::State state) {
    using State = FilePicture::State;
    if (file == nullptr) return "nothing is selected";
    if (file->file.folder) return "a folder";
    return state == State::coming ? "being made" : state == State::there ? "a picture" : "no picture";
}

}  // namespace

void file_preview(Ui& ui, FilePictures& pictures, const LookedAt* file, float width) {
    const Column column(ui, {.width = px(ui.em(width)), .height = grow(), .gap = 0.2F});
    using State = FilePicture::State;
    FilePicture picture;
    if (file != nullptr && !file->file.folder) picture = pictures.picture(ui, file->path, file->file);
    Node& frame = ui.leaf(Role::image, "Preview");
    frame.size[0] = grow();
    frame.size[1] = px(std::round(ui.em(width) / aspect));
    frame.is |= when(picture.state == State::coming, Is::busy);
    frame.text = words_for(file, picture.state);
    PictureLook look{0, glm::vec2(picture.size), Icon::none, file == nullptr ? "Selected files are shown here" : ""};
    if (file != nullptr) look.icon = icon_of(file->file, picture.state);
    if (picture.state == State::there && picture.size.x > 0 && picture.size.y > 0) look.image = picture.image;
    ui.draw_with<draw_picture>(frame, look);
    if (file == nullptr) return;
    literal_line(ui, file->file.name);
    if (!file->about.empty()) label(ui, file->about, {.tone = Tone::dim, .number = true, .width = grow()});
    if (picture.state == State::coming) label(ui, "The picture is being made", {.tone = Tone::dim, .wrap = true});
    if (picture.state == State::failed) literal(ui, shortened(ui, picture.fault), Tone::warning);
}

}  // namespace lapfx::ui
