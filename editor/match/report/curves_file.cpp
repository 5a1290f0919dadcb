#include "match/report/curves_file.h"

#include <cstdio>

#include "match/frame/frame_amounts.h"

namespace lapfx::match {

namespace {

std::string cell(double value) {
    char text[32];
    std::snprintf(text, sizeof text, ",%.5f", value);
    return text;
}

std::string cells(const std::optional<Amount>& amount) {
    return amount ? cell(amount->value) + cell(amount->low) + cell(amount->high) : ",,,";
}

std::string cell(std::span<const FrameAmounts> frames, std::size_t i, Curve curve) {
    if (i >= frames.size() || !measurable(frames[i], curve)) return ",";
    return cell((curve == Curve::blood ? frames[i].blood : frames[i].veil).value);
}

}  // namespace

std::string curves_csv(std::span<const TargetPoint> target, const FitResult& result) {
    std::string csv =
        "time,blood,blood_low,blood_high,blood_before,blood_after,veil,veil_low,veil_high,veil_before,veil_after\n";
    for (std::size_t i = 0; i < target.size(); ++i) {
        char time[32];
        std::snprintf(time, sizeof time, "%.4f", target[i].time);
        csv += time + cells(target[i].blood) + cell(result.before, i, Curve::blood) +
               cell(result.after, i, Curve::blood) + cells(target[i].veil) + cell(result.before, i, Curve::veil) +
               cell(result.after, i, Curve::veil) + '\n';
    }
    return csv;
}

}  // namespace lapfx::match
