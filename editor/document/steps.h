// Steps of the history that something was done by, watched from outside.
//
//     taken_ = document::WatchedStep(document);            // after document.change("Fit", ...)
//     once a frame:  if (!taken_.in_effect(document)) offer_it_again();   // it was undone
#pragma once

#include <cstdint>

#include "document/document.h"

namespace lapfx::document {

/// Id of the last step that is in effect; 0: none.
std::uint64_t newest_step(const Document& document);

/// One step. UI thread.
class WatchedStep {
  public:
    WatchedStep() = default;  ///< none: never in effect
    /// The newest step, which is in effect.
    explicit WatchedStep(const Document& document);

    explicit operator bool() const { return id_ != 0; }
    /// Whether it was done and is not undone. To be asked once a frame: a step that the document has forgotten, because
    /// too many came after it, can be undone no more and stays in effect, and that is told from one that was undone and
    /// replaced by how the history was when this was asked last.
    bool in_effect(const Document& document);

  private:
    std::uint64_t id_ = 0;
    std::uint64_t last_known_ = 0;  ///< the last step of the history, undone ones too, when this was asked last
    bool done_ = false, forgotten_ = false;
};

}  // namespace lapfx::document
