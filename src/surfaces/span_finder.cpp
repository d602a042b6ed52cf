#include "surfaces/span_finder.h"

#include <algorithm>
#include <utility>

namespace frontier_pilot::surfaces {
namespace {

/// Less than one, so that despite rounding no block is taken that has a point outside the disc.
constexpr double kSurely = 1.0 - 1e-9;

}  // namespace

SpanFinder::SpanFinder(const SurfacePoints& points) : points_(points) {
  connect();
  enclose();
}

void SpanFinder::connect() {
  connected_.resize(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    connected_[i].first = points_[i].connected && i > 0 ? connected_[i - 1].first : i;
  }
  for (std::size_t i = points_.size(); i-- > 0;) {
    const bool goes_on = i + 1 < points_.size() && points_[i + 1].connected;
    connected_[i].last = goes_on ? connected_[i + 1].last : i;
  }
}

void SpanFinder::enclose() {
  std::vector<Box> parts;
  parts.reserve(points_.size());
  for (const SurfacePoint& point : points_) parts.push_back({point.position, point.position});
  while (parts.size() >= kFanOut) {
    std::vector<Box> blocks;
    for (std::size_t i = 0; i + kFanOut <= parts.size(); i += kFanOut) {
      Box block = parts[i];
      for (std::size_t k = i + 1; k < i + kFanOut; ++k) {
        block.low = block.low.cwiseMin(parts[k].low);
        block.high = block.high.cwiseMax(parts[k].high);
      }
      blocks.push_back(block);
    }
    boxes_.push_back(blocks);
    parts = std::move(blocks);
  }
}

Span SpanFinder::around(std::size_t i, double radius) const {
  constexpr std::size_t kLeast = 2;
  const Disc disc{points_[i].position, radius * radius};
  const Span& all = connected_[i];
  Span span{i - std::min(kLeast, i - all.first), i + std::min(kLeast, all.last - i)};
  while (span.first > all.first) {
    const std::size_t count = countDown(disc, span.first - 1, all.first);
    if (count == 0) break;
    span.first -= count;
  }
  while (span.last < all.last) {
    const std::size_t count = countUp(disc, span.last + 1, all.last);
    if (count == 0) break;
    span.last += count;
  }
  return span;
}

bool SpanFinder::holds(const Disc& disc, std::size_t i) const {
  return (points_[i].position - disc.centre).squaredNorm() <= disc.squared_radius;
}

bool SpanFinder::holdsAll(const Disc& disc, const Box& box) {
  const Vec2 farthest = (box.low - disc.centre).cwiseAbs().cwiseMax((box.high - disc.centre).cwiseAbs());
  return farthest.squaredNorm() <= kSurely * disc.squared_radius;
}

/// A number of points from `from` upwards, at most to `last`, that lie in the disc: those of the largest block that
/// does for certain, or `from` alone, or none.
std::size_t SpanFinder::countUp(const Disc& disc, std::size_t from, std::size_t last) const {
  std::size_t count = holds(disc, from) ? 1 : 0;
  for (std::size_t level = 0; count > 0 && level < boxes_.size(); ++level) {
    const std::size_t size = count * kFanOut;
    if (from % size != 0 || from + size - 1 > last || !holdsAll(disc, boxes_[level][from / size])) break;
    count = size;
  }
  return count;
}

/// The same downwards from `from`, at most to `first`.
std::size_t SpanFinder::countDown(const Disc& disc, std::size_t from, std::size_t first) const {
  std::size_t count = holds(disc, from) ? 1 : 0;
  for (std::size_t level = 0; count > 0 && level < boxes_.size(); ++level) {
    const std::size_t size = count * kFanOut;
    if ((from + 1) % size != 0 || from + 1 < first + size || !holdsAll(disc, boxes_[level][from / size])) break;
    count = size;
  }
  return count;
}

RangeMaximum::RangeMaximum(std::vector<double> values) : values_(std::move(values)) {
  for (std::size_t i = 0; i + kBlock <= values_.size(); i += kBlock) {
    const auto first = values_.begin() + static_cast<std::ptrdiff_t>(i);
    blocks_.push_back(*std::max_element(first, first + kBlock));
  }
}

double RangeMaximum::operator()(const Span& span) const {
  double greatest = values_[span.first];
  for (std::size_t i = span.first; i <= span.last;) {
    const bool whole = i % kBlock == 0 && i + kBlock - 1 <= span.last;
    greatest = std::max(greatest, whole ? blocks_[i / kBlock] : values_[i]);
    i += whole ? kBlock : 1;
  }
  return greatest;
}

}  // namespace frontier_pilot::surfaces
