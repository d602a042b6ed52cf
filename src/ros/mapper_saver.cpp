#include <boost/make_shared.hpp>
#include <chrono>
#include <utility>

#include "frontier_pilot/ros/callback_guard.h"
#include "frontier_pilot/ros/map_saver.h"
#include "frontier_pilot/ros/names.h"
#include "frontier_pilot/ros/throttled_log.h"

namespace frontier_pilot {
namespace {

constexpr const char* kSaving = "a map that is saved";

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
  const boost::function<bool(SaveMap::Request&, SaveMap::Response&)> handle =
      [this](SaveMap::Request& request, SaveMap::Response& response) { return this->handle(request, response); };
  ros::AdvertiseServiceOptions options;
  options.init(names::kSaveMap, handle);
  options.callback_queue = &queue_;
  connections.serve(options);
  spinner_.start();
}

void MapSaver::provide(OccupancyMap& map) {
  if (auto wanted = wanted_.take()) wanted->set_value(takeSnapshot(map));
}

void MapSaver::run(std::function<void()> job) { queue_.addCallback(boost::make_shared<Job>(std::move(job))); }

void MapSaver::close() {
  closed_ = true;
  wanted_.take();  // a promise that is destroyed wakes who waits for it
}

bool MapSaver::handle(SaveMap::Request& request, SaveMap::Response& response) {
  const MapIoResult result = save(request.path);
  response.success = static_cast<std::uint8_t>(result.ok());
  response.message = result.text;
  if (result.ok()) {
    THROTTLED_INFO(result.text);
  } else {
    THROTTLED_ERROR("map not saved, " << toString(result.status) << ": " << result.text);
  }
  return true;
}

MapIoResult MapSaver::save(const std::string& path) {
  constexpr auto kSnapshotPatience = std::chrono::seconds(10);  // for a mapper that is busy
  std::promise<MapSnapshot> promise;
  std::future<MapSnapshot> snapshot = promise.get_future();
  wanted_.put(std::move(promise));
  if (closed_) wanted_.take();
  if (snapshot.wait_for(kSnapshotPatience) != std::future_status::ready) {
    return {MapIoStatus::kCannotWrite, "the mapper was too busy to hand over its map"};
  }
  try {
    return saveMap(snapshot.get(), path);
  } catch (const std::future_error&) {
    return {MapIoStatus::kCannotWrite, "the mapper is shut down"};
  }
}

}  // namespace frontier_pilot
