#include "sim/lab/study_processes.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "core/error.h"
#include "text/progress.h"

namespace tp100 {

namespace report {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(PoseErrors, max_position_error_m, mean_position_error_m,
                                   rms_position_error_m, final_position_error_m, mse_x_m2, mse_y_m2,
                                   mse_yaw_rad2, max_yaw_error_rad)

}  // namespace report

namespace sim {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Spread, median, p95, count)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Judged, course, robot, what, unit, limit, ours)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FormErrors, form, median)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(CourseStudy, course, robot, setup, board, uneven, blind, runs,
                                   completed, distance_m, judged, forms, mse_x_m2, mse_y_m2,
                                   mse_yaw_rad2)

namespace {

/// Does not compile before a new field is listed above. The run shown stays in its process.
[[maybe_unused]] void require_all_fields(const CourseStudy& study, const Judged& judged,
                                         const FormErrors& form, const report::PoseErrors& errors) {
  [[maybe_unused]] const auto& [a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11, a12, a13, a14,
                                shown] = study;
  [[maybe_unused]] const auto& [b1, b2, b3, b4, b5, b6] = judged;
  [[maybe_unused]] const auto& [c1, c2] = form;
  [[maybe_unused]] const auto& [d1, d2, d3, d4, d5, d6, d7, d8] = errors;
}

using Bytes = std::vector<std::uint8_t>;

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

void write_all(int file, const Bytes& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t written = write(file, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno != EINTR) fail("the result of a study");
    if (written > 0) done += static_cast<std::size_t>(written);
  }
}

Bytes read_all(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  Bytes bytes(static_cast<std::size_t>(std::max<off_t>(size, 0)));
  if (size < 0 || pread(file, bytes.data(), bytes.size(), 0) != size) fail("the result of a study");
  return bytes;
}

/// Waits for a process, or with -1 for any child, and returns its status.
int wait_for(pid_t pid) {
  int status = 0;
  while (waitpid(pid, &status, 0) < 0)
    if (errno != EINTR) fail("waitpid");
  return status;
}

/// Starts a process that runs `body`, returns its result, 1 after an exception, and ends with this
/// process.
pid_t start_process(const std::function<int()>& body) {
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid < 0) fail("fork");
  if (pid > 0) return pid;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  int status = 1;
  try {
    if (getppid() == parent) status = body();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "the process of a study: %s\n", error.what());
  }
  _exit(status);
}

// What a job writes: its studies, or the message of its exception and whether it is a UserError.
constexpr const char* kStudies = "studies";
constexpr const char* kMessage = "message";
constexpr const char* kSetup = "setup";

/// Returns 0 if the job succeeded.
int run_job(const StudyProcesses::Job& job, int file) {
  nlohmann::json outcome;
  try {
    outcome[kStudies] = job();
  } catch (const UserError& error) {
    outcome = {{kMessage, error.what()}, {kSetup, true}};
  } catch (const std::exception& error) {
    outcome = {{kMessage, error.what()}, {kSetup, false}};
  }
  write_all(file, nlohmann::json::to_cbor(outcome));
  return outcome.contains(kStudies) ? 0 : 1;
}

/// Starts no more jobs after one has failed.
int run_jobs(const std::vector<StudyProcesses::Job>& jobs, const std::vector<int>& files) {
  const unsigned most = std::max(std::thread::hardware_concurrency(), 1U);
  unsigned running = 0;
  bool failed = false;
  text::Progress progress("part", jobs.size());
  const auto wait_for_one = [&] {
    failed |= wait_for(-1) != 0;
    --running;
    progress.step();
  };
  for (std::size_t i = 0; i < jobs.size() && !failed; ++i) {
    if (running == most) wait_for_one();
    if (failed) break;
    start_process([&] { return run_job(jobs[i], files[i]); });
    ++running;
  }
  while (running > 0) wait_for_one();
  return failed ? 1 : 0;
}

}  // namespace

StudyProcesses::StudyProcesses(const std::vector<Job>& jobs) {
  try {
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      files_.push_back(memfd_create("study", MFD_CLOEXEC));
      if (files_.back() < 0) fail("memfd_create");
    }
    std::fflush(nullptr);
    if (!jobs.empty()) runner_ = start_process([&] { return run_jobs(jobs, files_); });
  } catch (...) {
    end();
    throw;
  }
}

StudyProcesses::~StudyProcesses() { end(); }

void StudyProcesses::end() {
  if (runner_ > 0) {
    kill(runner_, SIGKILL);
    waitpid(runner_, nullptr, 0);
  }
  for (const int file : files_) close(file);
}

std::vector<CourseStudy> StudyProcesses::results() {
  const int status = runner_ > 0 ? wait_for(std::exchange(runner_, -1)) : 0;
  std::vector<CourseStudy> all;
  for (const int file : files_) {
    const Bytes bytes = read_all(file);
    if (bytes.empty()) continue;  // ended by a signal, or not begun after another one failed
    const nlohmann::json outcome = nlohmann::json::from_cbor(bytes);
    if (const auto message = outcome.find(kMessage); message != outcome.end()) {
      if (outcome[kSetup].get<bool>()) throw UserError(message->get<std::string>());
      throw std::runtime_error(message->get<std::string>());
    }
    for (const nlohmann::json& study : outcome[kStudies]) all.push_back(study.get<CourseStudy>());
  }
  if (status != 0)
    throw std::runtime_error(
        "the process of a study ended without a result: it was killed, or its error is printed "
        "above");
  return all;
}

}  // namespace sim
}  // namespace tp100
