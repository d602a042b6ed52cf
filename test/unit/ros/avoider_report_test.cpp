#include "ros/obstacle_avoider/avoider_report.h"

#include <gtest/gtest.h>

namespace frontier_pilot {
namespace {

using Status = diagnostic_updater::DiagnosticStatusWrapper;

Status diagnosticsIn(avoid::AvoiderState state, const char* reason) {
  avoid::AvoiderSnapshot snapshot;
  snapshot.state = state;
  snapshot.reason = reason;
  Status status;
  fillDiagnostics(snapshot, status);
  return status;
}

TEST(AvoiderReport, ToBeSwitchedOffIsNoWarningAndIsSaid) {
  const Status status = diagnosticsIn(avoid::AvoiderState::kIdle, "switched off");
  EXPECT_EQ(status.level, Status::OK);
  EXPECT_EQ(status.message, "idle: switched off");
}

TEST(AvoiderReport, ToWaitForAScanIsAWarningAndToBeStuckAnError) {
  EXPECT_EQ(diagnosticsIn(avoid::AvoiderState::kWaiting, "no scan yet").level, Status::WARN);
  EXPECT_EQ(diagnosticsIn(avoid::AvoiderState::kStuck, "no room").level, Status::ERROR);
}

}  // namespace
}  // namespace frontier_pilot
