// The edge of blood in the picture (paper: figure 7): without noise it is the polygon of the mesh, exactly the linear
// interpolation of the vertices' values; with noise it is not, and covers as much. Measured on a sheet seen from above.
#include <numbers>

#include "gl/gl.h"
#include "lapfx/refine.h"
#include "parity/render/scene_fixture.h"

namespace lapfx {
namespace {

constexpr double height = 60.0;                  // mm, of the camera above the sheet
constexpr std::uint32_t largest_triangles = 60;  // squares a side: their diagonals, 1.89 mm, are not split

class EdgeTest : public test::SceneTest {
  protected:
    EdgeTest() {
        preset.smoke.clips.clear();
        scene.light.focus_distance = height;  // lit to the colour of the tissue, so that no channel saturates
        preset.bleeding.gravity_bias = 0.0;
        preset.bleeding.threshold = 0.0;
        preset.bleeding.rivulets = 0.0;
        scene.events.resize(1);
        scene.events[0].position = scene.events[0].to = {0.0, 0.0, 0.0};
    }

    /// The sheet in n squares a side, turned about the wound by `degrees`.
    void use_sheet(std::uint32_t n, double degrees = 0.0) {
        Organ sheet = test::plane(80.0, n);
        const double turn = glm::radians(degrees);
        for (glm::vec3& p : sheet.positions)
            p = glm::vec3(glm::dvec3(p.x * std::cos(turn) - p.z * std::sin(turn), 0.0,
                                     p.x * std::sin(turn) + p.z * std::cos(turn)));
        test::write_obj(folder / "sheet.obj", sheet);
    }

    glm::ivec2 frame{400, 400};

    /// A triangle of the largest sheet that is not split is then 38 pixels wide.
    void look_closely() { scene.camera.field_of_view = 13.2; }

    double mm_per_pixel() const {
        return 2.0 * height * std::tan(glm::radians(scene.camera.field_of_view) / 2.0) / frame.y;
    }

    /// The pixels with blood: those that change when the wound is removed, and those they enclose, because both
    /// pictures are white where the lamp is reflected.
    std::vector<bool> blood_mask(double time) const {
        Preview p = preview();
        const Image bleeding = p.image(time, frame);
        p.set_contacts({});
        return blood_mask(bleeding, p.image(time, frame));
    }

    std::vector<bool> blood_mask(const Image& bleeding, const Image& dry) const {
        std::vector<bool> changed;
        for (std::size_t i = 0; i < dry.pixels.size(); i += 4) {
            // The reflection at the rim may compensate for its colour, but not in all channels.
            int most = 0;
            for (std::size_t c = 0; c < 3; ++c)
                most = std::max(most, std::abs(bleeding.pixels[i + c] - dry.pixels[i + c]));
            changed.push_back(most > 5);
        }
        return filled(changed);
    }

    /// Everything that cannot be reached from the corner without touching a pixel of `mask`.
    std::vector<bool> filled(const std::vector<bool>& mask) const {
        std::vector<bool> inside(mask.size(), true);
        std::vector<glm::ivec2> next{{0, 0}};
        while (!next.empty()) {
            const glm::ivec2 p = next.back();
            next.pop_back();
            if (p.x < 0 || p.y < 0 || p.x >= frame.x || p.y >= frame.y) continue;
            const auto i = static_cast<std::size_t>(p.y * frame.x + p.x);
            if (mask[i] || !inside[i]) continue;
            inside[i] = false;
            for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(-1, 0), glm::ivec2(0, 1), glm::ivec2(0, -1)})
                next.push_back(p + step);
        }
        return inside;
    }

    double area(const std::vector<bool>& mask) const {
        return static_cast<double>(std::count(mask.begin(), mask.end(), true)) * mm_per_pixel() * mm_per_pixel();
    }

    /// Mean over the seeds from 1 on, each of which bends the edge in another way.
    double mean_area(double time, int seeds) {
        Preview p = preview();
        p.set_contacts({});
        const Image dry = p.image(time, frame);
        double mean = 0.0;
        for (scene.seed = 1; scene.seed <= seeds; ++scene.seed) {
            p.set_scene(scene);
            mean += area(blood_mask(p.image(time, frame), dry)) / seeds;
        }
        return mean;
    }

    glm::dvec2 to_pixel(glm::vec3 p) const { return glm::dvec2(p.x, p.z) / mm_per_pixel() + glm::dvec2(frame) / 2.0; }

    /// Calls visit(pixel index, weights of the corners, triangle) for every pixel of every triangle of the sheet.
    template <typename Visit>
    void each_pixel(const Organ& organ, Visit visit) const {
        for (std::size_t t = 0; t + 2 < organ.indices.size(); t += 3) {
            std::array<glm::dvec2, 3> c;
            for (std::size_t k = 0; k < 3; ++k) c[k] = to_pixel(organ.positions[organ.indices[t + k]]);
            const auto twice = [](glm::dvec2 u, glm::dvec2 v) { return u.x * v.y - u.y * v.x; };
            const double whole = twice(c[1] - c[0], c[2] - c[0]);
            const glm::dvec2 low = glm::max(glm::min(c[0], glm::min(c[1], c[2])), 0.0);
            const glm::dvec2 high = glm::min(glm::max(c[0], glm::max(c[1], c[2])), glm::dvec2(frame) - 1.0);
            for (int y = static_cast<int>(low.y); y <= static_cast<int>(high.y); ++y)
                for (int x = static_cast<int>(low.x); x <= static_cast<int>(high.x); ++x) {
                    const glm::dvec2 p(x + 0.5, y + 0.5);
                    const glm::dvec3 w =
                        glm::dvec3(twice(c[1] - p, c[2] - p), twice(c[2] - p, c[0] - p), twice(c[0] - p, c[1] - p)) /
                        whole;
                    if (glm::all(glm::greaterThanEqual(w, glm::dvec3(0.0))))
                        visit(static_cast<std::size_t>(y * frame.x + x), w, t / 3);
                }
        }
    }

    /// The bleed value of each pixel, interpolated between the values that the CPU gives the vertices.
    std::vector<double> interpolated(double time) const {
        const Organ organ = refine(load_organ(folder / "sheet.obj")).organ;
        Effects effects(organ, preset, {.seed = 1, .gravity = scene.gravity, .clip_folders = {}});
        effects.set_contacts(scene.events);
        effects.seek(time);
        std::vector<glm::vec2> bleed(organ.positions.size());
        glGetNamedBufferSubData(effects.bleed_buffer(), 0, static_cast<GLsizeiptr>(bleed.size() * sizeof(glm::vec2)),
                                bleed.data());
        std::vector<double> values(static_cast<std::size_t>(frame.x * frame.y), -1e9);
        each_pixel(organ, [&](std::size_t pixel, glm::dvec3 w, std::size_t triangle) {
            glm::dvec3 corner;
            for (int k = 0; k < 3; ++k) corner[k] = bleed[organ.indices[3 * triangle + static_cast<std::size_t>(k)]].x;
            values[pixel] = glm::dot(corner, w);
        });
        return values;
    }

    /// How far the edge bends inside a triangle: root mean square distance, in pixels, of the edge's pixels from the
    /// straight line through them, mean over the triangles that hold a good piece of it.
    double bend(const std::vector<bool>& mask) const {
        const Organ organ = refine(load_organ(folder / "sheet.obj")).organ;
        std::vector<std::vector<glm::dvec2>> pieces(organ.triangle_count());
        each_pixel(organ, [&](std::size_t pixel, glm::dvec3, std::size_t triangle) {
            const auto x = static_cast<int>(pixel) % frame.x, y = static_cast<int>(pixel) / frame.x;
            if (x == 0 || y == 0 || x + 1 == frame.x || y + 1 == frame.y || !mask[pixel]) return;
            const auto row = static_cast<std::size_t>(frame.x);
            if (!mask[pixel - 1] || !mask[pixel + 1] || !mask[pixel - row] || !mask[pixel + row])
                pieces[triangle].emplace_back(x, y);
        });
        double sum = 0.0;
        int count = 0;
        for (const auto& piece : pieces) {
            if (piece.size() < 15) continue;
            glm::dvec2 mean(0.0);
            for (const glm::dvec2 p : piece) mean += p / static_cast<double>(piece.size());
            double xx = 0.0, yy = 0.0, xy = 0.0;
            for (const glm::dvec2 p : piece) {
                const glm::dvec2 d = p - mean;
                xx += d.x * d.x, yy += d.y * d.y, xy += d.x * d.y;
            }
            // The smaller eigenvalue of the scatter matrix.
            const double least = (xx + yy - std::hypot(xx - yy, 2.0 * xy)) / 2.0;
            sum += std::sqrt(std::max(least, 0.0) / static_cast<double>(piece.size()));
            ++count;
        }
        EXPECT_GT(count, 8);
        return sum / std::max(count, 1);
    }
};

TEST_F(EdgeTest, WithoutNoiseItIsTheMeshsPolygonToThePixel) {
    preset.bleeding.noise_strength = 0.0;
    look_closely();
    for (const double degrees : {0.0, 31.0}) {
        use_sheet(largest_triangles, degrees);
        const std::vector<bool> mask = blood_mask(1.3);
        const std::vector<double> values = interpolated(1.3);
        int wrong = 0, inside = 0;
        for (int y = 1; y + 1 < frame.y; ++y)
            for (int x = 1; x + 1 < frame.x; ++x) {
                // Right if this pixel or a neighbour is on the mask's side.
                const bool blood = mask[static_cast<std::size_t>(y * frame.x + x)];
                bool right = false;
                for (int n = 0; n < 9; ++n) {
                    const int neighbour = (y + n / 3 - 1) * frame.x + x + n % 3 - 1;
                    right = right || (values[static_cast<std::size_t>(neighbour)] > 0.0) == blood;
                }
                inside += blood ? 1 : 0;
                wrong += right ? 0 : 1;
            }
        EXPECT_GT(inside, 5'000);
        EXPECT_EQ(wrong, 0) << "turned by " << degrees << " degrees";
        EXPECT_LT(bend(mask), 0.45) << "straight in every triangle";
    }
}

TEST_F(EdgeTest, NoiseBendsItInsideTriangles) {
    preset.bleeding.noise_strength = 1.3;
    preset.bleeding.noise_scale = 1.5;
    look_closely();
    for (const double degrees : {0.0, 31.0}) {
        use_sheet(largest_triangles, degrees);
        EXPECT_GT(bend(blood_mask(1.3)), 0.9) << "turned by " << degrees << " degrees";
    }
}

TEST_F(EdgeTest, WithNoiseItStaysWhereItIsWhenTheMeshIsTurned) {
    // Noise is in organ space: on meshes fine enough for the distance, the edge is the same on both.
    preset.bleeding.noise_strength = 3.0;
    use_sheet(60);
    const std::vector<bool> straight = blood_mask(3.0);
    use_sheet(60, 31.0);
    const std::vector<bool> turned = blood_mask(3.0);
    int apart = 0, inside = 0;
    for (std::size_t i = 0; i < straight.size(); ++i) {
        apart += straight[i] != turned[i] ? 1 : 0;
        inside += straight[i] ? 1 : 0;
    }
    EXPECT_GT(inside, 5'000);
    EXPECT_LT(apart, inside / 50);
}

TEST_F(EdgeTest, NoiseTakesAsMuchAsItGives) {
    use_sheet(60);
    frame = {200, 200};  // pixels of a third of a millimetre
    const double radius = 14.0, disc = std::numbers::pi * radius * radius;
    preset.bleeding.max_extent = radius;
    preset.bleeding.noise_strength = 3.0;
    for (const double rivulets : {0.0, 1.0}) {
        preset.bleeding.rivulets = rivulets;
        // Level, then as on a wall, where down is in the sheet. Without a bias of the spread blood is a disc on both.
        for (const glm::dvec3 down : {glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(0.0, 0.0, 1.0)}) {
            scene.gravity = down;
            EXPECT_NEAR(mean_area(8.0, 6), disc, 0.05 * disc)
                << "rivulets " << rivulets << ", down " << down.y << ' ' << down.z;
        }
    }
}

TEST_F(EdgeTest, BloodOnCoarseMeshesCoversWhatItShouldInThePicture) {
    frame = {200, 200};
    preset.bleeding.speed = 4.0;
    preset.bleeding.max_extent = 14.0;
    scene.events[0].position = scene.events[0].to = {2.3, 0.0, 4.1};  // inside a triangle
    const double disc = std::numbers::pi * 14.0 * 14.0;
    for (const std::uint32_t squares : {80u, 8u, 4u, 2u, 1u}) {  // edges of 1, 10, 20, 40, 80 mm
        use_sheet(squares);
        preset.bleeding.noise_strength = 0.0;
        scene.seed = 1;
        const double shown = area(blood_mask(8.0));
        EXPECT_NEAR(shown, disc, 0.05 * disc) << squares;
        Preview p = preview();
        p.image(8.0, {8, 8});
        EXPECT_NEAR(p.amounts().blood_area, shown, 0.02 * disc) << squares;
        preset.bleeding.noise_strength = 3.0;
        EXPECT_NEAR(mean_area(8.0, 4), disc, 0.07 * disc) << "with noise, " << squares;
    }
}

TEST_F(EdgeTest, ItsRadiusIsSpeedTimesTimeUpToTheExtent) {
    preset.bleeding.noise_strength = 0.0;
    preset.bleeding.speed = 4.0;
    preset.bleeding.max_extent = 13.0;
    frame = {200, 200};
    use_sheet(120);
    for (const double time : {1.5, 2.5, 3.0, 4.0, 9.0}) {
        const double expected = std::min(4.0 * time, 13.0);
        EXPECT_NEAR(std::sqrt(area(blood_mask(time)) / std::numbers::pi), expected, 0.02 * expected) << time << " s";
    }
}

}  // namespace
}  // namespace lapfx
