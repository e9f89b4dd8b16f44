// Pictures of mechanisms in space: drawn by the script of the report, `window.spaceScene`.
import '../../../../loosepin-report/scripts/space-scene.ts';
import type { SpaceDrawing } from '../messages.ts';
import { figureOf } from '../drawing/figure.ts';

/** A picture with what it is drawn from. */
export interface Space {
  svg: string;
  data: SpaceData;
}

/** Another side of the mechanism, degrees. */
export interface Side {
  azimuth: number;
  elevation: number;
}

export function parsedSpace({ svg, scene }: SpaceDrawing): Space {
  return { svg, data: JSON.parse(scene) as SpaceData };
}

/** The picture as nodes with what draws it. */
export function sceneOf({ svg, data }: Space): { svg: SVGSVGElement; scene: SpaceScene } | null {
  const made = figureOf(svg);
  if (!made) return null;
  made.removeAttribute('width');
  made.removeAttribute('height');
  return { svg: made, scene: window.spaceScene(made, data) };
}
