#include "map_fixture.h"

namespace frontier_pilot {
namespace {

using test::blockOf;
using test::MapInTheWindow;
using test::mapOf;
using test::viewOf;

// [GUI-2]
TEST_F(MapInTheWindow, IsDrawnWithItsWallsAndWhatChangesInIt) {
  const teleop::MapChange map = mapOf(60, 60, kFree);
  widget_->setMap(viewOf(map));
  const QColor free = colorAt(4.0, 2.0);
  widget_->setMap(viewOf(blockOf(map, {38, 18, 6, 6}, kOccupied)));
  EXPECT_LT(colorAt(4.05, 2.05).lightness(), free.lightness() - 80);
  EXPECT_EQ(colorAt(4.0, 4.0), free) << "nothing else has changed";
}

// [GUI-2]
TEST_F(MapInTheWindow, ShowsThinWallsOfAMapThatIsMuchLargerThanThePicture) {
  const teleop::MapChange map = mapOf(4000, 4000, kFree);
  widget_->setMap(viewOf(map));
  const QColor free = colorAt(200.0, 100.0);
  widget_->setMap(viewOf(blockOf(map, {0, 2000, 4000, 1}, kOccupied)));
  const QImage image = picture().grab().toImage();
  const int column = pixelOf(100.0, 200.0).x(), row = pixelOf(100.0, 200.0).y();
  int darkest = 255;
  for (int y = row - 3; y <= row + 3; ++y) darkest = std::min(darkest, image.pixelColor(column, y).lightness());
  EXPECT_LT(darkest, free.lightness() - 80);
}

// [GUI-2]
TEST_F(MapInTheWindow, MayChangeItsSizeAndShrinks) {
  widget_->setMap(viewOf(mapOf(60, 60, kFree)));
  widget_->setMap(viewOf(mapOf(101, 33, kUnknown)));
  EXPECT_EQ(picture().image().geometry().width, 101);
  EXPECT_EQ(picture().image().at({100, 32}), kUnknown);
  widget_->setMap(viewOf(mapOf(1, 1, kOccupied)));
  EXPECT_EQ(picture().image().at({0, 0}), kOccupied);
  picture().grab();
}

// [FLT-1]
TEST_F(MapInTheWindow, LeavesOutChangesThatDoNotFit) {
  const teleop::MapChange map = mapOf(10, 10, kFree);
  teleop::MapChange beyond = blockOf(map, {5, 5, 6, 1}, kOccupied), short_of = blockOf(map, {0, 0, 3, 3}, kOccupied);
  widget_->setMap(viewOf(beyond));
  EXPECT_TRUE(picture().image().empty());
  widget_->setMap(viewOf(map));
  short_of.cells.pop_back();
  for (const teleop::MapChange& change : {beyond, short_of}) widget_->setMap(viewOf(change));
  EXPECT_EQ(picture().image().at({5, 5}), kFree);
  EXPECT_EQ(picture().image().at({0, 0}), kFree);
}

// [GUI-2]
TEST_F(MapInTheWindow, SaysInWordsWhatIsMissing) {
  teleop::MapView view;
  view.scene.problem = "No map: nobody publishes /map.";
  const QImage before = picture().grab().toImage();
  widget_->setMap(view);
  EXPECT_NE(picture().grab().toImage(), before);
  EXPECT_FALSE(picture().scene().problem.empty());
}

}  // namespace
}  // namespace frontier_pilot
