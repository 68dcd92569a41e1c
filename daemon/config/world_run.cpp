#include "config/world_run.h"

namespace tp100::config {

worlds::PeerSettings peer_settings(const WorldRun& run, std::uint32_t session, bool lockstep) {
  worlds::PeerSettings out;
  out.hello.session = session;
  out.hello.frame = run.settings.frame;
  out.hello.authority =
      run.parameters.owns_pose ? worlds::Authority::kWorld : worlds::Authority::kBridge;
  out.hello.rate_hz = run.settings.rate_hz;
  out.hello.timeout_s = run.parameters.timeout_s;
  out.hello.lockstep = lockstep;
  out.hello.version = run.version;
  out.hello.course = run.course;
  out.hello.setup = run.setup;
  out.surfaces = run.surfaces;
  return out;
}

}  // namespace tp100::config
