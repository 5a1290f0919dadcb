// A picture of the file that is selected, beside the list. The toolkit knows neither videos nor organs: the program
// hands it the picture.
#pragma once

#include "ui/core/ui.h"
#include "ui/shell/file_system.h"

namespace lapfx::ui {

struct FilePicture {
    enum class State : std::uint8_t {
        none,    ///< a kind of file of which there is none
        coming,  ///< it is being made
        there,
        failed,
    };
    State state = State::none;
    ImageHandle image = 0;
    glm::ivec2 size{0};           ///< px
    std::string_view fault = {};  ///< one line says why it `failed`; it is valid until the next build
};

class FilePictures {
  public:
    virtual ~FilePictures() = default;
    /// A dialog opens: pictures shown by the last one may be out of date.
    virtual void begin() {}
    /// The picture of the selected file; called in every build. Never waits: a picture that is missing is made in the
    /// background, which then wakes the UI.
    virtual FilePicture picture(Ui& ui, const std::string& path, const FileEntry& file) = 0;
};

/// The file that is selected.
struct LookedAt {
    std::string path;
    FileEntry file;
    std::string about;  ///< size and time, to be read
};

/// A column of `width` em: the picture, or an icon where there is none; below it name, size and time, and why there is
/// none. `file`: null when nothing is selected.
void file_preview(Ui& ui, FilePictures& pictures, const LookedAt* file, float width);

}  // namespace lapfx::ui
