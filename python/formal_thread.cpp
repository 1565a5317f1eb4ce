// SPDX-License-Identifier: Apache-2.0
#include "python/formal_thread.h"

#include <pthread.h>

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <utility>

namespace toolcomp::python {
namespace {

class FormalThread {
 public:
  FormalThread() {
    // What Coq defines runs on the stack: more of it than a thread of the system has by itself.
    constexpr std::size_t kStack = std::size_t{256} << 20U;
    pthread_attr_t attributes{};
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, kStack);
    pthread_attr_setdetachstate(&attributes, PTHREAD_CREATE_DETACHED);
    pthread_t thread{};
    const int error = pthread_create(
        &thread, &attributes,
        [](void* self) -> void* {
          static_cast<FormalThread*>(self)->work();
          return nullptr;
        },
        this);
    pthread_attr_destroy(&attributes);
    if (error != 0) throw std::system_error(error, std::generic_category());
  }

  void run(const std::function<void()>& work) {
    const std::scoped_lock turn(turn_);
    std::unique_lock lock(mutex_);
    work_ = &work;
    changed_.notify_all();
    changed_.wait(lock, [this] { return work_ == nullptr; });
    if (const std::exception_ptr error = std::exchange(error_, nullptr)) std::rethrow_exception(error);
  }

 private:
  [[noreturn]] void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return work_ != nullptr; });
      try {
        (*work_)();
      } catch (...) {
        error_ = std::current_exception();
      }
      work_ = nullptr;
      changed_.notify_all();
    }
  }

  std::mutex turn_;  // one asks at a time
  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* work_ = nullptr;
  std::exception_ptr error_;
};

}  // namespace

void in_formal_thread(const std::function<void()>& work) {
  // It lives as long as the process: nothing waits for it at the end.
  static FormalThread& thread = *new FormalThread;  // NOLINT(cppcoreguidelines-owning-memory)
  thread.run(work);
}

}  // namespace toolcomp::python
