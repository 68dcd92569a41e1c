// The cockpit: connects the daemon's channels to the elements of the page.
import 'uplot/dist/uPlot.min.css';
import './theme.css';
import './base.css';
import './header.css';
import './view.css';
import './plots.css';
import './drive.css';
import './drawer.css';
import './plan.css';
import './analyse.css';
import './setup.css';
import './layout.css';
import { CourseEditor } from '../draw/editor.ts';
import { Driver, kPeriod_ms } from '../drive/driver.ts';
import { Inputs, type KeyChange } from '../drive/inputs.ts';
import { Client, type ServerInfo } from '../foxglove/client.ts';
import { openSocket, type Socket } from '../foxglove/connection.ts';
import { StopSender } from '../foxglove/stop_sender.ts';
import { CameraImagePanel } from '../panel/camera_image.ts';
import { Controls } from '../panel/controls.ts';
import { CourseList } from '../panel/course_list.ts';
import { DoctorPanel } from '../panel/doctor_panel.ts';
import { attended, everyFrame, h, onLeave } from '../panel/dom.ts';
import { DrivePanel } from '../panel/drive_panel.ts';
import { Drawer } from '../panel/drawer.ts';
import { EventLog } from '../panel/event_log.ts';
import { Histogram } from '../panel/histogram.ts';
import { IdentifyPanel } from '../panel/identify_panel.ts';
import { Identity } from '../panel/identity.ts';
import { LinkTable } from '../panel/link_table.ts';
import { Notice } from '../panel/notice.ts';
import { Numbers } from '../panel/numbers.ts';
import { ParameterPanel } from '../panel/parameter_panel.ts';
import { PlaceDrawing } from '../panel/place_drawing.ts';
import { Plots } from '../panel/plots.ts';
import { RunList } from '../panel/run_list.ts';
import { SceneWords } from '../panel/scene_words.ts';
import { SignalPanel } from '../panel/signal_panel.ts';
import { StatusBar } from '../panel/status_bar.ts';
import { StopPanel } from '../panel/stop_panel.ts';
import { Timeline } from '../panel/timeline.ts';
import { Transport } from '../panel/transport.ts';
import { kModes, Viewport } from '../panel/viewport.ts';
import { Player } from '../replay/player.ts';
import { loadRecording } from '../replay/recording.ts';
import { Consent } from '../state/consent.ts';
import type { Estimate, Slip, State, Topic } from '../state/messages.ts';
import { past, reason, type Call } from '../state/service.ts';
import { kHistory_s, Store } from '../state/store.ts';
import { keyList, listen } from './keys.ts';
import { themeSwitch } from './theme.ts';

const kTopics: Topic[] = [
  '/state',
  '/course',
  '/path_history',
  '/estimate',
  '/slip',
  '/link',
  '/loop',
  '/event',
  '/parameter',
  '/recording',
  '/client',
  '/camera/image',
];
const kNumbers_ms = 100;
/** At most 30 frames per second; the margin lets a frame be drawn that is due within half a display period. */
const kView_ms = 1000 / 30 - 8;
const kPlots_ms = 100;
const kChips_ms = 200;
const kWindow_s = 60;
/** With `/state.watch` the daemon stops a robot that no page in sight has watched for 2 s. */
const kWatch_ms = 500;

const live = new Store();
/** Data source of the view, figures and diagrams: the robot or a recording. The bar is always live. */
let shown = live;
let player: Player | undefined;
let loading: AbortController | undefined;
/** The run that is replayed; empty: none. */
let replayed = '';
let metadata: ServerInfo['metadata'] = {};
let retryAt_ms = 0;

const connect = (): Socket => openSocket(`${location.origin}/`);
const client = new Client(
  connect,
  {
    serverInfo: (info) => {
      metadata = info.metadata;
    },
    ready: () => {
      stop.ready();
    },
    closed: (retry_ms) => {
      retryAt_ms = performance.now() + retry_ms;
      stop.button.disconnected();
      consent.forget('The connection was lost');
      driver.lose('the connection to the daemon is lost');
    },
    status: (level, message) => {
      if (level > 0) notice.say(message, performance.now());
    },
  },
);

const call: Call = (service, request) => client.call(service, request);
const consent = new Consent(call);
const stop = new StopSender(client, connect);

function pressStop(): void {
  consent.forget('STOP was pressed');
  stop.press(performance.now());
  stopPanel.show(stop.button.view(performance.now()));
}

async function replay(url: string, run: string): Promise<void> {
  loading?.abort();
  const mine = (loading = new AbortController());
  replayed = run;
  transport.loading(run, 0);
  try {
    const frames = await loadRecording(url, (share) => { transport.loading(run, share); }, mine.signal);
    // Data of a recording does not age.
    player = new Player(frames, new Store(() => 0));
    transport.open(run, player);
    signals.look(player.frames);
    look(player.store);
    player.playing = true;
  } catch (error: unknown) {
    if (mine.signal.aborted) return;
    backToLive();
    notice.say(reason(error), performance.now());
  }
}

function backToLive(): void {
  loading?.abort();
  player = undefined;
  replayed = '';
  transport.close();
  signals.look(undefined);
  look(live);
}

function look(store: Store): void {
  shown = store;
  document.body.classList.toggle('replaying', store !== live);
  plots.window_s = player === undefined ? kWindow_s : Math.min(Math.max(player.duration_s, 20), kHistory_s);
  viewport.reset();
}

/** The Unix time of t_s = 0, of the daemon or of the recording. */
function began_unix_s(): number | undefined {
  return player === undefined ? Number(metadata.start_unix_ns ?? NaN) / 1e9 || undefined : player.began_unix_s;
}

function mayCommand(): boolean {
  return metadata.commands !== 'stop';
}

/** Begins or ends drawing of a pose, on the live map: not on that of a recording. */
function drawPlace(on: boolean): void {
  if (on) {
    backToLive();
    viewport.set('map');
  }
  placing.show(on);
  courses.drawing(on);
}

/** Begins or ends drawing of a course on the map; the editor replaces the list of courses. */
function drawCourse(on: boolean): void {
  if (on) {
    backToLive();
    placing.show(false);
    viewport.set('map');
  }
  courses.element.hidden = on;
  document.body.classList.toggle('drawing', on);
}

const stopPanel = new StopPanel(pressStop);
stopPanel.element.id = 'stop';
const controls = new Controls(call, consent, (why) => { notice.say(why, performance.now()); });
const inputs = new Inputs(
  () => navigator.getGamepads(),
  () => performance.now(),
);
const driver = new Driver(
  call,
  consent.move,
  inputs,
  attended,
  (why) => {
    if (why !== '') notice.say(`Driving by hand: ${why}`, performance.now());
  },
);
const drive = new DrivePanel(driver, inputs, consent);
const status = new StatusBar();
const notice = new Notice();
const viewport = new Viewport();
const words = new SceneWords();
const cameraImage = new CameraImagePanel();
const timeline = new Timeline();
const numbers = new Numbers();
const plots = new Plots();
const histogram = new Histogram();
const events = new EventLog();
const runs = new RunList((file, run) => void replay(file.url, run.run), call);
const transport = new Transport(backToLive);
const parameters = new ParameterPanel((name, value) => { client.setParameter(name, value); }, call);
const signals = new SignalPanel(past);
const links = new LinkTable();
const doctor = new DoctorPanel(call, consent);
const identify = new IdentifyPanel(call, consent);
const editor = new CourseEditor(viewport, call, drawCourse);
const courses = new CourseList(call, drawPlace, editor);
const coursesPage = h('div', {}, courses.element, editor.element);
const placing = new PlaceDrawing(
  (at) => viewport.world(at),
  () => live.pose?.yaw_rad ?? 0,
  (pose) => {
    placing.show(false);
    courses.placed(pose);
  },
);

const drawer = new Drawer([
  { id: 'events', title: 'Events', element: events.element, show: () => { events.show(shown, began_unix_s()); } },
  { id: 'courses', title: 'Courses', element: coursesPage, show: () => { courses.show(live, client.ready, mayCommand()); } },
  { id: 'runs', title: 'Runs', element: runs.element, show: () => { runs.show(client.ready && mayCommand(), replayed); } },
  { id: 'parameters', title: 'Parameters', element: parameters.element, show: () => { parameters.show(live, client.ready, mayCommand()); } },
  { id: 'signals', title: 'Signals', element: signals.element, show: () => { signals.show(shown); } },
  { id: 'link', title: 'Link', element: links.element, show: () => { links.show(shown); } },
  { id: 'doctor', title: 'Doctor', element: doctor.element, show: () => { doctor.show(live, client.ready, mayCommand()); } },
  { id: 'identify', title: 'Identify', element: identify.element, show: () => { identify.show(live, client.ready, mayCommand()); } },
  { id: 'keys', title: 'Keys', element: keyList(), show: () => undefined },
], themeSwitch(() => { viewport.recolour(); }));

const identity = new Identity();
const header = h(
  'header',
  { class: 'bar' },
  identity.element,
  status.element,
  controls.element,
  stopPanel.element,
);
plots.element.append(histogram.element);
controls.element.append(drive.button);
viewport.element.append(words.element, cameraImage.element, editor.stage.element, placing.element, drive.element, notice.element, transport.element, timeline.element);
document.body.append(header, h('main', {}, viewport.element, numbers.element, plots.element, drawer.element));

for (const topic of kTopics) {
  client.subscribe(topic, (message) => {
    live.receive(topic, message as never);
    signals.receive(topic, message);
    if (topic === '/state') {
      stop.button.received((message as State).stop);
      consent.received(message as State);
      driver.received(message as State);
    }
    else if (topic === '/recording') runs.changed();
    // Only the path driven before is needed; from here on the page records its own.
    else if (topic === '/path_history') client.unsubscribe(topic);
  });
}

// A report leads to the replay of its run.
const wanted = new URLSearchParams(location.hash.slice(1)).get('replay');
if (wanted !== null) void replay(`/runs/${encodeURIComponent(wanted)}/run.mcap`, wanted);

Promise.all([past('/estimate'), past('/slip')]).then(
  ([estimates, slips]) => { live.before(estimates as Estimate[], slips as Slip[]); },
  () => undefined,
);

/** Subscribes to the channels with a message in every step while signals need them. */
function demand(): void {
  for (const topic of ['/sample', '/command']) {
    if (drawer.selected === 'signals' || signals.needs(topic)) client.subscribe(topic, (message) => { signals.receive(topic, message); });
    else client.unsubscribe(topic);
  }
}

listen({
  stop: pressStop,
  driveKey,
  letGo: () => { driver.leave(); },
  pressed: {
    r: () => { controls.pressStart(); },
    h: () => { controls.pressHold(); },
    p: () => { controls.pressPause(); },
    m: () => { drive.press(); },
    c: () => { viewport.next(); },
    '?': () => { drawer.select('keys'); },
    ...Object.fromEntries(kModes.map((mode, i) => [String(i + 1), () => { viewport.set(mode); }])),
  },
  held: { '[': () => { transport.step(-1); }, ']': () => { transport.step(1); } },
});

function driveKey(code: string, change: KeyChange): boolean {
  // The release of a key counts even if this page no longer drives.
  if (!driver.drives && change !== 'released') return false;
  const drives = inputs.key(code, change) && driver.drives;
  if (drives) driver.tick();
  return drives;
}

setInterval(() => { driver.tick(); }, kPeriod_ms);
onLeave(() => { driver.leave(); });
window.addEventListener('gamepaddisconnected', () => { driver.tick(); });

let watching = false;
setInterval(() => {
  // One call at a time: those that a slow connection keeps would tell later that somebody watched.
  if (watching || live.get('/state')?.watch !== true || document.visibilityState !== 'visible') return;
  watching = true;
  call('watch', {}).catch(() => undefined).finally(() => { watching = false; });
}, kWatch_ms);

let last_ms = performance.now();
everyFrame([
  { period_ms: 0, run: () => { stopPanel.show(stop.button.view(performance.now())); } },
  { period_ms: kView_ms, run: view },
  { period_ms: kNumbers_ms, run: () => {
    numbers.show(shown);
    timeline.show(shown);
    transport.show();
  } },
  { period_ms: kPlots_ms, run: () => { plots.show(shown); } },
  { period_ms: kChips_ms, run: chips },
]);

function view(now_ms: number): void {
  const dt_s = Math.min((now_ms - last_ms) / 1000, 0.5);
  last_ms = now_ms;
  player?.tick(dt_s);
  viewport.draw(shown, dt_s);
  cameraImage.show(shown, began_unix_s());
  editor.tick(courses.changeable);
}

function chips(now_ms: number): void {
  status.show(live, client.ready);
  words.show(shown, shown !== live, now_ms);
  controls.show(live, client.ready, mayCommand());
  drive.show(live, client.ready, mayCommand());
  notice.show(live, client.ready, (retryAt_ms - now_ms) / 1000, now_ms, shown !== live);
  histogram.show(shown);
  drawer.show();
  demand();
  identity.show(live, metadata);
  consent.shown();
}
