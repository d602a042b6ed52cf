#include "support/progress_track.h"

#include <cmath>
#include <cstdio>

namespace frontier_pilot::bench {

void ProgressTrack::add(double time, const exploration::ExplorerProgress& progress) {
  samples_.push_back({time, progress});
}

std::string ProgressTrack::text() const {
  std::string text = "    estimate";
  for (const double share : {0.25, 0.5, 0.75}) text += textAt(share);
  return text;
}

std::string ProgressTrack::textAt(double share) const {
  char text[100];
  std::snprintf(text, sizeof text, "  at %.0f %%: none", 100.0 * share);
  if (samples_.empty()) return text;
  const Sample& end = samples_.back();
  const Sample* at = &samples_.front();
  for (const Sample& sample : samples_) {
    if (sample.time <= share * end.time) at = &sample;
  }
  const auto& whole = at->progress.whole;
  if (!whole) return text;
  const double error = whole->area - end.progress.explored_area;
  const double time_error = whole->time_left - (end.time - at->time);
  std::snprintf(text, sizeof text, "  at %.0f %%: area %+.3f (%s), time %+.3f", 100.0 * share,
                error / end.progress.explored_area, std::abs(error) <= whole->deviation ? "within" : "beyond",
                time_error / end.time);
  return text;
}

}  // namespace frontier_pilot::bench
