#pragma once

#include <ros/console.h>
#include <ros/time.h>

#include <string>
#include <utility>
#include <vector>

namespace frontier_pilot {

/// What is logged as long as this object lives.
class LogLines : public ros::console::LogAppender {
 public:
  using Line = std::pair<ros::console::Level, std::string>;

  LogLines() {
    ros::Time::init();
    ros::console::register_appender(this);
  }
  ~LogLines() override { ros::console::deregister_appender(this); }
  LogLines(const LogLines&) = delete;
  LogLines& operator=(const LogLines&) = delete;

  void log(ros::console::Level level, const char* text, const char*, const char*, int) override {
    lines.emplace_back(level, text);
  }

  std::vector<Line> lines;
};

}  // namespace frontier_pilot
