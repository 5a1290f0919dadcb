#include "app/measure/compared.h"

#include <cmath>

#include "match/fit/target.h"
#include "match/use/compare_scene.h"
#include "match/use/measure_video.h"

namespace lapfx::app {

namespace {

constexpr double reference_part = 0.5;  // the reference takes this share of the progress

/// Why one of them has no curve, for people. What is no fault of theirs goes on.
std::string not_measured(const char* which, const Error& error) {
    if (error.failure() != Failure::bad_input) throw error;
    Fault fault = error.faults().front();
    fault.file.clear();
    return std::string(which) + " is not measured: " + fault.text();
}

}  // namespace

bool measure_both(Compared& compared, const BothWanted& wanted, const Progress& progress) {
    bool stopped = false;
    const auto part = [&](double from, double to) {
        return [&, from, to](double share) {
            if (progress && !progress(std::lerp(from, to, share))) stopped = true;
            return !stopped;
        };
    };
    const bool known = wanted.found != nullptr;
    try {
        match::MeasuredVideo measured;
        if (!known) measured = match::measure_video(wanted.video, {.options = wanted.options}, part(0, reference_part));
        const match::Measurement& found = known ? *wanted.found : measured.found;
        compared.of_reference = found.frames;
        wanted.curve.count_plate_by(match::painted_blood(found));
    } catch (const Error& error) {
        if (stopped) return false;
        compared.words = not_measured("The reference", error);
        return true;
    }
    const double offset = compared.reference.offset;
    const std::vector<double> times = match::compared_times(compared.of_reference, offset, 0, wanted.scene.duration);
    if (times.empty()) {
        compared.words = "The reference has fewer than two moments in common with the scene";
        return true;
    }
    try {
        auto done = match::compare_scene({.scene = wanted.scene,
                                          .preset = wanted.preset,
                                          .times = times,
                                          .reference = compared.of_reference,
                                          .offset = offset},
                                         wanted.curve, part(known ? 0 : reference_part, 1));
        if (!done) return false;
        compared.of_preview = std::move(done->frames);
        compared.words = in_words(done->compared.amounts);
    } catch (const Error& error) {
        compared.words = not_measured("The preview", error);
    }
    return true;
}

}  // namespace lapfx::app
