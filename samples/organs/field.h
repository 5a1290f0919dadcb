// The pieces of the gastric banding field, each as a patch in the field's own coordinates: mm, x right, y up,
// z towards the endoscope; the origin lies at the angle of His.
#pragma once

#include "height_map.h"
#include "patch.h"

namespace organs {

/// From where the endoscope looks: pieces that lie on others are laid on along this direction.
View field_view();

Patch stomach_shape();
Patch liver_edge_shape();
Patch lesser_omentum_shape();
Patch wall_shape();

/// The greater omentum along the greater curvature; `under` has been draped.
Patch apron_shape(const HeightMap& under);
/// The fat pad at the angle of His and the fat along the lesser curvature.
Patch cardia_fat_shape(const HeightMap& under);

}  // namespace organs
