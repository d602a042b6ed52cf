#include "ros/mapper/map_searcher.h"

#include <functional>
#include <iomanip>
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
  thread_.serve<Request, Response>(connections, names::kLocalize,
                                   [this](Request& request, Response& response) { return handle(request, response); });
}

bool MapSearcher::handle(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response) {
  using Work = std::function<mapping::RobotSearch()>;
  constexpr double kLongest = 30.0;  // [s]
  response.success = 0U;
  response.message = kBusy;
  const SteadyTime begin = steadyNow();
  const auto stop = [this, begin] { return thread_.closed() || toSeconds(steadyNow() - begin) > kLongest; };
  const auto work = thread_.ask<Work>([stop](mapping::Mapper& mapper) { return mapper.searchWork(stop); });
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
  const auto taken = thread_.ask<bool>([search](mapping::Mapper& mapper) { return mapper.locate(search); });
  response.success = static_cast<std::uint8_t>(taken.value_or(false));
  if (!taken.value_or(false)) response.message = "refused: the map was replaced meanwhile, or the mapper is shut down";
  THROTTLED_INFO(response.message);
  return true;
}

}  // namespace frontier_pilot
