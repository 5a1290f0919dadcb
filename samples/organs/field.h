// The pieces of the gastric banding field, each as a patch in the field's own coordinates: mm, x right, y up, z towards
// the endoscope; the origin is at the angle of His.
#pragma once

#include "height_map.h"
#include "patch.h"

namespace organs {

/// The direction from which the endoscope looks: pieces are put on top of others along it.
View field_view();

/// mask = how close fat is: 0 bare, 1 at its rim.
Patch stomach_shape();
/// mask = 1 at the sharp edge.
Patch liver_edge_shape();
Patch lesser_omentum_shape();
Patch wall_shape();

/// Not a part of the model: bowel and spleen would be here and carry the omentum.
Patch bed_shape();

/// The tissue under the fat, seen along field_view(): as it is, and with the hollows bridged by a cloth.
struct Ground {
    HeightMap bare;
    HeightMap bridged;
};

/// Fat: mask = 0 at the thin rim, 1 where it is thick. The greater omentum along the greater curvature.
Patch apron_shape(const Ground& ground);
/// The fat pad at the angle of His and the fat along the lesser curvature.
Patch cardia_fat_shape(const Ground& ground);

/// The gastrohepatic ligament: the firm band of the lesser omentum at the cardia, from the stomach to the liver,
/// with the vessels that run in it. u runs along it towards the stomach. mask = 0 at the rim, 1 where it is firm.
Patch ligament_shape(const Ground& ground);

}  // namespace organs
