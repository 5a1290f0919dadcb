// The streaming schemes (lapfx/streaming.h), one row each: what the code that plays clips must know about them.
#pragma once

#include <cstddef>

#include "lapfx/rows.h"
#include "lapfx/streaming.h"
#include "media/picture.h"

namespace lapfx::media {

struct SchemeRow {
    Scheme scheme;
    Layout layout;         ///< of the frames that are sent
    std::size_t textures;  ///< of each clip, for frames that are sent while it plays
    bool buffers;          ///< frames are decoded ahead into pixel buffers
};

/// In the order of the enumerators.
inline constexpr SchemeRow scheme_rows[] = {
    {.scheme = Scheme::pipeline, .layout = Layout::rgb, .textures = 1, .buffers = false},
    {.scheme = Scheme::buffered, .layout = Layout::rgb, .textures = 4, .buffers = true},
    {.scheme = Scheme::buffered_planar, .layout = Layout::planar, .textures = 4, .buffers = true},
    {.scheme = Scheme::resident, .layout = Layout::planar, .textures = 0, .buffers = false},
};
static_assert(rows_follow<&SchemeRow::scheme>(scheme_rows));

constexpr const SchemeRow& row_of(Scheme scheme) noexcept {
    return scheme_rows[static_cast<std::size_t>(scheme)];
}

}  // namespace lapfx::media
