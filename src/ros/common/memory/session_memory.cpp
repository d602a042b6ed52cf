#include "ros/common/memory/session_memory.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <ctime>
#include <iterator>
#include <system_error>
#include <utility>

#include "frontier_pilot/core/files.h"
#include "frontier_pilot/core/text.h"
#include "ros/common/memory/disk.h"
#include "ros/common/memory/memory_file.h"

namespace frontier_pilot {
namespace {

std::string asFileName(std::string name) {
  std::replace(name.begin(), name.end(), '/', '.');
  return name;
}

/// Whether a folder of this name lies where it is put: the run id is a parameter, which anybody can set. [FLT-1]
bool isPlainName(const std::string& session) {
  constexpr std::size_t kLongestName = 200;  // [bytes], of the 255 that a file system takes
  return !session.empty() && session.front() != '.' && session.find('/') == std::string::npos &&
         printable(session, kLongestName) == session;
}

namespace fs = std::filesystem;

/// The time of a file whose writer has ended in order. It is not kept in the file, because the disk may be full.
constexpr timespec kEndedInOrder{0, 0};
constexpr std::time_t kRestart = 10;     // [s], within which roslaunch restarts a node that has died
constexpr std::time_t kLongAgo = 86400;  // [s]: nobody is about to write into a folder that was made before that
const std::time_t g_process_began = std::time(nullptr);

constexpr const char* kOfProcess = "~";  // separates the process id; cannot occur within a ROS name
constexpr const char* kDigits = "0123456789";
constexpr const char* kLasting = "lasting_";  // before the names of the files of lasting nodes

void append(std::vector<fs::path>& files, const std::vector<fs::path>& more) {
  files.insert(files.end(), more.begin(), more.end());
}

/// Whether one of `files` lies in `folder`.
bool isSessionOf(const fs::path& folder, const std::vector<fs::path>& files) {
  return std::any_of(files.begin(), files.end(), [&](const fs::path& file) { return file.parent_path() == folder; });
}

/// Creates `folder`. Returns why a file could not be written there; empty if it could.
std::string whyNotWritable(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && access(folder.c_str(), W_OK | X_OK) != 0) error.assign(errno, std::generic_category());
  if (!error && fs::space(folder, error).available == 0) error = std::make_error_code(std::errc::no_space_on_device);
  return error ? error.message() : std::string();
}

/// Returns what went wrong; empty if nothing did.
std::string removeAll(const std::vector<fs::path>& files) {
  std::string problem;
  for (const fs::path& file : files) {
    std::error_code error;
    fs::remove(file, error);
    if (error) problem = error.message();
    rmdir(file.parent_path().c_str());  // stays unless it is empty
  }
  return problem;
}

/// Tries `attempt`, which returns what went wrong, for each of `files`. Returns why one cannot be written; empty if all
/// can.
template <class Attempt>
std::string tryAll(const std::vector<fs::path>& files, Attempt attempt) {
  std::string problem = files.empty() ? "the ROS session has no name" : "";
  for (const fs::path& file : files) {
    const std::string why = attempt(file);
    if (!why.empty()) problem = "cannot write " + file.string() + ": " + why;
  }
  return problem;
}

/// The files of `folder` that processes have written under `name`.
std::vector<fs::path> ofProcesses(const fs::path& folder, const std::string& name) {
  const std::string beginning = name + kOfProcess;
  std::vector<fs::path> found;
  for (fs::path& entry : entriesOf(folder)) {
    const std::string file = entry.filename().string();
    // A longer name is that of a temporary file, which is being written.
    const bool named = file.rfind(beginning, 0) == 0 && file.find_first_not_of(kDigits, beginning.size()) == file.npos;
    if (named) found.push_back(std::move(entry));
  }
  return found;
}

/// Those of `files` whose writers died, and in whose place this process was started: shortly before, unless `whenever`.
std::vector<fs::path> leftBehind(std::vector<fs::path> files, bool whenever) {
  const std::time_t since = whenever ? kEndedInOrder.tv_sec + 1 : g_process_began - kRestart;
  const auto is_of_another = [&](const fs::path& file) {
    return timeOf(file) < since || !writerOf(file).isReplacedByThisOne();
  };
  files.erase(std::remove_if(files.begin(), files.end(), is_of_another), files.end());
  return files;
}

/// Removes what lasting nodes of other sessions left that died long ago: nobody counts on it, and it lies in memory.
void removeOld(const fs::path& session) {
  for (const fs::path& entry : entriesOf(session)) {
    const bool is_lasting = entry.filename().string().rfind(kLasting, 0) == 0;
    if (!is_lasting || timeOf(entry) >= g_process_began - kLongAgo) continue;
    if (!writerOf(entry).lives()) unlink(entry.c_str());
  }
}

}  // namespace

bool isKeptByALivingProcess(const fs::path& file) { return writerOf(file).lives(); }

SessionMemory::SessionMemory(fs::path ros_home, const std::vector<std::string>& sessions, std::string what,
                             std::string owner, Owner kind, fs::path spare)
    : ros_home_(std::move(ros_home)),
      spare_(std::move(spare)),
      name_((kind == Owner::kLastingNode ? kLasting : "") + std::move(what) + asFileName(std::move(owner))),
      kind_(kind) {
  enter(sessions);
  std::vector<fs::path> elsewhere;
  for (const fs::path& root : {ros_home_, spare_}) {
    if (root.empty()) continue;
    for (const fs::path& session : entriesOf(root / "frontier_pilot")) {
      if (isSessionOf(session, own())) continue;
      if (kind_ == Owner::kLastingNode) removeOld(session);
      // One that is not empty stays.
      if (timeOf(session) < g_process_began - kLongAgo) rmdir(session.c_str());
      append(elsewhere,
             kind_ == Owner::kService ? ofProcesses(session, name_) : std::vector<fs::path>{session / name_});
    }
  }
  elsewhere_ = leftBehind(std::move(elsewhere), kind_ != Owner::kNode);
}

std::vector<fs::path> SessionMemory::filesIn(const fs::path& root, const std::vector<std::string>& sessions) const {
  std::vector<fs::path> files;
  if (root.empty()) return files;
  const std::string name = kind_ == Owner::kService ? name_ + kOfProcess + std::to_string(getpid()) : name_;
  for (const std::string& session : sessions) {
    if (isPlainName(session)) files.push_back(root / "frontier_pilot" / session / name);
  }
  return files;
}

std::vector<fs::path> SessionMemory::own() const {
  std::vector<fs::path> files = files_;
  append(files, spares_);
  return files;
}

bool SessionMemory::enter(const std::vector<std::string>& sessions) {
  const std::vector<fs::path> before = own();
  if (filesIn(ros_home_, sessions).empty() && filesIn(spare_, sessions).empty()) return false;
  files_ = filesIn(ros_home_, sessions);
  spares_ = filesIn(spare_, sessions);
  const std::vector<fs::path> now = own();
  if (now == before) return false;
  const auto stays = [&now](const fs::path& file) { return std::find(now.begin(), now.end(), file) != now.end(); };
  if (!before.empty()) elsewhere_.clear();
  // One that was in no session until now may have found the file of its predecessor in this one.
  elsewhere_.erase(std::remove_if(elsewhere_.begin(), elsewhere_.end(), stays), elsewhere_.end());
  std::remove_copy_if(before.begin(), before.end(), std::back_inserter(elsewhere_), stays);
  return true;
}

std::vector<fs::path> SessionMemory::others() const {
  std::vector<fs::path> found;
  if (kind_ != Owner::kService) return found;
  for (const fs::path& mine : own()) {
    for (fs::path& file : ofProcesses(mine.parent_path(), name_)) {
      if (file != mine) found.push_back(std::move(file));
    }
  }
  return found;
}

std::vector<fs::path> SessionMemory::findAll() const {
  std::vector<fs::path> files = own();
  append(files, others());
  append(files, elsewhere_);
  const auto is_gone = [error = std::error_code()](const fs::path& file) mutable {
    return fs::symlink_status(file, error).type() == fs::file_type::not_found;
  };
  files.erase(std::remove_if(files.begin(), files.end(), is_gone), files.end());
  return files;
}

std::optional<std::string> SessionMemory::recall() const {
  const std::vector<std::string> texts = recallAll();
  return texts.empty() ? std::nullopt : std::make_optional(texts.front());
}

std::vector<std::string> SessionMemory::recallAll() const { return textsIn(findAll()); }

std::vector<std::string> SessionMemory::recallFromElsewhere() const { return textsIn(elsewhere_); }

std::vector<std::string> SessionMemory::recallOfThisLaunch() const {
  std::vector<fs::path> files = findAll();
  const auto is_of_another = [](const fs::path& file) { return !writerOf(file).isOfThisLaunch(); };
  files.erase(std::remove_if(files.begin(), files.end(), is_of_another), files.end());
  return textsIn(files);
}

std::optional<std::string> SessionMemory::recallOthers() const {
  const auto texts = diskThread().run<std::vector<std::string>>([copy = *this] { return textsIn(copy.others()); });
  return texts && !texts->empty() ? std::make_optional(texts->front()) : std::nullopt;
}

std::string SessionMemory::remember(const std::string& text) const {
  const auto write = [bytes = memoryFileWith(text)](const fs::path& file) {
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    // It has to survive the process but not a power failure: after that a new master starts without a stop. And the
    // zeros must not be delayed by waiting for the disk.
    return error ? error.message() : writeFile(file, bytes, Survives::kProcessDeath);
  };
  const bool spared = !spares_.empty() && tryAll(spares_, write).empty();
  const std::string problem = onDisk([copy = *this, write, spared] {
    std::string why = tryAll(copy.files_, write);
    if (spared || why.empty()) copy.removeThoseOfTheDead();
    return why;
  });
  return spared ? std::string() : problem;
}

std::string SessionMemory::problem() const {
  const auto look = [](const fs::path& file) { return whyNotWritable(file.parent_path()); };
  const std::string problem = onDisk([files = files_, look] { return tryAll(files, look); });
  return !spares_.empty() && tryAll(spares_, look).empty() ? std::string() : problem;
}

std::string SessionMemory::removeThoseOfTheDead() const {
  std::vector<fs::path> files = others();
  files.erase(std::remove_if(files.begin(), files.end(), [](const fs::path& file) { return writerOf(file).lives(); }),
              files.end());
  append(files, elsewhere_);
  return removeAll(files);
}

std::string SessionMemory::forgetPatiently() const {
  const std::string of_the_dead = removeThoseOfTheDead(), mine = removeAll(files_);
  return mine.empty() ? of_the_dead : mine;
}

std::string SessionMemory::forget() const {
  const std::string spare = removeAll(spares_);
  const std::string problem = onDisk([copy = *this] { return copy.forgetPatiently(); });
  return spare.empty() ? problem : spare;
}

void SessionMemory::endInOrder() const {
  const auto mark = [](const std::vector<fs::path>& files) {
    const timespec times[] = {kEndedInOrder, kEndedInOrder};
    for (const fs::path& file : files) utimensat(AT_FDCWD, file.c_str(), times, 0);
    return std::string();
  };
  mark(spares_);
  onDisk([mark, files = files_] { return mark(files); });
}

}  // namespace frontier_pilot
