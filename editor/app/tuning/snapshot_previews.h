// Snapshots as pictures: a preview of each one that is compared, on the document's scene, beside the document's own;
// and a thumbnail of each, of the moment at which it was kept.
//
//     previews.want(0);                       // while the UI is built: A is drawn after this frame
//     if (PreviewHost* a = previews.at(0)) picture.draw(*a, shot);
//
// A preview shares the organ and the facts about clips with the document's; it is made when it is wanted and goes when
// it is not. UI thread, context current.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "app/base/editor_options.h"
#include "app/preview/preview_host.h"
#include "app/tuning/snapshots.h"
#include "ui/draw/images.h"

namespace lapfx::app {

class Screen;
class Timeline;

class SnapshotPreviews {
  public:
    static constexpr glm::ivec2 thumbnail_size{240, 192};

    /// All must outlive it. `preview`: the document's.
    SnapshotPreviews(const document::Document& document, const Snapshots& snapshots, PreviewHost& preview,
                     const Timeline& timeline, Jobs& jobs, ui::ImageStore& images, const Screen& screen,
                     const EditorOptions& options);
    ~SnapshotPreviews();

    /// While the UI is built: this one is compared, as long as this is called.
    void want(std::size_t slot) { wanted_[slot] = true; }
    /// Whether something is kept in the slot.
    bool kept(std::size_t slot) const { return snapshots_.at(slot).has_value(); }
    /// Snapshot::id of what is kept in the slot; 0: nothing.
    std::uint64_t id(std::size_t slot) const { return kept(slot) ? snapshots_.at(slot)->id : 0; }
    /// Null: nothing is kept in the slot, or its preview is still to come.
    PreviewHost* at(std::size_t slot) { return all_[slot] ? &all_[slot]->host : nullptr; }
    /// Another number for each preview that there has been for this slot.
    std::uint64_t number(std::size_t slot) const { return numbers_[slot]; }
    /// While the UI is built: thumbnails are seen, and those that are missing are made, one after the other. That of a
    /// snapshot that is kept while nobody looks is made, too.
    void show_thumbnails() { shows_ = true; }
    ui::ImageHandle thumbnail(std::size_t slot) const;                                ///< 0: none yet
    double thumbnail_time(std::size_t slot) const { return thumbnails_[slot].time; }  ///< s of the scene

    /// Once before each frame.
    void update();
    /// After the panels: previews that are wanted are made and take what has changed in the document's scene.
    void follow();
    /// Call it after that, for thumbnails. It returns whether it has drawn.
    bool draw();
    /// While time stands, another draw() of one that is compared could give a better picture.
    bool late() const;
    std::size_t memory() const;  ///< bytes of the previews

  private:
    struct Beside {
        Beside(const PreviewOptions& options, Jobs& jobs, const Scene& scene, const PreviewHost& shared,
               const std::shared_ptr<const PreparedOrgan>& shared_organ);
        ~Beside() { host.cancel_loading(); }
        document::Document document;  ///< the scene with the snapshot's preset
        PreviewHost host;
        std::shared_ptr<const PreparedOrgan> organ;
        std::uint64_t followed = 0;  ///< version of the editor's document
        std::uint64_t snapshot = 0;  ///< Snapshot::id
    };
    struct Thumbnail {
        ui::ImageHandle image = 0;
        std::uint64_t snapshot = 0;  ///< Snapshot::id that it shows
        double time = 0;             ///< s
    };
    bool missing(std::size_t slot) const;
    void follow(std::size_t slot, const std::shared_ptr<const PreparedOrgan>& organ);
    bool draw_thumbnail(std::size_t slot, PreviewHost& host);

    const document::Document& document_;
    const Snapshots& snapshots_;
    PreviewHost& preview_;
    const Timeline& timeline_;
    Jobs& jobs_;
    ui::ImageStore& images_;
    const Screen& screen_;
    PreviewOptions options_;
    std::array<bool, Snapshots::count> wanted_{};
    bool shows_ = false;
    std::array<std::unique_ptr<Beside>, Snapshots::count> all_;
    std::array<std::uint64_t, Snapshots::count> numbers_{};
    std::array<Thumbnail, Snapshots::count> thumbnails_;
    std::size_t making_ = Snapshots::count;  ///< slot whose preview is there for its thumbnail; count: none
    PreviewCopy copy_;
    Image read_;
};

}  // namespace lapfx::app
