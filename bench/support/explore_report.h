#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "frontier_pilot/system/closed_loop.h"

namespace frontier_pilot::bench {

/// The result of one exploration.
struct ExploreReport {
  std::string world;
  int seed = 0;
  double area = 0.0;       ///< reachable floor [m^2]
  double explored = 0.0;   ///< share of it that the map shows as free
  double wrong = 0.0;      ///< share of the map's occupied cells that are not near a true wall
  double simulated = 0.0;  ///< [s]
  double distance = 0.0;   ///< by the ground truth [m]
  int contacts = 0;
  std::optional<double> standing;  ///< of several robots: longest time that one stood without a reason [s]
  int decisions = 0;               ///< goals sent
  bool ended_well = false;
  std::string end;   ///< why it ended
  double cpu = 0.0;  ///< of the whole loop [s]
  system::ModuleTimes times;
  std::uint64_t hash = 0;
  std::optional<double> tour;  ///< length of a tour that knows the world [m]; without one its columns are left out

  /// Notes that `share` was explored at `t` [s].
  void reach(double share, double t);
  /// A line of the table, and the table's first line.
  std::string text() const;
  /// How long the explorer's decisions took.
  std::string decisionText() const;
  static std::string header(bool with_tour);

 private:
  static const std::vector<double>& levels();
  std::vector<double> reached_;  ///< when each level was reached [s]
};

}  // namespace frontier_pilot::bench
