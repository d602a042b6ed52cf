#include "support/svg.h"

#include <algorithm>
#include <sstream>

namespace frontier_pilot::bench {
namespace {

constexpr double kUnitsPerMetre = 10.0;
constexpr int kColours = 24;

/// Turns the picture: SVG's y axis points down.
class Canvas {
 public:
  explicit Canvas(const GridGeometry& geometry)
      : geometry_(geometry), scale_(kUnitsPerMetre), height_(geometry.height * geometry.resolution) {}
  double width() const { return geometry_.width * geometry_.resolution * scale_; }
  double height() const { return height_ * scale_; }
  double cell() const { return geometry_.resolution * scale_; }
  double x(double metres) const { return (metres - geometry_.origin.x()) * scale_; }
  double y(double metres) const { return (height_ - (metres - geometry_.origin.y())) * scale_; }

 private:
  GridGeometry geometry_;
  double scale_;
  double height_;
};

/// The cells that `wanted` picks, as one path of horizontal runs.
template <class Wanted>
void drawCells(std::ostream& out, const OccupancyGrid& map, const char* colour, Wanted wanted) {
  const Canvas canvas(map.geometry());
  out << "<path fill=\"" << colour << "\" d=\"";
  for (int y = 0; y < map.height(); ++y) {
    const std::int8_t* row = map.row(y);
    for (int x = 0; x < map.width();) {
      const int first = x;
      while (x < map.width() && wanted(row[x])) ++x;
      if (x > first) {
        out << "M" << first * canvas.cell() << " " << (map.height() - 1 - y) * canvas.cell() << "h"
            << (x - first) * canvas.cell() << "v" << canvas.cell() << "H" << first * canvas.cell() << "z";
      }
      if (x == first) ++x;
    }
  }
  out << "\"/>\n";
}

std::string colourAt(int part) {
  const int red = 255 * part / (kColours - 1);
  std::ostringstream out;
  out << "rgb(" << red << "," << 60 << "," << 255 - red << ")";
  return out.str();
}

void drawTrack(std::ostream& out, const Canvas& canvas, const SvgTrack& track) {
  const std::size_t n = track.points.size();
  for (int part = 0; part < kColours; ++part) {
    const std::size_t first = n * static_cast<std::size_t>(part) / kColours;
    const std::size_t last = std::min(n, n * static_cast<std::size_t>(part + 1) / kColours + 1);
    out << "<polyline fill=\"none\" stroke-width=\"1.5\" stroke=\"" << colourAt(part) << "\" points=\"";
    for (std::size_t i = first; i < last; ++i) {
      out << canvas.x(track.points[i].x()) << "," << canvas.y(track.points[i].y()) << " ";
    }
    out << "\"/>\n";
  }
}

}  // namespace

std::string drawSvg(const OccupancyGrid& map, const std::vector<SvgTrack>& tracks, const std::string& caption) {
  const Canvas canvas(map.geometry());
  std::ostringstream out;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 -16 " << canvas.width() << " " << canvas.height() + 16
      << "\">\n<rect y=\"-16\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  drawCells(out, map, "#c8ccd0", [](std::int8_t value) { return isUnknown(value); });
  drawCells(out, map, "#202428", [](std::int8_t value) { return isOccupied(value); });
  for (const SvgTrack& track : tracks) drawTrack(out, canvas, track);
  out << "<text x=\"4\" y=\"-4\" font-family=\"sans-serif\" font-size=\"11\">" << caption << "</text>\n</svg>\n";
  return out.str();
}

}  // namespace frontier_pilot::bench
