// Tissue that is charred, divided or covered with blood, drawn from given vertex values; and the two programs of an
// organ, one for such tissue and one for the rest, which must give the same pixels where nothing has happened.
#include "bleeding/bleed_gpu.h"
#include "render/camera.h"
#include "render/organ_gpu.h"
#include "render/view_block.h"
#include "support/gpu_test.h"
#include "support/meshes.h"

namespace lapfx {
namespace {

constexpr glm::ivec2 size(200, 200);
constexpr double height = 40.0;  // mm, of the camera above the sheet

class WoundedTest : public test::GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (IsSkipped()) return;
        organ = test::plane(30.0, 30);
        blood.assign(organ.positions.size(), glm::vec2(-10.0f, 0.0f));
        marks.assign(organ.positions.size(), glm::vec2(0.0f));
    }

    /// Linear light per pixel, rows from below.
    std::vector<glm::vec3> picture() const {
        const VertexRun all{0, static_cast<std::uint32_t>(blood.size())};
        const bleeding::BleedGpu bleed(blood.size());
        bleed.set({}, {0.0, -1.0, 0.0}, 3);
        bleed.send(blood, {&all, 1});
        const render::OrganGpu gpu(organ, &bleed);
        gpu.send_marks(marks, {&all, 1});
        const gl::Texture color({.size = size, .format = GL_RGBA32F}),
            depth({.size = size, .format = GL_DEPTH_COMPONENT32F});
        const gl::Framebuffer framebuffer(color, &depth);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
        glViewport(0, 0, size.x, size.y);
        const float black[4] = {}, far = 1.0f;
        glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, black);
        glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &far);
        SceneCamera camera;
        camera.eye = {0.0, height, 0.0};
        camera.target = {0.0, 0.0, 0.0};
        camera.up = {0.0, 0.0, -1.0};
        SceneLight light;
        light.focus_distance = height;
        const render::ViewBlock view;
        view.bind(render::view_of(camera, light, size));
        bleed.bind();
        gpu.draw(glm::mat4(1.0f));
        std::vector<glm::vec4> pixels(static_cast<std::size_t>(size.x * size.y));
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(pixels.size() * sizeof(glm::vec4)),
                          pixels.data());
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
        return {pixels.begin(), pixels.end()};
    }

    /// Where on the sheet a pixel lies, mm.
    static glm::dvec2 place(std::size_t pixel) {
        const double mm = 2.0 * height * std::tan(glm::radians(SceneCamera{}.field_of_view) / 2.0) / size.y;
        return (glm::dvec2(pixel % 200, pixel / 200) + 0.5 - glm::dvec2(size) / 2.0) * mm;
    }

    /// Median per channel of the pixels from `low` to `high` mm left or right of the middle; highlights do not count.
    static glm::vec3 median(const std::vector<glm::vec3>& picture, double low, double high) {
        glm::vec3 result;
        for (int c = 0; c < 3; ++c) {
            std::vector<float> values;
            for (std::size_t i = 0; i < picture.size(); ++i)
                if (const glm::dvec2 p = place(i); std::abs(p.x) >= low && std::abs(p.x) < high && std::abs(p.y) < 12.0)
                    values.push_back(picture[i][c]);
            std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                             values.end());
            result[c] = values[values.size() / 2];
        }
        return result;
    }

    /// Gives `value` to a strip along the middle, 2 * `half` mm wide.
    void mark_strip(glm::vec2 value, double half) {
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (std::abs(organ.positions[i].x) <= half) marks[i] = value;
    }

    Organ organ;
    std::vector<glm::vec2> blood, marks;
};

float largest_difference(const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (int c = 0; c < 3; ++c) largest = std::max(largest, std::abs(a[i][c] - b[i][c]));
    return largest;
}

TEST_F(WoundedTest, BothProgramsDrawUntouchedTissueAlike) {
    const auto plain = picture();
    EXPECT_GT(median(plain, 0.0, 12.0).r, 0.2f) << "the sheet is in view";
    // Too little char to be visible, but enough for the other program; then for half of the triangles.
    marks.assign(marks.size(), glm::vec2(1e-7f, 0.0f));
    EXPECT_LT(largest_difference(plain, picture()), 1e-4f);
    for (std::size_t i = 0; i < marks.size(); ++i) marks[i].x = i % 3 == 0 ? 1e-7f : 0.0f;
    EXPECT_LT(largest_difference(plain, picture()), 1e-4f) << "and there is no seam between them";
}

TEST_F(WoundedTest, CharIsBlackAndItsSurroundingsAreUntouched) {
    const auto plain = picture();
    mark_strip({1.0f, 0.0f}, 3.0);
    const auto charred = picture();
    const glm::vec3 before = median(plain, 0.0, 2.5), after = median(charred, 0.0, 2.5);
    for (int c = 0; c < 3; ++c) EXPECT_LT(after[c], 0.15f * before[c]) << "channel " << c;
    EXPECT_EQ(median(charred, 5.0, 12.0), median(plain, 5.0, 12.0));
}

TEST_F(WoundedTest, GentlyHeatedTissueIsPaleAndLosesItsColour) {
    const auto plain = picture();
    mark_strip({0.25f, 0.0f}, 3.0);
    const glm::vec3 before = median(plain, 0.0, 2.5), after = median(picture(), 0.0, 2.5);
    EXPECT_LT(after.r / after.g, before.r / before.g);
    EXPECT_GT(after.r, 0.4f * before.r) << "not burnt";
}

TEST_F(WoundedTest, DividedTissueIsRawAndDarkInsideAndUntouchedBeside) {
    const auto plain = picture();
    mark_strip({0.0f, 1.0f}, 1.0);
    const auto divided = picture();
    const glm::vec3 before = median(plain, 0.0, 1.0), inside = median(divided, 0.0, 1.0);
    EXPECT_LT(inside.g, 0.15f * before.g);
    EXPECT_GT(inside.r / inside.g, 2.0f * before.r / before.g) << "raw: red";
    EXPECT_EQ(median(divided, 4.0, 12.0), median(plain, 4.0, 12.0));
    // Its walls lean, so a shallow one is seen by its shading.
    mark_strip({0.0f, 0.3f}, 1.0);
    EXPECT_GT(largest_difference(picture(), plain), 0.02f) << "a dent";
}

TEST_F(WoundedTest, FreshBloodHidesCharAndClotsDoNotShine) {
    mark_strip({1.0f, 0.0f}, 15.0);
    const glm::vec3 charred = median(picture(), 0.0, 12.0);
    blood.assign(blood.size(), glm::vec2(12.0f, 0.0f));
    const auto fresh = picture();
    const glm::vec3 covered = median(fresh, 0.0, 12.0);
    EXPECT_GT(covered.r, 2.0f * charred.r);
    EXPECT_GT(covered.r, 5.0f * covered.g);
    blood.assign(blood.size(), glm::vec2(12.0f, 1.0f));
    const auto clotted = picture();
    EXPECT_LT(median(clotted, 0.0, 12.0).r, 0.8f * covered.r);
    const auto brightest = [](const std::vector<glm::vec3>& all) {
        float most = 0.0f;
        for (const glm::vec3 p : all) most = std::max(most, p.g);
        return most;
    };
    EXPECT_LT(brightest(clotted), 0.2f * brightest(fresh));
}

}  // namespace
}  // namespace lapfx
