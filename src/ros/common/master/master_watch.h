#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "frontier_pilot/core/time.h"
#include "ros/common/callback_guard.h"
#include "ros/common/master/master_state.h"
#include "ros/common/master/own_parameters.h"
#include "ros/common/messages/mailbox.h"

namespace frontier_pilot {

/// What the master says of this node and of those around it.
struct MasterReport {
  NodesByName publishers;  ///< by topic, of all topics
  std::map<std::string, std::string>
      rivals;  ///< by what belongs to this node alone, services and topics: another living node
};

/// Asks the master again and again, on a thread of its own (the master may be slow to answer, or gone), whether it
/// still has this node registered for its topics and services, and registers again what is missing: a new master knows
/// nobody, and a node that takes a service from this one and ends leaves no provider behind. A service that is held by
/// a node that no longer lives is taken back; one that a living node holds is an error that names it. [ARB-12] [FLT-1]
class MasterWatch {
 public:
  /// `period` is the time between two looks. A registration that is missing in two of them is made again.
  explicit MasterWatch(Duration period);
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  /// `service`, a resolved name, belongs to this node alone from now on.
  void claimService(const std::string& service);
  /// The same for topics: another node that publishes all of them takes this one for gone.
  void claimTopics(const std::vector<std::string>& topics);
  /// `f` is called, on the watch's thread, after something was registered again: the master may be another one. What
  /// was given before is called as well.
  void onRenewal(std::function<void()> f);
  /// When the master answered last; the start of the watch if it never did.
  SteadyTime lastAnswer() const { return last_answer_; }
  /// What the master said since the last call, if it said anything.
  std::optional<MasterReport> take() { return report_.take(); }
  /// ERROR while another node has what belongs to this one alone, or for some seconds after something was registered
  /// again.
  void diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) const;
  /// What `diagnose` calls an error now, one sentence each.
  std::vector<std::string> problems() const;

 private:
  void run();
  void look();
  struct Claims {
    std::vector<std::string> services;
    std::vector<std::vector<std::string>> topics;
  };

  Claims claims() const;
  std::map<std::string, std::string> findRivals(const MasterState& state) const;
  void lookAtTopics(const MasterState& state);
  void lookAtServices(const MasterState& state, const std::map<std::string, std::string>& rivals);
  /// The master may have this node's name and another's address: one service in each look, as each costs a call.
  void lookAtAnAddress(const MasterState& state);
  /// What was lost again and again in the last seconds belongs to somebody who comes and goes.
  void findTakers(std::map<std::string, std::string>& rivals);
  /// True if `what` was missing the last time too: a registration that is under way is not a lost one.
  bool missingTwice(const std::string& what);
  void sayWhatWasRenewed();
  void setRivals(const std::map<std::string, std::string>& rivals);

  Mailbox<MasterReport> report_;
  Duration period_;
  CallbackGuard guard_;
  std::atomic<SteadyTime> last_answer_;
  mutable std::mutex mutex_;  ///< guards the five that follow
  std::condition_variable wake_;
  bool ending_ = false;
  Claims claims_;
  std::vector<std::string> problems_;
  std::vector<std::function<void()>> renewals_;
  std::set<std::string> missing_, missing_before_;  ///< the thread's own, as those that follow
  std::map<std::string, std::string> rivals_;
  std::vector<std::string> renewed_;                      ///< in this look
  std::size_t next_service_ = 0;                          ///< whose address is looked at next
  std::map<std::string, std::deque<SteadyTime>> losses_;  ///< of services, in the last seconds
  OwnParameters parameters_;
  std::map<std::string, SteadyTime> remembered_;
  std::thread thread_;  ///< the last member: everything else is there before it starts
};

}  // namespace frontier_pilot
