#include "app/tuning/snapshot_previews.h"

#include "app/base/screen.h"
#include "app/preview/timeline.h"

namespace lapfx::app {

namespace {

/// Whether the document's preview shows what is kept in the slot, and all of it.
bool shows_whole(const PreviewHost& preview, const Snapshots& snapshots, std::size_t slot) {
    return snapshots.shown(slot) && !preview.alone();
}

}  // namespace

SnapshotPreviews::Beside::Beside(const PreviewOptions& options, Jobs& jobs, const Scene& scene,
                                 const PreviewHost& shared, const std::shared_ptr<const PreparedOrgan>& shared_organ)
    : host(options, jobs, loaded_already(scene, shared_organ, shared.clip_cache())), organ(shared_organ) {}

SnapshotPreviews::SnapshotPreviews(const document::Document& document, const Snapshots& snapshots, PreviewHost& preview,
                                   const Timeline& timeline, Jobs& jobs, ui::ImageStore& images, const Screen& screen,
                                   const EditorOptions& options)
    : document_(document),
      snapshots_(snapshots),
      preview_(preview),
      timeline_(timeline),
      jobs_(jobs),
      images_(images),
      screen_(screen),
      options_{.clip_folders = options.clip_folders, .wait_for_clips = options.exact} {}

SnapshotPreviews::~SnapshotPreviews() {
    for (const Thumbnail& thumbnail : thumbnails_)
        if (thumbnail.image != 0) images_.remove(thumbnail.image);
}

ui::ImageHandle SnapshotPreviews::thumbnail(std::size_t slot) const {
    const auto& snapshot = snapshots_.at(slot);
    const Thumbnail& made = thumbnails_[slot];
    return snapshot && made.snapshot == snapshot->id ? made.image : 0;
}

bool SnapshotPreviews::missing(std::size_t slot) const {
    const auto& snapshot = snapshots_.at(slot);
    return snapshot && thumbnails_[slot].snapshot != snapshot->id;
}

void SnapshotPreviews::update() {
    wanted_.fill(false);
    shows_ = false;
}

void SnapshotPreviews::follow() {
    const std::shared_ptr<const PreparedOrgan> organ = preview_.organ_of(document_.scene());
    if (making_ < all_.size() && (!missing(making_) || !shows_)) making_ = all_.size();
    for (std::size_t slot = 0; slot < all_.size() && shows_ && making_ == all_.size(); ++slot)
        if (missing(slot) && !shows_whole(preview_, snapshots_, slot)) making_ = slot;
    for (std::size_t slot = 0; slot < all_.size(); ++slot) {
        if (!kept(slot) || !(wanted_[slot] || slot == making_))
            all_[slot].reset();
        else if (organ)  // the former pictures stay while another one is loaded
            follow(slot, organ);
    }
}

void SnapshotPreviews::follow(std::size_t slot, const std::shared_ptr<const PreparedOrgan>& organ) {
    std::unique_ptr<Beside>& beside = all_[slot];
    const auto& snapshot = *snapshots_.at(slot);
    if (!beside || beside->organ != organ) {
        beside = std::make_unique<Beside>(options_, jobs_, document_.scene(), preview_, organ);
        ++numbers_[slot];
    }
    if (beside->snapshot != snapshot.id) {
        beside->snapshot = snapshot.id;
        beside->document.open({.scene = document_.scene(), .preset = snapshot.preset});
    } else if (document_.scene_changes_since(beside->followed) != 0) {
        beside->document.edit([this](document::Content& c) { c.scene = document_.scene(); });
    }
    beside->followed = document_.version();
    const bool before = beside->host.ready();
    beside->host.follow(beside->document);
    if (beside->host.ready() != before) screen_.wake("a snapshot's preview");
}

bool SnapshotPreviews::draw() {
    bool drawn = false;
    for (std::size_t slot = 0; slot < all_.size(); ++slot) {
        if (!missing(slot)) continue;
        if (shows_whole(preview_, snapshots_, slot) && preview_.ready() && !preview_.loading())
            drawn |= draw_thumbnail(slot, preview_);
        else if (all_[slot] && all_[slot]->host.ready() && !all_[slot]->host.loading())
            drawn |= draw_thumbnail(slot, all_[slot]->host);
    }
    return drawn;
}

/// With clips that are still late it is drawn again in the next frame.
bool SnapshotPreviews::draw_thumbnail(std::size_t slot, PreviewHost& host) {
    copy_.target.resize(thumbnail_size);
    copy_.revision = 0;  // what another host has drawn
    const Shot shot{.time = timeline_.time, .camera = document_.scene().camera};
    if (!host.draw_into(copy_, shot)) return false;
    screen_.wake("a snapshot's thumbnail");
    if (host.late()) return true;
    copy_.target.read(read_);
    Thumbnail& made = thumbnails_[slot];
    if (made.image == 0)
        made.image = images_.add(thumbnail_size, read_.pixels);
    else
        images_.update(made.image, thumbnail_size, read_.pixels);
    made.snapshot = snapshots_.at(slot)->id;
    made.time = timeline_.time;
    return true;
}

bool SnapshotPreviews::late() const {
    for (std::size_t slot = 0; slot < all_.size(); ++slot)
        if (all_[slot] && wanted_[slot] && all_[slot]->host.late()) return true;
    return false;
}

std::size_t SnapshotPreviews::memory() const {
    std::size_t bytes = copy_.target.memory();
    for (const auto& beside : all_)
        if (beside) bytes += beside->host.memory_use().clips + beside->host.memory_use().targets;
    return bytes;
}

}  // namespace lapfx::app
