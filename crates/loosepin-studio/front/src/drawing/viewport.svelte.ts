// Which part of the plane the canvas shows. It changes by zoom, pan and fit alone: an edit never moves it.

/** A rectangle of a picture, mm; y points down, as in SVG. */
export interface Box {
  left: number;
  top: number;
  width: number;
  height: number;
}

/** Free border around what is fitted, px. */
const borderPx = 18;
/** The smallest and the largest scale, as multiples of that at which all fits. */
const zoomRange = [0.05, 400] as const;

export class Viewport {
  /** Size of the canvas, px. */
  width = $state(0);
  height = $state(0);
  /** Pixels per millimetre. */
  scale = $state(1);
  /** Middle of the canvas in the picture, mm. */
  private x = $state(0);
  private y = $state(0);
  /** Nobody has zoomed or moved since the last fit: another size of the canvas fits anew. */
  private isFitted = true;
  private isPlaced = false;
  private content: Box | null = null;

  /** The value of `viewBox`. */
  readonly box = $derived(
    [this.x - this.width / 2 / this.scale, this.y - this.height / 2 / this.scale, this.width / this.scale, this.height / this.scale].map((value) => value.toFixed(5)).join(' '),
  );

  /** What there is to see. The first is fitted; later ones leave the view as it is. */
  show(content: Box): void {
    this.content = content;
    if (!this.isPlaced) this.fit();
  }

  resize(width: number, height: number): void {
    if (width === this.width && height === this.height) return;
    this.width = width;
    this.height = height;
    if (this.isFitted) this.fit();
  }

  fit(): void {
    const { content, width, height } = this;
    if (!content || width === 0 || height === 0) return;
    this.scale = this.fitting(content);
    this.x = content.left + content.width / 2;
    this.y = content.top + content.height / 2;
    this.isFitted = true;
    this.isPlaced = true;
  }

  /** Zooms about a place of the canvas, px from its corner; without one about its middle. */
  zoom(factor: number, px = this.width / 2, py = this.height / 2): void {
    const whole = this.content ? this.fitting(this.content) : this.scale;
    const scale = Math.min(Math.max(this.scale * factor, zoomRange[0] * whole), zoomRange[1] * whole);
    const [dx, dy] = [px - this.width / 2, py - this.height / 2];
    this.x += dx / this.scale - dx / scale;
    this.y += dy / this.scale - dy / scale;
    this.scale = scale;
    this.isFitted = false;
  }

  /** Moves the picture by so many pixels. */
  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y -= dy / this.scale;
    this.isFitted = false;
  }

  /** Pixels from the corner of the canvas, of a place in the plane, mm; y points up there. */
  pixels([x, y]: readonly [number, number]): [number, number] {
    return [(x - this.x) * this.scale + this.width / 2, (-y - this.y) * this.scale + this.height / 2];
  }

  private fitting({ width, height }: Box): number {
    const room = [Math.max(this.width - 2 * borderPx, 20), Math.max(this.height - 2 * borderPx, 20)] as const;
    return Math.min(room[0] / Math.max(width, 1e-6), room[1] / Math.max(height, 1e-6));
  }
}
