// Contacts and surfaces for the tests of heat.
#pragma once

#include <initializer_list>
#include <vector>

#include "cautery/cautery.h"
#include "support/contacts.h"
#include "support/logged.h"
#include "support/meshes.h"

namespace lapfx::cautery {

using LoggedCautery = test::Logged<Cautery>;

/// 200 degrees/s, cut at 177 (0.7 s), coagulate at 57 (0.1 s).
inline CauteryParameters simple_parameters() {
    CauteryParameters c;
    c.heat_rate = 200.0;
    c.tip_radius = 1.5;
    c.cut_temperature = 177.0;
    c.coagulation_temperature = 57.0;
    c.char_temperature = 137.0;
    c.heat_spread = 2.0;
    c.cooling_time = 2.0;
    c.maximum_temperature = 400.0;
    return c;
}

inline ToolContact at(glm::dvec3 place, double time, double duration, ToolAction action = ToolAction::cauterise) {
    return test::contact(action, time, duration, place);
}

inline ToolContact along(glm::dvec3 from, glm::dvec3 to, double time, double duration,
                         ToolAction action = ToolAction::cauterise) {
    return test::contact(action, time, duration, from, to);
}

/// The same path as `pieces` contacts that continue each other.
inline std::vector<ToolContact> in_pieces(const ToolContact& whole, int pieces) {
    std::vector<ToolContact> out;
    for (int i = 0; i < pieces; ++i) {
        ToolContact piece = whole;
        piece.time = i == 0 ? whole.time : out.back().end();
        piece.duration = whole.time + whole.duration * (i + 1) / pieces - piece.time;
        piece.position = i == 0 ? whole.position : out.back().to;
        piece.to = whole.tip(piece.end());
        out.push_back(piece);
    }
    return out;
}

/// A plane, 80 mm wide, of triangles 1 mm wide: y = 0.
inline const Surface& flat() {
    static const Surface surface(test::plane(80.0, 80));
    return surface;
}

}  // namespace lapfx::cautery
