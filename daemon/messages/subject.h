#pragma once
// What a bridge drives, fixed from its start to its end: the context of every message.

#include <memory>
#include <string>

#include "course/course.h"
#include "course/robot.h"

namespace tp100::messages {

struct Subject {
  std::string version;
  std::shared_ptr<const course::Course> course;  ///< null: none
  course::Robot robot{};
  std::string setup = "flat";
  std::string world = "internal";
  std::string pacing = "host";
  double rate_hz = 200.0;
};

}  // namespace tp100::messages
