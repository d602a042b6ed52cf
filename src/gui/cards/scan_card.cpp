#include "gui/cards/scan_card.h"

#include <QGridLayout>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace frontier_pilot::gui {
namespace {

constexpr double kLeastRadius = 1.0, kGreatestRadius = 12.0;  // [m]
constexpr double kScanLifetime = 1.0;                         // [s]

/// The width of a sector [rad], in [0, 2 pi).
double widthOf(const teleop::SectorView& sector) {
  const double width = std::fmod(sector.to - sector.from, 2.0 * kPi);
  return width < 0.0 ? width + 2.0 * kPi : width;
}

teleop::Severity severityOf(const teleop::SectorView& sector, std::optional<double> nearest) {
  if (!nearest || std::isnan(*nearest)) return teleop::Severity::kIdle;
  if (*nearest < sector.stop) return teleop::Severity::kError;
  return *nearest < sector.clear ? teleop::Severity::kWarning : teleop::Severity::kGood;
}

}  // namespace

ScanPicture::ScanPicture(const Outline& robot, QWidget* parent) : QWidget(parent), robot_(robot) {
  setAccessibleName("Scan around the robot");
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void ScanPicture::setState(const teleop::OperatorState& state) {
  scan_ = state.scan;
  avoider_ = state.avoider;
  sectors_ = state.sectors;
  update();
}

QSize ScanPicture::sizeHint() const {
  const int em = emOf(*this);
  return {em * 14, em * 12};
}

void ScanPicture::wheelEvent(QWheelEvent* event) {
  const double factor = std::pow(1.0015, -event->angleDelta().y());
  view_radius_ = std::clamp(view_radius_ * factor, kLeastRadius, kGreatestRadius);
  event->accept();
  update();
}

/// The position in pixels of the point at `range` [m] and `angle` [rad] in the base frame.
QPointF ScanPicture::at(double range, double angle) const {
  const double scale = std::min(width(), height()) * 0.5 / view_radius_;
  return {width() * 0.5 - std::sin(angle) * range * scale, height() * 0.5 - std::cos(angle) * range * scale};
}

void ScanPicture::paintEvent(QPaintEvent*) {
  const Theme theme = Theme::current();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath frame;
  frame.addRoundedRect(rect(), emOf(*this) * 0.35, emOf(*this) * 0.35);
  painter.setClipPath(frame);
  painter.fillPath(frame, theme.field);
  drawScan(painter, theme);
  if (avoider_ && avoider_->enabled) {
    if (sectors_.front_left) drawSector(painter, theme, *sectors_.front_left, avoider_->front_left);
    if (sectors_.front_right) drawSector(painter, theme, *sectors_.front_right, avoider_->front_right);
    if (sectors_.rear) drawSector(painter, theme, *sectors_.rear, avoider_->rear);
  }
  drawRings(painter, theme);
  drawRobot(painter, theme);
  painter.setFont(font());
  if (!scan_ || scan_->age > kScanLifetime) {
    painter.setPen(theme.warning);
    const QString text = scan_ ? "scan is " + ageText(scan_->age) + " old" : QString("no scan");
    painter.drawText(rect().adjusted(0, 0, 0, -emOf(*this) / 2), Qt::AlignHCenter | Qt::AlignBottom, text);
  }
}

void ScanPicture::drawRings(QPainter& painter, const Theme& theme) const {
  const double step = view_radius_ > 6.0 ? 2.0 : (view_radius_ > 1.5 ? 1.0 : 0.5);
  const double reach = view_radius_ * std::hypot(width(), height()) / std::min(width(), height());
  painter.setBrush(Qt::NoBrush);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.8);
  painter.setFont(small);
  for (double range = step; range < reach; range += step) {
    painter.setPen(QPen(faded(theme.muted, 0.45), 1, Qt::DotLine));
    const double radius = at(0.0, 0.0).y() - at(range, 0.0).y();
    painter.drawEllipse(at(0.0, 0.0), radius, radius);
    painter.setPen(theme.muted);
    const QPointF label = at(range, -kPi / 4.0);
    painter.drawText(label + QPointF(3, -3), QString::number(range) + " m");
  }
}

void ScanPicture::drawSector(QPainter& painter, const Theme& theme, const teleop::SectorView& sector,
                             std::optional<double> nearest) const {
  const QColor color = theme.color(severityOf(sector, nearest));
  const double width = widthOf(sector);
  const auto wedge = [&](double radius) {
    QPainterPath path(at(0.0, 0.0));
    constexpr int kPieces = 24;
    for (int i = 0; i <= kPieces; ++i) path.lineTo(at(radius, sector.from + width * i / kPieces));
    path.closeSubpath();
    return path;
  };
  painter.setPen(QPen(faded(color, 0.55), 1));
  painter.setBrush(faded(color, 0.12));
  if (sector.clear > sector.stop) painter.drawPath(wedge(sector.clear));
  painter.setBrush(faded(color, 0.3));
  painter.drawPath(wedge(sector.stop));
  if (!nearest || !std::isfinite(*nearest)) return;
  const double radius = at(0.0, 0.0).y() - at(*nearest, 0.0).y();
  QPainterPath arc;
  const QRectF box(at(0.0, 0.0) - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
  const double start = 90.0 + sector.from * 180.0 / kPi;
  arc.arcMoveTo(box, start);
  arc.arcTo(box, start, width * 180.0 / kPi);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(color, 2));
  painter.drawPath(arc);
}

void ScanPicture::drawScan(QPainter& painter, const Theme& theme) const {
  if (!scan_) return;
  const LaserScan2& scan = scan_->scan;
  const bool fresh = scan_->age <= kScanLifetime;
  QPolygonF seen;
  std::vector<QPointF> hits;
  for (std::size_t beam = 0; beam < scan.ranges.size(); ++beam) {
    const RangeReading reading = readBeam(scan, beam);
    if (reading.kind == RangeKind::kInvalid) continue;
    const Vec2 point = scan.T_base_sensor * Vec2(direction(scan.angle(beam)) * reading.distance);
    seen << at(point.norm(), bearing(point));
    if (reading.kind != RangeKind::kFree) hits.push_back(seen.back());
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(faded(theme.accent, fresh ? 0.1 : 0.04));
  painter.drawPolygon(seen);
  painter.setBrush(fresh ? theme.text : theme.idle);
  const double size = std::max(1.2, emOf(*this) * 0.09);
  for (const QPointF& hit : hits) painter.drawEllipse(hit, size, size);
}

void ScanPicture::drawRobot(QPainter& painter, const Theme& theme) const {
  const QPointF origin = at(0.0, 0.0);
  const double middle = 0.5 * (robot_.front() - robot_.rear());
  const double half = 0.5 * std::min(robot_.front() + robot_.rear(), 2.0 * robot_.halfWidth());
  // Drawn larger when the view is so wide that the robot would be a dot.
  const double scale = std::max(origin.y() - at(1.0, 0.0).y(), emOf(*this) * 0.35 / half);
  const auto place = [&](double x, double y) { return origin - QPointF(y, x) * scale; };
  QPolygonF body;
  for (const Vec2& corner : robot_.corners()) body << place(corner.x(), corner.y());
  painter.setPen(QPen(theme.card, 1.5));
  painter.setBrush(theme.accent);
  painter.drawPolygon(body);
  painter.setBrush(theme.on_accent);
  painter.setPen(Qt::NoPen);
  QPolygonF nose;
  nose << place(middle + 0.65 * half, 0.0) << place(middle - 0.4 * half, -0.45 * half)
       << place(middle - 0.4 * half, 0.45 * half);
  painter.drawPolygon(nose);
}

ScanCard::ScanCard(const Outline& robot, QWidget* parent)
    : Card("Surroundings", parent),
      picture_(new ScanPicture(robot)),
      toggle_(new Switch("obstacle_avoider")),
      dot_(new Dot),
      text_(new ElidedLabel("muted")) {
  text_->setObjectName("avoider_state");
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(emOf(*this) / 2);
  grid->setVerticalSpacing(0);
  grid->addWidget(toggle_, 0, 0, 2, 1);
  grid->addWidget(dot_, 0, 1);
  grid->addWidget(makeLabel("Obstacle avoider", "strong"), 0, 2);
  grid->addWidget(text_, 1, 2);
  grid->setColumnStretch(2, 1);
  content()->addWidget(picture_, 1);
  content()->addLayout(grid);
  connect(toggle_, &Switch::asked, this, &ScanCard::avoiderAsked);
}

void ScanCard::setState(const teleop::OperatorState& state) {
  picture_->setState(state);
  const bool heard = state.avoider && state.avoider->status_age <= teleop::kStatusLifetime;
  toggle_->setShown(heard ? std::optional<bool>(state.avoider->enabled) : std::nullopt, state.avoider_service_up,
                    "set_obstacle_avoid_enabled is down");
  dot_->setSeverity(heard ? state.avoider->severity : teleop::Severity::kIdle);
  QString text = heard ? QString::fromStdString(state.avoider->state_text) : QString("silent");
  if (!state.avoider_service_up) text = "down";
  text_->setFullText(text);
  setRemark(state.scan ? "scan " + ageText(state.scan->age) + " old" : QString("no scan"),
            state.scan && state.scan->age <= kScanLifetime ? teleop::Severity::kIdle : teleop::Severity::kWarning);
}

}  // namespace frontier_pilot::gui
