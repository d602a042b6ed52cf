#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "frontier_pilot/occupancy/scan_inserter.h"
#include "frontier_pilot/slam/pose_correction.h"

namespace frontier_pilot::test {

/// Revises when told to: everything inserted so far moves by `T_new_old`.
class Thoughtful final : public slam::PoseCorrection {
 public:
  struct Script {
    std::optional<Pose2> T_new_old;
    bool renders = true;
    std::size_t left_out = 0;
  };
  explicit Thoughtful(std::shared_ptr<Script> script) : script_(std::move(script)) {}

  slam::CorrectedScan correct(const surfaces::SurfaceScan& scan, const Pose2& T_odom_base,
                              const occupancy::OccupancyMap&) override {
    scans_.emplace_back(scan, T_map_odom_ * T_odom_base);
    return {T_map_odom_, true, "scripted"};
  }
  slam::RevisionWork takeWork() override {
    if (!script_->T_new_old) return {};
    const Pose2 T_new_old = *std::exchange(script_->T_new_old, std::nullopt);
    return [T_new_old, scans = scans_, renders = script_->renders, left_out = script_->left_out,
            generation = generation_] {
      slam::MapRevision revision;
      revision.left_out = left_out;
      revision.generation = generation;
      revision.T_new_old = T_new_old;
      revision.closures.resize(2);
      if (renders) revision.map.emplace();
      occupancy::ScanInserter inserter;
      for (const auto& [scan, T_map_base] : scans) {
        if (renders) inserter.insert(scan, T_new_old * T_map_base, *revision.map);
      }
      return revision;
    };
  }
  bool accept(const slam::MapRevision& revision) override {
    if (revision.generation != generation_) return false;
    T_map_odom_ = revision.T_new_old * T_map_odom_;
    return true;
  }
  bool refuse(const slam::MapRevision& revision) override { return revision.generation == generation_; }
  void reset() override {
    T_map_odom_ = Pose2();
    ++generation_;
  }

 private:
  std::shared_ptr<Script> script_;
  std::vector<std::pair<surfaces::SurfaceScan, Pose2>> scans_;
  Pose2 T_map_odom_;
  std::uint64_t generation_ = 0;
};

}  // namespace frontier_pilot::test
