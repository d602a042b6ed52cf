#include "gui/cards/map_card.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <array>
#include <utility>

namespace frontier_pilot::gui {
namespace {

const QString kIntroduction = "Wheel: zoom. Drag: move. Shift and click: waypoint.";
constexpr const char* kStopped = "The emergency stop is latched.";
const QString kAiming = "Press there, drag to where it looks. Esc: no goal.";

/// The size of the map, for the remark of the card.
QString sizeOf(const GridGeometry& geometry) {
  return QString("grid %1 m x %2 m")
      .arg(geometry.width * geometry.resolution, 0, 'f', 1)
      .arg(geometry.height * geometry.resolution, 0, 'f', 1);
}

}  // namespace

MapCard::MapCard(const Outline& robot, QWidget* parent)
    : Card("Map", parent),
      picture_(new MapPicture(robot)),
      go_(new QPushButton("Go here")),
      follow_(new QPushButton),
      forget_(new QPushButton("Forget points")),
      return_(new QPushButton("To origin")),
      save_(new QPushButton("Save map")),
      load_(new QPushButton("Load map")),
      dot_(new Dot),
      message_(new ElidedLabel("muted")) {
  message_->setObjectName("map_message");
  content()->addWidget(picture_, 1);
  content()->addLayout(makeButtons());
  auto* line = new QHBoxLayout;
  line->addWidget(dot_);
  line->addWidget(message_, 1);
  content()->addLayout(line);
  say(kIntroduction, teleop::Severity::kIdle);
  connectPicture();
}

QLayout* MapCard::makeButtons() {
  go_->setCheckable(true);
  auto* grid = new QGridLayout;
  const std::array<std::pair<const char*, QPushButton*>, 6> buttons{{{"map_go", go_},
                                                                     {"map_return", return_},
                                                                     {"waypoints_follow", follow_},
                                                                     {"waypoints_forget", forget_},
                                                                     {"map_save", save_},
                                                                     {"map_load", load_}}};
  constexpr int kColumns = 2;
  for (int i = 0; i < static_cast<int>(buttons.size()); ++i) {
    const auto& [name, button] = buttons[static_cast<std::size_t>(i)];
    button->setObjectName(name);
    grid->addWidget(button, i / kColumns, i % kColumns);
    grid->setColumnStretch(i % kColumns, 1);
  }
  connect(go_, &QPushButton::toggled, this, &MapCard::aim);
  connect(follow_, &QPushButton::clicked, this, [this] { emit waypointsAsked(picture_->waypoints()); });
  connect(forget_, &QPushButton::clicked, picture_, &MapPicture::clearWaypoints);
  connect(return_, &QPushButton::clicked, this, &MapCard::returnAsked);
  connect(save_, &QPushButton::clicked, this, [this] { askForFile(true); });
  connect(load_, &QPushButton::clicked, this, [this] { askForFile(false); });
  return grid;
}

void MapCard::connectPicture() {
  connect(picture_, &MapPicture::goalChosen, this, [this](const Pose2& goal) {
    go_->setChecked(false);
    say(QString("Sent to %1, %2.").arg(twoDecimals(goal.x), twoDecimals(goal.y)), teleop::Severity::kActive);
    emit goAsked(goal);
  });
  connect(picture_, &MapPicture::refused, this,
          [this](const QString& why) { say("Not sent: " + why + ".", teleop::Severity::kWarning); });
  connect(picture_, &MapPicture::waypointsChanged, this, &MapCard::showWaypointCount);
  connect(picture_, &MapPicture::aimingEnded, this, [this] { go_->setChecked(false); });
}

void MapCard::askForFile(bool to_save) {
  const QString maps = QDir::current().absoluteFilePath("maps");
  const bool has_maps = QFileInfo(maps).isDir();
  auto* dialog = new QFileDialog(this, to_save ? "Save the map as" : "Load a map",
                                 has_maps ? maps : QDir::currentPath(), "Maps (*.yaml)");
  dialog->setObjectName("map_file");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  // The dialog itself asks nothing: a question before a file is replaced or deleted would block the whole window.
  dialog->setOptions(QFileDialog::DontUseNativeDialog | QFileDialog::DontConfirmOverwrite | QFileDialog::ReadOnly);
  dialog->setAcceptMode(to_save ? QFileDialog::AcceptSave : QFileDialog::AcceptOpen);
  dialog->setFileMode(QFileDialog::AnyFile);  // the path is one of the mapper's machine
  dialog->setDefaultSuffix("yaml");
  if (to_save) dialog->selectFile(has_maps ? "map.yaml" : "maps/map.yaml");
  connect(dialog, &QFileDialog::fileSelected, this, [this, to_save, maps](const QString& file) {
    say(to_save ? "Saving the map." : "Loading the map.", teleop::Severity::kActive);
    if (!to_save) return emit loadAsked(file);
    if (QFileInfo(file).absolutePath() == maps) QDir().mkpath(maps);
    emit saveAsked(file.endsWith(".yaml") ? file.chopped(5) : file);
  });
  dialog->setModal(false);
  dialog->show();
}

void MapCard::aim(bool on) {
  picture_->setAiming(on);
  say(on ? kAiming : kIntroduction, on ? teleop::Severity::kActive : teleop::Severity::kIdle);
  if (on) picture_->setFocus();  // so that Esc reaches it
}

void MapCard::sayNotDone() { say("Not done, because the window was frozen: click again.", teleop::Severity::kWarning); }

void MapCard::say(const QString& text, teleop::Severity severity) {
  message_->setFullText(text);
  dot_->setSeverity(severity);
}

void MapCard::setState(const teleop::OperatorState& state) {
  const auto enable = [](QPushButton* button, bool on, const char* why_not) {
    button->setEnabled(on);
    button->setToolTip(on ? QString() : QString(why_not));
  };
  stopped_ = state.emergency_stop.value_or(false);
  const bool takes_goals = state.navigate.server_up && !stopped_;
  const char* why_not = stopped_ ? kStopped : "The navigation is down, or does not respond.";
  enable(go_, takes_goals, why_not);
  enable(return_, takes_goals, why_not);
  if (takes_goals) return_->setToolTip("Pause the explorer, and drive to the origin of the map.");
  enable(save_, state.save_map_up, "mapper/save_map is down.");
  enable(load_, state.load_map_up, "mapper/load_map is down.");
  if (!takes_goals) go_->setChecked(false);
  showWaypoints(state);
  if (state.map_answer.count == answers_) return;
  answers_ = state.map_answer.count;
  say(QString::fromStdString(state.map_answer.text),
      state.map_answer.success ? teleop::Severity::kGood : teleop::Severity::kError);
}

void MapCard::showWaypointCount() {
  const int count = static_cast<int>(picture_->waypoints().size());
  follow_->setText(count == 0 ? QString("Follow points")
                              : QString(count == 1 ? "Follow %1 point" : "Follow %1 points").arg(count));
  follow_->setEnabled(count > 0 && follower_up_ && !stopped_);
  follow_->setToolTip(stopped_        ? kStopped
                      : !follower_up_ ? "waypoint_follower is down, or does not respond."
                                      : "Add waypoints with the Shift key and a click on the map.");
  forget_->setEnabled(count > 0);
}

void MapCard::showWaypoints(const teleop::OperatorState& state) {
  follower_up_ = state.waypoints.server_up;
  showWaypointCount();
  const std::string& news = state.waypoints.active ? state.waypoints.feedback : state.waypoints.result;
  if (news == waypoints_told_) return;
  waypoints_told_ = news;
  if (news.empty()) return;
  say(QString::fromStdString("Waypoints: " + news),
      state.waypoints.active ? teleop::Severity::kActive : teleop::Severity::kIdle);
}

void MapCard::setView(const teleop::MapView& view) {
  picture_->setView(view);
  const bool has_map = !picture_->image().empty();
  setRemark(has_map ? sizeOf(picture_->image().geometry()) : QString("no map"),
            view.scene.problem.empty() ? teleop::Severity::kIdle : teleop::Severity::kWarning);
}

}  // namespace frontier_pilot::gui
