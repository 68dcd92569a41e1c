#include "server/outbox.h"

#include <utility>

namespace tp100::server {

void Outbox::push_data(Frame frame) {
  data_bytes_ += frame.size();
  data_.push_back(std::move(frame));
  // One frame may always wait, however large.
  while (data_.size() > kMaxData || (data_bytes_ > kMaxDataBytes && data_.size() > 1)) {
    data_bytes_ -= data_.front().size();
    data_.pop_front();
    ++dropped_;
  }
}

bool Outbox::push_reply(Frame frame) {
  const std::size_t bytes = reply_bytes_ + frame.size();
  if (replies_.size() >= kMaxReplies || bytes > kMaxReplyBytes) return false;
  reply_bytes_ = bytes;
  replies_.push_back(std::move(frame));
  return true;
}

Frame Outbox::pop() {
  if (!replies_.empty()) {
    Frame frame = std::move(replies_.front());
    replies_.pop_front();
    reply_bytes_ -= frame.size();
    return frame;
  }
  Frame frame = std::move(data_.front());
  data_.pop_front();
  data_bytes_ -= frame.size();
  return frame;
}

}  // namespace tp100::server
