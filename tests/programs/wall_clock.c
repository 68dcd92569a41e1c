// Preloaded into a program: the wall clock steps an hour ahead after one second and back to an hour
// behind after five seconds, as if a user had set it. All other clocks are unchanged.
#define _GNU_SOURCE
#include <dlfcn.h>
#include <time.h>

typedef int (*Clock)(clockid_t, struct timespec*);

int clock_gettime(clockid_t id, struct timespec* out) {
  static Clock real;
  static time_t began;
  struct timespec now;
  int status;
  if (!real) real = (Clock)dlsym(RTLD_NEXT, "clock_gettime");
  status = real(id, out);
  if (status != 0 || (id != CLOCK_REALTIME && id != CLOCK_REALTIME_COARSE)) return status;
  real(CLOCK_MONOTONIC, &now);
  if (began == 0) began = now.tv_sec;
  if (now.tv_sec - began >= 5) {
    out->tv_sec -= 3600;
  } else if (now.tv_sec - began >= 1) {
    out->tv_sec += 3600;
  }
  return status;
}
