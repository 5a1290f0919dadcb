#include "match/fit/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lapfx/prepared_organ.h"
#include "match/fit/certainty.h"
#include "match/fit/color_match.h"
#include "match/fit/fit_input.h"
#include "match/fit/search.h"
#include "match/fit/undetermined.h"
#include "match/frame/frame_amounts.h"
#include "match/scene/seen_places.h"

namespace lapfx::match {

namespace {

constexpr std::size_t other_places = 24;  // of the first search
constexpr double learning_step = 0.25;    // coordinates: how far a parameter is moved that the core knows nothing of
constexpr double enough = 0.02;           // of the cost: a curve that gains less is the last
constexpr double narrower = 0.4;          // of the last step, where a curve came out worse
constexpr double bound_near = 1e-3;       // coordinates
constexpr double held_error = 0.7;        // coordinates: a value of the preset is right within a factor of two or so
constexpr double small_change = 0.02, farther = 3.0, farthest_least = 0.1;  // coordinates, standard errors, coordinates
constexpr double much_less = 0.1;                                           // of what small changes do
constexpr double telling_share = 0.25;                                      // of the moments
constexpr double denial = 8.0;  // of the cost: four standard errors, when all else is found beside it
const std::string density_key = "smoke.plume.density";  // changes what core_at() tells as emission, and no other amount
constexpr int rounds_beside_held = 3;                   // curves that are drawn at most once it is known what is held

/// A drawn place.
struct Drawn {
    std::vector<double> coordinates;
    std::vector<FrameAmounts> frames;
    double cost = 0.0;
};

/// One parameter, and how far it was moved, in coordinates.
struct Moved {
    std::size_t parameter = 0;
    double step = 0.0;
};

/// What fits of the same organ and target share.
struct Shared {
    CoreAmounts core;
    int curves = 0;                         ///< drawn
    int most_curves = 0;                    ///< of all of them, at most
    std::vector<FrameAmounts> before = {};  ///< of the scene without a proposal; empty: the start is that scene
};

class Fit {
  public:
    Fit(const FitInput& input, Shared& shared)
        : input_(input),
          shared_(shared),
          base_(input.start),
          start_(coordinates_of(input, input.start)),
          objective_(aim_of(input), input.weights, start_),
          carried_(start_.size(), share_of(input)) {
        for (const TargetPoint& aim : input.target) times_.push_back(aim.time);
        best_.coordinates = start_;
        known_ = known_to_core();
    }

    /// That are drawn.
    int most_curves() const {
        const auto unknown = std::count(known_.begin(), known_.end(), false);
        return 2 + input_.rounds + rounds_beside_held + static_cast<int>(unknown) + (input_.match_colors ? 2 : 0);
    }

    /// Draws the start. False: it was ended.
    bool begin() { return draw(start_); }
    const std::vector<FrameAmounts>& frames() const { return best_.frames; }

    /// Where the first search ends, once it has begun: as the curves are told, without another drawn.
    double told_cost() {
        first_place_ = search(space(), start_, first_options(unknown()));
        return space().cost_at(*first_place_);
    }

    /// Once it has begun. `ended`: with what it has begun with.
    FitResult run(bool ended = false) {
        early_ = early_ || ended;
        if (shared_.before.empty()) shared_.before = best_.frames;
        if (!early_) {
            leave_out_unseen();
            held_.assign(start_.size(), false), one_of_many_ = held_;
            const bool too_much = shows_smoke_of_its_own();
            const Courses courses = courses_of(objective_.target());
            for (const FreeParameter& p : input_.parameters)
                shown_.push_back(shows_anything_of(p.key, courses) || (too_much && p.key.starts_with("smoke.")));
            if (match_colors() && learn_unknown()) search_and_hold();
            go_back_if_farther();
            if (hold_undetermined()) search_rounds(rounds_beside_held - 1, options_with(held_));
            go_back_if_farther();
            tell_certainties();
        }
        return result();
    }
    /// Of drawn curves to the reference, as cost, wherever the parameters are.
    double distance(std::span<const FrameAmounts> frames) const { return objective_.cost(curves_of(frames), start_); }

  private:
    /// Blood that is not seen is no aim: it may be noise.
    static std::vector<TargetPoint> aim_of(const FitInput& input) {
        std::vector<TargetPoint> aim = input.target;
        if (!shows_blood(aim))
            for (TargetPoint& point : aim) point.blood.reset();
        return aim;
    }
    static std::vector<double> coordinates_of(const FitInput& input, const document::Content& tuned) {
        std::vector<double> coordinates;
        for (const FreeParameter& p : input.parameters)
            coordinates.push_back(
                std::clamp(p.coordinate(p.get(tuned)), p.coordinate(p.minimum), p.coordinate(p.maximum)));
        return coordinates;
    }
    /// Until a drawn curve with blood tells it.
    static double share_of(const FitInput& input) {
        constexpr double usual = 5e-5;  // of a view of 150 mm
        return seen_share_per_mm2(input.organ->organ(), input.start.scene, input.aspect).value_or(usual);
    }
    SearchSpace space() {
        return {.base = base_,
                .parameters = input_.parameters,
                .times = times_,
                .objective = objective_,
                .carried = carried_,
                .core = shared_.core};
    }
    /// Of each parameter: the core's amounts may change with it. A row within a list, such as an event's time, does not
    /// say so itself.
    std::vector<bool> known_to_core() {
        std::vector<bool> known;
        for (std::size_t k = 0; k < start_.size(); ++k)
            known.push_back((input_.parameters[k].row->redo & redo::amounts) != 0 ||
                            input_.parameters[k].key == density_key || core_changes(k, -learning_step) ||
                            core_changes(k, learning_step));
        return known;
    }
    std::vector<bool> unknown() const {
        std::vector<bool> unknown = known_;
        unknown.flip();
        return unknown;
    }
    bool core_changes(std::size_t k, double step) {
        const FreeParameter& p = input_.parameters[k];
        std::vector<double> moved = start_;
        moved[k] = std::clamp(moved[k] + step, p.coordinate(p.minimum), p.coordinate(p.maximum));
        try {
            return moved[k] != start_[k] && core_change(start_, moved) > 0.0;
        } catch (const Error&) {  // a rule between values
            return false;
        }
    }
    bool goes_on() {
        if (early_) return false;
        const auto share = [this](double curves) { return std::min(curves / shared_.most_curves, 1.0); };
        if (input_.progress)
            early_ = !input_.progress({.share = share(shared_.curves),
                                       .curves = shared_.curves,
                                       .next = share(shared_.curves + 1.0),
                                       .best = best_.frames.empty() ? nullptr : &best_.frames});
        return !early_;
    }
    /// What the scene itself does not show measurably cannot be fitted. Throws Error (bad_input) where nothing is left.
    void leave_out_unseen() {
        std::vector<TargetPoint> target(objective_.target().begin(), objective_.target().end());
        const auto none = [&](Curve curve) {
            return std::none_of(best_.frames.begin(), best_.frames.end(),
                                [&](const FrameAmounts& frame) { return measurable(frame, curve); });
        };
        const bool blind = none(Curve::blood), no_veil = none(Curve::veil);
        if ((blind || !blood_is_seen_) && no_veil)
            throw Error(Failure::bad_input,
                        Fault{.file = "",
                              .place = "",
                              .reason = blind ? "no picture of the scene is measurable"
                                              : "no bleeding is seen in the reference, and the veil is not measurable "
                                                "in any picture of the scene: nothing to fit to"});
        const bool no_plume =
            no_veil || std::none_of(best_.frames.begin(), best_.frames.end(),
                                    [](const FrameAmounts& frame) { return frame.plume.has_value(); });
        if (!blind && !no_plume) return;
        for (TargetPoint& aim : target) {
            if (blind) aim.blood.reset();
            if (no_veil) aim.veil.reset();
            if (no_plume) aim.plume.reset();
        }
        objective_ = Objective(std::move(target), input_.weights, start_);
        first_place_.reset();  // it was searched for with what is left out now
        best_.cost = distance(best_.frames);
        nearest_ = best_;
    }
    /// Smoke of the scene where the reference has none, or less than can be: it is to go, although no course tells it.
    bool shows_smoke_of_its_own() const {
        std::ptrdiff_t moments = 0, more = 0;
        for (std::size_t i = 0; i < input_.target.size() && i < best_.frames.size(); ++i) {
            if (!input_.target[i].veil || !best_.frames[i].measurable()) continue;
            ++moments;
            if (best_.frames[i].veil.low > input_.target[i].veil->high) ++more;
        }
        return static_cast<double>(more) > telling_share * static_cast<double>(moments);
    }
    /// Draws a place, learns from it, and keeps it if it is the nearest; where one parameter was `moved` from the best
    /// place, only what that does is learnt. False: it was ended.
    bool draw(const std::vector<double>& coordinates, const std::optional<Moved>& moved = {}) {
        if (!goes_on()) return false;
        std::optional<std::vector<FrameAmounts>> frames = input_.draw(space().tuned(coordinates), times_);
        early_ = !frames;
        if (early_) return false;
        ++shared_.curves;
        const ShownCurves shown = curves_of(*frames);
        if (moved) {
            carried_.learn(moved->parameter, moved->step, shown);
            return true;
        }
        carried_.drawn(coordinates, space().core_at(coordinates), shown);
        last_cost_ = objective_.cost(shown, coordinates);
        if (best_.frames.empty() || last_cost_ < best_.cost) best_ = {coordinates, std::move(*frames), last_cost_};
        if (nearest_.frames.empty() || best_.cost < nearest_.cost) nearest_ = best_;
        return true;
    }
    /// What is measured of smoke and blood depends on their colours, so these come before all but a first step, with
    /// which there is enough of both to see. False: it was ended.
    bool match_colors() {
        if (!input_.match_colors) return true;
        SearchOptions options = first_options(unknown());
        search_round(options);
        if (!goes_on()) return false;
        const std::optional<document::Content> matched = input_.match_colors(space().tuned(best_.coordinates));
        early_ = !matched;
        if (early_) return false;
        const std::vector<std::string> changed = different_colors(base_, *matched);
        if (changed.empty()) return true;
        const document::Content other = base_;
        take_colors(base_, *matched, changed);
        Drawn before = std::exchange(best_, {}), nearest = std::exchange(nearest_, {});
        Carried carried = std::exchange(carried_, Carried(start_.size(), share_of(input_)));
        if (draw(before.coordinates)) return true;
        base_ = other, best_ = std::move(before), nearest_ = std::move(nearest), carried_ = std::move(carried);
        return false;
    }
    /// To the side with more room within the bounds, or to the other one where a rule between values forbids it.
    double step_to_learn(std::size_t k) {
        const FreeParameter& p = input_.parameters[k];
        const double at = best_.coordinates[k];
        double up = std::min(p.coordinate(p.maximum) - at, learning_step),
               down = -std::min(at - p.coordinate(p.minimum), learning_step);
        if (up < -down) std::swap(up, down);
        for (const double step : {up, down}) {
            std::vector<double> moved = best_.coordinates;
            moved[k] += step;
            if (std::isfinite(space().cost_at(moved))) return step;
        }
        return 0.0;
    }
    /// One curve for each parameter that the core's amounts do not depend on.
    bool learn_unknown() {
        for (std::size_t k = 0; k < start_.size(); ++k) {
            const double step = known_[k] ? 0.0 : step_to_learn(k);
            if (step == 0.0) continue;  // or it cannot be moved beside the others, and nothing is told of it
            std::vector<double> moved = best_.coordinates;
            moved[k] += step;
            if (!draw(moved, Moved{k, step})) return false;
            first_place_.reset();
        }
        return true;
    }
    SearchOptions options_with(std::vector<bool> held) {
        return {.held = std::move(held), .seed = input_.seed, .goes_on = [this] { return goes_on(); }};
    }
    /// Looks elsewhere, too.
    SearchOptions first_options(std::vector<bool> held) {
        SearchOptions options = options_with(std::move(held));
        options.others = other_places;
        if (input_.proposed) options.also = coordinates_of(input_, *input_.proposed);
        return options;
    }
    /// What the reference does not tell is held as soon as the curves are as near as measuring tells, so that no more
    /// are drawn to find it. Farther away, slopes say little about what is told.
    void search_and_hold() {
        SearchOptions options = first_options({});
        const double as_near = 0.5 * objective_.blocks();
        int round = 0;
        for (bool more = true; more && round < input_.rounds && best_.cost > as_near; ++round)
            more = search_round(options);
        if (round < input_.rounds && best_.cost <= as_near && hold_undetermined()) ++round;
        options.held = held_;
        search_rounds(input_.rounds - round, std::move(options));
    }
    void search_rounds(int rounds, SearchOptions options) {
        for (int round = 0; round < rounds && search_round(options);) ++round;
    }
    /// Draws at most one curve. False: another would gain little or nothing, or it was ended.
    bool search_round(SearchOptions& options) {
        if (!goes_on()) return false;
        const std::vector<double> from = best_.coordinates;
        const double before = best_.cost;
        const std::vector<double> next =
            first_place_ ? *std::exchange(first_place_, {}) : search(space(), from, options);
        options.others = 0, options.also.clear();
        double moved = 0.0;
        for (std::size_t k = 0; k < next.size(); ++k) moved = std::max(moved, std::abs(next[k] - from[k]));
        if (moved < bound_near || !draw(next)) return false;
        if (last_cost_ < before && before - last_cost_ < enough * before) return false;
        options.radius = last_cost_ < before ? std::max(options.radius, 2.0 * moved) : narrower * moved;
        if (last_cost_ >= before)  // from the best place again, knowing more
            carried_.stand_at(from, space().core_at(from), curves_of(best_.frames));
        return true;
    }
    /// `error_of_held`: coordinates, of those that are held; 0: they are as they are.
    std::vector<Certainty> certainties(const std::vector<double>& coordinates, Errors errors,
                                       double error_of_held = 0.0) {
        Linearised linear = linearised(space(), coordinates);
        linear.fitted = 1 + static_cast<std::size_t>(std::count(held_.begin(), held_.end(), false));
        for (std::size_t k = 0; k < held_.size(); ++k) {
            if (!held_[k]) continue;
            const std::size_t column = k + 1, prior = objective_.amounts() + k;  // after the offset, and the amounts
            linear.residuals[prior] = 0.0;
            if (error_of_held > 0.0)
                linear.slopes[prior * linear.columns + column] = 1.0 / error_of_held;
            else
                for (std::size_t row = 0; row < prior - k; ++row) linear.slopes[row * linear.columns + column] = 0.0;
        }
        std::vector<Certainty> all = certainty_of(objective_, linear, coordinates, errors, input_.seed);
        for (std::size_t k = 0; k < all.size(); ++k) all[k].determined = all[k].determined && shown_[k];
        look_farther(coordinates, all);
        return all;
    }
    /// Slopes say what small changes do. Where larger ones to one side do much less to the core's amounts (blood that
    /// never reaches how far it could spread), that side has no end, and the parameter is not known.
    void look_farther(const std::vector<double>& coordinates, std::vector<Certainty>& all) {
        for (std::size_t k = 0; k < all.size(); ++k) {
            const FreeParameter& p = input_.parameters[k];
            if (!all[k].determined || held_[k] || !known_[k] || p.key == density_key) continue;
            const double low = p.coordinate(p.minimum), high = p.coordinate(p.maximum);
            const auto change_by = [&](double step) {
                std::vector<double> far = coordinates;
                far[k] = std::clamp(far[k] + step, low, high);
                const double moved = std::abs(far[k] - coordinates[k]);
                try {
                    return moved > 0.0 ? core_change(coordinates, far) / moved : 0.0;
                } catch (const Error&) {  // a rule between values
                    return std::numeric_limits<double>::infinity();
                }
            };
            const double slope = std::max(change_by(-small_change), change_by(small_change));
            if (!std::isfinite(slope)) continue;
            const double step = std::max(farther * all[k].error, farthest_least);
            const bool ends_below = coordinates[k] - low < bound_near || change_by(-step) > much_less * slope;
            const bool ends_above = high - coordinates[k] < bound_near || change_by(step) > much_less * slope;
            if (!ends_below) all[k].low = low;
            if (!ends_above) all[k].high = high;
            all[k].determined = ends_below && ends_above;
        }
    }
    /// Between the core's amounts at two places: root of the sum of squares, each in parts of its greatest. What is
    /// emitted is none of them: it begins and ends at once, so the least step may change much.
    double core_change(const std::vector<double>& from, const std::vector<double>& to) {
        const std::vector<Amounts> a = space().core_at(from), b = space().core_at(to);
        double sum = 0.0;
        for (const auto amount : {&Amounts::blood_area, &Amounts::haze}) {
            double change2 = 0.0, most = 0.0;
            for (std::size_t i = 0; i < a.size(); ++i) {
                change2 += std::pow(a[i].*amount - b[i].*amount, 2);
                most = std::max(most, a[i].*amount);
            }
            if (most > 0.0) sum += change2 / (most * most);
        }
        return std::sqrt(sum);
    }
    /// Once it is known what is held: that it is as it was is not certain, which makes the others less certain. Where
    /// smoke may have hidden blood, what the curves tell is found all the same, but it is not known.
    void tell_certainties() {
        const std::vector<double>& at = best_.coordinates;
        const std::vector<Certainty> seen = certainties(at, Errors::with_scales);
        const std::vector<Certainty> known = certainties(at, Errors::with_hidden);
        certainties_ = certainties(at, Errors::with_hidden, held_error);
        behind_smoke_.resize(held_.size());
        for (std::size_t k = 0; k < held_.size(); ++k) {
            if (held_[k]) certainties_[k] = when_held_[k];
            const bool rare = too_rare(input_.parameters[k].key, objective_.target());
            certainties_[k].determined = !held_[k] && known[k].determined && !rare;
            behind_smoke_[k] = !held_[k] && seen[k].determined && !known[k].determined && !rare;
        }
    }
    double kept_coordinate(std::size_t k) const { return input_.parameters[k].coordinate(kept(input_.parameters[k])); }
    /// Of those that the reference does not tell, the one whose value before it denies least; nothing where it denies
    /// that of each.
    std::optional<std::size_t> least_told(const std::vector<double>& coordinates) const {
        std::optional<std::size_t> least;
        double least_denied = 0.0;
        for (std::size_t k = 0; k < held_.size(); ++k) {
            const Certainty& c = certainties_[k];
            const double value = kept_coordinate(k);
            if (held_[k] || ruled_out_[k] || c.determined || (shown_[k] && (value < c.low || value > c.high))) continue;
            const double denied = shown_[k] ? std::abs(value - coordinates[k]) / c.error : -1.0;
            if (!least || denied < least_denied) least = k, least_denied = denied;
        }
        return least;
    }
    /// What the reference does not tell keeps its value. Several that do the same to the curves are all unknown, but
    /// once one of them is held the others may be known: so one after the other, and what is left is found beside it.
    /// All of it together must not make the curves farther than the reference denies. True: it has drawn the place
    /// where that is so.
    bool hold_undetermined() {
        first_place_.reset();  // was found with nothing held
        std::vector<double> next = best_.coordinates;
        const double most = nearest_.cost + denial;
        certainties_ = certainties(next, Errors::of_course);
        when_held_.resize(next.size());
        ruled_out_.assign(next.size(), false);
        while (const std::optional<std::size_t> k = early_ ? std::nullopt : least_told(next)) {
            held_[*k] = true, one_of_many_[*k] = false, when_held_[*k] = certainties_[*k];
            std::vector<double> beside = next;
            beside[*k] = kept_coordinate(*k);
            const bool moves = beside[*k] != next[*k];
            if (moves && (shown_[*k] || space().cost_at(beside) > most))
                beside = search(space(), beside, options_with(held_));
            const double cost = space().cost_at(beside);
            ruled_out_[*k] = moves && cost > most;
            one_of_many_[*k] = ruled_out_[*k] && (!shown_[*k] || cost <= space().cost_at(next) + denial);
            held_[*k] = !ruled_out_[*k];
            if (held_[*k]) next = beside, certainties_ = certainties(next, Errors::of_course);
        }
        if (early_ || next == best_.coordinates) return false;
        Drawn before = std::exchange(best_, {});
        if (draw(next)) return true;
        best_ = std::move(before);
        return false;
    }
    /// What was told of values that are put back may not be what is drawn then: where that is farther than the
    /// reference denies, or than the scene was while the nearest is not, they stay where the curves were nearest.
    void go_back_if_farther() {
        const double scene = distance(shared_.before);
        const bool than_scene = distance(best_.frames) > scene && distance(nearest_.frames) <= scene;
        if (early_ || (best_.cost <= nearest_.cost + denial && !than_scene)) return;
        for (std::size_t k = 0; k < held_.size(); ++k) {
            if (!held_[k] || kept_coordinate(k) == nearest_.coordinates[k]) continue;
            held_[k] = false, one_of_many_[k] = true;
        }
        best_ = nearest_;
        carried_.stand_at(best_.coordinates, space().core_at(best_.coordinates), curves_of(best_.frames));
    }
    const document::Content& original() const { return input_.before ? *input_.before : input_.start; }
    /// An event that the proposal added was not there before.
    double value_before(const FreeParameter& p) const {
        try {
            return p.get(original());
        } catch (const Error&) {
            return p.get(input_.start);
        }
    }
    /// The value of one that is not determined: that of the preset before any proposal; proposed events stay.
    double kept(const FreeParameter& p) const { return p.get(p.of_scene ? input_.start : original()); }
    FitResult result() {
        FitResult result{.tuned = space().tuned(best_.coordinates),
                         .before = shared_.before,
                         .after = best_.frames,
                         .ended_early = early_,
                         .curves = shared_.curves,
                         .evaluations = shared_.core.evaluations()};
        result.blood_before = misfit(input_.target, result.before, &TargetPoint::blood);
        result.blood_after = misfit(input_.target, result.after, &TargetPoint::blood);
        result.veil_before = misfit(input_.target, result.before, &TargetPoint::veil);
        result.veil_after = misfit(input_.target, result.after, &TargetPoint::veil);
        const std::span<const TargetPoint> told = blood_is_seen_ ? objective_.target() : input_.target;
        const Courses courses = courses_of(told);
        for (std::size_t k = 0; k < start_.size() && !certainties_.empty(); ++k) {
            const FittedParameter& p = result.parameters.emplace_back(fitted(k, told, courses));
            p.parameter.set(result.tuned, p.after);  // what has kept its value has it to the last bit
        }
        return result;
    }
    double found(std::size_t k) const {
        const FreeParameter& p = input_.parameters[k];
        if (held_[k] && !early_) return kept(p);
        const double at = best_.coordinates[k];
        return at == start_[k] ? p.get(input_.start) : p.value(at);
    }
    static bool near_bound(const FreeParameter& p, double at) {
        return at - p.coordinate(p.minimum) < bound_near || p.coordinate(p.maximum) - at < bound_near;
    }
    FittedParameter fitted(std::size_t k, std::span<const TargetPoint> told, const Courses& courses) const {
        const FreeParameter& p = input_.parameters[k];
        const Certainty& c = certainties_[k];
        const double at = best_.coordinates[k];
        FittedParameter fitted{.parameter = p,
                               .before = value_before(p),
                               .after = found(k),
                               .low = p.value(c.low),
                               .high = p.value(c.high),
                               .determined = c.determined,
                               .at_bound = !held_[k] && near_bound(p, at)};
        if (early_) {
            fitted.determined = false;
            fitted.why = "the fit ended before that was known";
        } else if (!c.determined) {
            fitted.why = behind_smoke_[k]
                             ? std::string(behind_smoke)
                             : why_undetermined(k, input_.parameters, certainties_, told, courses, input_.weights);
            if (one_of_many_[k])
                fitted.why +=
                    "; put back together with the others, the value before makes the curves farther: this is "
                    "one of many that fit";
            else if (ruled_out_[k])
                fitted.why += "; but the curves rule out the value before, so it is where they are nearest" +
                              std::string(fitted.at_bound ? ", at its bound" : "");
            else if (!held_[k])
                fitted.why += "; " + where_nearest(p, fitted.low, fitted.high, fitted.at_bound);
        }
        return fitted;
    }

    const FitInput& input_;
    Shared& shared_;
    document::Content base_;  ///< the start, with the colours of the reference once they are matched
    const std::vector<double> start_;
    std::vector<double> times_;
    Objective objective_;
    Carried carried_;
    Drawn best_;
    Drawn nearest_;  ///< of all that were drawn; the best keeps what the reference does not tell, and may be farther
    std::optional<std::vector<double>> first_place_;  ///< what told_cost() found; used up by the first round
    std::vector<Certainty> certainties_;
    std::vector<bool> known_;           ///< of each parameter: to the core
    std::vector<bool> held_, shown_;    ///< of each parameter: it keeps its value; the reference shows anything of it
    std::vector<bool> behind_smoke_;    ///< of each parameter: it would be known if smoke hid no blood
    std::vector<bool> ruled_out_;       ///< of each parameter: the curves are much farther with its value before
    std::vector<bool> one_of_many_;     ///< of each parameter: it was held, but what was drawn then was farther
    std::vector<Certainty> when_held_;  ///< of each parameter that is held
    const bool blood_is_seen_ = shows_blood(input_.target);
    double last_cost_ = 0.0;
    bool early_ = false;
};

}  // namespace

FitResult fit(const FitInput& input) {
    require_something(input);
    Shared shared{.core = CoreAmounts(input.organ)};
    Fit begun(input, shared);
    shared.most_curves = begun.most_curves();
    if (!input.before) return begun.run(!begun.begin());
    const FitInput without = without_proposal(input);
    Fit as_it_is(without, shared);
    const bool drawn = as_it_is.begin();
    shared.before = as_it_is.frames();
    const auto run_as_it_is = [&](bool ended) {
        FitResult result = as_it_is.run(ended);
        result.proposal_left = true;
        return result;
    };
    const bool both = drawn && begun.begin();
    // A parameter more has to make the curves nearer by as much as chance does (Akaike, 1974).
    if (both && moves_tools(input) &&
        as_it_is.told_cost() <= begun.told_cost() + static_cast<double>(input.of_proposal))
        return run_as_it_is(false);
    FitResult result = begun.run(!both);
    const bool farther = both && as_it_is.distance(result.after) > as_it_is.distance(result.before);
    if (!farther) return result;
    shared.most_curves += as_it_is.most_curves();
    return run_as_it_is(result.ended_early);
}

}  // namespace lapfx::match
