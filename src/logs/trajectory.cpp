#include "frontier_pilot/logs/trajectory.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <istream>
#include <ostream>

#include "frontier_pilot/logs/scan_log.h"
#include "logs/text_reader.h"

namespace frontier_pilot::logs {
namespace {

Spread spreadOf(const std::vector<double>& values) {
  if (values.empty()) return {};
  const double count = static_cast<double>(values.size());
  Spread spread;
  for (const double value : values) spread.mean += value / count;
  for (const double value : values) spread.stddev += (value - spread.mean) * (value - spread.mean) / count;
  spread.stddev = std::sqrt(spread.stddev);
  return spread;
}

}  // namespace

void writeTum(std::ostream& out, const Trajectory& trajectory) {
  out << std::fixed << std::setprecision(6);
  for (const StampedPose2& entry : trajectory) {
    const double half = 0.5 * entry.pose.yaw;
    out << toSeconds(entry.stamp) << " " << entry.pose.x << " " << entry.pose.y << " 0 0 0 " << std::sin(half) << " "
        << std::cos(half) << "\n";
  }
}

std::vector<PoseRelation> readRelations(std::istream& file, const std::string& name, std::size_t records) {
  TextReader reader(file, name, " ,\t\r");
  std::vector<PoseRelation> relations;
  while (reader.nextLine()) {
    PoseRelation relation;
    relation.from = reader.count("the first record");
    relation.to = reader.count("the second record");
    relation.T_from_to.x = reader.number("dx");
    relation.T_from_to.y = reader.number("dy");
    relation.T_from_to.yaw = normalizeAngle(reader.number("dyaw"));
    if (!reader.atEnd()) reader.fail("has more than five values");
    const std::size_t last = std::max(relation.from, relation.to);
    if (last >= records) reader.fail("record " + std::to_string(last) + " is beyond the log's end");
    reader.keep(sizeof(relation));
    relations.push_back(relation);
  }
  if (relations.empty()) throw LogError(name + ": holds no relation");
  return relations;
}

RelationError relationError(const std::vector<Pose2>& trajectory, const std::vector<PoseRelation>& relations) {
  std::vector<double> translations;
  std::vector<double> rotations;
  for (const PoseRelation& relation : relations) {
    const Pose2 estimate = trajectory[relation.from].inverse() * trajectory[relation.to];
    const Pose2 difference = relation.T_from_to.inverse() * estimate;
    translations.push_back(difference.position().norm());
    rotations.push_back(std::abs(difference.yaw));
  }
  return {spreadOf(translations), spreadOf(rotations)};
}

AbsoluteError absoluteError(const std::vector<Pose2>& estimate, const std::vector<Pose2>& truth) {
  AbsoluteError error;
  if (estimate.empty()) return error;
  const Pose2 T_truth_estimate = truth.front() * estimate.front().inverse();
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    const Pose2 aligned = T_truth_estimate * estimate[i];
    const double position = (aligned.position() - truth[i].position()).norm();
    const double yaw = std::abs(angleDifference(aligned.yaw, truth[i].yaw));
    error.position_rmse += position * position;
    error.yaw_rmse += yaw * yaw;
    error.position_max = std::max(error.position_max, position);
    error.yaw_max = std::max(error.yaw_max, yaw);
  }
  const double count = static_cast<double>(estimate.size());
  error.position_rmse = std::sqrt(error.position_rmse / count);
  error.yaw_rmse = std::sqrt(error.yaw_rmse / count);
  return error;
}

}  // namespace frontier_pilot::logs
