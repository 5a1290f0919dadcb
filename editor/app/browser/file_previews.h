// Pictures for the file dialog: a frame of a video, an image, an organ, a scene, a preset on the scene that is open.
// Each is made by a child process (app/browser/thumbnail_maker.h), once it has been looked at for a moment; the newest
// are kept.
//
//     file_dialog.show_pictures(&previews);
//     each frame:  previews.update();
//
// UI thread.
#pragma once

#include <memory>
#include <vector>

#include "app/browser/thumbnail_maker.h"
#include "document/document.h"
#include "ui/draw/images.h"
#include "ui/shell/file_preview.h"

namespace lapfx::app {

class Screen;
struct EditorOptions;

class FilePreviews : public ui::FilePictures {
  public:
    static constexpr glm::ivec2 size{360, 288};
    static constexpr std::size_t most_kept = 24;        ///< pictures in memory, the newest looked at
    static constexpr double rests = 0.15;               ///< s that a file is selected before its picture is begun
    static constexpr std::chrono::seconds longest{60};  ///< a picture that takes longer is given up
    static constexpr int niceness = 5;                  ///< of the process that makes one; low, because a person waits

    /// All must outlive it.
    FilePreviews(const EditorOptions& options, const document::Document& document, ui::ImageStore& images,
                 Screen& screen)
        : options_(options), document_(document), images_(images), screen_(screen) {}
    ~FilePreviews() override;

    void begin() override;
    ui::FilePicture picture(ui::Ui& ui, const std::string& path, const ui::FileEntry& file) override;
    /// Once before each frame: takes what has been made; what nobody looks at any more is not finished.
    void update();
    bool busy() const { return maker_ != nullptr && maker_->busy(); }
    /// For tests: pictures are made by this program, even where the options say that none are made.
    void make_with(const std::filesystem::path& program) { program_ = program; }

  private:
    /// The preview of a file with this size and time of change; if either differs, it is made again. A preset is shown
    /// on the scene that was open.
    struct Kept {
        std::string path;
        std::uint64_t bytes = 0;
        std::int64_t changed = 0;
        std::filesystem::path scene{};
        double time = 0;  ///< s, in it
        bool made = false;
        ui::ImageHandle image = 0;
        glm::ivec2 size{0};
        std::string fault{};
        std::uint64_t used = 0;
    };
    Kept& kept_for(const std::string& path, const ui::FileEntry& file);
    void make(const std::string& path);
    void give_up();
    double time_in_scene() const;
    void take(ThumbnailMaker::Result&& result);

    const EditorOptions& options_;
    const document::Document& document_;
    ui::ImageStore& images_;
    Screen& screen_;
    std::vector<Kept> kept_;
    std::unique_ptr<ThumbnailMaker> maker_;
    std::filesystem::path program_;  ///< empty: this one
    std::string looked_at_, begun_;
    double since_ = 0;  ///< s, when it was first looked at
    std::uint64_t uses_ = 0;
    bool asked_ = false;
};

/// Whether there may be a picture of a file of this name.
bool has_picture(std::string_view path);

}  // namespace lapfx::app
