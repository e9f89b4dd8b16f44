// Zoom and pan of the canvas by wheel, fingers and keys.
import type { Point } from '../editing/drag.ts';
import { isKey } from '../shell/keys.ts';
import type { Viewport } from './viewport.svelte.ts';

const zoomPerPx = 0.0022;
const wheelLinePx = 16;
const keyZoom = 1.25;
const keyPanPx = 40;
/** The way of each arrow on the canvas: to the right and upwards. */
export const arrows: Record<string, Point> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

/** Fingers on the canvas that zoom and pan; the first one that takes a part of the mechanism is none of them. */
export class Navigation {
  private readonly fingers = new Map<number, [number, number]>();

  constructor(
    private readonly view: Viewport,
    private readonly canvas: HTMLElement,
  ) {}

  get isOn(): boolean {
    return this.fingers.size > 0;
  }

  wheel(event: WheelEvent): void {
    event.preventDefault();
    const px = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? wheelLinePx : 1;
    // A touch pad pans by two fingers; a pinch of it is a wheel with Ctrl, and so is a wheel of a mouse here.
    if (event.shiftKey) this.view.pan(-(event.deltaX || event.deltaY) * px, 0);
    else if (event.deltaX !== 0 && !event.ctrlKey) this.view.pan(-event.deltaX * px, -event.deltaY * px);
    else this.view.zoom(Math.exp(-event.deltaY * px * zoomPerPx * (event.ctrlKey ? 4 : 1)), ...this.place(event));
  }

  begin(event: Pick<PointerEvent, 'pointerId' | 'clientX' | 'clientY'>): void {
    this.fingers.set(event.pointerId, [event.clientX, event.clientY]);
    this.canvas.setPointerCapture(event.pointerId);
  }

  move(event: PointerEvent): void {
    const before = this.fingers.get(event.pointerId);
    if (!before) return;
    const other = [...this.fingers].find(([id]) => id !== event.pointerId)?.[1];
    const now: [number, number] = [event.clientX, event.clientY];
    this.fingers.set(event.pointerId, now);
    if (!other) return this.view.pan(now[0] - before[0], now[1] - before[1]);
    const far = ([x, y]: [number, number]): number => Math.max(Math.hypot(x - other[0], y - other[1]), 1);
    const { left, top } = this.canvas.getBoundingClientRect();
    // Half of the way of one finger is that of the middle of both.
    this.view.pan((now[0] - before[0]) / 2, (now[1] - before[1]) / 2);
    this.view.zoom(far(now) / far(before), (now[0] + other[0]) / 2 - left, (now[1] + other[1]) / 2 - top);
  }

  end(event: PointerEvent): void {
    this.fingers.delete(event.pointerId);
  }

  /** Takes the keys + - 0, and the arrows where nothing on the canvas has the focus. */
  key(event: KeyboardEvent, isOnCanvas: boolean): boolean {
    const way = arrows[event.key];
    if (isKey(event, 'zoomIn')) this.view.zoom(keyZoom);
    else if (isKey(event, 'zoomOut')) this.view.zoom(1 / keyZoom);
    else if (isKey(event, 'fit')) this.view.fit();
    else if (way && isOnCanvas) this.view.pan(-way[0] * keyPanPx, way[1] * keyPanPx);
    else return false;
    event.preventDefault();
    return true;
  }

  /** Takes the wheel, and keeps the viewport at the size of the canvas; stops when the returned function is called. */
  attach(): () => void {
    const { view, canvas } = this;
    const resize = (): void => view.resize(canvas.clientWidth, canvas.clientHeight);
    const sizes = new ResizeObserver(resize);
    sizes.observe(canvas);
    resize();
    const wheel = (event: WheelEvent): void => this.wheel(event);
    canvas.addEventListener('wheel', wheel, { passive: false });
    return () => {
      sizes.disconnect();
      canvas.removeEventListener('wheel', wheel);
    };
  }

  private place({ clientX, clientY }: MouseEvent): [number, number] {
    const { left, top } = this.canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }
}
