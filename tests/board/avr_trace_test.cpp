#include "avr_trace.h"

#include <gmock/gmock.h>

#include <string>

#include "avr_rig.h"
#include "support/temporary_folder.h"

namespace tp100::sim {
namespace {

using testing::HasSubstr;

TEST(AvrTrace, HasThePinsAndTheFramesOfADrive) {
  const test::TemporaryFolder folder;
  AvrRig rig;
  ASSERT_TRUE(rig.boot());
  rig.drive();
  rig.trace.write(folder.path().string(), "drive");

  const std::string vcd = test::read_bytes(folder.file("drive.vcd"));
  EXPECT_THAT(vcd, HasSubstr("$var wire 1 i motor_left_enable $end"));
  // The left motor is enabled and runs forward, and its encoder turns.
  for (const char* change : {"\n1i\n", "\n1e\n", "\n1a\n", "\n0a\n", "\n1b\n", "\n0b\n"}) {
    EXPECT_THAT(vcd, HasSubstr(change)) << change;
  }
  const std::string frames = test::read_bytes(folder.file("drive.frames"));
  EXPECT_THAT(frames, HasSubstr("to host  type 1:"));   // hello
  EXPECT_THAT(frames, HasSubstr("to board type 67:"));  // command
}

}  // namespace
}  // namespace tp100::sim
