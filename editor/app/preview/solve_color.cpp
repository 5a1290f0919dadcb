#include "app/preview/solve_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/color_space.hpp>
#include <iterator>
#include <vector>

#include "app/preview/pick_color.h"
#include "match/compare/region.h"

namespace lapfx::app {

namespace {

constexpr int most_tries = 5;
constexpr double good = 0.8;           // Delta E at which no better one is looked for
constexpr double least_gain = 0.004;   // light that a field of full light adds: less is nothing
constexpr double lit_share = 0.25;     // of the strongest gain, from which a place is lit well
constexpr double pure_share = 0.93;    // of the largest share of the light, from which a place is typical of the field
constexpr double pointed_share = 0.2;  // of the strongest gain, from which the place that was pointed at will do
constexpr double as_near = 2;          // Delta E, less than an eye tells apart (2.3: Mahy and others, 1994)
constexpr double clipped = 0.96;       // light from which a channel says nothing

/// What the camera's curve does, taken back: light that is a straight line over the field's.
glm::dvec3 before_curve(const glm::dvec3& shown, const CameraResponse& response) {
    return {light_shown_as(shown.x, response), light_shown_as(shown.y, response), light_shown_as(shown.z, response)};
}

glm::dvec3 to_light(const glm::dvec3& color) {
    return glm::convertSRGBToLinear(color);
}
glm::dvec3 in_codes(const glm::dvec3& color) {
    return glm::round(glm::clamp(color, 0.0, 1.0) * 255.0) / 255.0;
}
double apart(const glm::dvec3& a, const glm::dvec3& b) {
    return match::distance({.color = a}, {.color = b});
}

/// The light of a picture, averaged over what the eyedropper averages.
class Lights {
  public:
    explicit Lights(const Image& image) : size_(image.width, image.height) {
        std::array<double, 256> light{};
        for (int i = 0; i < 256; ++i) light[static_cast<std::size_t>(i)] = to_light(glm::dvec3(i / 255.0)).x;
        lights_.resize(static_cast<std::size_t>(std::max(0, size_.x)) * static_cast<std::size_t>(std::max(0, size_.y)));
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            const std::uint8_t* const p = image.pixels.data() + 4 * i;
            lights_[i] = {light[p[0]], light[p[1]], light[p[2]]};
        }
    }
    glm::ivec2 size() const { return size_; }
    const glm::dvec3& at(glm::ivec2 p) const {
        return lights_[static_cast<std::size_t>(p.y) * static_cast<std::size_t>(size_.x) +
                       static_cast<std::size_t>(p.x)];
    }
    template <typename Look>
    void around(glm::ivec2 place, const Look& look) const {
        const glm::ivec2 low = glm::max(place - picked_side / 2, glm::ivec2(0)),
                         high = glm::min(place + picked_side / 2, size_ - 1);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) look(at({x, y}));
    }
    glm::dvec3 mean(glm::ivec2 place) const {
        glm::dvec3 sum(0);
        int count = 0;
        around(place, [&](const glm::dvec3& light) { sum += light, ++count; });
        return count == 0 ? sum : sum / static_cast<double>(count);
    }

  private:
    glm::ivec2 size_;
    std::vector<glm::dvec3> lights_;
};

struct Spot {
    glm::ivec2 at{0};
    double gain = 0;   ///< light for light of the field
    double share = 0;  ///< of its light that may come from the field; does not depend on how well it is lit
    glm::dvec3 light{0};
    double rough = 0;  ///< how much its pixels differ, of its light
};

/// The value that 2 % of the spots are above.
template <typename Value>
double nearly_most(const std::vector<Spot>& spots, const Value& value) {
    std::vector<double> values;
    for (const Spot& spot : spots) values.push_back(value(spot));
    const auto high = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * 98 / 100);
    std::nth_element(values.begin(), high, values.end());
    return *high;
}

/// Where the field acts, from two pictures with different colours of it.
class Acting {
  public:
    Acting(const Lights& one, const Lights& other, double by) : one_(one), other_(other), by_(by) {
        const glm::ivec2 size = one.size();
        const int step = std::max(1, size.y / 160);
        for (int y = picked_side / 2; y < size.y - picked_side / 2; y += step)
            for (int x = picked_side / 2; x < size.x - picked_side / 2; x += step)
                if (const Spot spot = spot_at({x, y}); spot.gain >= least_gain) spots_.push_back(spot);
        if (spots_.empty()) return;
        most_ = nearly_most(spots_, [](const Spot& spot) { return spot.gain; });
    }
    bool any() const { return !spots_.empty(); }
    double most() const { return most_; }

    Spot spot_at(glm::ivec2 at) const {
        Spot spot{.at = at, .light = one_.mean(at)};
        const glm::dvec3 other = other_.mean(at);
        const double differ = glm::dot(glm::abs(other - spot.light), glm::dvec3(1));
        spot.gain = differ / (3 * by_);
        spot.share = differ / (glm::dot(glm::max(other, spot.light), glm::dvec3(1)) + 1e-6);
        glm::dvec3 most(0);
        one_.around(at, [&](const glm::dvec3& light) {
            spot.rough = std::max(spot.rough, glm::length(light - spot.light));
            most = glm::max(most, light);
        });
        spot.rough /= glm::length(spot.light) + 0.01;
        if (std::max({most.x, most.y, most.z}) >= clipped) spot.gain = 0;  // a highlight
        return spot;
    }

    /// A place that is even and lit as most of those are where the field acts.
    Spot typical() const {
        std::vector<Spot> strong;
        std::ranges::copy_if(spots_, std::back_inserter(strong),
                             [&](const Spot& spot) { return spot.gain >= lit_share * most_; });
        if (strong.empty()) return spots_.front();
        const double purest = nearly_most(strong, [](const Spot& spot) { return spot.share; });
        std::erase_if(strong, [&](const Spot& spot) { return spot.share < pure_share * purest; });
        glm::dvec3 middle(0);
        for (int c = 0; c < 3; ++c) {
            const auto half = strong.begin() + static_cast<std::ptrdiff_t>(strong.size() / 2);
            std::nth_element(strong.begin(), half, strong.end(),
                             [c](const Spot& a, const Spot& b) { return a.light[c] < b.light[c]; });
            middle[c] = half->light[c];
        }
        const auto cost = [&](const Spot& spot) {
            return glm::length(spot.light - middle) / (glm::length(middle) + 0.01) + spot.rough;
        };
        return *std::ranges::min_element(strong, {}, cost);
    }

  private:
    const Lights &one_, &other_;
    double by_;
    std::vector<Spot> spots_;
    double most_ = 0;
};

struct Tried {
    glm::dvec3 field{0}, light{0};  ///< both linear; the light before the curve
};

/// The next field of a channel: the line through the two tries that are nearest to what is wanted.
double next_of(const std::vector<Tried>& tried, int c, double wanted) {
    std::vector<Tried> by = tried;
    std::ranges::sort(by, {}, [&](const Tried& t) { return std::abs(t.light[c] - wanted); });
    const Tried& best = by.front();
    for (std::size_t i = 1; i < by.size(); ++i) {
        const double over = by[i].field[c] - best.field[c], rise = by[i].light[c] - best.light[c];
        if (std::abs(over) < 1e-6 || rise / over < 1e-5) continue;
        return std::clamp(best.field[c] + (wanted - best.light[c]) * over / rise, 0.0, 1.0);
    }
    return best.field[c];
}

/// Where a colour cannot be reached, the nearest may be an extreme one, such as black, that helps little. One nearer to
/// what was picked is taken if it comes as near to the eye.
SolvedColor nearer_to_picked(const SolvedColor& best, const glm::dvec3& picked,
                             const std::function<glm::dvec3(const glm::dvec3&)>& seen_with) {
    for (const double share : {0.0, 0.25, 0.5, 0.75}) {
        SolvedColor tried = best;
        tried.color = in_codes(glm::mix(picked, best.color, share));
        tried.seen = seen_with(tried.color);
        tried.off = apart(tried.seen, picked);
        if (tried.off <= best.off + as_near) return tried;
    }
    return best;
}

}  // namespace

SolvedColor solve_color(const glm::dvec3& picked, const glm::dvec3& now, const std::optional<glm::dvec2>& place,
                        const std::function<Image(const glm::dvec3&)>& draw, const CameraResponse& response) {
    const glm::dvec3 first_color = in_codes(now);
    // Far enough from it to be seen everywhere, and not so bright that the curve hides how much it does.
    const bool bright = std::max({first_color.x, first_color.y, first_color.z}) > 0.6;
    const glm::dvec3 second_color = in_codes(bright ? 0.4 * first_color : glm::dvec3(0.75));
    const Lights first(draw(first_color)), second(draw(second_color));
    const double by = glm::dot(glm::abs(to_light(second_color) - to_light(first_color)), glm::dvec3(1)) / 3;
    SolvedColor none{.color = picked, .picked = picked, .seen = picked};
    if (first.size() != second.size() || first.size().x < picked_side || first.size().y < picked_side) return none;
    const Acting acting(first, second, by);
    if (!acting.any()) return none;

    const glm::dvec3 wanted = before_curve(to_light(picked), response);
    const auto seen_at = [&](glm::ivec2 at) {
        return [&draw, at](const glm::dvec3& color) { return glm::convertLinearToSRGB(Lights(draw(color)).mean(at)); };
    };
    const auto solve_at = [&](glm::ivec2 at) {
        SolvedColor best{.color = first_color, .acts = true, .picked = picked, .off = 1e9};
        best.place = (glm::dvec2(at) + 0.5) / glm::dvec2(first.size());
        std::vector<Tried> tried;
        const auto take = [&](const glm::dvec3& color, const Lights& lights) {
            const glm::dvec3 light = lights.mean(at), seen = glm::convertLinearToSRGB(light);
            tried.push_back({to_light(color), before_curve(light, response)});
            if (const double off = apart(seen, picked); off < best.off)
                best.color = color, best.seen = seen, best.off = off;
        };
        take(first_color, first);
        take(second_color, second);
        std::vector<glm::dvec3> drawn{first_color, second_color};
        for (int i = 0; i < most_tries && best.off > good; ++i) {
            glm::dvec3 field;
            for (int c = 0; c < 3; ++c) field[c] = next_of(tried, c, wanted[c]);
            const glm::dvec3 color = in_codes(glm::convertLinearToSRGB(field));
            if (std::ranges::find(drawn, color) != drawn.end()) break;
            drawn.push_back(color);
            take(color, Lights(draw(color)));
        }
        return best.off > reached_color ? nearer_to_picked(best, picked, seen_at(at)) : best;
    };

    std::optional<SolvedColor> pointed;
    if (place) {
        const glm::ivec2 at = glm::clamp(glm::ivec2(*place * glm::dvec2(first.size())), glm::ivec2(picked_side / 2),
                                         first.size() - 1 - picked_side / 2);
        if (acting.spot_at(at).gain >= pointed_share * acting.most()) pointed = solve_at(at);
        if (pointed && pointed->off <= reached_color) return *pointed;
    }
    const SolvedColor typical = solve_at(acting.typical().at);
    return pointed && pointed->off <= typical.off ? *pointed : typical;
}

}  // namespace lapfx::app
