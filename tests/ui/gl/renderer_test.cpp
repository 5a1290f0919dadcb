#include "ui/gl/renderer.h"

#include <random>

#include "ui/gl/renderer_fixture.h"
#include "ui/support/count_allocations.h"
#include "ui/support/shape_reference.h"

namespace lapfx::ui::test {
namespace {

/// The sum of the red channel; a full pixel counts as 1.
double red_sum(const Picture& picture) {
    return cv::sum(picture)[0] / 255;
}

// --- shapes ---

TEST_F(RendererTest, AFillOnWholePixelsIsExactlySharp) {
    for (const float radius : {0.0F, 5.0F}) {
        const Picture picture = drawn([&](Painter& p) { p.fill({10, 20, 30, 40}, red, radius); });
        EXPECT_EQ(bounds_of(picture), Rect(10, 20, 30, 40));
        for (int y = 26; y < 54; ++y) {
            EXPECT_EQ(at(picture, 9, y), black);
            EXPECT_EQ(at(picture, 10, y), red);
            EXPECT_EQ(at(picture, 39, y), red);
            EXPECT_EQ(at(picture, 40, y), black);
        }
        EXPECT_EQ(at(picture, 10, 20), radius == 0 ? red : black);
    }
}

TEST_F(RendererTest, TheSmallestFillsAreFull) {
    for (const int side : {1, 2, 3, 4}) {
        const auto length = static_cast<float>(side);
        const Picture picture = drawn([&](Painter& p) { p.fill({10, 20, length, length}, red); });
        EXPECT_EQ(red_sum(picture), side * side);
        EXPECT_EQ(bounds_of(picture), Rect(10, 20, length, length));
    }
}

TEST_F(RendererTest, AFrameIsInsideItsRectangle) {
    const Picture picture = drawn([&](Painter& p) { p.frame({10, 20, 30, 40}, red, 2); });
    EXPECT_EQ(bounds_of(picture), Rect(10, 20, 30, 40));
    for (const int x : {10, 11, 38, 39}) EXPECT_EQ(at(picture, x, 40), red) << x;
    for (const int x : {9, 12, 37, 40}) EXPECT_EQ(at(picture, x, 40), black) << x;
    for (const int y : {20, 21, 58, 59}) EXPECT_EQ(at(picture, 25, y), red) << y;
    for (const int y : {19, 22, 57, 60}) EXPECT_EQ(at(picture, 25, y), black) << y;
}

TEST_F(RendererTest, AFramedFillHasBothColours) {
    const Picture picture = drawn([&](Painter& p) {
        p.fill({10, 20, 30, 40}, red, 4);
        p.frame({10, 20, 30, 40}, {0, 0, 255, 128}, 1, 4);
    });
    EXPECT_EQ(list.instances.size(), 1U);
    EXPECT_EQ(at(picture, 11, 40), red);
    EXPECT_EQ(at(picture, 10, 40), Color(127, 0, 128, 255)) << "the fill goes on under the frame";
    EXPECT_EQ(at(picture, 9, 40), black);
}

TEST_F(RendererTest, ColoursAreBlendedAsTheyAreStored) {
    const Picture picture = drawn([&](Painter& p) {
        p.fill({0, 0, 10, 10}, white);
        p.fill({0, 0, 10, 10}, {0, 100, 200, 51});
    });
    EXPECT_EQ(at(picture, 5, 5), Color(204, 224, 244, 255));
}

TEST_F(RendererTest, AFractionalEdgeCoversItsShareOfThePixel) {
    const Picture picture = drawn([&](Painter& p) { p.fill({10.25F, 20, 20.5F, 10}, red); });
    EXPECT_NEAR(at(picture, 10, 25).r, 191, 1);
    EXPECT_EQ(at(picture, 11, 25), red);
    EXPECT_NEAR(at(picture, 30, 25).r, 191, 1);
    EXPECT_EQ(at(picture, 31, 25), black);
}

TEST_F(RendererTest, WhatIsThinnerThanAPixelIsPalerInstead) {
    EXPECT_NEAR(red_sum(drawn([&](Painter& p) { p.fill({10.5F, 20, 0.25F, 40}, red); })), 10, 0.2);
    EXPECT_NEAR(red_sum(drawn([&](Painter& p) { p.line({10, 40.5F}, {90, 40.5F}, 0.5F, red); })), 40.4, 0.5);
    EXPECT_NEAR(red_sum(drawn([&](Painter& p) { p.line({10, 10}, {90, 70}, 0.25F, red); })), 25.2, 0.5);
}

TEST_F(RendererTest, AreasAreRight) {
    const double pi = 3.14159265;
    const Picture disc = drawn([&](Painter& p) { p.fill({20.3F, 20.7F, 40, 40}, red, 20); });
    EXPECT_NEAR(red_sum(disc), pi * 400, 3);
    const Picture line = drawn([&](Painter& p) { p.line({20, 20}, {80, 65}, 6, red); });
    EXPECT_NEAR(red_sum(line), 75 * 6 + pi * 9, 2);
    const Picture ring = drawn([&](Painter& p) { p.frame({20, 20, 40, 40}, red, 5, 20); });
    EXPECT_NEAR(red_sum(ring), pi * (400 - 225), 3);
}

TEST_F(RendererTest, ALineOfNoLengthIsADot) {
    const Picture picture = drawn([&](Painter& p) { p.line({30, 30}, {30, 30}, 8, red); });
    EXPECT_EQ(bounds_of(picture), Rect(26, 26, 8, 8));
    EXPECT_NEAR(red_sum(picture), 50.3, 1);
}

TEST_F(RendererTest, ManyShapesLookAsTheReferenceSays) {
    std::mt19937 random(7);
    const auto between = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    const auto byte = [&] { return static_cast<std::uint8_t>(random() & 255U); };
    const auto color = [&] { return Color{byte(), byte(), byte(), byte()}; };
    for (int picture = 0; picture < 12; ++picture) {
        SCOPED_TRACE(picture);
        const auto draw = [&](Painter& p) {
            p.clear({0, 0, 70, 90}, color());
            for (int i = 0; i < 8; ++i) {
                p.push_clip({std::floor(between(0, 50)), std::floor(between(0, 40)), 50, 40});
                Rect rect{between(-20, 90), between(-20, 70), between(4, 60), between(4, 60)};
                if (i % 2 == 0) rect = {std::floor(rect.x), std::floor(rect.y), std::ceil(rect.w), std::ceil(rect.h)};
                const float radius = std::floor(between(0, 20));
                switch (random() % 6) {
                    case 0:
                        p.fill(rect, color(), radius);
                        break;
                    case 1:
                        p.frame(rect, color(), 3, radius);
                        break;
                    case 2:
                        p.line(rect.at(), {between(0, 120), between(0, 90)}, between(1, 9), color());
                        break;
                    case 3:
                        p.shadow(rect, color(), between(1, 20), radius);
                        break;
                    case 4:
                        p.fill(rect, color(), radius);
                        p.frame(rect, color(), 2, radius);
                        break;
                    default:
                        p.line(rect.at(), rect.at() + glm::vec2(15, 6), 2, color());
                }
                p.pop_clip();
            }
        };
        expect_as_reference(draw, 2);
    }
}

TEST_F(RendererTest, GradientsAndCheckersLookAsTheReferenceSays) {
    expect_as_reference(
        [](Painter& p) {
            p.gradient({5, 5, 100, 20}, red, {0, 255, 0, 40}, false);
            p.push_clip({20, 0, 30, 90});
            p.gradient({5, 30, 100, 50}, {10, 20, 30, 255}, {250, 200, 100, 255}, true);
            p.pop_clip();
            p.push_clip({57, 33, 40, 90});
            p.checker({50, 30, 60, 50}, white, {60, 70, 80, 200}, 7);
            p.pop_clip();
        },
        1);
}

// --- clips, batches, clears ---

TEST_F(RendererTest, NothingLeavesItsClip) {
    const Rect clip{31, 23, 40, 30};
    const ImageHandle image = images.add({1, 1}, std::vector<std::uint8_t>{255, 255, 255, 255});
    const std::function<void(Painter&)> drawings[] = {
        [](Painter& p) {
            p.fill({0, 0, 120, 90}, white);
        },
        [](Painter& p) {
            p.fill({-20.5F, -20.5F, 180.3F, 150.3F}, white, 9);
        },
        [](Painter& p) {
            p.line({-10, 0}, {130, 85}, 60, white);
        },
        [](Painter& p) {
            p.shadow({10, 10, 90, 70}, white, 15);
        },
        [](Painter& p) {
            p.gradient({0, 0, 120, 90}, white, white, true);
        },
        [](Painter& p) {
            p.checker({0, 0, 120, 90}, white, white, 3);
        },
        [&](Painter& p) {
            p.image({0, 0, 120, 90}, image);
        },
        [&](Painter& p) {
            p.compare({0, 0, 120, 90}, image, image, {});
        },
    };
    for (const auto& draw : drawings) {
        const Picture picture = drawn([&](Painter& p) {
            p.push_clip(clip);
            draw(p);
            p.pop_clip();
        });
        EXPECT_EQ(bounds_of(picture), clip);
        EXPECT_EQ(at(picture, 31, 23), white);
        EXPECT_EQ(at(picture, 70, 52), white);
    }
}

TEST_F(RendererTest, EachOfManyClipsIsItsOwn) {
    const Picture picture = drawn([](Painter& p) {
        for (int i = 0; i < 600; ++i) {
            p.push_clip({static_cast<float>(i % 100), static_cast<float>(i / 100) * 2, 1, 1});
            p.fill({0, 0, 120, 90}, {static_cast<std::uint8_t>(i % 251), 100, static_cast<std::uint8_t>(i / 3), 255});
            p.pop_clip();
        }
    });
    EXPECT_EQ(list.batches.size(), 3U);
    EXPECT_EQ(renderer->last().draw_calls, 3);
    for (int i = 0; i < 600; ++i) {
        EXPECT_EQ(at(picture, i % 100, i / 100 * 2),
                  Color(static_cast<std::uint8_t>(i % 251), 100, static_cast<std::uint8_t>(i / 3), 255));
        EXPECT_EQ(at(picture, i % 100, i / 100 * 2 + 1), black);
    }
}

TEST_F(RendererTest, LaterCoversEarlierWhateverTheirKinds) {
    const ImageHandle image = images.add({1, 1}, std::vector<std::uint8_t>{0, 255, 0, 255});
    const Picture picture = drawn([&](Painter& p) {
        p.fill({0, 0, 40, 40}, red);
        p.image({10, 0, 40, 40}, image);
        p.fill({20, 0, 40, 40}, blue);
        p.gradient({30, 0, 40, 40}, white, white, false);
        p.line({40, 20}, {60, 20}, 10, red);
    });
    EXPECT_EQ(at(picture, 5, 20), red);
    EXPECT_EQ(at(picture, 15, 20), green);
    EXPECT_EQ(at(picture, 25, 20), blue);
    EXPECT_EQ(at(picture, 35, 30), white);
    EXPECT_EQ(at(picture, 50, 20), red);
}

TEST_F(RendererTest, ClearsComeFirstInOrderFromTheTop) {
    const Picture picture = drawn([](Painter& p) {
        p.fill({0, 0, 5, 5}, white);
        p.clear({0, 0, 50, 20}, red);
        p.clear({40, 10, 500, 20}, blue);
        p.clear({200, 10, 50, 20}, green);
    });
    EXPECT_EQ(at(picture, 2, 2), white);
    EXPECT_EQ(at(picture, 49, 9), red);
    EXPECT_EQ(at(picture, 39, 19), red);
    EXPECT_EQ(at(picture, 40, 10), blue);
    EXPECT_EQ(at(picture, 119, 29), blue);
    EXPECT_EQ(at(picture, 119, 30), black);
    EXPECT_EQ(renderer->last().clears, 2) << "one lies outside";
}

// --- text ---

/// Expects each pixel of a glyph to have the value that `expected` gives for the ink of its texel, 0..1.
void expect_glyph(const Picture& picture, const Instance& glyph, glm::ivec2 at_px, const Atlas& atlas,
                  const std::function<double(double)>& expected) {
    int inked = 0;
    for (int y = 0; y < static_cast<int>(glyph.h); ++y) {
        for (int x = 0; x < static_cast<int>(glyph.w); ++x) {
            const std::size_t texel = static_cast<std::size_t>((glyph.uv[1] + y) * atlas.size.x + glyph.uv[0] + x);
            const double ink = atlas.pixels[texel] / 255.0;
            inked += ink > 0.1 && ink < 0.9 ? 1 : 0;
            EXPECT_NEAR(at(picture, at_px.x + x, at_px.y + y).r, expected(ink), 1.01) << x << ',' << y;
        }
    }
    EXPECT_GT(inked, 10);
}

TEST_F(RendererTest, AGlyphIsItsTexelsAndLightTextIsALittleStronger) {
    const auto& run = fonts.run("g", {.size = 40});
    const Instance glyph = run.glyphs[0];
    const glm::ivec2 place(30 + static_cast<int>(glyph.x), 50 + static_cast<int>(glyph.y));
    const Picture dark = drawn([&](Painter& p) {
        p.clear({0, 0, 120, 90}, white);
        p.run(run, {30, 50}, black);
    });
    expect_glyph(dark, glyph, place, fonts.atlas(), [](double ink) { return 255 * (1 - ink); });
    const Picture light = drawn([&](Painter& p) { p.run(run, {30, 50}, white); });
    expect_glyph(light, glyph, place, fonts.atlas(), [](double ink) { return 255 * (ink + 0.4 * ink * (1 - ink)); });
}

TEST_F(RendererTest, AGlyphIsCutByItsClipWithoutMoving) {
    const auto& run = fonts.run("H", {.size = 40});
    const Picture uncut = drawn([&](Painter& p) { p.run(run, {30, 60}, white); });
    const Picture cut = drawn([&](Painter& p) {
        p.push_clip({37, 40, 9, 9});
        p.run(run, {30, 60}, white);
        p.pop_clip();
    });
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            const bool inside = Rect(37, 40, 9, 9).contains({x, y});
            EXPECT_EQ(at(cut, x, y), inside ? at(uncut, x, y) : black) << x << ',' << y;
        }
    }
}

TEST_F(RendererTest, GlyphsThatComeLaterAreSentAndOnlyTheirRows) {
    drawn([&](Painter& p) { p.text({0, 0, 120, 20}, "abc", p.text_style(), white); });
    EXPECT_GT(renderer->last().bytes, fonts.atlas().pixels.size());
    const Picture late = drawn([&](Painter& p) { p.text({0, 0, 120, 20}, "xyz", p.text_style(), white); });
    EXPECT_LT(renderer->last().bytes, fonts.atlas().pixels.size() / 4);
    EXPECT_GT(red_sum(late), 20);
    Renderer other;  // it has to fetch the whole atlas, although nothing in it is new
    canvas->fill(black);
    other.draw(list, fonts, &images, canvas->framebuffer());
    EXPECT_EQ(cv::norm(canvas->read(), late, cv::NORM_INF), 0);
}

TEST_F(RendererTest, AnAtlasThatGrewOrWasPackedAnewIsSentWhole) {
    const auto draw = [&](Painter& p) { p.text({0, 0, 120, 90}, "Grown", p.text_style(2), white); };
    const Picture before = drawn(draw);
    const glm::ivec2 first_size = fonts.atlas().size;
    const std::uint32_t first_resets = fonts.atlas().resets;
    for (int px = 60; px < 400 && fonts.atlas().size == first_size; px += 5) {
        fonts.run("ABCDEFGHIJKLMNOPQRSTUVWXYZ", {.size = static_cast<float>(px)});
        fonts.next_frame();
    }
    ASSERT_TRUE(fonts.atlas().size != first_size || fonts.atlas().resets != first_resets);
    EXPECT_EQ(cv::norm(drawn(draw), before, cv::NORM_INF), 0);
    EXPECT_EQ(cv::norm(drawn(draw), before, cv::NORM_INF), 0);
}

// --- the renderer itself ---

TEST_F(RendererTest, TheStateThatOthersLeftDoesNotMatter) {
    const ImageHandle image = images.add({2, 2}, red_green_blue_white);
    const auto draw = [&](Painter& p) {
        p.clear({0, 0, 120, 90}, {50, 60, 70, 255});
        p.fill({10, 10, 50, 50}, {255, 0, 0, 100}, 5);
        p.text({10, 10, 100, 20}, "state", p.text_style(), white);
        p.image({60, 40, 20, 20}, image);
    };
    const Picture before = drawn(draw);
    images.update(image, {2, 2}, red_green_blue_white);
    GLuint sampler = 0;
    glCreateSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    for (GLuint unit = 0; unit < 3; ++unit) glBindSampler(unit, sampler);
    for (const GLenum on : {GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_COLOR_LOGIC_OP,
                            GL_FRAMEBUFFER_SRGB, GL_RASTERIZER_DISCARD, GL_SAMPLE_MASK, GL_CLIP_DISTANCE0}) {
        glEnable(on);
    }
    glDepthFunc(GL_NEVER);
    glStencilFunc(GL_NEVER, 0, 0);
    glCullFace(GL_FRONT_AND_BACK);
    glScissor(3, 3, 4, 4);
    glLogicOp(GL_INVERT);
    glSampleMaski(0, 0);
    glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
    glBlendFuncSeparate(GL_ZERO, GL_ONE, GL_ZERO, GL_ONE);
    glBlendEquation(GL_MAX);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    glViewport(1, 2, 3, 4);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 77);
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
    const Picture after = drawn(draw);
    EXPECT_EQ(cv::norm(after, before, cv::NORM_INF), 0);
    glDeleteSamplers(1, &sampler);
}

TEST_F(RendererTest, OneCallDrawsAFrameOfShapesAndText) {
    drawn([](Painter& p) {
        p.clear({0, 0, 120, 90}, blue);
        for (int i = 0; i < 50; ++i) {
            p.fill({0, static_cast<float>(i), 100, 10}, red, 3);
            p.text({0, static_cast<float>(i), 100, 10}, "text", p.text_style(), white);
            p.icon({100, static_cast<float>(i), 14, 14}, Icon::check, white);
        }
    });
    EXPECT_EQ(renderer->last().draw_calls, 1);
    EXPECT_EQ(renderer->last().clears, 1);
    renderer->draw(list, fonts, &images, canvas->framebuffer());
    const std::size_t instances = list.instances.size() * sizeof(Instance);
    EXPECT_GE(renderer->last().bytes, instances);
    EXPECT_LE(renderer->last().bytes, instances + 8192);
}

TEST_F(RendererTest, AnEmptyListDrawsNothing) {
    const Picture picture = drawn([](Painter&) {});
    EXPECT_EQ(red_sum(picture), 0);
    EXPECT_EQ(renderer->last().draw_calls, 0);
    list.reset({0, 0});
    renderer->draw(list, fonts, nullptr, canvas->framebuffer());
    EXPECT_EQ(renderer->last().draw_calls, 0);
}

TEST_F(RendererTest, AShaderThatDoesNotCompileIsRefusedAndTheLastStays) {
    std::string fault;
    const auto draw = [](Painter& p) { p.fill({0, 0, 10, 10}, red); };
    EXPECT_FALSE(renderer->reload("#version 450 core\nvoid main() { gl_Position = vec4(nonsense); }", "", fault));
    EXPECT_NE(fault.find("ui.vert: "), std::string::npos) << fault;
    EXPECT_NE(fault.find("nonsense"), std::string::npos) << fault;
    EXPECT_NE(fault.find("ui.frag: "), std::string::npos) << fault;
    EXPECT_EQ(at(drawn(draw), 5, 5), red);
}

TEST_F(RendererTest, AShaderThatCompilesIsUsedAtOnce) {
    std::string fault = "old";
    const auto draw = [](Painter& p) { p.fill({0, 0, 10, 10}, red); };
    const std::string vertex =
        "#version 450 core\nlayout(location = 0) uniform vec2 u_pixel;\n"
        "void main() { gl_Position = vec4(gl_VertexID & 1, gl_VertexID >> 1, 0, 0.5 + 0 * u_pixel.x) - vec4(0.25); }";
    const std::string fragment = "#version 450 core\nout vec4 o; void main() { o = vec4(0, 1, 0, 1); }";
    EXPECT_TRUE(renderer->reload(vertex, fragment, fault)) << fault;
    EXPECT_EQ(fault, "");
    while (glGetError() != GL_NO_ERROR) {
    }
    EXPECT_EQ(at(drawn(draw), 70, 30), green);
    while (glGetError() != GL_NO_ERROR) {  // the renderer sets uniforms that this shader lacks
    }
}

TEST_F(RendererTest, ASteadyFrameAllocatesNothingOfOurs) {
    const ImageHandle image = images.add({2, 2}, red_green_blue_white);
    const auto draw = [&] {
        painter.start(size);
        painter.text({0, 0, 100, 10}, "text", painter.text_style(), white);
        painter.image({0, 0, 40, 40}, image);
        painter.finish(&images);
        renderer->draw(list, fonts, &images, canvas->framebuffer());
    };
    for (int i = 0; i < 3; ++i) draw();
    const std::size_t before = lapfx::test::allocations_so_far();
    for (int i = 0; i < 10; ++i) draw();
    EXPECT_EQ(lapfx::test::allocations_so_far(), before);
}

}  // namespace
}  // namespace lapfx::ui::test
