#include <boost/make_shared.hpp>
#include <chrono>
#include <utility>

#include "ros/common/callback_guard.h"
#include "ros/common/names.h"
#include "ros/common/throttled_log.h"
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
  const boost::function<bool(SaveMap::Request&, SaveMap::Response&)> handle =
      [this](SaveMap::Request& request, SaveMap::Response& response) { return this->handle(request, response); };
  ros::AdvertiseServiceOptions options;
  options.init(names::kSaveMap, handle);
  options.callback_queue = &queue_;
  connections.serve(options);
  spinner_.start();
}

void MapSaver::provide(occupancy::OccupancyMap& map) {
  if (auto wanted = wanted_.take()) wanted->set_value(map_files::takeSnapshot(map));
}

void MapSaver::run(std::function<void()> job) { queue_.addCallback(boost::make_shared<Job>(std::move(job))); }

void MapSaver::close() {
  closed_ = true;
  wanted_.take();  // destroying the promise wakes the thread that waits for it
}

bool MapSaver::handle(SaveMap::Request& request, SaveMap::Response& response) {
  const map_files::MapIoResult result = save(request.path);
  response.success = static_cast<std::uint8_t>(result.ok());
  response.message = result.text;
  if (result.ok()) {
    THROTTLED_INFO(result.text);
  } else {
    THROTTLED_ERROR("map not saved, " << toString(result.status) << ": " << result.text);
  }
  return true;
}

map_files::MapIoResult MapSaver::save(const std::string& path) {
  constexpr auto kSnapshotPatience = std::chrono::seconds(10);  // enough for a busy mapper
  std::promise<map_files::MapSnapshot> promise;
  std::future<map_files::MapSnapshot> snapshot = promise.get_future();
  wanted_.put(std::move(promise));
  if (closed_) wanted_.take();
  if (snapshot.wait_for(kSnapshotPatience) != std::future_status::ready) {
    return {map_files::MapIoStatus::kCannotWrite, "the mapper was too busy to hand over its map"};
  }
  try {
    return map_files::saveMap(snapshot.get(), path);
  } catch (const std::future_error&) {
    return {map_files::MapIoStatus::kCannotWrite, "the mapper is shut down"};
  }
}

}  // namespace frontier_pilot
