#include <QScrollBar>
#include <QTime>
#include <QVBoxLayout>

#include "gui/cards/cards.h"

namespace frontier_pilot::gui {
namespace {

constexpr int kMostLines = 300;

}  // namespace

LogCard::LogCard(QWidget* parent) : Card("Log", parent), text_(new QPlainTextEdit) {
  text_->setObjectName("log");
  text_->setReadOnly(true);
  text_->setFocusPolicy(Qt::ClickFocus);
  text_->setMaximumBlockCount(kMostLines);
  text_->setMinimumHeight(emOf(*this) * 6);
  text_->setFrameShape(QFrame::NoFrame);
  content()->addWidget(text_, 1);
}

void LogCard::append(const teleop::OperatorLogLine& line) {
  const Theme theme = Theme::current();
  const bool quiet = line.severity == teleop::Severity::kIdle || line.severity == teleop::Severity::kActive;
  const QColor color = quiet ? theme.text : theme.color(line.severity);
  text_->appendHtml(QString("<span style='color:%1'>%2</span> <span style='color:%3'>%4</span>")
                        .arg(theme.muted.name(), QTime::currentTime().toString("HH:mm:ss"), color.name(),
                             QString::fromStdString(line.text).toHtmlEscaped()));
}

}  // namespace frontier_pilot::gui
