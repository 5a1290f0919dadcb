#include "smoke/keying_pixel.h"

#include <gtest/gtest.h>

#include <limits>

namespace lapfx::smoke {
namespace {

constexpr Keying by_luma{
    .luma_low = 16, .luma_high = 216, .key_chroma = {0, 0}, .chroma_low = 0, .chroma_high = 0, .spill = 0, .dark = 0};

/// Before a green screen.
Keying by_chroma() {
    Keying key = by_luma;
    key.luma_low = -1.0f;
    key.luma_high = 0.0f;
    key.key_chroma = chroma({0, 255, 0});
    key.chroma_low = 40.0f;
    key.chroma_high = 140.0f;
    key.spill = 1.0f;
    return key;
}

TEST(Keying, LumaAndChromaAreThoseOfBt601) {
    EXPECT_NEAR(luma({255, 255, 255}), 255.0f, 1e-4f);
    EXPECT_NEAR(luma({100, 0, 0}), 29.9f, 1e-4f);
    EXPECT_NEAR(luma({0, 100, 0}), 58.7f, 1e-4f);
    EXPECT_NEAR(luma({0, 0, 100}), 11.4f, 1e-4f);
    EXPECT_NEAR(chroma({128, 128, 128}).x, 0.0f, 1e-4f);
    EXPECT_NEAR(chroma({128, 128, 128}).y, 0.0f, 1e-4f);
    EXPECT_NEAR(chroma({0, 0, 255}).x, 127.5f, 1e-3f);  // the definition: half of full scale
    EXPECT_NEAR(chroma({255, 0, 0}).y, 127.5f, 1e-3f);
}

TEST(Keying, LumaRampIsLinearBetweenItsThresholds) {
    for (const auto& [grey, alpha] :
         {std::pair{0.f, 0.f}, {16.f, 0.f}, {66.f, 0.25f}, {116.f, 0.5f}, {216.f, 1.f}, {255.f, 1.f}})
        EXPECT_NEAR(key_alpha(glm::vec3(grey), by_luma), alpha, 1e-5f) << grey;
}

TEST(Keying, DarkPolarityKeysTheNegative) {
    Keying key = by_luma;
    key.dark = 1.0f;
    for (const auto& [grey, alpha] : {std::pair{255.f, 0.f}, {239.f, 0.f}, {139.f, 0.5f}, {39.f, 1.f}, {0.f, 1.f}})
        EXPECT_NEAR(key_alpha(glm::vec3(grey), key), alpha, 1e-5f) << grey;
}

TEST(Keying, MixedSmokeKeepsItsOpacity) {
    // The reason why the ramps are linear: white smoke of opacity a over the key colour has alpha a.
    Keying key = by_chroma();
    key.chroma_low = 0.0f;
    key.chroma_high = glm::length(key.key_chroma);
    for (float a = 0.0f; a <= 1.0f; a += 0.125f)
        EXPECT_NEAR(key_alpha(glm::mix(glm::vec3(0, 255, 0), glm::vec3(255), a), key), a, 1e-4f);
}

TEST(Keying, ChromaIsUnusedWithBothBoundsZero) {
    EXPECT_NEAR(key_alpha({0, 255, 0}, by_luma), ramp(luma({0, 255, 0}), 16, 216), 1e-6f);
}

TEST(Keying, DespillTakesOutTheKeyColourOnly) {
    Keying key = by_chroma();
    const glm::vec2 across(-key.key_chroma.y, key.key_chroma.x);
    const glm::vec2 spilled = 0.3f * key.key_chroma + 0.2f * across;
    EXPECT_NEAR(glm::distance(despill(spilled, key), 0.2f * across), 0.0f, 1e-4f);
    key.spill = 0.5f;
    EXPECT_NEAR(glm::distance(despill(spilled, key), 0.15f * key.key_chroma + 0.2f * across), 0.0f, 1e-4f);
    EXPECT_EQ(despill(-key.key_chroma, key), -key.key_chroma) << "the opposite colour stays";
    EXPECT_EQ(despill({12, -5}, by_luma), glm::vec2(12, -5)) << "a grey background has no colour to take out";
}

TEST(Keying, VaryingKeepsAlphaWithinBounds) {
    EXPECT_NEAR(vary_alpha(0.5f, 0.4f, 0.5f), 0.6f, 1e-6f);
    EXPECT_NEAR(vary_alpha(0.5f, -0.4f, 0.5f), 0.4f, 1e-6f);
    EXPECT_EQ(vary_alpha(0.9f, 1.0f, 1.0f), 1.0f);
    EXPECT_EQ(vary_alpha(0.9f, -1.5f, 1.0f), 0.0f);
    EXPECT_EQ(vary_alpha(0.3f, 0.8f, 0.0f), 0.3f);
}

TEST(Keying, WhateverAPixelHoldsAlphaIsWithinZeroAndOne) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const Keying& key : {by_luma, by_chroma()})
        for (const float r : {nan, infinity, -infinity, -64.0f, 0.0f, 320.0f})
            for (const float g : {nan, infinity, -infinity, 128.0f})
                for (const float b : {nan, infinity, -infinity, 128.0f}) {
                    const float alpha = vary_alpha(key_alpha({r, g, b}, key), 0.5f, 0.35f);
                    EXPECT_TRUE(alpha >= 0.0f && alpha <= 1.0f) << r << ' ' << g << ' ' << b << ": " << alpha;
                }
}

/// Smoke at the left of x = 10, pixels.
float half_plane(glm::vec2 position) {
    return position.x < 10.0f ? 1.0f : 0.0f;
}

TEST(Keying, ChokeDrawsTheEdgeInByItsPixels) {
    for (const float choke : {0.0f, 0.5f, 3.0f, 16.0f}) {
        EXPECT_EQ(choked(half_plane, {9.9f - choke, 5.0f}, choke), 1.0f) << choke;
        EXPECT_EQ(choked(half_plane, {10.1f - choke, 5.0f}, choke), 0.0f) << choke;
    }
}

TEST(Keying, FeatherIsAMeanOverItsPixels) {
    EXPECT_EQ(edged(half_plane, {9.9f, 5.0f}, 0.0f, 0.0f), 1.0f);
    EXPECT_EQ(edged(half_plane, {5.9f, 5.0f}, 0.0f, 4.0f), 1.0f) << "beyond its reach nothing changes";
    EXPECT_EQ(edged(half_plane, {14.1f, 5.0f}, 0.0f, 4.0f), 0.0f);
    EXPECT_NEAR(edged(half_plane, {9.9f, 5.0f}, 0.0f, 4.0f), 6.0f / 9.0f, 1e-6f)
        << "itself and all but three to the right";
    EXPECT_NEAR(edged(half_plane, {10.1f, 5.0f}, 0.0f, 4.0f), 3.0f / 9.0f, 1e-6f);
    EXPECT_NEAR(edged(half_plane, {7.9f, 5.0f}, 2.0f, 4.0f), 6.0f / 9.0f, 1e-6f) << "choked first";
}

TEST(Keying, TheTintIsThatOfBrightSmokeAndBoundedForDarkOne) {
    EXPECT_EQ(tint(200.0f, {0.0f, 0.0f}), glm::vec3(1.0f));
    const glm::vec3 warm(180.0f, 160.0f, 150.0f);
    const glm::vec3 found = tint(luma(warm), chroma(warm)) * luma(warm);
    EXPECT_NEAR(glm::distance(found, warm), 0.0f, 0.1f);
    EXPECT_EQ(tint(0.0f, {0.0f, 127.0f}).r, 2.0f);
    EXPECT_EQ(tint(0.0f, {127.0f, 127.0f}).g, 0.0f);
}

TEST(Keying, SmokeWithItsOwnOpacityIsShadedByItsLuma) {
    for (const float alpha : {0.02f, 0.1f, 0.5f, 1.0f})
        EXPECT_NEAR(shade(128.0f * alpha, alpha), 1.0f, 1e-5f) << "middle grey, premultiplied, " << alpha;
    for (const float alpha : {0.0f, 0.02f, 0.5f, 1.0f})
        EXPECT_EQ(shade(255.0f * std::max(alpha, 0.01f), alpha), 1.0f)
            << "white, as the same keyed from black, " << alpha;
    EXPECT_EQ(shade(160.0f, 1.0f), 1.0f);
    EXPECT_NEAR(shade(96.0f, 1.0f), std::pow(0.8f / 1.05f, 2.0f), 1e-5f);
    EXPECT_NEAR(shade(32.0f, 0.5f), std::pow(0.3f / 0.55f, 2.0f), 1e-5f);
    EXPECT_EQ(shade(0.0f, 0.0f), 1.0f) << "nothing is there, so nothing is known";
    EXPECT_NEAR(shade(0.0f, 0.004f), 0.857f, 0.01f) << "a code value of rounding changes little";
    EXPECT_EQ(shade(0.0f, 1.0f), 0.1f);
    EXPECT_EQ(shade(255.0f, 0.0f), 1.0f) << "straight alpha";
}

TEST(Keying, ConstantsComeFromThePreset) {
    KeyingParameters k;
    k.luma_low = 20.0;
    k.luma_high = 90.0;
    k.key_color = {0.0, 1.0, 0.0};
    k.chroma_low = 30.0;
    k.chroma_high = 70.0;
    k.spill = 0.25;
    const Keying key = keying_of(k, ClipPolarity::dark);
    EXPECT_EQ(key.luma_low, 20.0f);
    EXPECT_EQ(key.luma_high, 90.0f);
    EXPECT_EQ(key.key_chroma, chroma({0, 255, 0}));
    EXPECT_EQ(key.chroma_low, 30.0f);
    EXPECT_EQ(key.chroma_high, 70.0f);
    EXPECT_EQ(key.spill, 0.25f);
    EXPECT_EQ(key.dark, 1.0f);
    EXPECT_EQ(keying_of(k, ClipPolarity::light).dark, 0.0f);
}

TEST(Keying, EqualThresholdsAreAStep) {
    Keying key = by_luma;
    key.luma_low = key.luma_high = 100.0f;
    EXPECT_EQ(key_alpha(glm::vec3(99.9f), key), 0.0f);
    EXPECT_EQ(key_alpha(glm::vec3(100.1f), key), 1.0f);
}

}  // namespace
}  // namespace lapfx::smoke
