#pragma once

#include <array>
#include <string>

namespace frontier_pilot {

/// A name that one process of this computer can have at a time, for as long as it lives: the kernel gives it back when
/// the process ends, however it ends. It is an abstract Unix socket, so that no file can be left behind. Such sockets
/// have no permissions: another user of the computer can take the name, too, as anybody can who reaches a ROS master.
class LocalName {
 public:
  explicit LocalName(const std::string& name);
  ~LocalName();
  LocalName(const LocalName&) = delete;
  LocalName& operator=(const LocalName&) = delete;

  /// Takes the name. False if another process has it; true also if the system does not offer such names.
  bool take();
  /// The process that has the name; 0 if it is not known.
  int owner() const;

 private:
  std::string name_;
  std::array<int, 2> sockets_{-1, -1};  ///< one has the name, the other one the name with the number of the process
};

}  // namespace frontier_pilot
