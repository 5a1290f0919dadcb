// The sample scene is the paper's operation: fat and ligament, each a part of the organ, and strokes on both.
#include <gmock/gmock.h>

#include <filesystem>
#include <set>
#include <string>

#include "bleeding/tissue_density.h"
#include "lapfx/preset.h"
#include "lapfx/scene.h"
#include "support/folders.h"
#include "unit/organ/fixtures.h"

namespace lapfx::test {
namespace {

struct Nearest {
    std::string part;
    double distance = 1e9;  // mm, of a vertex
};

Nearest nearest_to(const Organ& organ, const glm::dvec3& place) {
    Nearest nearest;
    for (const Part& part : organ.parts)
        for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
            const double distance = glm::distance(glm::dvec3(organ.positions[organ.indices[i]]), place);
            if (distance < nearest.distance) nearest = {part.name, distance};
        }
    return nearest;
}

/// Also of those that come later: whatever lies in samples/ is installed and shown as a sample.
TEST(SampleScenes, AllAreWholeAndTheirStrokesTouch) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "samples")) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".scene.json")) continue;
        ++scenes;
        const Scene scene = load_scene(entry.path());
        const Organ organ = load_organ(scene.folder / scene.organ.file);
        EXPECT_FALSE(load_preset(scene.folder / scene.preset).description.empty()) << name;
        EXPECT_FALSE(scene.name.empty()) << name;
        for (const std::string& file : {scene.tool.file, scene.reference.file})
            EXPECT_TRUE(file.empty() || std::filesystem::exists(scene.folder / file)) << name << ": " << file;
        EXPECT_FALSE(scene.events.empty()) << name;
        for (const ToolContact& event : scene.events)
            EXPECT_LT(nearest_to(organ, event.position).distance, 5.0) << name << ", " << event.time << " s";
    }
    EXPECT_GE(scenes, 1);
}

TEST(SampleScene, HasStrokesOnFatAndOnTheLigament) {
    const Scene scene = load_scene(source_folder() / "samples/lagb.scene.json");
    const Organ organ = load_organ(scene.folder / scene.organ.file);
    std::set<std::string> stroked;
    for (const ToolContact& event : scene.events)
        for (const glm::dvec3& place : {event.position, event.to}) {
            const Nearest nearest = nearest_to(organ, place);
            EXPECT_LT(nearest.distance, 2.0) << nearest.part << ", " << event.time << " s";
            stroked.insert(nearest.part);
        }
    EXPECT_THAT(stroked, testing::ElementsAre("cardia fat", "gastrohepatic ligament"));
}

TEST(SampleScene, TheLigamentHasVesselsAndHardlyAnyFat) {
    const Organ organ = load_organ(source_folder() / "samples/lagb.glb");
    const Surface surface(organ);
    const bleeding::TissueDensity tissue(organ, surface);
    double vessels = 0.0, fat = 0.0, count = 0.0, most = 0.0;
    for (const Part& part : organ.parts) {
        if (part.name != "gastrohepatic ligament") continue;
        const int texture = organ.materials[static_cast<std::size_t>(part.material)].base_color_image;
        for (std::uint32_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
            const glm::dvec2 here(tissue.map(texture)->sample(organ.uvs[organ.indices[i]]));
            vessels += here.x, fat += here.y, count += 1.0;
            most = std::max(most, here.x);
        }
    }
    ASSERT_GT(count, 3000.0);
    EXPECT_GT(vessels / count, 0.01);
    EXPECT_LT(vessels / count, 0.2);
    EXPECT_GT(most, 0.5) << "a stem";
    EXPECT_LT(fat / count, 0.05);
}

}  // namespace
}  // namespace lapfx::test
