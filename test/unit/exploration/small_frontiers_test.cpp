#include <string>

#include "strategy_fixture.h"

namespace frontier_pilot {
namespace {

using test::Strategies;
using test::touring;

exploration::ExplorerParameters largeFirst() {
  exploration::ExplorerParameters parameters = touring();
  parameters.tour.put_off_share = 0.1;
  parameters.tour.small_area = 0.3;
  parameters.tour.small_detour = parameters.tour.detour_per_area = 0.0;
  return parameters;
}

/// A corridor of `rows` cells with a niche on the left, nearer to the robot at column `robot` than the open end on the
/// right.
std::string nicheAndOpenEnd(int rows, std::size_t robot) {
  constexpr std::size_t kLength = 73;
  const std::string unknown(16, '?');
  std::string drawing = "#" + std::string(kLength, '#') + unknown + "\n";
  for (int row = 0; row < rows; ++row) {
    std::string floor(kLength, '.');
    if (row == rows / 2 - 1) floor[2] = 'n', floor[kLength - 2] = 'w';
    if (row == rows / 2) floor[robot] = 'r';
    drawing += "#" + floor + unknown + "\n";
  }
  return drawing + "##??????" + std::string(kLength - 7, '#') + unknown + "\n##??????##\n##??????##\n##########\n";
}

// [EXP-9]
TEST_F(Strategies, ASmallNicheWaitsForWhatIsLarge_EXP_9) {
  const std::string roomy = nicheAndOpenEnd(11, 33);
  const auto at_once = choose(roomy);
  ASSERT_TRUE(at_once);
  EXPECT_LT(distanceTo(*at_once, 'n'), distanceTo(*at_once, 'w'));
  strategy.reset();
  const auto later = choose(roomy, largeFirst());
  ASSERT_TRUE(later);
  EXPECT_LT(distanceTo(*later, 'w'), distanceTo(*later, 'n'));
}

// [EXP-9]
TEST_F(Strategies, ANicheOfAPassageDoesNotWaitBecauseAnythingMayLieBehindIt_EXP_9) {
  const auto goal = choose(nicheAndOpenEnd(7, 25), largeFirst());
  ASSERT_TRUE(goal);
  EXPECT_LT(distanceTo(*goal, 'n'), distanceTo(*goal, 'w'));
}

/// A room with a niche, and nothing else to see.
constexpr const char* kRoomWithANiche = R"(
  ##############################
  #............................#
  #............................#
  #............................#
  #............................#
  #..r.........................#
  #............................#
  #............................#
  #............................#
  #............................#
  #............................#
  #############????#############
              #????#
              ######
)";

// [EXP-9]
TEST_F(Strategies, ASmallNicheIsSeenInTheEndUnlessItIsLittleOfTheFloor_EXP_9) {
  exploration::ExplorerParameters parameters = largeFirst();
  EXPECT_TRUE(choose(kRoomWithANiche, parameters));
  strategy.reset();
  parameters.tour.left_share = 0.1;
  EXPECT_FALSE(choose(kRoomWithANiche, parameters));
  ASSERT_EQ(evaluator.frontiers().size(), 1U);
  EXPECT_STREQ(toString(evaluator.frontiers().front().rejection), "in a small corner not worth a trip");
}

// [EXP-9]
TEST_F(Strategies, ADoorIsNeverLeftHoweverLittleTheRestIs_EXP_9) {
  exploration::ExplorerParameters parameters = largeFirst();
  parameters.tour.left_share = 1.0;
  EXPECT_TRUE(choose(R"(
    ##############################
    #............................#
    #............................#
    #............................#
    #.........r..................#
    #............................#
    #............................#
    #............................#
    #............................#
    #............................#
    ###########.........##########
    ??????????????????????????????
    ??????????????????????????????
    ??????????????????????????????
    ??????????????????????????????
    ??????????????????????????????
    ??????????????????????????????
    ??????????????????????????????
    ??????????????????????????????
    ??????????????????????????????
    ??????????????????????????????
  )",
                     parameters));
}

}  // namespace
}  // namespace frontier_pilot
