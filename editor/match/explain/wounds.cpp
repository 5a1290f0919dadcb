#include "match/explain/wounds.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "lapfx/amounts.h"
#include "match/explain/wound_fit.h"
#include "match/explain/wound_site.h"

namespace lapfx::match {

namespace {

// How much less misfit (in squares of standard errors) an explanation must leave to be preferred to a simpler one. Chi
// squared of three unknowns is below 18 in 99.96 % of cases; a start is looked for over the whole curve.
constexpr double one_more = 18.0, an_end = 9.0, other_strengths = 6.6;
/// Squares of standard errors that a point leaves: beyond, much is left to explain.
constexpr double poor = 1.5;
constexpr int most_corrections = 6;
constexpr double settled_start = 0.01, settled_share = 0.005;  // s; of pace and extent
/// Below this share of the view tables say nothing that could be corrected.
constexpr double next_to_nothing = 1e-5;
constexpr double most_correction = 10.0;
/// A table ends where one wound alone would be so much more than all that was measured.
constexpr double beyond_most = 1.3;
constexpr double start_known_within = 0.5, speed_known_within = 0.3;  // s, share
// How far the blood has come before it ends, as a share of how far it would have come, to begin with.
constexpr double ends_at[] = {0.5, 0.8};

double within_row(std::string_view key, double value) {
    const Parameter* row = preset_table().find("bleeding")->find_row(key);
    return std::clamp(value, row->minimum, row->maximum);
}

class Explanation {
  public:
    Explanation(const BloodCurve& curve, const WoundSearch& search)
        : curve_(curve),
          search_(search),
          usual_speed_(search.preset.bleeding.speed > 0.0 ? search.preset.bleeding.speed : BleedingParameters{}.speed),
          tables_(curve, search, usual_speed_),
          model_(search.organ, {.gravity = search.scene.gravity}),
          strokes_(strokes_that_divide(search.scene.events)),
          waiting_(strokes_) {
        for (const glm::dvec3& place : search.elsewhere) waiting_.push_back({.position = place});
        std::reverse(waiting_.begin(), waiting_.end());
        model_.set(search.preset, {});  // throws for values that are not allowed
        none_.fit.misfit = curve.misfit(std::vector<double>(curve.blocks.size(), 0.0));
        found_ = none_;
    }

    void find();
    WoundsFound result();

  private:
    /// A fit and what the core makes of it.
    struct Made {
        WoundFit fit;                          // misfit: of blood
        std::vector<double> blood = {};        // share at each block; empty: none
        std::vector<ToolContact> events = {};  // those of the scene, changed
        std::vector<WoundFound> wounds = {};
        std::optional<std::size_t> unopened = {};  // a wound that is not there, though its site alone opens one
    };
    bool next_site();
    std::vector<ToolContact> without_wounds() const;
    void set_wounds(Made& made) const;
    Preset preset_of(const WoundFit& fit) const;
    Made made_of(const WoundFit& fit);
    void correct(const Made& made);
    WoundFit ended_or_not(const WoundFit& from) const;
    Made refined(WoundFit fit);
    double unit_of(const WoundFit& fit) const;
    void use_sites(std::size_t count);
    void make_even();
    double error_of(std::span<const double> blood) const;

    const BloodCurve& curve_;
    const WoundSearch& search_;
    double usual_speed_;
    WoundTables tables_;
    AmountsModel model_;
    std::vector<WoundSite> strokes_;  // all that divide
    std::vector<WoundSite> waiting_;  // not asked about yet; the next one is the last
    std::vector<WoundSite> sites_;    // those that open a wound, in the order in which they are used
    std::vector<std::size_t> open_nothing_;
    int evaluations_ = 0;
    Made none_;   // no wound
    Made found_;  // the best so far
};

/// Asks about places until there is one more that opens a wound.
bool Explanation::next_site() {
    while (!waiting_.empty()) {
        WoundSite site = std::move(waiting_.back());
        waiting_.pop_back();
        ++evaluations_;
        if (probe(site, search_, beyond_most * curve_.most() / search_.share_per_mm2)) {
            sites_.push_back(std::move(site));
            return true;
        }
        if (!site.contacts.empty()) open_nothing_.push_back(site.contacts.front());
    }
    return false;
}

void Explanation::use_sites(std::size_t count) {
    std::vector<const WoundSite*> used;
    for (std::size_t i = 0; i < count; ++i) used.push_back(&sites_[i]);
    tables_.set_sites(std::move(used));
    tables_.set_correction({});
}

/// The scene's events when no stroke opens a wound.
std::vector<ToolContact> Explanation::without_wounds() const {
    std::vector<ToolContact> events = search_.scene.events;
    for (const WoundSite& stroke : strokes_)
        for (const std::size_t i : stroke.contacts) events[i].strength = 0.0;
    return events;
}

/// The events that open the wounds of its fit.
void Explanation::set_wounds(Made& made) const {
    made.events = without_wounds();
    const double speed = preset_of(made.fit).bleeding.speed;
    const double strongest = scene_table().find("events")->find_row("strength")->maximum;
    for (std::size_t k = 0; k < made.fit.wounds.size(); ++k) {
        const WoundSite& site = sites_[k];
        const FittedWound& wound = made.fit.wounds[k];
        const double strength = made.fit.even ? site.strength : std::min(wound.pace / speed, strongest);
        const std::vector<ToolContact> contacts = site.contacts_at(wound.start, strength, search_.scene.events);
        made.wounds.push_back({.start = contacts.front().time + site.delay,
                               .strength = strength,
                               .position = site.position,
                               .event = site.contacts.empty() ? made.events.size() : site.contacts.front(),
                               .added = site.contacts.empty()});
        if (site.contacts.empty()) made.events.push_back(contacts.front());
        for (std::size_t i = 0; i < site.contacts.size(); ++i) made.events[site.contacts[i]] = contacts[i];
    }
}

Preset Explanation::preset_of(const WoundFit& fit) const {
    Preset preset = search_.preset;
    BleedingParameters& b = preset.bleeding;
    if (fit.wounds.empty()) return preset;
    b.speed = within_row("speed", fit.wounds[0].pace / sites_[0].strength);
    b.max_extent = within_row("max_extent", fit.max_extent);
    return preset;
}

/// Asks the core. When wounds open is taken from it.
Explanation::Made Explanation::made_of(const WoundFit& fit) {
    ++evaluations_;
    Made made{.fit = fit};
    set_wounds(made);
    model_.set(preset_of(fit), made.events, search_.scene.curves);
    for (const BloodCurve::Block& block : curve_.blocks)
        made.blood.push_back(search_.share_per_mm2 * model_.at(block.time).blood_area);
    made.fit.misfit = curve_.misfit(made.blood);
    for (std::size_t k = 0; k < made.wounds.size(); ++k) {
        WoundSite& site = sites_[k];
        std::vector<ToolContact> contacts;
        for (const std::size_t i : site.contacts) contacts.push_back(made.events[i]);
        if (contacts.empty()) contacts.push_back(made.events[made.wounds[k].event]);
        const std::optional<double> start = site.opens(model_.wounds(), contacts);
        if (!start) {
            made.unopened = k;
            continue;
        }
        made.wounds[k].start = *start;
        site.delay = *start - contacts.front().time;
    }
    return made;
}

/// Makes the tables give what the core gives for this fit.
void Explanation::correct(const Made& made) {
    const std::vector<double> raw = tables_.raw(made.fit);
    std::vector<double> correction(raw.size(), 1.0);
    for (std::size_t i = 0; i < raw.size(); ++i)
        if (raw[i] > next_to_nothing) correction[i] = std::min(made.blood[i] / raw[i], most_correction);
    tables_.set_correction(std::move(correction));
}

/// Standard errors count more where even the best explanation leaves more than they say.
double Explanation::unit_of(const WoundFit& fit) const {
    return std::max(fit.misfit / std::max(curve_.independent - static_cast<double>(fit.unknowns()), 1.0), 1.0);
}

/// An end of the spreading only where the curve shows one.
WoundFit Explanation::ended_or_not(const WoundFit& from) const {
    WoundFit open = from, best = from;
    open.max_extent = unbounded;
    open = tables_.fitted(open);
    double farthest = 0.0;
    for (std::size_t k = 0; k < open.wounds.size(); ++k) farthest = std::max(farthest, tables_.travelled(open, k));
    best = best.max_extent < unbounded ? tables_.fitted(best) : open;
    for (const double share : ends_at) {
        WoundFit ended = open;
        ended.max_extent = std::max(share * farthest, 1.0);
        ended = tables_.fitted(ended);
        if (ended.misfit < best.misfit) best = ended;
    }
    return open.misfit - best.misfit < an_end * unit_of(best) ? open : best;
}

/// Fits and corrects in turn, and keeps the best of what the core itself has given.
Explanation::Made Explanation::refined(WoundFit fit) {
    std::optional<Made> best;
    double least = unbounded;
    fit = ended_or_not(fit);
    for (int i = 0; i < most_corrections; ++i) {
        std::sort(fit.wounds.begin(), fit.wounds.end(), earlier);
        Made made = made_of(fit);
        if (made.unopened) return made;
        const double cost = made.fit.misfit + (fit.max_extent < unbounded ? an_end * unit_of(made.fit) : 0.0);
        if (cost < least) least = cost, best = made;
        correct(made);
        const WoundFit next = ended_or_not(fit);
        bool settled = (next.max_extent < unbounded) == (fit.max_extent < unbounded) &&
                       !(std::abs(std::log(next.max_extent / fit.max_extent)) > settled_share);
        for (std::size_t k = 0; k < next.wounds.size(); ++k)
            settled = settled && std::abs(next.wounds[k].start - fit.wounds[k].start) < settled_start &&
                      std::abs(std::log(next.wounds[k].pace / fit.wounds[k].pace)) < settled_share;
        if (settled) break;
        fit = next;
    }
    correct(*best);
    return *best;
}

/// One wound after another. A slow one can stand for a staircase of many, and is better than two: while much is left,
/// more at once are tried.
void Explanation::find() {
    if (!(curve_.most() > 0.0)) return;
    WoundFit from = found_.fit;  // perhaps with wounds that are not worth it yet
    while (from.wounds.size() < most_wounds) {
        const WoundFit& so_far = found_.fit;
        const std::size_t count = from.wounds.size() + 1, added = count - so_far.wounds.size();
        const double worth = one_more * static_cast<double>(added);
        // Nothing could be better than to leave nothing.
        if (so_far.misfit < worth || (added > 1 && unit_of(so_far) < poor)) break;
        if (sites_.size() < count && !next_site()) break;
        use_sites(count);
        WoundFit more = tables_.with_one_more(from);
        more.even = count == 1;
        if (so_far.misfit - more.misfit < worth * unit_of(more)) {
            from = more;
            continue;
        }
        const Made made = refined(more);
        if (made.unopened) {
            const WoundSite& site = sites_[*made.unopened];
            if (!site.contacts.empty()) open_nothing_.push_back(site.contacts.front());
            sites_.erase(sites_.begin() + static_cast<std::ptrdiff_t>(*made.unopened));
            if (*made.unopened + 1 < count) found_ = none_;  // wounds found before would be at other places now
            from = found_.fit;
        } else if (so_far.misfit - made.fit.misfit >= worth * unit_of(made.fit)) {
            found_ = made;
            from = made.fit;
        } else if (unit_of(more) < poor) {
            sites_.pop_back();  // it would explain all, but not here, where its blood is that of another one
        } else {
            from = made.fit;
        }
    }
    use_sites(found_.fit.wounds.size());
    if (found_.fit.wounds.size() > 1) make_even();
}

/// Keeps the strengths of the scene if they explain the curve nearly as well.
void Explanation::make_even() {
    correct(found_);
    WoundFit even = found_.fit;
    even.even = true;
    const Made made = refined(tables_.fitted(even));
    const double worth = other_strengths * static_cast<double>(even.wounds.size() - 1);
    if (!made.unopened && made.fit.misfit - found_.fit.misfit < worth * unit_of(found_.fit)) found_ = made;
}

double Explanation::error_of(std::span<const double> blood) const {
    const std::vector<BloodCurve::Block>& blocks = curve_.blocks;
    double sum = 0.0;
    std::size_t next = 0;
    for (const BloodPoint& p : curve_.points) {
        while (next < blocks.size() && blocks[next].time < p.time) ++next;
        double value = 0.0;
        if (!blood.empty()) {
            const std::size_t to = std::min(next, blocks.size() - 1), from = next > 0 ? next - 1 : 0;
            const double share = to > from ? (p.time - blocks[from].time) / (blocks[to].time - blocks[from].time) : 0.0;
            value = std::lerp(blood[from], blood[to], share);
        }
        sum += (p.blood - value) * (p.blood - value) / (p.error * p.error);
    }
    return std::sqrt(sum / static_cast<double>(curve_.points.size()));
}

WoundsFound Explanation::result() {
    const WoundFit& fit = found_.fit;
    const std::size_t count = fit.wounds.size();
    WoundsFound found;
    found.wounds = found_.wounds;
    found.events = count > 0 ? found_.events : without_wounds();
    found.open_nothing = open_nothing_;
    for (const WoundSite& stroke : strokes_)
        if (std::ranges::count(open_nothing_, stroke.contacts.front()) > 0)
            for (const std::size_t i : stroke.contacts) found.events[i] = search_.scene.events[i];
    const Preset preset = preset_of(fit);
    found.speed = preset.bleeding.speed;
    found.max_extent = search_.preset.bleeding.max_extent;
    found.error = error_of(found_.blood);
    found.evaluations = evaluations_;
    if (count == 0) return found;
    found.strengths_differ = !fit.even;
    for (std::size_t k = 0; k < count; ++k) found.at_least = std::max(found.at_least, tables_.travelled(fit, k));
    found.max_extent_is_known = fit.max_extent < unbounded;
    found.max_extent = found.max_extent_is_known ? preset.bleeding.max_extent
                                                 : within_row("max_extent", std::max(found.max_extent, found.at_least));
    correct(found_);
    const double unit = std::sqrt(unit_of(fit));
    const std::vector<double> errors = tables_.errors(fit);
    for (std::size_t k = 0; k < count; ++k) {
        found.wounds[k].start_error = unit * errors[k];
        found.wounds[k].start_is_known = found.wounds[k].start_error < start_known_within;
    }
    found.speed_error = unit * errors[count];
    found.speed_is_known = found.speed_error < speed_known_within;
    return found;
}

}  // namespace

WoundsFound wounds_of(std::span<const BloodPoint> points, const WoundSearch& search) {
    const BloodCurve curve(points, search.error_lasts);
    if (curve.points.size() < 2 || !(search.share_per_mm2 > 0.0)) {
        WoundsFound nothing;
        nothing.speed = search.preset.bleeding.speed, nothing.max_extent = search.preset.bleeding.max_extent;
        nothing.events = search.scene.events;
        return nothing;
    }
    Explanation explanation(curve, search);
    explanation.find();
    return explanation.result();
}

}  // namespace lapfx::match
