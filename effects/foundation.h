// What the effects compute from an organ before they draw it: once, on any thread, and shared by all bodies of that
// organ.
#pragma once

#include <optional>

#include "bleeding/tissue_density.h"
#include "lapfx/authoring/prepared_scene.h"
#include "organ/plate.h"
#include "organ/refine.h"
#include "organ/surface.h"
#include "work/stages.h"

namespace lapfx {

struct Foundation {
    /// `unsplit`: the organ before splitting. `pixels`: those of the organ's images, if the images have none; when
    /// empty, the pixels that are needed are copied.
    Foundation(const Organ& organ, const VesselParameters& vessels, const work::Stages& stages = {},
               organ::Unsplit unsplit = {}, organ::PixelList pixels = {});
    Foundation(const Foundation&) = delete;
    Foundation& operator=(const Foundation&) = delete;

    std::size_t vertices() const {
        return surface.weld.size();
    }  ///< all vertices of the organ, including those made by splitting
    std::size_t given_vertices() const { return vertices() - unsplit.midpoints.size(); }
    /// Call this when textures have been sent to the GPU: it frees the pixels that can be decoded again.
    void let_go_pixels() const { organ::let_go(pixels); }
    std::size_t pixel_memory() const { return organ::memory_of(pixels); }  ///< bytes
    std::size_t surface_memory() const { return surface.memory() + unsplit.memory(); }

    organ::Unsplit unsplit;
    std::optional<organ::Plate> plate;  ///< the organ is one; its picture is the only image
    Surface surface;
    organ::PixelList pixels;         ///< each image has them; null where nobody needs the pixels
    bleeding::TissueDensity tissue;  ///< refers to `surface`; whoever changes it copies it first
};

struct PreparedOrgan::State {
    std::size_t own_memory() const;  ///< bytes, without those of the foundation and of pixels
    std::size_t tool_pixel_memory() const { return organ::memory_of(tool_pixels); }

    Organ organ;
    std::shared_ptr<const Foundation> foundation;
    // prepare_organ(scene) needs the scene that it was made from.
    std::optional<Organ> tool;
    organ::PixelList tool_pixels;  // the pixels of its images, which have none themselves
    Scene source;                  // without events and curves
};

/// Gives the core access to the state of a PreparedOrgan.
struct PreparedOrganAccess {
    using State = PreparedOrgan::State;
    static const State& state(const PreparedOrgan& organ) { return organ.state(); }
    static std::shared_ptr<const PreparedOrgan> make(std::unique_ptr<const State> state) {
        return std::shared_ptr<const PreparedOrgan>(new PreparedOrgan(std::move(state)));
    }
};

}  // namespace lapfx
