#pragma once

#include <cstddef>
#include <vector>

#include "frontier_pilot/core/laser_scan.h"

namespace frontier_pilot::surfaces {

/// The lone returns of a scan, as numbers among its returns, in ascending order: a beam ends at least 1 m behind both
/// of its neighbours, and no return of the four beams on either side is near its own. Such a beam has mostly passed a
/// pane of glass, a mesh or a slit, or was reflected. A return without neighbours is the usual criterion for an outlier
/// (Rusu et al., "Towards 3D Point Cloud Based Object Maps for Household Environments", 2008); to ask as well that its
/// neighbours be nearer keeps poles and corners. That glass is seen at some angles only is described by Foster et al.,
/// "VisAGGE: Visible Angle Grid for Glass Environments", ICRA 2013.
std::vector<std::size_t> loneReturns(const LaserScan2& scan);

}  // namespace frontier_pilot::surfaces
