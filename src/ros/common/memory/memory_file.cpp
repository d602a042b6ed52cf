#include "ros/common/memory/memory_file.h"

#include <sys/stat.h>

#include <algorithm>
#include <iterator>
#include <sstream>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/text.h"

namespace frontier_pilot {
namespace {

constexpr std::size_t kLongestText = 262144;  // [bytes], of a file

}  // namespace

std::string memoryFileWith(const std::string& text) {
  std::ostringstream content;
  content << printable(text, kLongestText / 2) << '\n' << ProcessIdentity::own();
  return content.str();
}

std::string textIn(const std::filesystem::path& file) {
  const std::string text = readFile(file, kLongestText).bytes;
  return printable(text.substr(0, text.find('\n')), kLongestText);
}

std::vector<std::string> textsIn(const std::vector<std::filesystem::path>& files) {
  std::vector<std::string> texts;
  std::transform(files.begin(), files.end(), std::back_inserter(texts), textIn);
  std::stable_partition(texts.begin(), texts.end(), [](const std::string& text) { return !text.empty(); });
  return texts;
}

ProcessIdentity writerOf(const std::filesystem::path& file) {
  std::istringstream content(readFile(file, kLongestText).bytes);
  content.ignore(kLongestText, '\n');
  ProcessIdentity writer;
  content >> writer;
  return writer;
}

std::time_t timeOf(const std::filesystem::path& file) {
  struct stat status {};
  return stat(file.c_str(), &status) == 0 ? status.st_mtim.tv_sec : 0;
}

}  // namespace frontier_pilot
