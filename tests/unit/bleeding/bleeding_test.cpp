// What every bleeding model does for those who do not know it, at the example of the model `spread`.
#include "bleeding/bleeding.h"

#include <gtest/gtest.h>

#include "bleeding/bleed_cpu.h"
#include "support/meshes.h"

namespace lapfx::bleeding {
namespace {

constexpr glm::dvec3 down{0.0, -1.0, 0.0};

/// A model that has the blood which it is told.
class Told final : public Bleeding {
  public:
    explicit Told(std::vector<BloodAt> blood) : blood_(std::move(blood)), changed_(blood_.size()) {}

    Model model() const override { return static_cast<Model>(model_count); }
    void set_parameters(const BleedingParameters&, unsigned) override {}
    void set_wounds(std::span<const Wound>) override {}
    void set_clearing(const tool::Log&) override {}
    void set_strength(const FactorCurve&) override {}
    void replace(Bleeding&) override {}
    void keep(const Bleeding&, std::span<const std::uint32_t>, double) override {}
    void update(double) noexcept override {}
    BloodAt at(std::uint32_t vertex) const noexcept override { return blood_[vertex]; }
    BloodAmount amount() const noexcept override { return {}; }
    std::span<const WoundStatus> wounds() const override { return {}; }
    std::span<const DrawnArray> drawn() const override { return {}; }
    ChangedVertices& changed() override { return changed_; }

  private:
    std::vector<BloodAt> blood_;
    ChangedVertices changed_;
};

TEST(Bleeding, AModelIsMadeAsThePresetAsks) {
    const Surface surface(test::plane(10.0, 4));
    const auto blood = make_bleeding(model_of({}), surface, down);
    EXPECT_EQ(blood->model(), Model::spread);
    EXPECT_EQ(blood->changed().take().size(), 1U) << "at first, all vertices";
    EXPECT_TRUE(blood->changed().empty());
}

TEST(Bleeding, AtAVertexIsWhatIsDrawnThere) {
    const Surface surface(test::plane(60.0, 30));
    BleedField field(surface, down);
    field.set(std::vector<Wound>{{.position = {0, 0, 0}, .stop = 0.5}}, {});
    field.update(1.5);
    ASSERT_EQ(field.drawn().size(), 1U);
    const DrawnArray& drawn = field.drawn().front();
    EXPECT_EQ(drawn.data, field.values().data());
    EXPECT_EQ(drawn.count * drawn.stride, field.values().size_bytes());
    int bloody = 0;
    for (std::uint32_t v = 0; v < field.values().size(); ++v) {
        const BloodAt blood = field.at(v);
        EXPECT_EQ(glm::vec2(blood.value, blood.clot), field.values()[v]);
        EXPECT_EQ(blood.any, field.values()[v].x > field.dry()) << v;
        bloody += blood.any;
    }
    EXPECT_GT(bloody, 10);
    EXPECT_LT(bloody, 900) << "a corner of the sheet is dry";
}

TEST(Bleeding, BloodOfAnyModelStaysWhenTheOrganIsCut) {
    const Organ organ = test::plane(10.0, 4);
    const Surface surface(organ);
    const auto vertices = static_cast<std::uint32_t>(organ.positions.size());
    std::vector<BloodAt> blood(vertices);
    blood[3] = {.any = true, .value = 4.0f, .clot = 0.25f};
    blood[4] = {.any = false, .value = 9.0f, .clot = 0.0f};
    blood[5] = {.any = true, .value = 5.0f, .clot = 0.75f};
    std::vector<std::uint32_t> sources(vertices, Bleeding::gone);
    sources[10] = 3, sources[11] = 4, sources[12] = 5;
    BleedField field(surface, down);
    field.set({}, {});
    field.keep(Told(blood), sources, 2.0);
    field.update(1.9);
    EXPECT_FALSE(field.at(10).any) << "the organ has not been cut yet";
    field.update(2.0);
    EXPECT_EQ(glm::vec2(field.at(10).value, field.at(10).clot), glm::vec2(4.0f, 0.25f));
    EXPECT_EQ(glm::vec2(field.at(12).value, field.at(12).clot), glm::vec2(5.0f, 0.75f));
    for (std::uint32_t v = 0; v < vertices; ++v) EXPECT_EQ(field.at(v).any, v == 10 || v == 12) << v;
}

TEST(Bleeding, WhatLayThereAtTheCutStaysWithTheModelThatKnowsIt) {
    const Organ organ = test::plane(10.0, 4);
    const Surface surface(organ);
    const auto vertices = static_cast<std::uint32_t>(organ.positions.size());
    std::vector<std::uint32_t> sources(vertices, 0);
    BleedField field(surface, down);
    field.keep(Told(std::vector<BloodAt>(vertices, {.any = true, .value = 4.0f})), sources, 0.0);
    BleedField turned(surface, {1.0, 0.0, 0.0});
    turned.replace(field);
    turned.update(1.0);
    EXPECT_EQ(turned.at(7).value, 4.0f);
    Told other(std::vector<BloodAt>(vertices, {.any = true, .value = 4.0f}));
    BleedField anew(surface, down);
    anew.replace(other);
    anew.update(1.0);
    EXPECT_FALSE(anew.at(7).any);
}

TEST(Bleeding, CountsTheWoundsThatBleed) {
    std::vector<WoundStatus> wounds(3);
    wounds[0].bleeds = wounds[2].bleeds = true;
    EXPECT_EQ(bleeding_wounds(wounds), 2);
    EXPECT_EQ(bleeding_wounds({}), 0);
}

}  // namespace
}  // namespace lapfx::bleeding
