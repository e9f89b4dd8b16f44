// The widget of a notebook (a module of anywidget): shows a figure in a frame, where nothing of the notebook disturbs it and it disturbs
// nothing, and keeps its cursor and the trait `drive_angle_rad` equal.
import type { FrameMessage, WidgetMessage } from './frame-messages.d.ts';

interface Model {
  get(name: string): unknown;
  set(name: string, value: unknown): void;
  save_changes(): void;
  on(event: string, hear: () => void): void;
  off(event: string, hear: () => void): void;
}

const trait = 'drive_angle_rad';
const radPerDeg = Math.PI / 180;

/** Whether letters around the figure are light: every notebook has its own way to say which theme it has. */
function isDark(element: HTMLElement): boolean {
  const [red = 0, green = 0, blue = 0] = (getComputedStyle(element).color.match(/[\d.]+/g) ?? []).map(Number);
  return 0.299 * red + 0.587 * green + 0.114 * blue > 128;
}

function render({ model, el }: { model: Model; el: HTMLElement }): () => void {
  const frame = document.createElement('iframe');
  frame.title = String(model.get('_title'));
  frame.setAttribute('sandbox', 'allow-scripts allow-downloads');
  // Seen as soon as it has the colours of the notebook.
  Object.assign(frame.style, { display: 'block', width: '100%', height: '30rem', border: '0', visibility: 'hidden' });
  // A change of the theme, however it is made, is a change of this colour: it ends a transition.
  el.style.transition = 'color 1ms';
  frame.srcdoc = String(model.get('_document'));

  const send = (message: WidgetMessage): void => frame.contentWindow?.postMessage(message, '*');
  const sendColours = (): void => {
    // A frame of another scheme than its document would have an opaque ground.
    frame.style.colorScheme = isDark(el) ? 'dark' : 'light';
    send({ kind: 'loosepin-colours', isDark: isDark(el) });
  };
  let known: unknown = null;
  const sendAngle = (): void => {
    const angle = model.get(trait);
    if (angle === known || typeof angle !== 'number') return;
    known = angle;
    send({ kind: 'loosepin-angle', angleDeg: angle / radPerDeg });
  };
  const hear = (event: MessageEvent<FrameMessage | null>): void => {
    if (event.source !== frame.contentWindow) return;
    const message = event.data;
    if (message === null) return;
    // A notebook takes cells that are out of sight off the page: there they have no height.
    if (message.kind === 'loosepin-height' && message.heightPx > 0 && frame.clientWidth > 0) frame.style.height = message.heightPx + 'px';
    if (message.kind === 'loosepin-angle') {
      known = message.angleDeg * radPerDeg;
      model.set(trait, known);
      model.save_changes();
    }
    if (message.kind === 'loosepin-ready') {
      sendColours();
      // A frame that is moved in the page loads again.
      known = null;
      sendAngle();
      frame.style.visibility = 'visible';
    }
  };
  addEventListener('message', hear);
  el.addEventListener('transitionend', sendColours);
  model.on('change:' + trait, sendAngle);
  el.append(frame);
  return () => {
    removeEventListener('message', hear);
    el.removeEventListener('transitionend', sendColours);
    model.off('change:' + trait, sendAngle);
  };
}

export default { render };
