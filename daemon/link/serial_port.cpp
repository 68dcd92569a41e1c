#include "link/serial_port.h"

#include <fcntl.h>
#include <libserialport.h>

#include <cerrno>
#include <memory>

namespace tp100::link {

int open_serial_port(const std::string& real_path, int baud, int& error) {
  sp_port* raw = nullptr;
  if (sp_get_port_by_name(real_path.c_str(), &raw) != SP_OK) {
    error = ENOENT;
    return -1;
  }
  const std::unique_ptr<sp_port, decltype(&sp_free_port)> port(raw, &sp_free_port);
  if (sp_open(port.get(), SP_MODE_READ_WRITE) != SP_OK) {
    error = sp_last_error_code();
    return -1;
  }
  int fd = -1;
  if (sp_set_baudrate(port.get(), baud) != SP_OK || sp_set_bits(port.get(), 8) != SP_OK ||
      sp_set_parity(port.get(), SP_PARITY_NONE) != SP_OK ||
      sp_set_stopbits(port.get(), 1) != SP_OK ||
      sp_set_flowcontrol(port.get(), SP_FLOWCONTROL_NONE) != SP_OK ||
      sp_get_port_handle(port.get(), &fd) != SP_OK) {
    error = sp_last_error_code();
    sp_close(port.get());
    return -1;
  }
  // The library closes its own descriptor; the duplicate keeps DTR up.
  const int own = ::fcntl(fd, F_DUPFD_CLOEXEC, 3);
  error = errno;
  sp_close(port.get());
  return own;
}

}  // namespace tp100::link
