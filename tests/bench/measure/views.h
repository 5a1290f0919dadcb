// The scenes of `lapfx bench measure`, drawn at random: several organs, lights and cameras, each with a label, so that
// one of them can be left out.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/measure/random.h"
#include "lapfx/authoring/preview.h"

namespace lapfx::bench {

/// What may happen in a view: a share of the views has no blood, and another no smoke.
struct Happening {
    bool blood = true, smoke = true;
};

struct DrawnView {
    Scene scene;  ///< without events
    Preset preset;
    Happening happens;
    std::map<std::string, std::string> labels;  ///< organ, light, camera
};

DrawnView draw_view(Random& random);

/// Cuts that bleed and burns that smoke, where the tissue is seen at `size`. In half of the clips an instrument that
/// does nothing moves through the view all the time: its strokes have neither power nor strength.
std::vector<ToolContact> draw_touches(Random& random, const Preview& preview, const Happening& happens, glm::ivec2 size,
                                      bool clip);

/// Organs that were prepared once: views of the same file whose presets look for the same vessels share one.
class PreparedViews {
  public:
    std::shared_ptr<const PreparedOrgan> of(const DrawnView& view);

  private:
    struct Prepared {
        std::string file;
        VesselParameters vessels;
        std::shared_ptr<const PreparedOrgan> organ;
    };
    std::vector<Prepared> prepared_;
};

}  // namespace lapfx::bench
