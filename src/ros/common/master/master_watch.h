#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <ros/subscriber.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "robot_check/observation.h"
#include "ros/common/callback_guard.h"
#include "ros/common/master/lost_connections.h"
#include "ros/common/master/master_state.h"
#include "ros/common/master/own_parameters.h"
#include "ros/common/master/publisher_watch.h"
#include "ros/common/master/registration.h"
#include "ros/common/master/rivals.h"
#include "ros/common/master/session_news.h"
#include "ros/common/messages/mailbox.h"

namespace frontier_pilot {

/// What a look at the master has found out about other nodes.
struct MasterReport {
  NodesByName publishers;                             ///< by topic, of all topics
  NodesByName providers;                              ///< by service, of all services
  std::optional<std::vector<std::string>> listeners;  ///< the living subscribers of the topic of `watchListeners`
  std::map<std::string, std::string>
      rivals;  ///< by service or topic that belongs to this node alone: another living node that has it as well
};

/// Asks the master periodically, on a thread of its own (the master may be slow to answer, or gone), whether this node
/// is still registered for its topics and services, and registers again what is missing: a restarted master knows no
/// node, and a node that takes over a service and then ends leaves it without a provider. A service that is registered
/// for a node that no longer lives is taken back; if that node lives, it is reported as an error. A subscriber that has
/// lost a publisher is connected to it again. A node that has outlived its master and its launch, and whose name
/// another process has at the new master, ends: to register again would end that one. [ARB-12] [FLT-1]
class MasterWatch {
 public:
  /// `period` is the time between two looks; the next one comes sooner when a registration was missing. A registration
  /// that is missing in two successive looks is made again.
  explicit MasterWatch(Duration period);
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  /// `service`, a resolved name, belongs to this node alone from now on.
  void claimService(const std::string& service);
  /// The same for topics: another living node that publishes all of them is a rival. The next report is that of a look
  /// that begins now: an earlier one has not looked for such rivals.
  void claimTopics(const std::vector<std::string>& topics);
  /// `f` is called, on the watch's thread, with the names of the ROS session: once at the start, and after something
  /// was registered again, because the master may have been restarted. While the master tells no name, it is asked
  /// again in each look. Functions that were given earlier are still called.
  void onSession(SessionNews::Listener f) { session_.add(std::move(f)); }
  /// Sets a parameter of this node's private namespace at the master, on the watch's thread: a caller never waits for a
  /// master that is gone. A restarted master is given it as well.
  void setParameter(const std::string& name, const XmlRpc::XmlRpcValue& value);
  /// When the master answered last; the start of the watch if it never did.
  SteadyTime lastAnswer() const { return last_answer_; }
  /// The latest report, once; nothing if there was no new one since the last call.
  std::optional<MasterReport> take() { return report_.take(); }
  /// Whether a look has ended, so that it is known who publishes what.
  bool hasLooked() const;
  /// The nodes that publish `topic`, a resolved name, as of the last look; also those that hang or were killed.
  std::vector<std::string> publishersOf(const std::string& topic) const;
  /// Whether each look is also to list all topics with their types, which costs another call.
  void listTopics(bool wanted) { lists_topics_ = wanted; }
  /// The XML-RPC URIs of the nodes from which this one receives `topic`, a resolved name, as of the last look.
  std::set<std::string> connectedPublishersOf(const std::string& topic) const;
  /// Each look is also to find out whether the publishers of `topic`, a resolved name, exist.
  void watchPublishers(const std::string& topic) { watched_.add(topic); }
  /// Whether `subscriber`, whose topic is watched, receives from a process that existed at the last look: roscpp goes
  /// on counting those that were killed as publishers.
  bool mayReceive(const ros::Subscriber& subscriber) const {
    return subscriber.getNumPublishers() > 0 && watched_.mayBePublished(subscriber.getTopic());
  }
  /// Whether `node` lives, as a look after `since` has found it. Nothing as long as that is not known: the next look
  /// finds it out, unless the master does not answer, or has forgotten this node, and so perhaps others, in the last
  /// ten seconds.
  std::optional<bool> lives(const std::string& node, SteadyTime since) { return nodes_.lives(node, since); }
  /// Each look is also to find out which subscribers of `topic`, a resolved name, live. Empty: of none any more.
  void watchListeners(const std::string& topic);
  /// The topics of the last look that listed them; empty before.
  std::vector<robot_check::Topic> topics() const;
  /// ERROR while another node has a service or topic that belongs to this one alone, and for ten seconds after
  /// something was registered again.
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  /// The errors that `diagnose` reports now, one sentence each.
  std::vector<std::string> problems() const;

 private:
  void run();
  void look();
  void sendParameters();
  Claims claims() const;
  std::optional<std::vector<std::string>> findListeners(const MasterState& state) const;
  void lookAtTopics(const MasterState& state);
  void lookAtServices(const MasterState& state, const std::map<std::string, std::string>& rivals);
  /// Checks the address that the master has for one service: it may list this node's name with the address of another
  /// process. One service in each look, because each check costs a call.
  void lookAtAnAddress(const MasterState& state);
  /// Adds the services whose registration was lost repeatedly in the last ten seconds: a node that registers and ends
  /// again and again takes them.
  void findTakers(std::map<std::string, std::string>& rivals);
  /// Ends this node for the other process that has its name.
  void giveWay();
  /// True if `what` was missing in the last look, too: a registration that is still in progress is not lost.
  bool missingTwice(const std::string& what);
  void sayWhatWasRenewed();
  void setRivals(const std::map<std::string, std::string>& rivals);

  Mailbox<MasterReport> report_;
  PublisherWatch watched_;
  NodeWatch nodes_;
  Duration period_;
  CallbackGuard guard_;
  std::atomic<SteadyTime> last_answer_;
  std::atomic<bool> lists_topics_{false};
  SessionNews session_;
  mutable std::mutex mutex_;  ///< guards the ten that follow
  std::condition_variable wake_;
  bool ending_ = false;
  bool looks_anew_ = false;  ///< topics were claimed since the look began
  Claims claims_;
  std::string listened_;  ///< the topic of `watchListeners`
  std::vector<std::string> problems_;
  std::vector<robot_check::Topic> topics_;
  UrisByTopic connected_;                  ///< publishers from which this node receives
  std::optional<NodesByName> publishers_;  ///< by topic, as of the last look
  std::map<std::string, XmlRpc::XmlRpcValue> new_parameters_;
  std::set<std::string> missing_, missing_before_;  ///< used by the thread alone, like all that follow
  std::map<std::string, std::string> rivals_;
  std::vector<std::string> renewed_;                      ///< registered again in this look
  std::size_t next_service_ = 0;                          ///< index of the service whose address is checked next
  std::map<std::string, std::deque<SteadyTime>> losses_;  ///< by service: when it was missing in the last ten seconds
  LostConnections connections_;
  std::shared_ptr<OwnParameters> parameters_ = sharedParameters();
  std::map<std::string, SteadyTime> remembered_;
  std::thread thread_;  ///< started when all others are constructed
};

}  // namespace frontier_pilot
