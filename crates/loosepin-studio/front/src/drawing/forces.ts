// Springs and loads in the drawing: their signs, each a button with a name.
import { element } from './element.ts';
import type { ForceView } from '../messages.ts';

/** A spring from (0, 0) to (1, 0), its coils 1 to either side. */
const turns = 10;
const coils = 'M0 0H.25' + Array.from({ length: turns }, (_, turn) => `L${(0.25 + (0.5 * (turn + 0.5)) / turns).toFixed(3)} ${turn % 2 === 0 ? 1 : -1}`).join('') + 'L.75 0H1';

function sign(force: ForceView, size: number): SVGElement[] {
  const [first, second] = force.ends;
  if (!first) return [];
  const at = (name: string, attributes: Record<string, string>, ...children: SVGElement[]): SVGElement => {
    const made = element(name, attributes);
    made.append(...children);
    return made;
  };
  if (second) {
    const line = (kind: string): SVGElement => element('path', { d: kind === 'reach' ? 'M0 0H1' : coils, class: kind });
    const data = { 'data-from': `${first.body} ${first.x} ${first.y}`, 'data-to': `${second.body} ${second.x} ${second.y}`, 'data-across': String(0.7 * size) };
    return [at('g', data, line('reach'), line('sign'))];
  }
  const [place, x, y] = [{ 'data-rides': String(first.body), 'data-x': String(first.x), 'data-y': String(first.y) }, first.x, first.y];
  if (force.direction_deg === null) {
    // Round about its place: three quarters of a turn, with a point.
    const r = 1.7 * size;
    const arc = `M${r} 0A${r} ${r} 0 1 1 0 ${-r}l${-0.7 * size} ${0.4 * size}M0 ${-r}l${-0.7 * size} ${-0.45 * size}`;
    return [at('g', place, element('path', { d: arc, class: 'reach' }), element('path', { d: arc, class: 'sign' }))];
  }
  // The arrow ends where the force acts.
  const [tail, tip] = [5 * size, 0.9 * size];
  const arrow = `M${-tail} 0H${-tip}m${-0.8 * size} ${0.45 * size}L${-tip} 0l${-0.8 * size} ${-0.45 * size}`;
  const turned = at('g', { transform: `rotate(${force.direction_deg})` }, element('path', { d: arrow, class: 'reach' }), element('path', { d: arrow, class: 'sign' }));
  return force.turns
    ? [at('g', { 'data-body': String(first.body) }, at('g', { transform: `translate(${x} ${y})` }, turned))]
    : [at('g', place, turned)];
}

/** Adds the signs; the player of the drawing moves them with their bodies. `size` is that of letters, mm. */
export function addForces(layers: DocumentFragment, forces: ForceView[], nameOf: (force: ForceView) => string, size: number): void {
  // y points up in the drawing.
  const upright = element('g', { transform: 'scale(1 -1)', class: 'forces' });
  for (const force of forces) {
    const signs = sign(force, size);
    if (signs.length === 0) continue;
    const button = element('g', { role: 'button', tabindex: '0', 'aria-label': nameOf(force), class: 'force ' + force.table });
    button.dataset.force = `${force.table} ${force.name}`;
    button.append(...signs);
    upright.append(button);
  }
  layers.append(upright);
}
