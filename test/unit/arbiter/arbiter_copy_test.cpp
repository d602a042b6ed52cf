// A copy of an arbiter shares nothing with the original.
#include <memory>

#include "arbiter_fixture.h"

namespace frontier_pilot {
namespace {

// [ARB-2]
TEST_F(ArbiterTest, ACopyMadeWhileDrivingDoesAsTheOriginalDoes_ARB_2) {
  send("nav", 0.2);
  arbiter::Arbiter copy = arbiter;
  advance(0.01);
  EXPECT_EQ(arbiter.update(now), std::nullopt) << "nothing has changed";
  EXPECT_EQ(copy.update(now), std::nullopt) << "nothing has changed for the copy either";
  advance(1.0);
  EXPECT_EQ(arbiter.update(now), Twist2{});
  EXPECT_EQ(copy.update(now), Twist2{});
}

// [ARB-2]
TEST_F(ArbiterTest, ACopyOutlivesTheArbiterThatItWasMadeOf_ARB_2) {
  auto original = std::make_unique<arbiter::Arbiter>(arbiter::ArbiterParameters{});
  original->onCommand(*original->find("nav"), {0.2, 0.0}, now);
  arbiter::Arbiter copy = *original;
  original.reset();
  EXPECT_EQ(copy.status(now).active_source, "nav");
  EXPECT_EQ(copy.onCommand(*copy.find("nav"), {0.2, 0.0}, now), (Twist2{0.2, 0.0}));
  EXPECT_EQ(copy.update(now), std::nullopt);
}

}  // namespace
}  // namespace frontier_pilot
