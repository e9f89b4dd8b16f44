// From the screen into a picture.

/** A place of the screen in units of a picture; null where the picture is not shown. */
export function pointIn(svg: SVGSVGElement | null | undefined, clientX: number, clientY: number): DOMPoint | null {
  const toScreen = svg?.getScreenCTM();
  return toScreen ? new DOMPoint(clientX, clientY).matrixTransform(toScreen.inverse()) : null;
}
