#include "support/real_time_monitor.h"

#include <dlfcn.h>
#include <pthread.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <ucontext.h>

#include <cerrno>

namespace {

thread_local bool t_armed = false;
thread_local std::uint64_t t_locks = 0;
thread_local volatile long t_first_call = -1;
// The kernel reads this at every system call of the thread.
thread_local volatile char t_selector = SYSCALL_DISPATCH_FILTER_ALLOW;

void on_system_call(int, siginfo_t* info, void* context) {
  // The return from this handler is also a system call.
  t_selector = SYSCALL_DISPATCH_FILTER_ALLOW;
  if (t_first_call < 0) t_first_call = info->si_syscall;
#if defined(__x86_64__)
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RAX] = -ENOSYS;
#else
  static_cast<void>(context);
#endif
}

bool dispatch(unsigned long mode) {
  const bool on = mode == PR_SYS_DISPATCH_ON;
  return ::prctl(PR_SET_SYSCALL_USER_DISPATCH, mode, 0UL, 0UL, on ? &t_selector : nullptr) == 0;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

void count() {
  if (t_armed) ++t_locks;
}

}  // namespace

extern "C" {
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
  static auto* const real = next<int(pthread_mutex_t*)>("pthread_mutex_lock");
  count();
  return real(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
  static auto* const real = next<int(pthread_mutex_t*)>("pthread_mutex_trylock");
  count();
  return real(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) noexcept {
  static auto* const real = next<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
  count();
  return real(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) noexcept {
  static auto* const real = next<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
  count();
  return real(lock);
}
}

namespace tp100::test {

bool watches_system_calls() {
#if defined(__x86_64__)
  return dispatch(PR_SYS_DISPATCH_ON) && dispatch(PR_SYS_DISPATCH_OFF);
#else
  return false;
#endif
}

RealTimeMonitor::RealTimeMonitor(RealTimeViolations& count) : count_(count) {
  struct sigaction action {};
  action.sa_sigaction = on_system_call;
  action.sa_flags = SA_SIGINFO;
  ::sigaction(SIGSYS, &action, nullptr);
  dispatch(PR_SYS_DISPATCH_ON);
  t_locks = 0;
  t_first_call = -1;
  t_armed = true;
  t_selector = SYSCALL_DISPATCH_FILTER_BLOCK;
}

RealTimeMonitor::~RealTimeMonitor() {
  t_selector = SYSCALL_DISPATCH_FILTER_ALLOW;
  t_armed = false;
  dispatch(PR_SYS_DISPATCH_OFF);
  count_.heap += heap_.calls();
  count_.locks += t_locks;
  if (count_.first_system_call < 0) count_.first_system_call = t_first_call;
}

}  // namespace tp100::test
