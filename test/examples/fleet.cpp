#include "frontier_pilot/core/grid.h"
#include "frontier_pilot/fleet/merged_map.h"

#include "examples.h"

namespace fp = frontier_pilot;

bool examples::fleet() {
  //! [example]
  fp::GridGeometry geometry;
  geometry.width = geometry.height = 40;
  const fp::OccupancyGrid own(geometry, fp::kFree);
  fp::OccupancyGrid other(geometry, fp::kUnknown);
  // A robot's view: its own map, and the map of another robot that started 3 m ahead of it and looks back.
  fp::fleet::MergedMap view(fp::fleet::FirstSource::kPrevails);
  const fp::Pose2 T_own_other(3.0, 2.0, fp::kPi);
  view.setSource(0, own, geometry.rect(), {});
  view.setSource(1, other, geometry.rect(), T_own_other);
  view.takeChanged();

  other[fp::Cell{4, 4}] = fp::kOccupied;
  view.setSource(1, other, fp::CellRect{4, 4, 1, 1}, T_own_other);
  const fp::CellRect changed = view.takeChanged();
  const fp::Vec2 obstacle = T_own_other * geometry.centre({4, 4});
  //! [example]
  const fp::Cell cell = view.map().geometry().cellAt(obstacle);
  return changed.contains(cell) && fp::isOccupied(view.map()[cell]);
}
