#include "analysis/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace tp100::analysis {

void claim_standard_streams() {
  // The lowest free number is given out first.
  int fd = 0;
  while (fd >= 0 && fd <= STDERR_FILENO) fd = ::open("/dev/null", O_RDWR);
  if (fd > STDERR_FILENO) ::close(fd);
}

int finish_standard_output(const char* program, int status) {
  errno = 0;
  const bool failed_before = std::ferror(stdout) != 0;
  if (std::fflush(stdout) == 0 && !failed_before) return status;
  const char* reason = errno == 0 ? "an earlier line failed" : std::strerror(errno);
  std::fprintf(stderr, "%s: standard output: cannot be written (%s); check where it goes\n",
               program, reason);
  return status == 0 ? 2 : status;
}

}  // namespace tp100::analysis
