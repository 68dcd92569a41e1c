// Appends the times of a test to the file that TP100_TEST_TIMES names, one line per test: name,
// wall-clock and processor seconds (including the programs that the test started and waited for),
// and for how many seconds a processor of the machine was idle meanwhile, the mean of all.
// scripts/tested.py uses this to find tests in the wrong group.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace tp100 {
namespace {

double seconds(const timeval& time) { return double(time.tv_sec) + 1e-6 * double(time.tv_usec); }

double processor_s(int who) {
  rusage usage{};
  ::getrusage(who, &usage);
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Since the machine was started, the mean of its processors; without waiting for a disk.
double idle_s() {
  std::ifstream stat("/proc/stat");
  std::string cpu;
  double user = 0.0, nice = 0.0, system = 0.0, idle = 0.0;
  stat >> cpu >> user >> nice >> system >> idle;
  return idle / double(::sysconf(_SC_CLK_TCK)) / double(::sysconf(_SC_NPROCESSORS_ONLN));
}

class TestTime : public testing::EmptyTestEventListener {
  void OnTestEnd(const testing::TestInfo& test) override {
    name_ = std::string(test.test_suite_name()) + '.' + test.name();
  }
  void OnTestProgramEnd(const testing::UnitTest& program) override {
    const char* file = std::getenv("TP100_TEST_TIMES");
    if (file == nullptr || *file == 0 || program.test_to_run_count() != 1) return;
    char line[400];
    const int size = std::snprintf(line, sizeof line, "%s\t%.3f\t%.3f\t%.3f\n", name_.c_str(),
                                   1e-3 * double(program.elapsed_time()),
                                   processor_s(RUSAGE_SELF) + processor_s(RUSAGE_CHILDREN),
                                   idle_s() - idle_before_s_);
    const int fd = ::open(file, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0644);
    if (fd < 0) return;
    // Each line is one write, because other processes append to the same file.
    if (::write(fd, line, std::size_t(size)) != size) std::perror(file);
    ::close(fd);
  }

  const double idle_before_s_ = idle_s();
  std::string name_;
};

[[maybe_unused]] const bool kListens = [] {
  testing::UnitTest::GetInstance()->listeners().Append(new TestTime);
  return true;
}();

}  // namespace
}  // namespace tp100
