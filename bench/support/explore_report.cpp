#include "support/explore_report.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <vector>

namespace frontier_pilot::bench {
namespace {

std::string format(const char* pattern, ...) __attribute__((format(printf, 1, 2)));

std::string format(const char* pattern, ...) {
  char line[400];
  va_list arguments;
  va_start(arguments, pattern);
  std::vsnprintf(line, sizeof(line), pattern, arguments);
  va_end(arguments);
  return line;
}

}  // namespace

const std::vector<double>& ExploreReport::levels() {
  static const std::vector<double> levels = {0.5, 0.8, 0.9, 0.95, 0.97, 0.99};
  return levels;
}

void ExploreReport::reach(double share, double t) {
  while (reached_.size() < levels().size() && share >= levels()[reached_.size()]) reached_.push_back(t);
}

std::string ExploreReport::header(bool with_tour) {
  const std::string columns =
      "world         seed explored  wrong    T50    T80    T90    T95    T97    T99    end [s]   dist contacts "
      "goals "
      "  x real | cpu per simulated s [ms]: sim  map  nav  expl  arb | hash             end";
  return columns + (with_tour ? "                            tour dist/tour" : "");
}

std::string ExploreReport::text() const {
  std::string out = format("%-14s %3d  %.4f  %.4f", world.c_str(), seed, explored, wrong);
  for (std::size_t i = 0; i < levels().size(); ++i) {
    out += i < reached_.size() ? format(" %6.0f", reached_[i]) : "      -";
  }
  const double ms = 1e3 / simulated;
  out += format("  %8.1f %6.1f %8d %5d %8.1f |", simulated, distance, contacts, decisions, simulated / cpu);
  out += format("                   %8.2f %4.2f %4.2f %5.2f %4.2f |", ms * times.simulator, ms * times.mapper,
                ms * times.navigator, ms * times.explorer, ms * times.arbiter);
  out += format(" %016llx ", static_cast<unsigned long long>(hash));
  out += tour ? format("%-27s %7.1f %9.2f", end.c_str(), *tour, distance / *tour) : end;
  return out + (standing ? format("; stood without a reason for %.1f s", *standing) : "");
}

std::string ExploreReport::decisionText() const {
  std::vector<double> sorted = times.decisions;
  if (sorted.empty()) return "no decision";
  std::sort(sorted.begin(), sorted.end());
  const auto ms = [&](double share) {
    return 1e3 * sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  };
  return format("%zu decisions: median %.2f ms, 99th percentile %.2f ms, longest %.2f ms", sorted.size(), ms(0.5),
                ms(0.99), ms(1.0));
}

}  // namespace frontier_pilot::bench
