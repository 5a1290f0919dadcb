// Colours that were picked become those of fields: the picture is to show what was picked, so each is solved for
// (solve_color.h) in the picture that was clicked, and a notice says where and how near it comes. Where smoke over that
// place keeps the colour from being seen, it is solved for without smoke.
//
//     seen.clicked({.shot = shot, .size = size, .place = place});   // a panel with a picture
//     color = seen.solve("Deep colour", picked, color, put);        // the field, a frame later
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "app/base/notices.h"
#include "app/preview/preview_host.h"
#include "app/preview/solve_color.h"

namespace lapfx::app {

class SeenColors {
  public:
    /// Both must outlive it.
    SeenColors(PreviewHost& preview, Notices& notices) : preview_(preview), notices_(notices) {}

    /// The picture of the scene that has to show the colour.
    struct Picture {
        Shot shot;
        glm::ivec2 size{0};
        glm::dvec2 place{0.5};  ///< that was clicked, shares of it from its upper left corner
    };
    void clicked(const Picture& picture) { picture_ = picture; }

    /// The colour (sRGB, 0..1) for the field that `put` writes; as it was picked where no picture shows that field.
    glm::dvec3 solve(std::string_view name, const glm::dvec3& picked, const glm::dvec3& now,
                     const std::function<void(document::Content&, const glm::dvec3&)>& put);

    /// What the last solve() found.
    const SolvedColor& last() const { return last_; }
    /// The smoke that it left out because it lies over that place: "haze", "a plume", "haze and a plume"; else empty.
    const std::string& veil() const { return veil_; }

  private:
    using Put = std::function<void(document::Content&, const glm::dvec3&)>;
    bool plume_over(const SolvedColor& solved, const Shot& shot, glm::ivec2 size, const Put& put);

    PreviewHost& preview_;
    Notices& notices_;
    std::optional<Picture> picture_;
    SolvedColor last_;
    std::string veil_;
};

}  // namespace lapfx::app
