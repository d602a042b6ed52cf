#include "ros/common/callback_guard.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace frontier_pilot {
namespace {

using Status = diagnostic_updater::DiagnosticStatusWrapper;

std::string valueOf(const Status& status, const std::string& key) {
  for (const auto& entry : status.values) {
    if (entry.key == key) return entry.value;
  }
  return "";
}

// [FLT-1]
TEST(CallbackGuard, LetsNoExceptionOutAndCountsItByWhatCameIn) {
  CallbackGuard guard;
  EXPECT_TRUE(guard.run("scan", [] {}));
  EXPECT_FALSE(guard.run("scan", [] { throw std::runtime_error("Time is out of dual 32-bit range"); }));
  EXPECT_FALSE(guard.run("scan", [] { throw std::logic_error("never"); }));
  EXPECT_FALSE(guard.run("odom", [] { throw 7; }));  // NOLINT(hicpp-exception-baseclass): it may be anything
  EXPECT_EQ(guard.total(), 3U);
  Status status;
  guard.report(status);
  EXPECT_EQ(valueOf(status, "exceptions caught"), "3");
  EXPECT_EQ(valueOf(status, "exceptions in scan"), "2, the latest: never");
  EXPECT_EQ(valueOf(status, "exceptions in odom"), "1, the latest: an exception of unknown type");
}

TEST(CallbackGuard, WarnsWhileAnExceptionIsRecent) {
  CallbackGuard guard;
  Status status;
  status.summary(Status::OK, "ready");
  guard.report(status);
  EXPECT_EQ(status.level, Status::OK);
  guard.run("scan", [] { throw std::runtime_error("no"); });
  guard.report(status);
  EXPECT_EQ(status.level, Status::WARN);
}

// [FLT-1] What is thrown quotes what came in.
TEST(CallbackGuard, ShowsTextsWithoutControlCharactersAndCutsThem_FLT_1) {
  CallbackGuard guard;
  Status status;
  guard.run("scan", [] { throw std::runtime_error("frame 'a\nb'" + std::string(100000, 'x')); });
  guard.report(status);
  const std::string said = valueOf(status, "exceptions in scan");
  EXPECT_EQ(said.find(R"(1, the latest: frame 'a\nb'x)"), 0U) << said;
  EXPECT_LT(said.size(), 300U);
}

}  // namespace
}  // namespace frontier_pilot
