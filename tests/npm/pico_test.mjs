// Starts the image of a Pico on another author's emulator of the RP2040: from the flash, as the chip's ROM does, until it
// answers a host. The emulator's own defects are worked around where the comments say so.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import test from 'node:test';
import { load } from './packages.mjs';

const { Simulator } = load('rp2040js');
const FLASH = 0x10000000;
const ROM_COPIES_TO = 0x41f00; // offset in the RAM

/** Contents of the flash from a UF2 file, as the chip's ROM takes it. */
function flashOf(uf2) {
  assert.equal(uf2.length % 512, 0);
  const flash = Buffer.alloc(uf2.length / 2, 0xff);
  for (let at = 0; at < uf2.length; at += 512) {
    const words = [0, 4, 8, 16, 20, 24, 28, 508].map((offset) => uf2.readUInt32LE(at + offset));
    assert.deepEqual(words, [0x0a324655, 0x9e5d5157, 0x2000, 256, at / 512, uf2.length / 512, 0xe48bff56, 0x0ab16f30]);
    uf2.copy(flash, uf2.readUInt32LE(at + 12) - FLASH, at + 32, at + 32 + 256);
  }
  return flash;
}

/** CRC of the second boot stage as the ROM checks it. */
function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) {
    for (let bit = 7; bit >= 0; --bit) {
      const one = (crc >>> 31) ^ ((byte >> bit) & 1);
      crc = ((crc << 1) ^ (one ? 0x04c11db7 : 0)) >>> 0;
    }
  }
  return crc;
}

function uncobs(frame) {
  const out = [];
  for (let at = 0; at < frame.length;) {
    const code = frame[at++];
    for (let i = 1; i < code; ++i) out.push(frame[at++]);
    if (code < 255 && at < frame.length) out.push(0);
  }
  return Buffer.from(out);
}

class Pico {
  sent = [];
  bauds = [];

  constructor(flash) {
    this.simulator = new Simulator();
    this.mcu = this.simulator.rp2040;
    this.mcu.logger = { debug() {}, info() {}, warn() {}, error() {} };
    // This emulator's watchdog ignores kicks: disable it.
    const dog = Object.values(this.mcu.peripherals).find((one) => one.name === 'WATCHDOG_BASE');
    dog.alarm = { enable: false };
    const write = dog.writeUint32.bind(dog);
    this.fed = [];
    dog.writeUint32 = (offset, value) => {
      if (offset === 4) this.fed.push({ at_ms: this.ms(), ms: value / 2000 });
      write(offset, value);
    };
    this.mcu.uart[0].onByte = (byte) => this.sent.push(byte);
    this.mcu.uart[0].onBaudRateChange = (baud) => this.bauds.push(baud);
    this.mcu.flash.set(flash);
    this.mcu.sram.set(flash.subarray(0, 256), ROM_COPIES_TO);
    this.mcu.core.PC = 0x20000000 + ROM_COPIES_TO;
  }

  ms() { return this.simulator.clock.nanos / 1e6; }

  run(ms) {
    const { core } = this.mcu;
    const end = this.ms() + ms;
    while (this.ms() < end) {
      // This emulator's SysTick does not end the sleep by itself.
      if (core.waiting && !core.interruptsUpdated) this.simulator.clock.tick(this.simulator.clock.nanosToNextAlarm || 1000);
      else this.simulator.clock.tick(core.executeInstruction() * 8);
    }
  }

  send(hex) {
    for (const byte of Buffer.from(hex, 'hex')) {
      this.mcu.uart[0].feedByte(byte);
      this.run(0.02);
    }
  }

  /** Payloads of every frame sent since the last call. */
  frames() {
    const found = [];
    let from = 0;
    for (let at = 0; at < this.sent.length; ++at) {
      if (this.sent[at] !== 0) continue;
      if (at > from) found.push(uncobs(this.sent.slice(from, at)));
      from = at + 1;
    }
    this.sent = this.sent.slice(from);
    return found;
  }
  hellos() {
    return this.frames().filter((frame) => frame[0] === 1)
      .map((frame) => ({ schema: frame.readUInt32LE(6), board: frame[10], nonce: frame.readUInt32LE(11), state: frame[16] }));
  }
}

const images = process.env.TP100_FIRMWARE;

test('the second boot stage has the CRC that the ROM asks for', async () => {
  const flash = flashOf(await readFile(join(images, 'tp100_pico.uf2')));
  assert.equal(flash.readUInt32LE(252), crc32(flash.subarray(0, 252)));
});

test('the image starts from the flash, says hello and answers', async () => {
  const golden = await readFile(new URL('../wire/golden_frames.txt', import.meta.url), 'utf8');
  const pico = new Pico(flashOf(await readFile(join(images, 'tp100_pico.uf2'))));
  pico.run(700);
  assert.equal(pico.mcu.clkSys, 125e6);
  assert.equal(pico.bauds.at(-1), 500000);
  const hellos = pico.hellos();
  assert.ok(hellos.length >= 3 && hellos.length <= 4, `${hellos.length} hellos in 0.7 s`);
  for (const hello of hellos) {
    assert.equal(hello.board, 4);
    assert.equal(hello.schema, Number(/^Hello \|.*schema=(\w+)/m.exec(golden)[1]));
    assert.equal(hello.state, 0);
    assert.notEqual(hello.nonce, 0);
  }
  // The motors' inputs are low, and so is their PWM.
  for (let pin = 10; pin <= 15; ++pin) assert.equal(pico.mcu.gpio[pin].outputEnable, true, `GP${pin} is an output`);
  for (let pin = 10; pin <= 15; ++pin) assert.equal(pico.mcu.gpio[pin].outputValue, false, `GP${pin} is low`);

  pico.send(/^HelloRequest \|.*\| (\w+)$/m.exec(golden)[1]);
  pico.run(5);
  assert.deepEqual(pico.hellos().map((hello) => hello.state), [1]);

  // The watchdog's period is 250 ms, and it is kicked in time.
  const late = pico.fed.slice(1).map((feed, i) => feed.at_ms - pico.fed[i].at_ms);
  assert.ok(pico.fed.every((feed) => feed.ms === 250));
  assert.ok(Math.max(...late) < 100, `${Math.max(...late)} ms between two feeds`);
});
