// The page with all robots: a card for each daemon on this machine and for those that the
// configuration names. Every card has a connection of its own to its daemon and depends neither on
// another card nor on the daemon that served the page.
import './theme.css';
import './base.css';
import './robots.css';
import { everyFrame, h, setText } from '../panel/dom.ts';
import { StopPanel } from '../panel/stop_panel.ts';
import { Robot, RobotList, type Listed } from '../robots/robot.ts';
import { RobotCard } from '../robots/robot_card.ts';
import { themeSwitch } from './theme.ts';

const kList_ms = 1000;
const kCards_ms = 100;

const cards = new Map<Robot, RobotCard>();
const list = new RobotList((listed) => new Robot(listed));
let listed = true;

function pressAll(): void {
  for (const card of cards.values()) card.pressStop();
  showCards();
}

const stopAll = new StopPanel(pressAll, undefined, 'STOP all');
stopAll.element.id = 'stop-all';
stopAll.show({ kind: 'ready' });
const note = h('p', { class: 'robots-note', role: 'status' });
const items = h('ul', { class: 'cards', 'aria-label': 'Robots' });
document.body.append(
  h('header', { class: 'bar' }, h('div', { class: 'identity' }, h('h1', {}, 'Robots'), themeSwitch(() => undefined), note), stopAll.element),
  h('main', {}, items),
);

async function update(): Promise<void> {
  try {
    const answer = await fetch('api/robots');
    if (!answer.ok) throw new Error(answer.statusText);
    const { robots } = (await answer.json()) as { robots: Listed[] };
    list.take(robots, performance.now());
    listed = true;
  } catch {
    listed = false;
  }
  setTimeout(() => { void update(); }, kList_ms);
}

function showCards(): void {
  for (const robot of list.robots) {
    if (cards.has(robot)) continue;
    const card = new RobotCard(robot);
    cards.set(robot, card);
    items.append(card.element);
  }
  for (const [robot, card] of cards) {
    if (list.robots.includes(robot)) {
      card.show(list.ended(robot));
    } else {
      card.element.remove();
      cards.delete(robot);
    }
  }
  setText(note, listed ? '' : 'The daemon that served this page does not answer: robots that start now are missing.');
}

// Before any element that might handle the key itself. With the focus on a card, the space bar stops its robot.
window.addEventListener('keydown', (event) => {
  if (event.key !== 'Escape' && event.code !== 'Space') return;
  event.preventDefault();
  if (event.repeat) return;
  const focused = [...cards.values()].find((card) => event.code === 'Space' && card.element.contains(document.activeElement));
  if (focused === undefined) pressAll();
  else focused.pressStop();
}, { capture: true });
window.addEventListener('keyup', (event) => {
  if (event.code === 'Space') event.preventDefault();
}, { capture: true });

everyFrame([{ period_ms: kCards_ms, run: showCards }]);
void update();
