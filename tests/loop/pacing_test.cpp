#include "loop/pacing.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/clock.h"
#include "loop/real_time.h"

namespace tp100::loop {
namespace {

TEST(Schedule, SkipsMissedCyclesAndKeepsThePhase) {
  for (HostNs now = 105; now < 145; ++now) {
    Schedule schedule(5, 100);
    ASSERT_EQ(schedule.deadline(), 105);
    EXPECT_EQ(schedule.advance(now), static_cast<std::uint64_t>((now - 105) / 5)) << now;
    EXPECT_EQ(schedule.deadline(), now / 5 * 5 + 5) << now;
  }
}

TEST(Waiting, NeverEndsBeforeTheDeadline) {
  for (int i = 0; i < 20; ++i) {
    const HostNs deadline = monotonic_now() + 300 * kNsPerUs;
    sleep_until(deadline);
    ASSERT_GE(monotonic_now(), deadline);
  }
  const HostNs deadline = monotonic_now() + 50 * kNsPerUs;
  spin_until(deadline);
  EXPECT_GE(monotonic_now(), deadline);
}

/// The fix that is suggested if `what` is refused.
std::string fix(const std::vector<Privilege>& privileges, const std::string& what) {
  for (const Privilege& privilege : privileges) {
    if (privilege.what.rfind(what, 0) == 0) return privilege.granted ? "granted" : privilege.fix;
  }
  return "not asked for";
}

/// Runs in its own process, because it lowers limits and gives up root irreversibly.
[[noreturn]] void ask_without_rights() {
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_RTPRIO, &none);
  ::setrlimit(RLIMIT_MEMLOCK, &none);
  if (::geteuid() == 0 && ::setresuid(65534, 65534, 65534) != 0) std::_Exit(2);
  const RealTimeProcess process({.lock_memory = true, .hold_cpu_latency = true});
  std::fprintf(stderr, "%s\n%s\n", fix(process.privileges(), "memory").c_str(),
               fix(apply_to_this_thread({.priority = 80}), "SCHED_FIFO").c_str());
  std::_Exit(0);
}

TEST(RealTime, APrivilegeThatIsMissingNamesTheCommandThatGrantsIt) {
  EXPECT_EXIT(ask_without_rights(), testing::ExitedWithCode(0),
              R"(echo ".USER - memlock unlimited" . sudo tee -a /etc/security/limits.d/tp100.conf)"
              R"(.*
echo ".USER - rtprio 90" . sudo tee -a /etc/security/limits.d/tp100.conf)");
}

TEST(RealTime, EveryPrivilegeIsGrantedOrComesWithAFix) {
  const RealTimeProcess process({.lock_memory = false, .hold_cpu_latency = true});
  for (const Privilege& privilege : process.privileges())
    EXPECT_NE(privilege.granted, !privilege.fix.empty());
  for (const Privilege& privilege : apply_to_this_thread({.priority = 0, .cpu = 100'000})) {
    EXPECT_FALSE(privilege.granted);
    EXPECT_FALSE(privilege.fix.empty());
  }
}

TEST(RealTime, TheKernelsUnboundWorkersComeBeforeOrdinaryPrograms) {
  const auto policies = [] {
    std::vector<int> found;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::string name;
      std::getline(std::ifstream(entry.path() / "comm"), name);
      if (name.starts_with("kworker/u"))
        found.push_back(::sched_getscheduler(std::stoi(entry.path().filename())));
    }
    return found;
  };
  const RealTimeProcess process({.lock_memory = false, .hold_cpu_latency = false});
  const bool permitted = ::setpriority(PRIO_PROCESS, 0, -1) == 0;
  EXPECT_EQ(process.privileges().size(), permitted && !policies().empty() ? 1u : 0u);
  // The kernel may make another one at any time.
  const auto all = [&] {
    process.keep();
    return std::ranges::all_of(policies(), [](int policy) { return policy == SCHED_FIFO; });
  };
  for (int i = 0; i < 100 && !process.privileges().empty(); ++i)
    if (all()) return;
  EXPECT_TRUE(process.privileges().empty());
}

}  // namespace
}  // namespace tp100::loop
