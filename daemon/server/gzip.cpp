#include "server/gzip.h"

#include <boost/beast/zlib/deflate_stream.hpp>
#include <boost/crc.hpp>
#include <cstdint>

namespace tp100::server {
namespace {

namespace zlib = boost::beast::zlib;

constexpr int kFast = 3, kWindowBits = 15, kMemoryLevel = 8;

}  // namespace

std::string gzipped(std::string_view text) {
  std::string out("\x1f\x8b\x08\0\0\0\0\0\0\xff", 10);
  const std::size_t head = out.size();
  zlib::deflate_stream deflate;
  deflate.reset(kFast, kWindowBits, kMemoryLevel, zlib::Strategy::normal);
  out.resize(head + deflate.upper_bound(text.size()));
  zlib::z_params z;
  z.next_in = text.data();
  z.avail_in = text.size();
  z.next_out = out.data() + head;
  z.avail_out = out.size() - head;
  boost::system::error_code end;  // of the stream
  deflate.write(z, zlib::Flush::finish, end);
  out.resize(head + z.total_out);
  boost::crc_32_type crc;
  crc.process_bytes(text.data(), text.size());
  const std::uint64_t tail = std::uint64_t{text.size() & 0xffffffffU} << 32U | crc.checksum();
  for (unsigned shift = 0; shift < 64; shift += 8) out += static_cast<char>(tail >> shift);
  return out;
}

}  // namespace tp100::server
