#include "core/worker.h"

#include <pthread.h>

#include <exception>
#include <filesystem>
#include <new>
#include <utility>

#include "core/error.h"

namespace tp100 {
namespace {

/// What is being thrown, in one line. A path is shortened to its name: viewers get no path of this
/// machine.
std::string thrown() {
  try {
    throw;
  } catch (const UserError& error) {
    return error.what();
  } catch (const std::filesystem::filesystem_error& error) {
    const std::string name = error.path1().filename().string();
    return (name.empty() ? "the disk" : one_line(name)) + ": " + error.code().message() +
           "; check folder, permission and disk";
  } catch (const std::bad_alloc&) {
    return "memory is used up; end other programs, then try again";
  } catch (const std::exception& error) {
    return "a defect of tp100d (" + one_line(error.what()) + "); report it";
  } catch (...) {
    return "a defect of tp100d (unknown); report it";
  }
}

}  // namespace

Worker::Worker(const char* name, std::size_t most) : most_(most), thread_([this] { run(); }) {
  ::pthread_setname_np(thread_.native_handle(), name);
}

Worker::~Worker() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  some_.notify_one();
  thread_.join();
}

bool Worker::post(Job job, Failed failed) {
  {
    const std::lock_guard lock(mutex_);
    if (jobs_.size() >= most_) return false;
    jobs_.push_back({std::move(job), std::move(failed)});
  }
  some_.notify_one();
  return true;
}

void Worker::ask(const Answer& answer, std::function<std::string()> job) {
  const auto answered = [answer, job = std::move(job)] {
    std::string json, why;
    run_here([&] { json = job(); }, [&](const std::string& thrown) { why = thrown; });
    answer(why, why.empty() ? json : "");
  };
  if (!post(answered, [](const std::string&) {})) answer(kBusy, "");
}

bool Worker::idle_by(std::chrono::steady_clock::time_point deadline) {
  std::unique_lock lock(mutex_);
  return idle_.wait_until(lock, deadline, [this] { return jobs_.empty() && !busy_; });
}

void Worker::run_here(const Job& job, const Failed& failed) {
  try {
    job();
  } catch (...) {
    try {
      failed(thrown());
    } catch (...) {
      // There is not even memory for the answer. The robot drives on, and its STOP works.
    }
  }
}

void Worker::run() {
  std::unique_lock lock(mutex_);
  for (;;) {
    some_.wait(lock, [this] { return !jobs_.empty() || ending_; });
    if (jobs_.empty()) return;
    Posted next = std::move(jobs_.front());
    jobs_.pop_front();
    busy_ = true;
    lock.unlock();
    run_here(next.job, next.failed);
    next = {};  // frees what they captured without the lock
    lock.lock();
    busy_ = false;
    if (jobs_.empty()) idle_.notify_all();
  }
}

}  // namespace tp100
