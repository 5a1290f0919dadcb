// The page of an export with both pictures (app/measure/side_by_side.h), made ready beside the UI: the reference is
// opened for the export alone, and what has not been measured yet is measured.
//
//     making = std::make_unique<PageMaking>(wanted, parts);
//     each frame:  making->serve();
//     if (auto page = making->take()) render(std::move(page));   // throws what went wrong
//
// UI thread, context current.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/base/render_steps.h"
#include "app/base/thread_work.h"
#include "app/measure/compared.h"
#include "output/frame_page.h"

namespace lapfx::app {

class PreviewHost;

/// A copy of all that it is made of: the document may change meanwhile.
struct PageWanted {
    Scene scene;
    Preset preset;
    std::filesystem::path video;
    Compared compared;                        ///< what is drawn; the amounts come here
    std::optional<match::Measurement> found;  ///< the video's, where it is known
};

class PageMaking {
  public:
    struct Parts {
        const PreviewHost& preview;
        Jobs& jobs;
        std::shared_ptr<const PreparedOrgan> organ;
        std::vector<std::filesystem::path> clip_folders;
        bool exact;         ///< all is done at once, in the constructor
        int measured_side;  ///< EditorOptions
    };
    /// Ending it waits for what is being done: a picture, or a frame of the video.
    PageMaking(PageWanted wanted, const Parts& parts);

    const Job& job() const { return *job_; }  ///< its progress
    /// Once a frame, outside of the UI's build: draws what is to be measured.
    void serve();
    /// Null until it is made. Once. Throws Error with what went wrong.
    std::unique_ptr<output::FramePage> take();

  private:
    using Video = std::shared_ptr<VideoReader>;
    Video measure(Job& job);

    PageWanted wanted_;
    const int measured_side_;
    const std::shared_ptr<Job> job_;  ///< of no list: the export that it is for is shown
    std::unique_ptr<RenderSteps> steps_;
    std::unique_ptr<match::PreviewCurve> curve_;
    ThreadWork<Video> work_;  // last: it uses all of the others
};

}  // namespace lapfx::app
