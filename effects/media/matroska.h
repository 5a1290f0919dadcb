// The size that a Matroska or WebM file states about itself.
#pragma once

#include <cstdint>
#include <span>

namespace lapfx::media {

/// Bytes of the whole file, from its beginning (RFC 8794, section 4: EBML; RFC 9559, section 5.1: the Segment holds all
/// but the header). 0: it is no Matroska, or its size was not known when it was written.
std::int64_t matroska_size(std::span<const std::uint8_t> head);

}  // namespace lapfx::media
