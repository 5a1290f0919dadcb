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
    /// What was saved of this clip, wherever it stood in the list then: the same file, as often used before it, however
    /// the folder of either names it. Null: it is new.
    const SmokeClip* known_clip(std::size_t number);
    /// The same; of a clip that is new, the defaults.
    const SmokeClip& clip(std::size_t number);
    /// Of the keying that holds for this clip: its own or the preset's.
    const KeyingParameters& keying(std::size_t number);

  private:
    void follow();
    void follow_clips();

    const document::Document& document_;
    std::uint64_t followed_ = 0;            ///< version of the document
    std::shared_ptr<const Preset> preset_;  ///< that content_ is of
    std::shared_ptr<const Scene> scene_;
    document::Content content_;
    std::vector<std::size_t> clips_;  ///< of each clip, its number among the saved ones; no_clip: it is new
};

}  // namespace lapfx::app
