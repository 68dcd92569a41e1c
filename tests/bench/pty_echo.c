/* pty_echo PORT: answers each frame that ends on PORT with one of the same size, as plainly as C
 * can. */

#define _DEFAULT_SOURCE
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <termios.h>
#include <unistd.h>

int main(int argc, char** argv) {
  const int port = argc == 2 ? open(argv[1], O_RDWR | O_NOCTTY) : -1;
  if (port < 0) {
    fprintf(stderr, "usage: pty_echo PORT\n");
    return 2;
  }
  struct termios settings;
  tcgetattr(port, &settings);
  cfmakeraw(&settings);
  tcsetattr(port, TCSANOW, &settings);
  char frame[4096];
  size_t used = 0;
  for (;;) {
    struct pollfd wait = {port, POLLIN, 0};
    poll(&wait, 1, -1);
    const ssize_t n = read(port, frame + used, sizeof frame - used);
    if (n <= 0) return 0;
    used += (size_t)n;
    if (frame[used - 1] != 0 && used < sizeof frame) continue;
    if (write(port, frame, used) < 0) return 1;
    used = 0;
  }
}
