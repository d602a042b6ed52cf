#include "slam/back_end/refinement.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

void note(slam::Refinement& refinement, int steps, bool weak) {
  slam::KeyframeStep step;
  step.weak = weak;
  for (int i = 0; i < steps; ++i) refinement.note(step);
}

TEST(Refinement, IsNeverDueWhereScansMatch) {
  slam::Refinement refinement;
  note(refinement, 5000, false);
  EXPECT_FALSE(refinement.isDue());
  note(refinement, 50, true);
  EXPECT_FALSE(refinement.isDue()) << "a hole in the scans now and then";
}

TEST(Refinement, IsDueWhenADriveWithWeakStepsHasGrownByAShare) {
  slam::Refinement refinement;
  note(refinement, 29, true);
  EXPECT_FALSE(refinement.isDue()) << "too little to bend";
  note(refinement, 71, false);
  EXPECT_TRUE(refinement.isDue());
  slam::SubmapGraph graph;
  slam::LoopCloser closer;
  EXPECT_TRUE(refinement.refine(graph, closer).empty());
  note(refinement, 14, false);
  EXPECT_FALSE(refinement.isDue());
  note(refinement, 1, false);
  EXPECT_TRUE(refinement.isDue());
}

}  // namespace
}  // namespace frontier_pilot
