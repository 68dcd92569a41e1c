// A recorded run in three dimensions on a plain canvas: no WebGL, no network. `tp100Replay` is called with
// the canvas' box and the data that replay_view.cpp writes. Colours are the page's.
function tp100Replay(box, run) {
  'use strict';
  const canvas = box.querySelector('canvas');
  const draw = canvas.getContext('2d');
  const slider = box.querySelector('input[type=range]');
  const playButton = box.querySelector('button');
  const speed = box.querySelector('select');
  const clock = box.querySelector('output');
  const follow = box.querySelector('input[type=checkbox]');
  const style = getComputedStyle(document.documentElement);
  const colour = (name) => style.getPropertyValue('--' + name);
  const frames = run.frames;
  const eye = { turn: -2.2, tilt: 0.75, distance: run.size * 1.3 + 0.5, x: run.middle[0], y: run.middle[1], z: 0 };
  let now = 0;
  let playing = false;
  let last = 0;

  // Camera coordinates of a point of the world: right, up, away.
  function seen(p) {
    const x = p[0] - eye.x, y = p[1] - eye.y, z = p[2] - eye.z;
    const ct = Math.cos(eye.turn), st = Math.sin(eye.turn);
    const cv = Math.cos(eye.tilt), sv = Math.sin(eye.tilt);
    const right = -st * x + ct * y, towards = ct * x + st * y;
    return [right, cv * z - sv * towards, eye.distance - (cv * towards + sv * z)];
  }
  function onScreen(p) {
    const [right, up, away] = seen(p);
    if (away < 0.02) return null;
    const scale = canvas.height * 1.1 / away;
    return [canvas.width / 2 + right * scale, canvas.height / 2 - up * scale, away];
  }
  function line(points, colour, width, dash) {
    draw.strokeStyle = colour;
    draw.lineWidth = width;
    draw.setLineDash(dash || []);
    draw.beginPath();
    let down = false;
    for (const p of points) {
      const at = p === null ? null : onScreen(p);
      if (at === null) down = false;
      else if (down) draw.lineTo(at[0], at[1]);
      else draw.moveTo(at[0], at[1]);
      if (at !== null) down = true;
    }
    draw.stroke();
    draw.setLineDash([]);
  }
  function fill(faces) {
    const shown = [];
    for (const face of faces) {
      const corners = face.points.map(onScreen);
      if (corners.includes(null)) continue;
      shown.push({ corners, colour: face.colour, away: corners.reduce((sum, c) => sum + c[2], 0) / corners.length });
    }
    shown.sort((a, b) => b.away - a.away);
    for (const { corners, colour } of shown) {
      draw.fillStyle = colour;
      draw.strokeStyle = 'rgba(0,0,0,.35)';
      draw.lineWidth = 1;
      draw.beginPath();
      corners.forEach((c, i) => (i === 0 ? draw.moveTo(c[0], c[1]) : draw.lineTo(c[0], c[1])));
      draw.closePath();
      draw.fill();
      draw.stroke();
    }
  }
  // x, y, z, roll, pitch, yaw (REP-103): where a point of the robot is in the world.
  function placed(pose, p) {
    const [x, y, z, roll, pitch, yaw] = pose;
    const cr = Math.cos(roll), sr = Math.sin(roll), cp = Math.cos(pitch), sp = Math.sin(pitch);
    const cy = Math.cos(yaw), sy = Math.sin(yaw);
    const y1 = cr * p[1] - sr * p[2], z1 = sr * p[1] + cr * p[2];
    const x2 = cp * p[0] + sp * z1, z2 = -sp * p[0] + cp * z1;
    return [x + cy * x2 - sy * y1, y + sy * x2 + cy * y1, z + z2];
  }
  function boxFaces(pose, [x0, x1, y0, y1, z0, z1], colour) {
    const at = (x, y, z) => placed(pose, [x, y, z]);
    return [
      [at(x0, y0, z1), at(x1, y0, z1), at(x1, y1, z1), at(x0, y1, z1)],
      [at(x0, y0, z0), at(x1, y0, z0), at(x1, y0, z1), at(x0, y0, z1)],
      [at(x0, y1, z0), at(x1, y1, z0), at(x1, y1, z1), at(x0, y1, z1)],
      [at(x0, y0, z0), at(x0, y1, z0), at(x0, y1, z1), at(x0, y0, z1)],
      [at(x1, y0, z0), at(x1, y1, z0), at(x1, y1, z1), at(x1, y0, z1)],
    ].map((points) => ({ points, colour }));
  }
  function ground() {
    const step = run.size > 8 ? 1 : 0.25;
    const reach = Math.min(run.size / 2 + 2 * step, 100 * step);
    const from = (v) => Math.floor((v - reach) / step) * step;
    for (let i = 0; i * step <= 2 * reach + step; ++i) {
      const x = from(run.middle[0]) + i * step, y = from(run.middle[1]) + i * step;
      line([[x, from(run.middle[1]), 0], [x, run.middle[1] + reach, 0]], colour('line'), 1);
      line([[from(run.middle[0]), y, 0], [run.middle[0] + reach, y, 0]], colour('line'), 1);
    }
  }
  function obstacles() {
    const faces = [];
    for (const s of run.surfaces) {
      const pose = [s[0], s[1], 0, 0, 0, s[2]];
      faces.push({ colour: 'rgba(90,140,150,.35)', points: [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([i, j]) =>
        placed(pose, [i * s[3] / 2, j * s[4] / 2, 0])) });
    }
    for (const b of run.blocks)
      faces.push(...boxFaces([b[0], b[1], 0, 0, 0, b[2]], [-b[4] / 2, b[4] / 2, -b[5] / 2, b[5] / 2, 0, b[3]], '#a58a6d'));
    for (const r of run.ramps) {
      const [x, y, heading, height, up, top, down, width] = r;
      const at = (u, v, w) => placed([x, y, 0, 0, 0, heading], [u - (up + top + down) / 2, v * width / 2, w]);
      const sides = [[0, 0, up, height], [up, height, up + top, height], [up + top, height, up + top + down, 0]];
      for (const [u0, h0, u1, h1] of sides)
        faces.push({ colour: '#cdb184', points: [at(u0, -1, h0), at(u1, -1, h1), at(u1, 1, h1), at(u0, 1, h0)] });
      for (const v of [-1, 1])
        faces.push({ colour: '#b59a6d', points: [at(0, v, 0), at(up + top + down, v, 0), at(up + top, v, height), at(up, v, height)] });
    }
    return faces;
  }
  function robot(frame) {
    const { length, gauge, track, height, radius } = run.robot;
    const half = length / 2, inner = gauge / 2 - track / 2, outer = gauge / 2 + track / 2;
    const faces = boxFaces(frame.robot, [-half * 0.85, half * 0.85, -inner, inner, radius * 0.6, height], '#57b96b');
    for (const side of [-1, 1]) {
      const from = side < 0 ? -outer : inner, to = side < 0 ? -inner : outer;
      faces.push(...boxFaces(frame.robot, [-half, half, from, to, 0, 2 * radius], '#3a3a3a'));
    }
    fill(faces);
    // Treads on top of the tracks move as far as the tracks have run.
    for (const [side, travel] of [[1, frame.left], [-1, frame.right]]) {
      const gap = 0.02;
      for (let x = -half + ((travel % gap) + gap) % gap; x < half; x += gap)
        line([placed(frame.robot, [x, side * inner, 2 * radius]), placed(frame.robot, [x, side * outer, 2 * radius])], '#9a9a9a', 1);
    }
    line([placed(frame.robot, [0, 0, height]), placed(frame.robot, [half * 1.3, 0, height])], '#c0392b', 2);
  }
  function footprint(pose, colour) {
    const { length, gauge, track } = run.robot;
    const i = length / 2, j = (gauge + track) / 2;
    line([[i, j], [i, -j], [-i, -j], [-i, j], [i, j]].map(([u, v]) => placed(pose, [u, v, 0.003])), colour, 2);
  }
  function frameAt(t) {
    let low = 0, high = frames.t.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (frames.t[middle] <= t) low = middle; else high = middle - 1;
    }
    return low;
  }
  function show() {
    if (frames.t.length === 0) return;
    const i = frameAt(now);
    const frame = { robot: frames.robot[i], left: frames.left[i], right: frames.right[i] };
    if (follow.checked) [eye.x, eye.y, eye.z] = frame.robot;
    draw.fillStyle = colour('ground');
    draw.fillRect(0, 0, canvas.width, canvas.height);
    ground();
    fill(obstacles());
    line(run.path.map(([x, y]) => [x, y, 0.002]), colour('path'), 3, [8, 6]);
    for (const name of run.path_histories)
      line(frames[name].slice(0, i + 1).map((p) => p && [p[0], p[1], p[2] + 0.004]), colour(name), 2);
    robot(frame);
    if (run.path_histories.includes('truth') && frames.truth[i]) footprint(frames.truth[i], colour('truth'));
    clock.value = now.toFixed(1) + ' s';
    slider.value = String(now);
  }
  function turn(at) {
    if (!playing) return;
    now = Math.min(now + Math.min(at - last, 100) * 1e-3 * Number(speed.value), Number(slider.max));
    last = at;
    if (now >= Number(slider.max)) play(false);
    show();
    requestAnimationFrame(turn);
  }
  function play(on) {
    playing = on && frames.t.length > 0;
    playButton.textContent = playing ? 'Pause' : 'Play';
    if (!playing) return;
    if (now >= Number(slider.max)) now = 0;
    requestAnimationFrame((at) => { last = at; turn(at); });
  }

  slider.max = frames.t.length > 0 ? String(frames.t[frames.t.length - 1]) : '0';
  slider.addEventListener('input', () => { now = Number(slider.value); show(); });
  playButton.addEventListener('click', () => play(!playing));
  follow.addEventListener('change', () => {
    if (!follow.checked) [eye.x, eye.y, eye.z] = [run.middle[0], run.middle[1], 0];
    eye.distance = follow.checked ? 0.8 : run.size * 1.3 + 0.5;
    show();
  });
  canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons === 0) return;
    eye.turn -= event.movementX * 0.01;
    eye.tilt = Math.min(1.55, Math.max(0.05, eye.tilt + event.movementY * 0.01));
    show();
  });
  canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    eye.distance = Math.min(200, Math.max(0.2, eye.distance * Math.exp(event.deltaY * 1e-3)));
    show();
  }, { passive: false });
  matchMedia('screen and (prefers-color-scheme: dark)').addEventListener('change', show);
  now = Number(slider.max);
  show();
}
