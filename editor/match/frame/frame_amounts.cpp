#include "match/frame/frame_amounts.h"

namespace lapfx::match {

bool measurable(const FrameAmounts& frame, Curve curve) {
    switch (curve) {
        case Curve::blood:
            return frame.blood_measurable();
        case Curve::course:
            return frame.course.has_value();
        case Curve::veil:
            break;
    }
    return frame.measurable();
}

const Amount& amount_of(const FrameAmounts& frame, Curve curve) {
    switch (curve) {
        case Curve::blood:
            return frame.blood;
        case Curve::course:
            return *frame.course;
        case Curve::veil:
            break;
    }
    return frame.veil;
}

}  // namespace lapfx::match
