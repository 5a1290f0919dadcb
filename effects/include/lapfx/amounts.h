// How much blood and smoke there is: what simulators score trainees by, and what is matched to a surgery video. Effects
// gives the amounts of what it draws; AmountsModel works them out without drawing and without OpenGL, on any thread,
// for plots over a whole scene.
//
//     lapfx::AmountsModel model(organ, {.gravity = scene.gravity});
//     model.set(preset, scene.events, scene.curves);
//     for (double time = 0.0; time <= scene.duration; time += 0.1) plot(time, model.at(time).blood_area);
//
// It gives the same figures as Effects, to the last bit. Lengths mm, times s. One thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "lapfx/api.h"
#include "lapfx/curves.h"
#include "lapfx/error.h"
#include "lapfx/organ.h"
#include "lapfx/preset.h"
#include "lapfx/tool.h"
#include "lapfx/wound.h"

namespace lapfx {

/// Amounts at one time. Nothing is read back from the GPU.
struct Amounts {
    double blood_area = 0.0;    ///< mm2 of organ surface whose bleed value is above the threshold
    double blood_volume = 0.0;  ///< mm3, a proxy: a layer from 0 at its edge to `thickness` at `deep_at` and beyond
    int wounds = 0;             ///< wounds that have opened by now
    int bleeding_wounds =
        0;  ///< wounds whose blood still spreads, or fills again what was cleared (WoundStatus::bleeds). A wound whose
            ///< blood has reached max_extent does not count: it adds no more blood
    int left_out_wounds = 0;  ///< wounds that did not open because there were 4096 already
    std::uint64_t lost_samples =
        0;              ///< samples of the tool queue that found no room or could not be used (tool_queue.h)
    double haze = 0.0;  ///< E, optical thickness at the focus distance
    double emission =
        0.0;  ///< smoke that all tools make at this moment; one tool at full power on lean tissue makes 1.
              ///< A tool of the queue that has not let go makes it up to .1 s after its last sample
    double burnt_area = 0.0;  ///< mm2 of organ surface that has reached the char temperature
};

/// A member of Amounts, of any of the types that they have.
struct AmountMember {
    double Amounts::*number = nullptr;
    int Amounts::*count = nullptr;
    std::uint64_t Amounts::*many = nullptr;

    constexpr AmountMember(double Amounts::*member) : number(member) {}
    constexpr AmountMember(int Amounts::*member) : count(member) {}
    constexpr AmountMember(std::uint64_t Amounts::*member) : many(member) {}
    constexpr double of(const Amounts& amounts) const {
        return number != nullptr  ? amounts.*number
               : count != nullptr ? static_cast<double>(amounts.*count)
                                  : static_cast<double>(amounts.*many);
    }
    friend bool operator==(const AmountMember&, const AmountMember&) = default;
};

/// Everything about an amount for those who show it or write it down: one row for each member of Amounts. lapfx.h and
/// lapfx.py have members of the same names, which tests compare with these rows.
struct AmountRow {
    std::string_view key;  ///< the member's name
    AmountMember member;
    std::string_view title;  ///< "Blood area"
    std::string_view help;   ///< a sentence
    std::string_view unit = {};
    int decimals = -1;  ///< in amounts_line(); -1: it is no column there
};

/// In the order of the columns of amounts_line().
inline constexpr AmountRow amount_rows[] = {
    {.key = "blood_area",
     .member = &Amounts::blood_area,
     .title = "Blood area",
     .help = "Organ surface that blood covers.",
     .unit = "mm2",
     .decimals = 3},
    {.key = "blood_volume",
     .member = &Amounts::blood_volume,
     .title = "Blood volume",
     .help = "The covered surface times the thickness of the layer: an estimate.",
     .unit = "mm3",
     .decimals = 3},
    {.key = "wounds",
     .member = &Amounts::wounds,
     .title = "Wounds",
     .help = "Wounds that have opened by now.",
     .decimals = 0},
    {.key = "bleeding_wounds",
     .member = &Amounts::bleeding_wounds,
     .title = "Wounds bleeding",
     .help = "Wounds whose blood is still spreading.",
     .decimals = 0},
    {.key = "haze",
     .member = &Amounts::haze,
     .title = "Haze",
     .help = "Optical thickness of the smoke in the whole view, at the focus distance.",
     .decimals = 5},
    {.key = "burnt_area",
     .member = &Amounts::burnt_area,
     .title = "Burnt area",
     .help = "Organ surface that has reached the char temperature.",
     .unit = "mm2",
     .decimals = 3},
    {.key = "emission",
     .member = &Amounts::emission,
     .title = "Emission",
     .help = "Smoke that all tools make at this moment: one at full power on lean tissue makes 1.",
     .decimals = 4},
    {.key = "left_out_wounds",
     .member = &Amounts::left_out_wounds,
     .title = "Wounds left out",
     .help = "Wounds that did not open because there were 4096 already."},
    {.key = "lost_samples",
     .member = &Amounts::lost_samples,
     .title = "Samples lost",
     .help = "Samples of the tool queue that found no room or could not be used."},
};
inline constexpr std::size_t amount_count = std::size(amount_rows);

/// The table that `lapfx render --amounts` writes, with one line for each time, s. Both end their line and have points
/// in their numbers, whatever the locale. Any thread; they make strings, and so are not for each frame.
LAPFX_API std::string amounts_head();
LAPFX_API std::string amounts_line(double time, const Amounts& amounts);

/// The part of Amounts that is known in closed form.
struct SmokeAmounts {
    double haze = 0.0, emission = 0.0;  ///< as in Amounts

    void put_into(Amounts& amounts) const { amounts.haze = haze, amounts.emission = emission; }
};

class PreparedOrgan;

struct AmountsOptions {
    glm::dvec3 gravity{0.0, -1.0, 0.0};  ///< direction in organ space
};

class LAPFX_API AmountsModel {
  public:
    /// Copies what it needs from the organ. It takes as long as the constructor of Effects, without the uploads. Images
    /// without pixels, such as PreparedOrgan::organ()'s, show no vessels: give the PreparedOrgan itself. Throws Error
    /// (bad_input) for a gravity without a direction.
    explicit AmountsModel(const Organ& organ, const AmountsOptions& options = {});
    /// The same with an organ that was prepared before (prepared_organ.h). This takes no time and shares the prepared
    /// data.
    explicit AmountsModel(const std::shared_ptr<const PreparedOrgan>& organ, const AmountsOptions& options = {});
    AmountsModel(AmountsModel&&) noexcept;
    AmountsModel& operator=(AmountsModel&&) noexcept;
    ~AmountsModel();

    /// Replaces what was set before; what has not changed costs nothing. The clips need not exist, because amounts do
    /// not depend on them. Throws Error (bad_input) for a preset whose values are not allowed, and keeps the previous
    /// state.
    void set(const Preset& preset, std::span<const ToolContact> contacts, const Curves& curves = {});

    /// Takes any times in any order; going forwards costs least. A time that is not finite counts as 0.
    Amounts at(double time) noexcept;
    /// The same haze and emission as at() gives, in no time: neither blood nor heat is worked out for it.
    SmokeAmounts smoke_at(double time) const noexcept;
    /// Every wound of the contacts and what it was doing at that time. Wounds of later contacts are waiting. Valid
    /// until the next call that is not const.
    std::span<const WoundStatus> wounds() const noexcept;

  private:
    struct LAPFX_HIDDEN State;
    std::unique_ptr<State> state_;
};

}  // namespace lapfx
