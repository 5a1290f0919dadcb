// A fixture with the sample scene and its reference, in windows of several sizes and scales.
#pragma once

#include "app/reference/reference.h"
#include "editor/support/editor_test.h"

namespace lapfx::test {

struct Shape {
    float scale;
    glm::ivec2 size;
};

class ShapedTest : public EditorTest {
  protected:
    void SetUp() override {
        EditorTest::SetUp();
        if (IsSkipped()) return;
        open_sample();
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
