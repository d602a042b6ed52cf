#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "frontier_pilot/exploration/parameters.h"
#include "ros/common/memory/remembered_text.h"

namespace frontier_pilot {

/// What an operator has told an explorer, where it has begun, whether a stopping rule has ended its exploration, and of
/// which emergency stops it knew. Nothing stands for what has not been told.
struct ExplorerOrders {
  std::optional<exploration::ExplorationBounds> bounds;  ///< empty if they were lifted
  std::optional<bool> returns_to_start;
  std::optional<Pose2> start;        ///< in the map's frame
  std::optional<std::string> ended;  ///< the rule that has ended the exploration, in words
  /// How many emergency stops the arbiter had been asked for when the robot explored; kStopped if it was stopped then.
  std::optional<std::uint64_t> stops;

  static constexpr std::uint64_t kStopped = std::numeric_limits<std::uint64_t>::max();
};

/// The orders on one line, and back; nothing if the text is not such a line, or something is wrong with the bounds.
std::string toText(const ExplorerOrders& orders);
std::optional<ExplorerOrders> ordersIn(const std::string& text);

/// What counts of the orders of an earlier launch at the same master: what keeps the robot from driving somewhere.
ExplorerOrders ofAnotherLaunch(const ExplorerOrders& orders);

/// Keeps the orders beyond the death of the node: the next one must neither leave the bounds nor drive off again, nor
/// return to another place. Another launch finds what `ofAnotherLaunch` leaves. At a regular shutdown all is forgotten
/// but the stops: one that is called before the next one is there counts, too. (That it is paused is a SafeSwitch.)
/// [FLT-2] [EXP-10]
class ExplorerMemory {
 public:
  explicit ExplorerMemory(NodeConnections& connections);
  ~ExplorerMemory() { end(); }
  ExplorerMemory(const ExplorerMemory&) = delete;
  ExplorerMemory& operator=(const ExplorerMemory&) = delete;

  /// Those of the process before this one, until others are kept.
  const ExplorerOrders& orders() const { return orders_; }
  /// Why this process must not explore by itself; empty if it may.
  std::string whyStand() const;

  /// The text to append to an answer: why the bounds, or the way home, would not survive this node; empty if they
  /// would.
  std::string keepBounds(const exploration::ExplorationBounds& bounds);
  std::string keepReturnToStart(bool returns);
  void keepStart(const std::optional<Pose2>& start);
  /// The rule that has ended the exploration; nothing once it goes on.
  void keepEnd(const std::optional<std::string>& reason);
  void keepStops(std::uint64_t stops);
  /// A regular end: forgets all but the stops.
  void end();
  /// An end that is none of the launch: all stays for the next explorer.
  void leave();

 private:
  std::string keep();

  RememberedText text_;
  ExplorerOrders orders_;
  bool ended_ = false;
  bool is_damaged_ = false;  ///< what was left cannot be read, and stays as it is until the bounds are set
};

}  // namespace frontier_pilot
