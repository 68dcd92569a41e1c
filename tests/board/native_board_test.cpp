#include "sim/board/native_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <random>

#include "../support/wire_host.h"
#include "still_imu.h"

namespace tp100::sim {
namespace {

constexpr std::int64_t kMs = 1'000'000;
constexpr std::int64_t kByteNs = 20'000;

// A board, a host that collects frames, and the wires between them.
class Rig : public test::ReceivedFrames {
 public:
  explicit Rig(NativeBoardSettings settings = {}) : board(settings, &imu) {
    board.set_battery(7.9);
    board.reset(PowerUp::kPowerOn, 0);
  }

  void run(int ms) {
    for (int i = 0; i < ms; ++i) {
      const std::int64_t until_ns = now_ns + kMs;
      std::vector<TimedByte> arriving;
      while (!host_out.empty() && host_out.front().at_ns <= until_ns) {
        arriving.push_back(host_out.front());
        host_out.erase(host_out.begin());
      }
      std::vector<EncoderEdge> now_edges;
      while (!edges.empty() && edges.front().at_ns <= until_ns) {
        now_edges.push_back(edges.front());
        edges.erase(edges.begin());
      }
      board.advance(until_ns, now_edges, arriving);
      now_ns = until_ns;
      for (const TimedByte& byte : board.take_sent()) take(byte);
    }
  }
  template <class Message>
  void send(const Message& message) {
    send_bytes(test::frame_of(message));
  }
  void send_bytes(const std::vector<std::uint8_t>& bytes) {
    for (const std::uint8_t value : bytes) {
      line_free_ns = std::max(line_free_ns, now_ns) + kByteNs;
      host_out.push_back({line_free_ns, value});
    }
  }
  void connect() {
    run(20);
    ASSERT_FALSE(hellos.empty());
    wire::Parameters parameters = test::good_parameters();
    parameters.boot_nonce = hellos.back().boot_nonce;
    send(parameters);
    run(20);
    ASSERT_FALSE(samples.empty());
  }

  StillImu imu;
  NativeBoard board;
  std::int64_t now_ns = 0;
  std::int64_t line_free_ns = 0;
  std::vector<TimedByte> host_out;
  std::vector<EncoderEdge> edges;
  std::vector<TimedByte> sent;
  std::vector<std::int64_t> hello_at_ns;
  std::vector<std::int64_t> sample_at_ns;

 private:
  void take(const TimedByte& byte) {
    sent.push_back(byte);
    const std::optional<wire::Type> type = receive(byte.value);
    if (type == wire::Type::kHello) hello_at_ns.push_back(byte.at_ns);
    if (type == wire::Type::kSample) sample_at_ns.push_back(byte.at_ns);
  }
};

TEST(NativeBoard, IsSilentWithoutPower) {
  NativeBoard board({}, nullptr);
  board.advance(100 * kMs, {}, {});
  EXPECT_TRUE(board.take_sent().empty());
}

TEST(NativeBoard, SaysHelloAfterItsBootDelay) {
  NativeBoardSettings settings;
  settings.boot_delay_ns = 840 * kMs;
  Rig rig(settings);
  rig.run(1500);
  ASSERT_GE(rig.hellos.size(), 3U);
  EXPECT_GT(rig.hello_at_ns[0], 840 * kMs);
  EXPECT_LT(rig.hello_at_ns[0], 845 * kMs);
  EXPECT_NEAR(static_cast<double>(rig.hello_at_ns[2] - rig.hello_at_ns[1]), 200.0 * kMs, 1.0 * kMs);
  EXPECT_EQ(rig.hellos[0].board, static_cast<std::uint8_t>(wire::BoardType::kNative));
  EXPECT_EQ(rig.hellos[0].reset_cause, static_cast<std::uint8_t>(wire::ResetCause::kPowerOn));
  EXPECT_EQ(rig.bad_frames, 0);
}

TEST(NativeBoard, SwallowsBytesWhileItBoots) {
  NativeBoardSettings settings;
  settings.boot_delay_ns = 100 * kMs;
  Rig rig(settings);
  rig.send_bytes(std::vector<std::uint8_t>(30, 0x55));
  rig.run(50);
  EXPECT_EQ(rig.board.counters().rx_lost_in_boot, 30U);
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
}

TEST(NativeBoard, EveryBytesTakesItsTimeOnTheWire) {
  Rig rig;
  rig.connect();
  rig.run(500);
  ASSERT_GT(rig.sent.size(), 4000U);
  for (std::size_t i = 1; i < rig.sent.size(); ++i) {
    ASSERT_GE(rig.sent[i].at_ns - rig.sent[i - 1].at_ns, kByteNs);
  }
  const std::size_t frame = wire::Sample::kSize + 5;
  const std::int64_t delay_ns =
      rig.sample_at_ns.back() - rig.sample_at_ns[rig.sample_at_ns.size() - 2];
  EXPECT_NEAR(static_cast<double>(delay_ns), 5.0 * kMs, 0.6 * kMs);
  // The IMU burst and the transmission of the frame take place between measurement and arrival.
  const double measured_ns = rig.samples.back().device_us * 1e3 + 4.0 * kMs;
  const double arrival_ns = static_cast<double>(rig.sample_at_ns.back());
  EXPECT_GE(arrival_ns - measured_ns, 471e3 + static_cast<double>(frame) * kByteNs - 2e3);
  EXPECT_LT(arrival_ns - measured_ns, 471e3 + static_cast<double>(frame) * kByteNs + 1e6);
}

TEST(NativeBoard, CountsBytesThatFindTheBufferFull) {
  Rig rig;
  rig.run(20);
  // 200 bytes arrive at one instant, which is impossible on a wire; the ring buffer holds 63 in any
  // case.
  std::vector<TimedByte> burst(200, TimedByte{rig.now_ns + 1, 0x55});
  rig.board.advance(rig.now_ns + kMs, {}, burst);
  EXPECT_EQ(rig.board.counters().rx_overruns, 200U - 63U);
}

TEST(NativeBoard, ALineAtFullRateDoesNotOverrun) {
  Rig rig;
  rig.connect();
  rig.send_bytes(std::vector<std::uint8_t>(20'000, 0x55));
  rig.run(450);
  EXPECT_EQ(rig.board.counters().rx_overruns, 0U);
}

TEST(NativeBoard, CountsEveryEdgeExactly) {
  Rig rig;
  rig.connect();
  // A leads B in forward direction; the right encoder turns backward at half the speed.
  constexpr std::array<std::pair<std::uint8_t, bool>, 4> kCycle = {
      {{0, true}, {1, true}, {0, false}, {1, false}}};
  for (int i = 0; i < 4001; ++i) {
    const auto& [channel, level] = kCycle[static_cast<std::size_t>(i % 4)];
    rig.edges.push_back({rig.now_ns + 1 + i * 100'000, channel, level});
    if (i % 2 == 0) {
      // B leads: 3 up, 2 up, 3 down, 2 down.
      const auto& [other, other_level] = kCycle[static_cast<std::size_t>((i / 2) % 4)];
      rig.edges.push_back(
          {rig.now_ns + 1 + i * 100'000, static_cast<std::uint8_t>(3 - other), other_level});
    }
  }
  rig.run(420);
  EXPECT_EQ(rig.samples.back().left_counts, 4001);
  EXPECT_EQ(rig.samples.back().right_counts, -2001);
}

TEST(NativeBoard, TheSampleHoldsTheEdgesUpToItsTime) {
  Rig rig;
  rig.connect();
  const std::int64_t step_ns = rig.now_ns + 50 * kMs;
  rig.edges.push_back({step_ns, 0, true});
  rig.run(100);
  const double boot_us = 4000.0;
  for (const wire::Sample& sample : rig.samples) {
    const double at_us = static_cast<double>(sample.device_us) + boot_us;
    EXPECT_EQ(sample.left_counts, at_us * 1e3 > static_cast<double>(step_ns) ? 1 : 0);
  }
}

TEST(NativeBoard, SameInputsGiveTheSameBytes) {
  const auto run = [](std::uint64_t seed) {
    NativeBoardSettings settings;
    settings.seed = seed;
    settings.clock_ppm = 37.0;
    Rig rig(settings);
    rig.connect();
    std::mt19937_64 random(5);
    for (int i = 0; i < 300; ++i) {
      rig.send(wire::SyncRequest{static_cast<std::uint16_t>(i)});
      rig.edges.push_back({rig.now_ns + static_cast<std::int64_t>(random() % kMs), 0, i % 2 == 0});
      rig.run(3);
    }
    std::vector<std::pair<std::int64_t, std::uint8_t>> bytes;
    for (const TimedByte& byte : rig.sent) bytes.emplace_back(byte.at_ns, byte.value);
    return bytes;
  };
  EXPECT_EQ(run(3), run(3));
  EXPECT_NE(run(3), run(4)) << "another seed must give another boot nonce";
}

TEST(NativeBoard, TheQuantumDoesNotChangeWhatItDoes) {
  const auto run = [](std::int64_t quantum_ns) {
    StillImu imu;
    NativeBoard board({}, &imu);
    board.reset(PowerUp::kPowerOn, 0);
    std::vector<std::pair<std::int64_t, std::uint8_t>> bytes;
    for (std::int64_t at_ns = quantum_ns; at_ns <= 600 * kMs; at_ns += quantum_ns) {
      board.advance(at_ns, {}, {});
      for (const TimedByte& byte : board.take_sent()) bytes.emplace_back(byte.at_ns, byte.value);
    }
    return bytes;
  };
  EXPECT_EQ(run(kMs), run(kMs / 8));
  EXPECT_EQ(run(kMs), run(3 * kMs));
}

TEST(NativeBoard, ItsClockIsOffByItsPpmAndStartsWhereItIsTold) {
  NativeBoardSettings settings;
  settings.clock_ppm = 500.0;
  settings.start_us = 0xFFFFFFFFU - 1'000'000U;
  Rig rig(settings);
  rig.connect();
  const wire::Sample first = rig.samples.front();
  const std::int64_t first_ns = rig.sample_at_ns.front();
  for (int i = 0; i < 50; ++i) {
    rig.send(wire::SyncRequest{1});
    rig.run(200);
  }
  const double device_us = rig.samples.back().device_us - first.device_us;
  const double true_us = static_cast<double>(rig.sample_at_ns.back() - first_ns) * 1e-3;
  EXPECT_NEAR(device_us / true_us, 1.0005, 1e-4);
  EXPECT_GT(first.device_us, 0xFFFFFFFFU - 1'000'000U);
  EXPECT_LT(rig.samples.back().device_us, 20'000'000U) << "the device clock has not wrapped";
  // Timer and clock use the same resonator, so the samples do not drift against device time.
  const auto samples = static_cast<double>(rig.samples.size() - 1);
  EXPECT_NEAR(device_us / samples, 5000.0, 0.3);
}

TEST(NativeBoard, ResetGivesANewNonceAndItsCause) {
  Rig rig;
  rig.connect();
  const std::uint32_t first = rig.hellos.back().boot_nonce;
  rig.board.reset(PowerUp::kBrownOut, rig.now_ns);
  rig.run(20);
  EXPECT_NE(rig.hellos.back().boot_nonce, first);
  EXPECT_NE(rig.hellos.back().boot_nonce, 0U);
  EXPECT_EQ(rig.hellos.back().reset_cause, static_cast<std::uint8_t>(wire::ResetCause::kBrownOut));
  EXPECT_EQ(rig.hellos.back().state, static_cast<std::uint8_t>(wire::State::kHello));
}

TEST(NativeBoard, DrivesAndStopsWhenItsHostFallsSilent) {
  Rig rig;
  rig.connect();
  const std::uint32_t nonce = rig.hellos.back().boot_nonce;
  const auto command = [&](std::uint16_t sequence) {
    wire::Command c{};
    c.boot_nonce = nonce;
    c.sequence = sequence;
    c.answers = rig.samples.back().sequence;
    c.speed_mps = 0.1f;
    c.expiry_us = rig.board.device_us() + 190'000;
    return c;
  };
  std::uint16_t sequence = 0;
  for (int i = 0; i < 100; ++i) {
    rig.send(command(++sequence));
    if (i == 10) rig.send(wire::Arm{nonce, 5, rig.board.device_us() + 200'000});
    rig.run(5);
  }
  EXPECT_GT(rig.board.motor_duty().left, 0.2);
  EXPECT_GT(rig.board.motor_duty().right, 0.2);
  rig.run(200);
  EXPECT_EQ(rig.board.motor_duty().left, 0.0);
  EXPECT_EQ(rig.board.motor_duty().right, 0.0);
}

TEST(NativeBoard, TheBatteryIsReadInStepsOfTheConverter) {
  Rig rig;
  rig.board.set_battery(7.9);
  rig.connect();
  EXPECT_NEAR(rig.samples.back().battery_mv, 7900, 15);
  rig.board.set_battery(99.0);
  rig.run(500);
  EXPECT_NEAR(rig.samples.back().battery_mv, 15'000, 30);
}

TEST(NativeBoard, WithoutAnImuFramesGoOn) {
  Rig rig;
  rig.imu.answers = false;
  rig.connect();
  const std::size_t before = rig.samples.size();
  rig.run(500);
  EXPECT_NEAR(static_cast<double>(rig.samples.size() - before), 100.0, 3.0);
  EXPECT_EQ(rig.samples.back().imu_age, 255);
}

}  // namespace
}  // namespace tp100::sim
