#include "ros/common/messages/stop_words.h"

namespace frontier_pilot {
namespace {

constexpr const char* kMayBeUnsent = "the zero velocity may not have been sent yet";
constexpr const char* kSignature = "(answered by ";
constexpr const char* kUnsigned = "is not signed by an arbiter";

bool contains(const std::string& text, const char* words) { return text.find(words) != std::string::npos; }

}  // namespace

std::string answerOfStop(const std::string& said, bool sent) {
  return sent ? said : said + ", but " + kMayBeUnsent + ": make sure that the robot stands";
}

bool mayBeUnsent(const std::string& answer) { return contains(answer, kMayBeUnsent); }

std::string signatureOf(const std::string& node) { return kSignature + node + ")"; }

std::string withoutSignature(const std::string& answer) {
  const std::size_t end = answer.rfind(kSignature);
  return end == std::string::npos || end == 0 ? answer : answer.substr(0, end - 1);
}

bool isSigned(const std::string& answer) { return contains(answer, kSignature); }

std::string unsignedAnswerOf(const std::string& who) {
  return "the answer of " + who + " " + kUnsigned + ": make sure that the robot stands";
}

bool leavesDoubt(const std::string& answer) { return mayBeUnsent(answer) || contains(answer, kUnsigned); }

}  // namespace frontier_pilot
