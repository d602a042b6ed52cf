#include <QGridLayout>
#include <QVBoxLayout>

#include "gui/cards/cards.h"

namespace frontier_pilot::gui {
namespace {

QString figuresOf(const teleop::SourceView& source) {
  if (!source.age) return "no message";
  if (source.rate >= 0.5 && *source.age < 1.0) {
    return QString("%1 Hz   %2").arg(source.rate, 0, 'f', 0).arg(ageText(*source.age));
  }
  return ageText(*source.age) + " ago";
}

}  // namespace

SourcesCard::SourcesCard(QWidget* parent) : Card("Who may drive", parent), empty_(makeLabel("", "muted", true)) {
  content()->addWidget(empty_);
}

void SourcesCard::setState(const teleop::OperatorState& state) {
  const bool silent = !state.arbiter || state.arbiter->status_age > teleop::kStatusLifetime;
  empty_->setText(state.arbiter ? "" : "The arbiter (cmd_vel_arbiter) is down: no source is known.");
  empty_->setVisible(!state.arbiter);
  setRemark(silent ? "arbiter silent" : "highest first", silent ? teleop::Severity::kError : teleop::Severity::kIdle);
  const std::vector<teleop::SourceView> none;
  const std::vector<teleop::SourceView>& sources = state.arbiter ? state.arbiter->sources : none;
  const auto same = [](const Row& row, const teleop::SourceView& source) {
    return row.name == QString::fromStdString(source.name);
  };
  if (!std::equal(rows_.begin(), rows_.end(), sources.begin(), sources.end(), same)) rebuild(sources);
  for (std::size_t i = 0; i < rows_.size(); ++i) fill(rows_[i], sources[i], silent);
}

void SourcesCard::rebuild(const std::vector<teleop::SourceView>& sources) {
  for (const Row& row : rows_) row.widget->deleteLater();
  rows_.clear();
  for (const teleop::SourceView& source : sources) {
    const QString name = QString::fromStdString(source.name);
    Row row{name, new QWidget, new Switch("enable_" + name), new Dot, new ElidedLabel("muted"), nullptr};
    row.figures = makeLabel("", "muted");
    auto* grid = new QGridLayout(row.widget);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(emOf(*this) / 2);
    grid->setVerticalSpacing(0);
    grid->addWidget(row.toggle, 0, 0, 2, 1);
    grid->addWidget(row.dot, 0, 1);
    grid->addWidget(makeLabel(name, "strong"), 0, 2);
    grid->addWidget(row.figures, 0, 3, Qt::AlignRight);
    grid->addWidget(row.text, 1, 2, 1, 2);
    grid->setColumnStretch(3, 1);
    row.text->setObjectName("source_state_" + name);
    row.figures->setObjectName("source_age_" + name);
    connect(row.toggle, &Switch::asked, this, [this, name](bool on) { emit enableAsked(name, on); });
    content()->addWidget(row.widget);
    rows_.push_back(row);
  }
}

void SourcesCard::fill(const Row& row, const teleop::SourceView& source, bool silent) const {
  const bool available = source.service_up && !silent;
  row.toggle->setShown(source.enabled, available, "set_" + row.name + "_enabled is down");
  row.dot->setSeverity(silent ? teleop::Severity::kIdle : source.severity);
  QString text = QString::fromStdString(source.state_text);
  if (source.required) text += " (required)";
  if (source.rejected > 0) text += QString(", %1 rejected").arg(source.rejected);
  if (!available) text = silent ? "unknown" : "switch is down, " + text;
  row.text->setFullText(text);
  row.figures->setText(silent ? "" : figuresOf(source));
}

}  // namespace frontier_pilot::gui
