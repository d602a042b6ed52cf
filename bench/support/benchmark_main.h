#pragma once

namespace frontier_pilot::bench {

/// What the program measures, for --help; each benchmark of Google Benchmark defines it.
extern const char* const kPurpose;

}  // namespace frontier_pilot::bench
