#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "exploration/observed_map.h"
#include "frontier_pilot/exploration/parameters.h"

namespace frontier_pilot::exploration {

/// What a viewpoint is expected to show of the unknown behind one frontier cell.
struct Glimpse {
  std::uint32_t cell = 0;  ///< index of the frontier cell
  float area = 0.0F;       ///< [m^2]
  std::uint16_t ray = 0;   ///< number of the ray, counted counter-clockwise from the x axis
};

/// Views from single cells by ray casting, sorted by the frontier cells that the rays leave the known floor through.
/// Known cells behind the first unknown one count for nothing, in contrast to `viewGain`. Kept until enough of the map
/// around the viewpoint has changed.
class FrontierViews {
 public:
  explicit FrontierViews(const ViewParameters& parameters) : parameters_(parameters) {}

  /// Valid until the next call.
  const std::vector<Glimpse>& from(Cell viewpoint, const ObservedMap& map);
  void clear() { views_.clear(); }

 private:
  struct View {
    std::uint64_t changes = 0;
    double area = 0.0;
    std::vector<Glimpse> glimpses;
  };
  /// A cell that a ray passes through, relative to the viewpoint, and how far along the ray its centre is [m].
  struct RayCell {
    std::int16_t x = 0, y = 0;
    float along = 0.0F;
  };
  void drawRays(double resolution);
  void look(Cell viewpoint, const ObservedMap& map, View& view) const;
  /// The same with the map's value at a cell of a ray given by `value_at`.
  template <class ValueAt>
  void look(Cell viewpoint, const ObservedMap& map, View& view, ValueAt value_at) const;
  template <class ValueAt>
  float unknownAlong(const std::vector<RayCell>& ray, ValueAt value_at, RayCell& last_free) const;

  ViewParameters parameters_;
  double resolution_ = 0.0;                 ///< that the rays are drawn for [m]
  std::vector<std::vector<RayCell>> rays_;  ///< from the centre of a cell: the same for all viewpoints
  std::unordered_map<std::size_t, View> views_;
};

}  // namespace frontier_pilot::exploration
