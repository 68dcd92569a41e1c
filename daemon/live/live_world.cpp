#include "live/live_world.h"

#include "core/error.h"
#include "link/udp.h"

namespace tp100::live {

LiveWorld::LiveWorld(boost::asio::io_context& context, const config::WorldRun& run,
                     const config::GiveWorld& give)
    : kind_(bridge::to_string(run.parameters.kind)) {
  switch (run.parameters.kind) {
    case bridge::WorldKind::kInternal:
      break;
    case bridge::WorldKind::kUdp:
      port_ = std::make_unique<WorldPort>(context, run, give);
      break;
    case bridge::WorldKind::kFiles:
      files_ = std::make_unique<WorldFiles>(run, give);
      break;
  }
}

void LiveWorld::take(const StepRecord& record) {
  if (port_ != nullptr) port_->take(record);
  if (files_ != nullptr) files_->take(record);
}

void LiveWorld::stop() {
  if (port_ != nullptr) port_->stop();
  if (files_ != nullptr) files_->stop();
}

bool LiveWorld::ended_by(std::chrono::steady_clock::time_point deadline) {
  return files_ == nullptr || files_->ended_by(deadline);
}

std::string LiveWorld::take_note() {
  if (port_ != nullptr) return port_->take_note();
  return files_ != nullptr ? files_->take_note() : std::string();
}

WorldFigures LiveWorld::figures() const {
  WorldFigures out{.name = kind_, .udp = {}, .files = {}};
  if (port_ != nullptr) {
    out.udp = port_->counters();
    out.strangers = port_->strangers();
  }
  if (files_ != nullptr) out.files = files_->counters();
  return out;
}

}  // namespace tp100::live
