#include <QResizeEvent>
#include <QVBoxLayout>

#include "gui/cards/cards.h"
#include "gui/cards/map_card.h"
#include "gui/cards/scan_card.h"
#include "gui/pilot_widget.h"

/// In how many columns the cards stand, and which stands where.
namespace frontier_pilot::gui {
namespace {

// The least width for two, three and four columns, in line heights.
constexpr int kTwoColumns = 38, kThreeColumns = 54, kFourColumns = 84;

}  // namespace

/// The cards of each column, from the left; the last columns may be empty.
std::vector<std::vector<QWidget*>> PilotWidget::planOf(int columns) const {
  if (columns == 1) {
    return {{drive_card_, sources_card_, scan_card_, patrol_card_, spin_card_, map_card_, navigation_card_,
             explorer_card_, log_card_},
            {},
            {},
            {}};
  }
  if (columns == 2) {
    return {{drive_card_, scan_card_, patrol_card_, spin_card_, log_card_},
            {map_card_, navigation_card_, sources_card_, explorer_card_},
            {},
            {}};
  }
  if (columns == 3) {
    return {{drive_card_, scan_card_, spin_card_},
            {map_card_, navigation_card_, log_card_},
            {sources_card_, explorer_card_, patrol_card_},
            {}};
  }
  return {{drive_card_, patrol_card_, spin_card_},
          {scan_card_, navigation_card_},
          {map_card_, log_card_},
          {sources_card_, explorer_card_}};
}

void PilotWidget::layOut(int columns) {
  if (columns == columns_) return;
  columns_ = columns;
  const std::vector<std::vector<QWidget*>> plan = planOf(columns);
  for (QVBoxLayout* layout : column_layouts_) {
    while (QLayoutItem* item = layout->takeAt(0)) delete item;
  }
  for (std::size_t i = 0; i < plan.size(); ++i) {
    for (QWidget* card : plan[i]) {
      const bool grows = card == log_card_ || (columns > 1 && (card == scan_card_ || card == map_card_));
      column_layouts_[i]->addWidget(card, grows ? (card == map_card_ ? 3 : 1) : 0);
    }
    if (!plan[i].empty() && plan[i].back() != log_card_) column_layouts_[i]->addStretch();
    const int share = columns == kMostColumns && plan[i].front() == map_card_ ? 3 : 2;
    body_->setStretch(static_cast<int>(i), plan[i].empty() ? 0 : share);
  }
}

void PilotWidget::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int width = event->size().width() / emOf(*this);
  layOut(width >= kFourColumns ? 4 : (width >= kThreeColumns ? 3 : (width >= kTwoColumns ? 2 : 1)));
}

}  // namespace frontier_pilot::gui
