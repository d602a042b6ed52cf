#include <boost/make_shared.hpp>
#include <utility>

#include "ros/common/callback_guard.h"
#include "ros/common/clock.h"
#include "ros/common/messages/save_answer.h"
#include "ros/common/names.h"
#include "ros/mapper/map_saver.h"

namespace frontier_pilot {
namespace {

constexpr const char* kSaving = "saving a map";

class Job : public ros::CallbackInterface {
 public:
  explicit Job(std::function<void()> job) : job_(std::move(job)) {}
  CallResult call() override {
    guard_.run(kSaving, job_);
    return Success;
  }

 private:
  std::function<void()> job_;
  CallbackGuard guard_;
};

}  // namespace

void MapSaver::serve(NodeConnections& connections) {
  using Request = SaveMap::Request;
  using Response = SaveMap::Response;
  thread_.serve<Request, Response>(connections, names::kSaveMap,
                                   [this](Request& request, Response& response) { return handle(request, response); });
}

void MapSaver::run(std::function<void()> job) { thread_.queue().addCallback(boost::make_shared<Job>(std::move(job))); }

bool MapSaver::handle(SaveMap::Request& request, SaveMap::Response& response) {
  answerSave(save(request.path), response);
  return true;
}

map_files::MapIoResult MapSaver::save(const std::string& path) {
  return saveCopy<map_files::MapSnapshot, occupancy::OccupancyMap>(
      thread_, saves_, path, "mapper", map_files::takeSnapshot,
      [path, way = way_, steps = way_->steps()](const map_files::MapSnapshot& map) {
        map_files::MapIoResult result = map_files::saveMap(map, path);
        if (result.ok()) way->noteSaved(steps, steadyNow());
        return result;
      });
}

}  // namespace frontier_pilot
