// Golden trace of the link to the host.

#include <gtest/gtest.h>

#include <vector>

#include "../support/wire_host.h"
#include "firmware/host_link.h"
#include "scripted_hal.h"
#include "support/golden_trace.h"

namespace tp100::firmware {
namespace {

// What leaves, and in which order, when the line takes a little more each time.
class LinkTrace : public test::ReceivedFrames {
 public:
  void post(int step) {
    const auto token = static_cast<std::uint32_t>(step);
    const auto small = static_cast<std::uint8_t>(step);
    switch (step * 5 % 9) {
      case 0:
        return link.post(wire::Acknowledge{small, token, 3, 7});
      case 1:
        return link.post(wire::FaultReport{token, small, 5, -step});
      case 2: {
        wire::Sample sample{};
        sample.sequence = small;
        return link.post(sample);
      }
      case 3:
        return link.post(wire::SyncReply{small, token, 0, 1, 2});
      case 4: {
        wire::Hello hello{};
        hello.boot_nonce = token;
        return link.post(hello);
      }
      case 5:
        return link.log(small % 3, "what was said: ", "and more of it, which ends somewhere",
                        token);
      case 6:
        return link.log(2, "", "short", token);
      case 7:
        return link.log(1, "a text that is longer than the line of a log can be", "!", token);
      default:
        return link.post(wire::Acknowledge{2, token, 0, 9});
    }
  }
  // Each frame that left: step, type, the number it was posted with, level and length of a text.
  void write(int step) {
    for (const std::uint8_t byte : hal.sent) {
      const auto type = receive(byte);
      if (!type) continue;
      double number = 0.0, more = 0.0, text = 0.0;
      if (*type == wire::Type::kHello) number = hellos.back().boot_nonce;
      if (*type == wire::Type::kSample) number = samples.back().sequence;
      if (*type == wire::Type::kAcknowledge) number = acknowledges.back().token;
      if (*type == wire::Type::kSyncReply) {
        number = sync_replies.back().id;
        more = static_cast<std::int32_t>(hal.now_us - sync_replies.back().sent_us);
      }
      if (*type == wire::Type::kFaultReport) number = reports.back().device_us;
      if (*type == wire::Type::kLog) {
        number = log_messages.back().device_us;
        more = log_messages.back().level;
        for (const std::uint8_t letter : log_messages.back().text) text = text * 1.01 + letter;
      }
      trace.row({1.0 * step, 1.0 * static_cast<int>(*type), number, more, text,
                 1.0 * static_cast<double>(hal.sent.size()), 1.0 * link.counts().unsent,
                 1.0 * bad_frames});
    }
    hal.sent.clear();
  }

  ScriptedHal hal;
  HostLink link{hal};
  test::GoldenTrace trace{"firmware/link.csv",
                          {"step", "type", "number", "more", "text", "bytes", "unsent", "bad"}};
};

TEST(GoldenLink, SendsInTheRecordedOrderAsMuchAsTheLineTakes) {
  LinkTrace t;
  for (int step = 1; step < 1200; ++step) {
    t.hal.now_us += 1000;
    t.hal.waiting = static_cast<std::uint8_t>(step % 50);
    // Hardly any room for a while, then ever more of it.
    const int phase = step % 300;
    t.hal.room = static_cast<std::size_t>(phase < 150 ? phase % 14 : (phase - 150) * 7 % 83);
    if (phase < 220) t.post(step);
    t.link.flush();
    t.write(step);
    t.hal.room = static_cast<std::size_t>(phase < 150 ? 0 : step % 53);
    t.link.flush();
    t.write(step);
  }
  EXPECT_FALSE(t.hal.overfilled);
  EXPECT_EQ(t.trace.difference(1e-8), "");
}

}  // namespace
}  // namespace tp100::firmware
