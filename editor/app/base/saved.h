// Scene and preset as they were opened or saved: what the dot of a row compares with, and what Backspace goes back to.
//
//     const double speed = saved.content().preset.bleeding.speed;
//
// UI thread. It follows the document by itself and is computed again only when the document has changed.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "document/document.h"

namespace lapfx::app {

class Saved {
  public:
    /// `document` must outlive it.
    explicit Saved(const document::Document& document) : document_(document) {}

    const document::Content& content();
    /// The saved version of this clip, at any place in the list. It has the same file, by whatever path, and the file
    /// was used as often before it. Null: the clip is new.
    const SmokeClip* known_clip(std::size_t number);
    /// The same; the defaults for a clip that is new.
    const SmokeClip& clip(std::size_t number);
    /// The saved keying that applies to this clip: its own or the preset's.
    const KeyingParameters& keying(std::size_t number);

  private:
    void follow();
    void follow_clips();

    const document::Document& document_;
    std::uint64_t followed_ = 0;            ///< version of the document
    std::shared_ptr<const Preset> preset_;  ///< that content_ is of
    std::shared_ptr<const Scene> scene_;
    document::Content content_;
    std::vector<std::size_t> clips_;  ///< each clip has its number among the saved ones here; no_clip: it is new
};

}  // namespace lapfx::app
