#include "tools/map_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "frontier_pilot/core/files.h"

namespace frontier_pilot::tools {
namespace {

constexpr double kLargestSide = 4000.0;  // [pixels]
constexpr int kMargin = 20;              // [pixels]
constexpr int kFractionBits = 4;         // of OpenCV's fixed-point coordinates
const cv::Vec3b kUnknownColour(200, 200, 200);
const cv::Vec3b kWallColour(0, 0, 0);
const cv::Vec3b kFloorColour(255, 255, 255);
const cv::Scalar kRed(80, 80, 240);
const cv::Scalar kBlue(220, 80, 0);
const cv::Scalar kGreen(0, 160, 0);

/// The picture, and the conversion of points in the map's frame to its pixels; its y axis points down.
class Canvas {
 public:
  Canvas(const OccupancyGrid& map, const MapPicture& picture) {
    for (int y = 0; y < map.height(); ++y) {
      for (int x = 0; x < map.width(); ++x) {
        if (!isUnknown(map[Cell{x, y}])) include(map.geometry().centre({x, y}));
      }
    }
    for (const Polyline* track : {&picture.odometry, &picture.trajectory}) {
      for (const Vec2& point : *track) include(point);
    }
    const Vec2 size = (high_ - low_) / map.resolution();
    const double shrink = std::max(1.0, size.maxCoeff() / kLargestSide);
    pixel_ = map.resolution() * shrink;
    image_ = cv::Mat3b(rows(), columns(), kUnknownColour);
  }

  cv::Mat3b& image() { return image_; }
  Vec2 pixelOf(const Vec2& point) const {
    return {(point.x() - low_.x()) / pixel_ + kMargin, (high_.y() - point.y()) / pixel_ + kMargin};
  }
  cv::Point cellOf(const Vec2& point) const {
    // Shifted by half a pixel: the centres of the map's cells must not lie on the border between two pixels.
    const Vec2 pixel = pixelOf(point) + Vec2::Constant(0.5);
    return {static_cast<int>(pixel.x()), static_cast<int>(pixel.y())};
  }
  /// In the fixed-point coordinates with which OpenCV draws lines at fractions of pixels.
  cv::Point fineOf(const Vec2& point) const {
    const Vec2 pixel = pixelOf(point) * static_cast<double>(1 << kFractionBits);
    return {static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y()))};
  }

 private:
  void include(const Vec2& point) {
    low_ = empty_ ? point : low_.cwiseMin(point).eval();
    high_ = empty_ ? point : high_.cwiseMax(point).eval();
    empty_ = false;
  }
  int columns() const { return static_cast<int>((high_.x() - low_.x()) / pixel_) + 1 + 2 * kMargin; }
  int rows() const { return static_cast<int>((high_.y() - low_.y()) / pixel_) + 1 + 2 * kMargin; }

  bool empty_ = true;
  Vec2 low_ = Vec2::Zero();
  Vec2 high_ = Vec2::Zero();
  double pixel_ = 1.0;  ///< side of a pixel [m]
  cv::Mat3b image_;
};

void drawMap(const OccupancyGrid& map, Canvas& canvas) {
  // Walls last: where several cells share a pixel, a wall must not vanish.
  for (const bool walls : {false, true}) {
    for (std::size_t i = 0; i < map.size(); ++i) {
      if (isUnknown(map[i]) || isOccupied(map[i]) != walls) continue;
      const cv::Point pixel = canvas.cellOf(map.geometry().centre(map.geometry().cell(i)));
      canvas.image()(pixel) = walls ? kWallColour : kFloorColour;
    }
  }
}

void drawLine(const Vec2& from, const Vec2& to, const cv::Scalar& colour, Canvas& canvas) {
  cv::line(canvas.image(), canvas.fineOf(from), canvas.fineOf(to), colour, 1, cv::LINE_AA, kFractionBits);
}

void drawTrack(const Polyline& track, const cv::Scalar& colour, Canvas& canvas) {
  for (std::size_t i = 1; i < track.size(); ++i) drawLine(track[i - 1], track[i], colour, canvas);
}

}  // namespace

bool writePicture(const OccupancyGrid& map, const MapPicture& picture, const std::string& path) {
  Canvas canvas(map, picture);
  drawMap(map, canvas);
  drawTrack(picture.odometry, kRed, canvas);
  for (const auto& [from, to] : picture.closures) drawLine(from, to, kGreen, canvas);
  drawTrack(picture.trajectory, kBlue, canvas);
  try {
    std::vector<unsigned char> bytes;
    if (!cv::imencode(".png", canvas.image(), bytes)) return false;
    return writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}).empty();
  } catch (const cv::Exception&) {
    return false;
  }
}

}  // namespace frontier_pilot::tools
