// An organ whose long triangles are split for its blood is drawn with its original triangles where nothing has happened
// to it, and the picture equals that of the split ones.
#include <map>

#include "gl/objects.h"
#include "lapfx/effects.h"
#include "lapfx/refine.h"
#include "parity/render/scene_fixture.h"
#include "render/camera.h"
#include "render/touched_triangles.h"

namespace lapfx {
namespace {

class UnsplitTest : public test::SceneTest {
  protected:
    static constexpr glm::ivec2 extent{320, 320};

    void SetUp() override {
        SceneTest::SetUp();
        if (IsSkipped()) return;
        preset.smoke.clips.clear();
        color = gl::Texture({.size = extent, .format = GL_RGBA32F, .samples = 4});
        depth = gl::Texture({.size = extent, .format = GL_DEPTH_COMPONENT32F, .samples = 4});
        target = gl::Framebuffer(color, &depth);
        resolved_color = gl::Texture({.size = extent, .format = GL_RGBA32F});
        resolved = gl::Framebuffer(resolved_color, nullptr);
    }

    /// Cuts and a burn all over what the camera sees.
    void wound(Effects& effects, double radius) const {
        std::vector<ToolContact> contacts;
        for (int i = 0; i < 5; ++i) {
            const glm::dvec3 at = radius * glm::normalize(glm::dvec3(std::cos(1.3 * i), 0.4 * i - 0.6, 1.2));
            contacts.push_back({.action = i == 4 ? ToolAction::cauterise : ToolAction::cut,
                                .duration = i == 4 ? 3.0 : 0.1,
                                .position = at,
                                .to = at});
        }
        effects.set_contacts(contacts);
    }

    Effects bleeding(const Organ& organ) const {
        Effects effects(organ, preset);
        wound(effects, 60.0);
        effects.seek(2.5);
        return effects;
    }

    /// The organ without its triangles above `y`, and which of its vertices each one was.
    static std::pair<Organ, std::vector<std::uint32_t>> without_top(const Organ& organ, float y) {
        Organ cut;
        std::vector<glm::vec3> normals;
        std::vector<std::uint32_t> origin;
        std::map<std::uint32_t, std::uint32_t> known;
        for (std::size_t t = 0; t < organ.indices.size(); t += 3) {
            const std::span corners = std::span(organ.indices).subspan(t, 3);
            const auto above = [&](std::uint32_t v) { return organ.positions[v].y > y; };
            if (std::any_of(corners.begin(), corners.end(), above)) continue;
            for (const std::uint32_t v : corners) {
                const auto [at, is_new] = known.try_emplace(v, static_cast<std::uint32_t>(origin.size()));
                cut.indices.push_back(at->second);
                if (!is_new) continue;
                cut.positions.push_back(organ.positions[v]);
                normals.push_back(organ.normals[v]);
                origin.push_back(v);
            }
        }
        return {test::drawable(std::move(cut), normals), origin};
    }

    /// Linear light, per pixel.
    std::vector<glm::vec4> draw(Effects& effects, const glm::dvec3& eye) const {
        constexpr float black[4] = {}, far = 1.0f;
        glClearNamedFramebufferfv(target.name(), GL_COLOR, 0, black);
        glClearNamedFramebufferfv(target.name(), GL_DEPTH, 0, &far);
        glViewport(0, 0, extent.x, extent.y);
        glBindFramebuffer(GL_FRAMEBUFFER, target.name());
        effects.draw_organ(
            render::view_of({.eye = eye, .target = {0, 0, 0}, .up = {0, 1, 0}}, {.focus_distance = 100.0}, extent));
        glBlitNamedFramebuffer(target.name(), resolved.name(), 0, 0, extent.x, extent.y, 0, 0, extent.x, extent.y,
                               GL_COLOR_BUFFER_BIT, GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        std::vector<glm::vec4> pixels(static_cast<std::size_t>(extent.x * extent.y));
        glGetTextureImage(resolved_color.name(), 0, GL_RGBA, GL_FLOAT,
                          static_cast<GLsizei>(pixels.size() * sizeof(glm::vec4)), pixels.data());
        return pixels;
    }

    struct Difference {
        int pixels = 0;  ///< that differ by more than a hundredth
        int red = 0;     ///< with blood, of the first
        double mean = 0.0;
    };
    Difference compare(Effects& a, Effects& b, const glm::dvec3& eye) const {
        const std::vector<glm::vec4> p = draw(a, eye), q = draw(b, eye);
        Difference found;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const glm::vec3 apart = glm::abs(glm::vec3(p[i] - q[i]));
            const float most = std::max({apart.r, apart.g, apart.b});
            found.pixels += most > 0.01f ? 1 : 0;
            found.red += p[i].r > 0.02f && p[i].r > 4.0f * p[i].g ? 1 : 0;
            found.mean += static_cast<double>(most) / static_cast<double>(p.size());
        }
        return found;
    }

    /// Directly at it; along it, so that triangles are seen edge on; from close by.
    void expect_alike(Effects& a, Effects& b) const {
        int red = 0;
        for (const glm::dvec3& eye : {glm::dvec3(0, 0, 150), {90, 30, 70}, {20, 62, 66}, {5, 2, 61.5}}) {
            const Difference found = compare(a, b, eye);
            EXPECT_LE(found.pixels, 20) << "of " << extent.x * extent.y << " at " << eye.x;
            EXPECT_LE(found.mean, 5e-4) << eye.x;
            red += found.red;
        }
        EXPECT_GT(red, 5000) << "there is blood to tell apart";
    }

    gl::Texture color, depth, resolved_color;
    gl::Framebuffer target, resolved;
};

TEST_F(UnsplitTest, ThePictureIsThatOfTheSplitTriangles) {
    for (const int cuts : {2, 3}) {
        const Organ given = test::sphere(60.0, cuts), fine = refine(given).organ;
        ASSERT_GT(fine.triangle_count(), 3 * given.triangle_count());
        Effects unsplit = bleeding(given), split = bleeding(fine);
        expect_alike(unsplit, split);
        // Removed blood leaves no trace.
        unsplit.seek(5.0);
        unsplit.seek(0.5);
        Effects early(fine, preset);
        wound(early, 60.0);
        early.seek(0.5);
        EXPECT_LE(compare(unsplit, early, {0, 0, 150}).pixels, 20);
    }
}

TEST_F(UnsplitTest, SoItIsWhenItMovesAndUnderOverlays) {
    const Organ given = test::sphere(60.0, 3);
    const RefinedOrgan fine = refine(given);
    Effects unsplit = bleeding(given), split = bleeding(fine.organ);
    std::vector<glm::vec3> moved = given.positions, all, normals;
    for (glm::vec3& p : moved) p += glm::vec3(0.0f, 0.08f * p.x, 0.0f);
    all = moved;
    normals = given.normals;
    for (const glm::uvec2& m : fine.midpoints) {
        all.push_back(0.5f * (all[m.x] + all[m.y]));
        normals.push_back(glm::normalize(normals[m.x] + normals[m.y]));
    }
    unsplit.set_shape(moved, given.normals);
    split.set_shape(all, normals);
    expect_alike(unsplit, split);
    // A host that has all vertices may bend the surface between those of the file, and that is drawn.
    for (std::size_t v = moved.size(); v < all.size(); ++v) all[v] *= 60.0f / glm::length(fine.organ.positions[v]);
    unsplit.set_shape(all, normals);
    split.set_shape(all, normals);
    EXPECT_EQ(compare(unsplit, split, {90, 30, 70}).mean, 0.0);
    for (const Overlay overlay : {Overlay::bleed, Overlay::vessels}) {
        unsplit.set_shape(fine.organ.positions, fine.organ.normals);
        split.set_shape(fine.organ.positions, fine.organ.normals);
        unsplit.set_shape(given.positions, given.normals);
        unsplit.set_overlay(overlay);
        split.set_overlay(overlay);
        EXPECT_LE(compare(unsplit, split, {20, 62, 66}).mean, 1e-6);
    }
}

TEST_F(UnsplitTest, SoItIsOnceItHasBeenCut) {
    const Organ given = test::sphere(60.0, 3);
    const RefinedOrgan fine = refine(given);
    Effects unsplit = bleeding(given), split = bleeding(fine.organ);
    auto [cut, origin] = without_top(given, 40.0f);
    ASSERT_LT(cut.triangle_count(), given.triangle_count());
    unsplit.set_topology(cut, origin);
    // The same for all vertices: a midpoint between the same two vertices is the same.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> former;
    auto next = static_cast<std::uint32_t>(given.positions.size());
    for (const glm::uvec2& m : fine.midpoints) former[std::minmax(m.x, m.y)] = next++;
    const RefinedOrgan fine_cut = refine(cut);
    for (const glm::uvec2& m : fine_cut.midpoints) {
        const auto found = former.find(std::minmax(origin[m.x], origin[m.y]));
        origin.push_back(found == former.end() ? Effects::new_vertex : found->second);
    }
    split.set_topology(fine_cut.organ, origin);
    for (const double time : {2.5, 4.0}) {
        for (Effects* e : {&unsplit, &split}) e->seek(time);
        expect_alike(unsplit, split);
    }
}

TEST_F(UnsplitTest, SoItIsWhenBloodRunsAnotherWayOrItsEdgeReachesFurther) {
    const Organ given = test::sphere(60.0, 3), fine = refine(given).organ;
    preset.bleeding.noise_strength = 0.0;
    Effects unsplit = bleeding(given), split = bleeding(fine);
    for (Effects* e : {&unsplit, &split}) {
        e->set_gravity({1.0, 0.0, 0.2});
        e->seek(2.5);
    }
    expect_alike(unsplit, split);
    preset.bleeding.noise_strength = 8.0;
    for (Effects* e : {&unsplit, &split}) {
        e->set_preset(preset);
        e->seek(2.5);
    }
    expect_alike(unsplit, split);
}

TEST_F(UnsplitTest, OnlyRunsOfTouchedTrianglesAreDrawn) {
    render::TouchedTriangles touched(1000);
    const auto runs = [&](std::size_t begin, std::size_t end) {
        std::vector<std::pair<std::size_t, std::size_t>> found;
        touched.for_each(begin, end, [&](std::size_t b, std::size_t e) { found.emplace_back(b, e); });
        return found;
    };
    using Runs = std::vector<std::pair<std::size_t, std::size_t>>;
    EXPECT_EQ(runs(0, 1000), Runs{});
    touched.touch(300);
    touched.touch(390);
    touched.touch(999);
    EXPECT_EQ(runs(0, 1000), (Runs{{256, 512}, {896, 1000}})) << "neighbours are one run";
    EXPECT_EQ(runs(310, 400), (Runs{{310, 400}})) << "of a part, no more than the part";
    EXPECT_EQ(runs(0, 257), (Runs{{256, 257}}));
    EXPECT_EQ(runs(512, 896), Runs{});
    EXPECT_EQ(runs(0, 0), Runs{});
}

}  // namespace
}  // namespace lapfx
