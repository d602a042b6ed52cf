#include "ros/map_log/bag_choice.h"

#include <nav_msgs/Odometry.h>
#include <rosbag/query.h>
#include <rosbag/view.h>
#include <sensor_msgs/LaserScan.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "frontier_pilot/core/geometry.h"
#include "ros/common/names.h"

namespace frontier_pilot {
namespace {

constexpr double kFew = 0.1;         // a topic with a smaller share of the most frequent one's messages is not chosen
constexpr double kSameField = 10.0;  // [deg]: fields of view are compared in steps of this
constexpr double kNotable = 1.0;     // [s]

struct Candidate {
  double field = 0.0;  ///< of view, for scans [deg]
  std::size_t messages = 0;
  std::vector<double> leads;  ///< how far stamps are ahead of the times of recording [s]
};
using Candidates = std::map<std::string, Candidate>;

double degreesOf(const sensor_msgs::LaserScan& scan) {
  const double gaps = scan.ranges.empty() ? 0.0 : static_cast<double>(scan.ranges.size() - 1);
  return std::abs(scan.angle_increment) * gaps * 180.0 / kPi;
}
double degreesOf(const nav_msgs::Odometry&) { return 0.0; }

/// The topics of one type, with messages that can be read.
template <class Msg>
Candidates candidates(const rosbag::Bag& bag) {
  constexpr std::size_t kSamples = 50;  // of the lead: reading all messages would take as long as mapping them
  Candidates found;
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::DataType<Msg>::value()));
  for (const rosbag::MessageInstance& message : view) {
    Candidate& candidate = found[message.getTopic()];
    if (++candidate.messages > kSamples) continue;
    const auto msg = message.instantiate<Msg>();
    if (!msg) continue;
    candidate.field = std::max(candidate.field, degreesOf(*msg));
    if (!msg->header.stamp.isZero())
      candidate.leads.push_back(msg->header.stamp.toSec() - message.getTime().toSec());  // a ros::Duration may overflow
  }
  return found;
}

/// The best topic; `found` must not be empty.
std::string best(const Candidates& found, const char* usual_name) {
  std::size_t most = 0;
  for (const auto& [name, candidate] : found) most = std::max(most, candidate.messages);
  const auto rank = [&](const auto& entry) {
    const Candidate& candidate = entry.second;
    const bool often = static_cast<double>(candidate.messages) >= kFew * static_cast<double>(most);
    return std::make_tuple(often, std::floor(candidate.field / kSameField + 0.5), isSameTopic(entry.first, usual_name),
                           candidate.messages, entry.first);
  };
  return std::max_element(found.begin(), found.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); })
      ->first;
}

std::string describeScans(const Candidates& found, const std::string& chosen) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(0) << "scans from " << chosen << ": of " << found.size()
       << " LaserScan topics the widest field of view, " << found.at(chosen).field << " deg, "
       << found.at(chosen).messages << " scans; not ";
  const char* separator = "";
  for (const auto& [name, candidate] : found) {
    if (name == chosen) continue;
    text << separator << name << " (" << candidate.field << " deg, " << candidate.messages << " scans)";
    separator = ", ";
  }
  text << "; --scan chooses another";
  return text.str();
}

std::string describeOdometry(const Candidates& found, const std::string& chosen) {
  std::string text = "odometry from " + chosen + ", not ";
  const char* separator = "";
  for (const auto& [name, candidate] : found) {
    if (name == chosen) continue;
    text += separator + name;
    separator = ", ";
  }
  return text + "; --odom chooses another";
}

void noteLead(std::vector<double> leads, std::vector<std::string>& words) {
  if (leads.empty()) return;
  std::sort(leads.begin(), leads.end());
  const double lead = leads[leads.size() / 2];
  if (std::abs(lead) < kNotable) return;
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "stamps are " << std::abs(lead) << " s "
       << (lead > 0.0 ? "ahead of" : "behind") << " the time of recording: the clock follows the stamps";
  words.push_back(text.str());
}

}  // namespace

bool isSameTopic(const std::string& a, const std::string& b) {
  const auto bare = [](const std::string& text) {
    return text.substr(std::min(text.find_first_not_of('/'), text.size()));
  };
  return !bare(b).empty() && bare(a) == bare(b);
}

BagChoice chooseTopics(const rosbag::Bag& bag, const tools::BagTopics& wanted) {
  BagChoice choice{wanted, {}};
  const Candidates scans = candidates<sensor_msgs::LaserScan>(bag);
  if (wanted.scan.empty()) choice.topics.scan = scans.empty() ? names::kScan : best(scans, names::kScan);
  if (wanted.scan.empty() && scans.size() > 1) choice.words.push_back(describeScans(scans, choice.topics.scan));
  if (wanted.odom.empty()) {
    const Candidates odometry = candidates<nav_msgs::Odometry>(bag);
    Candidates usual = odometry;
    for (auto& [name, candidate] : usual) {
      if (isSameTopic(name, names::kOdom)) candidate.field = 360.0;  // the usual name counts more than the number
    }
    choice.topics.odom = odometry.empty() ? names::kOdom : best(usual, names::kOdom);
    if (odometry.size() > 1) choice.words.push_back(describeOdometry(odometry, choice.topics.odom));
  }
  for (const auto& [name, candidate] : scans) {
    if (isSameTopic(name, choice.topics.scan)) noteLead(candidate.leads, choice.words);
  }
  return choice;
}

std::vector<std::string> describeHoles(const std::string& what, std::vector<double> stamps) {
  constexpr double kLeastHole = 2.0;  // [s]
  constexpr double kUsualGaps = 10.0;
  if (stamps.size() < 2) return {};
  std::sort(stamps.begin(), stamps.end());
  std::vector<double> gaps;
  for (std::size_t i = 1; i < stamps.size(); ++i) gaps.push_back(stamps[i] - stamps[i - 1]);
  std::vector<double> sorted = gaps;
  std::sort(sorted.begin(), sorted.end());
  const double least = std::max(kLeastHole, kUsualGaps * sorted[sorted.size() / 2]);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (gaps[i] < least) continue;
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << what << ": nothing for " << gaps[i] << " s from "
         << stamps[i] - stamps.front() << " s on";
    words.push_back(text.str());
  }
  return words;
}

}  // namespace frontier_pilot
