// What the effects know of an organ before they draw it: found once, on any thread, and shared by all bodies of that organ.
#pragma once

#include <optional>

#include "bleeding/tissue_density_cpu.h"
#include "lapfx/prepared_organ.h"
#include "organ/refine.h"
#include "organ/stages.h"
#include "organ/surface.h"

namespace lapfx {

struct Foundation {
    /// `unsplit`: what the organ was split from.
    Foundation(const Organ& organ, const VesselParameters& vessels, const organ::Stages& stages = {},
               organ::Unsplit unsplit = {});
    Foundation(const Foundation&) = delete;
    Foundation& operator=(const Foundation&) = delete;

    std::size_t memory() const {  ///< bytes
        return surface.memory() + tissue.memory() + unsplit.memory();
    }

    organ::Unsplit unsplit;
    Surface surface;
    bleeding::TissueDensity tissue;  ///< to be copied by whom it changes; refers to `surface`
};

struct PreparedOrgan::State {
    Organ organ;
    std::shared_ptr<const Foundation> foundation;
    // Of prepare_organ(scene): what it was made from.
    std::optional<Organ> tool;
    SceneOrgan organ_source;
    SceneTool tool_source;
    std::filesystem::path folder;
};

}  // namespace lapfx
