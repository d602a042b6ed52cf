#pragma once

#include <ros/datatypes.h>

#include <boost/shared_ptr.hpp>
#include <cstddef>
#include <deque>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "frontier_pilot/core/time.h"
#include "ros/common/hold_up_watch.h"

namespace frontier_pilot {

/// How long a node that starts is being connected to those who publish already; also on a busy computer.
constexpr Duration kSettling = std::chrono::seconds(2);

/// The publishers to which this node was not connected although the master knew them, for instance because they hung
/// when the node was started. Whatever they latch is delivered when they are connected at last. May be used from
/// several threads.
class LateConnections {
 public:
  using Connection = std::pair<std::string, std::string>;  ///< topic and publisher

  /// What is missing in one look. What has been missing for almost a second is late, because a
  /// connection takes its time to be made.
  void note(const std::set<Connection>& missing, SteadyTime now);
  /// Whether the publisher was late until a moment ago.
  bool has(const std::string& topic, const std::string& publisher, SteadyTime now) const;

 private:
  mutable std::mutex mutex_;                ///< guards all that follow
  std::map<Connection, SteadyTime> since_;  ///< when each was missing first
  std::map<Connection, SteadyTime> late_;   ///< when each that is late was missing last
};

/// Those of this process.
LateConnections& lateConnections();

/// Recognizes commands that were published before and are delivered again: a latching publisher (`rostopic pub`, for
/// instance) sends its last message to each new connection, whenever it was published. A connection that is made again,
/// or a node that is started again, must not take it for a new command. [ARB-6] [ARB-8]
class LatchedRepeats {
 public:
  using Header = boost::shared_ptr<ros::M_string>;  ///< the header of a connection, which belongs to that one alone

  /// The first message of each latching publisher that arrives within `settling` of the `start` counts as published
  /// before this node was there, and so does that of one that is connected late. With zero neither does. A start that
  /// takes long, or a hold-up of the process before the node is settled, begins that time again: the message may have
  /// waited meanwhile.
  LatchedRepeats(std::string topic, SteadyTime start, Duration settling,
                 const LateConnections& late = lateConnections())
      : topic_(std::move(topic)),
        settling_until_(start + settling),
        settles_(settling > Duration::zero()),
        is_settled_(!settles_),
        hold_ups_(settling, 3 * settling),
        late_(late) {
    hold_ups_.isCatchingUp(start);
  }

  /// To be called at least every 0.3 s where there is a time to settle, by whoever reads the messages.
  void look(SteadyTime now);

  /// Whether a message that arrives now by the connection with this header was published before: it is the first one
  /// that a latching publisher sends by it, and that publisher was heard by another connection already, or was
  /// connected late, or this node is not settled yet. A publisher that is started again under its old name is not told
  /// from one that is connected again.
  bool isRepeat(const Header& header, SteadyTime now);

 private:
  static constexpr std::size_t kMostRemembered = 200;  ///< latching publishers; most have names that are used once

  std::string topic_;  ///< a resolved name
  SteadyTime settling_until_;
  bool settles_, is_settled_;
  HoldUpWatch hold_ups_;  ///< until the node is settled
  const LateConnections& late_;
  std::deque<std::pair<std::string, Header>> heard_;  ///< by publisher: the connection by which it was heard last
};

/// `kSettling` for a node that was started after another one of its name, which has had the commands of that time; zero
/// for others: a goal that is latched before the navigation is there at all is meant for it.
Duration settlingOfARestart();

/// Warns of a command that was dropped as a repeat.
void sayRepeat(const std::string& topic, const std::string& publisher);

}  // namespace frontier_pilot
