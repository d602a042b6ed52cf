#include "ros/mapper/map_searcher.h"

#include <chrono>
#include <future>
#include <iomanip>
#include <memory>
#include <sstream>

#include "ros/common/clock.h"
#include "ros/common/names.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr const char* kBusy = "refused: the mapper is too busy, or shut down";

}  // namespace

void MapSearcher::serve(NodeConnections& connections) {
  using Request = std_srvs::Trigger::Request;
  using Response = std_srvs::Trigger::Response;
  const boost::function<bool(Request&, Response&)> handle = [this](Request& request, Response& response) {
    return this->handle(request, response);
  };
  ros::AdvertiseServiceOptions options;
  options.init(names::kLocalize, handle);
  options.callback_queue = &queue_;
  connections.serve(options);
  spinner_.start();
}

void MapSearcher::provide(mapping::Mapper& mapper) {
  if (const auto wanted = wanted_.take()) (*wanted)(mapper);
}

void MapSearcher::close() {
  closed_ = true;
  wanted_.take();  // destroying the promise wakes the thread that waits for it
}

template <class Answer>
std::optional<Answer> MapSearcher::ask(const std::function<Answer(mapping::Mapper&)>& question) {
  constexpr auto kPatience = std::chrono::seconds(10);  // enough for a busy mapper
  auto promise = std::make_shared<std::promise<Answer>>();
  std::future<Answer> answer = promise->get_future();
  wanted_.put([promise, question](mapping::Mapper& mapper) { promise->set_value(question(mapper)); });
  promise.reset();
  if (closed_ || answer.wait_for(kPatience) != std::future_status::ready) wanted_.take();
  if (answer.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  try {
    return answer.get();
  } catch (const std::future_error&) {
    return std::nullopt;
  }
}

bool MapSearcher::handle(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  using Work = std::function<mapping::RobotSearch()>;
  constexpr double kLongest = 30.0;  // [s]
  response.success = 0U;
  response.message = kBusy;
  const SteadyTime begin = steadyNow();
  const auto stop = [this, begin] { return closed_ || toSeconds(steadyNow() - begin) > kLongest; };
  const auto work = ask<Work>([stop](mapping::Mapper& mapper) { return mapper.searchWork(stop); });
  if (!work) return true;
  const mapping::RobotSearch search = (*work)();
  std::ostringstream text;
  text << localization::describe(search.result) << std::fixed << std::setprecision(1) << " (searched for "
       << toSeconds(steadyNow() - begin) << " s)";
  response.message = text.str();
  if (!search.found()) {
    THROTTLED_WARN("robot not localised, " << response.message);
    return true;
  }
  const auto taken = ask<bool>([search](mapping::Mapper& mapper) { return mapper.locate(search); });
  response.success = static_cast<std::uint8_t>(taken.value_or(false));
  if (!taken.value_or(false)) response.message = "refused: the map was replaced meanwhile, or the mapper is shut down";
  THROTTLED_INFO(response.message);
  return true;
}

}  // namespace frontier_pilot
