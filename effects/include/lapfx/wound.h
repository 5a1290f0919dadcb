// A place that bleeds. Plain data; closed form in time.
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace lapfx {

struct Wound {
    glm::dvec3 position{0.0};                               ///< mm, organ space, rest shape, on or near the surface
    double start = 0.0;                                     ///< s
    double strength = 1.0;                                  ///< factor on the preset's speed
    double stop = std::numeric_limits<double>::infinity();  ///< s, when coagulation begins
    double sealed =
        std::numeric_limits<double>::infinity();  ///< s, when a clip ends its flow at once; `stop` is not later

    friend bool operator==(const Wound&, const Wound&) = default;
};

/// What a wound is doing at a time.
enum class WoundState {
    waiting,   ///< not open yet
    bleeding,  ///< open: its blood spreads, or fills again what suction or irrigation has cleared, or stands still
               ///< while the bleeding strength is 0 (curves.h)
    spent,  ///< open, but its blood has reached max_extent everywhere: it does not spread any more and does not count
            ///< as bleeding
    clotting,  ///< coagulated: the flow dies down
    closed,    ///< coagulated, its flow has ended
};

/// The state of a wound at a time.
struct WoundStatus {
    Wound wound;
    WoundState state = WoundState::waiting;
    double extent = 0.0;  ///< mm, how far its blood has travelled
    bool bleeds =
        false;  ///< its blood spreads or fills again now, perhaps while it clots; bleeding_wounds counts these
};

}  // namespace lapfx
