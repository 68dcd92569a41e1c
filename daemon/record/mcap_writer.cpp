#include "record/mcap_writer.h"

#include <zstd.h>

#include <algorithm>
#include <filesystem>
#include <new>

#include "core/error.h"

namespace tp100::record {
namespace {

/// One record: head on construction, length at the end.
class Record {
 public:
  Record(Bytes& out, McapOp op) : out_(out) {
    out_.number(static_cast<std::uint8_t>(op));
    length_at_ = out_.size();
    out_.number<std::uint64_t>(0);
  }
  ~Record() { out_.patch(length_at_, static_cast<std::uint64_t>(out_.size() - length_at_ - 8)); }
  Record(const Record&) = delete;
  Record& operator=(const Record&) = delete;
  ByteWriter* operator->() { return &out_; }

 private:
  ByteWriter out_;
  std::size_t length_at_;
};

void write_map(ByteWriter& out, const McapMap& entries) {
  const std::size_t size_at = out.size();
  out.number<std::uint32_t>(0);
  for (const auto& [key, value] : entries) {
    out.text(key);
    out.text(value);
  }
  out.patch(size_at, static_cast<std::uint32_t>(out.size() - size_at - 4));
}

// Speed matters more than the last tenth of compression; the frame contains its size.
constexpr int kLevel = 1;

// Part of the chunks' index that is kept in memory: some minutes.
constexpr std::size_t kIndexBytes = std::size_t{64} << 10;

}  // namespace

struct McapWriter::Zstd {
  Zstd() : context(ZSTD_createCCtx()) {
    if (context == nullptr) throw std::bad_alloc();
  }
  ~Zstd() { ZSTD_freeCCtx(context); }
  Zstd(const Zstd&) = delete;
  Zstd& operator=(const Zstd&) = delete;
  ZSTD_CCtx* context;
};

McapWriter::McapWriter(RecordingFile& file, std::string_view library, McapCompression compression,
                       std::string_view profile)
    : file_(file) {
  if (compression == McapCompression::kZstd) zstd_ = std::make_unique<Zstd>();
  record_.assign(kMcapMagic.begin(), kMcapMagic.end());
  {
    Record header(record_, McapOp::kHeader);
    header->text(profile);
    header->text(library);
  }
  write(record_);
}

McapWriter::~McapWriter() = default;

// The CRC covers only what is in the file.
void McapWriter::write(const Bytes& bytes) {
  file_.append(bytes);
  if (file_.error() == 0) data_crc_.process_bytes(bytes.data(), bytes.size());
}

std::uint16_t McapWriter::add_schema(const McapSchema& schema) {
  record_.clear();
  // Zero means "no schema".
  const auto id = static_cast<std::uint16_t>(++schema_group_.count);
  {
    Record record(record_, McapOp::kSchema);
    record->number(id);
    record->text(schema.name);
    record->text(schema.encoding);
    record->text(schema.text);
  }
  write(record_);
  ByteWriter(schema_group_.records).bytes(record_);
  return id;
}

std::uint16_t McapWriter::add_channel(std::uint16_t schema, std::string_view topic,
                                      std::string_view message_encoding, const McapMap& metadata) {
  record_.clear();
  const auto id = static_cast<std::uint16_t>(channels_.size());
  {
    Record record(record_, McapOp::kChannel);
    record->number(id);
    record->number(schema);
    record->text(topic);
    record->text(message_encoding);
    write_map(*record.operator->(), metadata);
  }
  write(record_);
  ByteWriter(channel_group_.records).bytes(record_);
  ++channel_group_.count;
  channels_.emplace_back();
  return id;
}

void McapWriter::attach(const McapAttachment& attachment) {
  end_chunk();
  const std::uint64_t offset = file_.size();
  record_.clear();
  {
    Record record(record_, McapOp::kAttachment);
    record->number(attachment.log_ns);
    record->number(attachment.log_ns);
    record->text(attachment.name);
    record->text(attachment.media_type);
    record->number(static_cast<std::uint64_t>(attachment.data.size()));
    record->bytes(bytes_of(attachment.data));
    record->number(crc32(std::span(record_).subspan(kMcapRecordHead)));
  }
  write(record_);
  Record index(attachment_group_.records, McapOp::kAttachmentIndex);
  index->number(offset);
  index->number(static_cast<std::uint64_t>(record_.size()));
  index->number(attachment.log_ns);
  index->number(attachment.log_ns);
  index->number(static_cast<std::uint64_t>(attachment.data.size()));
  index->text(attachment.name);
  index->text(attachment.media_type);
  ++attachment_group_.count;
}

void McapWriter::add_metadata(std::string_view name, const McapMap& entries) {
  end_chunk();
  const std::uint64_t offset = file_.size();
  record_.clear();
  {
    Record record(record_, McapOp::kMetadata);
    record->text(name);
    write_map(*record.operator->(), entries);
  }
  write(record_);
  Record index(metadata_group_.records, McapOp::kMetadataIndex);
  index->number(offset);
  index->number(static_cast<std::uint64_t>(record_.size()));
  index->text(name);
  ++metadata_group_.count;
}

void McapWriter::message(std::uint16_t channel, std::uint64_t log_ns,
                         std::span<const std::uint8_t> data) {
  Channel& to = channels_[channel];
  if (chunk_.empty()) open_since_ns_ = first_ns_ = last_ns_ = log_ns;
  first_ns_ = std::min(first_ns_, log_ns);
  last_ns_ = std::max(last_ns_, log_ns);
  to.open.push_back({log_ns, chunk_.size()});
  Record record(chunk_, McapOp::kMessage);
  record->number(channel);
  record->number(to.sequence++);
  record->number(log_ns);
  record->number(log_ns);
  record->bytes(data);
}

// Compresses the open chunk into packed_; returns the name of the compression.
std::string_view McapWriter::pack() {
  if (zstd_ != nullptr) {
    packed_.resize(ZSTD_compressBound(chunk_.size()));
    const std::size_t size = ZSTD_compressCCtx(zstd_->context, packed_.data(), packed_.size(),
                                               chunk_.data(), chunk_.size(), kLevel);
    if (ZSTD_isError(size) == 0) {
      packed_.resize(size);
      return "zstd";
    }
  }
  packed_ = chunk_;
  return "";
}

void McapWriter::end_chunk() {
  if (chunk_.empty()) return;
  if (file_.error() == 0) write_chunk();
  for (Channel& channel : channels_) channel.written += channel.open.size();
  drop_chunk();
}

void McapWriter::drop_chunk() {
  chunk_.clear();
  for (Channel& channel : channels_) channel.open.clear();
}

void McapWriter::write_chunk() {
  const std::string_view compression = pack();
  const std::uint64_t offset = file_.size();
  record_.clear();
  {
    Record record(record_, McapOp::kChunk);
    record->number(first_ns_);
    record->number(last_ns_);
    record->number(static_cast<std::uint64_t>(chunk_.size()));
    record->number(crc32(chunk_));
    record->text(compression);
    record->number(static_cast<std::uint64_t>(packed_.size()));
    record->bytes(packed_);
  }
  index_messages(offset, record_.size(), compression);
  begin_ns_ = message_count_ == 0 ? first_ns_ : std::min(begin_ns_, first_ns_);
  end_ns_ = std::max(end_ns_, last_ns_);
  for (const Channel& channel : channels_) message_count_ += channel.open.size();
  write(record_);
  set_index_aside();
}

// Writes the message indexes after the chunk in record_, and its entry in the summary.
void McapWriter::index_messages(std::uint64_t chunk_offset, std::uint64_t chunk_length,
                                std::string_view compression) {
  Record index(chunk_group_.records, McapOp::kChunkIndex);
  index->number(first_ns_);
  index->number(last_ns_);
  index->number(chunk_offset);
  index->number(chunk_length);
  const std::size_t size_at = chunk_group_.records.size();
  index->number<std::uint32_t>(0);
  for (std::uint16_t id = 0; static_cast<std::size_t>(id) < channels_.size(); ++id) {
    const std::vector<Entry>& entries = channels_[id].open;
    if (entries.empty()) continue;
    index->number(id);
    index->number(chunk_offset + record_.size());
    Record record(record_, McapOp::kMessageIndex);
    record->number(id);
    record->number(static_cast<std::uint32_t>(entries.size() * 16));
    for (const Entry& entry : entries) {
      record->number(entry.log_ns);
      record->number(entry.offset);
    }
  }
  index->patch(size_at, static_cast<std::uint32_t>(chunk_group_.records.size() - size_at - 4));
  index->number(static_cast<std::uint64_t>(record_.size()) - chunk_length);
  index->text(compression);
  index->number(static_cast<std::uint64_t>(packed_.size()));
  index->number(static_cast<std::uint64_t>(chunk_.size()));
  ++chunk_group_.count;
}

bool McapWriter::open_index() {
  if (index_ != nullptr) return true;
  try {
    const std::filesystem::path folder = std::filesystem::path(file_.path()).parent_path();
    index_ = std::make_unique<AnonymousFile>(folder.empty() ? "." : folder.string());
    return true;
  } catch (const UserError&) {
    return false;
  }
}

// If the disk refuses the index, it stays in memory.
void McapWriter::set_index_aside() {
  if (chunk_group_.records.size() < kIndexBytes || !open_index()) return;
  if (index_->append(chunk_group_.records) == 0) chunk_group_.records.clear();
}

// If the older part cannot be read, it is omitted: readers also find chunks without an index.
Bytes McapWriter::chunk_index() const {
  Bytes index;
  if (index_ != nullptr) {
    index.resize(index_->size());
    if (index_->read(0, index) != 0) index.clear();
  }
  index.insert(index.end(), chunk_group_.records.begin(), chunk_group_.records.end());
  return index;
}

void McapWriter::write_statistics(ByteWriter& out) const {
  out.number(message_count_);
  out.number(static_cast<std::uint16_t>(schema_group_.count));
  out.number(channel_group_.count);
  out.number(attachment_group_.count);
  out.number(metadata_group_.count);
  out.number(chunk_group_.count);
  out.number(begin_ns_);
  out.number(end_ns_);
  out.number(static_cast<std::uint32_t>(channels_.size() * 10));
  for (std::uint16_t id = 0; static_cast<std::size_t>(id) < channels_.size(); ++id) {
    out.number(id);
    out.number(channels_[id].written);
  }
}

std::uint64_t McapWriter::needed() const {
  std::uint64_t size = 4096 + chunk_.size() + chunk_.size() / 128;
  for (const Channel& channel : channels_) size += 64 + channel.open.size() * 16;
  for (const Group* group :
       {&schema_group_, &channel_group_, &chunk_group_, &attachment_group_, &metadata_group_})
    size += group->records.size();
  if (index_ != nullptr) size += index_->size();
  return size;
}

void McapWriter::finish() {
  end_chunk();
  record_.clear();
  {
    Record record(record_, McapOp::kDataEnd);
    record->number(static_cast<std::uint32_t>(data_crc_.checksum()));
  }
  const std::uint64_t summary_at = record_.size();
  const std::uint64_t file_offset = file_.size();
  Bytes statistics;
  {
    Record record(statistics, McapOp::kStatistics);
    write_statistics(*record.operator->());
  }
  Bytes offsets;
  const auto add_group = [&](McapOp op, const Bytes& records) {
    if (records.empty()) return;
    Record record(offsets, McapOp::kSummaryOffset);
    record->number(static_cast<std::uint8_t>(op));
    record->number(file_offset + record_.size());
    record->number(static_cast<std::uint64_t>(records.size()));
    ByteWriter(record_).bytes(records);
  };
  add_group(McapOp::kSchema, schema_group_.records);
  add_group(McapOp::kChannel, channel_group_.records);
  add_group(McapOp::kStatistics, statistics);
  add_group(McapOp::kChunkIndex, chunk_index());
  add_group(McapOp::kAttachmentIndex, attachment_group_.records);
  add_group(McapOp::kMetadataIndex, metadata_group_.records);
  const std::uint64_t offsets_at = record_.size();
  ByteWriter(record_).bytes(offsets);
  {
    Record footer(record_, McapOp::kFooter);
    footer->number(file_offset + summary_at);
    footer->number(file_offset + offsets_at);
    footer->number<std::uint32_t>(0);
  }
  // The CRC also covers the footer's length, which is known only now.
  const auto covered = std::span(record_).subspan(summary_at, record_.size() - summary_at - 4);
  ByteWriter(record_).patch(record_.size() - 4, crc32(covered));
  ByteWriter(record_).bytes(kMcapMagic);
  write(record_);
}

}  // namespace tp100::record
