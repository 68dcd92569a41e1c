// A course as a card: its outline with obstacles, its figures and its actions.
import { footprint } from '../scene/geometry.ts';
import type { Footprint } from '../state/messages.ts';
import { facts, type CourseEntry } from '../state/setup.ts';
import { button, deleteButton, h, svg } from './dom.ts';

const kMargin_m = 0.12;

export interface CardActions {
  choose: () => void;
  remove: () => void;
  /** Opens its file in the editor. */
  edit: () => void;
}

export function courseCard(course: CourseEntry, actions: CardActions): HTMLElement {
  const fixed = { 'data-fixed': String(course.in_force || course.why_not !== '') };
  const buttons = h(
    'div',
    { class: 'card-buttons' },
    button({ class: 'control card-choose', 'aria-label': `Choose course ${course.name}`, ...fixed }, course.in_force ? 'In use' : 'Choose', actions.choose),
    button({ class: 'link card-edit', title: course.from === 'own' ? 'Open it in the editor' : 'Open a copy of your own in the editor', 'aria-label': `Edit course ${course.name}` }, 'edit', actions.edit),
  );
  if (course.from !== 'given') buttons.append(h('a', { href: `/courses/${course.name}.toml`, download: '' }, 'file'));
  if (course.from === 'own') buttons.append(deleteButton({ class: 'link card-delete', 'data-fixed': String(course.in_force) }, actions.remove));
  const card = h(
    'li',
    { class: 'card', id: `course-${course.name}` },
    thumbnail(course),
    h(
      'div',
      { class: 'card-text' },
      h('h3', {}, course.name, ...(course.from === 'own' ? [h('span', { class: 'card-own' }, ' yours')] : [])),
      h('p', { class: 'card-about' }, course.description ?? ''),
      h('p', { class: 'card-facts' }, facts(course)),
    ),
    buttons,
  );
  if (course.in_force) card.setAttribute('aria-current', 'true');
  if (course.why_not !== '') card.append(h('p', { class: 'card-why' }, course.why_not));
  return card;
}

/** The outline in a fixed frame, x to the right, y up. */
export function thumbnail(course: Pick<CourseEntry, 'name' | 'outline' | 'obstacles' | 'surfaces' | 'start'>): SVGSVGElement {
  const image = svg('svg', { class: 'card-outline', role: 'img', 'aria-label': `Outline of course ${course.name}` });
  const outline = course.outline ?? [];
  if (outline.length === 0) return image;
  const pieces = (list: Footprint[] | undefined): { x: number; y: number }[][] =>
    (list ?? []).map((piece) => footprint(piece, piece.length_m, piece.width_m));
  const obstacles = pieces(course.obstacles);
  const line = outline.map(({ x_m, y_m }) => ({ x: x_m, y: y_m }));
  const all = [...line, ...obstacles.flat()];
  const [xs, ys] = [all.map(({ x }) => x), all.map(({ y }) => y)];
  const [left, top] = [Math.min(...xs) - kMargin_m, Math.max(...ys) + kMargin_m];
  const width = Math.max(...xs) + kMargin_m - left;
  const height = top - Math.min(...ys) + kMargin_m;
  image.setAttribute('viewBox', `${left} ${-top} ${width} ${height}`);
  const points = (list: { x: number; y: number }[]): string => list.map(({ x, y }) => `${x.toFixed(3)},${(-y).toFixed(3)}`).join(' ');
  const fill = (list: { x: number; y: number }[][], colour: string): void => {
    for (const corners of list) image.append(svg('polygon', { points: points(corners), fill: colour }));
  };
  fill(pieces(course.surfaces), 'var(--surface)');
  fill(obstacles, 'var(--obstacle)');
  image.append(
    svg('polyline', {
      points: points(line),
      fill: 'none',
      stroke: 'var(--path)',
      'stroke-width': '1.5',
      'stroke-linejoin': 'round',
      'vector-effect': 'non-scaling-stroke',
    }),
  );
  const start = course.start;
  if (start !== undefined) {
    const size = 0.05 * Math.max(width, height);
    image.append(svg('circle', { cx: String(start.x_m), cy: String(-start.y_m), r: String(size), fill: 'var(--fused)' }));
  }
  return image;
}
