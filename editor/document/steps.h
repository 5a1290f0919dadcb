// Steps of the history that something was done by, watched from outside.
//
//     taken_ = document::newest_step(document);                       // after document.change("Fit", ...)
//     if (!document::in_effect(document, taken_)) offer_it_again();   // it was undone
#pragma once

#include <cstdint>

#include "document/document.h"

namespace lapfx::document {

/// Id of the last step that is in effect; 0: none.
std::uint64_t newest_step(const Document& document);
/// Whether the step with this id was done and is not undone. One that the document has forgotten is undone no more,
/// but nobody knows: it is not.
bool in_effect(const Document& document, std::uint64_t step);

}  // namespace lapfx::document
