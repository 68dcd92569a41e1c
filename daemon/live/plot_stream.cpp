#include "live/plot_stream.h"

#include <utility>

#include "core/time.h"
#include "text/format.h"

namespace tp100::live {
namespace {

/// Null: not for plots.
const char* plotted_topic(messages::Channel channel) {
  switch (channel) {
    case messages::Channel::kEstimate:
      return "/estimate";
    case messages::Channel::kSample:
      return "/sample";
    case messages::Channel::kCommand:
      return "/command";
    case messages::Channel::kSlip:
      return "/slip";
    default:
      return nullptr;
  }
}

}  // namespace

PlotStream::PlotStream(const std::string& address, const messages::PublishClock& clock,
                       messages::RunContext run_context)
    : sender_(link::parse_udp(address, "server.plot")),
      messages_(std::move(run_context), clock),
      step_messages_(messages_, false) {}

void PlotStream::take(const StepRecord& record) {
  const double unix_s = static_cast<double>(messages_.clock().unix_ns(record.now_ns)) * 1e-9;
  std::string datagram = text::format("{\"timestamp\":%.6f", unix_s);
  step_messages_.take(record, plotted_topic,
                      [&](messages::Channel channel, HostNs, const std::string& json) {
                        datagram += ",\"" + std::string(plotted_topic(channel)) + "\":" + json;
                      });
  sender_.send(datagram + "}");
}

void PlotStream::take_truth(HostNs at, const Pose& truth) {
  step_messages_.take_truth({at, truth});
}

void PlotStream::take_setup(const messages::RunContext& run_context, HostNs) {
  messages_ = messages::Messages(run_context, messages_.clock());
}

}  // namespace tp100::live
