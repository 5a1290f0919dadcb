// The sample scene with its smoke composited off-screen equals shading each layer at the frame's resolution, to 0.1/255
// on average.
#include "lapfx/authoring/prepared_scene.h"
#include "lapfx/authoring/preview.h"
#include "support/folders.h"
#include "support/gpu_test.h"

namespace lapfx {
namespace {

struct Difference {
    double mean = 0.0;
    int far = 0;  ///< pixels that differ by more than 24 in some channel
};

Difference difference(const Image& a, const Image& b) {
    Difference d;
    for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
        int most = 0;
        for (std::size_t c = 0; c < 3; ++c) {
            const int apart = std::abs(a.pixels[i + c] - b.pixels[i + c]);
            d.mean += apart;
            most = std::max(most, apart);
        }
        d.far += most > 24 ? 1 : 0;
    }
    d.mean /= static_cast<double>(a.pixels.size()) * 0.75;
    return d;
}

class SmokeResolutionTest : public test::GpuTest, public testing::WithParamInterface<const char*> {};

TEST_P(SmokeResolutionTest, DiffersLittleFromShadingAtTheFramesResolution) {
    const std::filesystem::path root = test::source_folder();
    // What is below the smoke is the same in all pictures: an organ with small textures, prepared once.
    static const Scene scene = load_scene(test::light_folder() / "samples/lagb.scene.json");
    static const auto organ = prepare_organ(scene);
    const Preset preset = load_preset(root / "presets" / (std::string(GetParam()) + ".json"));
    // In a smaller frame the clips would have its resolution or more, and nothing would be compared.
    constexpr glm::ivec2 size(1280, 1024);
    const auto picture = [&](SmokeResolution resolution, double time, const Preset& of) {
        Preview preview(scene, of, organ,
                        {.clip_folders = {root / "samples/clips"},
                         .wait_for_clips = true,
                         .streaming = {.resolution = resolution}});
        return preview.image(time, size);
    };
    Preset clear = preset;
    clear.smoke.clips.clear();
    clear.smoke.haze.accumulation = 0.0;
    constexpr double time = 6.0;
    const Image direct = picture(SmokeResolution::screen, time, preset);
    const Difference smoke = difference(direct, picture(SmokeResolution::screen, time, clear));
    EXPECT_GT(smoke.mean, 0.3) << "there is smoke";
    for (const SmokeResolution resolution : {SmokeResolution::clip, SmokeResolution::half, SmokeResolution::balanced}) {
        const Difference d = difference(direct, picture(resolution, time, preset));
        const char* name = resolution == SmokeResolution::clip   ? "clip"
                           : resolution == SmokeResolution::half ? "half"
                                                                 : "balanced";
        EXPECT_LE(d.mean, 0.1) << name;
        EXPECT_LE(d.mean, 0.25 * smoke.mean) << name;
        EXPECT_LE(d.far, size.x * size.y / 500) << name << ": pixels that are far off";
        RecordProperty(std::string("mean_") + name, std::to_string(d.mean));
        std::printf("%s at %s resolution: mean difference %.3f, %d pixels beyond 24; smoke itself %.2f\n", GetParam(),
                    name, d.mean, d.far, smoke.mean);
    }
}

INSTANTIATE_TEST_SUITE_P(Presets, SmokeResolutionTest,
                         testing::Values("heavy_haze", "hook_cautery_plume", "gastric_banding"),
                         [](const auto& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace lapfx
