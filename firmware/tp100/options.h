// What can be chosen before the sketch is compiled.
#ifndef TP100_FIRMWARE_OPTIONS_H
#define TP100_FIRMWARE_OPTIONS_H

// Without its two slashes the line below simulates the robot inside the board: a bare Mega is
// enough, and no pin ever drives a motor.

// #define FAKE_ROBOT

#endif
