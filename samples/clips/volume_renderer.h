// Draws a density field as the camera would see it: single scattering with soft self-shadowing, orthographic
// along z.
//
// Values are display-referred: colour and alpha are what a keyer finds in 8-bit code values, not linear
// light.
#pragma once

#include <vector>

#include "field.h"

namespace clips {

/// Premultiplied grey and alpha, 0 to 1, rows from the top.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<float> value;
    std::vector<float> alpha;

    Picture() = default;
    Picture(int w, int h) : width(w), height(h), value(std::size_t(w) * h), alpha(value.size()) {}
};

struct LightSettings {
    float extinction = 1.0f;       ///< optical depth per cell and unit of density
    float shadow = 1.0f;           ///< extinction towards the light, relative to that towards the eye
    glm::vec2 slant{-0.5f, 0.6f};  ///< direction of the light: x and y per unit of z towards the camera
    float direct = 0.85f;          ///< brightness of smoke in full light
    float ambient = 0.2f;          ///< brightness in full shadow
};

/// The part of the box in the picture, and how it fades towards its borders.
struct ViewSettings {
    glm::vec2 centre{0.0f};    ///< cells
    float height = 1.0f;       ///< cells over the picture's height
    glm::vec4 fade{0.0f};      ///< left, right, top, bottom: widths in cells inside `fade_box`
    glm::vec4 fade_box{0.0f};  ///< left, right, top, bottom in cells; alpha is 0 there and beyond
    bool fades = false;
};

class VolumeRenderer {
  public:
    VolumeRenderer(const Field& lattice, LightSettings light, ViewSettings view, int width, int height);

    Picture draw(const Field& density);

  private:
    void sweep(const Field& density);
    void shift_shadow();
    float border(glm::vec2 position) const;

    LightSettings light_;
    ViewSettings view_;
    int width_, height_;
    int nx_, ny_;
    float spacing_;
    std::vector<float> shadow_, next_, value_, clear_;
};

}  // namespace clips
