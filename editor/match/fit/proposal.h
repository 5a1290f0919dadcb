// What a measured reference says by itself, without drawing and without search: when tools work, how much smoke they
// make and how it clears, where blood begins, how fast and how far it spreads. It is where a fit begins, and is shown
// beside what is there.
//
//     const Proposal proposal = propose({scene, preset}, organ, target, {.aspect = 1.25});
//     for (const std::string& line : texts_of(proposal.lines)) std::cout << line << '\n';
//     document.take(proposal.tuned);
//
// Under two seconds. Any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "match/fit/fit.h"
#include "match/fit/free_parameter.h"
#include "match/fit/target.h"

namespace lapfx {
class PreparedOrgan;
}

namespace lapfx::match {

struct ProposalOptions {
    double aspect = 1.25;  ///< of the picture, width over height
    /// Parameters of the preset that may be proposed; those of others stay. Events and curves.emission always move.
    std::vector<std::string> keys = {"bleeding.speed", "bleeding.max_extent", "smoke.haze.accumulation",
                                     "smoke.haze.ventilation"};
};

enum class About : std::uint8_t {
    amounts,
    tools,
    offset  ///< between reference and scene: it stays as it is, whatever moves
};

/// For people, one sentence without a full stop.
struct ProposalLine {
    About about = About::amounts;
    std::string text = {};
};
std::vector<std::string> texts_of(std::span<const ProposalLine> lines);

struct Proposal {
    /// Smoke: whole strokes that are hot have the times of the bursts, each burst that of the stroke which begins
    /// nearest, and full power; those that are too many have none; where they are too few, coagulation is added. Blood:
    /// cold strokes that divide have the times of the wounds, cuts are added, and hot strokes open none where blood is
    /// seen. Strokes outside of the target's time, and values that the reference does not tell, stay.
    document::Content tuned;
    std::vector<ProposalLine> lines = {};  ///< what was found, and what is not determined
    double veil_offset = 0.0;              ///< of the baseline of the reference, which may be hazy itself
};

/// An amount that is not measurable at two times at least leaves what belongs to it as it is. Throws Error (bad_input)
/// for a preset whose values are not allowed.
Proposal propose(const document::Content& start, const std::shared_ptr<const PreparedOrgan>& organ,
                 std::span<const TargetPoint> target, const ProposalOptions& options);

/// The search of a fit begins where the reference says; what it began with becomes its `before`. The lines of the
/// proposal. `tools`: events may be moved; when single contacts work is found more exactly along with the parameters.
/// Where they may not, the values of the proposal are a place that the search tries (FitInput::proposed).
std::vector<ProposalLine> begin_with_proposal(FitInput& input, bool tools = true);

/// Instead of the proposal's lines, where FitResult::proposal_left. `before`: the scene without the proposal.
ProposalLine scene_was_nearer(const Scene& before, const Scene& proposed);

/// Those that are true of the scene without the proposal, too: on the offset.
std::vector<ProposalLine> without_moves(std::span<const ProposalLine> lines);

}  // namespace lapfx::match
