// A line beside the pointer, for a while: what has become of what the person does in a picture.
#pragma once

#include <string>

#include "ui/core/ui.h"

namespace lapfx::panels {

struct SaidBeside {
    std::string text;
    glm::vec2 at{0};  ///< px within the picture
    double until = 0;
};

void say_beside(ui::Ui& ui, SaidBeside& said, std::string_view text, glm::vec2 at);
/// Builds it over the picture of this size, as long as it is said.
void put_said(ui::Ui& ui, const SaidBeside& said, glm::vec2 picture);
/// The same, in the lower left corner of the picture.
void put_in_corner(ui::Ui& ui, std::string_view label, std::string_view text);

}  // namespace lapfx::panels
