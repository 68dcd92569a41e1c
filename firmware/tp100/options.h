// Compile-time options of the sketch.
#ifndef TP100_FIRMWARE_OPTIONS_H
#define TP100_FIRMWARE_OPTIONS_H

// Uncomment the line below to simulate the robot inside the board: a bare Mega is enough, and no
// pin ever drives a motor.

// #define FAKE_ROBOT

#endif
