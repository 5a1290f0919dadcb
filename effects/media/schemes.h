// The streaming schemes (lapfx/streaming.h), one row each: what the code that plays clips must know about them. It asks
// for no enumerator, so a scheme that does what others do is a row alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "lapfx/rows.h"
#include "lapfx/streaming.h"
#include "media/picture.h"

namespace lapfx::media {

struct SchemeRow {
    Scheme scheme;
    std::string_view key;  ///< "buffered_planar"
    Layout layout;         ///< of the frames that are sent
    std::size_t textures;  ///< of each clip, for frames that are sent while it plays
    bool ahead = true;     ///< frames are decoded ahead, otherwise one at a time
    bool buffers = false;  ///< into pixel buffers, from which several are sent in one cycle
    bool stays = false;    ///< frames stay on the GPU once they are sent
    /// Of clips that do not fit into the memory; the scheme itself where they need not fit. Of the same layout.
    Scheme otherwise;
};

/// In the order of the enumerators.
inline constexpr SchemeRow scheme_rows[] = {
    {.scheme = Scheme::pipeline,
     .key = "pipeline",
     .layout = Layout::rgb,
     .textures = 1,
     .ahead = false,
     .otherwise = Scheme::pipeline},
    {.scheme = Scheme::buffered,
     .key = "buffered",
     .layout = Layout::rgb,
     .textures = 4,
     .buffers = true,
     .otherwise = Scheme::buffered},
    {.scheme = Scheme::buffered_planar,
     .key = "buffered_planar",
     .layout = Layout::planar,
     .textures = 4,
     .buffers = true,
     .otherwise = Scheme::buffered_planar},
    {.scheme = Scheme::resident,
     .key = "resident",
     .layout = Layout::planar,
     .textures = 0,
     .stays = true,
     .otherwise = Scheme::buffered_planar},
};
static_assert(rows_follow<&SchemeRow::scheme>(scheme_rows));
static_assert(std::ranges::all_of(scheme_rows, [](const SchemeRow& row) { return !row.buffers || row.textures >= 4; }),
              "two frames are sent in a cycle while two others may still be shown");

constexpr const SchemeRow& row_of(Scheme scheme) noexcept {
    return scheme_rows[static_cast<std::size_t>(scheme)];
}

}  // namespace lapfx::media
