// TP100 firmware: the code is in src/, compile-time options are in options.h. Wiring:
// src/hal_mega.h. Protocol: ../PROTOCOL.md.
#include "src/mega.h"

void setup() { tp100::firmware::mega_setup(); }

void loop() { tp100::firmware::mega_loop(); }
