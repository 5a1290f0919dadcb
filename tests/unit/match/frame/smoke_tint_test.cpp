// The tint of a known smoke over painted tissue.
#include "match/frame/smoke_tint.h"

#include <gtest/gtest.h>

#include "unit/match/pictures.h"

namespace lapfx::match {
namespace {

/// Tissue with dark hollows behind a veil of this light (red, green, blue).
struct Smoky {
    SmokeLayers layers;
    explicit Smoky(const glm::dvec3& light, double from = 0.4, double to = 0.4) {
        layers.clear = test::tissue();
        const cv::Size size = layers.clear.size();
        layers.veil = test::ramp(from, to);
        layers.valid = cv::Mat(size, CV_8U, cv::Scalar(255));
        layers.light = cv::Mat(size, CV_32FC3, cv::Scalar(light.b, light.g, light.r));
        layers.seen = test::veiled(layers.clear, layers.veil, layers.light);
    }
    std::optional<glm::dvec3> tint() const { return smoke_tint(layers); }
};

TEST(SmokeTint, IsThatOfTheSmoke) {
    for (const glm::dvec3& light :
         {glm::dvec3(0.2, 0.2, 0.2), glm::dvec3(0.2, 0.16, 0.24), glm::dvec3(0.27, 0.25, 0.2)}) {
        const std::optional<glm::dvec3> found = Smoky(light).tint();
        ASSERT_TRUE(found);
        const glm::dvec3 wanted = light * (3.0 / (light.r + light.g + light.b));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR((*found)[c], wanted[c], 0.01);
    }
}

TEST(SmokeTint, OfAnUnevenVeilAndALightOfAnotherTint) {
    Smoky smoky({0.2, 0.16, 0.24}, 0.2, 0.6);
    smoky.layers.light.setTo(cv::Scalar(0.17, 0.17, 0.21));
    const std::optional<glm::dvec3> found = smoky.tint();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->r, 1.0, 0.04);
    EXPECT_NEAR(found->g, 0.8, 0.04);
    EXPECT_NEAR(found->b, 1.2, 0.04);
}

TEST(SmokeTint, DoesNotNeedTheBaselineInItsPlace) {
    Smoky smoky({0.2, 0.16, 0.24});
    cv::flip(smoky.layers.clear, smoky.layers.clear, -1);
    const std::optional<glm::dvec3> found = smoky.tint();
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->b, 1.2, 0.02);
}

TEST(SmokeTint, IsNotToldByWhatIsNoSmoke) {
    EXPECT_FALSE(Smoky({0.2, 0.2, 0.2}, 0.05, 0.05).tint()) << "too thin";
    EXPECT_FALSE(Smoky({0.3, 0.1, 0.1}).tint()) << "no smoke is so red";
    Smoky bright({0.2, 0.2, 0.2});
    bright.layers.clear *= 3.0;  // other tissue
    EXPECT_FALSE(bright.tint());
    Smoky small({0.2, 0.2, 0.2});
    small.layers.valid.setTo(0);
    small.layers.valid(cv::Rect(0, 0, 20, 20)).setTo(255);
    EXPECT_FALSE(small.tint());
}

}  // namespace
}  // namespace lapfx::match
