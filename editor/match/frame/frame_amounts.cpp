#include "match/frame/frame_amounts.h"

#include "match/picture/traps.h"

namespace lapfx::match {

unsigned flag_of(InView shown) {
    switch (shown) {
        case InView::bag:
            return told::bag;
        case InView::trocar:
            return told::trocar;
        case InView::dark:
            return told::dark;
        case InView::tissue:
            break;
    }
    return 0;
}

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
