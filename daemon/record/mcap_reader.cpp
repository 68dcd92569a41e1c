#include "record/mcap_reader.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/bytes.h"
#include "record/mcap_format.h"
#include "record/recording_file.h"
#include "text/atomic_file.h"

namespace tp100::record {
namespace {

using Span = std::span<const std::uint8_t>;

std::string text_of(Span bytes) { return {bytes.begin(), bytes.end()}; }

// Those of our own files are a thousandth of these limits.
constexpr std::uint64_t kMaxDirectory = std::uint64_t{64} << 20;
constexpr std::uint64_t kMaxMetadata = std::uint64_t{1} << 20;

/// Channels collected while reading a file.
class Directory {
 public:
  void add_schema(ByteReader in) {
    const auto id = in.number<std::uint16_t>();
    if (schemas_.contains(id)) return;
    take(in.left());
    Schema schema;
    schema.name = in.text();
    schema.encoding = in.text();
    schema.text = text_of(in.bytes(in.number<std::uint32_t>()));
    if (!in.ok() || id == 0) throw CorruptFile{"a schema is invalid"};
    schemas_[id] = std::move(schema);
  }
  /// Returns the channel if it is new.
  const McapChannel* add_channel(ByteReader in) {
    McapChannel channel;
    channel.id = in.number<std::uint16_t>();
    if (channels_.contains(channel.id)) return nullptr;
    take(in.left());
    const auto schema = in.number<std::uint16_t>();
    channel.topic = in.text();
    channel.encoding = in.text();
    in.bytes(in.number<std::uint32_t>());
    if (!in.ok()) throw CorruptFile{"a channel is invalid"};
    if (schema != 0) {
      const auto found = schemas_.find(schema);
      if (found == schemas_.end()) throw CorruptFile{"a channel has no schema"};
      take(found->second.text.size());
      channel.schema_name = found->second.name;
      channel.schema_encoding = found->second.encoding;
      channel.schema = found->second.text;
    }
    const std::uint16_t id = channel.id;
    return &channels_.emplace(id, std::move(channel)).first->second;
  }
  const McapChannel* find(std::uint16_t id) const {
    const auto found = channels_.find(id);
    return found == channels_.end() ? nullptr : &found->second;
  }

 private:
  struct Schema {
    std::string name, encoding, text;
  };
  void take(std::uint64_t bytes) {
    if (bytes > left_) throw CorruptFile{"too many schemas and channels"};
    left_ -= bytes;
  }

  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, McapChannel> channels_;
  std::uint64_t left_ = kMaxDirectory;
};

/// Content of a chunk record, unpacked and with its CRC checked. Throws CorruptFile.
void unpack(Span content, Bytes& out) {
  ByteReader in(content);
  in.number<std::uint64_t>();
  in.number<std::uint64_t>();
  const auto size = in.number<std::uint64_t>();
  const auto crc = in.number<std::uint32_t>();
  const std::string_view compression = in.text();
  const Span packed = in.bytes(in.number<std::uint64_t>());
  if (!in.ok() || in.left() > 0) throw CorruptFile{"a chunk is invalid"};
  if (size > McapReader::kMaxSize)
    throw CorruptFile{"a chunk claims to hold " + std::to_string(size) + " bytes"};
  if (compression.empty()) {
    if (packed.size() != size) throw CorruptFile{"the size of a chunk is wrong"};
    out.assign(packed.begin(), packed.end());
  } else if (compression == "zstd") {
    out.resize(static_cast<std::size_t>(size));
    const std::size_t got = ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
    if (ZSTD_isError(got) != 0 || got != size) throw CorruptFile{"a chunk cannot be decompressed"};
  } else {
    throw CorruptFile{"a chunk is not compressed with zstd"};
  }
  if (crc != 0 && crc != crc32(out)) throw CorruptFile{"the CRC of a chunk is wrong"};
}

McapMessage message_of(Span content, const Directory& directory) {
  ByteReader in(content);
  McapMessage message;
  message.channel = directory.find(in.number<std::uint16_t>());
  message.sequence = in.number<std::uint32_t>();
  message.log_ns = in.number<std::uint64_t>();
  in.number<std::uint64_t>();
  if (!in.ok()) throw CorruptFile{"a message is invalid"};
  if (message.channel == nullptr) throw CorruptFile{"a message has no channel"};
  message.data = in.bytes(in.left());
  return message;
}

/// Compares the indexes of a file and the sum of its data with what is in it. Each function throws
/// CorruptFile.
class IndexCheck {
 public:
  /// A record at a position of the file, in order. `unpacked`: the content of a chunk.
  void record(McapOp op, std::uint64_t at, Span head, Span content, Span unpacked) {
    if (op == McapOp::kDataEnd) return data_end(ByteReader(content));
    if (!summary_) {
      crc_.process_bytes(head.data(), head.size());
      crc_.process_bytes(content.data(), content.size());
    }
    ByteReader in(content);
    if (op == McapOp::kChunk) {
      chunks_[at] = head.size() + content.size();
      take_messages(unpacked);
    } else if (op == McapOp::kMessageIndex) {
      message_index(in);
    } else if (op == McapOp::kChunkIndex) {
      in.bytes(16);
      const auto start = in.number<std::uint64_t>();
      const auto found = chunks_.find(start);
      if (found == chunks_.end() || found->second != in.number<std::uint64_t>())
        throw CorruptFile{"an index of chunks points to none"};
      ++indexed_;
    }
  }
  void end() const {
    if (!summary_) throw CorruptFile{"the end of the data is missing"};
    if (indexed_ > 0 && indexed_ != chunks_.size())
      throw CorruptFile{std::to_string(chunks_.size() - indexed_) + " chunks have no index"};
  }

 private:
  struct Message {
    std::uint16_t channel = 0;
    std::uint64_t log_ns = 0;
  };

  void take_messages(Span unpacked) {
    messages_.clear();
    RecordList records(unpacked);
    while (records.next()) {
      if (records.op != McapOp::kMessage) continue;
      ByteReader in(records.content);
      const auto channel = in.number<std::uint16_t>();
      in.number<std::uint32_t>();
      messages_[static_cast<std::uint64_t>(records.content.data() - unpacked.data()) -
                kMcapRecordHead] = {channel, in.number<std::uint64_t>()};
    }
  }

  void message_index(ByteReader in) {
    const auto channel = in.number<std::uint16_t>();
    ByteReader entries(in.bytes(in.number<std::uint32_t>()));
    while (in.ok() && entries.left() > 0) {
      const auto log_ns = entries.number<std::uint64_t>();
      const auto found = messages_.find(entries.number<std::uint64_t>());
      if (found == messages_.end() || found->second.channel != channel ||
          found->second.log_ns != log_ns)
        throw CorruptFile{"an index of messages is wrong"};
    }
  }

  void data_end(ByteReader in) {
    summary_ = true;
    const auto sum = in.number<std::uint32_t>();
    if (sum != 0 && sum != crc_.checksum()) throw CorruptFile{"the CRC of the data is wrong"};
  }

  boost::crc_32_type crc_ = [] {
    boost::crc_32_type crc;
    crc.process_bytes(kMcapMagic.data(), kMcapMagic.size());
    return crc;
  }();
  bool summary_ = false;
  std::size_t indexed_ = 0;
  std::map<std::uint64_t, std::uint64_t> chunks_;  // length of the record by its position
  std::map<std::uint64_t, Message> messages_;      // of the last chunk, by position in it
};

// Of a header in a ZIP archive (APPNOTE.TXT of PKWARE, 4.3.7).
constexpr std::uint32_t kZipFile = 0x04034b50;
constexpr std::size_t kZipHead = 30;

}  // namespace

struct McapReader::State {
  explicit State(const std::string& p) : path(p) {}

  void open();
  void find_in_archive();
  Span read(std::uint64_t offset, std::uint64_t size, Bytes& buffer) const;
  bool find_summary() const;
  bool hand_on(McapOp op, Span content, Directory& known, McapHandler& handler,
               Bytes& unpacked) const;

  std::string path;
  Descriptor file;
  std::uint64_t begin = 0;  // in the file that contains it
  std::uint64_t size = 0;
  bool has_summary = false;
};

void McapReader::State::open() {
  file = Descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY));
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0)
    throw UserError(path + ": cannot be read (" + std::strerror(errno) +
                    "); name a recording or its folder, as tp100d run --record makes them");
  if (!S_ISREG(status.st_mode)) throw UserError(path + ": not a file; give a recording");
  mark_in_use(file.get());
  size = static_cast<std::uint64_t>(status.st_size);
  find_in_archive();
  Bytes buffer;
  if (size < kMcapMagic.size() ||
      !std::ranges::equal(read(0, kMcapMagic.size(), buffer), kMcapMagic))
    throw UserError(path + ": not a recording (" +
                    (size == 0 ? "nothing was written before the end" : "no MCAP file") + ")");
}

// If the file is an archive, goes on with the recording in it.
void McapReader::State::find_in_archive() {
  Bytes buffer;
  const std::uint64_t all = size;
  for (std::uint64_t at = 0; at + kZipHead <= all;) {
    ByteReader in(read(at, kZipHead, buffer));
    if (in.number<std::uint32_t>() != kZipFile) break;
    in.number<std::uint32_t>();
    const bool stored = in.number<std::uint16_t>() == 0;
    in.bytes(8);
    const std::uint64_t length = in.number<std::uint32_t>();
    in.number<std::uint32_t>();
    const std::uint64_t name_size = in.number<std::uint16_t>(), more = in.number<std::uint16_t>();
    const std::uint64_t content = at + kZipHead + name_size + more;
    if (content > all || length > all - content) break;
    const std::string name = text_of(read(at + kZipHead, name_size, buffer));
    if (name.ends_with(".mcap") && stored && length > 0) {
      begin = content;
      size = length;
      return;
    }
    at = content + length;
    if (at + kZipHead > all || !stored || name.ends_with(".mcap")) break;
  }
  if (all >= 4 && ByteReader(read(0, 4, buffer)).number<std::uint32_t>() == kZipFile)
    throw UserError(path +
                    ": an archive without a recording, or one that is compressed; unpack it");
}

// `size` bytes at `offset`, both within the file.
Span McapReader::State::read(std::uint64_t offset, std::uint64_t bytes, Bytes& buffer) const {
  buffer.resize(static_cast<std::size_t>(bytes));
  std::size_t done = 0;
  const int error = move_all(buffer.size(), done, [&](std::size_t at, std::size_t left) {
    return ::pread(file.get(), buffer.data() + at, left, static_cast<off_t>(begin + offset + at));
  });
  if (error != 0)
    throw UserError(path + ": cannot be read (" + std::strerror(error) + "), or became shorter");
  return buffer;
}

// Whether the file ends with a summary all of which is valid.
bool McapReader::State::find_summary() const {
  const std::uint64_t tail = kMcapRecordHead + kMcapFooterSize + kMcapMagic.size();
  if (size < kMcapMagic.size() + tail) return false;
  Bytes buffer;
  ByteReader in(read(size - tail, tail, buffer));
  const auto op = static_cast<McapOp>(in.number<std::uint8_t>());
  const auto length = in.number<std::uint64_t>();
  const auto summary_at = in.number<std::uint64_t>();
  in.number<std::uint64_t>();
  const auto crc = in.number<std::uint32_t>();
  if (op != McapOp::kFooter || length != kMcapFooterSize ||
      !std::ranges::equal(in.bytes(kMcapMagic.size()), kMcapMagic))
    return false;
  const std::uint64_t footer_at = size - tail;
  if (summary_at < kMcapMagic.size() || summary_at > footer_at || footer_at - summary_at > kMaxSize)
    return false;
  const Span bytes =
      read(summary_at, footer_at - summary_at + kMcapRecordHead + kMcapFooterSize, buffer);
  if (crc != 0 && crc != crc32(bytes.first(bytes.size() - 4))) return false;
  try {
    RecordList records(bytes.first(static_cast<std::size_t>(footer_at - summary_at)));
    while (records.next()) {
    }
    return true;
  } catch (const CorruptFile&) {
    return false;
  }
}

// Passes one record of the data section to the handler. False: stop reading. Throws CorruptFile.
bool McapReader::State::hand_on(McapOp op, Span content, Directory& known, McapHandler& handler,
                                Bytes& unpacked) const {
  ByteReader in(content);
  switch (op) {
    case McapOp::kSchema:
      known.add_schema(in);
      return true;
    case McapOp::kChannel: {
      const McapChannel* channel = known.add_channel(in);
      return channel == nullptr || handler.channel(*channel);
    }
    case McapOp::kMessage:
      return handler.message(message_of(content, known));
    case McapOp::kChunk: {
      unpack(content, unpacked);
      RecordList records(unpacked);
      Bytes none;
      while (records.next()) {
        if (records.op == McapOp::kChunk || records.op == McapOp::kAttachment ||
            records.op == McapOp::kMetadata)
          throw CorruptFile{"a chunk contains a record that is not allowed in it"};
        if (!hand_on(records.op, records.content, known, handler, none)) return false;
      }
      return handler.chunk_end();
    }
    case McapOp::kAttachment: {
      const auto log_ns = in.number<std::uint64_t>();
      in.number<std::uint64_t>();
      const std::string name(in.text());
      const std::string media_type(in.text());
      const Span data = in.bytes(in.number<std::uint64_t>());
      const auto crc = in.number<std::uint32_t>();
      if (!in.ok() || in.left() > 0) throw CorruptFile{"an attachment is invalid"};
      if (crc != 0 && crc != crc32(content.first(content.size() - 4)))
        throw CorruptFile{"the CRC of an attachment is wrong"};
      return handler.attachment(name, media_type, log_ns, text_of(data));
    }
    case McapOp::kMetadata: {
      if (content.size() > kMaxMetadata) throw CorruptFile{"metadata of too many bytes"};
      const std::string name(in.text());
      ByteReader entries(in.bytes(in.number<std::uint32_t>()));
      std::map<std::string, std::string> map;
      while (entries.ok() && entries.left() > 0) {
        const std::string key(entries.text());
        map[key] = entries.text();
      }
      if (!in.ok() || !entries.ok()) throw CorruptFile{"metadata are invalid"};
      return handler.metadata(name, map);
    }
    default:
      return true;
  }
}

McapReader::McapReader(const std::string& path) : state_(std::make_unique<State>(path)) {
  state_->open();
  text::note_read(path);
  state_->has_summary = state_->find_summary();
}

McapReader::~McapReader() = default;

McapEnd McapReader::stream(McapHandler& handler, McapCheck check) const {
  McapEnd end;
  const std::uint64_t size = state_->size;
  Directory known;
  Bytes head, content, unpacked;
  IndexCheck indexes;
  std::uint64_t at = kMcapMagic.size();
  const auto problem = [&](const std::string& what) {
    if (end.problem.empty()) end.problem = what + " at byte " + std::to_string(at);
  };
  // A wrong index costs nothing that is in the file.
  const auto verify = [&](auto look) {
    if (check == McapCheck::kContent) return;
    try {
      look();
    } catch (const CorruptFile& wrong) {
      problem(wrong.what);
    }
  };
  for (;;) {
    if (size - at < kMcapRecordHead) {
      problem("the file is cut off");
      return end;
    }
    ByteReader in(state_->read(at, kMcapRecordHead, head));
    const auto op = static_cast<McapOp>(in.number<std::uint8_t>());
    const auto length = in.number<std::uint64_t>();
    if (op == McapOp{} || length > size - at - kMcapRecordHead) {
      problem(op == McapOp{} ? "a record without a type" : "the file is cut off");
      return end;
    }
    if (op == McapOp::kFooter) {
      verify([&] { indexes.end(); });
      const std::uint64_t tail = at + kMcapRecordHead + length;
      end.whole = state_->has_summary && size - tail == kMcapMagic.size() && end.problem.empty();
      if (!end.whole) problem("the end of the file is invalid");
      return end;
    }
    if (length > kMaxSize) {
      problem("a record of " + std::to_string(length) + " bytes");
      return end;
    }
    try {
      const Span bytes = state_->read(at + kMcapRecordHead, length, content);
      if (!state_->hand_on(op, bytes, known, handler, unpacked)) return end;
      verify([&] { indexes.record(op, at, head, bytes, unpacked); });
    } catch (const CorruptFile& corruption) {
      ++end.corrupted;
      problem(corruption.what);
    }
    at += kMcapRecordHead + length;
  }
}

bool McapReader::indexed() const { return state_->has_summary; }
const std::string& McapReader::path() const { return state_->path; }

}  // namespace tp100::record
