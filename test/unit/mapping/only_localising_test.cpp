#include <gtest/gtest.h>

#include "frontier_pilot/localization/map_localization.h"

namespace frontier_pilot {
namespace {

/// Localises on a map that shows nothing, and leaves it as it is.
class OnlyLocalising : public ::testing::Test {
 protected:
  occupancy::OccupancyMap nothing_known;
  localization::MapLocalization localization{
      localization::MapLocalization::Use::kLocalizeOnly, {}, nothing_known, {}, {}};
};

TEST_F(OnlyLocalising, HasNothingToRevise) {
  EXPECT_FALSE(localization.takeWork());
  EXPECT_FALSE(localization.accept({}));
  EXPECT_FALSE(localization.refuse({}));
  localization.abandonWork();
  EXPECT_TRUE(localization.trajectory().empty());
  EXPECT_EQ(localization.keyframes(), 0U);
}

TEST_F(OnlyLocalising, SaysWhyTheRobotIsNotFound_MAP_5) {
  const slam::CorrectedScan corrected = localization.correct(surfaces::SurfaceScan(), Pose2(), nothing_known);
  EXPECT_STREQ(corrected.text, "not localised: there is no map to localise on");
  EXPECT_FALSE(corrected.sound);
}

}  // namespace
}  // namespace frontier_pilot
