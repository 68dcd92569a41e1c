// TP100 firmware: everything is in src/, what can be chosen in options.h. Wiring: src/hal_mega.h.
// Protocol: ../PROTOCOL.md.
#include "src/mega.h"

void setup() { tp100::firmware::mega_setup(); }

void loop() { tp100::firmware::mega_loop(); }
