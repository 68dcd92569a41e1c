#pragma once
// Sends one JSON datagram per step to a plotting program (PlotJuggler's UDP server).

#include <string>

#include "link/udp.h"
#include "messages/channels.h"
#include "messages/messages.h"
#include "messages/sink.h"

namespace tp100::live {

/// Sends {"timestamp":s,"/estimate":{...},"/sample":{...},"/command":{...},"/slip":{...}}: the Unix
/// time and each channel's message of the step (CHANNELS.md). There may be no receiver; what the
/// system does not accept at once is lost.
class PlotStream : public messages::Sink {
 public:
  /// `address`: "udp:[HOST:]PORT". Looks the host up, so it may block. Throws SetupError.
  PlotStream(const std::string& address, const messages::PublishClock& clock,
             messages::RunContext run_context);

  void take(const StepRecord& record) override;
  void take_truth(HostNs at, const Pose& truth) override;
  void take_setup(const messages::RunContext& run_context, HostNs at) override;

 private:
  link::UdpSender sender_;
  messages::Messages messages_;
  messages::StepMessages step_messages_;
};

}  // namespace tp100::live
