// STOP, arm and disarm: each is repeated until the robot answers, and never reaches another boot.
#include <gtest/gtest.h>

#include <vector>

#include "link/request_sender.h"
#include "session_rig.h"

namespace tp100::link {
namespace {

using wire::Result;
using wire::Type;

constexpr HostNs kRepeat = OneShotRequest::kRepeatNs, kLimit = kAnswerNs;

class RequestSenderTest : public testing::Test {
 protected:
  struct Sent {
    Type type;
    std::uint32_t token;
  };
  void begin(Type type, HostNs now) {
    if (type == Type::kStop) sender_.stop(now);
    if (type == Type::kDisarm) sender_.disarm(now);
    if (type == Type::kArm) sender_.arm(1, 2, now);
  }
  /// What is sent at `now`.
  std::vector<Sent> poll(HostNs now, bool connected = true) {
    const bool any = sender_.poll(connected, now);
    std::vector<Sent> sent;
    wire::FrameDecoder decoder;
    for (const std::uint8_t byte : output_.bytes()) {
      if (decoder.push(byte) != wire::DecodeResult::kFrame) continue;
      const Type type{decoder.type()};
      wire::Arm arm{};
      wire::Stop stop{};
      if (type == Type::kArm) {
        EXPECT_TRUE(wire::read_payload(decoder.payload(), decoder.size(), arm));
        EXPECT_EQ(arm.boot_nonce, 1U);
        EXPECT_EQ(arm.expiry_us, 2U);
      } else {
        EXPECT_TRUE(wire::read_payload(decoder.payload(), decoder.size(), stop));
      }
      sent.push_back({type, type == Type::kArm ? arm.token : stop.token});
    }
    output_.written(output_.bytes().size());
    EXPECT_EQ(any, !sent.empty()) << "a keep-alive counts on it";
    return sent;
  }
  bool answer(Type type, std::uint32_t token, Result result = Result::kAccepted) {
    return sender_.on_acknowledge(
        {static_cast<std::uint8_t>(type), token, static_cast<std::uint8_t>(result), 77}, 0);
  }

  static constexpr Type kTypes[] = {Type::kStop, Type::kArm, Type::kDisarm};
  LinkCounters counters_{};
  OutputQueue<kMaxOut> output_{counters_};
  SessionEvents events_;
  Tokens tokens_;
  RequestSender sender_{tokens_, output_, events_};
};

TEST_F(RequestSenderTest, EachIsRepeatedEvery30MsAndGivenUpAfter200MsButAStopGoesOn) {
  for (const Type type : kTypes) {
    SCOPED_TRACE(static_cast<int>(type));
    const HostNs start = 7;
    begin(type, start);
    EXPECT_TRUE(poll(start, false).empty()) << "there is no connection";
    std::vector<std::uint32_t> tokens;
    std::vector<HostNs> times;
    for (HostNs at = 0; at <= 3 * kLimit; at += kNsPerMs) {
      if (type == Type::kStop) begin(type, start + at);  // one that is asked for again is the same
      for (const Sent& sent : poll(start + at)) {
        EXPECT_EQ(sent.type, type);
        tokens.push_back(sent.token);
        times.push_back(at);
      }
      const bool over = at >= kLimit;
      EXPECT_EQ(sender_.pending(), type == Type::kStop || !over) << at;
      EXPECT_EQ(sender_.take_answer(), type != Type::kStop && at == kLimit ? RequestAnswer::kFailed
                                                                           : RequestAnswer::kNone);
      const auto events = events_.take();
      ASSERT_EQ(events.size(), at == kLimit ? 1U : 0U) << at;
      if (!events.empty()) {
        EXPECT_EQ(as<NotAcknowledged>(events[0])->request, type);
      }
    }
    EXPECT_EQ(tokens, std::vector(tokens.size(), tokens.at(0)));
    ASSERT_EQ(times.size(), type == Type::kStop ? 9U : 7U);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_EQ(times[i], static_cast<HostNs>(i) * kRepeat);
    if (type == Type::kStop) {
      EXPECT_EQ(times[8] - times[7], kLimit);
      answer(type, tokens[0]);
    }
    events_.take();
  }
}

TEST_F(RequestSenderTest, OnlyItsOwnAnswerEndsARequestAndItsResultIsReported) {
  for (const Type type : kTypes) {
    for (const Result result : {Result::kAccepted, Result::kWrongBoot, Result::kStaleToken,
                                Result::kFaultPersists, Result::kOutOfRange, Result::kWrongState}) {
      SCOPED_TRACE(10 * static_cast<int>(type) + static_cast<int>(result));
      begin(type, 0);
      const std::uint32_t token = poll(0).at(0).token;
      EXPECT_FALSE(answer(type, token - 1));
      for (const Type other : {Type::kStop, Type::kArm, Type::kDisarm, Type::kSample})
        EXPECT_TRUE(other == type || !answer(other, token));
      EXPECT_TRUE(sender_.pending());
      EXPECT_TRUE(events_.take().empty());
      EXPECT_FALSE(answer(type, token, result));
      EXPECT_FALSE(sender_.pending());
      EXPECT_EQ(sender_.take_answer(), type == Type::kStop           ? RequestAnswer::kNone
                                       : result == Result::kAccepted ? RequestAnswer::kAcknowledged
                                                                     : RequestAnswer::kFailed);
      EXPECT_EQ(sender_.take_answer(), RequestAnswer::kNone) << "it is reported once";
      const auto events = events_.take();
      ASSERT_EQ(events.size(), 1U);
      const Acknowledged* event = as<Acknowledged>(events[0]);
      ASSERT_NE(event, nullptr);
      EXPECT_EQ(event->request, type);
      EXPECT_EQ(event->result, result);
      EXPECT_EQ(event->detail, 77);
      begin(Type::kDisarm, 0);
      const std::uint32_t next = poll(0).at(0).token;
      EXPECT_EQ(next - token > 1000U, result == Result::kStaleToken && type != Type::kStop)
          << "the robot knows a higher one";
      answer(Type::kDisarm, next);
      sender_.take_answer();
      events_.take();
    }
  }
}

TEST_F(RequestSenderTest, AnArmWaitsForTheEndOfAStopAndADisarmDoesNot) {
  begin(Type::kStop, 0);
  begin(Type::kArm, 0);
  const auto sent = poll(0);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].type, Type::kStop);
  EXPECT_TRUE(poll(1).empty());
  begin(Type::kDisarm, 2);
  EXPECT_EQ(sender_.take_answer(), RequestAnswer::kNone) << "the arm's failure is an event only";
  EXPECT_EQ(poll(2).at(0).type, Type::kDisarm);
}

TEST_F(RequestSenderTest, OnlyAnArmThatWasGivenUpAndIsAcceptedLateNeedsADisarm) {
  begin(Type::kArm, 0);
  const std::uint32_t token = poll(0).at(0).token;
  poll(kLimit);
  EXPECT_FALSE(answer(Type::kArm, token, Result::kWrongState));
  EXPECT_FALSE(answer(Type::kArm, token + 1));
  EXPECT_FALSE(answer(Type::kDisarm, token));
  EXPECT_FALSE(answer(Type::kStop, token));
  EXPECT_TRUE(answer(Type::kArm, token));
  EXPECT_FALSE(answer(Type::kArm, token)) << "once is enough";
  begin(Type::kArm, 0);
  const std::uint32_t again = poll(0).at(0).token;
  begin(Type::kDisarm, 1);
  EXPECT_FALSE(answer(Type::kArm, again)) << "a disarm is under way";
}

TEST_F(RequestSenderTest, TokensGrowWithTimeAndWithEachRequest) {
  EXPECT_EQ(tokens_.next(0), 1U);
  EXPECT_EQ(tokens_.next(0), 2U);
  EXPECT_EQ(tokens_.next(10 * kNsPerMs), 3U);
  EXPECT_EQ(tokens_.next(5 * kNsPerS), 501U);
}

// The robot armed at last although nobody waits any longer.
TEST(SessionRequests, AnArmThatIsAcceptedTooLateIsDisarmed) {
  SessionRig rig;
  rig.connect();
  rig.robot.answers_requests = false;
  const HostNs asked = rig.now;
  rig.session.request(RobotRequest::kArm, rig.now);
  rig.run(210);
  EXPECT_EQ(rig.session.take_answer(), RequestAnswer::kFailed);
  const auto& arms = rig.robot.received.arms;
  EXPECT_EQ(arms.front().boot_nonce, rig.robot.boot_nonce);
  EXPECT_NEAR(static_cast<double>(arms.back().expiry_us - rig.robot.device_us(asked)), 200e3, 600.0)
      << "the last copy dies with the request";
  rig.robot.answers_requests = true;
  for (int again = 0; again < 2; ++again) {
    rig.robot.send(
        wire::Acknowledge{static_cast<std::uint8_t>(Type::kArm), arms.back().token, 0, 0});
    rig.run(20);
    EXPECT_EQ(rig.robot.received.disarms.size(), 1u);
  }
}

// Its token belongs to another boot, or nobody may want it any longer. The same is true of a
// disarm; a STOP is wanted always, and goes on in the next session.
TEST(Session, AnArmUnderWayEndsWithItsSession) {
  for (const RobotRequest request :
       {RobotRequest::kArm, RobotRequest::kDisarm, RobotRequest::kStop}) {
    for (int end = 0; end < 6; ++end) {
      SCOPED_TRACE(10 * static_cast<int>(request) + end);
      SessionRig rig;
      rig.connect();
      rig.robot.answers_requests = false;
      rig.session.request(request, rig.now);
      rig.run(20);
      ASSERT_TRUE(rig.session.request_pending());
      if (end == 0) rig.robot.reboot(rig.now);
      if (end == 1) rig.robot.state = wire::State::kHello;
      if (end == 2) rig.session.use(SessionRig::settings().parameters, rig.now);
      const bool closed = end == 3 || end == 4;
      if (closed) rig.session.close(rig.now);
      if (end == 4) rig.robot.reboot(rig.now);
      if (end == 5) rig.session.open(rig.now);
      rig.robot.received = {};
      rig.run(end < 2 ? 1 : 0);
      EXPECT_EQ(rig.session.request_pending(), request == RobotRequest::kStop);
      if (closed) rig.session.open(rig.now);
      rig.robot.answers_requests = true;
      rig.run(500);
      EXPECT_EQ(rig.session.state(), SessionState::kReady);
      EXPECT_TRUE(rig.robot.received.arms.empty());
      EXPECT_TRUE(rig.robot.received.disarms.empty());
      EXPECT_EQ(rig.robot.received.stops.size(), request == RobotRequest::kStop ? 1U : 0U);
      EXPECT_FALSE(rig.session.request_pending());
      EXPECT_EQ(rig.session.take_answer(),
                request == RobotRequest::kArm ? RequestAnswer::kFailed : RequestAnswer::kNone);
    }
  }
}

TEST(SessionRequests, StopIsTheFirstThingSentOnTheNextSession) {
  SessionRig rig;
  rig.connect();
  rig.session.close(rig.now);
  rig.session.request(RobotRequest::kStop, rig.now);
  rig.run(300);
  EXPECT_EQ(rig.count<NotAcknowledged>(), 1);
  rig.robot.received = {};
  rig.robot.state = wire::State::kHello;
  const auto since = static_cast<std::uint32_t>(rig.now / (10 * kNsPerMs));
  rig.connect();
  ASSERT_FALSE(rig.robot.received.types.empty());
  EXPECT_EQ(rig.robot.received.types[0], static_cast<std::uint8_t>(Type::kStop));
  EXPECT_GE(rig.robot.received.stops[0].token, since) << "it is fresh for whatever robot is there";
  EXPECT_FALSE(rig.session.request_pending());
  EXPECT_EQ(rig.session.state(), SessionState::kReady);
}

}  // namespace
}  // namespace tp100::link
