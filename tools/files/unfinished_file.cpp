#include "files/unfinished_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <system_error>

namespace tamis::io {

/// An entry of a list that a signal handler reads. Entries are reused and never freed, as the handler may be reading
/// them.
struct UnfinishedName {
  enum State : int { unused, claimed, removable };
  std::atomic<int> state{unused};
  std::array<char, PATH_MAX> path{};
  UnfinishedName* next = nullptr;
};

namespace {

constexpr std::array kEndings{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGALRM, SIGXCPU, SIGUSR1, SIGUSR2};

std::atomic<UnfinishedName*> names{nullptr};
std::atomic<bool> is_ending{false};
std::atomic<int> makers{0};  ///< threads that make a file that is not yet removable

/// While it lives, signals are blocked in this thread, and a handler in another thread waits for its end.
class Making {
 public:
  Making() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before_);
    ++makers;
    if (!is_ending) return;
    --makers;
    for (;;) pause();  // another thread is about to end the process: no new files
  }
  ~Making() {
    --makers;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  Making(const Making&) = delete;
  Making& operator=(const Making&) = delete;

 private:
  sigset_t before_{};
};

[[noreturn]] void fail(int error) { throw std::system_error(error, std::generic_category()); }

UnfinishedName* claim_name() {
  for (UnfinishedName* name = names; name != nullptr; name = name->next) {
    int unused = UnfinishedName::unused;
    if (name->state.compare_exchange_strong(unused, UnfinishedName::claimed)) return name;
  }
  auto* name = new UnfinishedName;
  name->state = UnfinishedName::claimed;
  name->next = names;
  while (!names.compare_exchange_weak(name->next, name)) {
  }
  return name;
}

/// Random, as process numbers recur; short, whatever the length of the final name.
std::string random_name() {
  std::random_device random;
  return fmt::format(".tamis-{:08x}{:08x}.part", random(), random());
}

extern "C" void remove_and_end(int signal) {
  is_ending = true;
  while (makers > 0) poll(nullptr, 0, 1);
  for (const UnfinishedName* name = names; name != nullptr; name = name->next)
    if (name->state == UnfinishedName::removable) unlink(name->path.data());
  raise(signal);  // its action is the default again (SA_RESETHAND)
}

}  // namespace

UnfinishedFile::UnfinishedFile(const std::filesystem::path& folder, mode_t mode) : name_(claim_name()) {
  int error = EEXIST;
  while (error == EEXIST) {
    const std::string path = (folder / random_name()).string();
    if (path.size() >= name_->path.size()) {
      error = ENAMETOOLONG;
      break;
    }
    std::strcpy(name_->path.data(), path.c_str());
    const Making making;
    descriptor_ = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    error = descriptor_ >= 0 ? 0 : errno;
    if (error == 0) name_->state = UnfinishedName::removable;
  }
  if (error == 0) return;
  name_->state = UnfinishedName::unused;
  fail(error);
}

UnfinishedFile::~UnfinishedFile() {
  if (name_->state == UnfinishedName::removable) unlink(name_->path.data());
  name_->state = UnfinishedName::unused;
}

void UnfinishedFile::rename_to(const std::filesystem::path& path) {
  if (std::rename(name_->path.data(), path.c_str()) != 0) fail(errno);
  name_->state = UnfinishedName::claimed;
}

void remove_unfinished_files_on_signals() {
  struct sigaction removal {};
  removal.sa_handler = remove_and_end;
  removal.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : kEndings) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler == SIG_DFL) sigaction(signal, &removal, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace tamis::io
