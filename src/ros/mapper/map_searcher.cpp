#include "ros/mapper/map_searcher.h"

#include <functional>
#include <iomanip>
#include <sstream>
#include <string>

#include "ros/common/clock.h"
#include "ros/common/names.h"
#include "ros/common/throttled_log.h"

namespace frontier_pilot {
namespace {

/// Has the mapper go on from where the search has found the robot; empty, or why it does not.
std::string goOnFrom(const mapping::RobotSearch& search, mapping::Mapper& mapper) {
  if (mapper.locate(search)) return {};
  if (search.generation != mapper.generation()) return "the map was replaced or corrected meanwhile; call again";
  const std::string why = mapper.whyNotFound();
  return why.empty() ? "the clock was set back meanwhile" : why;
}

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
  const SteadyTime begin = steadyNow();
  const auto stop = [this, begin] { return thread_.closed() || toSeconds(steadyNow() - begin) > kLongest; };
  const auto work = thread_.ask<Work>([stop](mapping::Mapper& mapper) { return mapper.searchWork(stop); });
  if (!work) {
    response.message = "refused: " + thread_.whyNot("mapper", "hand over its map");
    return true;
  }
  const mapping::RobotSearch search = (*work)();
  std::ostringstream text;
  text << localization::describe(search.result) << std::fixed << std::setprecision(1) << " (searched for "
       << toSeconds(steadyNow() - begin) << " s)";
  response.message = text.str();
  if (!search.found()) {
    THROTTLED_WARN("robot not localised, " << response.message);
    return true;
  }
  const auto answer = thread_.ask<std::string>([search](mapping::Mapper& mapper) { return goOnFrom(search, mapper); });
  const std::string why = answer.value_or(thread_.whyNot("mapper", "go on from where the robot was found"));
  response.success = static_cast<std::uint8_t>(why.empty());
  if (!why.empty()) response.message = "refused: " + why;
  THROTTLED_INFO(response.message);
  return true;
}

}  // namespace frontier_pilot
