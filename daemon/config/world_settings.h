#pragma once
// How an external world is reached. Whether there is one, and who owns the pose, is in
// bridge::WorldParameters.

#include <string>

#include "worlds/frame.h"
#include "worlds/live_link.h"

namespace tp100::config {

struct WorldSettings {
  worlds::Frame frame = worlds::Frame::kRos;   ///< of every message and file
  double rate_hz = 100.0;                      ///< poses and files per second
  std::string address = "udp:127.0.0.1:9760";  ///< udp: where the world listens
  std::string listen;                          ///< "udp:[HOST:]PORT"; empty: any free port
  std::string encoder_file = "Encoder.txt";    ///< files: written
  std::string encoder_template = "{seq} {t_s} {left} {right}";
  std::string orientation_file = "Orientation.txt";  ///< files: read
  std::string orientation_template;                  ///< empty: Unreal's texts or plain numbers
  std::string live_link;                             ///< "udp:[HOST:]PORT"; empty: none
  worlds::LiveLinkDialect live_link_dialect = worlds::LiveLinkDialect::kBones;
  std::string live_link_subject = "TP100";
};

}  // namespace tp100::config
