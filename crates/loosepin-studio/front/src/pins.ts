// What can be taken on a drawing: pins. Each is a button with a name, for the mouse, the finger and the keyboard.
import type { JointEntry } from './messages.ts';

const namespace = 'http://www.w3.org/2000/svg';

export function element(name: string, attributes: Record<string, string>): SVGElement {
  const made = document.createElementNS(namespace, name);
  Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, value));
  return made;
}

/** Adds what is taken of each pin; the player of the drawing moves them with their bodies. */
export function addPins(svg: SVGSVGElement, joints: JointEntry[], nameOf: (joint: JointEntry) => string): void {
  // y points up in the drawing.
  const upright = element('g', { transform: 'scale(1 -1)', class: 'pins' });
  for (const joint of joints) {
    if (!joint.pin) continue;
    const { body, x, y } = joint.pin;
    const grip = element('g', { 'data-rides': String(body), 'data-x': String(x), 'data-y': String(y) });
    grip.classList.add('grip');
    grip.dataset.joint = joint.name;
    grip.setAttribute('tabindex', '0');
    grip.setAttribute('role', 'button');
    grip.setAttribute('aria-label', nameOf(joint));
    // A line without length and with round ends is a disc whose size is in pixels of the screen.
    const disc = element('path', { d: 'M0 0h0', class: 'disc' });
    grip.append(disc);
    upright.append(grip);
  }
  svg.append(upright);
}
