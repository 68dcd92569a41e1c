#include "ros2/participant.h"

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsi/q_radmin.h>
#include <pthread.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/error.h"
#include "ros2/message_types.h"
#include "text/format.h"
#include "text/standard_streams.h"

namespace tp100::ros2 {
namespace {

constexpr int kLastDomain = 232;  // by the ports that RTPS derives from the number

// Messages are passed to Cyclone DDS as CDR, so it needs only the names of their types.

/// A message; without keys, because ROS 2's topics have none.
struct CdrData : ddsi_serdata {
  CdrData(const ddsi_sertype* of, ddsi_serdata_kind as, Bytes content)
      : ddsi_serdata{}, bytes(std::move(content)), size(static_cast<std::uint32_t>(bytes.size())) {
    ddsi_serdata_init(this, of, as);
    // Cyclone DDS reads up to a multiple of four.
    bytes.resize((bytes.size() + 3) / 4 * 4);
  }
  static const CdrData& of(const ddsi_serdata* data) { return *static_cast<const CdrData*>(data); }
  Bytes bytes;
  std::uint32_t size;
};

// Longer than any message that is read; longer ones are not kept.
constexpr std::size_t kLargestTaken = 4096;

/// A message from the network, in fragments that may overlap.
ddsi_serdata* received(const ddsi_sertype* type, ddsi_serdata_kind kind, const nn_rdata* fragments,
                       size_t size) {
  Bytes bytes;
  if (size <= kLargestTaken) bytes.resize(size);
  std::size_t filled = 0;
  for (; fragments != nullptr && !bytes.empty(); fragments = fragments->nextfrag) {
    const std::size_t end = std::min<std::size_t>(fragments->maxp1, size);
    if (end <= filled) continue;
    const unsigned char* const payload =
        NN_RMSG_PAYLOADOFF(fragments->rmsg, NN_RDATA_PAYLOAD_OFF(fragments));
    std::memcpy(bytes.data() + filled, payload + (filled - fragments->min), end - filled);
    filled = end;
  }
  return new CdrData(type, kind, std::move(bytes));
}

/// A message of this process's own domain.
ddsi_serdata* received_at_once(const ddsi_sertype* type, ddsi_serdata_kind kind,
                               ddsrt_msg_iovlen_t count, const ddsrt_iovec_t* parts, size_t size) {
  Bytes bytes;
  for (std::size_t i = 0; i < count && size <= kLargestTaken; ++i) {
    const auto* const from = static_cast<const std::uint8_t*>(parts[i].iov_base);
    bytes.insert(bytes.end(), from, from + std::min(parts[i].iov_len, size - bytes.size()));
  }
  return new CdrData(type, kind, std::move(bytes));
}

ddsi_serdata* shared(const ddsi_serdata* data, size_t from, size_t size, ddsrt_iovec_t* out) {
  out->iov_base = const_cast<std::uint8_t*>(CdrData::of(data).bytes.data() + from);
  out->iov_len = size;
  return ddsi_serdata_ref(data);
}

const ddsi_serdata_ops& data_operations() {
  static const ddsi_serdata_ops kOperations = [] {
    ddsi_serdata_ops ops{};  // messages are read as CDR: operations that decode it stay null
    ops.from_ser = received;
    ops.from_ser_iov = received_at_once;
    ops.from_keyhash = [](const ddsi_sertype* type, const ddsi_keyhash*) -> ddsi_serdata* {
      return new CdrData(type, SDK_KEY, {});
    };
    ops.eqkey = [](const ddsi_serdata*, const ddsi_serdata*) { return true; };
    ops.get_size = [](const ddsi_serdata* data) { return CdrData::of(data).size; };
    ops.to_ser = [](const ddsi_serdata* data, size_t from, size_t size, void* out) {
      std::memcpy(out, CdrData::of(data).bytes.data() + from, size);
    };
    ops.to_ser_ref = shared;
    ops.to_ser_unref = [](ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); };
    ops.to_untyped = [](const ddsi_serdata* data) -> ddsi_serdata* {
      auto* key = new CdrData(data->type, SDK_KEY, {});
      key->type = nullptr;
      return key;
    };
    ops.free = [](ddsi_serdata* data) { delete static_cast<CdrData*>(data); };
    ops.print = [](const ddsi_sertype*, const ddsi_serdata*, char* out, size_t) -> size_t {
      *out = '\0';
      return 0;
    };
    ops.get_keyhash = [](const ddsi_serdata*, ddsi_keyhash* out, bool) {
      std::memset(out, 0, sizeof *out);
    };
    return ops;
  }();
  return kOperations;
}

const ddsi_sertype_ops& type_operations() {
  static const ddsi_sertype_ops kOperations = [] {
    ddsi_sertype_ops ops{};
    ops.version = ddsi_sertype_v0;
    ops.free = [](ddsi_sertype* type) {
      ddsi_sertype_fini(type);
      delete type;
    };
    // Cyclone DDS compares names and operations before.
    ops.equal = [](const ddsi_sertype*, const ddsi_sertype*) { return true; };
    ops.hash = [](const ddsi_sertype*) -> std::uint32_t { return 0; };
    return ops;
  }();
  return kOperations;
}

dds_domainid_t domain_of(const config::Ros2Settings& settings) {
  if (settings.domain >= 0) return static_cast<dds_domainid_t>(settings.domain);
  const std::string variable = text::environment_variable("ROS_DOMAIN_ID");
  if (variable.empty()) return 0;
  const int domain = text::number_in<int>(variable).value_or(-1);
  if (domain < 0 || domain > kLastDomain)
    throw UserError("ROS_DOMAIN_ID=" + one_line(variable) +
                    ": not a domain; use a number from 0 to " + std::to_string(kLastDomain));
  return static_cast<dds_domainid_t>(domain);
}

/// Configuration of Cyclone DDS for that interface; without one it is the environment's.
std::string dds_configuration(const std::string& interface) {
  if (interface.empty()) return text::environment_variable("CYCLONEDDS_URI");
  constexpr const char* kMayHave =
      "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ._-:@";
  if (interface.find_first_not_of(kMayHave) != std::string::npos)
    throw UserError("ros2.interface = \"" + one_line(interface) +
                    "\": not a network interface; `ip link` lists them");
  // The loopback interface can multicast although it does not report so; if it cannot, participants
  // are found at the ports where ROS 2's own participants look, too.
  const bool local = interface == "lo";
  return "<CycloneDDS><Domain id=\"any\"><General><Interfaces><NetworkInterface name=\"" +
         interface + "\"" + (local ? " multicast=\"true\"" : "") + "/></Interfaces></General>" +
         (local ? "<Discovery><ParticipantIndex>auto</ParticipantIndex>"
                  "<MaxAutoParticipantIndex>32</MaxAutoParticipantIndex>"
                  "<Peers><Peer address=\"127.0.0.1\"/></Peers></Discovery>"
                : "") +
         "</Domain></CycloneDDS>";
}

/// Descriptors of this process that are datagram sockets.
std::set<int> datagram_sockets() {
  std::set<int> out;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    const int fd = std::stoi(entry.path().filename().string());
    int type = 0;
    socklen_t size = sizeof type;
    if (::getsockopt(fd, SOL_SOCKET, SO_TYPE, &type, &size) == 0 && type == SOCK_DGRAM)
      out.insert(fd);
  }
  return out;
}

/// Cyclone DDS sends through one interface but listens at all addresses. Makes the sockets that
/// were opened since `before` receive nothing from other machines.
void receive_of_this_machine_only(const std::set<int>& before) {
  constexpr std::string_view kDevice = "lo";
  for (const int fd : datagram_sockets())
    if (!before.contains(fd) && ::setsockopt(fd, SOL_SOCKET, SO_BINDTODEVICE, kDevice.data(),
                                             socklen_t{kDevice.size()}) != 0)
      throw UserError("[ros2]: the sockets cannot be kept to lo (" +
                      std::string(std::strerror(errno)) +
                      "), and would receive from other machines; set ros2.enabled to false");
}

/// Threads started during its lifetime have small stacks. With locked memory each thread occupies
/// its whole stack: 8 MB by default, of which the threads of Cyclone DDS need little.
class SmallStacks {
 public:
  SmallStacks() {
    pthread_getattr_default_np(&before_);
    pthread_attr_t small = before_;
    pthread_attr_setstacksize(&small, kBytes);
    pthread_setattr_default_np(&small);
  }
  ~SmallStacks() {
    pthread_setattr_default_np(&before_);
    pthread_attr_destroy(&before_);
  }
  SmallStacks(const SmallStacks&) = delete;
  SmallStacks& operator=(const SmallStacks&) = delete;

 private:
  static constexpr std::size_t kBytes = std::size_t{1} << 20U;
  pthread_attr_t before_{};
};

/// Quality of service that ROS 2's own participants give a topic.
struct QosOf {
  QosOf(const Qos& qos, const MessageType& type) : dds(dds_create_qos()) {
    dds_qset_reliability(dds, qos.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                         0);
    dds_qset_history(dds, DDS_HISTORY_KEEP_LAST, qos.depth);
    if (qos.transient_local) {
      dds_qset_durability(dds, DDS_DURABILITY_TRANSIENT_LOCAL);
      dds_qset_durability_service(dds, 0, DDS_HISTORY_KEEP_LAST, qos.depth, DDS_LENGTH_UNLIMITED,
                                  DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
    }
    dds_qset_writer_data_lifecycle(dds, false);
    const dds_data_representation_id_t cdr = DDS_DATA_REPRESENTATION_XCDR1;
    dds_qset_data_representation(dds, 1, &cdr);
    const std::string data = "typehash=" + std::string(type.hash) + ";";
    dds_qset_userdata(dds, data.data(), data.size());
  }
  ~QosOf() { dds_delete_qos(dds); }
  QosOf(const QosOf&) = delete;
  QosOf& operator=(const QosOf&) = delete;
  dds_qos_t* dds;
};

/// The publisher of one topic.
struct Writer {
  dds_entity_t entity = 0;
  const ddsi_sertype* type = nullptr;

  /// If a subscriber is slow, a reliable message replaces an older one that is kept for it.
  void write(Bytes cdr) const { dds_writecdr(entity, new CdrData(type, SDK_DATA, std::move(cdr))); }
};

/// The subscription to one topic.
struct Reader {
  Input input{};
  dds_entity_t entity = 0;

  void take(const std::function<void(const Received&)>& receive) const {
    std::array<ddsi_serdata*, kAtOnce> messages{};
    std::array<dds_sample_info_t, kAtOnce> infos{};
    const dds_return_t count =
        dds_takecdr(entity, messages.data(), kAtOnce, infos.data(), DDS_ANY_STATE);
    for (std::size_t i = 0; i < static_cast<std::size_t>(std::max(count, 0)); ++i) {
      const dds_sample_info_t& info = infos[i];
      const CdrData& data = CdrData::of(messages[i]);
      if (info.valid_data || info.instance_state == DDS_IST_NOT_ALIVE_NO_WRITERS)
        receive({.input = input,
                 .writer = info.publication_handle,
                 .written_ns = info.source_timestamp,
                 .taken_ns = unix_now_ns(),
                 .cdr = info.valid_data ? std::span(data.bytes).first(data.size)
                                        : std::span<const std::uint8_t>{},
                 .gone = !info.valid_data});
      ddsi_serdata_unref(messages[i]);
    }
  }

 private:
  static constexpr std::uint32_t kAtOnce = 16;
};

rmw_dds_common::Gid gid_of(dds_entity_t entity) {
  dds_guid_t guid{};
  dds_get_guid(entity, &guid);
  rmw_dds_common::Gid gid;
  std::copy(std::begin(guid.v), std::end(guid.v), gid.data.begin());
  return gid;
}

}  // namespace

struct Participant::State {
  State(const config::Ros2Settings& settings, const std::string& node,
        std::span<const Topic> published, std::span<const Input> taken) {
    const std::set<int> before = datagram_sockets();
    join(settings);
    try {
      if (settings.interface == "lo") receive_of_this_machine_only(before);
      for (const Topic topic : published) {
        const TopicText& text = topics().at(static_cast<std::size_t>(topic));
        writers.emplace(topic, writer("rt" + std::string(text.name), *text.type, text.qos));
      }
      for (const Input input : taken) {
        const InputText& text = inputs().at(static_cast<std::size_t>(input));
        readers.push_back({input, reader("rt" + std::string(text.name), *text.type, text.qos)});
      }
      announce(node);
    } catch (...) {
      dds_delete(domain);
      throw;
    }
  }
  ~State() { dds_delete(domain); }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  void join(const config::Ros2Settings& settings) {
    const dds_domainid_t number = domain_of(settings);
    const std::string configuration = dds_configuration(settings.interface);
    // The log of Cyclone DDS has the reason of a failure.
    std::string why;
    dds_set_log_sink(
        [](void* out, const dds_log_data_t* line) {
          *static_cast<std::string*>(out) = std::string(line->message, line->size);
        },
        &why);
    const SmallStacks stacks;
    domain = dds_create_domain(number, configuration.c_str());
    dds_qos_t* const qos = dds_create_qos();
    constexpr std::string_view kEnclave = "enclave=/;";
    dds_qset_userdata(qos, kEnclave.data(), kEnclave.size());
    participant = domain < 0 ? domain : dds_create_participant(number, qos, nullptr);
    dds_delete_qos(qos);
    dds_set_log_sink(nullptr, nullptr);
    if (participant >= 0) return;
    if (domain >= 0) dds_delete(domain);
    throw UserError("[ros2]: cannot join domain " + std::to_string(number) + ": " +
                    (why.empty() ? dds_strretcode(-participant) : one_line(why)) +
                    "; check ros2.interface and ros2.domain, and for a service the drop-in of "
                    "ROS2.md");
  }
  /// A topic of that type, and the type that it has in this domain.
  std::pair<dds_entity_t, const ddsi_sertype*> topic(const std::string& name,
                                                     const MessageType& type) const {
    auto* wanted = new ddsi_sertype{};
    ddsi_sertype_init_flags(wanted, std::string(type.dds_name).c_str(), &type_operations(),
                            &data_operations(), DDSI_SERTYPE_FLAG_TOPICKIND_NO_KEY);
    ddsi_sertype* used = wanted;
    const dds_entity_t entity =
        dds_create_topic_sertype(participant, name.c_str(), &used, nullptr, nullptr, nullptr);
    if (entity < 0) ddsi_sertype_unref(wanted);
    return {checked(entity, name), used};
  }
  Writer writer(const std::string& name, const MessageType& type, const Qos& offered) const {
    const auto [of, used] = topic(name, type);
    const QosOf qos(offered, type);
    return {checked(dds_create_writer(participant, of, qos.dds, nullptr), name), used};
  }
  dds_entity_t reader(const std::string& name, const MessageType& type, const Qos& wanted) const {
    const QosOf qos(wanted, type);
    return checked(dds_create_reader(participant, topic(name, type).first, qos.dds, nullptr), name);
  }
  static dds_entity_t checked(dds_entity_t entity, const std::string& name) {
    if (entity >= 0) return entity;
    throw UserError("[ros2]: topic " + name + " is impossible (" + dds_strretcode(-entity) +
                    "); set ros2.enabled to false");
  }
  /// Announces the node, its publishers and subscriptions to ROS 2's graph.
  void announce(const std::string& node) {
    graph = writer("ros_discovery_info", rmw_dds_common::ParticipantEntitiesInfo::kType,
                   {.transient_local = true, .depth = 1});
    rmw_dds_common::NodeEntitiesInfo entities{.node_namespace = "/", .node_name = node};
    for (const auto& [topic, writer] : writers)
      entities.writer_gid_seq.push_back(gid_of(writer.entity));
    for (const Reader& reader : readers) entities.reader_gid_seq.push_back(gid_of(reader.entity));
    graph.write(serialized(rmw_dds_common::ParticipantEntitiesInfo{
        .gid = gid_of(participant), .node_entities_info_seq = {entities}}));
  }

  dds_entity_t domain = 0, participant = 0;
  std::map<Topic, Writer> writers;
  std::vector<Reader> readers;
  Writer graph{};
};

Participant::Participant(const config::Ros2Settings& settings, const std::string& node,
                         std::span<const Topic> published, std::span<const Input> taken)
    : state_(std::make_unique<State>(settings, node, published, taken)) {}
Participant::~Participant() = default;
void Participant::write(Topic topic, Bytes cdr) { state_->writers.at(topic).write(std::move(cdr)); }
void Participant::take(const std::function<void(const Received&)>& receive) {
  for (const Reader& reader : state_->readers) reader.take(receive);
}

}  // namespace tp100::ros2
