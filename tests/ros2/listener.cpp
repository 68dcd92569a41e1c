// ros2_listener DOMAIN TOPIC=TYPE=QOS...: receives topics with Fast DDS, an implementation that
// shares nothing with the daemon's. Writes a line of JSON for each participant, each writer and
// each message that it finds, and ends when standard input does. QOS: R reliable or B best effort,
// followed by T transient local or V volatile.

#include <fastcdr/Cdr.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/domain/DomainParticipantListener.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <fastdds/dds/topic/TypeSupport.hpp>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
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

std::string guid_text(const rtps::GUID_t& guid) {
  return hex(guid.guidPrefix.value, 12) + hex(guid.entityId.value, 4);
}

template <class UserData>
std::string text_of(const UserData& data) {
  return {data.begin(), data.end()};
}

/// Any type: the bytes as they came.
class RawType : public fast::TopicDataType {
 public:
  explicit RawType(const std::string& name) {
    setName(name.c_str());
    m_typeSize = kLargest;
    m_isGetKeyDefined = false;
    auto_fill_type_information(false);
    auto_fill_type_object(false);
  }
  bool serialize(void*, rtps::SerializedPayload_t*) override { return false; }
  bool deserialize(rtps::SerializedPayload_t* payload, void* out) override {
    static_cast<std::vector<std::uint8_t>*>(out)->assign(payload->data,
                                                         payload->data + payload->length);
    return true;
  }
  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [] { return kLargest; };
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
      const auto now = std::chrono::system_clock::now().time_since_epoch();
      print("{\"message\":\"" + reader->get_topicdescription()->get_name() + "\",\"sent_ns\":" +
            std::to_string(info.source_timestamp.to_ns()) + ",\"received_ns\":" +
            std::to_string(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count()) +
            ",\"cdr\":\"" + hex(bytes.data(), bytes.size()) + "\"}");
    }
  }
  void on_requested_incompatible_qos(fast::DataReader* reader,
                                     const fast::RequestedIncompatibleQosStatus&) override {
    print("{\"incompatible\":\"" + reader->get_topicdescription()->get_name() + "\"}");
  }
};

}  // namespace

int main(int argc, char** argv) {
  Discovery discovery;
  Messages messages;
  fast::DomainParticipantQos participant_qos = fast::PARTICIPANT_QOS_DEFAULT;
  // Without shared memory, which would leave files behind.
  participant_qos.transport().use_builtin_transports = false;
  auto udp = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
  udp->receiveBufferSize = kLargest;
  const std::string domain = argv[1];
  if (const std::size_t at = domain.find('@'); at != std::string::npos)
    udp->interfaceWhiteList.push_back(domain.substr(at + 1));
  participant_qos.transport().user_transports.push_back(udp);
  auto* const factory = fast::DomainParticipantFactory::get_instance();
  auto* const participant =
      factory->create_participant(static_cast<fast::DomainId_t>(std::stoul(domain)),
                                  participant_qos, &discovery, fast::StatusMask::none());
  auto* const subscriber = participant->create_subscriber(fast::SUBSCRIBER_QOS_DEFAULT);
  for (int i = 2; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t first = argument.find('='), second = argument.rfind('=');
    const std::string name = argument.substr(0, first), qos = argument.substr(second + 1);
    const fast::TypeSupport type(new RawType(argument.substr(first + 1, second - first - 1)));
    type.register_type(participant);
    auto* const topic =
        participant->create_topic(name, type.get_type_name(), fast::TOPIC_QOS_DEFAULT);
    fast::DataReaderQos reader = fast::DATAREADER_QOS_DEFAULT;
    reader.reliability().kind =
        qos[0] == 'R' ? fast::RELIABLE_RELIABILITY_QOS : fast::BEST_EFFORT_RELIABILITY_QOS;
    reader.durability().kind =
        qos[1] == 'T' ? fast::TRANSIENT_LOCAL_DURABILITY_QOS : fast::VOLATILE_DURABILITY_QOS;
    reader.history().kind = fast::KEEP_ALL_HISTORY_QOS;
    if (topic == nullptr || subscriber->create_datareader(topic, reader, &messages) == nullptr)
      return 1;
  }
  print("{\"listening\":true}");
  for (char c = 0; ::read(STDIN_FILENO, &c, 1) > 0;) {
  }
  participant->delete_contained_entities();
  factory->delete_participant(participant);
  return 0;
}
