#pragma once

#include <string>

namespace frontier_pilot {

/// A name that one process of this computer can have at a time, for as long as it lives: the kernel gives it back when
/// the process ends, however it ends. It is an abstract Unix socket, so that no file can be left behind.
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
  std::string address_;  ///< of the socket, which begins with a zero byte
  int socket_ = -1;
};

}  // namespace frontier_pilot
