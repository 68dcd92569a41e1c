#include "live/terminal.h"

#include <utility>

#include "core/start_rule.h"

namespace tp100::live {

Terminal::Terminal(boost::asio::io_context& context, Reach reach)
    : reach_(std::move(reach)), input_(context, [this](const std::string& line) { take(line); }) {}

void Terminal::ask() {
  if (session_ != SessionState::kReady || under_way() || reach_.course.empty()) return;
  const bool word = reach_.controls.start_consent() == StartConsent::kWord;
  const bool typed_ahead = input_.drop_typed_ahead();
  const std::string what = "to start course " + reach_.course;
  reach_.log.info(word ? "ready; type go and press Enter " + what + "; Enter alone is STOP"
                       : "ready; press Enter " + what);
  if (typed_ahead && word) press_stop("Enter, before that was asked: STOP");
}

void Terminal::take(const std::string& line) {
  if (reach_.course.empty()) return;
  switch (meaning_of(line, reach_.controls.start_consent(), under_way())) {
    case LineMeaning::kStop:
      return press_stop(under_way() ? "Enter: STOP"
                                    : "Enter: STOP; to start again type go and press Enter");
    case LineMeaning::kNothing:
      return reach_.log.info("nothing is started; press Enter alone to start course " +
                             reach_.course);
    case LineMeaning::kStart:
      break;
  }
  if (session_ != SessionState::kReady) {
    reach_.log.info("no robot yet; nothing is started");
  } else if (line == kStartWord) {
    reach_.cycle.request(OperatorRequest::kStart);
  } else {
    reach_.cycle.request_first_start();
  }
}

void Terminal::press_stop(const std::string& told) {
  reach_.log.warn(told);
  reach_.cycle.request(OperatorRequest::kStop);
  reach_.server.stop_pressed("keyboard");
}

}  // namespace tp100::live
