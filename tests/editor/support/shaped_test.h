// A fixture with the sample scene and its reference, in windows of several sizes and scales.
#pragma once

#include "app/reference/reference.h"
#include "editor/support/editor_test.h"

namespace lapfx::test {

struct Shape {
    float scale;
    glm::ivec2 size;
};

class ShapedTest : public SampleTest {
  protected:
    ShapedTest() { scene_scale = 0.02; }  // windows are large, and nobody looks at the scene in them
    void SetUp() override {
        SampleTest::SetUp();
        if (IsSkipped()) return;
        editor().reference().choose_sample();
        ui().frame().frame();
    }
    void shape(const Shape& to) {
        ui().scale = to.scale;
        ui().size = to.size;
        ui().frame().frame().frame();
    }
};

}  // namespace lapfx::test
