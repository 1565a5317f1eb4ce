// SPDX-License-Identifier: Apache-2.0
#include "host/process.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

#include "spec/language/printable.h"

namespace toolcomp::host {
namespace {

constexpr std::size_t kErrorTail = 4096;

// The groups alive, for kill_processes(): plain atomics, because a signal handler reads them.
constexpr std::size_t kMaxGroups = 512;
std::array<std::atomic<pid_t>, kMaxGroups> groups{};

void register_group(pid_t group) {
  for (auto& slot : groups) {
    pid_t none = 0;
    if (slot.compare_exchange_strong(none, group)) return;
  }
}

void forget_group(pid_t group) {
  for (auto& slot : groups) {
    pid_t same = group;
    if (slot.compare_exchange_strong(same, 0)) return;
  }
}

// While a process is started and not yet among the groups. Signals wait in this thread meanwhile; a handler in another
// one waits for it, so that a process that signals us at once is known by then.
std::atomic<int> starting{0};

class Starting {
 public:
  Starting() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
    ++starting;
  }
  ~Starting() {
    --starting;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  Starting(const Starting&) = delete;
  Starting& operator=(const Starting&) = delete;

 private:
  sigset_t before_{};
};

void close_fd(int& fd) {
  if (fd >= 0) ::close(fd);
  fd = -1;
}

struct Pipe {
  int read = -1;
  int write = -1;
  Pipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error(std::string("pipe: ") + std::strerror(errno));
    read = ends[0];
    write = ends[1];
  }
  ~Pipe() {
    close_fd(read);
    close_fd(write);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
};

// A write to a process that has gone raises SIGPIPE: held back for this thread and swallowed, so that the caller sees
// EPIPE and the rest of the program keeps its own disposition of the signal.
class NoSigpipe {
 public:
  NoSigpipe() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoSigpipe() {
    if (!was_pending_) {
      const timespec now{};
      while (sigtimedwait(&pipe_, nullptr, &now) < 0 && errno == EINTR) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoSigpipe(const NoSigpipe&) = delete;
  NoSigpipe& operator=(const NoSigpipe&) = delete;

 private:
  sigset_t pipe_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

// The attributes of the new process: its own group, default signals, nothing blocked.
class Attributes {
 public:
  Attributes() {
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_setpgroup(&attributes_, 0);
    sigset_t set;
    sigemptyset(&set);
    posix_spawnattr_setsigmask(&attributes_, &set);
    sigaddset(&set, SIGPIPE);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    sigaddset(&set, SIGXFSZ);
    posix_spawnattr_setsigdefault(&attributes_, &set);
    posix_spawnattr_setflags(
        &attributes_, static_cast<short>(POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF));
  }
  ~Attributes() {
    posix_spawn_file_actions_destroy(&actions_);
    posix_spawnattr_destroy(&attributes_);
  }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  void connect(int fd, int as) { posix_spawn_file_actions_adddup2(&actions_, fd, as); }
  [[nodiscard]] const posix_spawnattr_t* attributes() const { return &attributes_; }
  [[nodiscard]] const posix_spawn_file_actions_t* actions() const { return &actions_; }

 private:
  posix_spawnattr_t attributes_{};
  posix_spawn_file_actions_t actions_{};
};

std::string describe(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return "killed by signal " + std::to_string(signal) + " (" + ::strsignal(signal) +
           ")";  // NOLINT(concurrency-mt-unsafe)
  }
  return "exit status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

Process::Process(const std::string& command) {
  Pipe in;
  Pipe out;
  Pipe err;
  Attributes attributes;
  attributes.connect(in.read, STDIN_FILENO);
  attributes.connect(out.write, STDOUT_FILENO);
  attributes.connect(err.write, STDERR_FILENO);
  const std::array<const char*, 4> arguments{"sh", "-c", command.c_str(), nullptr};
  {
    const Starting now;
    const int error = ::posix_spawn(&pid_, "/bin/sh", attributes.actions(), attributes.attributes(),
                                    const_cast<char* const*>(arguments.data()), environ);  // NOLINT: POSIX signature
    if (error != 0) throw std::runtime_error(std::string("cannot start a process: ") + std::strerror(error));
    register_group(pid_);
  }
  in_ = std::exchange(in.write, -1);
  out_ = std::exchange(out.read, -1);
  err_ = std::exchange(err.read, -1);
  for (const int fd : {in_, out_, err_}) ::fcntl(fd, F_SETFL, O_NONBLOCK);
}

Process::~Process() { finish(); }

bool Process::send() {
  const NoSigpipe guard;
  const ssize_t n = ::write(in_, outgoing_.data() + sent_, outgoing_.size() - sent_);
  if (n >= 0) {
    sent_ += static_cast<std::size_t>(n);
    return true;
  }
  return errno == EAGAIN || errno == EINTR;
}

bool Process::receive(std::size_t limit, Exchange& end) {
  std::array<char, 1 << 16> buffer{};
  const ssize_t n = ::read(out_, buffer.data(), buffer.size());
  if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) {
    end = Exchange::closed;
    return false;
  }
  if (n > 0) pending_.append(buffer.data(), static_cast<std::size_t>(n));
  // The line end may have come with the bytes over the limit: then the line itself decides.
  if (pending_.size() > limit && pending_.find('\n', scanned_) == std::string::npos) {
    end = Exchange::too_long;
    return false;
  }
  return true;
}

std::string Process::errors() const { return spec::printable_lines(errors_); }

void Process::receive_errors() {
  std::array<char, kErrorTail> buffer{};
  const ssize_t n = ::read(err_, buffer.data(), buffer.size());
  if (n > 0) {
    errors_.append(buffer.data(), static_cast<std::size_t>(n));
    if (errors_.size() > kErrorTail) errors_.erase(0, errors_.size() - kErrorTail);
  } else if (n == 0 || (errno != EAGAIN && errno != EINTR)) {
    close_fd(err_);
  }
}

bool Process::take_line(std::string& reply) {
  const std::size_t end = pending_.find('\n', scanned_);
  if (end == std::string::npos) {
    scanned_ = pending_.size();
    return false;
  }
  reply.assign(pending_, 0, end);
  if (!reply.empty() && reply.back() == '\r') reply.pop_back();
  pending_.erase(0, end + 1);
  scanned_ = 0;
  return true;
}

Exchange Process::exchange(std::string_view line, std::string& reply, Clock::time_point deadline, std::size_t limit) {
  outgoing_ = std::string(line) + '\n';
  sent_ = 0;
  return receive_line(reply, deadline, limit);
}

Exchange Process::receive_line(std::string& reply, Clock::time_point deadline, std::size_t limit) {
  Exchange end = Exchange::closed;
  while (true) {
    if (take_line(reply)) return reply.size() > limit ? Exchange::too_long : Exchange::line;
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return Exchange::timed_out;
    std::array<pollfd, 3> ready{
        {{out_, POLLIN, 0}, {err_, POLLIN, 0}, {sent_ == outgoing_.size() ? -1 : in_, POLLOUT, 0}}};
    const int n = ::poll(ready.data(), ready.size(), static_cast<int>(std::min<std::int64_t>(left, 60'000)));
    if (n < 0 && errno != EINTR) return Exchange::closed;
    if (n <= 0) continue;
    if (ready[1].revents != 0) receive_errors();
    // A process that reads nothing more may still have answered: only the end of its output ends the exchange.
    if (ready[2].revents != 0 && !send()) sent_ = outgoing_.size();
    if (ready[0].revents != 0 && !receive(limit, end)) return end;
  }
}

std::string Process::finish(std::chrono::milliseconds patience) {
  if (pid_ < 0) return ended_;
  close_fd(in_);
  // Looked at without being reaped, so that the id of the group cannot be given to anybody else before the kill.
  const auto ended = [this] {
    siginfo_t info{};
    return ::waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == pid_;
  };
  const Clock::time_point deadline = Clock::now() + patience;
  bool by_itself = ended();
  while (!by_itself && Clock::now() < deadline) {
    if (err_ >= 0) receive_errors();
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    by_itself = ended();
  }
  ::kill(-pid_, SIGKILL);
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  forget_group(pid_);
  pid_ = -1;
  ended_ = by_itself ? describe(status) : "still running";
  if (by_itself && WIFEXITED(status)) exit_status_ = WEXITSTATUS(status);
  for (int i = 0; i < 16 && err_ >= 0; ++i) receive_errors();
  close_fd(out_);
  close_fd(err_);
  return ended_;
}

std::string shell_quoted(std::string_view text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + '\'';
}

void kill_processes() noexcept {
  while (starting.load() > 0) {
  }
  for (const auto& slot : groups)
    if (const pid_t group = slot.load(); group > 0) ::kill(-group, SIGKILL);
}

}  // namespace toolcomp::host
