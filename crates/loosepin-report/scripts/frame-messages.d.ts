// What a figure in a frame of a notebook and the widget around it tell each other. Angles are those of the record, in degrees.

/** From the figure to the widget. */
export type FrameMessage =
  | { kind: 'loosepin-ready' }
  | { kind: 'loosepin-angle'; angleDeg: number }
  | { kind: 'loosepin-height'; heightPx: number };

/** From the widget to the figure. */
export type WidgetMessage =
  | { kind: 'loosepin-angle'; angleDeg: number }
  | { kind: 'loosepin-colours'; isDark: boolean };
