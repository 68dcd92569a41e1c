// ros2_peer DOMAIN [+]TOPIC=TYPE=QOS...: receives topics, and with a plus publishes them, with Fast
// DDS, an implementation that shares nothing with the daemon's. Writes a line of JSON for each
// participant, each writer, each message, each match of a topic of its own and each message that it
// has published. A line "TOPIC=TYPE HEX" on standard input is a message to publish; it ends when
// standard input does. DOMAIN is a number, @ADDRESS after it an address to be restricted to,
// >ADDRESS where to announce itself instead of by multicast. QOS: R reliable or B best effort,
// followed by T transient local or V volatile.

#include <fastcdr/Cdr.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <fastrtps/utils/IPLocator.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/DataWriterListener.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fast = eprosima::fastdds::dds;
namespace rtps = eprosima::fastrtps::rtps;

constexpr std::uint32_t kLargest = 1U << 20U;

void print(const std::string& line) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  std::puts(line.c_str());
  std::fflush(stdout);
}

std::int64_t unix_ns() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

std::string hex(const std::uint8_t* bytes, std::size_t size) {
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string out;
  out.reserve(2 * size);
  for (std::size_t i = 0; i < size; ++i) {
    out += kDigits[bytes[i] >> 4U];
    out += kDigits[bytes[i] & 15U];
  }
  return out;
}

std::vector<std::uint8_t> bytes_of(const std::string& text) {
  std::vector<std::uint8_t> out;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2)
    out.push_back(static_cast<std::uint8_t>(std::stoul(text.substr(i, 2), nullptr, 16)));
  return out;
}

std::string guid_text(const rtps::GUID_t& guid) {
  return hex(guid.guidPrefix.value, 12) + hex(guid.entityId.value, 4);
}

/// The address after `mark` in the first argument; empty: none.
std::string address_behind(char mark, const std::string& domain) {
  const std::size_t at = domain.find(mark);
  if (at == std::string::npos) return {};
  const std::size_t end = domain.find_first_not_of("0123456789.", at + 1);
  return domain.substr(at + 1, end == std::string::npos ? end : end - at - 1);
}

template <class UserData>
std::string text_of(const UserData& data) {
  return {data.begin(), data.end()};
}

/// Any type, as received bytes.
class RawType : public fast::TopicDataType {
 public:
  explicit RawType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = kLargest;
    m_isGetKeyDefined = false;
    auto_fill_type_information(false);
    auto_fill_type_object(false);
  }
  bool serialize(void* in, rtps::SerializedPayload_t* payload) override {
    const auto& bytes = *static_cast<const std::vector<std::uint8_t>*>(in);
    std::memcpy(payload->data, bytes.data(), bytes.size());
    payload->length = static_cast<std::uint32_t>(bytes.size());
    payload->encapsulation = CDR_LE;
    return true;
  }
  bool deserialize(rtps::SerializedPayload_t* payload, void* out) override {
    static_cast<std::vector<std::uint8_t>*>(out)->assign(payload->data,
                                                         payload->data + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void* data) override {
    return [data] {
      return static_cast<std::uint32_t>(static_cast<std::vector<std::uint8_t>*>(data)->size());
    };
  }
  void* createData() override { return new std::vector<std::uint8_t>; }
  void deleteData(void* data) override { delete static_cast<std::vector<std::uint8_t>*>(data); }
  bool getKey(void*, rtps::InstanceHandle_t*, bool) override { return false; }
};

class Discovery : public fast::DomainParticipantListener {
 public:
  void on_participant_discovery(fast::DomainParticipant*,
                                rtps::ParticipantDiscoveryInfo&& found) override {
    if (found.status != rtps::ParticipantDiscoveryInfo::DISCOVERED_PARTICIPANT) return;
    print("{\"participant\":\"" + guid_text(found.info.m_guid) + "\",\"user_data\":\"" +
          text_of(found.info.m_userData) + "\"}");
  }
  void on_publisher_discovery(fast::DomainParticipant*,
                              rtps::WriterDiscoveryInfo&& found) override {
    if (found.status != rtps::WriterDiscoveryInfo::DISCOVERED_WRITER) return;
    const auto& qos = found.info.m_qos;
    const bool reliable = qos.m_reliability.kind == fast::RELIABLE_RELIABILITY_QOS;
    const bool transient = qos.m_durability.kind == fast::TRANSIENT_LOCAL_DURABILITY_QOS;
    print("{\"writer\":\"" + guid_text(found.info.guid()) + "\",\"topic\":\"" +
          found.info.topicName().to_string() + "\",\"type\":\"" +
          found.info.typeName().to_string() + "\",\"user_data\":\"" + text_of(qos.m_userData) +
          "\",\"qos\":\"" + (reliable ? 'R' : 'B') + (transient ? 'T' : 'V') + "\"}");
  }
};

class Messages : public fast::DataReaderListener {
 public:
  void on_data_available(fast::DataReader* reader) override {
    std::vector<std::uint8_t> bytes;
    fast::SampleInfo info;
    while (reader->take_next_sample(&bytes, &info) == ReturnCode_t::RETCODE_OK) {
      if (!info.valid_data) continue;
      print("{\"message\":\"" + reader->get_topicdescription()->get_name() + "\",\"received_ns\":" +
            std::to_string(unix_ns()) + ",\"cdr\":\"" + hex(bytes.data(), bytes.size()) + "\"}");
    }
  }
  void on_requested_incompatible_qos(fast::DataReader* reader,
                                     const fast::RequestedIncompatibleQosStatus&) override {
    print("{\"incompatible\":\"" + reader->get_topicdescription()->get_name() + "\"}");
  }
};

class Matches : public fast::DataWriterListener {
 public:
  void on_publication_matched(fast::DataWriter* writer,
                              const fast::PublicationMatchedStatus& status) override {
    print("{\"matched\":\"" + writer->get_topic()->get_name() + "=" +
          writer->get_topic()->get_type_name() +
          "\",\"count\":" + std::to_string(status.current_count) + "}");
  }
};

/// Quality of service of a reader or writer.
template <class AnyQos>
AnyQos with(AnyQos qos, const std::string& wanted) {
  qos.reliability().kind =
      wanted[0] == 'R' ? fast::RELIABLE_RELIABILITY_QOS : fast::BEST_EFFORT_RELIABILITY_QOS;
  qos.durability().kind =
      wanted[1] == 'T' ? fast::TRANSIENT_LOCAL_DURABILITY_QOS : fast::VOLATILE_DURABILITY_QOS;
  return qos;
}

}  // namespace

int main(int argc, char** argv) {
  Discovery discovery;
  const std::string domain = argv[1];
  Messages messages;
  Matches matches;
  fast::DomainParticipantQos participant_qos = fast::PARTICIPANT_QOS_DEFAULT;
  // Without shared memory, which would leave files behind.
  participant_qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->receiveBufferSize = kLargest;
  if (const std::string only = address_behind('@', domain); !only.empty())
    udp->interfaceWhiteList.push_back(only);
  if (const std::string peer = address_behind('>', domain); !peer.empty()) {
    rtps::Locator_t locator;
    rtps::IPLocator::setIPv4(locator, peer);
    participant_qos.wire_protocol().builtin.initialPeersList.push_back(locator);
  }
  participant_qos.transport().user_transports.push_back(udp);
  auto* const factory = fast::DomainParticipantFactory::get_instance();
  auto* const participant =
      factory->create_participant(static_cast<fast::DomainId_t>(std::stoul(domain)),
                                  participant_qos, &discovery, fast::StatusMask::none());
  auto* const subscriber = participant->create_subscriber(fast::SUBSCRIBER_QOS_DEFAULT);
  auto* const publisher = participant->create_publisher(fast::PUBLISHER_QOS_DEFAULT);
  std::map<std::string, fast::DataWriter*> writers;
  for (int i = 2; i < argc; ++i) {
    const bool publishes = argv[i][0] == '+';
    const std::string argument = argv[i] + (publishes ? 1 : 0);
    const std::size_t first = argument.find('='), second = argument.rfind('=');
    const std::string name = argument.substr(0, first), qos = argument.substr(second + 1);
    const fast::TypeSupport type(new RawType(argument.substr(first + 1, second - first - 1)));
    type.register_type(participant);
    auto* const topic =
        participant->create_topic(name, type.get_type_name(), fast::TOPIC_QOS_DEFAULT);
    if (topic == nullptr) return 1;
    if (publishes) {
      fast::DataWriterQos offered = with(fast::DATAWRITER_QOS_DEFAULT, qos);
      // Like another version of the type: only the received bytes matter.
      constexpr std::string_view kOther = "typehash=RIHS01_00;";
      offered.user_data().data_vec({kOther.begin(), kOther.end()});
      auto* const writer = publisher->create_datawriter(topic, offered, &matches);
      if (writer == nullptr) return 1;
      writers[argument.substr(0, second)] = writer;
      continue;
    }
    fast::DataReaderQos reader = with(fast::DATAREADER_QOS_DEFAULT, qos);
    reader.history().kind = fast::KEEP_ALL_HISTORY_QOS;
    if (subscriber->create_datareader(topic, reader, &messages) == nullptr) return 1;
  }
  print("{\"listening\":true}");
  for (std::string line; std::getline(std::cin, line);) {
    const std::size_t space = line.find(' ');
    std::vector<std::uint8_t> bytes = bytes_of(line.substr(space + 1));
    writers.at(line.substr(0, space))->write(&bytes);
    print("{\"written_ns\":" + std::to_string(unix_ns()) + "}");
  }
  participant->delete_contained_entities();
  factory->delete_participant(participant);
  return 0;
}
