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

TEST_F(PlotStreamTest, AStepIsOneDatagramWithItsTime) {
  record_->now_ns = 2 * kNsPerS;
  record_->snapshot.estimates[PoseSource::kOdometry].pose.x_m = 0.25;
  const Json datagram = sent();
  EXPECT_NEAR(datagram["timestamp"].get<double>(), 1'700'000'002.0, 1e-5);
  EXPECT_EQ(datagram["/estimate"]["odometry"]["x_m"], 0.25);
  EXPECT_EQ(datagram["/estimate"]["step"], 7);
}

TEST_F(PlotStreamTest, ACommandIsThereOnlyIfTheStepHasOne) {
  EXPECT_FALSE(sent().contains("/command"));
  record_->command_valid = true;
  record_->now_ns += kNsPerS;
  EXPECT_TRUE(sent().contains("/command"));
}

TEST_F(PlotStreamTest, TruthIsInTheEstimate) {
  EXPECT_FALSE(sent()["/estimate"].contains("truth"));
  stream_.take_truth(record_->now_ns, {.x_m = 0.5});
  record_->now_ns += 5 * kNsPerMs;
  EXPECT_EQ(sent()["/estimate"]["truth"]["x_m"], 0.5);
}

TEST_F(PlotStreamTest, EveryStepLeaves) {
  for (int i = 0; i < 20; ++i) {
    record_->now_ns += kNsPerMs;
    EXPECT_TRUE(sent().contains("/estimate")) << i;
  }
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
