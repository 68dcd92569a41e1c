#include <gtest/gtest.h>

#include "server/broker.h"

namespace tp100::server {
namespace {

WebSocketFrame frame(const std::string& body) {
  WebSocketFrame out;
  out.body = std::make_shared<const std::string>(body);
  return out;
}

TEST(Outbox, TheOldestDataGoesFirst) {
  Outbox box;
  for (std::size_t i = 0; i < Outbox::kMaxData + 5; ++i) box.push_data(frame(std::to_string(i)));
  EXPECT_EQ(box.size(), Outbox::kMaxData);
  EXPECT_EQ(box.dropped(), 5U);
  EXPECT_EQ(*box.pop()->body, "5");
}

TEST(Outbox, BytesAreBoundedToo) {
  Outbox box;
  const std::string large(Outbox::kMaxCounted, 'x');
  for (std::size_t i = 0; i < Outbox::kMaxData; ++i) box.push_data(frame(large));
  EXPECT_LE(box.size() * large.size(), Outbox::kMaxDataBytes);
  EXPECT_EQ(box.dropped() + box.size(), Outbox::kMaxData);
}

// A viewer that subscribes to path, course and scene of the longest course at once gets all three.
TEST(Outbox, LargeDataWhichEverybodyGetsWaitsTogether) {
  Outbox box;
  for (int i = 0; i < 3; ++i) box.push_data(frame(std::string(Outbox::kMaxDataBytes, 'x')));
  EXPECT_EQ(box.size(), 3U);
  EXPECT_EQ(box.dropped(), 0U);
}

TEST(Outbox, AnswersGoBeforeDataAndAreNeverDropped) {
  Outbox box;
  for (std::size_t i = 0; i < 2 * Outbox::kMaxData; ++i) box.push_data(frame("data"));
  ASSERT_TRUE(box.push_reply(frame("answer")));
  EXPECT_EQ(*box.pop()->body, "answer");
  EXPECT_EQ(*box.pop()->body, "data");
}

TEST(Outbox, AnswersAreBounded) {
  Outbox box;
  std::size_t taken = 0;
  while (box.push_reply(frame("answer"))) ++taken;
  EXPECT_EQ(taken, Outbox::kMaxReplies);
  while (!box.empty()) box.pop();
  EXPECT_TRUE(box.push_reply(frame("answer")));
}

}  // namespace
}  // namespace tp100::server
