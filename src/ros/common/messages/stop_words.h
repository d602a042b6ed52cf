#pragma once

#include <string>

namespace frontier_pilot {

/// The answer to a stop that said `said`, whose zero was written to the sockets in time if `sent`. The stop holds in
/// either case, so that it is a success, but where the zero was not written the base may still drive. [ARB-7]
std::string answerOfStop(const std::string& said, bool sent);
/// Whether a stop was answered with that reserve.
bool mayBeUnsent(const std::string& answer);

/// What an arbiter adds to each of its answers, so that the caller sees who has answered. [ARB-12]
std::string signatureOf(const std::string& node);
/// The answer without that.
std::string withoutSignature(const std::string& answer);
/// Whether an answer has that: without it another node may have taken the service, and then nothing is latched.
bool isSigned(const std::string& answer);
/// What is said of `who`'s answer to a stop that is not signed, with what to do about it.
std::string unsignedAnswerOf(const std::string& who);

/// Whether an answer, by the words above, leaves a doubt whether the robot stands although it is a success.
bool leavesDoubt(const std::string& answer);

}  // namespace frontier_pilot
