#include "sim/body/ode_world.h"

#include <atomic>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <mutex>

namespace tp100::sim {
namespace {

std::atomic<std::uint64_t> g_messages{0};

std::mutex& ode_mutex() {
  static std::mutex mutex;
  return mutex;
}

[[gnu::format(printf, 2, 0)]] void count_message(int, const char* format, va_list arguments) {
  if (g_messages.fetch_add(1) == 0) {
    std::fputs("ODE: ", stderr);
    std::vfprintf(stderr, format, arguments);
    std::fputc('\n', stderr);
  }
}

[[noreturn, gnu::format(printf, 2, 0)]] void give_up(int number, const char* format,
                                                     va_list arguments) {
  count_message(number, format, arguments);
  std::abort();
}

void initialise_once() {
  static const bool done = [] {
    dInitODE2(0);
    dSetMessageHandler(count_message);
    dSetErrorHandler(give_up);
    dSetDebugHandler(give_up);
    return true;
  }();
  (void)done;
}

}  // namespace

OdeWorld::OdeWorld() {
  const std::lock_guard lock(ode_mutex());
  initialise_once();
  world_ = dWorldCreate();
  contacts_ = dJointGroupCreate(0);
  dWorldSetGravity(world_, 0.0, 0.0, -9.81);
}

OdeWorld::~OdeWorld() {
  const std::lock_guard lock(ode_mutex());
  dJointGroupDestroy(contacts_);
  dWorldDestroy(world_);
}

void OdeWorld::step(double dt_s) {
  const std::lock_guard lock(ode_mutex());
  thread_local const int allocated = dAllocateODEDataForThread(dAllocateFlagBasicData);
  static_cast<void>(allocated);
  dRandSetSeed(static_cast<unsigned long>(steps_++));
  dWorldQuickStep(world_, dt_s);
  dJointGroupEmpty(contacts_);
}

std::uint64_t OdeWorld::solver_messages() { return g_messages.load(); }

}  // namespace tp100::sim
