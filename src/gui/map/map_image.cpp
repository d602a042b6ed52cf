#include "gui/map/map_image.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace frontier_pilot::gui {
namespace {

constexpr int kCoarsest = 64;  // a level with no longer side is the last one
constexpr int kColors = 256;   // as an index a value is a byte: -1, unknown, is the last

const std::int8_t* rowOf(const QImage& image, int row) {
  return reinterpret_cast<const std::int8_t*>(image.constScanLine(row));
}

std::int8_t* rowOf(QImage& image, int row) { return reinterpret_cast<std::int8_t*>(image.scanLine(row)); }

QRgb mixed(const QColor& from, const QColor& to, double share) {
  const auto mix = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
  return qRgb(mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue()));
}

QVector<QRgb> colorsOf(const Theme& theme) {
  const QColor free = theme.dark ? QColor("#39424f") : QColor("#ffffff");
  QVector<QRgb> colors(kColors, MapImage::unknownColor(theme).rgb());
  for (int value = 0; value <= kOccupied; ++value)
    colors[value] = mixed(free, theme.text, static_cast<double>(value) / kOccupied);
  return colors;
}

}  // namespace

QColor MapImage::unknownColor(const Theme& theme) { return theme.dark ? theme.field : QColor("#d3d8df"); }

void MapImage::apply(const teleop::MapChange& change) {
  const CellRect all = change.geometry.rect();
  const bool fits =
      !change.rect.empty() && change.rect.intersection(all) == change.rect &&
      change.cells.size() == static_cast<std::size_t>(change.rect.width) * static_cast<std::size_t>(change.rect.height);
  if (!fits) return;
  if (empty() || change.geometry != geometry_) {
    if (!(change.rect == all)) return;
    rebuild(change.geometry);
  }
  write(change);
  CellRect rect = change.rect;
  for (std::size_t level = 1; level < levels_.size(); ++level) rect = reduce(level, rect);
}

void MapImage::rebuild(const GridGeometry& geometry) {
  geometry_ = geometry;
  levels_.clear();
  QSize size(geometry.width, geometry.height);
  levels_.emplace_back(size, QImage::Format_Indexed8);
  while (std::max(size.width(), size.height()) > kCoarsest) {
    size = QSize((size.width() + 1) / 2, (size.height() + 1) / 2);
    levels_.emplace_back(size, QImage::Format_Indexed8);
  }
}

void MapImage::write(const teleop::MapChange& change) {
  const CellRect& rect = change.rect;
  for (int row = 0; row < rect.height; ++row) {
    std::copy_n(change.cells.data() + static_cast<std::ptrdiff_t>(row) * rect.width, rect.width,
                rowOf(levels_.front(), rect.y + row) + rect.x);
  }
}

CellRect MapImage::reduce(std::size_t level, const CellRect& finer) {
  const QImage& from = levels_[level - 1];
  QImage& to = levels_[level];
  const CellRect rect{finer.x / 2, finer.y / 2, (finer.x + finer.width + 1) / 2 - finer.x / 2,
                      (finer.y + finer.height + 1) / 2 - finer.y / 2};
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    const std::int8_t* low = rowOf(from, 2 * y);
    const std::int8_t* high = rowOf(from, std::min(2 * y + 1, from.height() - 1));
    std::int8_t* out = rowOf(to, y);
    for (int x = rect.x; x < rect.x + rect.width; ++x) {
      const int left = 2 * x;
      const int right = std::min(left + 1, from.width() - 1);
      out[x] = std::max(std::max(low[left], high[left]), std::max(low[right], high[right]));
    }
  }
  return rect;
}

std::int8_t MapImage::at(Cell cell) const {
  return empty() || !geometry_.contains(cell) ? kUnknown : rowOf(levels_.front(), cell.y)[cell.x];
}

QRectF MapImage::knownArea() const {
  if (empty()) return {};
  const QImage& coarse = levels_.back();
  CellRect known;
  for (int y = 0; y < coarse.height(); ++y) {
    for (int x = 0; x < coarse.width(); ++x) {
      if (!isUnknown(rowOf(coarse, y)[x])) known.include(Cell{x, y});
    }
  }
  const double step = geometry_.resolution * std::pow(2.0, static_cast<double>(levels_.size() - 1));
  const QRectF all(geometry_.origin.x(), geometry_.origin.y(), geometry_.width * geometry_.resolution,
                   geometry_.height * geometry_.resolution);
  if (known.empty()) return all;
  return all.intersected(QRectF(geometry_.origin.x() + known.x * step, geometry_.origin.y() + known.y * step,
                                known.width * step, known.height * step));
}

void MapImage::paint(QPainter& painter, const QRectF& visible, double scale, const Theme& theme) {
  if (empty()) return;
  const double pixels_per_cell = scale * geometry_.resolution;
  // So coarse that no pixel of the image is smaller than one of the widget, or some would not be drawn.
  const double finest = std::max(0.0, std::ceil(-std::log2(pixels_per_cell)));
  const auto level = static_cast<std::size_t>(std::min(finest, static_cast<double>(levels_.size() - 1)));
  QImage& image = levels_[level];
  const double step = geometry_.resolution * std::pow(2.0, static_cast<double>(level));
  // Whole pixels of the image around what is visible.
  const double left = std::max(0.0, std::floor((visible.left() - geometry_.origin.x()) / step));
  const double low = std::max(0.0, std::floor((visible.top() - geometry_.origin.y()) / step));
  const double right = std::min<double>(image.width(), std::ceil((visible.right() - geometry_.origin.x()) / step));
  const double high = std::min<double>(image.height(), std::ceil((visible.bottom() - geometry_.origin.y()) / step));
  if (right <= left || high <= low) return;
  image.setColorTable(colorsOf(theme));
  const QRectF source(left, low, right - left, high - low);
  painter.drawImage(QRectF(geometry_.origin.x() + left * step, geometry_.origin.y() + low * step, source.width() * step,
                           source.height() * step),
                    image, source);
}

}  // namespace frontier_pilot::gui
