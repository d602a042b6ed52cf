#include <cmath>
#include <cstdio>
#include <map>

#include "ros/common/clock.h"
#include "ros/common/messages/conversions.h"
#include "ros/common/names.h"
#include "ros/frontier_explorer/explorer_markers.h"

namespace frontier_pilot {
namespace {

using visualization_msgs::Marker;

struct Colour {
  float r, g, b, a;
};
constexpr Colour kGreen = {0.1F, 0.8F, 0.3F, 0.9F};
constexpr Colour kBlue = {0.1F, 0.4F, 1.0F, 0.8F};
constexpr Colour kRed = {1.0F, 0.1F, 0.1F, 0.8F};
constexpr Colour kOrange = {1.0F, 0.55F, 0.1F, 0.9F};
constexpr Colour kGrey = {0.55F, 0.55F, 0.55F, 0.8F};
constexpr Colour kInk = {0.1F, 0.1F, 0.1F, 1.0F};

std::string text(const char* format, double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, format, value);
  return buffer;
}

/// Collects the markers of one message; ids count up within each namespace.
class MarkerWriter {
 public:
  MarkerWriter(const std::string& frame, Time stamp) {
    blank_.header.frame_id = frame;
    blank_.header.stamp = toRosTime(stamp);
    blank_.pose.orientation.w = 1.0;
    Marker clear = blank_;
    clear.action = Marker::DELETEALL;
    array_.markers.push_back(clear);
  }

  void sphere(const std::string& ns, const Vec2& at, double diameter, const Colour& colour) {
    Marker& marker = add(ns, Marker::SPHERE, at, colour);
    marker.scale.x = marker.scale.y = diameter;
    marker.scale.z = 0.05;
  }
  void text(const std::string& ns, const Vec2& at, const std::string& words, const Colour& colour) {
    Marker& marker = add(ns, Marker::TEXT_VIEW_FACING, at, colour);
    marker.pose.position.z = 0.3;
    marker.scale.z = 0.25;
    marker.text = words;
  }
  void cells(const std::string& ns, const std::vector<Cell>& list, const GridGeometry& geometry, const Colour& colour) {
    const auto found = points_.find(ns);
    if (found == points_.end()) {
      Marker& marker = add(ns, Marker::POINTS, Vec2::Zero(), colour);
      marker.scale.x = marker.scale.y = geometry.resolution;
      points_[ns] = array_.markers.size() - 1;
    }
    for (const Cell cell : list) {
      geometry_msgs::Point point;
      point.x = geometry.centre(cell).x();
      point.y = geometry.centre(cell).y();
      point.z = 0.02;
      array_.markers[points_[ns]].points.push_back(point);
    }
  }
  /// An open line.
  void line(const std::string& ns, const std::vector<Vec2>& points, const Colour& colour) {
    if (points.size() < 2) return;
    Marker& marker = add(ns, Marker::LINE_STRIP, Vec2::Zero(), colour);
    marker.scale.x = 0.04;
    for (const Vec2& at : points) {
      geometry_msgs::Point point;
      point.x = at.x();
      point.y = at.y();
      point.z = 0.03;
      marker.points.push_back(point);
    }
  }
  /// From the place in the direction of the yaw.
  void arrow(const std::string& ns, const Pose2& at, const Colour& colour) {
    Marker& marker = add(ns, Marker::ARROW, at.position(), colour);
    marker.pose = toPoseMsg(at);
    marker.pose.position.z = 0.1;
    marker.scale.x = 0.6;
    marker.scale.y = marker.scale.z = 0.12;
  }
  /// A closed line along the sides of a polygon.
  void polygon(const std::string& ns, std::vector<Vec2> corners, const Colour& colour) {
    corners.push_back(corners.front());
    line(ns, corners, colour);
  }
  visualization_msgs::MarkerArray take() { return std::move(array_); }

 private:
  Marker& add(const std::string& ns, int type, const Vec2& at, const Colour& colour) {
    Marker marker = blank_;
    marker.ns = ns;
    marker.id = next_id_[ns]++;
    marker.type = type;
    marker.pose.position.x = at.x();
    marker.pose.position.y = at.y();
    marker.color.r = colour.r;
    marker.color.g = colour.g;
    marker.color.b = colour.b;
    marker.color.a = colour.a;
    array_.markers.push_back(marker);
    return array_.markers.back();
  }

  Marker blank_;
  visualization_msgs::MarkerArray array_;
  std::map<std::string, int> next_id_;
  std::map<std::string, std::size_t> points_;
};

/// The text at a frontier: on a tour the robot's namespace, the place and the time until then; otherwise the score;
/// nothing while it waits.
std::string wordsOf(const exploration::Frontier& frontier, const std::string& owner) {
  if (frontier.place == 0) return frontier.score == 0.0 ? "" : text("%.2f", frontier.score);
  const std::string name = owner.size() > 1 ? owner.substr(1) + " " : "";
  return name + std::to_string(frontier.place) + text(": %.0f s", frontier.cost);
}

void writeSelectable(MarkerWriter& writer, const exploration::Frontier& frontier, const ExplorerScene& scene) {
  writer.cells(names::kFrontierCells, frontier.cells, scene.geometry, kGreen);
  writer.sphere("centroids", frontier.centroid, 0.15 + 0.2 * std::sqrt(frontier.info.area), kBlue);
  const std::string words = wordsOf(frontier, scene.owner);
  if (!words.empty()) writer.text("scores", frontier.centroid, words, kInk);
}

void writeRejected(MarkerWriter& writer, const exploration::Frontier& frontier, const GridGeometry& geometry) {
  const std::string reason = toString(frontier.rejection);
  writer.cells("rejected: " + reason, frontier.cells, geometry, kGrey);
  using exploration::Rejection;
  const bool one_of_many = frontier.rejection == Rejection::kTooSmall || frontier.rejection == Rejection::kLeftOut ||
                           frontier.rejection == Rejection::kSmallCorner;
  if (!one_of_many) writer.text("reasons", frontier.centroid, reason, kGrey);
}

/// The corners clicked so far; the larger first one is where a click closes the polygon.
void writeClicked(MarkerWriter& writer, const std::vector<Vec2>& corners) {
  for (const Vec2& corner : corners)
    writer.sphere("new bounds", corner, &corner == &corners.front() ? 0.5 : 0.2, kOrange);
  writer.line("new bounds", corners, kOrange);
}

}  // namespace

visualization_msgs::MarkerArray makeExplorerMarkers(const ExplorerScene& scene, const std::string& frame, Time stamp) {
  MarkerWriter writer(frame, stamp);
  for (const exploration::Frontier& frontier : scene.frontiers) {
    if (frontier.selectable()) {
      writeSelectable(writer, frontier, scene);
    } else {
      writeRejected(writer, frontier, scene.geometry);
    }
  }
  for (const exploration::BlacklistedPlace& entry : scene.blacklist) {
    writer.sphere("blacklist", entry.position, 0.4, kRed);
    writer.text("blacklist reasons", entry.position, entry.reason, kRed);
  }
  writer.line("tour", scene.tour, kBlue);
  if (!scene.bounds.stay_within.empty()) writer.polygon("bounds", scene.bounds.stay_within, kGreen);
  for (const std::vector<Vec2>& area : scene.bounds.keep_out) writer.polygon("keep out", area, kRed);
  writeClicked(writer, scene.clicked);
  for (const Pose2& pose : scene.inspections) writer.arrow("to inspect", pose, kOrange);
  return writer.take();
}

}  // namespace frontier_pilot
