// Has one defect of the kind that is asked for, so that scripts/sanitize knows that it would be told of one.
#include <cstdlib>
#include <iostream>
#include <limits>
#include <string>
#include <thread>

namespace {

int g_shared = 0;

void raceForIt() {
  std::thread other([] { ++g_shared; });
  ++g_shared;
  other.join();
}

void useAfterFree() {
  const volatile int* const number = new int(1);
  delete number;
  std::cout << *number;
}

void leak() {
  volatile int* number = new int(1);
  number = nullptr;
  static_cast<void>(number);
}

void castOutOfRange() {
  volatile double number = std::numeric_limits<double>::quiet_NaN();
  std::cout << static_cast<int>(number);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string defect = argc == 2 ? argv[1] : "";
  if (defect == "race") raceForIt();
  if (defect == "use") useAfterFree();
  if (defect == "leak") leak();
  if (defect == "cast") castOutOfRange();
  return EXIT_SUCCESS;
}
