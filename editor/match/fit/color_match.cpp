#include "match/fit/color_match.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <glm/gtc/color_space.hpp>
#include <limits>

#include "match/compare/joined.h"

namespace lapfx::match {

namespace {

constexpr std::size_t most_times = 12;  // that are drawn for one measuring
// Below, what is taken for blood or smoke of the video may be an error of measuring, whose colour is the tissue's. The
// interval of blood begins at 0 behind thin smoke, too, so much of it counts all the same.
constexpr double least_blood = 0.01, much_blood = 0.05, least_veil = 0.1;
constexpr double least_blood_drawn = 0.005, least_veil_drawn = 0.05;  // of the scene, which has no such errors
constexpr double darkest = 0.004, brightest = 0.8;                    // mean light that tells an exposure
constexpr double clipped = 0.96;                                      // light from which a channel says nothing
constexpr double least_light = 1e-4;                                  // that is measured
constexpr double least_field = 6e-4;  // light of 2 code values, from which a colour can grow
// On a colour's light: blood has little green, which the tissue's own hides. Down, it soon makes no difference.
constexpr double least_factor = 1.0 / 6.0, most_factor = 20.0;
constexpr double least_step = 0.02;  // of what was given: nearer tries tell no slope
// Tissue shines through blood, in green and blue more than blood itself. Light of smoke is all its own, but is measured
// in steps, between which it seems not to change.
constexpr double through_blood = 0.1, through_smoke = 0.7, through_exposure = 0.5;
constexpr double through_tissue = 0.2;     // the lamp is mirrored in it, of which a dark channel has little else
constexpr double least_organ = 0.02;       // light of a channel of the organ's colour
constexpr double most_slope = 1.5;         // of a line over that through the origin
constexpr double light_weight = 25.0;      // Delta E for a factor of e in brightness
constexpr double good = 1.0, plain = 5.0;  // Delta E: cannot be seen, is worth a word
constexpr double light_tolerance = 0.1;    // of a logarithm

const std::string exposure_key = "camera.exposure", organ_key = "organ.color";

/// A colour of the preset that is changed in the light of one of the measured colours.
struct Field {
    std::string key;
    std::optional<glm::dvec3> MeasuredColors::*seen;
    glm::dvec3& (*of)(Preset&);
};
using FieldColors = std::array<glm::dvec3, 4>;
const std::array<Field, 4>& fields() {
    static const std::array<Field, 4> all = {{
        {"bleeding.color_thin", &MeasuredColors::blood, [](Preset& p) -> glm::dvec3& { return p.bleeding.color_thin; }},
        {"bleeding.color_deep", &MeasuredColors::blood, [](Preset& p) -> glm::dvec3& { return p.bleeding.color_deep; }},
        {"smoke.haze.color", &MeasuredColors::smoke, [](Preset& p) -> glm::dvec3& { return p.smoke.haze.color; }},
        {"smoke.plume.color", &MeasuredColors::smoke, [](Preset& p) -> glm::dvec3& { return p.smoke.plume.color; }},
    }};
    return all;
}

FieldColors colors_of(Preset preset) {
    FieldColors colors;
    for (std::size_t k = 0; k < colors.size(); ++k) colors[k] = fields()[k].of(preset);
    return colors;
}

template <typename... Values>
std::string text(const char* format, Values... values) {
    char made[160];
    std::snprintf(made, sizeof made, format, values...);
    return made;
}

std::string hex(const glm::dvec3& color) {
    const glm::ivec3 code(glm::round(255.0 * color));
    return text("#%02x%02x%02x", code.r, code.g, code.b);
}

bool finite(const glm::dvec3& color) {
    return std::isfinite(color.r) && std::isfinite(color.g) && std::isfinite(color.b);
}

double largest(const glm::dvec3& color) {
    return std::max({color.r, color.g, color.b});
}

std::optional<double> tissue_light(const MeasuredColors& colors) {
    if (!colors.tissue || !finite(*colors.tissue)) return {};
    return light_of(*colors.tissue);
}

bool tells_exposure(const MeasuredColors& colors) {
    const std::optional<double> light = tissue_light(colors);
    return light && *light >= darkest && *light <= brightest;
}

std::optional<double> relative_light(const MeasuredColors& shown, const MeasuredColors& reference) {
    if (!tells_exposure(shown) || !tells_exposure(reference)) return {};
    return *tissue_light(shown) / *tissue_light(reference);
}

/// In whole code values, as an editor shows it.
glm::dvec3 scaled(const glm::dvec3& color, const glm::dvec3& factor) {
    if (factor == glm::dvec3(1.0)) return color;
    const glm::dvec3 light = glm::max(glm::convertSRGBToLinear(color), glm::dvec3(least_field)) * factor;
    return glm::round(glm::convertLinearToSRGB(glm::clamp(light, 0.0, 1.0)) * 255.0) / 255.0;
}

/// One measured colour that can be corrected.
struct MatchedColor {
    const char* name;  ///< "blood"
    std::optional<glm::dvec3> MeasuredColors::*seen;
    std::optional<double> ColorLikeness::*off;
    Amount ColorsAtPeak::*amount;
    double least, much, least_drawn;
    double least_slope;  ///< how much of what is seen the colour makes, at least
};
constexpr std::array<MatchedColor, 2> parts = {{
    {"blood", &MeasuredColors::blood, &ColorLikeness::blood, &ColorsAtPeak::blood, least_blood, much_blood,
     least_blood_drawn, through_blood},
    {"smoke", &MeasuredColors::smoke, &ColorLikeness::smoke, &ColorsAtPeak::veil, least_veil, 1.0, least_veil_drawn,
     through_smoke},
}};

/// What was drawn: the factor on each part's colours, and what was seen.
struct TriedColors {
    double exposure = 1.0;
    glm::dvec3 organ{1.0};  ///< its colour
    std::array<glm::dvec3, parts.size()> factor = {glm::dvec3(1.0), glm::dvec3(1.0)};
    FieldColors colors = {};
    MeasuredColors seen = {};
};

/// The next of what gives `wanted` for what was given: along the line through the nearest try and one beyond, or else
/// the next nearest, that is as steep as light can be; of one try, in proportion. `least_slope`: of the line, over that
/// through the origin.
double next_of(std::vector<glm::dvec2> given_and_seen, double wanted, double least_slope) {
    for (glm::dvec2& pair : given_and_seen) pair = glm::max(pair, glm::dvec2(least_light));
    std::ranges::stable_sort(given_and_seen, {}, [&](const glm::dvec2& pair) { return std::abs(pair.y - wanted); });
    const glm::dvec2 best = given_and_seen.front();
    std::erase_if(given_and_seen,
                  [&](const glm::dvec2& pair) { return std::abs(pair.x - best.x) < least_step * best.x; });
    const auto beyond = [&](const glm::dvec2& pair) { return (pair.y < wanted) != (best.y < wanted); };
    const auto nearer = [&](const glm::dvec2& a, const glm::dvec2& b) {
        if (beyond(a) != beyond(b)) return beyond(a);
        return beyond(a) && std::abs(a.x - best.x) < std::abs(b.x - best.x);
    };
    std::ranges::stable_sort(given_and_seen, nearer);
    const double proportion = best.y / best.x;
    double slope = proportion;
    if (!given_and_seen.empty()) {
        const glm::dvec2& other = given_and_seen.front();
        slope = std::clamp((other.y - best.y) / (other.x - best.x), least_slope * proportion, most_slope * proportion);
    }
    return best.x + (wanted - best.y) / slope;
}

class Matching {
  public:
    explicit Matching(const ColorMatchInput& input)
        : input_(input), result_{.start = input.begun ? input.begun->start : input.start, .tuned = input.start} {
        if (is_free(exposure_key))
            exposure_ = free_parameters(input.start, std::vector<std::string>{exposure_key}).front();
    }

    ColorMatch run() {
        TriedColors first{.organ = input_.start.scene.organ.color, .colors = start_};
        if (exposure_) first.exposure = exposure_->get(input_.start);
        if (!draw(std::move(first))) return std::move(result_);
        decide();
        for (int round = 0; round < input_.rounds && (moves_exposure_ || moves_[0] || moves_[1]); ++round) {
            if (is_good(best())) break;
            std::optional<TriedColors> next = corrected();
            if (!next || !draw(std::move(*next))) break;
        }
        if ((moves_[0] || moves_[1]) && !result_.ended_early && !is_good(best()))
            if (std::optional<TriedColors> next = joined_best()) draw(std::move(*next));
        finish();
        return std::move(result_);
    }

  private:
    bool is_free(const std::string& key) const { return std::ranges::find(input_.keys, key) != input_.keys.end(); }
    std::vector<std::string> free_fields(const MatchedColor& part) const {
        std::vector<std::string> keys;
        for (const Field& field : fields())
            if (field.seen == part.seen && is_free(field.key)) keys.push_back(field.key);
        return keys;
    }
    void say(std::string line) { result_.lines.push_back(std::move(line)); }

    document::Content tuned_of(const TriedColors& tried) const {
        document::Content tuned = input_.start;
        if (exposure_) exposure_->set(tuned, tried.exposure);
        tuned.scene.organ.color = tried.organ;
        for (std::size_t k = 0; k < start_.size(); ++k) fields()[k].of(tuned.preset) = tried.colors[k];
        return tuned;
    }
    bool draw(TriedColors next) {
        const std::optional<ColorsAtPeak> drawn = input_.draw(tuned_of(next));
        result_.ended_early = !drawn;
        if (!drawn) return false;
        ++result_.drawn;
        if (tried_.empty()) first_ = *drawn;
        next.seen = drawn->colors;
        tried_.push_back(std::move(next));
        return true;
    }

    /// What is corrected; says what is not, and why.
    void decide() {
        decide_exposure();
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const std::vector<std::string> keys = free_fields(parts[i]);
            if (keys.empty()) continue;
            const std::string why = why_untold(parts[i]);
            moves_[i] = why.empty();
            if (moves_[i] && !by_channel(i))
                say(joined(keys) + (keys.size() > 1 ? ": keep their tint, " : ": keeps its tint, ") +
                    "the video does not tell that of its smoke; only how bright it is was matched");
            if (!why.empty()) say(joined(keys) + (keys.size() > 1 ? ": stay, " : ": stays, ") + why);
        }
    }
    void decide_exposure() {
        const std::optional<double> light = relative_light(first_.colors, input_.reference.colors);
        if (!exposure_) {
            if (light && std::abs(std::log(*light)) > light_tolerance)
                say(exposure_key + ": is not free; the tissue of the video is " + text("%.2f", 1.0 / *light) +
                    " times as bright as that of the scene");
            return;
        }
        if (input_.start.scene.plate.use)
            say(exposure_key + ": stays, the tissue is the plate, which is shown as it is");
        else if (!tissue_light(input_.reference.colors) || !tissue_light(first_.colors))
            say(exposure_key + ": stays, no tissue is measurable in both");
        else if (!light)
            say(exposure_key + ": stays, the " + (tells_exposure(first_.colors) ? "video" : "scene") +
                " is too dark or too bright to tell it");
        else
            moves_exposure_ = true;
        moves_organ_ = moves_exposure_ && is_free(organ_key);
    }
    std::string why_untold(const MatchedColor& part) const {
        const auto no_color = [&](const ColorsAtPeak& at) {
            const std::optional<glm::dvec3>& color = at.colors.*part.seen;
            return !color || !finite(*color);
        };
        const Amount &there = input_.reference.*part.amount, &here = first_.*part.amount;
        const std::string name = part.name;
        if (no_color(input_.reference) || there.value < part.least || (there.low <= 0.0 && there.value < part.much))
            return "the video shows too little " + name + " to tell its colour";
        if (no_color(first_) || here.value < part.least_drawn)
            return "the scene shows too little " + name + " to compare its colour";
        const glm::dvec3& color = *(input_.reference.colors.*part.seen);
        if (largest(color) >= clipped) return "the video shows its " + name + " overexposed";
        return {};
    }

    ColorLikeness off(const TriedColors& tried) const { return likeness_of(tried.seen, input_.reference.colors); }
    double light_off(const TriedColors& tried) const {
        if (!moves_exposure_) return 0.0;
        if (moves_organ_) return off(tried).tissue.value_or(lost);
        const std::optional<double> light = relative_light(tried.seen, input_.reference.colors);
        return light ? light_weight * std::abs(std::log(*light)) : lost;
    }
    bool tinted() const { return input_.reference.colors.tinted && first_.colors.tinted; }
    /// Else only how bright it is.
    bool by_channel(std::size_t i) const { return parts[i].seen != &MeasuredColors::smoke || tinted(); }
    /// Of a part that is not seen any more: as far as can be.
    double part_off(const TriedColors& tried, std::size_t i) const {
        if (!moves_[i]) return 0.0;
        return (off(tried).*parts[i].off).value_or(lost);
    }
    double cost(const TriedColors& tried) const { return light_off(tried) + part_off(tried, 0) + part_off(tried, 1); }
    bool is_good(const TriedColors& tried) const {
        return light_off(tried) < good && part_off(tried, 0) < good && part_off(tried, 1) < good;
    }
    const TriedColors& best() const {
        return *std::ranges::min_element(tried_, {}, [&](const TriedColors& tried) { return cost(tried); });
    }

    /// What is seen of blood depends on the smoke before it, too: what was tried long ago says little.
    std::span<const TriedColors> latest() const {
        constexpr std::size_t most = 3;
        return std::span(tried_).last(std::min(tried_.size(), most));
    }
    /// What is seen grows with the exposure, so the factors on colours go by what is seen for an exposure of 1.
    double wanted_factor(std::size_t i, int channel, double exposure) const {
        const auto light = [&](const glm::dvec3& color) { return by_channel(i) ? color[channel] : light_of(color); };
        std::vector<glm::dvec2> pairs;
        for (const TriedColors& tried : latest())
            if (const std::optional<glm::dvec3>& color = tried.seen.*parts[i].seen)
                pairs.emplace_back(tried.factor[i][channel], light(*color) / tried.exposure);
        if (pairs.empty()) return 1.0;
        const double wanted = light(*(input_.reference.colors.*parts[i].seen)) / exposure;
        return std::clamp(next_of(std::move(pairs), wanted, parts[i].least_slope), least_factor, most_factor);
    }
    double wanted_exposure() const {
        std::vector<glm::dvec2> pairs;
        for (const TriedColors& tried : tried_)
            if (const std::optional<double> light = tissue_light(tried.seen); light && *light > 0.0)
                pairs.emplace_back(tried.exposure, *light);
        return next_of(std::move(pairs), *tissue_light(input_.reference.colors), through_exposure);
    }
    /// Light of the tissue for one of its texture and an exposure of 1.
    glm::dvec3 wanted_tissue() const {
        glm::dvec3 wanted;
        for (int c = 0; c < 3; ++c) {
            std::vector<glm::dvec2> pairs;
            for (const TriedColors& tried : tried_)
                if (const std::optional<glm::dvec3>& color = tried.seen.tissue; color && finite(*color))
                    pairs.emplace_back(tried.exposure * std::max(glm::convertSRGBToLinear(tried.organ)[c], least_organ),
                                       (*color)[c]);
            wanted[c] = next_of(std::move(pairs), (*input_.reference.colors.tissue)[c], through_tissue);
        }
        return glm::max(wanted, glm::dvec3(0.0));
    }
    double rounded_exposure(double exposure) const {
        return std::clamp(std::round(100.0 * exposure) / 100.0, exposure_->minimum, exposure_->maximum);
    }
    /// The organ's colour keeps how light it is; the exposure takes the rest.
    void correct_tissue(TriedColors& next) const {
        if (!moves_organ_) {
            next.exposure = rounded_exposure(wanted_exposure());
            return;
        }
        const glm::dvec3 wanted = wanted_tissue(), before = glm::convertSRGBToLinear(input_.start.scene.organ.color);
        next.exposure = rounded_exposure(largest(wanted) / std::max(largest(before), least_organ));
        const glm::dvec3 organ = glm::clamp(wanted / next.exposure, least_organ, 1.0);
        next.organ = glm::round(glm::convertLinearToSRGB(organ) * 255.0) / 255.0;
    }
    std::optional<TriedColors> corrected() const {
        TriedColors next{.exposure = best().exposure, .organ = best().organ, .colors = start_};
        if (moves_exposure_) correct_tissue(next);
        for (std::size_t i = 0; i < parts.size(); ++i)
            for (int c = 0; moves_[i] && c < 3; ++c) next.factor[i][c] = wanted_factor(i, c, next.exposure);
        return colored(std::move(next));
    }
    /// What came nearest of each, together: one may have gone too far while another was found.
    std::optional<TriedColors> joined_best() const {
        TriedColors next{.exposure = best().exposure, .organ = best().organ, .colors = start_};
        for (std::size_t i = 0; i < parts.size(); ++i) {
            const auto off_of = [&](const TriedColors& tried) { return part_off(tried, i); };
            next.factor[i] = std::ranges::min_element(tried_, {}, off_of)->factor[i];
        }
        return colored(std::move(next));
    }
    /// With the colours of its factors; nothing: it was drawn.
    std::optional<TriedColors> colored(TriedColors next) const {
        for (std::size_t k = 0; k < start_.size(); ++k)
            for (std::size_t i = 0; i < parts.size(); ++i)
                if (fields()[k].seen == parts[i].seen && is_free(fields()[k].key))
                    next.colors[k] = scaled(start_[k], next.factor[i]);
        const auto is_same = [&](const TriedColors& tried) {
            return tried.exposure == next.exposure && tried.organ == next.organ && tried.colors == next.colors;
        };
        return std::ranges::any_of(tried_, is_same) ? std::optional<TriedColors>() : next;
    }

    void finish() {
        const TriedColors& found = best();
        result_.tuned = tuned_of(found);
        result_.before = input_.begun ? input_.begun->before : off(tried_.front());
        result_.after = off(found);
        result_.light_before = relative_light(tried_.front().seen, input_.reference.colors);
        if (input_.begun && input_.begun->light_before) result_.light_before = input_.begun->light_before;
        result_.light_after = relative_light(found.seen, input_.reference.colors);
        tell_exposure(found);
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (moves_[i]) tell_part(found, i);
    }
    void tell_exposure(const TriedColors& found) {
        if (!moves_exposure_) return;
        const double before = exposure_->get(result_.start), after = found.exposure;
        const glm::dvec3 from = result_.start.scene.organ.color, &to = found.organ;
        if (before == after)
            say(exposure_key + (from == to ? ": stays, the tissue of the video is as bright" : ": stays"));
        else
            say(exposure_key + text(": %.4g -> %.4g, ", before, after) + "the tissue of the video was " +
                text("%.2f", 1.0 / *result_.light_before) + " times as bright as that of the scene" +
                (from == to ? "" : "; the colour of the organ does its part"));
        if (moves_organ_)
            say(organ_key + (from == to ? ": stays, the tissue of the video has its tint"
                                        : ": " + hex(from) + " -> " + hex(to) + ", the tint of the video's tissue"));
        say("light.color and light.intensity: stay, the video does not tell the lamp's colour from the tissue's, and "
            "exposure does what intensity would");
    }
    void tell_part(const TriedColors& found, std::size_t i) {
        const MatchedColor& part = parts[i];
        const FieldColors before = colors_of(result_.start.preset);
        for (std::size_t k = 0; k < start_.size(); ++k) {
            const Field& field = fields()[k];
            if (field.seen != part.seen || !is_free(field.key)) continue;
            const glm::dvec3 &from = before[k], &to = found.colors[k];
            say(field.key + (from == to ? ": stays, nothing nearer was found" : ": " + hex(from) + " -> " + hex(to)));
        }
        if (const double left = part_off(found, i); left > plain)
            say(std::string(part.name) + text(": a difference of Delta E %.0f is left, which no colour mends", left));
    }

    static constexpr double lost = 100.0;
    const ColorMatchInput& input_;
    const FieldColors start_ = colors_of(input_.start.preset);
    ColorMatch result_;
    std::optional<FreeParameter> exposure_;
    bool moves_exposure_ = false, moves_organ_ = false;
    std::array<bool, parts.size()> moves_ = {};
    ColorsAtPeak first_;
    std::vector<TriedColors> tried_;
};

}  // namespace

std::span<const std::string> color_keys() {
    static const std::vector<std::string> all = [] {
        std::vector<std::string> keys = {exposure_key, organ_key};
        for (const Field& field : fields()) keys.push_back(field.key);
        return keys;
    }();
    return all;
}

bool is_color_of_scene(std::string_view key) {
    return key == exposure_key || key == organ_key;
}

std::vector<std::string> different_colors(const document::Content& a, const document::Content& b) {
    std::vector<std::string> keys;
    if (a.scene.camera.exposure != b.scene.camera.exposure) keys.push_back(exposure_key);
    if (a.scene.organ.color != b.scene.organ.color) keys.push_back(organ_key);
    const FieldColors of_a = colors_of(a.preset), of_b = colors_of(b.preset);
    for (std::size_t k = 0; k < of_a.size(); ++k)
        if (of_a[k] != of_b[k]) keys.push_back(fields()[k].key);
    return keys;
}

void take_colors(document::Content& into, const document::Content& from, std::span<const std::string> keys) {
    const FieldColors colors = colors_of(from.preset);
    for (const std::string& key : keys) {
        if (key == exposure_key) into.scene.camera.exposure = from.scene.camera.exposure;
        if (key == organ_key) into.scene.organ.color = from.scene.organ.color;
        for (std::size_t k = 0; k < colors.size(); ++k)
            if (key == fields()[k].key) fields()[k].of(into.preset) = colors[k];
    }
}

ColorMatch match_colors(const ColorMatchInput& input) {
    return Matching(input).run();
}

std::vector<std::string> likeness_lines(const ColorMatch& match) {
    std::vector<std::string> lines;
    const auto add = [&](const char* name, const std::optional<double>& before, const std::optional<double>& after) {
        lines.push_back(std::string(name) + (before && after
                                                 ? text(": Delta E %.1f before, %.1f after", *before, *after)
                                                 : ": colour not measurable in both"));
    };
    add("blood", match.before.blood, match.after.blood);
    add("smoke", match.before.smoke, match.after.smoke);
    add("tissue", match.before.tissue, match.after.tissue);
    if (match.light_before && match.light_after)
        lines.back() +=
            text("; %.2f times as bright as in the video before, %.2f after", *match.light_before, *match.light_after);
    return lines;
}

std::optional<ColorsAtPeak> drawn_colors(PreviewCurve& curve, const document::Content& tuned,
                                         std::span<const TargetPoint> target, const Progress& progress) {
    std::vector<double> times;
    const std::size_t count = std::min(target.size(), most_times);
    for (std::size_t i = 0; i < count; ++i)
        times.push_back(target[i * (target.size() - 1) / std::max(count - 1, std::size_t{1})].time);
    if (times.empty()) return ColorsAtPeak{};
    PeakColors colors(times.front(), times.back());
    const auto take = [&](const Image& frame, const Estimator* estimator, const FrameAmounts& amounts) {
        colors.add(frame, estimator, amounts);
    };
    if (!curve.measure(tuned.scene, tuned.preset, times, {.progress = progress, .measured = take})) return {};
    ColorsAtPeak found = colors.at_peak();
    // Tissue of a drawn scene does not move, so all that its smoke puts before it tells the tint.
    found.colors.tinted = found.colors.smoke.has_value();
    return found;
}

}  // namespace lapfx::match
