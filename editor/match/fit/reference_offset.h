// What the curves say of the offset between a reference and a scene, before anything is moved.
//
//     const std::string line = told_of_offset(target, courses_of(target), core_curves);
//
// Pure, any thread.
#pragma once

#include <span>
#include <string>

#include "match/fit/target.h"
#include "match/fit/undetermined.h"

namespace lapfx::match {

/// For people, one sentence without a full stop, that begins with the offset's key: the reference's curves are those of
/// the scene but for one shift in time, or they are even, so that no offset is nearer than another. Empty: neither.
/// `scene`: its curves, no farther apart than longest_gap.
std::string told_of_offset(std::span<const TargetPoint> target, const Courses& courses,
                           std::span<const FrameAmounts> scene);

}  // namespace lapfx::match
