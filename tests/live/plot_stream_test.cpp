#include "live/plot_stream.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "../link/udp_receiver.h"
#include "core/error.h"

namespace tp100::live {
namespace {

using Json = nlohmann::json;

class PlotStreamTest : public testing::Test {
 protected:
  Json sent() {
    record_->step = 7;
    stream_.take(*record_);
    return Json::parse(receiver_.wait());
  }
  UdpReceiver receiver_;
  PlotStream stream_{"udp:" + std::to_string(receiver_.port()),
                     {.start_ns = 0, .start_unix_ns = 1'700'000'000'000'000'000},
                     {}};
  std::unique_ptr<StepRecord> record_ = std::make_unique<StepRecord>();
};

TEST_F(PlotStreamTest, EveryStepIsOneDatagramWithItsTime) {
  record_->now_ns = 2 * kNsPerS;
  record_->snapshot.estimates[PoseSource::kOdometry].pose.x_m = 0.25;
  const Json datagram = sent();
  EXPECT_NEAR(datagram["timestamp"].get<double>(), 1'700'000'002.0, 1e-5);
  EXPECT_EQ(datagram["/estimate"]["odometry"]["x_m"], 0.25);
  EXPECT_EQ(datagram["/estimate"]["step"], 7);
  for (int i = 0; i < 20; ++i) {
    record_->now_ns += kNsPerMs;
    EXPECT_TRUE(sent().contains("/estimate")) << i;
  }
}

TEST_F(PlotStreamTest, CommandAndTruthAreThereOnlyIfTheStepHasThem) {
  const Json without = sent();
  EXPECT_FALSE(without.contains("/command"));
  EXPECT_FALSE(without["/estimate"].contains("truth"));
  record_->command_valid = true;
  stream_.take_truth(record_->now_ns, {.x_m = 0.5});
  record_->now_ns += 5 * kNsPerMs;
  const Json with = sent();
  EXPECT_TRUE(with.contains("/command"));
  EXPECT_EQ(with["/estimate"]["truth"]["x_m"], 0.5);
}

TEST(PlotStream, AnAddressThatIsNoneIsRefusedByItsKey) {
  try {
    const PlotStream stream("9870", {}, {});
    FAIL() << "9870 is accepted";
  } catch (const SetupError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("server.plot"));
  }
}

}  // namespace
}  // namespace tp100::live
