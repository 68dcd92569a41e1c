// The cockpit: the daemon, the four views, and what connects them.
import './cockpit.css';
import { Driver, kPeriod_ms } from '../drive/driver.ts';
import { Inputs } from '../drive/inputs.ts';
import { Controls } from '../panel/controls.ts';
import { attended, everyFrame, h, onLeave } from '../panel/dom.ts';
import { DrivePanel } from '../panel/drive_panel.ts';
import { Identity } from '../panel/identity.ts';
import { NextStep } from '../panel/next_step.ts';
import { Notice } from '../panel/notice.ts';
import { RunCard } from '../panel/run_card.ts';
import { StatusBar } from '../panel/status_bar.ts';
import { StopPanel } from '../panel/stop_panel.ts';
import { Viewport } from '../panel/viewport.ts';
import { Replay } from '../replay/replay.ts';
import type { State } from '../state/messages.ts';
import type { Store } from '../state/store.ts';
import { AnalyseView } from './analyse_view.ts';
import { Daemon } from './daemon.ts';
import { DriveView } from './drive_view.ts';
import { listen } from './keys.ts';
import { PlanView } from './plan_view.ts';
import { SetupView } from './setup_view.ts';
import { themeSwitch } from './theme.ts';
import { kViews, Views } from './views.ts';

const kFigures_ms = 100;
/** At most 30 frames per second; the margin lets a frame be drawn that is due within half a display period. */
const kView_ms = 1000 / 30 - 8;
const kState_ms = 200;

const notice = new Notice();
const say = (why: string): void => { notice.say(why, performance.now()); };
const daemon = new Daemon({
  lost: () => { driver.lose('the connection to the daemon is lost'); },
  complaint: say,
  message: (topic, message) => {
    analyse.signals.receive(topic, message);
    if (topic === '/state') driver.received(message as State);
    else if (topic === '/recording') analyse.runs.changed();
  },
});
const { live, consent, call } = daemon;

const replay = new Replay(look, say, daemon.call);
/** What the page shows of a robot: a recording in the view Analyse, else the robot. The header is always the robot's. */
const replaying = (): boolean => replay.player !== undefined && views.shown === 'analyse';
const shown = (): Store => (replaying() ? replay.player?.store : undefined) ?? live;
const began_unix_s = (): number | undefined => (replaying() ? replay.player?.began_unix_s : daemon.began_unix_s);

const inputs = new Inputs(() => navigator.getGamepads(), () => performance.now());
const driver = new Driver(call, consent.move, inputs, attended, (why) => {
  if (why !== '') say(`Driving by hand: ${why}`);
});
// What sets the robot in motion shows it.
const moves = (): void => { views.go('drive'); };
const controls = new Controls(call, consent, moves, say);
const drivePanel = new DrivePanel(driver, inputs, consent, moves);
const status = new StatusBar();
const step = new NextStep();
const identity = new Identity(themeSwitch(() => { viewport.recolour(); }));
const stopPanel = new StopPanel(pressStop);
stopPanel.element.id = 'stop';

const viewport = new Viewport();
const analyse = new AnalyseView(daemon, replay, shown, () => { views.go('analyse', 'runs'); });
const drive = new DriveView(viewport, drivePanel, new RunCard(analyse), replay.transport, daemon);
const plan = new PlanView(daemon, viewport);
const setup = new SetupView(daemon);
const views = new Views({ analyse: analyse.tabs, setup: setup.tabs }, look);

controls.element.append(drivePanel.button);
document.body.append(
  h('header', { class: 'bar' }, identity.element, views.element, status.element, controls.element, step.element, stopPanel.element, notice.element),
  h('main', {}, viewport.element, drive.side, plan.element, analyse.tabs.element, setup.tabs.element),
);
analyse.follow(location.hash);
look();

function pressStop(): void {
  daemon.pressStop();
  stopPanel.show(daemon.stop.button.view(performance.now()));
}

/** Another view is shown, or another recording. */
function look(): void {
  document.body.classList.toggle('replaying', replaying());
  document.body.classList.toggle('replay-loading', replay.player === undefined && replay.run !== '' && views.shown === 'analyse');
  views.keep('replay', replay.run === '' ? undefined : replay.run);
  plan.look(views.shown === 'plan');
  const player = replaying() ? replay.player : undefined;
  drive.look(player);
  analyse.signals.look(player?.frames);
  viewport.reset();
}

listen({
  stop: pressStop,
  driveKey: (code, change) => driver.key(code, change),
  letGo: () => { driver.leave(); },
  pressed: {
    ...controls.keys,
    m: () => { (replaying() ? replay.transport : controls).pressMark(); },
    t: () => { drivePanel.press(); },
    c: () => { viewport.next(); },
    '?': () => { views.go('setup', 'keys'); },
    ...Object.fromEntries(kViews.map((view, i) => [String(i + 1), () => { views.go(view); }])),
  },
  held: { '[': () => { replay.transport.step(-1); }, ']': () => { replay.transport.step(1); } },
});

setInterval(() => { driver.tick(); }, kPeriod_ms);
onLeave(() => { driver.leave(); });
addEventListener('gamepaddisconnected', () => { driver.tick(); });

let last_ms = performance.now();
everyFrame([
  { period_ms: 0, run: () => { stopPanel.show(daemon.stop.button.view(performance.now())); } },
  { period_ms: kView_ms, run: showView },
  { period_ms: kFigures_ms, run: () => { drive.showFigures(shown()); } },
  { period_ms: kState_ms, run: showState },
]);
daemon.start();

function showView(now_ms: number): void {
  const dt_s = Math.min((now_ms - last_ms) / 1000, 0.5);
  last_ms = now_ms;
  if (replaying()) replay.player?.tick(dt_s);
  viewport.draw(shown(), dt_s);
  drive.showImage(shown(), began_unix_s());
  plan.tick();
}

function showState(now_ms: number): void {
  const { connected, mayCommand } = daemon;
  // Also a lease whose token has arrived after another view was chosen.
  if (views.shown !== 'drive') driver.release();
  status.show(live, connected, daemon.pace);
  identity.show(live, daemon.metadata);
  controls.show(live, connected, mayCommand);
  step.show(live, connected, mayCommand, controls.asks || drivePanel.asks, driver.drives);
  drivePanel.show(live, connected, mayCommand);
  notice.show(live, connected, daemon.retryIn_s, now_ms, replaying(), daemon.pace);
  drive.showWords(live, shown(), replaying(), began_unix_s(), now_ms);
  ({ drive: undefined, plan, analyse: analyse.tabs, setup: setup.tabs })[views.shown]?.show();
  daemon.demand((topic) => analyse.needs(topic, views.shown === 'analyse') || (views.shown === 'setup' && setup.needs(topic)));
  consent.shown();
}
