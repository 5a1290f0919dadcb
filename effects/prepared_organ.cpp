#include "lapfx/prepared_organ.h"

#include "foundation.h"
#include "lapfx/authoring/file.h"
#include "lapfx/authoring/tissue_report.h"
#include "organ/load.h"
#include "organ/refine.h"

namespace lapfx {

namespace {

// Shares of the whole time, for a textured organ.
constexpr double loaded = 0.3, refined = 0.35, tool_loaded = 0.4;
constexpr double split = 0.1;  // share of that for an organ that is already loaded

template <typename T>
std::size_t bytes_of(const std::vector<T>& data) {
    return data.size() * sizeof(T);
}

/// Its images are without pixels.
std::size_t bytes_of(const Organ& organ) {
    return bytes_of(organ.positions) + bytes_of(organ.normals) + bytes_of(organ.tangents) + bytes_of(organ.uvs) +
           bytes_of(organ.colors) + bytes_of(organ.indices);
}

std::filesystem::path path_of(const Scene& scene, const std::string& file, const std::string& place) {
    return named_path(scene.folder, file, Reach::anywhere, "", place);
}

organ::SplitOrgan split_of(Organ organ, const work::Stages& stages) {
    const organ::RefinePlan plan = organ::plan_refine(organ, stages.part(0.0, 0.0));
    return organ::refine(std::move(organ), plan, stages);
}

/// Runs a task that Stopped may end.
template <typename F>
std::shared_ptr<const PreparedOrgan> unless_stopped(const F& work) {
    try {
        return PreparedOrganAccess::make(work());
    } catch (const work::Stopped&) {
        return nullptr;
    }
}

}  // namespace

Foundation::Foundation(const Organ& organ, const VesselParameters& vessels, const work::Stages& stages,
                       organ::Unsplit from, organ::PixelList given)
    : unsplit(std::move(from)),
      surface(organ, stages.part(0.0, 0.3)),
      pixels(given.empty() ? organ::copied_pixels(organ) : std::move(given)),
      tissue(organ, surface, vessels, stages.part(0.3, 1.0), pixels) {
    tissue.rest();  // the densities made here serve the first preset with these parameters
    stages.reach(1.0);
}

PreparedOrgan::PreparedOrgan(std::unique_ptr<const State> state) : state_(std::move(state)) {}
PreparedOrgan::~PreparedOrgan() = default;

const Organ& PreparedOrgan::organ() const {
    return state_->organ;
}

std::vector<std::filesystem::path> files_of(const PreparedOrgan& organ) {
    const PreparedOrganAccess::State& known = PreparedOrganAccess::state(organ);
    std::vector<std::filesystem::path> files;
    for (const Organ* made : {&known.organ, known.tool ? &*known.tool : nullptr}) {
        if (made == nullptr) continue;
        files.insert(files.end(), made->files.begin(), made->files.end());
        files.insert(files.end(), made->unread_files.begin(), made->unread_files.end());
    }
    return files;
}

std::vector<std::filesystem::path> tool_files_of(const PreparedOrgan& organ) {
    const std::optional<Organ>& tool = PreparedOrganAccess::state(organ).tool;
    return tool ? tool->files : std::vector<std::filesystem::path>();
}

bool made_for(const PreparedOrgan& prepared, const Scene& scene) {
    const PreparedOrganAccess::State& known = PreparedOrganAccess::state(prepared);
    const SceneOrgan& organ = known.organ_source;
    const SceneTool& tool = known.tool_source;
    // Whether both paths lead to the same file.
    const auto same_file = [&](const std::string& made, const std::string& wanted) {
        if (made.empty() || wanted.empty()) return made == wanted;
        return std::filesystem::absolute(known.folder / made).lexically_normal() ==
               std::filesystem::absolute(scene.folder / wanted).lexically_normal();
    };
    return same_file(organ.file, scene.organ.file) && organ.scale == scene.organ.scale &&
           organ.rotation == scene.organ.rotation && same_file(tool.file, scene.tool.file) &&
           tool.scale == scene.tool.scale;
}

std::size_t PreparedOrgan::State::own_memory() const {
    return bytes_of(organ) + (tool ? bytes_of(*tool) : 0);
}

std::size_t PreparedOrgan::memory() const {
    const Foundation& known = *state_->foundation;
    return state_->own_memory() + state_->tool_pixel_memory() + known.surface_memory() + known.pixel_memory() +
           known.tissue.shared_memory() + known.tissue.own_memory();
}

std::shared_ptr<const PreparedOrgan> prepare_organ(const Scene& scene, const VesselParameters& vessels,
                                                   const Progress& progress) {
    return unless_stopped([&] {
        const work::Stages stages(progress);
        auto made = std::make_unique<PreparedOrganAccess::State>();
        made->organ_source = scene.organ;
        made->tool_source = scene.tool;
        made->folder = scene.folder;
        std::vector<organ::Encoded> encoded;
        organ::SplitOrgan fine = split_of(organ::load(path_of(scene, scene.organ.file, "/organ/file"),
                                                      {.scale = scene.organ.scale, .rotation = scene.organ.rotation},
                                                      stages.part(0.0, loaded), &encoded),
                                          stages.part(loaded, refined));
        made->organ = std::move(fine.organ);
        organ::PixelList pixels = organ::take_pixels(made->organ, encoded);
        if (!scene.tool.file.empty()) {
            std::vector<organ::Encoded> tool_encoded;
            made->tool =
                organ::load(path_of(scene, scene.tool.file, "/tool/file"), {.scale = scene.tool.scale, .rotation = {}},
                            stages.part(refined, tool_loaded), &tool_encoded);
            made->tool_pixels = organ::take_pixels(*made->tool, tool_encoded);
        }
        made->foundation = std::make_shared<const Foundation>(made->organ, vessels, stages.part(tool_loaded, 1.0),
                                                              std::move(fine.from), std::move(pixels));
        return made;
    });
}

std::shared_ptr<const PreparedOrgan> prepare_organ(Organ organ, const VesselParameters& vessels,
                                                   const Progress& progress) {
    return unless_stopped([&] {
        const work::Stages stages(progress);
        auto made = std::make_unique<PreparedOrganAccess::State>();
        organ::SplitOrgan fine = split_of(std::move(organ), stages.part(0.0, split));
        made->organ = std::move(fine.organ);
        organ::PixelList pixels = organ::take_pixels(made->organ, {});
        made->foundation = std::make_shared<const Foundation>(made->organ, vessels, stages.part(split, 1.0),
                                                              std::move(fine.from), std::move(pixels));
        return made;
    });
}

TissueHistogram tissue_histogram(const PreparedOrgan& organ, const VesselParameters& parameters) {
    return PreparedOrganAccess::state(organ).foundation->tissue.histogram(parameters);
}

}  // namespace lapfx
