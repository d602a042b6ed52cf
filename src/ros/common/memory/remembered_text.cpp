#include "ros/common/memory/remembered_text.h"

#include <chrono>
#include <utility>

#include "ros/common/master/ros_sessions.h"
#include "ros/common/memory/disk.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

/// The thread on which all texts of this process are written again; it ends with the last of them.
std::shared_ptr<PeriodicThread> sharedThread() {
  static std::mutex mutex;
  static std::weak_ptr<PeriodicThread> shared;
  const std::lock_guard<std::mutex> lock(mutex);
  std::shared_ptr<PeriodicThread> thread = shared.lock();
  if (!thread) shared = thread = std::make_shared<PeriodicThread>(std::chrono::seconds(1));
  return thread;
}

}  // namespace

RememberedText::RememberedText(std::string what, const std::string& owner, SessionMemory::Owner kind,
                               NodeConnections& connections, std::filesystem::path spare)
    : what_(std::move(what)),
      report_(connections.memory()),
      memory_(rosHome(), rosSessions(), what_, owner, kind, std::move(spare)),
      thread_(sharedThread()) {
  left_ = memory_.recallAll();
  left_elsewhere_ = memory_.recallFromElsewhere();
  left_by_this_launch_ = memory_.recallOfThisLaunch();
  connections.master().onSession([this](const std::vector<std::string>& sessions) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (memory_.enter(sessions)) problem_.put(store());
  });
  number_ = thread_->add([this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    problem_.put(store());
  });
  connections.everySteady(ros::WallDuration(1.0), [this] {
    if (const auto problem = problem_.take()) tell(*problem);
  });
}

RememberedText::~RememberedText() {
  thread_->remove(number_);
  end(!text_);
}

void RememberedText::end(bool forget) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ended_ = true;
  if (forget) memory_.forget();
  memory_.endInOrder();
}

std::string RememberedText::set(std::optional<std::string> text) {
  const std::lock_guard<std::mutex> lock(mutex_);
  text_ = std::move(text);
  if (!text_) memory_.forget();
  std::string problem = store();
  problem_.take();  // one of before
  tell(problem);
  return problem;
}

std::string RememberedText::store() const {
  if (ended_) return {};
  return text_ ? memory_.remember(*text_) : memory_.problem();
}

/// Nothing is lost as long as there is no text: that is only in the diagnostics.
void RememberedText::tell(const std::string& problem) {
  const std::string counts = report_.setProblem(what_, problem);
  if (!text_ || counts.empty()) {
    warned_of_.clear();
  } else if (counts != warned_of_) {
    warned_of_ = counts;
    THROTTLED_WARN(what_ << " would not survive this node: " << counts);
  }
}

}  // namespace frontier_pilot
