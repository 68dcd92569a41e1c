#include "link/request_sender.h"

#include <gtest/gtest.h>

namespace tp100::link {
namespace {

class RequestSenderTest : public testing::Test {
 protected:
  std::size_t waiting() const { return output_.bytes().size(); }
  wire::Acknowledge accepted(wire::Type type, std::uint32_t token) const {
    return {static_cast<std::uint8_t>(type), token, 0, 0};
  }

  LinkCounters counters_{};
  OutputQueue<kMaxOut> output_{counters_};
  SessionEvents events_;
  Tokens tokens_;
  RequestSender sender_{tokens_, output_, events_};
};

TEST_F(RequestSenderTest, QueuesNothingWithoutARequestOrAConnection) {
  EXPECT_FALSE(sender_.pending());
  EXPECT_FALSE(sender_.poll(true, 0));
  sender_.stop(0);
  sender_.disarm(0);
  EXPECT_TRUE(sender_.pending());
  EXPECT_FALSE(sender_.poll(false, 0));
  EXPECT_EQ(waiting(), 0U);
  EXPECT_TRUE(sender_.poll(true, 0));
  EXPECT_GT(waiting(), 0U);
}

TEST_F(RequestSenderTest, TellsWhetherItQueuedAnything) {
  const HostNs repeat = OneShotRequest::kRepeatNs;
  for (const bool stop : {true, false}) {
    RequestSender sender(tokens_, output_, events_);
    if (stop) {
      sender.stop(0);
    } else {
      sender.arm(1, 2, 0);
    }
    EXPECT_TRUE(sender.poll(true, 0));
    EXPECT_FALSE(sender.poll(true, repeat - 1));
    EXPECT_TRUE(sender.poll(true, repeat));
    EXPECT_FALSE(sender.poll(true, repeat));
  }
}

TEST_F(RequestSenderTest, AnArmWaitsForTheEndOfAStopAndADisarmDoesNot) {
  sender_.stop(0);
  sender_.arm(1, 2, 0);
  EXPECT_TRUE(sender_.poll(true, 0));
  const std::size_t one = waiting();
  output_.written(one);
  EXPECT_FALSE(sender_.poll(true, 1));
  sender_.disarm(2);
  EXPECT_TRUE(sender_.poll(true, 2));
  EXPECT_GT(waiting(), 0U);
}

TEST_F(RequestSenderTest, OnlyAnArmThatWasGivenUpAndIsAcceptedLateNeedsADisarm) {
  sender_.arm(1, 2, 0);
  sender_.poll(true, OneShotRequest::kLimitNs);
  ASSERT_EQ(sender_.take_answer(), RequestAnswer::kFailed);
  wire::Acknowledge refused = accepted(wire::Type::kArm, 1);
  refused.result = static_cast<std::uint8_t>(wire::Result::kWrongState);
  EXPECT_FALSE(sender_.on_acknowledge(refused, 0));
  EXPECT_FALSE(sender_.on_acknowledge(accepted(wire::Type::kArm, 2), 0));
  EXPECT_FALSE(sender_.on_acknowledge(accepted(wire::Type::kDisarm, 1), 0));
  EXPECT_FALSE(sender_.on_acknowledge(accepted(wire::Type::kStop, 1), 0));
  EXPECT_TRUE(sender_.on_acknowledge(accepted(wire::Type::kArm, 1), 0));
  EXPECT_FALSE(sender_.on_acknowledge(accepted(wire::Type::kArm, 1), 0));
}

TEST_F(RequestSenderTest, IsOverdueAtItsLimitAndNotBefore) {
  const HostNs limit = OneShotRequest::kLimitNs;
  sender_.disarm(7);
  sender_.poll(true, 7 + limit - 1);
  EXPECT_EQ(sender_.take_answer(), RequestAnswer::kNone);
  EXPECT_TRUE(sender_.pending());
  sender_.poll(true, 7 + limit);
  EXPECT_EQ(sender_.take_answer(), RequestAnswer::kFailed);
  EXPECT_FALSE(sender_.pending());
}

TEST_F(RequestSenderTest, AStopThatIsOverdueIsRepeatedAtTheLimitsInterval) {
  const HostNs limit = OneShotRequest::kLimitNs;
  sender_.stop(0);
  int copies = 0;
  for (HostNs now = 0; now <= 3 * limit; now += kNsPerMs) copies += sender_.poll(true, now);
  EXPECT_EQ(copies, 7 + 2);
}

TEST_F(RequestSenderTest, TokensGrowWithTimeAndWithEachRequest) {
  EXPECT_EQ(tokens_.next(0), 1U);
  EXPECT_EQ(tokens_.next(0), 2U);
  EXPECT_EQ(tokens_.next(10 * kNsPerMs), 3U);
  EXPECT_EQ(tokens_.next(5 * kNsPerS), 501U);
  tokens_.leap();
  EXPECT_EQ(tokens_.next(6 * kNsPerS), 501U + (1U << 24U) + 1U);
}

}  // namespace
}  // namespace tp100::link
