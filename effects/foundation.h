// What the effects know of an organ before they draw it: found once, on any thread, and shared by all bodies of that
// organ.
#pragma once

#include <optional>

#include "bleeding/tissue_density.h"
#include "lapfx/authoring/prepared_scene.h"
#include "organ/refine.h"
#include "organ/surface.h"
#include "work/stages.h"

namespace lapfx {

struct Foundation {
    /// `unsplit`: what the organ was split from. `pixels`: of the organ's images, where these have none themselves;
    /// empty: copies of what is needed.
    Foundation(const Organ& organ, const VesselParameters& vessels, const work::Stages& stages = {},
               organ::Unsplit unsplit = {}, organ::PixelList pixels = {});
    Foundation(const Foundation&) = delete;
    Foundation& operator=(const Foundation&) = delete;

    std::size_t vertices() const {
        return surface.weld.size();
    }  ///< of the organ, also those that splitting it has made
    std::size_t given_vertices() const { return vertices() - unsplit.midpoints.size(); }
    /// Textures have been sent to the GPU: pixels that can be decoded again need not be kept.
    void let_go_pixels() const { organ::let_go(pixels); }
    std::size_t pixel_memory() const { return organ::memory_of(pixels); }  ///< bytes
    std::size_t surface_memory() const { return surface.memory() + unsplit.memory(); }

    organ::Unsplit unsplit;
    Surface surface;
    organ::PixelList pixels;         ///< by image, null where nobody needs them
    bleeding::TissueDensity tissue;  ///< to be copied by whom it changes, and set; refers to `surface`
};

struct PreparedOrgan::State {
    std::size_t own_memory() const;  ///< bytes, without the foundation and without pixels
    std::size_t tool_pixel_memory() const { return organ::memory_of(tool_pixels); }

    Organ organ;
    std::shared_ptr<const Foundation> foundation;
    // Of prepare_organ(scene): what it was made from.
    std::optional<Organ> tool;
    organ::PixelList tool_pixels;  // of its images, which have none themselves
    SceneOrgan organ_source;
    SceneTool tool_source;
    std::filesystem::path folder;
};

/// The way to it from what a host holds.
struct PreparedOrganAccess {
    using State = PreparedOrgan::State;
    static const State& state(const PreparedOrgan& organ) { return organ.state(); }
    static std::shared_ptr<const PreparedOrgan> make(std::unique_ptr<const State> state) {
        return std::shared_ptr<const PreparedOrgan>(new PreparedOrgan(std::move(state)));
    }
};

}  // namespace lapfx
